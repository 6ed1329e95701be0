//! The distance between two outlines.

use fenderline_contact::number::{bounded, lesser};
use fenderline_contact::{Outline, Pose, Vec2};

/// The least distance between two outlines in their places (m); 0 where they overlap. `nearer_m` is a distance that is known
/// already: what is farther need not be found exactly.
pub(super) fn distance_m(
    (one, one_at): (&Outline, Pose),
    (other, other_at): (&Outline, Pose),
    nearer_m: f64,
) -> f64 {
    let apart_m = (one_at.apply(Vec2::ZERO) - other_at.apply(Vec2::ZERO)).length();
    let at_least_m = apart_m - one.radius_m() - other.radius_m();
    if at_least_m >= nearer_m {
        return at_least_m;
    }
    let placed = |of: &Outline, at: Pose| -> Vec<Vec2> {
        of.vertices().iter().map(|&vertex| at.apply(vertex)).collect()
    };
    let (a, b) = (placed(one, one_at), placed(other, other_at));
    if is_inside(a[0], &b) || is_inside(b[0], &a) {
        return 0.0;
    }
    let mut least_m = f64::INFINITY;
    for edge in edges(&a) {
        for across in edges(&b) {
            if meet(edge, across) {
                return 0.0;
            }
            for (point, of) in [(edge[0], across), (across[0], edge)] {
                least_m = lesser(least_m, to_edge_m(point, of));
            }
        }
    }
    least_m
}

fn edges(of: &[Vec2]) -> impl Iterator<Item = [Vec2; 2]> {
    (0..of.len()).map(|from| [of[from], of[(from + 1) % of.len()]])
}

fn to_edge_m(point: Vec2, [from, to]: [Vec2; 2]) -> f64 {
    let along = to - from;
    let share = bounded((point - from).dot(along) / along.dot(along), 0.0, 1.0);
    (point - (from + along * share)).length()
}

/// True if two edges cross.
fn meet([a, b]: [Vec2; 2], [c, d]: [Vec2; 2]) -> bool {
    let side = |p: Vec2, q: Vec2, r: Vec2| (q - p).cross(r - p) > 0.0;
    side(a, b, c) != side(a, b, d) && side(c, d, a) != side(c, d, b)
}

/// True if a point is inside: a ray from it crosses an odd number of edges.
fn is_inside(point: Vec2, of: &[Vec2]) -> bool {
    let crosses = |[from, to]: [Vec2; 2]| {
        (from.y > point.y) != (to.y > point.y)
            && point.x < from.x + (to.x - from.x) * (point.y - from.y) / (to.y - from.y)
    };
    edges(of).filter(|&edge| crosses(edge)).count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

    use super::*;

    fn square(half_m: f64) -> Outline {
        let corners = [
            vec2(-half_m, -half_m),
            vec2(half_m, -half_m),
            vec2(half_m, half_m),
            vec2(-half_m, half_m),
        ];
        Outline::new(&corners).expect("a square").0
    }

    fn between(at: Vec2, heading_rad: f64) -> f64 {
        let (one, other) = (square(2.0), square(1.0));
        let origin = Pose::new(Vec2::ZERO, 0.0);
        distance_m((&one, origin), (&other, Pose::new(at, heading_rad)), f64::INFINITY)
    }

    #[test]
    fn the_distance_of_two_squares_is_that_of_faces_corners_or_none() {
        for (at, heading_rad, expected_m) in [
            (vec2(10.0, 0.5), 0.0, 7.0),
            (vec2(6.0, 7.0), 0.0, 5.0),
            // A corner of the turned one towards the face.
            (vec2(0.0, 8.0), core::f64::consts::FRAC_PI_4, 6.0 - core::f64::consts::SQRT_2),
            (vec2(2.5, 0.0), 0.0, 0.0),
            (vec2(0.3, 0.2), 0.1, 0.0),
            // Crossed without a corner of either inside the other.
            (vec2(2.2, 0.0), core::f64::consts::FRAC_PI_4, 0.0),
        ] {
            let found_m = between(at, heading_rad);
            assert!((found_m - expected_m).abs() < 1e-12, "{at:?}: {found_m}, not {expected_m}");
        }
    }
}
