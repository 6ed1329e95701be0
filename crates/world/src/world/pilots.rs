//! Which pilots of a vessel are active.

use fenderline_ship::control::{CoursePilot, SpeedPilot, StationPilot};

use super::assist::AssistPilot;

/// The active pilots of a vessel: plain data.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pilots {
    /// Keeps a course with the rudder.
    pub course: Option<CoursePilot>,
    /// Keeps a speed with the engine.
    pub speed: Option<SpeedPilot>,
    /// Keeps a station with all devices.
    pub station: Option<StationPilot>,
    /// Assists a ship with the azimuth units.
    pub assist: Option<AssistPilot>,
    /// Thrust ahead that azimuth units keep for a course without an ordered speed (N).
    pub ahead_n: f64,
}
