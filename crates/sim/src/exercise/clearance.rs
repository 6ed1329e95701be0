//! Computes the distance between two outlines at their positions.

use fenderline_contact::{Outline, Pose, Vec2};

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
    let placed = |of: &Outline, at: Pose| -> Vec<Vec2> {
        of.vertices().iter().map(|&vertex| at.apply(vertex)).collect()
    };
    of_outlines_m(&placed(one, one_at), &placed(other, other_at))
}
