//! The sheet of mooring lines.

use fenderline_results::{LINES, Outcome};
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::table::{Cell, Head, cells_of, heads_of, sheet_of};

/// Writes one row for each mooring line.
pub(super) fn lines(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let mut heads = vec![Head("Line", "", 22.0)];
    heads.extend(heads_of(&LINES));
    heads.push(Head("Verdict", "", 22.0));
    let all = outcome.setup.world.lines.iter().zip(&outcome.world.lines);
    let rows = all.map(|(line, totals)| {
        let mut row: Vec<Cell> = vec![line.line.name.as_str().into()];
        row.extend(cells_of(&LINES, line, Some(totals)));
        row.push(totals.verdict().text().into());
        row
    });
    sheet_of(sheet, "Lines", &heads, rows, 1)
}
