//! Turning circle.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::{Approach, ManoeuvreError, Moment, Trial};
use crate::hydro::model3::{Model3, Motion};

/// Time limit of a turning circle, in units of the ship's length divided by the approach speed.
const TIME_LIMIT: f64 = 400.0;

/// The measures of a turning circle, for the midship point, from the rudder order; lengths are positive towards the
/// side of the turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TurningCircle {
    /// Advance at 90° (m).
    pub advance_m: f64,
    /// Transfer at 90° (m).
    pub transfer_m: f64,
    /// Time to 90° (s).
    pub quarter_s: f64,
    /// Tactical diameter: transfer at a change of heading of 180° (m).
    pub tactical_diameter_m: f64,
    /// Time to 180° (s).
    pub half_s: f64,
    /// The steady turn that the ship makes after two full circles.
    pub steady: SteadyTurn,
}

/// A steady turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyTurn {
    /// Speed U in the turn divided by the approach speed U₀.
    pub speed_ratio: f64,
    /// Dimensionless rate of turn r' = rL/U, positive to starboard.
    pub yaw_rate: f64,
    /// Drift angle β in the turn (rad), positive if the ship slides to port.
    pub drift_rad: f64,
    /// Diameter of the circle of the midship point (m).
    pub diameter_m: f64,
}

/// Turns with the rudder at an angle (rad) until the heading has changed by 720°, and returns the measures.
///
/// # Errors
/// Fails with [`ManoeuvreError::NotReached`] for a rudder that does not turn the ship.
pub fn turning_circle(
    model: &Model3,
    approach: &Approach,
    rudder_rad: f64,
) -> Result<TurningCircle, ManoeuvreError> {
    turning_circle_observed(model, approach, rudder_rad, &mut |_| {})
}

/// Does as [`turning_circle`], and calls `observe` after every step.
///
/// # Errors
/// See [`turning_circle`].
pub fn turning_circle_observed(
    model: &Model3,
    approach: &Approach,
    rudder_rad: f64,
    observe: &mut dyn FnMut(&Moment),
) -> Result<TurningCircle, ManoeuvreError> {
    let mut trial = Trial::new(model, approach, observe);
    let quarter = trial.turn_to(FRAC_PI_2, rudder_rad, "a change of heading of 90°")?;
    let half = trial.turn_to(PI, rudder_rad, "a change of heading of 180°")?;
    trial.turn_to(2.0 * TAU, rudder_rad, "two full circles")?;
    let velocity = trial.motion.velocity;
    let (speed_mps, length_m) = (velocity.speed_mps(), model.ship().particulars.length_m);
    Ok(TurningCircle {
        advance_m: quarter.north_m,
        transfer_m: quarter.east_m.copysign(quarter.east_m * rudder_rad),
        quarter_s: quarter.time_s,
        tactical_diameter_m: half.east_m.copysign(half.east_m * rudder_rad),
        half_s: half.time_s,
        steady: SteadyTurn {
            speed_ratio: speed_mps / approach.speed_mps,
            yaw_rate: velocity.yaw_radps * length_m / speed_mps,
            drift_rad: velocity.drift_rad(),
            diameter_m: 2.0 * speed_mps / velocity.yaw_radps.abs(),
        },
    })
}

/// Position and time at which the ship passed a heading.
struct Passage {
    north_m: f64,
    east_m: f64,
    time_s: f64,
}

impl Trial<'_> {
    /// Takes steps until the heading has changed by `angle_rad` to either side. The passage of the heading is
    /// interpolated within the step.
    fn turn_to(
        &mut self,
        angle_rad: f64,
        rudder_rad: f64,
        what: &'static str,
    ) -> Result<Passage, ManoeuvreError> {
        let length_m = self.model.ship().particulars.length_m;
        let start_mps = self.motion.velocity.speed_mps();
        let limit_s = self.time_s + TIME_LIMIT * length_m / start_mps;
        let shaft_rps = self.shaft.value;
        while self.time_s < limit_s {
            let (before, before_s) = (self.motion, self.time_s);
            self.advance(rudder_rad, shaft_rps);
            if self.motion.heading_rad.abs() >= angle_rad {
                return Ok(passage(&before, before_s, &self.motion, self.time_s, angle_rad));
            }
        }
        Err(ManoeuvreError::NotReached { what, after_s: limit_s })
    }
}

fn passage(
    before: &Motion,
    before_s: f64,
    after: &Motion,
    after_s: f64,
    angle_rad: f64,
) -> Passage {
    let (from, to) = (before.heading_rad.abs(), after.heading_rad.abs());
    let part = (angle_rad - from) / (to - from);
    Passage {
        north_m: before.north_m + part * (after.north_m - before.north_m),
        east_m: before.east_m + part * (after.east_m - before.east_m),
        time_s: before_s + part * (after_s - before_s),
    }
}
