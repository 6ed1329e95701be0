//! Unit expressions: products, quotients and powers of units, as in `kN.s/m^2`.
//!
//! ```text
//! expression = factor { ("." | "*" | "·" | "×" | space) factor | "/" factor }
//! factor     = (symbol | "1" | "(" expression ")") [power]
//! power      = "^" ["-"] digit | "²" | "³"
//! ```

use super::decimal::Scale;
use super::table::{self, UNITS};
use super::{Dimension, UnitError, temperature};
use crate::suggest::nearest;

/// A unit: its factor to the SI unit, and its dimension.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Unit {
    pub(super) scale: Scale,
    pub(super) dimension: Dimension,
}

impl Unit {
    pub(super) const ONE: Unit = Unit { scale: Scale::ONE, dimension: Dimension::NONE };

    fn times(self, other: Unit, power: i32) -> Result<Unit, UnitError> {
        let scale = self.scale.times(other.scale, power);
        let dimension = self.dimension.times(other.dimension, power);
        match (scale, dimension) {
            (Some(scale), Some(dimension)) => Ok(Unit { scale, dimension }),
            _ => Err(UnitError::new("the unit's powers are too high to compute with")),
        }
    }
}

/// Parses a whole unit expression. The caller must limit the length of `text`, which limits the depth of recursion.
pub(super) fn parse(text: &str) -> Result<Unit, UnitError> {
    let mut cursor = Cursor { rest: text };
    let unit = cursor.expression()?;
    match cursor.rest.chars().next() {
        None => Ok(unit),
        Some(')') => Err(UnitError::new("there is a `)` without its `(` in the unit")),
        Some('-') => Err(UnitError::with_help(
            "`-` does not belong in a unit",
            "write a product with a point: kN.m, kip.ft",
        )),
        Some(other) => Err(UnitError::new(format!("`{}` does not belong in a unit", show(other)))),
    }
}

struct Cursor<'a> {
    rest: &'a str,
}

impl Cursor<'_> {
    fn expression(&mut self) -> Result<Unit, UnitError> {
        let mut product = Unit::ONE.times(self.factor()?, 1)?;
        let mut divided = false;
        loop {
            let spaced = self.skip_spaces();
            if self.take(&['/']) {
                divided = true;
                product = product.times(self.factor()?, -1)?;
            } else if self.take(&['.', '*', '·', '⋅', '×']) || (spaced && self.at_factor()) {
                if divided {
                    return Err(UnitError::with_help(
                        "a product after a `/` in a unit can be read in two ways",
                        "write the divisor last or in parentheses: kN.s/m^2, kN/(m.s)",
                    ));
                }
                product = product.times(self.factor()?, 1)?;
            } else {
                return Ok(product);
            }
        }
    }

    fn factor(&mut self) -> Result<Unit, UnitError> {
        self.skip_spaces();
        let atom = if self.take(&['(']) {
            let inner = self.expression()?;
            self.skip_spaces();
            if !self.take(&[')']) {
                return Err(UnitError::new("there is a `(` without its `)` in the unit"));
            }
            inner
        } else {
            self.symbol()?
        };
        let power = self.power()?;
        Unit::ONE.times(atom, power)
    }

    fn symbol(&mut self) -> Result<Unit, UnitError> {
        if self.take(&['1']) {
            return Ok(Unit::ONE);
        }
        let end = self.rest.find(|c: char| !is_symbol(c)).unwrap_or(self.rest.len());
        let (symbol, rest) = self.rest.split_at(end);
        if symbol.is_empty() {
            return Err(match rest.chars().next() {
                None => UnitError::new("the unit breaks off where a unit symbol should follow"),
                Some(other) => UnitError::new(format!(
                    "`{}` stands in the unit where a unit symbol should stand",
                    show(other)
                )),
            });
        }
        let named = table::find(symbol).ok_or_else(|| unknown(symbol))?;
        if rest.starts_with(|c: char| c.is_ascii_digit()) {
            return Err(UnitError::with_help(
                format!("there is a digit right after the unit `{symbol}`"),
                format!("write a power as `{symbol}^2`"),
            ));
        }
        self.rest = rest;
        Ok(Unit { scale: named.scale, dimension: named.dimension })
    }

    fn power(&mut self) -> Result<i32, UnitError> {
        if self.take(&['²']) {
            return Ok(2);
        }
        if self.take(&['³']) {
            return Ok(3);
        }
        if !self.take(&['^']) {
            return Ok(1);
        }
        let sign = if self.take(&['-', '\u{2212}']) { -1 } else { 1 };
        let end = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
        let (digits, rest) = self.rest.split_at(end);
        match digits.parse::<i32>() {
            Ok(power @ 1..=9) => {
                self.rest = rest;
                Ok(sign * power)
            }
            _ => Err(UnitError::with_help(
                "the power of a unit must be a whole number from 1 to 9",
                "write m^2 or s^-1",
            )),
        }
    }

    fn at_factor(&self) -> bool {
        self.rest.starts_with(|c: char| is_symbol(c) || c == '(' || c == '1')
    }

    fn take(&mut self, wanted: &[char]) -> bool {
        match self.rest.strip_prefix(wanted) {
            Some(rest) => {
                self.rest = rest;
                true
            }
            None => false,
        }
    }

    fn skip_spaces(&mut self) -> bool {
        let trimmed = self.rest.trim_start();
        let skipped = trimmed.len() < self.rest.len();
        self.rest = trimmed;
        skipped
    }
}

fn is_symbol(c: char) -> bool {
    c.is_alphabetic() || c == '°' || c == '%' || c == '_'
}

fn show(c: char) -> String {
    c.escape_debug().to_string()
}

/// The error for a symbol that no unit has.
fn unknown(symbol: &str) -> UnitError {
    let message = format!("`{}` is not a known unit", symbol.escape_debug());
    if symbol == "kt" {
        return UnitError::with_help(
            "the unit `kt` can be read as knots or as kilotonnes",
            "write `kn` for knots, `1000 t` for a kilotonne",
        );
    }
    if ["ton", "tons"].iter().any(|ton| ton.eq_ignore_ascii_case(symbol)) {
        return UnitError::with_help(
            format!("the unit `{symbol}` can be read as a metric, a long or a short ton"),
            "write `t` for 1000 kg, `LT` for 1016 kg, `ST` for 907 kg",
        );
    }
    if temperature::is_unit(symbol) {
        return UnitError::new(format!("`{}` is a temperature", symbol.escape_debug()));
    }
    let spelled = UNITS.iter().find(|unit| {
        unit.also.iter().any(|other| *other == symbol || other.eq_ignore_ascii_case(symbol))
    });
    let suggestion = spelled
        .map(|unit| unit.symbol)
        .or_else(|| nearest(symbol, UNITS.iter().map(|unit| unit.symbol)));
    match suggestion {
        Some(symbol) => UnitError::with_help(message, format!("did you mean `{symbol}`?")),
        None => UnitError::with_help(message, format!("known units: {}", known_units())),
    }
}

fn known_units() -> String {
    UNITS.iter().map(|unit| unit.symbol).collect::<Vec<_>>().join(" ")
}
