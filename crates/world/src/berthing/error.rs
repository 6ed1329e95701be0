//! Errors of the berthing formulas: particulars that are out of range.

use std::fmt;

use fenderline_contact::DisplayNumber;

/// A quantity of a berthing that is impossible or outside the range of a formula.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum BerthingError {
    /// A quantity is not a number within its range; both ends of the range are allowed.
    OutOfRange {
        /// Name of the quantity, with its unit.
        quantity: &'static str,
        /// The value of the quantity.
        value: f64,
        /// Lower limit of the quantity.
        low: f64,
        /// Upper limit of the quantity.
        high: f64,
    },
    /// With the given bow radius, the hull meets the quay between two fenders, however close the fenders stand.
    NoClearance {
        /// How far the compressed fender stands out from the quay (m).
        projection_m: f64,
        /// The required clearance between hull and quay (m).
        clearance_m: f64,
    },
}

impl fmt::Display for BerthingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            BerthingError::OutOfRange { quantity, value, low, high } => {
                let [low, high, value] = [*low, *high, *value].map(DisplayNumber);
                write!(f, "{quantity} must be between {low} and {high}, but is {value}")
            }
            BerthingError::NoClearance { projection_m, clearance_m } => write!(
                f,
                "a fender that stands out {projection_m} m leaves no clearance of {clearance_m} m"
            ),
        }
    }
}

impl std::error::Error for BerthingError {}
