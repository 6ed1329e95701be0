//! The warm path of the clip: contacts move little from step to step, so walk from the edges that
//! crossed in the last step, touch only the vertices near them, and certify that the small lens
//! found there is the whole overlap. Where the certificate fails the cold path answers.
//!
//! Why the certificate holds. Let the first polygon's boundary enter the second's at P_in and leave
//! it at P_out, and let Q be bounded by the first one's chain from P_in to P_out and the second
//! one's chain back. Q turns left at every corner, and by one turn in all as long as neither chain
//! turns by more than half a turn: so Q is convex and lies to the left of all its own edges. What
//! is left to show is that each chain's vertices lie within the *far* part of the other polygon,
//! whose edges are not Q's. A polygon inscribed in that far part, of four of its vertices, is
//! enough. Then Q's boundary is part of the boundary of the overlap; both are simple closed curves,
//! so they are the same.

use super::convex::{ConvexPolygon, Placed, after, before};
use super::lens::{Crossing, Stretch};
use crate::vec2::Vec2;

/// Steps that a walk may take before the cold path is the cheaper one.
const WALK: usize = 8;
/// Chains longer than this (in vertices) are left to the cold path.
const CHAIN: usize = 32;
/// Far parts of up to this many edges are tested edge by edge.
const FAR_EXACT: usize = 4;
/// Crossing edges flatter than this sine are left to the cold path, which knows of edges that lie
/// on one another.
const FLAT: f64 = 1e-9;

/// A crossing with the geometry that found it.
struct Edges {
    at: Crossing,
    a_along: Vec2,
    b_along: Vec2,
    a_start: Vec2,
    a_end: Vec2,
    b_end: Vec2,
    b_start: Vec2,
    /// How far along the first polygon's edge, 0 to 1.
    share: f64,
}

/// The stretch of `a`'s boundary inside `b`, if it is found near `hint` and certified to be the
/// only one.
#[inline]
pub(crate) fn find(a: &ConvexPolygon, b: &Placed<'_>, hint: Stretch) -> Option<Stretch> {
    let enter = walk::<true>(a, b, hint.enter)?;
    let leave = walk::<false>(a, b, hint.leave)?;
    certify(a, b, &enter, &leave).then_some(Stretch { enter: enter.at, leave: leave.at })
}

/// Walks to the crossing where `a` enters (or leaves) `b`.
#[inline]
fn walk<const ENTER: bool>(a: &ConvexPolygon, b: &Placed<'_>, hint: Crossing) -> Option<Edges> {
    let (n, m) = (a.count(), b.count());
    let (mut i, mut j) = (hint.a as usize, hint.b as usize);
    if i >= n || j >= m {
        return None;
    }
    let (mut b_start, mut b_end) = (b.vertex(j), b.vertex(j + 1));
    for _ in 0..WALK {
        let (a_start, a_end) = (a.closed()[i], a.closed()[i + 1]);
        let (a_along, b_along) = (a_end - a_start, b_end - b_start);
        let a_start_in = b_along.cross(a_start - b_start);
        let a_end_in = b_along.cross(a_end - b_start);
        let b_start_in = a_along.cross(b_start - a_start);
        let b_end_in = a_along.cross(b_end - a_start);
        if ENTER {
            if a_start_in >= 0.0 {
                i = before(i, n);
            } else if a_end_in < 0.0 {
                i = after(i, n);
            } else if b_start_in < 0.0 {
                j = before(j, m);
                (b_end, b_start) = (b_start, b.vertex(j));
            } else if b_end_in >= 0.0 {
                j = after(j, m);
                (b_start, b_end) = (b_end, b.vertex(j + 1));
            } else {
                let share = a_start_in / (a_start_in - a_end_in);
                let at = Crossing { a: i as u32, b: j as u32 };
                return Some(Edges { at, a_along, b_along, a_start, a_end, b_start, b_end, share });
            }
        } else if a_end_in >= 0.0 {
            i = after(i, n);
        } else if a_start_in < 0.0 {
            i = before(i, n);
        } else if b_end_in < 0.0 {
            j = after(j, m);
            (b_start, b_end) = (b_end, b.vertex(j + 1));
        } else if b_start_in >= 0.0 {
            j = before(j, m);
            (b_end, b_start) = (b_start, b.vertex(j));
        } else {
            let share = a_start_in / (a_start_in - a_end_in);
            let at = Crossing { a: i as u32, b: j as u32 };
            return Some(Edges { at, a_along, b_along, a_start, a_end, b_start, b_end, share });
        }
    }
    None
}

#[inline]
fn certify(a: &ConvexPolygon, b: &Placed<'_>, enter: &Edges, leave: &Edges) -> bool {
    let (n, m) = (a.count(), b.count());
    let a_chain = ring_distance(enter.at.a, leave.at.a, n);
    let b_chain = ring_distance(leave.at.b, enter.at.b, m);
    if a_chain > CHAIN || b_chain > CHAIN || flat(enter) || flat(leave) {
        return false;
    }
    chain_turns_little(a_chain, enter.a_along, leave.a_along, enter.share < leave.share)
        && chain_turns_little(b_chain, leave.b_along, enter.b_along, b_order(enter, leave))
        && a_chain_in_far_b(a, b, enter, leave, a_chain)
        && b_chain_in_far_a(a, b, enter, leave, b_chain)
}

#[inline]
fn flat(edges: &Edges) -> bool {
    let sine = edges.a_along.cross(edges.b_along);
    sine * sine
        <= FLAT * FLAT * edges.a_along.length_squared() * edges.b_along.length_squared()
}

/// On one edge of `b`: does the walk back meet P_out before P_in?
#[inline]
fn b_order(enter: &Edges, leave: &Edges) -> bool {
    let enters = enter.a_start + enter.a_along * enter.share;
    let leaves = leave.a_start + leave.a_along * leave.share;
    enter.b_along.dot(enters - leaves) > 0.0
}

/// At most half a turn from the first edge of a chain to its last; on one edge, in order.
#[inline]
fn chain_turns_little(chain: usize, first: Vec2, last: Vec2, in_order: bool) -> bool {
    if chain == 0 { in_order } else { first.cross(last) >= 0.0 }
}

#[inline]
fn ring_distance(from: u32, to: u32, count: usize) -> usize {
    let (from, to) = (from as usize, to as usize);
    if to >= from { to - from } else { to + count - from }
}

/// The first polygon's chain against the second's far part: from the end of the edge where it
/// enters round to the start of the edge where it leaves.
#[inline]
fn a_chain_in_far_b(
    a: &ConvexPolygon,
    b: &Placed<'_>,
    enter: &Edges,
    leave: &Edges,
    chain: usize,
) -> bool {
    if chain == 0 {
        return true;
    }
    let m = b.count();
    let from = after(enter.at.b as usize, m);
    let edges = ring_distance(from as u32, leave.at.b, m);
    let far = FarPart { from, edges, count: m, start: enter.b_end, end: leave.b_start };
    far.holds(|k| b.vertex(k), chain, |step| a.closed()[ring(enter.at.a, step, a.count())])
}

/// The second polygon's chain against the first one's far part.
#[inline]
fn b_chain_in_far_a(
    a: &ConvexPolygon,
    b: &Placed<'_>,
    enter: &Edges,
    leave: &Edges,
    chain: usize,
) -> bool {
    if chain == 0 {
        return true;
    }
    let n = a.count();
    let from = after(leave.at.a as usize, n);
    let edges = ring_distance(from as u32, enter.at.a, n);
    let far = FarPart { from, edges, count: n, start: leave.a_end, end: enter.a_start };
    far.holds(|k| a.closed()[k], chain, |step| b.vertex(ring(leave.at.b, step, b.count())))
}

/// Index `step + 1` places after edge `from`: the chain's vertices in order.
#[inline]
fn ring(from: u32, step: usize, count: usize) -> usize {
    let index = from as usize + step + 1;
    if index >= count { index - count } else { index }
}

/// The edges of a polygon that take no part in a lens: `edges` of them, from vertex `from` on.
struct FarPart {
    from: usize,
    edges: usize,
    count: usize,
    start: Vec2,
    end: Vec2,
}

impl FarPart {
    /// Do all of a chain's vertices lie within the far part? Tests a polygon inscribed in it first
    /// and, for those it does not hold, the far part itself.
    #[inline]
    fn holds(
        &self,
        vertex: impl Fn(usize) -> Vec2,
        chain: usize,
        chain_vertex: impl Fn(usize) -> Vec2,
    ) -> bool {
        let at = |k: usize| vertex((self.from + k) % self.count);
        let all_edges = |p: Vec2| {
            let mut start = self.start;
            (1..=self.edges).all(|k| {
                let end = at(k);
                let left = (end - start).cross(p - start) >= 0.0;
                start = end;
                left
            })
        };
        if self.edges <= FAR_EXACT {
            return (0..chain).all(|step| all_edges(chain_vertex(step)));
        }
        let (one, two) = (at(self.edges / 3), at(self.edges - self.edges / 3));
        (0..chain).all(|step| {
            let p = chain_vertex(step);
            let inscribed = (one - self.start).cross(p - self.start) >= 0.0
                && (two - one).cross(p - one) >= 0.0
                && (self.end - two).cross(p - two) >= 0.0;
            inscribed || all_edges(p)
        })
    }
}
