//! The approach of a ship to a berth, as a scenario gives it. The set-up of a simulation holds the ship's position,
//! heading and velocity that follow from the approach.

mod sentence;

use core::fmt;

/// A side of a ship.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Left, looking forward.
    Port,
    /// Right, looking forward.
    Starboard,
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Side::Port => "port",
            Side::Starboard => "starboard",
        })
    }
}

/// The approach of a ship to her berth. [`crate::setup::BodySetup`] holds the position, heading and velocity of the
/// start.
#[derive(Clone, Debug, PartialEq)]
pub struct Approach {
    /// Index of the ship in [`crate::setup::Setup::bodies`].
    pub body: usize,
    /// Index in [`crate::setup::Setup::fenders`] of the fender that the ship meets.
    pub fender: usize,
    /// Side of the ship that meets the fender.
    pub side: Side,
    /// Distance forward of midship of the point of the ship's side that meets the fender (m).
    pub contact_m: f64,
    /// Speed of the ship towards the berth in the normal berthing (m/s).
    pub normal_speed_mps: f64,
    /// Speed of the ship along the berth, positive forward (m/s).
    pub along_mps: f64,
    /// Angle between the ship's centreline and the berth, positive with the bow towards the berth (rad).
    pub angle_rad: f64,
    /// Distance of the contact point from the fender's face at the start (m).
    pub distance_m: f64,
    /// Berthing energy of the run divided by the energy of the normal berthing: 1 for a normal berthing.
    pub energy_factor: f64,
}

impl Approach {
    /// Speed of the ship towards the berth in the run (m/s), which is the normal speed times the square root of the
    /// energy factor.
    #[must_use]
    pub fn speed_mps(&self) -> f64 {
        self.normal_speed_mps * self.energy_factor.sqrt()
    }

    /// Whether the run is an abnormal berthing.
    #[must_use]
    pub fn is_abnormal(&self) -> bool {
        self.energy_factor > 1.0
    }
}
