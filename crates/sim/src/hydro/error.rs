//! Particulars and conditions that no ship can have, or that a formula must not be used for.

use std::fmt;

use fenderline_contact::DisplayNumber;

use crate::range::OutOfRange;

/// What is wrong with a ship's particulars or with the water she is in.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum HydroError {
    /// A quantity is not a number within its range, both ends included.
    OutOfRange {
        /// Which, with its unit.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// The least that is possible.
        low: f64,
        /// The greatest that is possible.
        high: f64,
    },
    /// A regression gives a negative added mass for these particulars: it is outside its range.
    NegativeAddedMass {
        /// Whose regression.
        formula: &'static str,
        /// Which coefficient.
        coefficient: &'static str,
        /// What it comes to.
        value: f64,
    },
    /// The water is no deeper than the draught.
    Aground {
        /// Depth of water (m).
        depth_m: f64,
        /// Draught (m).
        draught_m: f64,
    },
    /// A speed at which the formula has no answer: at or above the critical Froude number of depth.
    Supercritical {
        /// Froude number of depth, V/√(gh).
        froude: f64,
    },
}

impl fmt::Display for HydroError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            HydroError::OutOfRange { quantity, value, low, high } => {
                let [low, high, value] = [*low, *high, *value].map(DisplayNumber);
                write!(f, "{quantity} must be between {low} and {high}, but is {value}")
            }
            HydroError::NegativeAddedMass { formula, coefficient, value } => write!(
                f,
                "{formula} gives {coefficient} = {value:.4} for these particulars: use another formula"
            ),
            HydroError::Aground { depth_m, draught_m } => {
                let [depth_m, draught_m] = [*depth_m, *draught_m].map(DisplayNumber);
                write!(f, "aground: {depth_m} m of water under a draught of {draught_m} m")
            }
            HydroError::Supercritical { froude } => write!(
                f,
                "the Froude number of depth is {froude:.3}: the formula ends below the critical speed"
            ),
        }
    }
}

impl std::error::Error for HydroError {}

/// The value, where it lies within the range; NaN does not.
pub(super) fn within(
    quantity: &'static str,
    value: f64,
    low: f64,
    high: f64,
) -> Result<f64, HydroError> {
    crate::range::within(quantity, value, low, high)
        .map_err(|OutOfRange { .. }| HydroError::OutOfRange { quantity, value, low, high })
}
