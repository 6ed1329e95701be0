//! Numbers and points in messages about rows.

use fenderline_contact::Vec2;
use fenderline_keys::error::ScenarioError;

/// A point, for messages.
pub(super) fn shown(point_m: Vec2) -> String {
    format!("[{}, {}]", rounded(point_m.x), rounded(point_m.y))
}

/// To the millimetre, for messages.
pub(crate) fn rounded(value: f64) -> f64 {
    libm::round(value * 1000.0) / 1000.0 + 0.0
}

/// As `Assembly::missing`, for keys of which several would do.
pub(super) fn one_of_two(error: ScenarioError) -> ScenarioError {
    error.with_help("give two of `spacing`, `number` and `last`")
}
