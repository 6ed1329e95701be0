//! What decides how a body moves in a step of the coupled method.

use crate::mass::InverseMatrix;
use crate::memory::NOT_BEHIND;
use crate::number::greater;
use crate::ranked::RankedBody;
use crate::report::Wrench;
use crate::state::{BodyState, Velocity};
use crate::vec2::Vec2;

/// What decides how a body moves in a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motion {
    /// True for all but fixed bodies at rest.
    pub(crate) moves: bool,
    /// A fixed body at rest whose state was the same twice.
    pub(crate) settled: bool,
    /// The present group of islands contains it, or an earlier one does and it floats.
    pub(crate) in_island: bool,
    /// It is fixed, and a group of islands has moved it through this step.
    pub(crate) has_moved: bool,
    /// Time by which its velocity is older than its position (s). Negative if the host gave the velocity: then it is taken
    /// to lag by half of this step.
    pub(crate) velocity_lag_s: f64,
    /// All forces but contact.
    pub(crate) load: Wrench,
    /// M⁻¹ W (m/s², rad/s²).
    pub(crate) acceleration: Velocity,
    /// A bound on the speed of any point within this step (m/s).
    pub(crate) fastest_mps: f64,
    /// The part of it by acceleration and rotation (m/s).
    pub(crate) room_mps: f64,
}

impl Motion {
    /// Before a body is first placed.
    pub(crate) const UNKNOWN: Motion = Motion {
        moves: true,
        settled: false,
        in_island: false,
        has_moved: false,
        velocity_lag_s: NOT_BEHIND,
        load: Wrench { force_n: Vec2::ZERO, moment_nm: 0.0 },
        acceleration: (Vec2::ZERO, 0.0),
        fastest_mps: 0.0,
        room_mps: 0.0,
    };

    /// Of a fixed body; `unchanged`: its state is that of the last step.
    #[inline]
    pub(crate) fn of_fixed(body: &RankedBody, state: &BodyState, unchanged: bool) -> Motion {
        let room_mps = state.yaw_rate_radps.abs() * body.reach_m;
        Motion {
            moves: !state.is_at_rest(),
            settled: unchanged && state.is_at_rest(),
            room_mps,
            fastest_mps: state.velocity_mps.length() + room_mps,
            ..Motion::UNKNOWN
        }
    }

    /// Of a floating body under a load.
    #[inline]
    pub(crate) fn of_floating(
        body: &RankedBody,
        state: &BodyState,
        load: &Wrench,
        inverse: &InverseMatrix,
        velocity_lag_s: f64,
        step_s: f64,
    ) -> Motion {
        let (way, turn) = if body.is_alike {
            (load.force_n * body.inverse_mass, load.moment_nm * body.inverse_inertia)
        } else {
            inverse.response(load.force_n, load.moment_nm)
        };
        let by_load_mps = (way.length() + turn.abs() * body.reach_m)
            * greater(kick_s(velocity_lag_s, step_s), step_s);
        let room_mps = state.yaw_rate_radps.abs() * body.reach_m + by_load_mps;
        Motion {
            velocity_lag_s,
            load: *load,
            acceleration: (way, turn),
            room_mps,
            fastest_mps: state.velocity_mps.length() + room_mps,
            ..Motion::UNKNOWN
        }
    }
}

/// κ of a sub-step of length h, of a body whose velocity lags by `lag_s`.
#[inline(always)]
pub(crate) fn kick_s(lag_s: f64, h: f64) -> f64 {
    lag_s.abs() + 0.5 * h
}
