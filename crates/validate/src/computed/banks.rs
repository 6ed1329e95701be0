//! Computes the pull of a wall on a ship that goes along it, from the flow of her mirror image.

use fenderline_contact::{Pose, Vec2, vec2};
use fenderline_sim::passing::{PassingShip, Sections, force_of_wall};

use super::Values;

const LENGTH_M: f64 = 200.0;
const AREA_M2: f64 = 300.0;

/// Computes the side force Y on a ship with parabolic sections, divided by ρu²S²/L².
///
/// # Panics
/// Panics if the sections of the ship are out of range, which would be a bug.
pub(super) fn compute(values: &mut Values) {
    let sections = Sections::parabola(LENGTH_M, AREA_M2).expect("a good ship");
    let own = PassingShip {
        sections: &sections,
        pose: Pose::new(Vec2::ZERO, 0.0),
        velocity_mps: vec2(1.0, 0.0),
    };
    for (depth_m, depth) in [(None, "deep"), (Some(20.0), "20"), (Some(13.0), "13")] {
        for wall_m in [20.0, 30.0, 45.0, 60.0, 90.0] {
            let wall = [vec2(-500.0, wall_m), vec2(500.0, wall_m)];
            let [_, pull, _] = force_of_wall(&own, wall, 1.0, depth_m, 1.0);
            let unit = AREA_M2 * AREA_M2 / (LENGTH_M * LENGTH_M);
            values.put(format!("bank/{depth}/{wall_m}"), pull / unit, "");
        }
    }
}
