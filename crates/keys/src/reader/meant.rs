//! Suggests a unit for a plain number that is out of bounds: the unit in which engineers usually give this quantity.

use core::f64::consts::PI;

use crate::printable::printable_number;
use crate::spec::Quantity;
use crate::units::{self, Measure, measures as unit};

/// Units in which engineers usually give quantities, with the size of each unit in SI.
static OF_THE_TRADE: [(&Measure, &str, f64); 8] = [
    (&unit::ANGLE, "deg", PI / 180.0),
    (&unit::RATE_OF_TURN, "deg/s", PI / 180.0),
    (&unit::LENGTH, "mm", 1e-3),
    (&unit::FORCE, "kN", 1e3),
    (&unit::MASS, "t", 1e3),
    (&unit::STIFFNESS, "kN/m", 1e3),
    (&unit::STIFFNESS_PER_AREA, "kN/m^2", 1e3),
    (&unit::PLAIN_NUMBER, "%", 1e-2),
];

/// Says what to write instead of a plain number that is out of bounds, if the number would be within the bounds in
/// another unit.
pub(super) fn meant(quantity: &Quantity, value: f64) -> Option<String> {
    let measure = quantity.measure;
    let is_within = |si: f64| si >= quantity.low && si <= quantity.high;
    if core::ptr::eq(measure, &unit::CELSIUS) {
        let in_celsius = units::of_kelvin(value);
        return is_within(in_celsius).then(|| {
            format!(
                "if the number is in kelvin, write {in_celsius}, which is the temperature in \
                 degrees Celsius"
            )
        });
    }
    let (_, symbol, size) =
        OF_THE_TRADE.iter().find(|(other, _, _)| core::ptr::eq(*other, measure))?;
    let number = printable_number(value);
    is_within(value * size).then(|| match measure.unit {
        "" => format!("for a percentage write \"{number} {symbol}\""),
        si => format!(
            "a plain number is in {si}: write \"{number} {symbol}\" if you meant \
            {symbol}"
        ),
    })
}
