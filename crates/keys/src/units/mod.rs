//! Quantities with units: turns a text like "500 kN/m^2" into a number in SI units and its dimension. The program
//! parses units only in this module.

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
    /// The number of the quantity in SI units, which is finite.
    pub si: f64,
    /// Dimension of the quantity.
    pub dimension: Dimension,
    /// Whether the text gave a unit; the unit `1` counts as a unit.
    pub has_unit: bool,
}

/// Longest text of a quantity, in bytes. This length limits the parser's work and the depth of parentheses.
const LONGEST: usize = 120;

/// Parses a text with a number and its unit.
///
/// The resulting number is correctly rounded if numerator and denominator of the exact result are below 2^53 and the
/// unit has no factor π; otherwise it has a few rounding errors.
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
