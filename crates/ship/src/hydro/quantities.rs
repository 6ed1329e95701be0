//! Velocities and forces in the ship's axes: x forward, y to starboard, moments positive to starboard, all about
//! midship.

use crate::constants::SEA_WATER_KGPM3;
use fenderline_contact::number::bounded;

use std::ops::{Add, Mul};

/// Velocity of a ship through the water at midship.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Velocity {
    /// Forward (m/s).
    pub surge_mps: f64,
    /// To starboard (m/s).
    pub sway_mps: f64,
    /// Rate of turn of the ship, positive if the bow turns to starboard (rad/s).
    pub yaw_radps: f64,
}

impl Velocity {
    /// Speed of the ship through the water, U = √(u² + v²) (m/s).
    pub fn speed_mps(&self) -> f64 {
        (self.surge_mps * self.surge_mps + self.sway_mps * self.sway_mps).sqrt()
    }

    /// Drift angle β = atan2(−v, u) (rad), positive if the ship slides to port; 0 at rest.
    pub fn drift_rad(&self) -> f64 {
        libm::atan2(-self.sway_mps, self.surge_mps)
    }
}

/// A force on a ship at midship, and the moment about midship.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Force {
    /// Forward (N).
    pub surge_n: f64,
    /// To starboard (N).
    pub sway_n: f64,
    /// Moment about midship, positive if it turns the bow to starboard (N m).
    pub yaw_nm: f64,
}

impl Force {
    /// Makes the force and moment of a horizontal force that acts at a point `along_m` forward and `across_m` to
    /// starboard of midship.
    pub fn at(surge_n: f64, sway_n: f64, along_m: f64, across_m: f64) -> Force {
        Force { surge_n, sway_n, yaw_nm: along_m * sway_n - across_m * surge_n }
    }
}

impl Add for Force {
    type Output = Force;

    fn add(self, other: Force) -> Force {
        Force {
            surge_n: self.surge_n + other.surge_n,
            sway_n: self.sway_n + other.sway_n,
            yaw_nm: self.yaw_nm + other.yaw_nm,
        }
    }
}

impl Mul<f64> for Force {
    type Output = Force;

    fn mul(self, factor: f64) -> Force {
        Force {
            surge_n: self.surge_n * factor,
            sway_n: self.sway_n * factor,
            yaw_nm: self.yaw_nm * factor,
        }
    }
}

/// The water in which a ship floats, described by its density.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Water {
    /// Density (kg/m³).
    pub density_kgpm3: f64,
}

impl Water {
    /// Sea water, 1025 kg/m³.
    pub const SEA: Water = Water { density_kgpm3: SEA_WATER_KGPM3 };
    /// Fresh water of a towing tank, with 1000 kg/m³.
    pub const FRESH: Water = Water { density_kgpm3: 1000.0 };
}

/// The present rudder angle and shaft revolutions of a ship.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Controls {
    /// Shaft revolutions, positive ahead (1/s).
    pub shaft_rps: f64,
    /// Rudder angle (rad); a positive angle turns a ship that goes ahead to starboard.
    pub rudder_rad: f64,
}

/// Smooth step 3t² − 2t³ for t between 0 and 1; below 0 the step is 0, and above 1 it is 1.
pub(super) fn smooth_step(t: f64) -> f64 {
    let t = bounded(t, 0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
