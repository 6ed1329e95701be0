//! Assembles the overlap of two convex polygons from the crossings of their boundaries.

use alloc::vec::Vec;

use super::convex::{ConvexPolygon, Placed};
use super::ring::after;
use crate::maths::number::{greater, lesser};
use crate::maths::vec2::Vec2;

/// A crossing of the boundaries of two polygons: the number of an edge of the first polygon, and of an edge of the
/// second.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Crossing {
    pub(crate) a: u32,
    pub(crate) b: u32,
}

/// A stretch of the first polygon's boundary inside the second polygon, from one crossing to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Stretch {
    pub(crate) enter: Crossing,
    pub(crate) leave: Crossing,
}

/// The overlap of two convex pieces, in the frame of the first piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lens {
    /// Area S (m²).
    pub(crate) area_m2: f64,
    /// Centroid C (m).
    pub(crate) centroid_m: Vec2,
    /// Chord vector d = Σ (P_out − P_in) (m); zero if one piece contains the other.
    pub(crate) chord_m: Vec2,
    /// 1/|d| (1/m). `per_chord_m` is 0 if the chord is unusable: there is no chord, or edges coincide.
    // Computed here because other work hides the time that root and quotient take.
    pub(crate) per_chord_m: f64,
    /// Extent of the overlap along the normal of the chord, times the length of the chord (m²).
    pub(crate) spread_m2: f64,
    /// True if edges of the two pieces coincide, so that the chord is ambiguous.
    pub(crate) collinear: bool,
}

/// The point of an edge at the fraction `share` of its length (m): 0 is the start, 1 the end. A fraction outside 0 to
/// 1, which rounding can cause, gives the nearer end of the edge.
#[inline(always)]
pub(crate) fn point_along(start: Vec2, end: Vec2, share: f64) -> Vec2 {
    // Computed from the nearer end, so that both ends are exact.
    if share <= 0.5 {
        start + (end - start) * greater(share, 0.0)
    } else {
        end - (end - start) * greater(1.0 - share, 0.0)
    }
}

/// A stretch of boundary, with the points P_in and P_out where it begins and ends (m).
#[derive(Clone, Copy, Debug)]
pub(crate) struct Located {
    pub(crate) at: Stretch,
    pub(crate) enters_m: Vec2,
    pub(crate) leaves_m: Vec2,
}

/// Walks the boundary of the overlap and appends the overlap's vertices to `outline_m`. `stretches` must be in the
/// order in which the boundary is walked.
pub(crate) fn assemble(
    a: &ConvexPolygon,
    b: &Placed<'_>,
    stretches: &[Stretch],
    outline_m: &mut Vec<Vec2>,
) -> Lens {
    let start = outline_m.len();
    let mut chord_m = Vec2::ZERO;
    for (k, &at) in stretches.iter().enumerate() {
        let next = &stretches[if k + 1 == stretches.len() { 0 } else { k + 1 }];
        let enters_m = meeting_point(a, b, at.enter);
        let leaves_m = meeting_point(a, b, at.leave);
        chord_m += leaves_m - enters_m;
        trace(a, b, &Located { at, enters_m, leaves_m }, next.enter.b, outline_m);
    }
    measure(&outline_m[start..], chord_m, false)
}

/// Appends a part of the overlap's boundary: from the start of a stretch along the first polygon to its end, and then
/// along the second polygon up to edge `until_b`, where the next stretch begins.
#[inline(always)]
pub(crate) fn trace(
    a: &ConvexPolygon,
    b: &Placed<'_>,
    stretch: &Located,
    until_b: u32,
    outline_m: &mut Vec<Vec2>,
) {
    let Stretch { enter, leave } = stretch.at;
    outline_m.push(stretch.enters_m);
    let mut i = enter.a as usize;
    while i != leave.a as usize {
        i = after(i, a.count());
        outline_m.push(a.corner(i));
    }
    outline_m.push(stretch.leaves_m);
    let mut j = leave.b as usize;
    while j != until_b as usize {
        j = after(j, b.count());
        outline_m.push(b.vertex(j));
    }
}

/// The point where the boundaries of the two polygons cross, given the two edges in `crossing` (m).
fn meeting_point(a: &ConvexPolygon, b: &Placed<'_>, crossing: Crossing) -> Vec2 {
    let (i, j) = (crossing.a as usize, crossing.b as usize);
    let (a0, a1) = (a.corner(i), a.corner(i + 1));
    let (b0, b1) = (b.vertex(j), b.vertex(j + 1));
    let edge = b1 - b0;
    let (side_start, side_end) = (edge.cross(a0 - b0), edge.cross(a1 - b0));
    point_along(a0, a1, side_start / (side_start - side_end))
}

/// Computes area, centroid and spread of a polygon relative to its first vertex, so that small overlaps are accurate.
#[inline(always)]
pub(crate) fn measure(outline_m: &[Vec2], chord_m: Vec2, collinear: bool) -> Lens {
    let origin = outline_m[0];
    let mut twice_area = 0.0;
    let mut moment = Vec2::ZERO;
    let mut from = outline_m[1] - origin;
    let across = chord_m.quarter_turn_back();
    let (mut low, mut high) = (lesser(from.dot(across), 0.0), greater(from.dot(across), 0.0));
    for &vertex in &outline_m[2..] {
        let to = vertex - origin;
        let s = to.dot(across);
        (low, high) = (lesser(s, low), greater(s, high));
        let cross = from.cross(to);
        twice_area += cross;
        moment += (from + to) * cross;
        from = to;
    }
    let centroid_m =
        if twice_area > 0.0 { origin + moment * (1.0 / (3.0 * twice_area)) } else { origin };
    Lens {
        area_m2: 0.5 * twice_area,
        centroid_m,
        chord_m,
        per_chord_m: per_chord_m(chord_m, collinear),
        spread_m2: high - low,
        collinear,
    }
}

/// Least length of a chord (m): a shorter chord is a rounding error, because the sum over closed stretches cancels to
/// about 1e-13 m.
const SHORTEST_CHORD_M: f64 = 1e-11;

/// 1/|d|, the inverse length of the chord vector d, or 0 if the chord is unusable: see [`Lens::per_chord_m`].
#[inline]
pub(crate) fn per_chord_m(chord_m: Vec2, collinear: bool) -> f64 {
    let length_m = chord_m.length();
    if length_m > SHORTEST_CHORD_M && !collinear { 1.0 / length_m } else { 0.0 }
}
