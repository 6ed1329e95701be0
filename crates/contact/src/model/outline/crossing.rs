//! Finds edges of an outline that meet although they are not neighbours.

use alloc::vec::Vec;

use super::MERGE_DISTANCE_M;
use super::exact::turn;
use crate::maths::number::{greater, lesser};
use crate::maths::vec2::Vec2;

/// Finds two edges that are not neighbours and that cross, touch, overlap or come within [`MERGE_DISTANCE_M`] of each
/// other. Edge i goes from vertex i to vertex i + 1. Of all pairs of edges that meet, the function returns the pair
/// with the lowest edge, and among these the pair with the lowest other edge. The function returns `None` if the
/// polygon is simple, provided that successive edges do not lie on each other.
///
/// The sweep over the edges runs along the axis on which the edges are shorter. The sweep over n edges takes n log n
/// tests for hulls and quays, and at worst n² cheap tests (0.3 s for 10,000 vertices).
pub(super) fn meeting_edges(vertices: &[Vec2]) -> Option<[usize; 2]> {
    let edges = swept(vertices);
    let neighbours = |i: usize, j: usize| {
        let apart = i.abs_diff(j);
        apart <= 1 || apart == vertices.len() - 1
    };
    let mut first: Option<[usize; 2]> = None;
    for (rank, edge) in edges.iter().enumerate() {
        for other in &edges[rank + 1..] {
            if other.sweep.low > edge.sweep.high {
                break;
            }
            let pair = [edge.index.min(other.index), edge.index.max(other.index)];
            if edge.across.low <= other.across.high
                && other.across.low <= edge.across.high
                && first.is_none_or(|best| pair < best)
                && !edge.passes(other)
                && !other.passes(edge)
                && !neighbours(edge.index, other.index)
                && (segments_meet(edge.ends(), other.ends())
                    || segments_near(edge.ends(), other.ends()))
            {
                first = Some(pair);
            }
        }
    }
    first
}

/// An edge of the outline, with its extent along and across the direction of the sweep.
struct Edge {
    index: usize,
    from: Vec2,
    to: Vec2,
    length_m: f64,
    sweep: Span,
    across: Span,
}

/// An interval along one axis, widened by [`MERGE_DISTANCE_M`] at both ends.
#[derive(Clone, Copy)]
struct Span {
    low: f64,
    high: f64,
}

impl Span {
    fn new(a: f64, b: f64) -> Span {
        Span { low: lesser(a, b) - MERGE_DISTANCE_M, high: greater(a, b) + MERGE_DISTANCE_M }
    }
}

/// Lists the edges in the order in which the sweep meets them.
fn swept(vertices: &[Vec2]) -> Vec<Edge> {
    let successors = || vertices.iter().skip(1).chain(vertices.first());
    let (mut along, mut low, mut high) = (Vec2::ZERO, vertices[0], vertices[0]);
    for (a, b) in vertices.iter().zip(successors()) {
        along.x += (b.x - a.x).abs();
        along.y += (b.y - a.y).abs();
        low = Vec2 { x: lesser(low.x, a.x), y: lesser(low.y, a.y) };
        high = Vec2 { x: greater(high.x, a.x), y: greater(high.y, a.y) };
    }
    let extent = high - low;
    let along_x = along.x * extent.y <= along.y * extent.x;
    let mut edges: Vec<Edge> = vertices
        .iter()
        .zip(successors())
        .enumerate()
        .map(|(index, (&from, &to))| {
            let (x, y) = (Span::new(from.x, to.x), Span::new(from.y, to.y));
            let (sweep, across) = if along_x { (x, y) } else { (y, x) };
            Edge { index, from, to, length_m: (to - from).length(), sweep, across }
        })
        .collect();
    edges.sort_by(|a, b| a.sweep.low.total_cmp(&b.sweep.low).then(a.index.cmp(&b.index)));
    edges
}

impl Edge {
    fn ends(&self) -> [Vec2; 2] {
        [self.from, self.to]
    }

    /// Returns true if all of `other` is on one side of this edge's line, farther from the line than
    /// [`MERGE_DISTANCE_M`] and rounding.
    fn passes(&self, other: &Edge) -> bool {
        let direction = self.to - self.from;
        let (a, b) = (other.from - self.from, other.to - self.from);
        let reach = a.x.abs() + a.y.abs() + b.x.abs() + b.y.abs();
        let margin = self.length_m * (MERGE_DISTANCE_M + 1.0e-15 * reach);
        let (side_a, side_b) = (direction.cross(a), direction.cross(b));
        (side_a > margin && side_b > margin) || (side_a < -margin && side_b < -margin)
    }
}

/// Returns true if two closed segments have a point in common. The test is exact.
pub(super) fn segments_meet([a, b]: [Vec2; 2], [c, d]: [Vec2; 2]) -> bool {
    let (c_side, d_side) = (turn(a, b, c), turn(a, b, d));
    let (a_side, b_side) = (turn(c, d, a), turn(c, d, b));
    if opposite(c_side, d_side) && opposite(a_side, b_side) {
        return true;
    }
    (c_side == 0.0 && in_box(c, a, b))
        || (d_side == 0.0 && in_box(d, a, b))
        || (a_side == 0.0 && in_box(a, c, d))
        || (b_side == 0.0 && in_box(b, c, d))
}

fn opposite(a: f64, b: f64) -> bool {
    (a > 0.0 && b < 0.0) || (a < 0.0 && b > 0.0)
}

/// Returns true if the point p is in the box spanned by a and b. If p is on the line through a and b and in their box,
/// p is on the segment from a to b.
fn in_box(p: Vec2, a: Vec2, b: Vec2) -> bool {
    p.x >= lesser(a.x, b.x)
        && p.x <= greater(a.x, b.x)
        && p.y >= lesser(a.y, b.y)
        && p.y <= greater(a.y, b.y)
}

/// Returns true if two segments that do not cross come within [`MERGE_DISTANCE_M`] of each other. If two segments come
/// so near to each other, an end point of one of the segments comes so near to the other segment.
fn segments_near([a, b]: [Vec2; 2], [c, d]: [Vec2; 2]) -> bool {
    point_near(a, c, d) || point_near(b, c, d) || point_near(c, a, b) || point_near(d, a, b)
}

fn point_near(p: Vec2, a: Vec2, b: Vec2) -> bool {
    let (direction, from_a) = (b - a, p - a);
    let along = direction.dot(from_a);
    let squared_length = direction.length_squared();
    let limit = MERGE_DISTANCE_M * MERGE_DISTANCE_M;
    if along <= 0.0 {
        from_a.length_squared() <= limit
    } else if along >= squared_length {
        (p - b).length_squared() <= limit
    } else {
        let across = direction.cross(from_a);
        across * across <= limit * squared_length
    }
}
