//! The range check for numbers given by the user.

use std::fmt;

use fenderline_contact::DisplayNumber;

/// Error of a quantity that is outside its range, or not a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfRange {
    /// Name of the quantity that is out of range, with its unit.
    pub quantity: &'static str,
    /// Value of the quantity.
    pub value: f64,
    /// Lower limit.
    pub low: f64,
    /// Upper limit.
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

/// Returns a value if it is within its range, where both ends belong to the range; NaN never is. The allowed ranges are
/// wider than any real value and narrow enough that no result computed from them overflows.
pub fn within(quantity: &'static str, value: f64, low: f64, high: f64) -> Result<f64, OutOfRange> {
    if value >= low && value <= high {
        return Ok(value);
    }
    Err(OutOfRange { quantity, value, low, high })
}
