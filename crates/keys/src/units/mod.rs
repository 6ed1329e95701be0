//! Quantities with units: "500 kN/m^2" to a number in SI and its dimension. Unit strings are parsed
//! here and nowhere else.

mod decimal;
mod dimension;
mod error;
mod expression;
mod table;
mod temperature;

pub use dimension::{Dimension, measures, measures::Measure};
pub use error::UnitError;

pub use temperature::{celsius, of_kelvin};

use decimal::Decimal;

/// A quantity in SI units (angles in radians).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// The number in SI units; finite.
    pub si: f64,
    /// Dimension of the quantity.
    pub dimension: Dimension,
    /// Whether the text gave a unit, `1` included.
    pub has_unit: bool,
}

/// Longest text of a quantity, in bytes. Bounds the work and the depth of parentheses.
const LONGEST: usize = 120;

/// Parses a number and its unit.
///
/// The result is the correctly rounded product of number and unit if numerator and denominator of the exact result are
/// below 2^53 and the unit has no π; otherwise it has a few rounding errors.
pub fn parse(text: &str) -> Result<Quantity, UnitError> {
    if text.len() > LONGEST {
        return Err(UnitError::new(format!("a quantity has at most {LONGEST} characters")));
    }
    let (number, rest) = Decimal::split(text.trim())?;
    let rest = rest.trim_start();
    let unit = if rest.is_empty() { expression::Unit::ONE } else { expression::parse(rest)? };
    let si = number.times(&unit.scale);
    if !si.is_finite() {
        return Err(UnitError::new("the number is too large to compute with"));
    }
    Ok(Quantity { si, dimension: unit.dimension, has_unit: !rest.is_empty() })
}

#[cfg(test)]
mod tests;
