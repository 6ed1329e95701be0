//! A tree of boxes over the convex pieces of an outline. The tree finds the pieces near a place without a test of each
//! piece.
//!
//! The pieces are in the order of their first corners along the outline, so that neighbours in the list are mostly
//! neighbours in the plane. The tree halves the list of pieces again and again. A walk through the tree finds pieces in
//! the order of the list.

use alloc::vec::Vec;

use super::convex::ConvexPolygon;
use super::extent::Extent;

/// Marks a node that has other nodes below it; stands in place of the number of a piece.
const INNER: u32 = u32::MAX;

/// A tree of bounding boxes around convex pieces, and around runs of pieces.
#[derive(Clone, Debug, Default)]
pub(crate) struct BoxTree {
    /// The nodes. In the list a node comes before the nodes below it.
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    /// The bounding box of all pieces below the node, in the frame of the body.
    extent: Extent,
    /// Index of the first node after all nodes below this node.
    after: u32,
    /// Number of the piece if the node has no nodes below it, else [`INNER`].
    piece: u32,
}

impl BoxTree {
    /// Makes a tree over a list of at least one piece.
    pub(crate) fn new(pieces: &[ConvexPolygon]) -> BoxTree {
        let mut tree = BoxTree { nodes: Vec::with_capacity(2 * pieces.len() - 1) };
        tree.add(pieces, 0);
        tree
    }

    /// Adds the node for a run of pieces, and the nodes below it. `first` is the number of the first piece of the run.
    /// Returns the bounding box of the run.
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

    /// The bounding box of all pieces.
    pub(crate) fn extent(&self) -> Extent {
        self.nodes[0].extent
    }

    /// Finds the pieces whose bounding boxes meet a place, in ascending order, with their boxes.
    pub(crate) fn meeting(&self, place: Extent) -> Meeting<'_> {
        Meeting { nodes: &self.nodes, next: 0, place }
    }
}

/// A walk through a tree that finds the pieces near a place.
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
