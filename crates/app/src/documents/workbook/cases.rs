//! The table of a campaign as an Excel workbook.

use fenderline_contact::number::bounded;
use rust_xlsxwriter::{DocProperties, ExcelDateTime, Workbook, XlsxError};

use super::table::{self, Head, sheet_of};
use fenderline_campaign::Cell;

use crate::campaign::CaseTable;

/// The bytes of the workbook: one sheet with a row for each case, and the units in the second row.
///
/// # Errors
/// [`XlsxError`] if there are more rows than a sheet of Excel has.
pub(crate) fn cases_workbook(title: &str, cases: &CaseTable) -> Result<Vec<u8>, XlsxError> {
    let mut book = Workbook::new();
    // Without a clock: the same campaign writes the same bytes.
    let created = ExcelDateTime::from_ymd(2000, 1, 1)?;
    let properties = DocProperties::new().set_title(title).set_creation_datetime(&created);
    book.set_properties(&properties);
    let width = |name: &str| match name {
        "finding" | "error" => 60.0,
        _ => bounded(name.chars().count() as f64 + 2.0, 9.0, 30.0),
    };
    let heads: Vec<Head<'_>> =
        cases.heads.iter().map(|head| Head(&head.name, &head.unit, width(&head.name))).collect();
    let cell = |cell: &Cell| match cell {
        Cell::Text(text) => table::Cell::Text(text.clone()),
        Cell::Number(value) => table::Cell::Number(*value),
        Cell::Empty => table::Cell::Empty,
    };
    let rows = cases.rows.iter().map(|row| row.iter().map(cell).collect());
    sheet_of(book.add_worksheet(), "Cases", &heads, rows, 1)?;
    book.save_to_buffer()
}
