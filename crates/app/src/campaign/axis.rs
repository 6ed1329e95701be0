//! Variables whose values are numbers of one unit.

use fenderline_scenario::Variable;

/// The values of a variable as numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    pub(super) name: String,
    /// Their unit as the file has it; empty where they have none.
    pub(super) unit: String,
    /// One for each choice.
    pub(super) places: Vec<f64>,
}

impl Axis {
    /// The axis of a variable; `None` where a value is no number, or the units differ.
    pub(super) fn of(variable: &Variable) -> Option<Axis> {
        let parts: Vec<(f64, &str)> =
            variable.choices().iter().map(|choice| split(&choice.label)).collect::<Option<_>>()?;
        let (_, unit) = *parts.first()?;
        let is_one_unit = parts.iter().all(|(_, other)| *other == unit);
        is_one_unit.then(|| Axis {
            name: variable.name.clone(),
            unit: unit.to_owned(),
            places: parts.iter().map(|(place, _)| *place).collect(),
        })
    }

    /// As [`Axis::of`]; where there are no numbers, the values are numbered from 1.
    pub(super) fn or_numbered(variable: &Variable) -> Axis {
        Axis::of(variable).unwrap_or_else(|| Axis {
            name: format!("{} (in the order of the file)", variable.name),
            unit: String::new(),
            places: (1..=variable.choices().len()).map(|number| number as f64).collect(),
        })
    }
}

/// The number at the beginning of a text, and what follows.
fn split(label: &str) -> Option<(f64, &str)> {
    let label = label.trim();
    let end =
        label.find(|c: char| !(c.is_ascii_digit() || "+-.".contains(c))).unwrap_or(label.len());
    let (number, unit) = label.split_at(end);
    let value: f64 = number.parse().ok()?;
    Some((value, unit.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_units_of_labels() {
        assert_eq!(split("0.08 m/s"), Some((0.08, "m/s")));
        assert_eq!(split("-5deg"), Some((-5.0, "deg")));
        assert_eq!(split("13"), Some((13.0, "")));
        assert_eq!(split("ballast"), None);
        assert_eq!(split("9 m draught"), Some((9.0, "m draught")));
    }
}
