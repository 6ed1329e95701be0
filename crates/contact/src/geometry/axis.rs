//! Finds the axis of greatest separation, or of least penetration, of two convex polygons.

use super::convex::ConvexPolygon;
use super::ring::climb;
use crate::maths::vec2::Vec2;

/// The edge of one polygon whose outward normal separates it best from the other polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BestAxis {
    /// Gap between the polygons along the normal (m); if negative, the least penetration.
    pub(crate) gap_m: f64,
    /// True if the edge belongs to the first polygon.
    pub(crate) on_a: bool,
    /// The edge.
    pub(crate) edge: u32,
    /// The vertex of the other polygon that is deepest behind the edge.
    pub(crate) support: u32,
    /// Outward normal of the first polygon along the axis, in the frame of the first polygon.
    pub(crate) normal: Vec2,
}

/// Searches the edges of both polygons by rotating callipers, with O(n + m) work. `b_m` are the vertices of the second
/// polygon as a closed list, in the frame of the first polygon.
pub(crate) fn best_axis(a: &ConvexPolygon, b_m: &[Vec2]) -> BestAxis {
    let from_a = best_edge(a.closed(), b_m);
    let from_b = best_edge(b_m, a.closed());
    let on_a = from_a.gap_m >= from_b.gap_m;
    if on_a { from_a } else { from_b }.axis(on_a)
}

/// The gap between an edge of a polygon and another polygon.
#[derive(Clone, Copy)]
pub(super) struct EdgeGap {
    /// The gap along the outward normal of the edge (m).
    gap_m: f64,
    edge: usize,
    /// The corner of the other polygon that is deepest behind the edge.
    support: usize,
    outward: Vec2,
}

impl EdgeGap {
    /// Computes the gap of the edge with this number, start and direction; `support` is the corner of the other polygon
    /// deepest behind the edge.
    #[inline(always)]
    pub(super) fn new(
        edge: usize,
        (start, along): (Vec2, Vec2),
        (support, support_m): (usize, Vec2),
    ) -> EdgeGap {
        let outward = along.quarter_turn_back() * (1.0 / along.length());
        EdgeGap { gap_m: outward.dot(support_m - start), edge, support, outward }
    }

    /// Returns this gap as a separating axis. `on_a` tells whether the edge belongs to the first polygon.
    #[inline(always)]
    pub(super) fn axis(&self, on_a: bool) -> BestAxis {
        let EdgeGap { gap_m, edge, support, outward } = *self;
        let normal = if on_a { outward } else { -outward };
        BestAxis { gap_m, on_a, edge: edge as u32, support: support as u32, normal }
    }
}

/// The edge of `p` with the largest gap to `q`. In both lists of corners the first corner stands again at the end. The
/// deepest corner moves round in the same sense as the edge, so a full turn of the edges needs only one full turn of the
/// corners.
fn best_edge(p: &[Vec2], q: &[Vec2]) -> EdgeGap {
    let count = q.len() - 1;
    let mut best = EdgeGap { gap_m: f64::NEG_INFINITY, edge: 0, support: 0, outward: Vec2::ZERO };
    let mut support = None;
    for (edge, ends) in p.windows(2).enumerate() {
        let (start, along) = (ends[0], ends[1] - ends[0]);
        let depth = |j: usize| along.cross(q[j] - start);
        let deeper = |deepest, j| if depth(j) > depth(deepest) { j } else { deepest };
        let deepest = match support {
            None => (1..count).fold(0, deeper),
            Some(last) => climb(depth, last, count).0,
        };
        support = Some(deepest);
        let gap = EdgeGap::new(edge, (start, along), (deepest, q[deepest]));
        if gap.gap_m > best.gap_m {
            best = gap;
        }
    }
    best
}
