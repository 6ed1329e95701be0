//! One check for every number that a user gives: its name, its unit, its range.

use std::fmt;

use fenderline_contact::DisplayNumber;

/// A quantity that is not a number within its range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// Which, with its unit.
    pub quantity: &'static str,
    /// Its value.
    pub value: f64,
    /// The least that is taken.
    pub low: f64,
    /// The greatest that is taken.
    pub high: f64,
}

impl fmt::Display for OutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let OutOfRange { quantity, value, low, high } = self;
        let [low, high, value] = [*low, *high, *value].map(DisplayNumber);
        write!(f, "{quantity} must be between {low} and {high}, but is {value}")
    }
}

impl std::error::Error for OutOfRange {}

/// The value where it lies within the range, both ends included; NaN does not. Ranges are wider than
/// anything real and narrow enough that nothing computed from them overflows.
pub(crate) fn within(
    quantity: &'static str,
    value: f64,
    low: f64,
    high: f64,
) -> Result<f64, OutOfRange> {
    if value >= low && value <= high {
        return Ok(value);
    }
    Err(OutOfRange { quantity, value, low, high })
}
