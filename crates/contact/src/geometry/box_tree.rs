//! A tree of boxes over the convex pieces of an outline: which of them are near a place, without asking each.
//!
//! The pieces are in the order of their first corners along the outline, so that neighbours in the list are mostly
//! neighbours in the plane. The tree halves that list again and again, and a walk finds pieces in its order.

use alloc::vec::Vec;

use super::convex::ConvexPolygon;
use super::extent::Extent;

/// In place of a piece: the node has others below it.
const INNER: u32 = u32::MAX;

/// The boxes of the pieces and of runs of them.
#[derive(Clone, Debug, Default)]
pub(crate) struct BoxTree {
    /// A node comes before those below it.
    nodes: Vec<Node>,
}

#[derive(Clone, Copy, Debug)]
struct Node {
    /// The box about all pieces below, in the body's frame.
    extent: Extent,
    /// The first node after all those below.
    after: u32,
    /// The piece of a node with none below, else [`INNER`].
    piece: u32,
}

impl BoxTree {
    /// Over at least one piece.
    pub(crate) fn new(pieces: &[ConvexPolygon]) -> BoxTree {
        let mut tree = BoxTree { nodes: Vec::with_capacity(2 * pieces.len() - 1) };
        tree.add(pieces, 0);
        tree
    }

    /// Adds the node of a run of pieces, the first of which has this number, and those below. Returns its box.
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

    /// The box about all pieces.
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
