//! The sheet of contacts.

use fenderline_results::{Outcome, PAIRS};
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::table::{Cell, Head, cells_of, heads_of, sheet_of};

/// Number of columns from the list of contact quantities that stand before the column with the fender's name. The last
/// of these columns is the peak depth, and the name is that of the fender with this depth.
const UP_TO_DEPTH: usize = 4;

/// Writes one row for each pair of bodies that touched.
pub(super) fn contacts(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let mut heads: Vec<Head<'_>> = heads_of(&PAIRS).collect();
    heads.insert(UP_TO_DEPTH, Head("of the fender", "", 20.0));
    heads.splice(0..0, [Head("Body", "", 20.0), Head("Other body", "", 20.0)]);
    let setup = outcome.setup;
    let rows = outcome.pairs.iter().map(|pair| {
        let [one, other] = pair.bodies.map(|body| setup.bodies[body].name.as_str());
        let fender = pair.peak_depth_fender.map(|fender| setup.fenders[fender].name.as_str());
        let mut row: Vec<Cell> = cells_of(&PAIRS, &(), Some(pair)).collect();
        row.insert(UP_TO_DEPTH, fender.map_or(Cell::Empty, Cell::from));
        row.splice(0..0, [one.into(), other.into()]);
        row
    });
    sheet_of(sheet, "Contacts", &heads, rows, 2)
}
