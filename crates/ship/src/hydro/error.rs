//! Errors in the hydrodynamics of a ship: particulars and conditions out of range, or outside the validity of a
//! formula.

use std::fmt;

use fenderline_contact::DisplayNumber;

use crate::range::OutOfRange;

/// An error in a ship's particulars, or in the depth of the water or the speed of the ship.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum HydroError {
    /// A quantity is not a number within its range, where both ends belong to the range.
    OutOfRange {
        /// Name of the wrong quantity, with its unit.
        quantity: &'static str,
        /// Value of the quantity.
        value: f64,
        /// Lower limit.
        low: f64,
        /// Upper limit.
        high: f64,
    },
    /// A regression gives a negative added mass, because the particulars are outside its range.
    NegativeAddedMass {
        /// The regression.
        formula: &'static str,
        /// The coefficient.
        coefficient: &'static str,
        /// Value of the coefficient.
        value: f64,
    },
    /// The depth of the water is not larger than the ship's draught.
    Aground {
        /// Depth of water (m).
        depth_m: f64,
        /// Draught (m).
        draught_m: f64,
    },
    /// The depth Froude number is 1 or more, for which the formula is not defined.
    Supercritical {
        /// Depth Froude number V/√(gh).
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
                "the depth Froude number is {froude:.3}, but the formula is defined only below 1"
            ),
        }
    }
}

impl std::error::Error for HydroError {}

/// Returns a value if it is within its range; NaN is never within a range.
pub(super) fn within(
    quantity: &'static str,
    value: f64,
    low: f64,
    high: f64,
) -> Result<f64, HydroError> {
    crate::range::within(quantity, value, low, high)
        .map_err(|OutOfRange { .. }| HydroError::OutOfRange { quantity, value, low, high })
}
