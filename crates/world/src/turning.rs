//! The Coriolis and centripetal wrench (force and moment) of a vessel over a whole step (Kirchhoff's equations).
//!
//! The mass of a vessel with added mass differs between surge and sway, so the momentum turns with the heading. The
//! wrench that represents this turn of the momentum does no work. But a wrench that keeps its value at the start of a
//! step over the whole step does work, and in a steady turn this work always has the same sign. So this module
//! calculates a mean wrench over the step with two properties. The wrench takes the momentum M V of ship and added mass
//! from the heading before the step to the heading after the step. And the wrench does no work on the vessel, so only
//! the other forces change the kinetic energy.
//!
//! The module calculates in the ship's axes at the start of the step. In these axes the ship's mass matrix at the start
//! of the step is constant, and the ship turns by a small angle in the step. The formulas for differences between the
//! two headings use the sine and versine of the angle of the turn, so that no digits cancel.

use fenderline_contact::{BodyState, Rotation, Vec2, Wrench, vec2};

use crate::rigid_body::Inertia;

/// Maximum number of fixed-point iterations. Each iteration reduces the error by a factor of about the angle turned in
/// the step.
const ITERATIONS: u32 = 40;

/// Relative change of force and moment at which the iteration ends: some tens of roundings.
const CONVERGED: f64 = 1e-14;

/// The yaw rate with which the integrator turns the heading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum YawRateAt {
    /// The yaw rate at the start of the step: forward Euler.
    Start,
    /// The yaw rate at the end of the step: the engine's sub-steps.
    End,
}

/// How the integrator takes a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurningStep {
    /// Length of the step (s).
    pub step_s: f64,
    /// Time for which forces change the velocities (s). Normally the time is the whole step. In the first step of the
    /// leapfrog the time is half a step, because that step takes the velocities from the start of the step to its
    /// middle.
    pub acts_s: f64,
    /// The yaw rate that turns the heading.
    pub turned_by: YawRateAt,
}

/// The wrench that turns a vessel's momentum over a step in which `load` acts on the vessel, in a current (m/s).
///
/// If the vessel would turn by more than a radian in the step, the result is the wrench at the start of the step. If
/// the iteration does not converge, the result is the last iterate.
pub fn turning_wrench(
    inertia: &Inertia,
    state: &BodyState,
    load: &Wrench,
    current_mps: Vec2,
    step: &TurningStep,
) -> Wrench {
    let at_start = inertia.momentum_wrench(state, current_mps);
    let attitude = Rotation::from_angle(state.heading_rad);
    let own = |wrench: &Wrench| Wrench {
        force_n: attitude.apply_inverse(wrench.force_n),
        moment_nm: wrench.moment_nm,
    };
    let before = WaterVelocity {
        velocity_mps: attitude.apply_inverse(state.velocity_mps - current_mps),
        yaw_radps: state.yaw_rate_radps,
    };
    let (inverse, load, mut wrench) = (Inverse::of(inertia), own(load), own(&at_start));
    for _ in 0..ITERATIONS {
        let sum = Wrench {
            force_n: load.force_n + wrench.force_n,
            moment_nm: load.moment_nm + wrench.moment_nm,
        };
        let (linear_mps2, yaw_radps2) = inverse.acceleration(&sum);
        let after = WaterVelocity {
            velocity_mps: before.velocity_mps + linear_mps2 * step.acts_s,
            yaw_radps: before.yaw_radps + yaw_radps2 * step.acts_s,
        };
        let turned_rad = step.step_s
            * match step.turned_by {
                YawRateAt::Start => before.yaw_radps,
                YawRateAt::End => after.yaw_radps,
            };
        let is_small = turned_rad.abs() <= 1.0;
        if !is_small {
            return at_start;
        }
        let turn = Turn { before: &before, after: &after, turned_rad };
        let next = turn.wrench(inertia, step);
        let change_n2 = (next.force_n - wrench.force_n).length_squared();
        let has_converged = change_n2 <= CONVERGED * CONVERGED * next.force_n.length_squared()
            && (next.moment_nm - wrench.moment_nm).abs() <= CONVERGED * next.moment_nm.abs();
        wrench = next;
        if has_converged {
            break;
        }
    }
    Wrench { force_n: attitude.apply(wrench.force_n), moment_nm: wrench.moment_nm }
}

/// The inverse of a vessel's mass matrix, in the vessel's axes.
struct Inverse {
    /// Inverse mass in surge (1/kg).
    surge: f64,
    sway: f64,
    /// Coupling of sway and yaw (1/(kg·m)).
    coupling: f64,
    /// Inverse inertia in yaw (1/(kg·m²)).
    yaw: f64,
}

impl Inverse {
    fn of(inertia: &Inertia) -> Inverse {
        let Inertia { surge_kg, sway_kg, yaw_kgm2, coupling_kgm, .. } = *inertia;
        let per_determinant = 1.0 / (sway_kg * yaw_kgm2 - coupling_kgm * coupling_kgm);
        Inverse {
            surge: 1.0 / surge_kg,
            sway: yaw_kgm2 * per_determinant,
            coupling: -coupling_kgm * per_determinant,
            yaw: sway_kg * per_determinant,
        }
    }

    /// Acceleration by a wrench (m/s², rad/s²).
    fn acceleration(&self, wrench: &Wrench) -> (Vec2, f64) {
        let &Wrench { force_n, moment_nm } = wrench;
        let sway_mps2 = self.sway * force_n.y + self.coupling * moment_nm;
        let yaw_radps2 = self.coupling * force_n.y + self.yaw * moment_nm;
        (vec2(self.surge * force_n.x, sway_mps2), yaw_radps2)
    }
}

/// Velocity through the water, in the ship's axes at the start of the step.
struct WaterVelocity {
    velocity_mps: Vec2,
    yaw_radps: f64,
}

impl WaterVelocity {
    fn mean(&self, other: &WaterVelocity) -> WaterVelocity {
        WaterVelocity {
            velocity_mps: (self.velocity_mps + other.velocity_mps) * 0.5,
            yaw_radps: 0.5 * (self.yaw_radps + other.yaw_radps),
        }
    }

    /// The product M V at the start of the step: momentum, and angular momentum about the centre of gravity.
    fn momentum(&self, inertia: &Inertia) -> (Vec2, f64) {
        let Inertia { surge_kg, sway_kg, yaw_kgm2, coupling_kgm, .. } = *inertia;
        let &WaterVelocity { velocity_mps: Vec2 { x, y }, yaw_radps } = self;
        let momentum_ns = vec2(surge_kg * x, sway_kg * y + coupling_kgm * yaw_radps);
        (momentum_ns, coupling_kgm * y + yaw_kgm2 * yaw_radps)
    }

    /// The product (M₁ − M₀) V, where M₁ is the mass matrix of a ship that has turned by an angle with this sine and
    /// versine (1 − cosine).
    fn momentum_by_turn(&self, inertia: &Inertia, sine: f64, versine: f64) -> (Vec2, f64) {
        let Inertia { surge_kg, sway_kg, coupling_kgm, .. } = *inertia;
        let &WaterVelocity { velocity_mps: Vec2 { x, y }, yaw_radps } = self;
        let difference_kg = sway_kg - surge_kg;
        let (along, across) = (difference_kg * sine * sine, difference_kg * sine * (1.0 - versine));
        let coupled_ns = coupling_kgm * yaw_radps;
        let momentum_ns = vec2(
            along * x - across * y - coupled_ns * sine,
            -across * x - along * y - coupled_ns * versine,
        );
        (momentum_ns, -coupling_kgm * (sine * x + versine * y))
    }

    /// The scalar product V·P with a momentum P.
    fn dot(&self, (momentum_ns, yaw_nms): (Vec2, f64)) -> f64 {
        self.velocity_mps.dot(momentum_ns) + self.yaw_radps * yaw_nms
    }
}

/// The change of a vessel's velocity and heading in a step.
struct Turn<'a> {
    before: &'a WaterVelocity,
    after: &'a WaterVelocity,
    turned_rad: f64,
}

impl Turn<'_> {
    /// The wrench (force and moment), mean over a step, that turns the vessel's momentum with her heading.
    ///
    /// With the mass matrices M₀ and M₁ at the two headings and the velocity V₁ after the step, the impulse of the
    /// wrench is −(M₁ − M₀)V₁, so that only the loads change M V. The moment of the wrench is the Munk moment −Δ u v at
    /// the middle of the turn. This wrench should do the work −½V₁ᵀ(M₁ − M₀)V₁, so that only the loads change ½VᵀMV.
    /// But the work that the wrench does differs from this value by a small amount: of third order in Δt in a steady
    /// turn, of second order where the turn begins. The reason is that the integrators turn the heading with one of the
    /// two yaw rates and not with their mean. A wrench along the mean momentum adds the missing work.
    fn wrench(&self, inertia: &Inertia, step: &TurningStep) -> Wrench {
        let Turn { before, after, turned_rad } = *self;
        let middle = Rotation::from_angle(0.5 * turned_rad);
        let sine = 2.0 * middle.sin * middle.cos;
        let versine = 2.0 * middle.sin * middle.sin;
        let difference = after.momentum_by_turn(inertia, sine, versine);
        let [from, to] = [before, after].map(|v| middle.apply_inverse(v.velocity_mps));
        let difference_kg = inertia.sway_kg - inertia.surge_kg;
        let munk_nm = -0.5 * difference_kg * (to.y * from.x + to.x * from.y);
        let impulse = (difference.0 * -1.0, munk_nm * step.step_s);
        let mean = before.mean(after);
        let missing_j = -0.5 * after.dot(difference) - mean.dot(impulse);
        let (mean_ns, mean_nms) = mean.momentum(inertia);
        let twice_energy_j = mean.dot((mean_ns, mean_nms));
        let share = if twice_energy_j > 0.0 { missing_j / twice_energy_j } else { 0.0 };
        let per_s = 1.0 / step.acts_s;
        Wrench {
            force_n: (impulse.0 + mean_ns * share) * per_s,
            moment_nm: (impulse.1 + mean_nms * share) * per_s,
        }
    }
}
