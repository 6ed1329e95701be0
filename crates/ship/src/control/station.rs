//! An automatic pilot that brings a ship to a position and a heading by forces and keeps her there: for station keeping
//! and berthing.

use fenderline_contact::number::bounded;
use fenderline_contact::{BodyState, Rotation, Vec2};

use super::turn_to;

/// Force and moment that a pilot demands, in the ship's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Demand {
    /// Forward (N).
    pub surge_n: f64,
    /// To starboard (N).
    pub sway_n: f64,
    /// To starboard (N·m).
    pub yaw_nm: f64,
}

/// The gains of a station pilot, which acts as a damped spring with an integral part against steady wind and current.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gains {
    /// Mass in surge and sway and inertia in yaw of the ship (kg, kg, kg·m²).
    pub inertia: [f64; 3],
    /// Natural period of the pilot's control, which acts like a spring (s).
    pub period_s: f64,
    /// Damping over critical damping.
    pub damping: f64,
    /// Time constant of the control's integral part (s): much longer than the period.
    pub integral_s: f64,
    /// Greatest speed at which the pilot approaches: surge, sway (m/s), yaw (rad/s).
    pub fastest: [f64; 3],
}

/// A pilot that brings a ship to a position and keeps her there.
///
/// The pilot turns the error in each of surge, sway and yaw into a wanted speed, up to the greatest speed. The
/// difference between wanted and present speed gives the force that the pilot demands. Near the position the pilot acts
/// as a damped spring; farther away it gives a steady approach. A ship's master berths in the same way as the station
/// pilot: parallel to the berth, and no faster than the fenders allow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StationPilot {
    /// Position of the centre of gravity that the pilot keeps, earth-fixed (m).
    pub position_m: Vec2,
    /// Wanted heading (rad).
    pub heading_rad: f64,
    /// Gains.
    pub gains: Gains,
    /// The integral parts of the control: forces and moment against steady wind and current, earth-fixed (N, N, N·m).
    pub steady: [f64; 3],
}

impl StationPilot {
    /// The force and moment that the pilot demands in this step. The integral part of surge, sway or yaw stays constant
    /// while the demand is at the limit `largest`.
    pub fn demand(&mut self, state: &BodyState, largest: &Demand, step_s: f64) -> Demand {
        let attitude = Rotation::from_angle(state.heading_rad);
        let off = attitude.apply_inverse(self.position_m - state.position_m);
        let moving = attitude.apply_inverse(state.velocity_mps);
        let turn_rad = turn_to(state.heading_rad, self.heading_rad);
        let errors = [off.x, off.y, turn_rad];
        let speeds = [moving.x, moving.y, state.yaw_rate_radps];
        let steady =
            attitude.apply_inverse(fenderline_contact::vec2(self.steady[0], self.steady[1]));
        let steady = [steady.x, steady.y, self.steady[2]];
        let gains = &self.gains;
        let omega = 2.0 * core::f64::consts::PI / gains.period_s;
        let limits = [largest.surge_n, largest.sway_n, largest.yaw_nm];
        let (mut demand, mut growth) = ([0.0; 3], [0.0; 3]);
        for axis in 0..3 {
            let wanted = bounded(
                errors[axis] * omega / (2.0 * gains.damping),
                -gains.fastest[axis],
                gains.fastest[axis],
            );
            let change =
                gains.inertia[axis] * 2.0 * gains.damping * omega * (wanted - speeds[axis]);
            demand[axis] = change + steady[axis];
            let full = demand[axis].abs() >= limits[axis];
            growth[axis] = if full { 0.0 } else { change * step_s / gains.integral_s };
            demand[axis] = bounded(demand[axis], -limits[axis], limits[axis]);
        }
        let growth_n = attitude.apply(fenderline_contact::vec2(growth[0], growth[1]));
        self.steady[0] += growth_n.x;
        self.steady[1] += growth_n.y;
        self.steady[2] += growth[2];
        Demand { surge_n: demand[0], sway_n: demand[1], yaw_nm: demand[2] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fenderline_contact::{number::greater, vec2};

    #[test]
    fn a_ship_comes_to_her_place_against_the_wind_and_no_faster_than_allowed() {
        let inertia = [9e7, 1.3e8, 7e11];
        let gains = Gains {
            inertia,
            period_s: 200.0,
            damping: 1.0,
            integral_s: 300.0,
            fastest: [0.5, 0.2, 0.003],
        };
        let mut pilot = StationPilot {
            position_m: vec2(30.0, 40.0),
            heading_rad: 0.3,
            gains,
            steady: [0.0; 3],
        };
        let largest = Demand { surge_n: 8e5, sway_n: 1e6, yaw_nm: 5e7 };
        let mut state = BodyState::default();
        let mut fastest = 0.0_f64;
        for _ in 0..20_000 {
            let ask = pilot.demand(&state, &largest, 0.2);
            let attitude = Rotation::from_angle(state.heading_rad);
            // Wind from the west, and no water to damp her.
            let own = attitude.apply_inverse(vec2(0.0, -4e5));
            let a = vec2((ask.surge_n + own.x) / inertia[0], (ask.sway_n + own.y) / inertia[1]);
            state.velocity_mps += attitude.apply(a) * 0.2;
            state.yaw_rate_radps += ask.yaw_nm / inertia[2] * 0.2;
            state.position_m += state.velocity_mps * 0.2;
            state.heading_rad += state.yaw_rate_radps * 0.2;
            fastest = greater(fastest, attitude.apply_inverse(state.velocity_mps).y.abs());
        }
        assert!((state.position_m - pilot.position_m).length() < 0.1, "{:?}", state.position_m);
        assert!((state.heading_rad - 0.3).abs() < 1e-3);
        assert!(fastest < 0.3, "{fastest}");
    }
}
