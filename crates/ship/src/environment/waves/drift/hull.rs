//! Particulars of a hull for its mean wave drift force.

use crate::hydro::Particulars;
use crate::range::{OutOfRange, within};

/// Particulars of a hull for its mean wave drift force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriftHull {
    /// Length on the waterline (m).
    pub length_m: f64,
    /// Beam (m).
    pub beam_m: f64,
    /// Draught (m).
    pub draught_m: f64,
    /// Block coefficient.
    pub block_coefficient: f64,
}

impl DriftHull {
    /// Makes the hull of a wave drift force from the particulars of a ship.
    #[must_use]
    pub fn of(ship: &Particulars) -> DriftHull {
        DriftHull {
            length_m: ship.length_m,
            beam_m: ship.beam_m,
            draught_m: ship.draught_m,
            block_coefficient: ship.block_coefficient(),
        }
    }

    /// Checks every number.
    ///
    /// # Errors
    /// Fails at the first particular that is out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        within("length on the waterline [m]", self.length_m, 0.1, 2000.0)?;
        within("beam [m]", self.beam_m, 0.05, 500.0)?;
        within("draught [m]", self.draught_m, 0.01, 100.0)?;
        within("block coefficient", self.block_coefficient, 0.1, 1.0)?;
        Ok(())
    }
}
