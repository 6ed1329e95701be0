//! Time integrators compute the next state of a body from a state and its rate of change.

use fenderline_contact::{BodyState, Vec2, Wrench};

use fenderline_world::rigid_body::Inertia;

/// Rate of change of a body's state.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Rate {
    velocity_mps: Vec2,
    yaw_rate_radps: f64,
    acceleration_mps2: Vec2,
    yaw_acceleration_radps2: f64,
}

impl Rate {
    /// Linear and angular velocity of the body (m/s, rad/s).
    pub(crate) fn motion(&self) -> (Vec2, f64) {
        (self.velocity_mps, self.yaw_rate_radps)
    }

    /// The rate of change of a body's state under a wrench.
    pub(crate) fn of(inertia: &Inertia, state: &BodyState, wrench: &Wrench) -> Rate {
        let (acceleration_mps2, yaw_acceleration_radps2) = inertia.acceleration(state, wrench);
        Rate {
            velocity_mps: state.velocity_mps,
            yaw_rate_radps: state.yaw_rate_radps,
            acceleration_mps2,
            yaw_acceleration_radps2,
        }
    }

    /// The mean rate of the classical Runge–Kutta method, `(self + 2 (two + three) + four) / 6`.
    pub(crate) fn runge_kutta(self, two: Rate, three: Rate, four: Rate) -> Rate {
        let mean = |one: f64, two: f64, three: f64, four: f64| {
            (one + 2.0 * (two + three) + four) * (1.0 / 6.0)
        };
        let mean_vector = |one: Vec2, two: Vec2, three: Vec2, four: Vec2| {
            (one + (two + three) * 2.0 + four) * (1.0 / 6.0)
        };
        Rate {
            velocity_mps: mean_vector(
                self.velocity_mps,
                two.velocity_mps,
                three.velocity_mps,
                four.velocity_mps,
            ),
            yaw_rate_radps: mean(
                self.yaw_rate_radps,
                two.yaw_rate_radps,
                three.yaw_rate_radps,
                four.yaw_rate_radps,
            ),
            acceleration_mps2: mean_vector(
                self.acceleration_mps2,
                two.acceleration_mps2,
                three.acceleration_mps2,
                four.acceleration_mps2,
            ),
            yaw_acceleration_radps2: mean(
                self.yaw_acceleration_radps2,
                two.yaw_acceleration_radps2,
                three.yaw_acceleration_radps2,
                four.yaw_acceleration_radps2,
            ),
        }
    }
}

/// A step of forward Euler: moves positions with the old velocities, as the simulator of Moreno et al. (2023) does.
pub(crate) fn euler(state: &BodyState, rate: &Rate, step_s: f64) -> BodyState {
    BodyState {
        position_m: state.position_m + rate.velocity_mps * step_s,
        heading_rad: state.heading_rad + rate.yaw_rate_radps * step_s,
        velocity_mps: state.velocity_mps + rate.acceleration_mps2 * step_s,
        yaw_rate_radps: state.yaw_rate_radps + rate.yaw_acceleration_radps2 * step_s,
    }
}

/// A step of semi-implicit Euler: updates velocities first, then moves positions with the new velocities.
pub(crate) fn semi_implicit(state: &BodyState, rate: &Rate, step_s: f64) -> BodyState {
    let velocity_mps = state.velocity_mps + rate.acceleration_mps2 * step_s;
    let yaw_rate_radps = state.yaw_rate_radps + rate.yaw_acceleration_radps2 * step_s;
    BodyState {
        position_m: state.position_m + velocity_mps * step_s,
        heading_rad: state.heading_rad + yaw_rate_radps * step_s,
        velocity_mps,
        yaw_rate_radps,
    }
}
