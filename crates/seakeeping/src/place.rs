//! The slowly moving place and heading of a ship at which the forces of waves are computed.
//!
//! Wave forces of first order belong to the mean place of a ship. If wave forces were computed at the ship's present
//! place, excitation times her own wave motion would add a second-order force, which the drift already contains. For
//! the wave forces, a slow place p̂ therefore follows the ship's place p. The slow place p̂ has no lag if the ship
//! moves steadily: p̂′ = v̂ + 2c(p − p̂), v̂′ = c²(p − p̂).

use fenderline_contact::{BodyState, Vec2};

/// Rate c with which the slow place follows the ship (rad/s): a wave motion at 0.6 rad/s moves the slow place by a
/// fifteenth of the motion; a slow drift at 0.01 rad/s moves it by the whole drift.
const RATE_RADPS: f64 = 0.02;

/// A place and a heading that slowly follow those of a ship.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlowPlace {
    /// The place (m).
    pub position_m: Vec2,
    /// The heading (rad).
    pub heading_rad: f64,
    velocity_mps: Vec2,
    yaw_radps: f64,
}

impl SlowPlace {
    /// The slow place of a ship at the start of a run.
    #[must_use]
    pub fn new(state: &BodyState) -> SlowPlace {
        SlowPlace {
            position_m: state.position_m,
            heading_rad: state.heading_rad,
            velocity_mps: state.velocity_mps,
            yaw_radps: state.yaw_rate_radps,
        }
    }

    /// Moves the slow place by one step.
    pub fn follow(&mut self, state: &BodyState, step_s: f64) {
        let ahead_m = self.position_m + self.velocity_mps * step_s;
        let ahead_rad = self.heading_rad + self.yaw_radps * step_s;
        let (off_m, off_rad) = (state.position_m - ahead_m, state.heading_rad - ahead_rad);
        let share = RATE_RADPS * step_s;
        self.position_m = ahead_m + off_m * (2.0 * share);
        self.heading_rad = ahead_rad + off_rad * (2.0 * share);
        self.velocity_mps += off_m * (share * RATE_RADPS);
        self.yaw_radps += off_rad * (share * RATE_RADPS);
    }
}
