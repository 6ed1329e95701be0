//! Velocities and offsets of a body, as the hosts compute with them.

use crate::maths::vec2::Vec2;
use crate::state::body_state::BodyState;

/// Velocity of a body's centre of gravity, and the body's rate of turn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Velocity {
    pub(super) linear_mps: Vec2,
    pub(super) yaw_radps: f64,
}

impl Velocity {
    pub(super) fn of(state: &BodyState) -> Velocity {
        Velocity { linear_mps: state.velocity_mps, yaw_radps: state.yaw_rate_radps }
    }

    /// The constant velocity that leads from one state of a body to another state in `step_s`.
    pub(super) fn mean(from: &BodyState, to: &BodyState, step_s: f64) -> Velocity {
        Velocity {
            linear_mps: (to.position_m - from.position_m) * (1.0 / step_s),
            yaw_radps: (to.heading_rad - from.heading_rad) / step_s,
        }
    }

    /// Upper bound of the speed of a point of the body at this distance from the centre of gravity (m/s).
    pub(super) fn at(self, radius_m: f64) -> f64 {
        self.linear_mps.length() + self.yaw_radps.abs() * radius_m
    }

    /// The displacement of a body at this velocity in the time `step_s`.
    pub(super) fn displacement(self, step_s: f64) -> Offset {
        Offset { linear_m: self.linear_mps * step_s, rotation_rad: self.yaw_radps * step_s }
    }

    pub(super) fn times(self, factor: f64) -> Velocity {
        Velocity { linear_mps: self.linear_mps * factor, yaw_radps: self.yaw_radps * factor }
    }

    pub(super) fn plus(self, other: Velocity) -> Velocity {
        Velocity {
            linear_mps: self.linear_mps + other.linear_mps,
            yaw_radps: self.yaw_radps + other.yaw_radps,
        }
    }

    pub(super) fn minus(self, other: Velocity) -> Velocity {
        Velocity {
            linear_mps: self.linear_mps - other.linear_mps,
            yaw_radps: self.yaw_radps - other.yaw_radps,
        }
    }

    /// Moves a state with this velocity for `step_s`; the velocity in the state stays unchanged.
    pub(super) fn carry(self, state: &BodyState, step_s: f64) -> BodyState {
        BodyState {
            position_m: state.position_m + self.linear_mps * step_s,
            heading_rad: state.heading_rad + self.yaw_radps * step_s,
            ..*state
        }
    }

    /// Returns the state with its velocity replaced by this velocity.
    pub(super) fn of_body_at(self, state: &BodyState) -> BodyState {
        BodyState { velocity_mps: self.linear_mps, yaw_rate_radps: self.yaw_radps, ..*state }
    }
}

/// Difference of two poses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Offset {
    pub(super) linear_m: Vec2,
    pub(super) rotation_rad: f64,
}

impl Offset {
    pub(super) fn between(from: &BodyState, to: &BodyState) -> Offset {
        Offset {
            linear_m: to.position_m - from.position_m,
            rotation_rad: to.heading_rad - from.heading_rad,
        }
    }

    pub(super) fn plus(self, other: Offset) -> Offset {
        Offset {
            linear_m: self.linear_m + other.linear_m,
            rotation_rad: self.rotation_rad + other.rotation_rad,
        }
    }

    /// The velocity that covers this offset in the time `step_s`.
    pub(super) fn per(self, step_s: f64) -> Velocity {
        Velocity {
            linear_mps: self.linear_m * (1.0 / step_s),
            yaw_radps: self.rotation_rad / step_s,
        }
    }

    /// Returns the state displaced by this offset; the velocity in the state stays unchanged.
    pub(super) fn applied_to(self, state: &BodyState) -> BodyState {
        BodyState {
            position_m: state.position_m + self.linear_m,
            heading_rad: state.heading_rad + self.rotation_rad,
            ..*state
        }
    }
}
