//! Variables whose values are numbers of one unit.

use fenderline_campaign::Variable;

/// The values of a variable as numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    pub(super) name: String,
    /// Their unit as the file has it; empty if they have none.
    pub(super) unit: String,
    /// One for each choice.
    pub(super) places: Vec<f64>,
}

impl Axis {
    /// The axis of a variable; `None` if a value is no number, or the units differ.
    pub(super) fn of(variable: &Variable) -> Option<Axis> {
        let (places, unit) = variable.numbers()?;
        Some(Axis { name: variable.name.clone(), unit: unit.to_owned(), places })
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
