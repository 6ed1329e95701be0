//! The data that decide how a body moves in a step of the coupled method: its role and the bounds on its speed.

use crate::model::mass::InverseMatrix;
use crate::model::ranked::RankedBody;
use crate::state::body_state::{BodyState, Velocity};
use crate::state::report::Wrench;

/// The role of a body in a step of the coupled method. `Role` is kept apart from [`SpeedBound`] and other data, because
/// the stages that need the role of every body of every contact read little else.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Role {
    /// True for all bodies but fixed bodies at rest.
    pub(crate) moves: bool,
    /// True for a fixed body at rest whose state was the same in two steps.
    pub(crate) settled: bool,
    /// Whether the present group of islands contains the body; for a floating body, also whether an earlier group does.
    pub(crate) in_island: bool,
    /// Whether the body is fixed and a group of islands has moved it through this step.
    pub(crate) has_moved: bool,
}

impl Role {
    /// The role of a body that is in no island yet.
    #[inline(always)]
    pub(crate) fn new(moves: bool, settled: bool) -> Role {
        Role { moves, settled, in_island: false, has_moved: false }
    }
}

/// Bounds on the speed of any point of a body within a step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SpeedBound {
    /// Largest speed of any point of the body (m/s).
    pub(crate) fastest_mps: f64,
    /// How much faster than the body's reference point at the start of the step any point of the body may be, because
    /// of the yaw rate and of the acceleration during the step (m/s).
    pub(crate) room_mps: f64,
}

impl SpeedBound {
    /// Computes the bounds for a body on which this acceleration acts for `time_s`.
    #[inline(always)]
    pub(crate) fn of(
        body: &RankedBody,
        state: &BodyState,
        (way, turn): Velocity,
        time_s: f64,
    ) -> SpeedBound {
        let by_load_mps = (way.length() + turn.abs() * body.reach_m) * time_s;
        let room_mps = state.yaw_rate_radps.abs() * body.reach_m + by_load_mps;
        SpeedBound { fastest_mps: state.velocity_mps.length() + room_mps, room_mps }
    }
}

/// Acceleration of a body by its load, M⁻¹ W (m/s², rad/s²). `inverse` is M⁻¹, earth-fixed.
#[inline(always)]
pub(crate) fn acceleration(body: &RankedBody, inverse: &InverseMatrix, load: &Wrench) -> Velocity {
    if body.is_alike {
        (load.force_n * body.inverse_mass, load.moment_nm * body.inverse_inertia)
    } else {
        inverse.response(load.force_n, load.moment_nm)
    }
}

/// The time κ for which forces act in a sub-step of length h on a body whose velocity lags by `lag_s`.
#[inline(always)]
pub(crate) fn kick_s(lag_s: f64, h: f64) -> f64 {
    lag_s.abs() + 0.5 * h
}
