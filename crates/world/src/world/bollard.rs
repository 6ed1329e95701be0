//! Bollards to which orders send lines, and the people who take the lines there.

use fenderline_contact::Vec2;

use super::line_end::LineEnd;
use fenderline_ship::range::{OutOfRange, within};

/// A bollard on a body: a quay, a dolphin, another ship.
#[derive(Clone, Debug, PartialEq)]
pub struct BollardSetup {
    /// Name of the bollard.
    pub name: String,
    /// Index into [`crate::setup::Setup::bodies`].
    pub body: usize,
    /// Position in the body's frame (m).
    pub at_m: Vec2,
    /// Height above the still water (m); above datum if the body is fixed.
    pub above_water_m: f64,
    /// How many lines the bollard takes at once.
    pub most_lines: usize,
}

impl BollardSetup {
    /// The bollard as the end of a line.
    #[must_use]
    pub fn end(&self) -> LineEnd {
        LineEnd::OnBody { body: self.body, at_m: self.at_m, above_water_m: self.above_water_m }
    }
}

/// How line handlers bring lines to a bollard.
///
/// A gang of line handlers takes one line at a time. Further lines wait in the order in which they were sent. Within
/// the reach of a heaving line a gang needs [`LineHandling::heaving_line_s`]. Farther away a boat carries the line, and
/// the distance over the boat's speed is added.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineHandling {
    /// Number of gangs.
    pub gangs: usize,
    /// Farthest distance from fairlead to bollard that a heaving line reaches (m).
    pub heaving_line_m: f64,
    /// Time from the throw until the eye is over the bollard (s).
    pub heaving_line_s: f64,
    /// Speed of the boat with a line (m/s); `None` without a boat.
    pub boat_mps: Option<f64>,
}

impl Default for LineHandling {
    /// Two gangs, a heaving line of 30 m and 60 s, and a boat of 1 m/s. These values are our assumptions: no source was
    /// read.
    fn default() -> LineHandling {
        LineHandling { gangs: 2, heaving_line_m: 30.0, heaving_line_s: 60.0, boat_mps: Some(1.0) }
    }
}

impl LineHandling {
    /// Time that a gang needs for a line over a distance (s); `None` if the distance is out of reach.
    #[must_use]
    pub fn time_s(&self, distance_m: f64) -> Option<f64> {
        if distance_m <= self.heaving_line_m {
            return Some(self.heaving_line_s);
        }
        Some(self.heaving_line_s + distance_m / self.boat_mps?)
    }

    /// Checks the numbers.
    ///
    /// # Errors
    /// The first number out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        within("reach of a heaving line [m]", self.heaving_line_m, 0.0, 1e4)?;
        within("time of a heaving line [s]", self.heaving_line_s, 0.0, 1e5)?;
        within("speed of the boat [m/s]", self.boat_mps.unwrap_or(1.0), 0.01, 20.0)?;
        Ok(())
    }
}
