//! Orders: what is told to a vessel, and when.

use fenderline_contact::Vec2;

use super::assist::Assist;
use crate::mooring::WinchOrder;
use crate::tug::TugOrder;

/// An order at a time of the run.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// When (s).
    pub at_s: f64,
    /// Index into [`crate::WorldSetup::vessels`].
    pub vessel: usize,
    /// What.
    pub action: Action,
}

/// What an order asks for. A hand on a control takes it from the pilot that had it.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Rudder angle, positive turns to starboard going ahead (rad).
    Rudder(f64),
    /// Revolutions over full ones, −1 to 1.
    Engine(f64),
    /// A thruster by its index, −1 (to port) to 1.
    Thruster(usize, f64),
    /// An azimuth unit by its index; what is not given stays.
    Azimuth {
        /// Index into [`crate::VesselSetup::azimuths`].
        unit: usize,
        /// Thrust over that at rest and full power, 0 to 1.
        power: Option<f64>,
        /// Direction of the thrust from the bow, positive to starboard (rad).
        direction_rad: Option<f64>,
    },
    /// Keep a heading with the rudder, or with the azimuth units where there is none (rad).
    Course(f64),
    /// Keep a speed ahead through the water with the engine, or with the azimuth units where there is
    /// none (m/s).
    Speed(f64),
    /// Go to a place and stay there with engine, thrusters and tugs.
    Station(Station),
    /// A tug's work at a ship, with the azimuth units.
    Assist(Assist),
    /// Pilots off; controls stay where they are.
    Hands,
    /// A tug, by its index.
    Tug(usize, TugOrder),
    /// A line's winch, by the line's index.
    Winch(usize, WinchOrder),
    /// A line is cast off, by its index.
    LetGo(usize),
}

/// Where a ship shall go, and how fast at most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Place of the centre of gravity (m).
    pub position_m: Vec2,
    /// Heading (rad).
    pub heading_rad: f64,
    /// The fastest surge and sway (m/s).
    pub fastest_mps: [f64; 2],
}
