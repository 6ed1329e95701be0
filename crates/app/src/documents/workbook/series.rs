//! The sheets of result tables.

use fenderline_contact::number::bounded;
use fenderline_results::{KeptTable, KeptValues};
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::table::{Cell, Head, sheet_of};

/// Writes a sheet with the columns, units and values of a result table.
pub(super) fn time_series(sheet: &mut Worksheet, kept: &KeptTable) -> Result<(), XlsxError> {
    let width = |name: &str| bounded(name.chars().count() as f64 + 2.0, 9.0, 30.0);
    let heads: Vec<Head<'_>> = kept
        .columns
        .iter()
        .map(|column| Head(column.name, column.unit, width(column.name)))
        .collect();
    let cell = |values: &KeptValues, row: usize| match values {
        KeptValues::Floats(values) if values[row].is_nan() => Cell::Empty,
        KeptValues::Floats(values) => values[row].into(),
        KeptValues::Texts { codes, words } => {
            let word = usize::try_from(codes[row]).ok().and_then(|code| words.get(code));
            word.map_or(Cell::Empty, |word| word.as_str().into())
        }
        KeptValues::Flags(values) => Cell::Flag(values[row]),
        KeptValues::Counts(values) => f64::from(values[row]).into(),
    };
    let rows = (0..kept.rows()).map(|row| {
        kept.columns.iter().map(|column| cell(&column.values, row)).collect::<Vec<Cell>>()
    });
    // A sheet "Fenders" is there, and Excel tells no capitals from small letters.
    sheet_of(sheet, &format!("{} by time", kept.name), &heads, rows, 1)
}
