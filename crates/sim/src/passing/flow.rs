//! The flow of a passing ship, and its force on a ship at rest.

use core::f64::consts::TAU;

use fenderline_contact::number::greater;
use fenderline_contact::{Pose, Vec2, vec2};

use super::sections::Sections;

/// A ship that passes.
#[derive(Clone, Copy, Debug)]
pub struct PassingShip<'s> {
    /// Her sections.
    pub sections: &'s Sections,
    /// Where she is; the origin is that of her sections.
    pub pose: Pose,
    /// Her velocity over the water, north and east (m/s).
    pub velocity_mps: Vec2,
}

/// Force and moment [X, Y, N] of a passing ship on a ship at rest, in the axes of the latter and about the origin of her sections:
/// forward, to starboard, clockwise from above (N, N, N·m). Deep, open water; [`super::factors`] are for shallow water and quays.
///
/// `closest_m` is the least distance that any two points of the axes are taken to have, such as the mean of the two beams: nearer than
/// that the hulls would overlap, and the force stays that of the distance.
///
/// Of the acceleration of the water only the part that the speed of the passing ship makes is taken, not that of a change of her speed.
#[must_use]
pub fn force(
    at_rest: &Sections,
    pose: Pose,
    passing: &PassingShip<'_>,
    density_kgpm3: f64,
    closest_m: f64,
) -> [f64; 3] {
    // All in the axes of the ship at rest.
    let relative = pose.to(passing.pose);
    let velocity_mps = pose.rotation.apply_inverse(passing.velocity_mps);
    let ahead = relative.rotation.apply(vec2(1.0, 0.0));
    // Where her area grows forward, she draws water in as she goes ahead; the image above the surface doubles it.
    let strength_mps = -velocity_mps.dot(ahead) / TAU;
    let mut wrench = [0.0; 3];
    for panel in &at_rest.panels {
        let mut acceleration = Vec2::ZERO;
        for change in &passing.sections.changes {
            let from = vec2(panel.x_m, 0.0) - relative.apply(vec2(change.x_m, 0.0));
            acceleration += spread(from, velocity_mps, closest_m) * change.area_m2;
        }
        let mass_kg = density_kgpm3 * panel.volume_m3;
        let along_n = mass_kg * strength_mps * acceleration.x;
        let across_n = 2.0 * mass_kg * strength_mps * acceleration.y;
        wrench[0] += along_n;
        wrench[1] += across_n;
        wrench[2] += panel.x_m * across_n;
    }
    wrench
}

/// How fast d/r³ changes in a place where the source moves: d is from the source to the place.
fn spread(from_source_m: Vec2, velocity_mps: Vec2, closest_m: f64) -> Vec2 {
    let r2 = greater(from_source_m.length_squared(), closest_m * closest_m);
    let r3 = r2 * libm::sqrt(r2);
    (from_source_m * (3.0 * from_source_m.dot(velocity_mps) / r2) - velocity_mps) * (1.0 / r3)
}
