//! Zig-zag.

use fenderline_contact::number::greater;

use super::{Approach, ManoeuvreError, Moment, Trial};
use crate::hydro::model3::Model3;

/// Time limit of each leg of a zig-zag, in units of the ship's length divided by the approach speed.
const TIME_LIMIT: f64 = 100.0;

/// The measures of a zig-zag manoeuvre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZigZag {
    /// First overshoot: how far the heading goes beyond the check angle after the second execute (rad).
    pub first_overshoot_rad: f64,
    /// Second overshoot: how far the heading goes beyond the check angle after the third execute (rad).
    pub second_overshoot_rad: f64,
    /// Time from the first execute (rudder order) to the second (s).
    pub second_execute_s: f64,
    /// Distance sailed until the second execute (m), which is IMO's measure of the initial turning ability.
    pub initial_turning_m: f64,
}

/// Puts the rudder to `rudder_rad`, and over to the other side whenever the heading has changed by `check_rad`. Rudder
/// and check angle are in rad; the sign of the rudder gives the side of the first execute. In the 10/10 zig-zag both
/// angles are 10°.
///
/// # Errors
/// Fails with [`ManoeuvreError::NotReached`] for a ship that does not respond to the rudder.
pub fn zig_zag(
    model: &Model3,
    approach: &Approach,
    rudder_rad: f64,
    check_rad: f64,
) -> Result<ZigZag, ManoeuvreError> {
    zig_zag_observed(model, approach, rudder_rad, check_rad, &mut |_| {})
}

/// Does as [`zig_zag`], and calls `observe` after every step.
///
/// # Errors
/// See [`zig_zag`].
pub fn zig_zag_observed(
    model: &Model3,
    approach: &Approach,
    rudder_rad: f64,
    check_rad: f64,
    observe: &mut dyn FnMut(&Moment),
) -> Result<ZigZag, ManoeuvreError> {
    let mut trial = Trial::new(model, approach, observe);
    let side = 1.0_f64.copysign(rudder_rad);
    let initial_turning_m = trial.heading_to(rudder_rad, side, check_rad)?;
    let second_execute_s = trial.time_s;
    let first = trial.swing(-rudder_rad, side)?;
    trial.heading_to(-rudder_rad, -side, check_rad)?;
    let second = trial.swing(rudder_rad, -side)?;
    Ok(ZigZag {
        first_overshoot_rad: first - check_rad,
        second_overshoot_rad: second - check_rad,
        second_execute_s,
        initial_turning_m,
    })
}

impl Trial<'_> {
    /// Takes steps until the ship's heading is `check_rad` to a side. Returns the distance that the ship has sailed
    /// (m).
    fn heading_to(
        &mut self,
        rudder_rad: f64,
        side: f64,
        check_rad: f64,
    ) -> Result<f64, ManoeuvreError> {
        let limit_s = self.leg_s();
        let mut sailed_m = 0.0;
        while side * self.motion.heading_rad < check_rad {
            if self.time_s > limit_s {
                let what = "the check angle of a zig-zag";
                return Err(ManoeuvreError::NotReached { what, after_s: limit_s });
            }
            sailed_m += self.motion.velocity.speed_mps() * self.step_s;
            let shaft_rps = self.shaft.value;
            self.advance(rudder_rad, shaft_rps);
        }
        Ok(sailed_m)
    }

    /// Takes steps until the ship swings back. Returns the greatest heading to the side that the ship reaches (rad).
    fn swing(&mut self, rudder_rad: f64, side: f64) -> Result<f64, ManoeuvreError> {
        let limit_s = self.leg_s();
        let mut greatest_rad = side * self.motion.heading_rad;
        while side * self.motion.velocity.yaw_radps > 0.0 {
            if self.time_s > limit_s {
                let what = "the overshoot of a zig-zag";
                return Err(ManoeuvreError::NotReached { what, after_s: limit_s });
            }
            let shaft_rps = self.shaft.value;
            self.advance(rudder_rad, shaft_rps);
            greatest_rad = greater(greatest_rad, side * self.motion.heading_rad);
        }
        Ok(greatest_rad)
    }

    fn leg_s(&self) -> f64 {
        let length_m = self.model.ship().particulars.length_m;
        self.time_s + TIME_LIMIT * length_m / self.motion.velocity.speed_mps()
    }
}
