//! Choices whose labels are numbers of one unit.

use fenderline_scenario::Choice;

/// The numbers of the labels and their unit; `None` where one is no number, or the units differ.
pub(super) fn numbers(choices: &[Choice]) -> Option<(Vec<f64>, &str)> {
    let parts: Vec<(f64, &str)> =
        choices.iter().map(|choice| split(&choice.label)).collect::<Option<_>>()?;
    let (_, unit) = *parts.first()?;
    let is_one_unit = parts.iter().all(|(_, other)| *other == unit);
    is_one_unit.then(|| (parts.iter().map(|(number, _)| *number).collect(), unit))
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
