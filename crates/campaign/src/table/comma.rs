//! Reads tables that are text with separators, such as csv files.

use std::borrow::Cow;
use std::fs::File;
use std::io::{BufRead as _, BufReader};
use std::path::Path;

use fenderline_scenario::open_regular;

use super::error::{TableError, TableFault};
use super::head::Head;
use super::{LARGEST_BYTES, Numbers, Texts, cell};

/// Number of bytes within which the head line of a file must end.
const HEAD_BYTES: u64 = 1 << 20;

/// The byte order mark that some programs put before a text.
const BYTE_ORDER_MARK: &str = "\u{feff}";

/// The heads of a table and its separator.
pub(super) fn heads(path: &Path) -> Result<(Vec<Head>, u8), TableError> {
    let separator = separator(path)?;
    let mut reader = reader(path, separator)?;
    let record = reader.byte_headers().map_err(|why| damaged(path, &why))?;
    let cells: Vec<String> = record
        .iter()
        .map(|cell| text_of(cell).trim_start_matches(BYTE_ORDER_MARK).to_owned())
        .collect();
    if cells.iter().all(|cell| cell.trim().is_empty()) {
        return Err(TableError::new(path, TableFault::NoHead { number: None }));
    }
    let is_number = |cell: &&String| {
        !cell.trim().is_empty() && cell::number(cell, separator == b';').is_ok_and(f64::is_finite)
    };
    if let Some(number) = cells.iter().find(is_number) {
        let number = Some(number.clone());
        return Err(TableError::new(path, TableFault::NoHead { number }));
    }
    Ok((cells.iter().map(|cell| Head::of_text(cell)).collect(), separator))
}

/// Reads a column as numbers; the error names the first line that is refused.
pub(super) fn numbers(
    path: &Path,
    separator: u8,
    place: usize,
    column: &str,
) -> Result<Numbers, TableError> {
    let mut numbers = Numbers { values: Vec::new(), missing: 0 };
    each(path, separator, place, |line, text| {
        let value = cell::number(text, separator == b';').map_err(|()| {
            let (column, text) = (column.to_owned(), text.to_owned());
            TableError::new(path, TableFault::NotANumber { column, line, text })
        })?;
        numbers.missing += usize::from(value.is_nan());
        numbers.values.push(value);
        Ok(())
    })?;
    Ok(numbers)
}

/// Reads a column as texts.
pub(super) fn texts(path: &Path, separator: u8, place: usize) -> Result<Texts, TableError> {
    let mut texts = Texts::default();
    each(path, separator, place, |_, text| {
        texts.push(text);
        Ok(())
    })?;
    Ok(texts)
}

/// Calls `use_cell` with line and text of each cell of a column.
fn each(
    path: &Path,
    separator: u8,
    place: usize,
    mut use_cell: impl FnMut(u64, &str) -> Result<(), TableError>,
) -> Result<(), TableError> {
    let mut reader = reader(path, separator)?;
    let mut record = csv::ByteRecord::new();
    loop {
        match reader.read_byte_record(&mut record) {
            Ok(false) => return Ok(()),
            Ok(true) => {
                let line = record.position().map_or(0, csv::Position::line);
                use_cell(line, &text_of(record.get(place).unwrap_or_default()))?;
            }
            Err(why) => return Err(damaged(path, &why)),
        }
    }
}

/// A line of a text, and the place of a cell in the line.
pub(super) struct Line {
    /// Number of the line, counted from 1.
    pub(super) number: usize,
    pub(super) text: String,
    /// Place of the cell in the line, counted from 1 in characters.
    pub(super) column: usize,
    /// Length of the cell in characters.
    pub(super) length: usize,
}

/// Finds the line of a row (counted from 0) and the cell of a column in this line; `None` if the file cannot be read
/// any more or has no such row.
pub(super) fn line_of_row(path: &Path, separator: u8, place: usize, row: usize) -> Option<Line> {
    let mut reader = reader(path, separator).ok()?;
    let record = reader.byte_records().nth(row)?.ok()?;
    let after = usize::try_from(record.position()?.line()).ok()?;
    // The reader's position is before the empty lines that it skips.
    let lines = BufReader::new(open(path).ok()?).split(b'\n').enumerate().skip(after - 1);
    let is_empty = |line: &[u8]| line.iter().all(|byte| *byte == b'\r');
    let (index, line) = lines
        .map_while(|(index, line)| Some((index, line.ok()?)))
        .find(|(_, line)| !is_empty(line))?;
    let text = text_of(&line).trim_end().to_owned();
    let cells: Vec<&str> = text.split(char::from(separator)).collect();
    let (before, length) = match cells.get(place) {
        // A separator may be in quotes.
        Some(cell) if !text.contains('"') => {
            let earlier = cells[..place].iter().map(|cell| cell.chars().count() + 1);
            (earlier.sum(), cell.chars().count())
        }
        _ => (0, text.chars().count()),
    };
    Some(Line { number: index + 1, text, column: before + 1, length })
}

/// The text of a cell. Text that is not UTF-8 is taken as Latin-1, which older programs write.
fn text_of(cell: &[u8]) -> Cow<'_, str> {
    match str::from_utf8(cell) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(cell.iter().map(|byte| char::from(*byte)).collect()),
    }
}

/// Turns an error of the csv reader into ours; a line with a wrong number of cells gets its own words.
fn damaged(path: &Path, why: &csv::Error) -> TableError {
    match why.kind() {
        csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
            let line = pos.as_ref().map_or(0, csv::Position::line);
            TableError::new(
                path,
                TableFault::UnequalLines { line, cells: *len, heads: *expected_len },
            )
        }
        _ => TableError::damaged(path, why),
    }
}

fn open(path: &Path) -> Result<File, TableError> {
    open_regular(path, LARGEST_BYTES).map_err(|e| TableError::new(path, TableFault::File(e)))
}

fn reader(path: &Path, separator: u8) -> Result<csv::Reader<File>, TableError> {
    Ok(csv::ReaderBuilder::new().delimiter(separator).from_reader(open(path)?))
}

/// The separator of the head line: a tab or a semicolon if the line has one, else a comma.
fn separator(path: &Path) -> Result<u8, TableError> {
    use std::io::Read as _;
    let mut start = Vec::new();
    open(path)?
        .take(HEAD_BYTES)
        .read_to_end(&mut start)
        .map_err(|why| TableError::damaged(path, why))?;
    let line = start.split(|byte| *byte == b'\n').next().unwrap_or_default();
    Ok([b'\t', b';'].into_iter().find(|sought| line.contains(sought)).unwrap_or(b','))
}
