//! The sheet of flexible dolphins.

use fenderline_results::{DOLPHINS, Outcome};
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::table::{Cell, Head, cells_of, heads_of, sheet_of};

/// Writes one row for each flexible dolphin.
pub(super) fn dolphins(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let mut heads = vec![Head("Dolphin", "", 22.0)];
    heads.extend(heads_of(&DOLPHINS));
    let rows = outcome.dolphins.iter().map(|of| {
        let body = &outcome.setup.bodies[of.body];
        let mut row: Vec<Cell> = vec![body.name.as_str().into()];
        row.extend(cells_of(&DOLPHINS, body, Some(of)));
        row
    });
    sheet_of(sheet, "Dolphins", &heads, rows, 1)
}
