//! Computes the distance between two outlines at their positions.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{Outline, Pose, Vec2, vec2};

use fenderline_ship::distance::of_outlines_m;

/// The least distance between two outlines at their positions (m); 0 if they overlap. `nearer_m` is a distance that is
/// already known: larger distances need not be computed exactly.
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
    let placed = |of: &[Vec2], at: Pose| -> Vec<Vec2> {
        of.iter().map(|&vertex| at.apply(vertex)).collect()
    };
    let own = placed(one.vertices(), one_at);
    // The parts of a shore are many, and most of them are far.
    let (here_m, reach_m) = (other_at.apply_inverse(one_at.apply(Vec2::ZERO)), one.radius_m());
    other.polygons().fold(f64::INFINITY, |least_m, part| {
        let bound_m = lesser(least_m, nearer_m);
        if other.is_of_parts() && far_m(part, here_m) - reach_m >= bound_m {
            return lesser(least_m, far_m(part, here_m) - reach_m);
        }
        lesser(least_m, of_outlines_m(&own, &placed(part, other_at)))
    })
}

/// A lower bound of the distance of a point from a polygon: the distance from the upright box around the polygon (m).
fn far_m(part: &[Vec2], point: Vec2) -> f64 {
    let (mut low, mut high) = (part[0], part[0]);
    for corner in part {
        low = vec2(lesser(low.x, corner.x), lesser(low.y, corner.y));
        high = vec2(greater(high.x, corner.x), greater(high.y, corner.y));
    }
    let off = |at: f64, low: f64, high: f64| greater(greater(low - at, at - high), 0.0);
    vec2(off(point.x, low.x, high.x), off(point.y, low.y, high.y)).length()
}
