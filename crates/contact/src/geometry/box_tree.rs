//! A tree of boxes over the convex pieces of an outline. The tree finds the pieces near a place without testing each
//! piece.
//!
//! The pieces are in the order of their first corners along the outline, so that neighbours in the list are mostly
//! neighbours in the plane. The tree halves the list again and again. A walk through the tree finds pieces in the order
//! of the list.

use alloc::vec::Vec;

use super::convex::ConvexPolygon;
use super::extent::Extent;

/// Stands in place of a piece's number: the node has other nodes below it.
const INNER: u32 = u32::MAX;

/// Boxes around pieces, and around runs of pieces.
#[derive(Clone, Debug, Default)]
pub(crate) struct BoxTree {
    /// The nodes. A node comes before the nodes below it.
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    /// The box around all pieces below the node, in the body's frame.
    extent: Extent,
    /// Index of the first node after all nodes below this one.
    after: u32,
    /// Number of the piece if no nodes are below, else [`INNER`].
    piece: u32,
}

impl BoxTree {
    /// A tree over at least one piece.
    pub(crate) fn new(pieces: &[ConvexPolygon]) -> BoxTree {
        let mut tree = BoxTree { nodes: Vec::with_capacity(2 * pieces.len() - 1) };
        tree.add(pieces, 0);
        tree
    }

    /// Adds the node of a run of pieces, and the nodes below it. `first` is the number of the run's first piece.
    /// Returns the box around the run.
    fn add(&mut self, run: &[ConvexPolygon], first: u32) -> Extent {
        let own = self.nodes.len();
        self.nodes.push(Node { extent: Extent::EMPTY, after: 0, piece: INNER });
        let (extent, piece) = match run {
            [only] => (Extent::of(only.vertices()), first),
            _ => {
                let (one, two) = run.split_at(run.len() / 2);
                let extent = self.add(one, first);
                (extent.and(self.add(two, first + one.len() as u32)), INNER)
            }
        };
        self.nodes[own] = Node { extent, after: self.nodes.len() as u32, piece };
        extent
    }

    /// The box around all pieces.
    pub(crate) fn extent(&self) -> Extent {
        self.nodes[0].extent
    }

    /// The pieces whose boxes meet a place, ascending, with their boxes.
    pub(crate) fn meeting(&self, place: Extent) -> Meeting<'_> {
        Meeting { nodes: &self.nodes, next: 0, place }
    }
}

/// A walk through a tree.
pub(crate) struct Meeting<'t> {
    nodes: &'t [Node],
    next: usize,
    place: Extent,
}

impl Iterator for Meeting<'_> {
    type Item = (u32, Extent);

    #[inline]
    fn next(&mut self) -> Option<(u32, Extent)> {
        while let Some(node) = self.nodes.get(self.next) {
            if !node.extent.overlaps(&self.place) {
                self.next = node.after as usize;
                continue;
            }
            self.next += 1;
            if node.piece != INNER {
                return Some((node.piece, node.extent));
            }
        }
        None
    }
}
