//! Temperatures: degrees Celsius and Fahrenheit, which start from different zeros.

use super::decimal::{Decimal, Scale};
use super::error::UnitError;

const CELSIUS: [&str; 2] = ["degC", "°C"];
const FAHRENHEIT: [&str; 2] = ["degF", "°F"];
/// Wrong spellings of units of temperature, each with the unit that is meant.
const NEAR: [(&str, &str); 12] = [
    ("C", "degC"),
    ("c", "degC"),
    ("celsius", "degC"),
    ("centigrade", "degC"),
    ("degc", "degC"),
    ("deg C", "degC"),
    ("deg", "degC"),
    ("°", "degC"),
    ("F", "degF"),
    ("fahrenheit", "degF"),
    ("degf", "degF"),
    ("deg F", "degF"),
];
const KELVIN: [&str; 5] = ["K", "kelvin", "Kelvin", "degK", "°K"];

/// 0 °C in kelvin.
const ZERO_CELSIUS_K: f64 = 273.15;

/// Reads a temperature, in degrees Celsius; a number without a unit counts as degrees Celsius.
pub fn celsius(text: &str) -> Result<f64, UnitError> {
    let (number, unit) = Decimal::split(text.trim())?;
    let (number, unit) = (number.times(&Scale::ONE), unit.trim());
    if unit.is_empty() || CELSIUS.contains(&unit) {
        return Ok(number);
    }
    if FAHRENHEIT.contains(&unit) {
        return Ok((number - 32.0) * 5.0 / 9.0);
    }
    if KELVIN.contains(&unit) {
        let help = format!("write degrees Celsius: \"{} degC\"", of_kelvin(number));
        return Err(UnitError::with_help("a temperature in kelvin is not accepted", help));
    }
    let message = format!("`{}` is not a unit of temperature", unit.escape_debug());
    let near = NEAR.iter().find(|(name, _)| *name == unit || name.eq_ignore_ascii_case(unit));
    Err(UnitError::with_help(
        message,
        match near {
            Some((_, meant)) => format!("did you mean `{meant}`?"),
            None => "write degC or degF".to_owned(),
        },
    ))
}

/// Converts a temperature from kelvin to degrees Celsius, rounded to a hundredth of a degree.
pub fn of_kelvin(kelvin: f64) -> f64 {
    libm::round((kelvin - ZERO_CELSIUS_K) * 100.0) / 100.0
}

/// Whether a symbol is a unit of temperature.
pub(super) fn is_unit(symbol: &str) -> bool {
    CELSIUS.contains(&symbol) || FAHRENHEIT.contains(&symbol) || KELVIN.contains(&symbol)
}
