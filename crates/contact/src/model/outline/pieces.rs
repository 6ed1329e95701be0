//! Cuts a simple polygon into convex pieces along diagonals.
//!
//! The cuts add no point to the polygon. So both sides of a seam have the same end points, bit for bit, and in the
//! boundary sums of the two pieces the terms of the seam cancel.

use alloc::vec;
use alloc::vec::Vec;

use super::crossing::segments_meet;
use super::mesh;
use super::tidy;
use crate::maths::vec2::Vec2;

/// Cuts a simple polygon in the positive sense of turning into convex pieces, which are lists of indices of its
/// vertices. Each piece begins at its smallest index, and the pieces are in the order of their indices.
///
/// The first attempt makes single cuts that each remove one or two reflex corners, the shortest cut first, so that a
/// step or a knuckle costs one seam. If the single cuts fail or take too long, the polygon is triangulated and
/// triangles are merged. Triangulation gives at most four times the smallest possible number of pieces (Hertel &
/// Mehlhorn 1983).
pub(super) fn convex_pieces(vertices: &[Vec2]) -> Vec<Vec<usize>> {
    let rounding_m = tidy::rounding_m(vertices.iter().copied());
    let mut pieces = Vec::new();
    let mut to_cut = vec![(0..vertices.len()).collect::<Vec<_>>()];
    while let Some(indices) = to_cut.pop() {
        let ring = Ring { vertices, indices: &indices, rounding_m };
        let reflex = ring.reflex_corners();
        if reflex.is_empty() {
            pieces.push(indices);
        } else if let Some(cut) = ring.best_cut(&reflex) {
            to_cut.extend(split(&indices, cut));
        } else {
            pieces.extend(mesh::convex_pieces(vertices, &indices, rounding_m));
        }
    }
    for piece in &mut pieces {
        let first = (0..piece.len()).min_by_key(|i| piece[*i]).expect("a piece has vertices");
        piece.rotate_left(first);
    }
    pieces.sort_unstable();
    pieces
}

/// The search for few convex pieces tests pairs of vertices. A ring that may need more tests than this number (0.3 s of work) is cut into triangles
/// instead.
const MAX_WORK: u64 = 1_000_000_000;

/// A cut would make a sliver if it passes a vertex nearer than this fraction of the cut's length, or makes a smaller
/// angle with an edge (rad).
const SLIVER: f64 = 1.0e-6;

/// A part of the outline that must still be cut.
struct Ring<'a> {
    vertices: &'a [Vec2],
    indices: &'a [usize],
    rounding_m: f64,
}

impl Ring<'_> {
    fn point(&self, place: usize) -> Vec2 {
        self.vertices[self.indices[place]]
    }

    fn before(&self, place: usize) -> usize {
        (place + self.indices.len() - 1) % self.indices.len()
    }

    fn after(&self, place: usize) -> usize {
        (place + 1) % self.indices.len()
    }

    fn reflex_corners(&self) -> Vec<usize> {
        let corner = |i| [self.before(i), i, self.after(i)].map(|j| self.point(j));
        (0..self.indices.len()).filter(|&i| tidy::is_reflex(corner(i), self.rounding_m)).collect()
    }

    /// The best diagonal for a cut, as two places in the ring: a diagonal that removes the reflex angles at both of its
    /// ends goes before a diagonal that removes one, and among these the shortest is the best.
    fn best_cut(&self, reflex: &[usize]) -> Option<[usize; 2]> {
        let count = self.indices.len();
        let pairs = count as u64 * reflex.len() as u64;
        if pairs * pairs > MAX_WORK {
            return None;
        }
        let mut cuts = Vec::new();
        for &from in reflex {
            for to in (0..count).filter(|&to| self.mends(from, to)) {
                let mends_both = reflex.binary_search(&to).is_ok() && self.mends(to, from);
                if mends_both && from > to {
                    continue; // listed from its other end
                }
                let along = self.point(to) - self.point(from);
                cuts.push((!mends_both, along.length_squared(), [from, to]));
            }
        }
        cuts.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(a.2.cmp(&b.2)));
        cuts.into_iter().map(|(_, _, cut)| cut).find(|cut| self.is_clear(*cut))
    }

    /// Returns true if the diagonal leaves no reflex angle at the reflex corner `at`. A diagonal that leaves no reflex
    /// angle at the corner also starts inside the ring.
    fn mends(&self, at: usize, to: usize) -> bool {
        let (before, after) = (self.before(at), self.after(at));
        if to == at || to == before || to == after {
            return false;
        }
        let [a, p, b, q] = [before, at, after, to].map(|i| self.point(i));
        !tidy::is_reflex([a, p, q], self.rounding_m) && !tidy::is_reflex([q, p, b], self.rounding_m)
    }

    /// Returns true if the diagonal touches the ring only at its ends and cuts off no sliver.
    fn is_clear(&self, [from, to]: [usize; 2]) -> bool {
        let ends = [self.point(from), self.point(to)];
        let is_end = |i| i == from || i == to;
        (0..self.indices.len()).all(|i| {
            let j = self.after(i);
            match (is_end(i), is_end(j)) {
                (true, true) => false,
                (true, false) => !leaves_along(self.point(i), self.point(j), ends),
                (false, true) => !leaves_along(self.point(j), self.point(i), ends),
                (false, false) => {
                    !passes_close(self.point(i), ends)
                        && !segments_meet([self.point(i), self.point(j)], ends)
                }
            }
        })
    }
}

/// Returns true if the edge from an end of the diagonal to `other` is nearly parallel to the diagonal.
fn leaves_along(end: Vec2, other: Vec2, [a, b]: [Vec2; 2]) -> bool {
    let diagonal = if end == a { b - a } else { a - b };
    let edge = other - end;
    diagonal.dot(edge) > 0.0 && diagonal.cross(edge).abs() <= SLIVER * diagonal.dot(edge)
}

/// Returns true if the diagonal nearly passes through the point `p`.
fn passes_close(p: Vec2, [a, b]: [Vec2; 2]) -> bool {
    let (diagonal, from_a) = (b - a, p - a);
    let (along, squared_length) = (diagonal.dot(from_a), diagonal.length_squared());
    along > 0.0 && along < squared_length && diagonal.cross(from_a).abs() <= SLIVER * squared_length
}

/// Splits a ring along a diagonal into the two rings on either side.
fn split(ring: &[usize], [from, to]: [usize; 2]) -> [Vec<usize>; 2] {
    let (first, last) = (from.min(to), from.max(to));
    let between = ring[first..=last].to_vec();
    let round = ring[last..].iter().chain(&ring[..=first]).copied().collect();
    [between, round]
}
