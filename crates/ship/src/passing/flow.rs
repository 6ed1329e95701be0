//! The flow of a passing ship, and its force on a ship at rest.

use core::f64::consts::TAU;

use fenderline_contact::number::greater;
use fenderline_contact::{Pose, Vec2, vec2};

use super::sections::Sections;

/// A ship that passes.
#[derive(Clone, Copy, Debug)]
pub struct PassingShip<'s> {
    /// Sections of the ship.
    pub sections: &'s Sections,
    /// Pose of the ship: position and heading of the point from which the places of her sections are measured.
    pub pose: Pose,
    /// Velocity of the ship through the water, north and east (m/s).
    pub velocity_mps: Vec2,
}

/// Force and moment [X, Y, N] of a passing ship on a ship at rest (N, N, N·m): forward, to starboard, clockwise from
/// above. Force and moment are in the axes of the ship at rest, about the point from which the places of her sections
/// are measured. The formulas for a passing ship are for deep, open water; [`super::factors`] correct for shallow water
/// and quays.
///
/// `closest_m` is the least distance that two points of the ships' axes are taken to have, such as the mean of the two
/// beams. If the axes are nearer than `closest_m`, the hulls would overlap, and the force at `closest_m` is used.
///
/// The computed acceleration of the water contains only the part due to the speed of the passing ship, not the part due
/// to a change of her speed.
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

/// Force as by [`force`], but on a ship that goes ahead or astern herself, at the speed U₁ along her axis. The
/// velocities of both ships are those through the water.
///
/// The flow of the other ship gives the water the velocity (u, v) at a section of area S. The water that this section
/// displaces feels the acceleration at a fixed place, ρS ∂(u, v)/∂t. Across the axis of the ship that feels the force,
/// the added mass of a section (ρS for the slender half circle) has the momentum ρSv. In the frame of the moving ship
/// the momentum ρSv of a section changes by ρS (∂v/∂t)₁ − U₁ ∂(ρSv)/∂x, where ( )₁ is the change at a place that moves
/// with the ship (Lighthill's momentum of slender bodies, from memory). Summed over the ship's length, the term with U₁
/// gives no force, but the moment U₁ ∫ρSv dx. We derived this. With U₁ = 0 the formulas are Wang's. For two ships
/// abreast at one speed the forces on them are equal and opposite, as the forces between rows of sources must be. The
/// flow gives no lift, because neither hull sheds a wake.
#[must_use]
pub fn force_under_way(
    own: &PassingShip<'_>,
    other: &PassingShip<'_>,
    density_kgpm3: f64,
    closest_m: f64,
) -> [f64; 3] {
    force_above_bottom([own, other], density_kgpm3, closest_m, None)
}

/// Force as by [`force_under_way`], but in water of a depth (m; `None`: deep), where every source has images in surface
/// and bottom.
pub(super) fn force_above_bottom(
    [own, other]: [&PassingShip<'_>; 2],
    density_kgpm3: f64,
    closest_m: f64,
    depth_m: Option<f64>,
) -> [f64; 3] {
    // All quantities are in the axes of the ship that is pushed.
    let relative = own.pose.to(other.pose);
    let [own_mps, velocity_mps] =
        [own, other].map(|ship| own.pose.rotation.apply_inverse(ship.velocity_mps));
    let own_mps = vec2(own_mps.x, 0.0);
    let ahead = relative.rotation.apply(vec2(1.0, 0.0));
    // Where the sectional area grows in the direction of the bow, the ship draws water in as she goes ahead. The image
    // above the surface doubles this.
    let strength_mps = -velocity_mps.dot(ahead) / TAU;
    let mut wrench = [0.0; 3];
    for panel in &own.sections.panels {
        let (mut at_rest, mut with_her, mut across) = (Vec2::ZERO, 0.0, 0.0);
        for change in &other.sections.changes {
            let from = vec2(panel.x_m, 0.0) - relative.apply(vec2(change.x_m, 0.0));
            let seen = match depth_m {
                None => Seen::of(from, closest_m),
                Some(depth_m) => Seen::above_bottom(from, closest_m, depth_m),
            };
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

/// Number of images on each side of a source that are summed one by one.
const IMAGES: u32 = 4;

/// A source of the flow, as seen from a place.
struct Seen {
    /// Vector from the source to the place (m).
    from_m: Vec2,
    /// Ratio of Σ1/r³ to Σ1/r⁵ over the source and its images (m²). For a source without images this ratio is r², the
    /// square of the distance.
    r2_m2: f64,
    /// Sum of 1/r³ over the source and its images (1/m³).
    per_r3: f64,
}

impl Seen {
    fn of(from_m: Vec2, closest_m: f64) -> Seen {
        let r2_m2 = greater(from_m.length_squared(), closest_m * closest_m);
        Seen { from_m, r2_m2, per_r3: 1.0 / (r2_m2 * libm::sqrt(r2_m2)) }
    }

    /// Sums over a row of images of the source, which are twice the depth apart. Beyond the first few images, an
    /// integral with the first term of the Euler–Maclaurin formula replaces the sum; the integral begins half way to
    /// the next image. The error of the sum over the images is below 0.01 % of the sum.
    fn above_bottom(from_m: Vec2, closest_m: f64, depth_m: f64) -> Seen {
        let plane_m2 = greater(from_m.length_squared(), closest_m * closest_m);
        let apart_m = 2.0 * depth_m;
        let one = |squared_m2: f64| 1.0 / (squared_m2 * libm::sqrt(squared_m2));
        let mut per_r3 = one(plane_m2);
        let mut per_r5 = per_r3 / plane_m2;
        for image in 1..=IMAGES {
            let down_m = f64::from(image) * apart_m;
            let squared_m2 = plane_m2 + down_m * down_m;
            let per = one(squared_m2);
            per_r3 += 2.0 * per;
            per_r5 += 2.0 * per / squared_m2;
        }
        // ∫dz/(ρ² + z²)^{3/2} and ∫dz/(ρ² + z²)^{5/2} from that place on, on both sides.
        let last_m = (f64::from(IMAGES) + 0.5) * apart_m;
        let far_m2 = plane_m2 + last_m * last_m;
        let per_far3 = one(far_m2);
        let rest = 1.0 - last_m * far_m2 * per_far3;
        let slope = apart_m * last_m * per_far3 / far_m2;
        per_r3 += 2.0 * rest / (plane_m2 * apart_m) - 0.25 * slope;
        per_r5 += 2.0 * (2.0 * rest - last_m * plane_m2 * per_far3)
            / (3.0 * plane_m2 * plane_m2 * apart_m)
            - 5.0 / 12.0 * slope / far_m2;
        Seen { from_m, r2_m2: per_r3 / per_r5, per_r3 }
    }

    /// Rate of change of d/r³ at the place if the source moves past it, where d is the vector from the source to the
    /// place.
    fn change(&self, velocity_mps: Vec2) -> Vec2 {
        let along = 3.0 * self.from_m.dot(velocity_mps) / self.r2_m2;
        (self.from_m * along - velocity_mps) * self.per_r3
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The reference sums four thousand images on each side one by one. The tolerance is 0.01 %.
    #[test]
    fn images_in_the_bottom_are_the_sum_of_all() {
        for plane_m in [3.0, 12.0, 30.0, 90.0, 400.0] {
            let seen = Seen::above_bottom(vec2(plane_m, 0.0), 1.0, 15.0);
            let (mut per_r3, mut per_r5) = (0.0, 0.0);
            for image in -4000..=4000 {
                let down_m = 30.0 * f64::from(image);
                let squared_m2 = plane_m * plane_m + down_m * down_m;
                per_r3 += 1.0 / (squared_m2 * squared_m2.sqrt());
                per_r5 += 1.0 / (squared_m2 * squared_m2 * squared_m2.sqrt());
            }
            assert!((seen.per_r3 / per_r3 - 1.0).abs() < 1e-4, "{plane_m}");
            assert!((seen.r2_m2 * per_r5 / per_r3 - 1.0).abs() < 1e-4, "{plane_m}");
        }
    }
}
