//! The axis of greatest separation, or least penetration, of two convex polygons.

use super::convex::ConvexPolygon;
use super::ring::{after, before};
use crate::vec2::Vec2;

/// The edge of one polygon whose outward normal separates best from the other polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BestAxis {
    /// Gap along the normal (m); negative: least penetration.
    pub(crate) gap_m: f64,
    /// True where the edge is the first polygon's.
    pub(crate) on_a: bool,
    /// The edge.
    pub(crate) edge: u32,
    /// The other polygon's vertex deepest behind the edge.
    pub(crate) support: u32,
    /// Outward normal of the first polygon along the axis, in its frame.
    pub(crate) normal: Vec2,
}

/// Searches the edges of both polygons by rotating callipers: O(n + m).
/// `b_m` are the second polygon's closed vertices in the first one's frame.
pub(crate) fn best_axis(a: &ConvexPolygon, b_m: &[Vec2]) -> BestAxis {
    let from_a = best_edge(a.closed(), b_m);
    let from_b = best_edge(b_m, a.closed());
    let on_a = from_a.gap_m >= from_b.gap_m;
    let EdgeGap { gap_m, edge, support, outward } = if on_a { from_a } else { from_b };
    let normal = if on_a { outward } else { -outward };
    BestAxis { gap_m, on_a, edge: edge as u32, support: support as u32, normal }
}

#[derive(Clone, Copy)]
struct EdgeGap {
    gap_m: f64,
    edge: usize,
    support: usize,
    outward: Vec2,
}

/// The edge of `p` with the largest gap to `q`, both closed rings.
fn best_edge(p: &[Vec2], q: &[Vec2]) -> EdgeGap {
    let mut best = EdgeGap { gap_m: f64::NEG_INFINITY, edge: 0, support: 0, outward: Vec2::ZERO };
    let mut support = None;
    for edge in 0..p.len() - 1 {
        let along = p[edge + 1] - p[edge];
        let deepest = match support {
            None => deepest_by_search(p[edge], along, q),
            Some(j) => climb(p[edge], along, q, j),
        };
        support = Some(deepest);
        let outward = along.quarter_turn_back() * (1.0 / along.length());
        let gap_m = outward.dot(q[deepest] - p[edge]);
        if gap_m > best.gap_m {
            best = EdgeGap { gap_m, edge, support: deepest, outward };
        }
    }
    best
}

fn deepest_by_search(start: Vec2, along: Vec2, q: &[Vec2]) -> usize {
    let depth = |j: usize| along.cross(q[j] - start);
    (1..q.len() - 1).fold(0, |deepest, j| if depth(j) > depth(deepest) { j } else { deepest })
}

/// From vertex `j` uphill to the deepest vertex. The deepest vertex turns in the same sense as the
/// edge, so that one turn of the edges costs one turn of the vertices.
fn climb(start: Vec2, along: Vec2, q: &[Vec2], mut j: usize) -> usize {
    let count = q.len() - 1;
    let depth = |j: usize| along.cross(q[j] - start);
    for _ in 0..count {
        let (next, previous) = (after(j, count), before(j, count));
        if depth(next) > depth(j) {
            j = next;
        } else if depth(previous) > depth(j) {
            j = previous;
        } else {
            break;
        }
    }
    j
}
