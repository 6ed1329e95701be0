//! Crash stop.

use super::{Approach, ManoeuvreError, Moment, Trial};
use crate::hydro::model3::Model3;

/// Time that a stop may take, in lengths over speed of approach.
const PATIENCE: f64 = 200.0;

/// The measures of a crash stop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrashStop {
    /// Way along the track until the ship lies still ahead (m).
    pub track_reach_m: f64,
    /// Way along the course of the approach (m).
    pub head_reach_m: f64,
    /// Way across it, positive to starboard (m).
    pub lateral_m: f64,
    /// Change of heading, positive to starboard (rad).
    pub heading_rad: f64,
    /// Time (s).
    pub time_s: f64,
}

/// Orders revolutions astern (negative) with the rudder amidships, the shaft changing by
/// `shaft_rate_rps2` a second, until no way ahead is left.
///
/// The shaft follows its order whatever torque it takes: a diesel that cannot turn a large ship's propeller
/// astern at speed stops her later than this.
///
/// Nothing in the model makes a right-handed propeller astern swing the ship: heading and lateral way come
/// out zero on a symmetric ship, which real ones are not.
///
/// # Errors
/// [`ManoeuvreError::NoPropeller`]; [`ManoeuvreError::NotReached`] for revolutions that do not stop her.
pub fn crash_stop(
    model: &Model3,
    approach: &Approach,
    astern_rps: f64,
    shaft_rate_rps2: f64,
) -> Result<CrashStop, ManoeuvreError> {
    crash_stop_observed(model, approach, astern_rps, shaft_rate_rps2, &mut |_| {})
}

/// [`crash_stop`], showing every step to `watch`.
///
/// # Errors
/// As [`crash_stop`].
pub fn crash_stop_observed(
    model: &Model3,
    approach: &Approach,
    astern_rps: f64,
    shaft_rate_rps2: f64,
    watch: &mut dyn FnMut(&Moment),
) -> Result<CrashStop, ManoeuvreError> {
    if model.ship().propulsion.is_none() {
        return Err(ManoeuvreError::NoPropeller);
    }
    let mut trial = Trial::new(model, approach, watch);
    trial.shaft.rate_per_s = shaft_rate_rps2;
    let patience_s = PATIENCE * model.ship().particulars.length_m / approach.speed_mps;
    let mut track_reach_m = 0.0;
    while trial.motion.velocity.surge_mps > 0.0 {
        if trial.time_s > patience_s {
            let what = "a stop";
            return Err(ManoeuvreError::NotReached { what, after_s: patience_s });
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
