//! Tracks: the positions of a ship that follows waypoints at given speeds, whatever forces act on her.
//!
//! Everything about a track is a pure function of time, without state, so that a run can be copied, restored and
//! replayed bit for bit. A track has no end: before the first waypoint and after the last the ship is on the straight
//! line through the first or last leg.

mod error;
mod pace;
mod path;
mod plan;

use fenderline_contact::{Pose, Vec2};

pub use error::TrackError;
pub use pace::Pace;
pub use path::{Beside, Path};
pub use plan::{Leg, OnPlan, PassagePlan, Waypoint, WheelOver};

/// A track: the position of a ship at each time.
#[derive(Clone, Debug, PartialEq)]
pub struct Track {
    /// The path along which the ship moves.
    pub path: Path,
    /// The progress of the ship along the path over time.
    pub pace: Pace,
}

/// Position and motion of a ship on her track at some time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnTrack {
    /// Pose of the ship's midship point; the heading is that of the path.
    pub pose: Pose,
    /// Heading of the ship, clockwise from north, from −π to π (rad).
    pub heading_rad: f64,
    /// Speed of the ship over the ground along the path (m/s).
    pub speed_mps: f64,
    /// Velocity of the ship over the ground, north and east (m/s).
    pub velocity_mps: Vec2,
    /// Rate of turn of the ship, clockwise (rad/s).
    pub yaw_rate_radps: f64,
}

impl Track {
    /// Position and motion of the ship at a time (s).
    #[must_use]
    pub fn at(&self, t_s: f64) -> OnTrack {
        let place = self.path.at(self.pace.distance_m(t_s));
        let speed_mps = self.pace.speed_mps(t_s);
        let pose = Pose::new(place.position_m, place.heading_rad);
        OnTrack {
            pose,
            heading_rad: place.heading_rad,
            speed_mps,
            velocity_mps: place.ahead * speed_mps,
            yaw_rate_radps: place.curvature_pm * speed_mps,
        }
    }
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

    use super::*;

    /// Velocity and rate of turn are the derivatives of position and heading, on legs, in bends and beyond both ends.
    #[test]
    fn velocity_and_turning_are_those_of_the_position() {
        let path = Path::through(&[vec2(0.0, 0.0), vec2(500.0, 0.0), vec2(500.0, -800.0)], 200.0);
        let pace = Pace::by_time(&[(0.0, 1.0), (100.0, 5.0), (400.0, 5.0)], 50.0);
        let track = Track { path: path.unwrap(), pace: pace.unwrap() };
        let step_s = 1e-3;
        for t_s in [-30.0, 20.0, 50.0, 75.0, 119.0, 143.0, 160.0, 300.0, 500.0] {
            let [before, now, after] = [t_s - step_s, t_s, t_s + step_s].map(|t_s| track.at(t_s));
            let moved = after.pose.position_m - before.pose.position_m;
            let off = moved * (0.5 / step_s) - now.velocity_mps;
            assert!(off.length() < 1e-6, "{t_s}: {off:?}");
            let turned = (after.heading_rad - before.heading_rad) * (0.5 / step_s);
            assert!((turned - now.yaw_rate_radps).abs() < 1e-6, "{t_s}: {turned}");
            assert!((now.velocity_mps.length() - now.speed_mps).abs() < 1e-12);
        }
        // A quarter turn to port; at its end the ship heads west.
        assert!((track.at(500.0).heading_rad + std::f64::consts::FRAC_PI_2).abs() < 1e-12);
        assert!(track.at(50.0).pose.position_m.length() < 1e-9);
    }
}
