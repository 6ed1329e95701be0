//! The limiter of the paper's method: limits each contact by itself, from momentum and impulse (§3.4, eq. 9–26).
//!
//! The limiter knows neither the other contacts of a body nor external loads. So with the paper's limiter several
//! fenders together rebound by more than the restitution γ, and a body under steady load creeps into the contact. This
//! limiter follows the paper's method without any change.

use super::effective_mass::InverseMass;
use crate::maths::number::{greater, lesser};

/// Relative velocities of the bodies at the contact, in this step and when the contact began (m/s).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Velocities {
    pub(crate) normal_mps: f64,
    pub(crate) tangential_mps: f64,
    pub(crate) normal_0_mps: f64,
    pub(crate) tangential_0_mps: f64,
}

/// The normal force that momentum allows in one step (N), so that V_n⁺ ≥ −γ V_n⁰ (eq. 26, first line).
///
/// The limit of the normal force is N ≤ max(0, V_n + γ max(V_n⁰, 0)) E_x/Δt. Eq. 11 and 26 of the paper print V − γV⁰.
/// With the printed sign the bodies would still approach at γV⁰ when the contact ends.
#[inline]
pub(crate) fn limited_normal_n(
    normal_n: f64,
    v: &Velocities,
    mass: &InverseMass,
    restitution: f64,
    step_s: f64,
) -> f64 {
    let change_mps = v.normal_mps + restitution * greater(v.normal_0_mps, 0.0);
    within(normal_n, greater(change_mps, 0.0), mass.normal * step_s)
}

/// The tangential force that momentum allows in one step (N) (eq. 26, second line; the printed J must be L).
///
/// With the contact force F₁ = −N n + T t, the tangential speed after the step is V_t⁺ = V_t + Δt (T/E_y − K_tn N). The
/// tangential force T may not carry the tangential speed V_t beyond −γ V_t⁰, nor beyond its present value: V_t⁺ stays
/// within [min(V_t, −γ|V_t⁰|), max(V_t, γ|V_t⁰|)]. The limiter can only make the tangential force T smaller.
#[inline]
pub(crate) fn limited_tangential_n(
    tangential_n: f64,
    normal_n: f64,
    v: &Velocities,
    mass: &InverseMass,
    restitution: f64,
    step_s: f64,
) -> f64 {
    let rebound_mps = restitution * v.tangential_0_mps.abs();
    let lowest = lesser(v.tangential_mps, -rebound_mps);
    let highest = greater(v.tangential_mps, rebound_mps);
    let without = v.tangential_mps - step_s * mass.cross * normal_n;
    let mps_per_n = mass.tangential * step_s;
    if tangential_n > 0.0 {
        greater(within(tangential_n, highest - without, mps_per_n), 0.0)
    } else if tangential_n < 0.0 {
        -greater(within(-tangential_n, without - lowest, mps_per_n), 0.0)
    } else {
        tangential_n
    }
}

/// Returns the force, or a smaller force that just changes the velocity by `change_mps`. Most forces need no limit,
/// which a multiplication shows; only the other forces need a division.
#[inline(always)]
fn within(force_n: f64, change_mps: f64, mps_per_n: f64) -> f64 {
    if force_n * mps_per_n <= change_mps {
        return force_n;
    }
    lesser(force_n, change_mps / mps_per_n)
}

#[cfg(test)]
mod tests {
    use super::*;

    const MASS: InverseMass = InverseMass { normal: 1e-3, tangential: 2e-3, cross: 0.0 };

    fn closing() -> Velocities {
        Velocities {
            normal_mps: 2.0,
            tangential_mps: 1.0,
            normal_0_mps: 2.0,
            tangential_0_mps: 1.0,
        }
    }

    #[test]
    fn one_step_rebounds_at_gamma_times_the_closing_speed() {
        let n = limited_normal_n(1e9, &closing(), &MASS, 0.1, 0.5);
        assert!((2.0 - 0.5 * n * MASS.normal - -0.2).abs() < 1e-12);
    }

    #[test]
    fn a_contact_that_opens_faster_gets_no_force() {
        let leaving = Velocities { normal_mps: -0.3, ..closing() };
        assert_eq!(limited_normal_n(1e9, &leaving, &MASS, 0.1, 0.5), 0.0);
    }

    #[test]
    fn friction_reverses_slip_by_at_most_gamma() {
        let t = limited_tangential_n(-1e9, 0.0, &closing(), &MASS, 0.1, 0.5);
        assert!((1.0 + 0.5 * t * MASS.tangential - -0.1).abs() < 1e-12);
        assert_eq!(limited_tangential_n(-1.0, 0.0, &closing(), &MASS, 0.1, 0.5), -1.0);
    }

    #[test]
    fn a_force_along_the_slip_does_not_accelerate_it() {
        assert_eq!(limited_tangential_n(1e9, 0.0, &closing(), &MASS, 0.1, 0.5), 0.0);
    }
}
