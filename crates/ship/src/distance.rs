//! Distances in the plane, of points, segments and outlines.

use fenderline_contact::Vec2;
use fenderline_contact::number::{bounded, lesser};

/// Distance from a point to the nearest point of a segment (m). The segment must be longer than 0.
#[must_use]
pub fn to_segment_m(point: Vec2, [from, to]: [Vec2; 2]) -> f64 {
    let along = to - from;
    let share = bounded((point - from).dot(along) / along.length_squared(), 0.0, 1.0);
    (point - from - along * share).length()
}

/// The point of a segment that is nearest to a given point. The segment must be longer than 0.
fn on_segment(point: Vec2, [from, to]: [Vec2; 2]) -> Vec2 {
    let along = to - from;
    from + along * bounded((point - from).dot(along) / along.length_squared(), 0.0, 1.0)
}

/// The shortest distance between two segments (m); 0 if they cross.
pub fn of_segments_m(one: [Vec2; 2], other: [Vec2; 2]) -> f64 {
    if cross(one, other) {
        return 0.0;
    }
    let ends = [(one[0], other), (one[1], other), (other[0], one), (other[1], one)];
    ends.into_iter().fold(f64::INFINITY, |least, (end, of)| lesser(least, to_segment_m(end, of)))
}

/// Distance from a point, which may be inside, to the nearest edge of an outline (m).
#[must_use]
pub fn to_edge_m(point: Vec2, outline: &[Vec2]) -> f64 {
    edges(outline).fold(f64::INFINITY, |least, edge| lesser(least, to_segment_m(point, edge)))
}

/// The shortest distance between two simple outlines (m); 0 if they overlap.
///
/// # Panics
/// Panics if one of the outlines has no corners.
#[must_use]
pub fn of_outlines_m(one: &[Vec2], other: &[Vec2]) -> f64 {
    if contains(one, other[0]) || contains(other, one[0]) {
        return 0.0;
    }
    let mut least_m = f64::INFINITY;
    for edge in edges(one) {
        for across in edges(other) {
            if cross(edge, across) {
                return 0.0;
            }
            // Each corner begins one edge.
            for (corner, of) in [(edge[0], across), (across[0], edge)] {
                least_m = lesser(least_m, to_segment_m(corner, of));
            }
        }
    }
    least_m
}

/// The nearest points of two simple outlines that lie clear of each other: first the point on the first outline, then
/// the point on the second.
#[must_use]
pub fn nearest_points(one: &[Vec2], other: &[Vec2]) -> [Vec2; 2] {
    let (mut least_m, mut nearest) = (f64::INFINITY, [Vec2::ZERO; 2]);
    for edge in edges(one) {
        for across in edges(other) {
            // Each corner begins one edge.
            for points in
                [[edge[0], on_segment(edge[0], across)], [on_segment(across[0], edge), across[0]]]
            {
                let apart_m = (points[1] - points[0]).length();
                if apart_m < least_m {
                    (least_m, nearest) = (apart_m, points);
                }
            }
        }
    }
    nearest
}

fn edges(of: &[Vec2]) -> impl Iterator<Item = [Vec2; 2]> {
    (0..of.len()).map(|from| [of[from], of[(from + 1) % of.len()]])
}

/// True if two segments cross. If an end of one segment lies on the other segment, the distance of this end is 0, so
/// that this case need not count as a crossing.
fn cross(one: [Vec2; 2], other: [Vec2; 2]) -> bool {
    let side = |ends: [Vec2; 2], point: Vec2| (ends[1] - ends[0]).cross(point - ends[0]);
    let splits = |ends: [Vec2; 2], of: [Vec2; 2]| side(ends, of[0]) * side(ends, of[1]) < 0.0;
    splits(one, other) && splits(other, one)
}

/// True if a point is inside an outline, because a ray from the point then crosses an odd number of edges.
#[must_use]
pub fn contains(outline: &[Vec2], point: Vec2) -> bool {
    let crosses = |[from, to]: [Vec2; 2]| {
        (from.y > point.y) != (to.y > point.y)
            && point.x < from.x + (to.x - from.x) * (point.y - from.y) / (to.y - from.y)
    };
    edges(outline).filter(|&edge| crosses(edge)).count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_4, SQRT_2};

    use fenderline_contact::{Pose, vec2};

    use super::*;

    fn square(half_m: f64) -> [Vec2; 4] {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| vec2(x, y) * half_m)
    }

    #[test]
    fn the_distance_of_segments_is_that_of_their_nearest_points() {
        let along = [vec2(0.0, 0.0), vec2(10.0, 0.0)];
        for (other, distance_m) in [
            ([vec2(5.0, 3.0), vec2(5.0, 9.0)], 3.0),
            ([vec2(5.0, -3.0), vec2(5.0, 9.0)], 0.0),
            ([vec2(13.0, 4.0), vec2(20.0, 4.0)], 5.0),
            ([vec2(-5.0, 2.0), vec2(20.0, 2.0)], 2.0),
        ] {
            assert!((of_segments_m(along, other) - distance_m).abs() < 1e-12);
            assert!((of_segments_m(other, along) - distance_m).abs() < 1e-12);
        }
    }

    #[test]
    fn the_distance_of_two_squares_is_that_of_faces_corners_or_none() {
        for (at, heading_rad, expected_m) in [
            (vec2(10.0, 0.5), 0.0, 7.0),
            (vec2(6.0, 7.0), 0.0, 5.0),
            // A corner of the turned outline points towards the face.
            (vec2(0.0, 8.0), FRAC_PI_4, 6.0 - SQRT_2),
            (vec2(2.5, 0.0), 0.0, 0.0),
            (vec2(0.3, 0.2), 0.1, 0.0),
            // The outlines cross, but neither has a corner inside the other.
            (vec2(2.2, 0.0), FRAC_PI_4, 0.0),
        ] {
            let turned = square(1.0).map(|corner| Pose::new(at, heading_rad).apply(corner));
            for found_m in
                [of_outlines_m(&square(2.0), &turned), of_outlines_m(&turned, &square(2.0))]
            {
                assert!((found_m - expected_m).abs() < 1e-12, "{at:?}: {found_m}");
            }
            if expected_m > 0.0 {
                let [from, to] = nearest_points(&square(2.0), &turned);
                assert!(((to - from).length() - expected_m).abs() < 1e-12, "{from:?} {to:?}");
                assert!(to_edge_m(from, &square(2.0)) < 1e-12 && to_edge_m(to, &turned) < 1e-12);
            }
        }
    }

    #[test]
    fn the_distance_of_a_point_is_that_of_the_nearest_edge() {
        for (point, distance_m) in
            [(vec2(5.0, -12.0), 7.0), (vec2(8.0, 9.0), 5.0), (vec2(0.0, 4.0), 1.0)]
        {
            assert!((to_edge_m(point, &square(5.0)) - distance_m).abs() < 1e-12, "{point:?}");
        }
    }
}
