//! What stands in the columns that `run` prints.

use fenderline_scenario::printable_line;

/// Longest name of a pair or a fender (characters); longer ones are cut.
pub(super) const NAME_WIDTH: usize = 48;

/// A user's text without control characters, so that columns keep their width.
pub(super) fn one_line(text: &str) -> String {
    printable_line(text).into_owned()
}

/// A number with some decimals; very large ones with a power of ten.
pub(super) fn decimal(value: f64, decimals: usize) -> String {
    if value.abs() >= 1e12 { format!("{value:.3e}") } else { format!("{value:.decimals$}") }
}
