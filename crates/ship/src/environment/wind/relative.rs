//! The wind relative to a moving ship.

use fenderline_contact::{Rotation, Vec2};

/// Speed and angle of the wind relative to a ship.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RelativeWind {
    /// Speed (m/s).
    pub speed_mps: f64,
    /// Wind angle γ: direction from which the wind comes, measured from the bow, −π to π, positive over the port side
    /// (rad).
    pub angle_rad: f64,
}

impl RelativeWind {
    /// Computes the relative wind from the velocities of air and ship over the ground, north and east (m/s), and the
    /// ship's heading (rad).
    #[must_use]
    pub fn of(wind_mps: Vec2, ship_mps: Vec2, heading_rad: f64) -> RelativeWind {
        let air = Rotation::from_angle(heading_rad).apply_inverse(wind_mps - ship_mps);
        RelativeWind { speed_mps: air.length(), angle_rad: libm::atan2(air.y, -air.x) }
    }
}
