//! The approach of a ship to a berth, as a scenario gives it. The set-up holds the state that follows from it.

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

/// How a ship comes to her berth. [`crate::setup::BodySetup`] holds the position, heading and velocity of the start.
#[derive(Clone, Debug, PartialEq)]
pub struct Approach {
    /// Index of the ship in [`crate::setup::Setup::bodies`].
    pub body: usize,
    /// Index in [`crate::setup::Setup::fenders`] of the fender that she meets.
    pub fender: usize,
    /// Her side that meets it.
    pub side: Side,
    /// The point of her side that meets it, forward of midship (m).
    pub contact_m: f64,
    /// Speed towards the berth of the normal berthing (m/s).
    pub normal_speed_mps: f64,
    /// Speed along the berth, forward (m/s).
    pub along_mps: f64,
    /// Angle between her centreline and the berth, positive with the bow towards it (rad).
    pub angle_rad: f64,
    /// Distance of that point from the fender's face at the start (m).
    pub distance_m: f64,
    /// Energy of the run over that of the normal berthing: 1 for a normal berthing.
    pub energy_factor: f64,
}

impl Approach {
    /// Speed towards the berth in this run (m/s): energy goes with its square.
    #[must_use]
    pub fn speed_mps(&self) -> f64 {
        self.normal_speed_mps * self.energy_factor.sqrt()
    }

    /// Whether the run is that of an abnormal berthing.
    #[must_use]
    pub fn is_abnormal(&self) -> bool {
        self.energy_factor > 1.0
    }
}
