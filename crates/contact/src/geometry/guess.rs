//! Guesses at the one edge through which two polygons overlap that were not near each other in the last step. A good
//! guess saves the sweep of [`super::halfplanes`], and the first the search of [`super::apart`] too; [`super::through`]
//! certifies them, with the same result.

use super::apart::{self, Corner};
use super::convex::{ConvexPolygon, Placed};
use super::lens::{Crossing, Stretch};
use super::ring::{after, before};
use super::through::{self, Through};
use crate::vec2::Vec2;

/// Shallower overlaps are not guessed: the sweep finds out whether edges of them coincide (m).
const LEAST_DEPTH_M: f64 = 1e-6;

/// Polygons with more corners are left to the search, which does not look at all edges.
const MOST_EDGES: usize = 64;

/// The margin of the first guess (m): so much that no edge coincides with one of the other polygon, for which the sweep looks
/// too, and that no corner is on the other's edge, where rounding decides which edges cross.
const MARGIN_M: f64 = 1e-6;

/// The overlap through the edge of the larger polygon that the smaller one's centre is farthest beyond, if it is certified:
/// that of a fender in a hull's side, or of a hull's corner in a quay.
#[inline]
pub(super) fn beyond_an_edge(a: &ConvexPolygon, b: &Placed<'_>) -> Option<(Stretch, Through)> {
    let on_a = a.radius_m() >= b.polygon.radius_m();
    let (own, other) = if on_a { (a, b.polygon) } else { (b.polygon, a) };
    if own.count() > MOST_EDGES {
        return None;
    }
    let rotation = b.pose.rotation;
    let center_m =
        if on_a { b.pose.apply(other.center_m()) } else { b.pose.apply_inverse(other.center_m()) };
    let mut of_edges = (0..).zip(own.edges()).map(|(edge, of)| (edge, of.depth_m(center_m)));
    let first = of_edges.next()?;
    let least = |best: (u32, f64), next: (u32, f64)| if next.1 < best.1 { next } else { best };
    let (edge, depth_m) = of_edges.fold(first, least);
    if depth_m > 0.0 {
        return None;
    }
    let inward = own.edges()[edge as usize].inward();
    let inward = if on_a { rotation.apply_inverse(inward) } else { rotation.apply(inward) };
    let stretch = stretch(a, b, on_a, edge, other.farthest(inward) as u32)?;
    Some((stretch, through::find_within(a, b.polygon, b.pose, stretch, MARGIN_M)?))
}

/// The overlap through an edge of least penetration beside two corners of the difference, if it is certified. Where sides are
/// parallel, those of both polygons are as good: the other polygon's is tried too.
#[inline]
pub(super) fn find(
    a: &ConvexPolygon,
    b: &Placed<'_>,
    corners: [Corner; 2],
) -> Option<(Stretch, Through)> {
    let [of_a, of_b] = apart::best_beside_both(a, b, corners);
    let in_order = if of_a.gap_m >= of_b.gap_m { [of_a, of_b] } else { [of_b, of_a] };
    in_order.into_iter().find_map(|axis| {
        let stretch = stretch(a, b, axis.on_a, axis.edge, axis.support)?;
        let through = through::find(a, b.polygon, b.pose, stretch)?;
        (through.depth_m() > LEAST_DEPTH_M).then_some((stretch, through))
    })
}

/// The stretch through an edge of one of the polygons, from the other's deepest corner behind it. `None` if the other
/// polygon is wholly behind the edge, or not at all.
#[inline]
fn stretch(
    a: &ConvexPolygon,
    b: &Placed<'_>,
    on_a: bool,
    edge: u32,
    deepest: u32,
) -> Option<Stretch> {
    let (index, deepest) = (edge as usize, deepest as usize);
    if on_a {
        // In B's frame: two points to place rather than many.
        let [start, end] = [index, index + 1].map(|k| b.pose.apply_inverse(a.corner(k)));
        let [enters, leaves] = crossed(start, end, |k| b.polygon.corner(k), deepest, b.count())?;
        let crossing = |b: u32| Crossing { a: edge, b };
        Some(Stretch { enter: crossing(leaves), leave: crossing(enters) })
    } else {
        let [start, end] = [index, index + 1].map(|k| b.vertex(k));
        let [enters, leaves] = crossed(start, end, |k| a.corner(k), deepest, a.count())?;
        let crossing = |a: u32| Crossing { a, b: edge };
        Some(Stretch { enter: crossing(enters), leave: crossing(leaves) })
    }
}

/// The edges by which a polygon's boundary comes behind a line and leaves it again, found from its deepest corner.
fn crossed(
    start: Vec2,
    end: Vec2,
    corner: impl Fn(usize) -> Vec2,
    deepest: usize,
    count: usize,
) -> Option<[u32; 2]> {
    let along = end - start;
    let is_behind = |k: usize| along.cross(corner(k) - start) >= 0.0;
    if !is_behind(deepest) {
        return None;
    }
    let (mut enters, mut last) = (deepest, deepest);
    for _ in 0..count {
        if !is_behind(enters) {
            break;
        }
        enters = before(enters, count);
    }
    for _ in 0..count {
        let next = after(last, count);
        if !is_behind(next) {
            return Some([enters as u32, last as u32]);
        }
        last = next;
    }
    None
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::super::apart::Found;
    use super::super::halfplanes::{self, Buffers};
    use super::*;
    use crate::vec2::{Pose, vec2};

    fn ellipse(count: usize, half_length_m: f64, half_beam_m: f64) -> ConvexPolygon {
        let corner = |k: usize| {
            let angle = core::f64::consts::TAU * (k as f64 + 0.5) / count as f64;
            vec2(half_length_m * libm::cos(angle), half_beam_m * libm::sin(angle))
        };
        ConvexPolygon::new(&(0..count).map(corner).collect::<Vec<_>>())
    }

    /// Overlaps of many depths and attitudes: a certified guess is what the sweep finds, and most shallow ones are guessed.
    #[test]
    fn a_certified_guess_is_the_only_stretch_of_the_sweep() {
        let mut state = 7_u64;
        let mut between = |low: f64, high: f64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            low + (high - low) * ((state >> 11) as f64 / (1_u64 << 53) as f64)
        };
        let polygons = [(4, 40.0, 8.0), (4, 1.0, 0.5), (9, 30.0, 6.0), (24, 60.0, 9.0)]
            .map(|(count, length_m, beam_m)| ellipse(count, length_m, beam_m));
        // By each guess; and of those of the second, and of all, that are shallow.
        let (mut certified, mut shallow_certified, mut shallow) = ([0, 0], 0, 0);
        let mut buffers = Buffers::default();
        for round in 0..60_000 {
            let [a, b] = [0, 1].map(|_| &polygons[between(0.0, 3.999) as usize]);
            let place_m = vec2(between(-60.0, 60.0), between(-20.0, 20.0));
            let pose = Pose::new(place_m, between(-3.2, 3.2));
            let placed = Placed { polygon: b, pose };
            let Found::Overlap(corners) = apart::find(a, &placed) else { continue };
            buffers.b_m.clear();
            buffers.b_m.extend(b.closed().iter().map(|&v| pose.apply(v)));
            let swept = halfplanes::intersect(a, &mut buffers);
            let is_shallow = super::super::axis::best_axis(a, &buffers.b_m).gap_m > -0.2;
            shallow += u32::from(is_shallow);
            let guesses = [beyond_an_edge(a, &placed), find(a, &placed, corners)];
            shallow_certified += u32::from(is_shallow && guesses[1].is_some());
            for (guess, count) in guesses.into_iter().zip(&mut certified) {
                let Some((stretch, _)) = guess else { continue };
                assert_eq!(swept, halfplanes::Found::Crossings { collinear: false }, "{round}");
                assert_eq!(buffers.stretches, [stretch], "{round}");
                *count += 1;
            }
        }
        assert!(
            certified.iter().all(|&count| count > 500) && shallow > 100,
            "{certified:?} {shallow}"
        );
        assert!(shallow_certified * 10 > shallow * 7, "{shallow_certified} of {shallow}");
    }
}
