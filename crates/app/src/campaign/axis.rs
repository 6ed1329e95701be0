//! Axes of a figure for campaign variables whose values are numbers with one unit.

use fenderline_campaign::Variable;

/// An axis: the values of a campaign variable as numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    pub(super) name: String,
    /// Unit of the values as the campaign file writes it; empty if the values have no unit.
    pub(super) unit: String,
    /// One number for each choice of the variable.
    pub(super) places: Vec<f64>,
}

impl Axis {
    /// The axis of a variable; `None` if a value is no number, or the units differ.
    pub(super) fn of(variable: &Variable) -> Option<Axis> {
        let (places, unit) = variable.numbers()?;
        Some(Axis { name: variable.name.clone(), unit: unit.to_owned(), places })
    }

    /// The axis of a variable as by [`Axis::of`]; if the values are no numbers, they are numbered from 1.
    pub(super) fn or_numbered(variable: &Variable) -> Axis {
        Axis::of(variable).unwrap_or_else(|| Axis {
            name: format!("{} (in the order of the file)", variable.name),
            unit: String::new(),
            places: (1..=variable.choices().len()).map(|number| number as f64).collect(),
        })
    }
}
