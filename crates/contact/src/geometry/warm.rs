//! The warm path of the clip: computes the overlap of two polygons from the result of the last step. Contacts move
//! little from step to step. So the warm path walks from the edges that crossed in the last step, reads only the
//! vertices near these edges, and certifies that the overlap found there is the whole overlap. If this certificate
//! fails, the cold path of the clip is used.
//!
//! Proof of the certificate. Let the first polygon's boundary enter the second polygon at P_in and leave it at P_out.
//! Let Q be the region bounded by the first polygon's chain from P_in to P_out and by the second polygon's chain back.
//! The boundary of the region Q turns left at every corner. If neither chain turns by more than half a turn, the
//! boundary of Q turns by one full turn: so Q is convex and lies to the left of all its edges. It remains to show that
//! the vertices of each chain lie within the *far* part of the other polygon: the part whose edges are not edges of Q.
//! It is enough that the vertices lie within a polygon of three or four vertices inscribed in that far part. If the
//! vertices lie in the far part, the boundary of Q is part of the boundary of the overlap. The boundaries of Q and of
//! the overlap are simple closed curves, so they are the same.
//!
//! One of the two chains may turn by more than half a turn if the other chain is on a single edge. An example is the
//! chain of a fender that overlaps a bow so far that all but one of the fender's corners lie in the overlap. The
//! boundary of a convex polygon crosses the edge's line twice at most, so the region Q is all of the polygon behind the
//! line, and convex. For a chain that turns by more than half a turn, the rest of the proof is the same.

use alloc::vec::Vec;

use super::convex::{ConvexPolygon, Placed};
use super::lens::{Crossing, Located, Stretch, point_along, trace};
use super::ring::{after, before, ring_distance};
use crate::maths::vec2::Vec2;

/// Largest number of steps in the walk from the crossing of the last step to the crossing of this step. Beyond this
/// number of steps the cold path of the clip is cheaper.
const WALK: usize = 8;
/// Largest length of a chain, in vertices; longer chains are left to the cold path of the clip.
const CHAIN: usize = 32;
/// Crossing edges whose angle has a smaller sine than this are left to the cold path, which treats coincident edges.
pub(super) const FLAT: f64 = 1e-9;
/// Rounding error of the sine of the angle between two edges; far below [`FLAT`].
const ROUNDING: f64 = 1e-13;

/// A crossing of two edges, with the geometry that gave the crossing.
struct Edges {
    at: Crossing,
    a_start: Vec2,
    a_end: Vec2,
    b_start: Vec2,
    b_end: Vec2,
    a_along: Vec2,
    b_along: Vec2,
    /// b_along × a_along.
    turn: f64,
    /// Place of the crossing along the first polygon's edge, from 0 at its start to 1 at its end.
    share: f64,
}

impl Edges {
    #[inline]
    fn point(&self) -> Vec2 {
        point_along(self.a_start, self.a_end, self.share)
    }

    #[inline]
    fn is_flat(&self) -> bool {
        self.turn * self.turn
            <= FLAT * FLAT * self.a_along.length_squared() * self.b_along.length_squared()
    }
}

/// Finds the stretch of the boundary of `a` inside `b`, if it lies near `hint` and is certified to be the only stretch.
/// Appends the vertices of the overlap to `outline_m`.
#[inline(always)]
pub(crate) fn find(
    a: &ConvexPolygon,
    b: &Placed<'_>,
    hint: Stretch,
    outline_m: &mut Vec<Vec2>,
) -> Option<Located> {
    let enter = walk::<true>(a, b, hint.enter)?;
    let leave = walk::<false>(a, b, hint.leave)?;
    if enter.is_flat() || leave.is_flat() {
        return None;
    }
    let at = Stretch { enter: enter.at, leave: leave.at };
    let found = Located { at, enters_m: enter.point(), leaves_m: leave.point() };
    let a_chain = ring_distance(enter.at.a, leave.at.a, a.count());
    let b_chain = ring_distance(leave.at.b, enter.at.b, b.count());
    if a_chain > CHAIN || b_chain > CHAIN {
        return None;
    }
    let a_turns_little =
        chain_turns_little(a_chain, enter.a_along, leave.a_along, enter.share < leave.share);
    let b_turns_little =
        chain_turns_little(b_chain, leave.b_along, enter.b_along, b_order(&enter, &found));
    let is_convex = match (a_chain, b_chain) {
        (0, 1..) => a_turns_little,
        (1.., 0) => b_turns_little,
        _ => a_turns_little && b_turns_little,
    };
    if !is_convex {
        return None;
    }
    let start = outline_m.len();
    trace(a, b, &found, enter.at.b, outline_m);
    let (of_a, of_b) = outline_m[start..].split_at(1 + a_chain);
    let certified = far_part_of_b(b, &enter, &leave).holds(|k| b.vertex(k), &of_a[1..])
        && far_part_of_a(a, &enter, &leave).holds(|k| a.corner(k), &of_b[1..]);
    if !certified {
        outline_m.truncate(start);
        return None;
    }
    Some(found)
}

/// Walks to the crossing where the boundary of `a` enters (or leaves) `b`.
#[inline(always)]
fn walk<const ENTER: bool>(a: &ConvexPolygon, b: &Placed<'_>, hint: Crossing) -> Option<Edges> {
    let (n, m) = (a.count(), b.count());
    let (mut i, mut j) = (hint.a as usize, hint.b as usize);
    if i >= n || j >= m {
        return None;
    }
    let (mut b_start, mut b_end) = (b.vertex(j), b.vertex(j + 1));
    for _ in 0..WALK {
        let (a_start, a_end) = (a.corner(i), a.corner(i + 1));
        let (a_along, b_along) = (a_end - a_start, b_end - b_start);
        let a_start_in = b_along.cross(a_start - b_start);
        let a_end_in = b_along.cross(a_end - b_start);
        let b_start_in = a_along.cross(b_start - a_start);
        let b_end_in = a_along.cross(b_end - a_start);
        let (before_a, beyond_a, before_b, beyond_b) = if ENTER {
            (a_start_in >= 0.0, a_end_in < 0.0, b_start_in < 0.0, b_end_in >= 0.0)
        } else {
            (a_start_in < 0.0, a_end_in >= 0.0, b_start_in >= 0.0, b_end_in < 0.0)
        };
        if before_a {
            i = before(i, n);
        } else if beyond_a {
            i = after(i, n);
        } else if before_b {
            j = before(j, m);
            (b_end, b_start) = (b_start, b.vertex(j));
        } else if beyond_b {
            j = after(j, m);
            (b_start, b_end) = (b_end, b.vertex(j + 1));
        } else {
            let at = Crossing { a: i as u32, b: j as u32 };
            let turn = a_end_in - a_start_in;
            let share = a_start_in / -turn;
            return Some(Edges {
                at,
                a_start,
                a_end,
                b_start,
                b_end,
                a_along,
                b_along,
                turn,
                share,
            });
        }
    }
    None
}

/// For a chain on a single edge of `b`: returns true if the walk back reaches P_out before P_in.
#[inline(always)]
fn b_order(enter: &Edges, found: &Located) -> bool {
    enter.b_along.dot(found.enters_m - found.leaves_m) > 0.0
}

/// Returns true if a chain turns by at most half a turn, within rounding. The tolerance is needed because opposite
/// sides of a box are exactly half a turn apart. For a chain on a single edge, returns true if its points are in order.
/// The corners at P_in and P_out turn by more than [`FLAT`], which leaves more room than the rounding of a half turn.
#[inline(always)]
fn chain_turns_little(chain: usize, first: Vec2, last: Vec2, in_order: bool) -> bool {
    if chain == 0 {
        return in_order;
    }
    let turn = first.cross(last);
    turn >= 0.0
        || (first.dot(last) < 0.0
            && turn * turn <= ROUNDING * ROUNDING * first.length_squared() * last.length_squared())
}

/// The far part of the boundary of `b`: from the end of the edge where `a` enters to the start of the edge where `a`
/// leaves.
#[inline(always)]
fn far_part_of_b(b: &Placed<'_>, enter: &Edges, leave: &Edges) -> FarPart {
    let count = b.count();
    let from = after(enter.at.b as usize, count);
    let edges = ring_distance(from as u32, leave.at.b, count);
    FarPart { from, edges, count, start: enter.b_end, end: leave.b_start }
}

/// The far part of the boundary of `a`: from the end of the edge at which `a` leaves `b` to the start of the edge at
/// which `a` enters `b`.
#[inline(always)]
fn far_part_of_a(a: &ConvexPolygon, enter: &Edges, leave: &Edges) -> FarPart {
    let count = a.count();
    let from = after(leave.at.a as usize, count);
    let edges = ring_distance(from as u32, enter.at.a, count);
    FarPart { from, edges, count, start: leave.a_end, end: enter.a_start }
}

/// The edges of a polygon that do not bound the overlap: `edges` edges, from vertex `from` on.
struct FarPart {
    from: usize,
    edges: usize,
    count: usize,
    start: Vec2,
    end: Vec2,
}

impl FarPart {
    /// Returns true if all vertices of a chain are within the far part. The test tries a polygon inscribed in the far
    /// part first, and then the far part itself. `vertex` gives the vertices of the polygon with the far part.
    #[inline(always)]
    fn holds(&self, vertex: impl Fn(usize) -> Vec2, chain: &[Vec2]) -> bool {
        if chain.is_empty() {
            return true;
        }
        match self.edges {
            0 => return true,
            1 => return chain.iter().all(|&p| is_left(self.start, self.end, p)),
            _ => {}
        }
        let middle = vertex(self.index(self.edges / 2));
        chain.iter().all(|&p| {
            let inscribed = is_left(self.start, middle, p) & is_left(middle, self.end, p);
            inscribed || self.holds_in_thirds(&vertex, p)
        })
    }

    /// Does the test of [`FarPart::holds`] with an inscribed polygon of four corners, for cases in which three corners
    /// are not enough.
    #[inline(never)]
    fn holds_in_thirds(&self, vertex: impl Fn(usize) -> Vec2, p: Vec2) -> bool {
        let third = self.edges / 3;
        let (one, two) = (vertex(self.index(third)), vertex(self.index(self.edges - third)));
        let inscribed =
            is_left(self.start, one, p) && is_left(one, two, p) && is_left(two, self.end, p);
        inscribed || self.holds_exactly(vertex, p)
    }

    #[cold]
    #[inline(never)]
    fn holds_exactly(&self, vertex: impl Fn(usize) -> Vec2, p: Vec2) -> bool {
        let mut start = self.start;
        (1..=self.edges).all(|k| {
            let end = vertex(self.index(k));
            let left = is_left(start, end, p);
            start = end;
            left
        })
    }

    /// Index in the polygon of the `k`th vertex of the far part.
    #[inline(always)]
    fn index(&self, k: usize) -> usize {
        let index = self.from + k;
        if index >= self.count { index - self.count } else { index }
    }
}

/// Returns true if `p` is to the left of the line from `start` to `end`, or on this line.
#[inline(always)]
fn is_left(start: Vec2, end: Vec2, p: Vec2) -> bool {
    (end - start).cross(p - start) >= 0.0
}

#[cfg(test)]
mod tests {
    use super::super::halfplanes::{self, Buffers, Found};
    use super::super::lens::assemble;
    use super::*;
    use crate::maths::vec2::{Pose, vec2};

    /// A tug pressed so far over a fender that one corner alone is beyond her bow: the fender's chain turns by 270°.
    #[test]
    fn three_corners_behind_one_edge_are_found_from_the_last_step() {
        let block = |x: f64, y: f64| {
            ConvexPolygon::new(&[vec2(-x, -y), vec2(x, -y), vec2(x, y), vec2(-x, y)])
        };
        let (tug, fender) = (block(16.0, 5.0), block(0.5, 2.0));
        for (a, b, pose) in [
            (&tug, &fender, Pose::new(vec2(15.5, 0.3), 0.04)),
            (&fender, &tug, Pose::new(vec2(15.5, 0.3), 0.04).to(Pose::IDENTITY)),
        ] {
            let placed = Placed { polygon: b, pose };
            let mut buffers = Buffers::default();
            buffers.b_m.extend(b.closed().iter().map(|&v| pose.apply(v)));
            let swept = halfplanes::intersect(a, &mut buffers);
            assert_eq!(swept, Found::Crossings { collinear: false });
            let (mut warm_m, mut cold_m) = (Vec::new(), Vec::new());
            let found = find(a, &placed, buffers.stretches[0], &mut warm_m);
            assert_eq!(found.map(|found| found.at), Some(buffers.stretches[0]));
            assemble(a, &placed, &buffers.stretches, &mut cold_m);
            assert_eq!(warm_m, cold_m);
            assert_eq!(warm_m.len(), 5);
        }
    }
}
