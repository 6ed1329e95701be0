//! Bollards to which orders send lines, and the line handlers who take the lines to the bollards.

use fenderline_contact::Vec2;

use super::line_end::LineEnd;
use fenderline_ship::range::{OutOfRange, within};

/// A bollard on a body, for example on a quay, a dolphin or another ship.
#[derive(Clone, Debug, PartialEq)]
pub struct BollardSetup {
    /// Name of the bollard.
    pub name: String,
    /// Index into [`crate::setup::Setup::bodies`].
    pub body: usize,
    /// Position of the bollard in the body's frame (m).
    pub at_m: Vec2,
    /// Height of the bollard above the still water (m); above datum if the body is fixed.
    pub above_water_m: f64,
    /// Number of lines that the bollard can take at the same time.
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
/// the reach of a heaving line, a gang needs [`LineHandling::heaving_line_s`]. If the bollard is farther away, a boat
/// carries the line. The boat adds the time that it needs for the distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineHandling {
    /// Number of gangs.
    pub gangs: usize,
    /// Farthest distance from fairlead to bollard that a heaving line reaches (m).
    pub heaving_line_m: f64,
    /// Time from the throw until the eye is over the bollard (s).
    pub heaving_line_s: f64,
    /// Speed of the boat with a line (m/s); `None` if there is no boat.
    pub boat_mps: Option<f64>,
}

impl Default for LineHandling {
    /// Two gangs, a heaving line with a reach of 30 m and a time of 60 s, and a boat with a speed of 1 m/s. These
    /// values are our assumptions: we read no source for them.
    fn default() -> LineHandling {
        LineHandling { gangs: 2, heaving_line_m: 30.0, heaving_line_s: 60.0, boat_mps: Some(1.0) }
    }
}

impl LineHandling {
    /// Time that a gang needs to take a line over this distance (s); `None` if the distance is out of reach.
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
    /// Returns the first number that is out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        within("reach of a heaving line [m]", self.heaving_line_m, 0.0, 1e4)?;
        within("time that a gang needs with a heaving line [s]", self.heaving_line_s, 0.0, 1e5)?;
        within("speed of the line boat [m/s]", self.boat_mps.unwrap_or(1.0), 0.01, 20.0)?;
        Ok(())
    }
}
