//! The approach of a ship to a berth, as a scenario gives it. The set-up holds the state that follows from it.

use core::fmt;

use crate::named::called;
use crate::setup::Setup;

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
    /// Index of the ship in [`Setup::bodies`].
    pub body: usize,
    /// Index in [`Setup::fenders`] of the fender that she meets.
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

    /// The approach in a sentence.
    #[must_use]
    pub fn sentence(&self, setup: &Setup) -> String {
        let ship = &setup.bodies[self.body].name;
        let fender = &setup.fenders[self.fender].name;
        let to = &setup.bodies[setup.fenders[self.fender].body].name;
        // The fender of a dolphin often has the dolphin's name.
        let fender =
            if fender == to { String::new() } else { format!(", {}", called("fender", fender)) };
        let angle = self.angle_rad.to_degrees();
        let mut text = format!(
            "{ship} meets {to}{fender}, with her {} side {:.1} m {} of midship at {:.3} m/s and {angle:.1}°",
            self.side,
            self.contact_m.abs(),
            if self.contact_m < 0.0 { "aft" } else { "forward" },
            self.speed_mps(),
        );
        if self.is_abnormal() {
            text += &format!(
                "; abnormal berthing: {:.2} times the energy, {:.2} times the speed of {:.3} m/s",
                self.energy_factor,
                self.energy_factor.sqrt(),
                self.normal_speed_mps
            );
        }
        text
    }

    /// The state of the start in a sentence.
    #[must_use]
    pub fn start_sentence(&self, setup: &Setup) -> String {
        let body = &setup.bodies[self.body];
        format!(
            "{} starts at [{:.3} m, {:.3} m], heading {:.2}°, surge {:.4} m/s, sway {:.4} m/s",
            body.name,
            body.position_m.x,
            body.position_m.y,
            body.heading_rad.to_degrees(),
            body.velocity.surge_mps,
            body.velocity.sway_mps
        )
    }
}
