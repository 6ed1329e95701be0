//! The normal law (§3.2 of the paper, eq. 2–3): spring, stop and damper.

use crate::broad::candidates::Candidate;
use crate::maths::number::greater;
use crate::maths::vec2::Pose;
use crate::model::Model;
use crate::model::fender::RankedFender;
use crate::model::material::Material;
use crate::overlap::patch::Patch;
use crate::state::memory::PatchMemory;
use crate::state::report::ForceParts;
use crate::touch::Touch;

/// The normal force before the momentum limit (N): N = max(0, spring + stop + damper). The damper's part cṠ of the
/// normal force comes from the growth of the overlap.
///
/// Eq. 2–3 of the paper print the normal force as −(kS − c dS/dt). With c > 0, the damper as printed pulls the bodies
/// together and makes a body leave faster than it came. The normal force is at least 0 because a contact does not pull.
#[inline]
pub(crate) fn normal_force(touch: &Touch, factor: f64, damper_n: f64) -> ForceParts {
    let (spring_n, stop_n) = (touch.spring_n * factor, touch.stop_n * factor);
    let damper_n = greater(damper_n, -(spring_n + stop_n));
    ForceParts { spring_n, stop_n, damper_n, limiter_n: 0.0 }
}

/// The damper's force cṠ in the paper's method (N), by a backward difference: Ṡ = (S − S_before)/(time since S_before).
/// For a new contact the area S_before is 0.
#[inline]
pub(crate) fn damper_n(
    material: &Material,
    area_m2: f64,
    area_before_m2: f64,
    elapsed_s: f64,
) -> f64 {
    material.damping_nspm2 * ((area_m2 - area_before_m2) / elapsed_s)
}

/// The factor on a contact's spring and stop: the fender's factor at the speed and angle at which the contact began.
#[inline]
pub(crate) fn factor(
    model: &Model,
    face: Option<&RankedFender>,
    touch: &Touch,
    patch: &Patch,
    old: Option<&PatchMemory>,
) -> f64 {
    match (face, old) {
        (None, _) => 1.0,
        (Some(_), Some(memory)) => memory.factor,
        (Some(face), None) => {
            let fender = &model.fenders()[face.id.0 as usize];
            let speed_mps = greater(touch.v_normal_mps, 0.0);
            let angle_rad = angle_rad(model, face, touch, patch);
            fender.factors.at(speed_mps, angle_rad, fender.rated_deflection_m)
        }
    }
}

/// The angle between a fender's face and the hull's side in space (rad). This angle in space combines the tilt in the
/// plane with the slope of the hull's side, which outlines by height give: tan² of the angle is the sum of tan² of the
/// tilt and tan² of the slope.
#[cold]
#[inline(never)]
fn angle_rad(model: &Model, face: &RankedFender, touch: &Touch, patch: &Patch) -> f64 {
    if model.slices.is_empty() {
        return touch.tilt_rad;
    }
    let Candidate { a, b, face: number, .. } = patch.candidate;
    let (rank, hull, host) = match face.host == a {
        true => (b, patch.b_in_a, Pose::IDENTITY),
        false => (a, Pose::IDENTITY, patch.b_in_a),
    };
    match model.side_met(face, number, rank, hull, host) {
        None => touch.tilt_rad,
        Some(side) => combined_angle_rad(touch.tilt_rad, side.slope),
    }
}

/// The angle in space (rad) of a hull's side that is turned by `tilt_rad` in the plane and leans out with the slope
/// `slope`.
#[must_use]
pub fn combined_angle_rad(tilt_rad: f64, slope: f64) -> f64 {
    if slope == 0.0 {
        return tilt_rad;
    }
    let across = libm::tan(tilt_rad);
    libm::atan(libm::sqrt(across * across + slope * slope))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn force_n(area_m2: f64, area_before_m2: f64, factor: f64) -> f64 {
        let material = Material {
            stiffness_npm2: 100.0,
            damping_nspm2: 10.0,
            shear_stiffness_npm: 0.0,
            friction_static: 0.0,
            friction_dynamic: 0.0,
            restitution: 0.0,
        };
        let touch = Touch { spring_n: 100.0 * area_m2, ..Touch::default() };
        let damper_n = damper_n(&material, area_m2, area_before_m2, 0.5);
        normal_force(&touch, factor, damper_n).total_n()
    }

    #[test]
    fn the_damper_pushes_apart_while_the_overlap_grows_and_never_pulls() {
        assert_eq!(force_n(2.0, 1.0, 1.0), 220.0);
        assert_eq!(force_n(1.0, 2.0, 1.0), 80.0);
        assert_eq!(force_n(0.1, 2.0, 1.0), 0.0);
        assert_eq!(force_n(2.0, 2.0, 1.5), 300.0);
    }
}
