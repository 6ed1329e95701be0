//! Finds the edge that separates two convex polygons best, without a hint from the last step. The search is used in the
//! first step of a pair of bodies, and where the edge of the last step no longer separates the polygons.
//!
//! The search uses the method of Gilbert, Johnson and Keerthi (1988). The difference of two polygons A and B is the set
//! of all vectors from a point of A to a point of B. The search finds the point of the difference nearest to the
//! origin, from the corners of the difference in better and better directions. The edges of a convex polygon are sorted
//! by angle, so bisection finds the farthest corner in a direction.
//!
//! The gap along a direction is at most the distance between the two polygons. The gap equals the distance of the
//! polygons along the line between their nearest points, and is smaller along other directions. So the edge that
//! separates best is one that meets a corner nearest to the other polygon.

use super::axis::{BestAxis, EdgeGap};
use super::convex::{ConvexPolygon, Placed};
use super::ring::{before, climb};
use crate::maths::vec2::Vec2;

/// Least gap of two polygons for this search (m); nearer or overlapping polygons are left to the cold path of the clip.
const LEAST_GAP_M: f64 = 1e-9;

/// Most guesses. Each guess at least halves the error of the search, so more guesses are needed only where rounding
/// decides.
const MOST_GUESSES: usize = 24;

/// The search ends when the next guess would be nearer to the origin by less than this fraction of the squared
/// distance.
const NEAR_ENOUGH: f64 = 1e-12;

/// A corner of the difference of two polygons, with the corners of both polygons that give it.
#[derive(Clone, Copy)]
pub(super) struct Corner {
    at_m: Vec2,
    of_a: usize,
    of_b: usize,
}

/// The part of the difference of two polygons that is nearest to the origin.
enum Nearest {
    /// The origin is outside the difference; the field is a corner of the edge nearest to the origin.
    Outside(Corner),
    /// The origin is in a triangle of three corners of the difference: the polygons overlap.
    Within,
    Unsure,
}

impl Corner {
    /// The corner of the difference that is least far in the direction `direction`.
    #[inline]
    fn least(a: &ConvexPolygon, b: &Placed<'_>, direction: Vec2) -> Corner {
        let of_a = a.farthest(direction);
        let of_b = b.polygon.farthest(-b.pose.rotation.apply_inverse(direction));
        Corner { at_m: b.vertex(of_b) - a.corner(of_a), of_a, of_b }
    }
}

/// The axis of greatest separation of two polygons, if their gap is more than [`LEAST_GAP_M`]. Returns `None` if the
/// polygons overlap, or if the search is not certain.
pub(super) fn find(a: &ConvexPolygon, b: &Placed<'_>) -> Option<BestAxis> {
    match nearest(a, b) {
        Nearest::Outside(corner) => {
            let best = best_beside(a, b, corner);
            (best.gap_m > LEAST_GAP_M).then_some(best)
        }
        Nearest::Within | Nearest::Unsure => None,
    }
}

/// The axis with the greatest gap among the edges that meet a corner of the difference.
fn best_beside(a: &ConvexPolygon, b: &Placed<'_>, corner: Corner) -> BestAxis {
    let (n, m) = (a.count(), b.count());
    // Among equal gaps, the gap of the first polygon is taken, and of this polygon's edges the first, as in
    // `best_axis`.
    let [one, two] = in_order(before(corner.of_a, n), corner.of_a);
    let [three, four] = in_order(before(corner.of_b, m), corner.of_b);
    [axis_of_a(a, b, two, corner), axis_of_b(a, b, three, corner), axis_of_b(a, b, four, corner)]
        .into_iter()
        .fold(axis_of_a(a, b, one, corner), greater)
}

#[inline]
fn greater(best: BestAxis, next: BestAxis) -> BestAxis {
    if next.gap_m > best.gap_m { next } else { best }
}

/// The axis along the normal of an edge of polygon A.
#[inline(always)]
fn axis_of_a(a: &ConvexPolygon, b: &Placed<'_>, edge: usize, corner: Corner) -> BestAxis {
    let ends = [a.corner(edge), a.corner(edge + 1)];
    gap(edge, ends, |k| b.vertex(k), b.count(), corner.of_b).axis(true)
}

/// The axis along the normal of an edge of polygon B.
#[inline(always)]
fn axis_of_b(a: &ConvexPolygon, b: &Placed<'_>, edge: usize, corner: Corner) -> BestAxis {
    let ends = [b.vertex(edge), b.vertex(edge + 1)];
    gap(edge, ends, |k| a.corner(k), a.count(), corner.of_a).axis(false)
}

/// The gap between an edge and the other polygon; the search for the other polygon's deepest corner behind the edge
/// begins at the corner `from`, which is near the deepest corner. `corner` gives the corners of the other polygon,
/// which has `count` corners.
#[inline(always)]
fn gap(
    edge: usize,
    [start, end]: [Vec2; 2],
    corner: impl Fn(usize) -> Vec2,
    count: usize,
    from: usize,
) -> EdgeGap {
    let along = end - start;
    let (support, _) = climb(|j| along.cross(corner(j) - start), from, count);
    EdgeGap::new(edge, (start, along), (support, corner(support)))
}

fn in_order(i: usize, j: usize) -> [usize; 2] {
    if i < j { [i, j] } else { [j, i] }
}

/// Finds a corner of that edge of the difference which is nearest to the origin; or finds that the origin is within the
/// difference.
fn nearest(a: &ConvexPolygon, b: &Placed<'_>) -> Nearest {
    let mut one = Corner::least(a, b, b.pose.apply(b.polygon.center_m()) - a.center_m());
    let mut two = one;
    let mut nearest_m = one.at_m;
    for _ in 0..MOST_GUESSES {
        let new = Corner::least(a, b, nearest_m);
        let squared_m2 = nearest_m.length_squared();
        if squared_m2 - nearest_m.dot(new.at_m) <= NEAR_ENOUGH * squared_m2 {
            return if squared_m2 > 0.0 { Nearest::Outside(one) } else { Nearest::Unsure };
        }
        if is_within([one.at_m, two.at_m, new.at_m]) {
            return Nearest::Within;
        }
        let (share, at_m) = nearest_of_line(one.at_m, new.at_m);
        let (other_share, other_m) = nearest_of_line(two.at_m, new.at_m);
        let nearer = at_m.length_squared() <= other_m.length_squared();
        let (from, share, at_m) =
            if nearer { (one, share, at_m) } else { (two, other_share, other_m) };
        // The guess is no nearer than the last one: the rest is rounding.
        if at_m.length_squared() >= squared_m2 {
            return Nearest::Outside(one);
        }
        (one, two) = if share > 0.5 { (new, from) } else { (from, new) };
        if share >= 1.0 {
            two = new;
        }
        nearest_m = at_m;
    }
    Nearest::Unsure
}

/// Returns true if the origin is in the triangle. A triangle without area contains no point.
#[inline]
fn is_within([p, q, r]: [Vec2; 3]) -> bool {
    let sides = [p.cross(q), q.cross(r), r.cross(p)];
    sides.iter().all(|&side| side > 0.0) || sides.iter().all(|&side| side < 0.0)
}

/// The point of a line segment nearest to the origin, and how far along the segment it is: 0 at the start, 1 at the
/// end.
#[inline]
fn nearest_of_line(start: Vec2, end: Vec2) -> (f64, Vec2) {
    let along = end - start;
    let (way, whole) = (-start.dot(along), along.length_squared());
    if way <= 0.0 {
        (0.0, start)
    } else if way >= whole {
        (1.0, end)
    } else {
        let share = way / whole;
        (share, start + along * share)
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::*;
    use crate::geometry::axis::best_axis;
    use crate::maths::number::greater;
    use crate::maths::vec2::{Pose, Rotation, vec2};

    /// Numbers from 0 to 1 in a fixed order (Knuth's multiplicative congruential generator).
    struct Numbers(u64);

    impl Numbers {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (self.0 >> 11) as f64 / (1u64 << 53) as f64
        }

        fn between(&mut self, low: f64, high: f64) -> f64 {
            low + (high - low) * self.next()
        }

        /// Corners on an ellipse, from slender to round.
        fn polygon(&mut self, count: usize) -> ConvexPolygon {
            let (length_m, aspect) = (self.between(1.0, 150.0), self.between(0.05, 1.0));
            let turn = Rotation::from_angle(self.between(0.0, 6.0));
            let corners: Vec<Vec2> = (0..count)
                .map(|k| {
                    let at = (k as f64 + 0.6 * self.next()) * core::f64::consts::TAU / count as f64;
                    let on_circle = Rotation::from_angle(at).apply(vec2(1.0, 0.0));
                    turn.apply(vec2(length_m * on_circle.x, length_m * aspect * on_circle.y))
                })
                .collect();
            ConvexPolygon::new(&corners)
        }
    }

    #[test]
    fn the_farthest_corner_is_that_of_a_search_of_all() {
        let mut numbers = Numbers(7);
        for round in 0..4_000 {
            let polygon = numbers.polygon(3 + round % 97);
            let direction = Rotation::from_angle(numbers.between(0.0, 6.3)).apply(vec2(1.0, 0.0));
            let most = polygon.vertices().iter().map(|v| v.dot(direction)).fold(f64::MIN, greater);
            let found = polygon.corner(polygon.farthest(direction)).dot(direction);
            assert!(most - found <= 1e-13 * polygon.radius_m(), "{found} is not {most}");
        }
    }

    #[test]
    fn directions_along_the_axes_and_along_edges_find_a_farthest_corner() {
        let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let polygon = ConvexPolygon::new(&square.map(|(x, y)| vec2(x, y)));
        for (x, y) in [(1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            let found = polygon.corner(polygon.farthest(vec2(x, y)));
            assert_eq!(found.dot(vec2(x, y)), greater(vec2(x, y).dot(vec2(x, y)), 1.0));
        }
    }

    /// Pairs of polygons with gaps of 1 µm to 100 m, and overlapping pairs.
    #[test]
    fn the_axis_is_that_of_a_search_of_all_edges() {
        let mut numbers = Numbers(11);
        let (mut apart, mut overlapping) = (0, 0);
        for round in 0..20_000 {
            let (a, b) = (numbers.polygon(3 + round % 61), numbers.polygon(3 + round % 47));
            let heading_rad = numbers.between(0.0, 6.3);
            let bearing = Rotation::from_angle(numbers.between(0.0, 6.3)).apply(vec2(1.0, 0.0));
            let turned = Pose::new(vec2(0.0, 0.0), heading_rad);
            let reach_m = |p: &ConvexPolygon, pose: Pose, d: Vec2| {
                p.vertices().iter().map(|&v| pose.apply(v).dot(d)).fold(f64::MIN, greater)
            };
            // The polygons touch along the bearing, are shifted sideways, and are this far apart along the bearing.
            let touching_m = reach_m(&a, Pose::IDENTITY, bearing) + reach_m(&b, turned, -bearing);
            let gap_m = numbers.between(-1.0, 1.0) * libm::pow(10.0, numbers.between(-6.0, 2.0));
            let aside_m = bearing.quarter_turn() * numbers.between(-50.0, 50.0);
            let place_m = bearing * (touching_m + gap_m) + aside_m;
            let placed = Placed { polygon: &b, pose: Pose::new(place_m, heading_rad) };
            let closed: Vec<Vec2> = (0..=b.count()).map(|k| placed.vertex(k)).collect();
            let all = best_axis(&a, &closed);
            match find(&a, &placed) {
                None => {
                    assert!(all.gap_m < 2.0 * LEAST_GAP_M, "missed {all:?} in round {round}")
                }
                Some(found) => {
                    let rounding_m = 1e-12 * (a.radius_m() + b.radius_m());
                    let short_m = all.gap_m - found.gap_m;
                    assert!(short_m.abs() <= rounding_m, "{found:?} is not {all:?}");
                }
            }
            apart += u32::from(all.gap_m > 0.0);
            overlapping += u32::from(all.gap_m < 0.0);
        }
        assert!(apart > 10_000 && overlapping > 1_000, "{apart} {overlapping}");
    }

    /// Parallel sides, sides in line, and corners opposite corners.
    #[test]
    fn boxes_side_by_side_have_the_axis_of_a_search_of_all_edges() {
        let square = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let polygon = ConvexPolygon::new(&square.map(|(x, y)| vec2(x, y)));
        for heading in 0..8 {
            for (x, y) in (-12..=12).flat_map(|x| (-12..=12).map(move |y| (x, y))) {
                let place_m = vec2(0.25 * f64::from(x), 0.25 * f64::from(y));
                let pose = Pose::new(place_m, f64::from(heading) * core::f64::consts::FRAC_PI_4);
                let placed = Placed { polygon: &polygon, pose };
                let closed: Vec<Vec2> = (0..=4).map(|k| placed.vertex(k)).collect();
                let all = best_axis(&polygon, &closed);
                match find(&polygon, &placed) {
                    None => {
                        assert!(all.gap_m < 2.0 * LEAST_GAP_M, "missed {all:?} at {pose:?}")
                    }
                    Some(found) => {
                        assert!((all.gap_m - found.gap_m).abs() <= 1e-14, "{found:?}, {all:?}");
                    }
                }
            }
        }
    }
}
