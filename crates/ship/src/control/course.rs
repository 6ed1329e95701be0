//! Automatic pilots that keep a course with the rudder and a speed with the engine.

use fenderline_contact::number::{bounded, greater};

use super::turn_to;

/// Keeps a heading with the rudder: δ = Kp (ψ_wanted − ψ) − Kd r, within the rudder's stops (δ rudder angle, ψ heading,
/// r rate of turn).
///
/// The gains that `of_ship` gives are customary values, not tuned for a ship: one degree of rudder for each degree of
/// error, and a rate gain equal to the time in which the ship sails 1.5 times her length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CoursePilot {
    /// Wanted heading (rad).
    pub heading_rad: f64,
    /// Kp (rad/rad).
    pub gain: f64,
    /// Kd (rad/(rad/s)).
    pub rate_gain_s: f64,
    /// Largest rudder angle, where the rudder meets its stops (rad).
    pub stop_rad: f64,
}

impl CoursePilot {
    /// A pilot for a ship of the given length at the given speed.
    #[must_use]
    pub fn of_ship(heading_rad: f64, length_m: f64, speed_mps: f64, stop_rad: f64) -> CoursePilot {
        let rate_gain_s = 1.5 * length_m / greater(speed_mps.abs(), 0.5);
        CoursePilot { heading_rad, gain: 1.0, rate_gain_s, stop_rad }
    }

    /// The rudder order (rad). When the ship goes astern, the rudder order is reversed, because the rudder acts in the
    /// opposite direction.
    #[must_use]
    pub fn rudder_rad(&self, heading_rad: f64, yaw_rate_radps: f64, surge_mps: f64) -> f64 {
        let ask =
            self.gain * turn_to(heading_rad, self.heading_rad) - self.rate_gain_s * yaw_rate_radps;
        let ask = if surge_mps < -0.1 { -ask } else { ask };
        bounded(ask, -self.stop_rad, self.stop_rad)
    }
}

/// Keeps a speed with the engine. The engine order is a share of full revolutions, by proportional and integral
/// control.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedPilot {
    /// Speed ahead through the water that the pilot keeps (m/s).
    pub speed_mps: f64,
    /// Speed of the ship at full revolutions (m/s), for the feed-forward.
    pub full_speed_mps: f64,
    /// Integral time of the control: the time after which a constant error has changed the order as much by the
    /// integral as by the error itself (s).
    pub integral_s: f64,
    /// The present value of the control's integral part (dimensionless).
    pub integral: f64,
}

impl SpeedPilot {
    /// The engine order for this step: revolutions divided by full revolutions, −1 to 1. The integral part of the speed
    /// control stays constant while the engine order is at its limit.
    pub fn revolutions(&mut self, surge_mps: f64, step_s: f64) -> f64 {
        let error = (self.speed_mps - surge_mps) / self.full_speed_mps;
        let feed_forward = self.speed_mps / self.full_speed_mps;
        let ask = feed_forward + 3.0 * error + self.integral;
        if ask.abs() < 1.0 {
            self.integral += 3.0 * error * step_s / self.integral_s;
        }
        bounded(ask, -1.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_rudder_goes_the_short_way_round_and_counters_a_turn() {
        let pilot = CoursePilot::of_ship(0.1, 200.0, 5.0, 0.6);
        assert!(pilot.rudder_rad(6.2, 0.0, 5.0) > 0.0, "over north, not round by south");
        assert!(pilot.rudder_rad(0.1, 0.01, 5.0) < 0.0);
        assert!(pilot.rudder_rad(0.0, 0.0, -2.0) < 0.0, "astern");
        assert_eq!(pilot.rudder_rad(3.0, 0.0, 5.0), -0.6);
    }

    #[test]
    fn a_speed_against_a_steady_drag_is_reached() {
        // u̇ = (revolutions − drag)/30 s, with a drag that the feed-forward does not include.
        let mut pilot =
            SpeedPilot { speed_mps: 3.0, full_speed_mps: 8.0, integral_s: 60.0, integral: 0.0 };
        let mut u = 0.0;
        for _ in 0..6000 {
            u += 0.1 * (8.0 * pilot.revolutions(u, 0.1) - u - 1.5) / 30.0;
        }
        assert!((u - 3.0).abs() < 1e-3, "{u}");
    }
}
