//! The axis of greatest separation, or least penetration, of two convex polygons.

use super::convex::ConvexPolygon;
use super::ring::climb;
use crate::vec2::Vec2;

/// The edge of one polygon whose outward normal separates best from the other polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct BestAxis {
    /// Gap along the normal (m); if negative, the least penetration.
    pub(crate) gap_m: f64,
    /// True where the edge is the first polygon's.
    pub(crate) on_a: bool,
    /// The edge.
    pub(crate) edge: u32,
    /// The other polygon's vertex deepest behind the edge.
    pub(crate) support: u32,
    /// Outward normal of the first polygon along the axis, in the first polygon's frame.
    pub(crate) normal: Vec2,
}

/// Searches the edges of both polygons by rotating callipers: O(n + m).
/// `b_m` are the second polygon's closed vertices in the first one's frame.
pub(crate) fn best_axis(a: &ConvexPolygon, b_m: &[Vec2]) -> BestAxis {
    let from_a = best_edge(a.closed(), b_m);
    let from_b = best_edge(b_m, a.closed());
    let on_a = from_a.gap_m >= from_b.gap_m;
    if on_a { from_a } else { from_b }.axis(on_a)
}

/// The gap between a polygon's edge and another polygon.
#[derive(Clone, Copy)]
pub(super) struct EdgeGap {
    /// The gap along the edge's outward normal (m).
    gap_m: f64,
    edge: usize,
    /// The other polygon's corner deepest behind the edge.
    support: usize,
    outward: Vec2,
}

impl EdgeGap {
    /// The gap of an edge with this number, start and direction; `support` is the corner deepest behind the edge.
    #[inline(always)]
    pub(super) fn new(
        edge: usize,
        (start, along): (Vec2, Vec2),
        (support, support_m): (usize, Vec2),
    ) -> EdgeGap {
        let outward = along.quarter_turn_back() * (1.0 / along.length());
        EdgeGap { gap_m: outward.dot(support_m - start), edge, support, outward }
    }

    /// The gap as an axis. `on_a` tells whether the edge is the first polygon's.
    #[inline(always)]
    pub(super) fn axis(&self, on_a: bool) -> BestAxis {
        let EdgeGap { gap_m, edge, support, outward } = *self;
        let normal = if on_a { outward } else { -outward };
        BestAxis { gap_m, on_a, edge: edge as u32, support: support as u32, normal }
    }
}

/// The edge of `p` with the largest gap to `q`, both closed rings. The deepest corner moves round in the same sense as
/// the edge, so one turn of the edges costs one turn of the corners.
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
