//! Quantities of command-line options: a number with its unit, or a plain number.

use crate::units::{self, Measure, measures as unit};

/// A length, or a share of another length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LengthOrShare {
    /// A length in metres.
    Metres(f64),
    /// A share of another length, for example 0.72 for "72 %".
    Share(f64),
}

/// Reads a length, in metres, from a text such as `1.2`, `"1.2 m"` or `"1200 mm"`.
///
/// # Errors
/// Returns a text that says what is wrong with the option's value and what to write instead.
pub fn length_m(text: &str) -> Result<f64, String> {
    quantity(text, &unit::LENGTH)
}

/// Reads a force, in newtons, from a text such as `585000` or `"585 kN"`.
///
/// # Errors
/// Fails like [`length_m`].
pub fn force_n(text: &str) -> Result<f64, String> {
    quantity(text, &unit::FORCE)
}

/// Reads a share in per cent: `"10 %"` and `10` both give 0.1.
///
/// # Errors
/// Fails like [`length_m`].
pub fn percent(text: &str) -> Result<f64, String> {
    let parsed = parsed(text)?;
    if parsed.dimension != unit::PLAIN_NUMBER.dimension {
        return Err(format!(
            "the value is {}, but must be a percentage, as \"10 %\"",
            parsed.dimension
        ));
    }
    Ok(if parsed.has_unit { parsed.si } else { parsed.si / 100.0 })
}

/// Reads a length, as in `0.864` or `"864 mm"`, or a share of another length, as in `"72 %"`.
///
/// # Errors
/// Fails like [`length_m`].
pub fn length_or_share(text: &str) -> Result<LengthOrShare, String> {
    let parsed = parsed(text)?;
    if parsed.has_unit && parsed.dimension == unit::PLAIN_NUMBER.dimension {
        return Ok(LengthOrShare::Share(parsed.si));
    }
    length_m(text).map(LengthOrShare::Metres)
}

/// Reads a quantity as a number in the unit `unit`. A text without a unit is accepted only if `unit` is empty.
///
/// # Errors
/// Fails like [`length_m`].
pub fn in_unit(text: &str, unit: &str) -> Result<f64, String> {
    let ours =
        parsed(&format!("1 {}", unit.replace('²', "^2").replace('³', "^3").replace('·', ".")))?;
    let given = parsed(text)?;
    if given.has_unit == unit.is_empty() || given.dimension != ours.dimension {
        let example =
            if unit.is_empty() { "\"1.5\"".to_owned() } else { format!("\"1.5 {unit}\"") };
        let what =
            if given.has_unit { given.dimension.to_string() } else { "without a unit".to_owned() };
        return Err(format!("the value is {what}, but must be written as {example}"));
    }
    Ok(given.si / ours.si)
}

fn quantity(text: &str, measure: &Measure) -> Result<f64, String> {
    let parsed = parsed(text)?;
    if !parsed.has_unit || parsed.dimension == measure.dimension {
        return Ok(parsed.si);
    }
    Err(format!("it is {}, but must be {measure}, as \"{}\"", parsed.dimension, measure.example))
}

fn parsed(text: &str) -> Result<units::Quantity, String> {
    units::parse(text).map_err(|error| match error.help {
        Some(help) => format!("{}; {help}", error.message),
        None => error.message,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_and_plain_numbers() {
        assert_eq!(length_m("1.2"), Ok(1.2));
        assert_eq!(length_m("1.2 m"), Ok(1.2));
        assert_eq!(length_m("1200 mm"), Ok(1.2));
        assert_eq!(force_n("585 kN"), Ok(585e3));
        assert_eq!(force_n("60 tf"), Ok(588_399.0));
        assert_eq!((percent("10 %"), percent("10")), (Ok(0.1), Ok(0.1)));
        assert_eq!(length_or_share("72 %"), Ok(LengthOrShare::Share(0.72)));
        assert_eq!(length_or_share("0.72"), Ok(LengthOrShare::Metres(0.72)));
        assert_eq!(length_or_share("720 mm"), Ok(LengthOrShare::Metres(0.72)));
        assert!((in_unit("95 tf", "kN").unwrap() - 931.631_75).abs() < 1e-9);
        assert_eq!((in_unit("90 %", "%"), in_unit("1.5", "")), (Ok(90.0), Ok(1.5)));
        assert_eq!(in_unit("200 kN/m^2", "kN/m²"), Ok(200.0));
        for (text, unit) in [("930", "kN"), ("930 kJ", "kN"), ("0.9", "%"), ("3 kN", ""), ("x", "")]
        {
            assert!(in_unit(text, unit).is_err(), "{text} in {unit}");
        }
    }

    #[test]
    fn mistakes_say_what_to_write() {
        for (result, fragment) in [
            (
                length_m("1.2 kN").map(|_| ()),
                "it is a force [N], but must be a length [m], as \"1.5 m\"",
            ),
            (length_m("1.2 metre").map(|_| ()), "`metre` is not a known unit; did you mean `m`?"),
            (length_m("high").map(|_| ()), "the text does not start with a number"),
            (force_n("60 t").map(|_| ()), "it is a mass [kg], but must be a force [N]"),
            (percent("10 mm").map(|_| ()), "must be a percentage, as \"10 %\""),
            (length_or_share("3 kN").map(|_| ()), "must be a length"),
        ] {
            let message = result.unwrap_err();
            assert!(message.contains(fragment), "{message}");
        }
    }
}
