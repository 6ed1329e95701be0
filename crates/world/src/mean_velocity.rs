//! The mean velocity of a body over a step, from which the work of forces is computed.

use fenderline_contact::{BodyState, Displacement, Vec2, Wrench};

/// Mean velocity of a body over a step. For a constant force, force times mean velocity times Δt is exactly the
/// change of kinetic energy: ½m(v₁² − v₀²) = m(v₁ − v₀)·½(v₀ + v₁).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MeanVelocity {
    velocity_mps: Vec2,
    yaw_rate_radps: f64,
}

impl MeanVelocity {
    /// The mean of the body's velocities before and after the step.
    pub fn of(before: &BodyState, after: &BodyState) -> MeanVelocity {
        MeanVelocity {
            velocity_mps: (before.velocity_mps + after.velocity_mps) * 0.5,
            yaw_rate_radps: 0.5 * (before.yaw_rate_radps + after.yaw_rate_radps),
        }
    }

    /// The velocity with which the integrator moved the body.
    pub fn moved((velocity_mps, yaw_rate_radps): (Vec2, f64)) -> MeanVelocity {
        MeanVelocity { velocity_mps, yaw_rate_radps }
    }

    /// The mean velocity of a body over a step in which the contact engine moved the body, sub-steps included.
    pub fn over(motion: &Displacement, step_s: f64) -> MeanVelocity {
        MeanVelocity {
            velocity_mps: motion.translation_m * (1.0 / step_s),
            yaw_rate_radps: motion.rotation_rad / step_s,
        }
    }

    /// Velocity of the point of the body that is at `arm_m` from the centre of gravity (m/s).
    pub fn at(&self, arm_m: Vec2) -> Vec2 {
        self.velocity_mps + arm_m.spun_by(self.yaw_rate_radps)
    }

    /// Power of a force and moment on the body (W).
    pub fn power_w(&self, wrench: &Wrench) -> f64 {
        wrench.force_n.dot(self.velocity_mps) + wrench.moment_nm * self.yaw_rate_radps
    }
}
