//! Crash stop.

use super::{Approach, ManoeuvreError, Moment, Trial};
use crate::hydro::model3::Model3;

/// Time limit of a crash stop, in units of the ship's length divided by the approach speed.
const TIME_LIMIT: f64 = 200.0;

/// The measures of a crash stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrashStop {
    /// Distance that the ship sails along her track until she has no headway (m).
    pub track_reach_m: f64,
    /// Distance along the approach course that the ship makes good until she has no headway (m).
    pub head_reach_m: f64,
    /// Distance of the ship across the approach course, positive to starboard (m).
    pub lateral_m: f64,
    /// Change of the ship's heading, positive to starboard (rad).
    pub heading_rad: f64,
    /// Time (s).
    pub time_s: f64,
}

/// Orders revolutions astern (negative), with the rudder amidships, until the ship has no headway. In a crash stop, the
/// shaft's revolutions change by `shaft_rate_rps2` per second.
///
/// The model assumes that the shaft follows its order at any torque. The stopping distance is longer if a diesel engine
/// cannot turn the propeller astern at speed.
///
/// The model has no paddle-wheel effect of a propeller astern. In the model, a symmetric ship therefore stops without
/// change of heading and without lateral distance. On real ships change of heading and lateral distance differ from
/// zero.
///
/// # Errors
/// Fails with [`ManoeuvreError::NoPropeller`], or with [`ManoeuvreError::NotReached`] for revolutions that do not stop
/// the ship.
pub fn crash_stop(
    model: &Model3,
    approach: &Approach,
    astern_rps: f64,
    shaft_rate_rps2: f64,
) -> Result<CrashStop, ManoeuvreError> {
    crash_stop_observed(model, approach, astern_rps, shaft_rate_rps2, &mut |_| {})
}

/// Does as [`crash_stop`], and calls `observe` after every step.
///
/// # Errors
/// See [`crash_stop`].
pub fn crash_stop_observed(
    model: &Model3,
    approach: &Approach,
    astern_rps: f64,
    shaft_rate_rps2: f64,
    observe: &mut dyn FnMut(&Moment),
) -> Result<CrashStop, ManoeuvreError> {
    if model.ship().propulsion.is_none() {
        return Err(ManoeuvreError::NoPropeller);
    }
    let mut trial = Trial::new(model, approach, observe);
    trial.shaft.rate_per_s = shaft_rate_rps2;
    let limit_s = TIME_LIMIT * model.ship().particulars.length_m / approach.speed_mps;
    let mut track_reach_m = 0.0;
    while trial.motion.velocity.surge_mps > 0.0 {
        if trial.time_s > limit_s {
            let what = "a stop";
            return Err(ManoeuvreError::NotReached { what, after_s: limit_s });
        }
        track_reach_m += trial.motion.velocity.speed_mps() * trial.step_s;
        trial.advance(0.0, astern_rps);
    }
    Ok(CrashStop {
        track_reach_m,
        head_reach_m: trial.motion.north_m,
        lateral_m: trial.motion.east_m,
        heading_rad: trial.motion.heading_rad,
        time_s: trial.time_s,
    })
}
