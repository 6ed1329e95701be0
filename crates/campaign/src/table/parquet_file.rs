//! Reads tables that are Apache Parquet files.

use std::fs::File;
use std::path::Path;

use fenderline_scenario::open_regular;
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{ByteArray, DataType};
use parquet::errors::ParquetError;
use parquet::file::reader::{FileReader as _, SerializedFileReader};

use super::error::{TableError, TableFault};
use super::head::Head;
use super::{LARGEST_BYTES, Numbers, Texts};

/// Number of rows that are read at once.
const BATCH: usize = 1 << 14;

/// Key in the metadata of fenderline's tables that holds the units and meanings of the columns.
const COLUMN_KEY: &str = "fenderline.column.";

/// The heads of a table, with the units from its metadata, or else from the column names, as in `energy [kJ]`.
pub(super) fn heads(path: &Path) -> Result<Vec<Head>, TableError> {
    let reader = reader(path)?;
    let metadata = reader.metadata().file_metadata();
    let schema = metadata.schema_descr();
    let facts = metadata.key_value_metadata();
    let fact = |name: &str| {
        let key = format!("{COLUMN_KEY}{name}");
        facts
            .into_iter()
            .flatten()
            .find(|fact| fact.key == key)
            .and_then(|fact| fact.value.as_deref())
    };
    let head = |index: usize| {
        let column = schema.column(index);
        if column.max_rep_level() > 0 || column.path().parts().len() > 1 {
            let column = column.path().string();
            return Err(TableError::new(path, TableFault::NotPlain { column }));
        }
        let name = column.name();
        Ok(match fact(name).and_then(|text| text.split_once("; ")) {
            Some((unit, meaning)) => {
                Head { name: name.to_owned(), unit: unit.to_owned(), meaning: meaning.to_owned() }
            }
            None => Head::of_text(name),
        })
    };
    (0..schema.num_columns()).map(head).collect()
}

/// A column as numbers.
pub(super) fn numbers(path: &Path, place: usize, column: &str) -> Result<Numbers, TableError> {
    let mut numbers = Numbers { values: Vec::new(), missing: 0 };
    let mut row = 0;
    each(path, place, column, |cell| {
        row += 1;
        let value = match cell {
            Cell::Missing => f64::NAN,
            Cell::Flag(flag) => f64::from(u8::from(flag)),
            Cell::Number(value) if value.is_finite() || value.is_nan() => value,
            other => {
                let (column, text) = (column.to_owned(), other.shown());
                let fault = TableFault::NotANumber { column, line: row, text };
                return Err(TableError::new(path, fault));
            }
        };
        numbers.missing += usize::from(value.is_nan());
        numbers.values.push(value);
        Ok(())
    })?;
    Ok(numbers)
}

/// A column as texts.
pub(super) fn texts(path: &Path, place: usize, column: &str) -> Result<Texts, TableError> {
    let mut texts = Texts::default();
    each(path, place, column, |cell| {
        texts.push(&cell.shown());
        Ok(())
    })?;
    Ok(texts)
}

/// A cell.
enum Cell {
    Missing,
    Number(f64),
    Flag(bool),
    Text(String),
}

impl Cell {
    fn shown(&self) -> String {
        match self {
            Cell::Missing => String::new(),
            Cell::Number(value) => format!("{value}"),
            Cell::Flag(flag) => format!("{flag}"),
            Cell::Text(text) => text.clone(),
        }
    }
}

fn reader(path: &Path) -> Result<SerializedFileReader<File>, TableError> {
    let file = open_regular(path, LARGEST_BYTES)
        .map_err(|e| TableError::new(path, TableFault::File(e)))?;
    SerializedFileReader::new(file).map_err(|why| TableError::damaged(path, why))
}

/// Calls `use_cell` with each cell of a column, row group by row group.
fn each(
    path: &Path,
    place: usize,
    column: &str,
    mut use_cell: impl FnMut(Cell) -> Result<(), TableError>,
) -> Result<(), TableError> {
    let reader = reader(path)?;
    let damaged = |why: ParquetError| TableError::damaged(path, why);
    for group in 0..reader.num_row_groups() {
        let group = reader.get_row_group(group).map_err(damaged)?;
        let is_optional = group.metadata().column(place).column_descr().max_def_level() > 0;
        let number = Cell::Number;
        match group.get_column_reader(place).map_err(damaged)? {
            ColumnReader::DoubleColumnReader(column) => {
                read(column, is_optional, number, &mut use_cell, path)?;
            }
            ColumnReader::FloatColumnReader(column) => {
                read(column, is_optional, |v| number(f64::from(v)), &mut use_cell, path)?;
            }
            ColumnReader::Int32ColumnReader(column) => {
                read(column, is_optional, |v| number(f64::from(v)), &mut use_cell, path)?;
            }
            ColumnReader::Int64ColumnReader(column) => {
                read(column, is_optional, |v| number(v as f64), &mut use_cell, path)?;
            }
            ColumnReader::BoolColumnReader(column) => {
                read(column, is_optional, Cell::Flag, &mut use_cell, path)?;
            }
            ColumnReader::ByteArrayColumnReader(column) => {
                let text =
                    |v: ByteArray| Cell::Text(String::from_utf8_lossy(v.data()).into_owned());
                read(column, is_optional, text, &mut use_cell, path)?;
            }
            _ => {
                let column = column.to_owned();
                return Err(TableError::new(path, TableFault::NotPlain { column }));
            }
        }
    }
    Ok(())
}

/// Reads all cells of a column in a row group.
fn read<T: DataType>(
    mut column: ColumnReaderImpl<T>,
    is_optional: bool,
    cell: impl Fn(T::T) -> Cell,
    use_cell: &mut impl FnMut(Cell) -> Result<(), TableError>,
    path: &Path,
) -> Result<(), TableError> {
    let mut values = Vec::with_capacity(BATCH);
    let mut levels: Vec<i16> = Vec::with_capacity(BATCH);
    loop {
        values.clear();
        levels.clear();
        let levels_wanted = is_optional.then_some(&mut levels);
        let (rows, ..) = column
            .read_records(BATCH, levels_wanted, None, &mut values)
            .map_err(|why| TableError::damaged(path, why))?;
        if rows == 0 {
            return Ok(());
        }
        if !is_optional {
            values.drain(..).try_for_each(|value| use_cell(cell(value)))?;
            continue;
        }
        let mut present = values.drain(..);
        for level in &levels {
            use_cell(match level {
                0 => Cell::Missing,
                _ => present.next().map_or(Cell::Missing, &cell),
            })?;
        }
    }
}
