//! The pilots of a vessel that are active.

use fenderline_ship::control::{CoursePilot, SpeedPilot, StationPilot};

use super::assist::AssistPilot;

/// The active pilots of a vessel, as plain data.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pilots {
    /// Pilot that keeps a course with the rudder.
    pub course: Option<CoursePilot>,
    /// Pilot that keeps a speed with the engine.
    pub speed: Option<SpeedPilot>,
    /// Pilot that keeps a station with all devices.
    pub station: Option<StationPilot>,
    /// Pilot that assists a ship with the azimuth units.
    pub assist: Option<AssistPilot>,
    /// Thrust ahead that azimuth units keep on a course if no speed is ordered (N).
    pub ahead_n: f64,
}
