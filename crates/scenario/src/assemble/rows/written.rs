//! Writes numbers and points in messages about rows.

use fenderline_contact::Vec2;
use fenderline_keys::error::ScenarioError;

/// A point as messages show it.
pub(super) fn shown(point_m: Vec2) -> String {
    format!("[{}, {}]", rounded(point_m.x), rounded(point_m.y))
}

/// Rounds a number of metres to the millimetre, for messages.
pub(crate) fn rounded(value: f64) -> f64 {
    libm::round(value * 1000.0) / 1000.0 + 0.0
}

/// Adds to an error about a row the help that two of three keys are needed.
pub(super) fn one_of_two(error: ScenarioError) -> ScenarioError {
    error.with_help("give two of the keys `spacing`, `number` and `last`")
}
