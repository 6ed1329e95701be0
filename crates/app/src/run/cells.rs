//! Heads and values of the columns in the summary that `run` prints, as texts.

use core::fmt::Write as _;

use fenderline_results::{Catalogue, Printed};
use fenderline_scenario::printable_line;

/// Longest name of a pair or a fender (characters); longer names are cut.
pub(super) const NAME_WIDTH: usize = 48;

/// A user's text without control characters, so that columns keep their width.
pub(super) fn one_line(text: &str) -> String {
    printable_line(text).into_owned()
}

/// A number with the given number of decimals; a very large number is written with a power of ten.
pub(super) fn decimal(value: f64, decimals: usize) -> String {
    if value.abs() >= 1e12 { format!("{value:.3e}") } else { format!("{value:.decimals$}") }
}

/// The heads and the units of the columns of a table, each aligned to the right and after two spaces; `catalogue` lists
/// the quantities.
pub(super) fn heads<S, T>(catalogue: &Catalogue<S, T>) -> [String; 2] {
    let mut rows = [String::new(), String::new()];
    for column in catalogue.shown {
        if let Some(Printed { head, width, .. }) = column.printed {
            let _ = write!(rows[0], "  {head:>width$}");
            let _ = write!(rows[1], "  {:>width$}", column.scale.plain_unit());
        }
    }
    rows
}

/// The values of one row of a table, for one part of the run such as a fender; `-` where the part has no value.
pub(super) fn values<S, T>(catalogue: &Catalogue<S, T>, setup: &S, summary: &T) -> String {
    let mut row = String::new();
    for column in catalogue.shown {
        if let Some(Printed { width, decimals, .. }) = column.printed {
            let value = catalogue.number(column.quantity, setup, summary);
            let text = value.map(|value| decimal(column.scale.of(value), decimals));
            let _ = write!(row, "  {:>width$}", text.as_deref().unwrap_or("-"));
        }
    }
    row
}
