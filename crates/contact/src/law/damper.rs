//! The damper of the normal law with the force cṠ (eq. 2–3 of the paper), in the sub-steps of the coupled method.
//!
//! The force of a sub-step acts over the time κ, from the middle of the last sub-step to the middle of this sub-step.
//! So the damper acts on the growth of the overlap from the middle of the last sub-step to the middle of this sub-step:
//! its force is c(A − A')/κ, where A is the area in the middle of this sub-step and A' the area in the middle of the
//! last sub-step. The impulses of the damper add up to c times the area for any lengths of the sub-steps, and to zero
//! over a whole contact. The growth of the overlap over the last sub-step alone would lag by half a sub-step.

use crate::maths::number::lesser;
use crate::model::material::Material;

/// The overlap area to which the damper has already responded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Answered {
    /// The damper has responded to no area, because the overlap began within the last sub-step.
    Nothing,
    /// The area A' (m²).
    Area(f64),
    /// The present area. The damper counts as having responded to the present area if nothing is known about the growth
    /// of the overlap.
    AllThereIs,
}

/// An overlap at the start of a sub-step, and its growth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Growth {
    /// Area S of the overlap (m²), and the growth of S for each metre by which the bodies approach (m).
    pub(crate) area_m2: f64,
    pub(crate) chord_m: f64,
    /// V_n (m/s).
    pub(crate) closing_mps: f64,
    pub(crate) answered: Answered,
}

/// Returns the damper's force c(A − A')/κ for a sub-step of length h (N), and the area A (m²).
///
/// For an overlap that began within the last sub-step, the damper's force is limited to its force at the present speed.
/// Because of this limit on the damper, the force of a first touch is not larger than the speed of the touch gives. The
/// rest of the damper's force acts in the next sub-step.
pub(crate) fn damper(material: &Material, growth: &Growth, h: f64, kick_s: f64) -> (f64, f64) {
    let Growth { area_m2, chord_m, closing_mps, answered } = *growth;
    let rate_m2ps = chord_m * closing_mps;
    let grown_m2 = area_m2 + 0.5 * h * rate_m2ps;
    let (grows_m2, answered_m2) = match answered {
        Answered::Area(before_m2) => (grown_m2 - before_m2, grown_m2),
        Answered::AllThereIs => (rate_m2ps * kick_s, grown_m2),
        Answered::Nothing => {
            let most_m2 = lesser(grown_m2, rate_m2ps * kick_s);
            (most_m2, most_m2)
        }
    };
    (material.damping_nspm2 * grows_m2 / kick_s, answered_m2)
}

#[cfg(test)]
mod tests {
    use super::*;

    const OIL: Material = Material {
        stiffness_npm2: 0.0,
        damping_nspm2: 10.0,
        shear_stiffness_npm: 0.0,
        friction_static: 0.0,
        friction_dynamic: 0.0,
        restitution: 1.0,
    };

    /// A side 2 m wide penetrates at 0.5 m/s. The first touch is anywhere in the first sub-step.
    #[test]
    fn the_impulse_follows_the_area_for_any_sub_steps() {
        for touched_s in [0.01, 0.05, 0.09] {
            let (mut t, mut before_s, mut impulse_ns) = (touched_s, 0.1, 0.0);
            let mut answered = Answered::Nothing;
            for h in [0.1, 0.1, 0.02, 0.02, 0.5, 0.03] {
                let kick_s = 0.5 * (before_s + h);
                let growth = Growth { area_m2: t, chord_m: 2.0, closing_mps: 0.5, answered };
                let (force_n, answered_m2) = damper(&OIL, &growth, h, kick_s);
                impulse_ns += force_n * kick_s;
                answered = Answered::Area(answered_m2);
                (t, before_s) = (t + h, h);
            }
            let right_ns = 10.0 * (t - 0.5 * before_s);
            assert!((impulse_ns - right_ns).abs() < 1e-12, "{impulse_ns} of {right_ns} N·s");
        }
    }

    #[test]
    fn the_force_at_first_touch_is_bounded_by_the_speed() {
        for area_m2 in [1e-6, 0.05, 0.1] {
            let answered = Answered::Nothing;
            let growth = Growth { area_m2, chord_m: 2.0, closing_mps: 0.5, answered };
            let (force_n, _) = damper(&OIL, &growth, 0.1, 0.1);
            assert!(force_n <= 10.0 + 1e-12, "{force_n} N");
        }
    }
}
