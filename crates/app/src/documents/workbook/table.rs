//! Writes heads, cells and formats of a sheet.

use fenderline_contact::number::greater;
use fenderline_results::{Amount, Catalogue};
use rust_xlsxwriter::{Color, Format, FormatAlign, FormatBorder, Worksheet, XlsxError};

/// A cell.
pub(super) enum Cell {
    Text(String),
    /// A number in the unit that its column has.
    Number(f64),
    /// A number with its own unit, other than that of its column.
    Of(f64, &'static str),
    Flag(bool),
    Empty,
}

/// A column of a sheet: head, unit, width in characters.
pub(super) struct Head<'h>(pub(super) &'h str, pub(super) &'h str, pub(super) f64);

impl From<&str> for Cell {
    fn from(text: &str) -> Cell {
        Cell::Text(text.to_owned())
    }
}

impl From<String> for Cell {
    fn from(text: String) -> Cell {
        Cell::Text(text)
    }
}

impl From<f64> for Cell {
    fn from(value: f64) -> Cell {
        Cell::Number(value)
    }
}

impl From<Option<f64>> for Cell {
    fn from(value: Option<f64>) -> Cell {
        value.map_or(Cell::Empty, Cell::Number)
    }
}

/// The heads of those columns that a sheet shows; `catalogue` lists the quantities of one kind of part, such as
/// fenders.
pub(super) fn heads_of<S, T>(
    catalogue: &Catalogue<S, T>,
) -> impl Iterator<Item = Head<'static>> + use<S, T> {
    let columns = catalogue.shown.iter();
    columns.filter_map(|of| Some(Head(of.head, of.scale.page_unit(), of.sheet_width?)))
}

/// The cells of one row, for one part of the run such as a fender; `catalogue` lists the quantities of this kind of
/// part. `summary` is `None` for a part without results, such as a fender that was not touched.
pub(super) fn cells_of<S, T>(
    catalogue: &Catalogue<S, T>,
    setup: &S,
    summary: Option<&T>,
) -> impl Iterator<Item = Cell> {
    let columns = catalogue.shown.iter().filter(|of| of.sheet_width.is_some());
    columns.map(move |of| match catalogue.get(of.quantity).amount(setup, summary) {
        Amount::Number(value) => Cell::Number(of.scale.of(value)),
        Amount::Flag(value) => Cell::Flag(value),
        Amount::Word(word) => word.into(),
        Amount::Missing => Cell::Empty,
    })
}

/// Number of head lines of a sheet: names and units.
const HEAD_ROWS: u32 = 2;
/// Largest number of characters across a printed page.
const PAGE_WIDTH: f64 = 190.0;
/// Width of a bold letter divided by the width of a digit.
const BOLD: f64 = 1.2;
/// Height of a line of text in a cell (points).
const LINE: f64 = 15.0;
/// Excel's number for the paper size ISO A4.
const A4: u8 = 9;

/// Writes a sheet that is one table. The heads and the first columns stay in view and are repeated on each printed
/// page.
pub(super) fn sheet_of(
    sheet: &mut Worksheet,
    name: &str,
    heads: &[Head<'_>],
    rows: impl IntoIterator<Item = Vec<Cell>>,
    fixed_columns: u16,
) -> Result<(), XlsxError> {
    sheet.set_name(name)?;
    let end = table(sheet, 0, heads, rows)?;
    sheet.set_freeze_panes(HEAD_ROWS, fixed_columns)?;
    sheet.set_repeat_rows(0, HEAD_ROWS - 1)?;
    let columns = u16::try_from(heads.len()).expect("few columns");
    // From the units on: Excel takes the first row of the range as the head of the filter.
    if end > HEAD_ROWS {
        sheet.autofilter(HEAD_ROWS - 1, 0, end - 1, columns - 1)?;
    }
    if fixed_columns > 0 {
        sheet.set_repeat_columns(0, fixed_columns - 1)?;
    }
    let width: f64 = heads.iter().map(|Head(.., width)| width).sum();
    print_on_a4(sheet, name, 1 + (width / PAGE_WIDTH) as u16);
    Ok(())
}

/// Has the sheet printed on A4 landscape, `papers` pages side by side, with name and page number at the foot of each
/// page.
pub(super) fn print_on_a4(sheet: &mut Worksheet, name: &str, papers: u16) {
    sheet.set_paper_size(A4);
    sheet.set_landscape();
    sheet.set_print_fit_to_pages(papers, 0);
    sheet.set_footer(format!("&L{name}&RPage &P of &N"));
}

/// Writes heads and rows of a table from row `top` on, and returns the row after the last. The row below the heads has
/// the units.
pub(super) fn table(
    sheet: &mut Worksheet,
    top: u32,
    heads: &[Head<'_>],
    rows: impl IntoIterator<Item = Vec<Cell>>,
) -> Result<u32, XlsxError> {
    let tint = Color::RGB(0x00F3_F6F9);
    let head = at_top().set_text_wrap().set_bold().set_background_color(tint);
    let unit = Format::new().set_font_color(Color::RGB(0x005B_6675));
    let unit = unit.set_background_color(tint).set_border_bottom(FormatBorder::Thin);
    let mut lines = 1.0;
    for (column, Head(name, symbol, width)) in (0_u16..).zip(heads) {
        // Over the numbers of a column, which stand to the right.
        let side = |format: &Format| match *symbol {
            "" | "-" => format.clone().set_align(FormatAlign::Left).set_indent(1),
            _ => format.clone().set_align(FormatAlign::Right),
        };
        sheet.write_string_with_format(top, column, *name, &side(&head))?;
        sheet.write_string_with_format(top + 1, column, *symbol, &side(&unit))?;
        sheet.set_column_width(column, *width)?;
        lines = greater(lines, lines_of(name, *width));
    }
    sheet.set_row_height(top, LINE * lines)?;
    let formats: Vec<Format> = heads.iter().map(|Head(_, unit, _)| format_of(unit)).collect();
    let mut row = top + HEAD_ROWS;
    for cells in rows {
        for ((column, format), cell) in (0_u16..).zip(&formats).zip(cells) {
            put(sheet, (row, column), &cell, format)?;
        }
        row += 1;
    }
    Ok(row)
}

/// Number of lines of a bold head that wraps between words in a column of the given width (characters).
fn lines_of(head: &str, width: f64) -> f64 {
    let (mut lines, mut used) = (1.0, 0.0);
    for word in head.split(' ') {
        let length = BOLD * word.chars().count() as f64;
        if used > 0.0 && used + 1.0 + length > width {
            (lines, used) = (lines + 1.0, 0.0);
        }
        used += length + if used > 0.0 { 1.0 } else { 0.0 };
    }
    lines
}

/// Writes a cell. `format` is the number format for the unit of the cell's column.
pub(super) fn put(
    sheet: &mut Worksheet,
    (row, column): (u32, u16),
    cell: &Cell,
    format: &Format,
) -> Result<(), XlsxError> {
    match cell {
        // As a text, never as a formula.
        Cell::Text(text) => sheet.write_string_with_format(row, column, text, &wrapped())?,
        Cell::Number(value) => sheet.write_number_with_format(row, column, *value, format)?,
        Cell::Of(value, unit) => {
            sheet.write_number_with_format(row, column, *value, &format_of(unit))?
        }
        Cell::Flag(value) => {
            let middle = at_top().set_align(FormatAlign::Center);
            sheet.write_boolean_with_format(row, column, *value, &middle)?
        }
        Cell::Empty => return Ok(()),
    };
    Ok(())
}

/// The format of a text that wraps in its column.
fn wrapped() -> Format {
    at_top().set_text_wrap().set_align(FormatAlign::Left).set_indent(1)
}

fn at_top() -> Format {
    Format::new().set_align(FormatAlign::Top)
}

/// The number format of a unit; the cells themselves hold all digits.
pub(super) fn format_of(unit: &str) -> Format {
    let digits = match unit {
        "mm" | "kN·s" | "N" | "J" | "N·m" | "N·s" | "N/m²" => "#,##0",
        "kN" | "t" | "kJ (kN·m)" | "kN·m" | "kN/m²" | "MN/m" => "#,##0.0",
        "%" => "0.0",
        "s" => "0.0##",
        "kn" | "deg" | "deg/min" => "0.00",
        "m" | "m/s" | "–" => "0.000",
        "1" | "rad" | "rad/s" => "0.00000",
        _ => return at_top(),
    };
    at_top().set_num_format(digits)
}

#[cfg(test)]
mod tests {
    use super::lines_of;

    #[test]
    fn a_head_wraps_between_its_words() {
        assert_eq!(lines_of("Reaction", 11.0), 1.0);
        assert_eq!(lines_of("Approach speed", 10.0), 2.0);
        assert_eq!(lines_of("Largest turn of the panel", 12.0), 3.0);
        assert_eq!(lines_of("Penetration", 4.0), 1.0);
    }
}
