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
    let at_rest = PassingShip { sections: at_rest, pose, velocity_mps: Vec2::ZERO };
    force_under_way(&at_rest, passing, density_kgpm3, closest_m)
}

/// As [`force`], on a ship that goes ahead or astern herself, at U₁ along her axis; both velocities are through the water.
///
/// The water of the other ship's flow has the velocity (u, v) at a section of area S. Her displaced water feels the acceleration that
/// a place at rest sees, ρS ∂(u, v)/∂t. Across her axis her added mass, ρS for the slender half circle, has the momentum ρSv, which
/// changes as she sees it: ρS (∂v/∂t)₁ − U₁ ∂(ρSv)/∂x, where ( )₁ is the change at a place that moves with her (Lighthill's momentum
/// of slender bodies, recalled). Over her length the last term leaves no force and the moment U₁ ∫ρSv dx. Derived by this project; without
/// speed of her own it is Wang's flow, and for two ships abreast of each other at one speed the forces are equal and opposite, as those
/// between rows of sources must be. There is no lift: neither hull sheds a wake.
#[must_use]
pub fn force_under_way(
    own: &PassingShip<'_>,
    other: &PassingShip<'_>,
    density_kgpm3: f64,
    closest_m: f64,
) -> [f64; 3] {
    // All in the axes of the ship that is pushed.
    let relative = own.pose.to(other.pose);
    let [own_mps, velocity_mps] =
        [own, other].map(|ship| own.pose.rotation.apply_inverse(ship.velocity_mps));
    let own_mps = vec2(own_mps.x, 0.0);
    let ahead = relative.rotation.apply(vec2(1.0, 0.0));
    // Where her area grows forward, she draws water in as she goes ahead; the image above the surface doubles it.
    let strength_mps = -velocity_mps.dot(ahead) / TAU;
    let mut wrench = [0.0; 3];
    for panel in &own.sections.panels {
        let (mut at_rest, mut with_her, mut across) = (Vec2::ZERO, 0.0, 0.0);
        for change in &other.sections.changes {
            let from = vec2(panel.x_m, 0.0) - relative.apply(vec2(change.x_m, 0.0));
            let seen = Seen::of(from, closest_m);
            at_rest += seen.change(velocity_mps) * change.area_m2;
            with_her += seen.change(velocity_mps - own_mps).y * change.area_m2;
            across += seen.per_r3 * from.y * change.area_m2;
        }
        let unit = density_kgpm3 * panel.volume_m3 * strength_mps;
        let across_n = unit * (at_rest.y + with_her);
        wrench[0] += unit * at_rest.x;
        wrench[1] += across_n;
        wrench[2] += panel.x_m * across_n + own_mps.x * unit * across;
    }
    wrench
}

/// A source, seen from a place.
struct Seen {
    /// From the source to the place (m).
    from_m: Vec2,
    r2_m2: f64,
    per_r3: f64,
}

impl Seen {
    fn of(from_m: Vec2, closest_m: f64) -> Seen {
        let r2_m2 = greater(from_m.length_squared(), closest_m * closest_m);
        Seen { from_m, r2_m2, per_r3: 1.0 / (r2_m2 * libm::sqrt(r2_m2)) }
    }

    /// How fast d/r³ changes in the place if the source moves past it: d is from the source to the place.
    fn change(&self, velocity_mps: Vec2) -> Vec2 {
        let along = 3.0 * self.from_m.dot(velocity_mps) / self.r2_m2;
        (self.from_m * along - velocity_mps) * self.per_r3
    }
}
