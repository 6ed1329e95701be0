//! Tables as comma-separated text.

use std::io::Write as _;

use fenderline_results::{Column, Names, Value};

use super::OutputError;
use super::part_file::{PartFile, Sealed};

/// A csv file being written.
pub(super) struct CsvTable<R> {
    writer: csv::Writer<PartFile>,
    columns: Vec<Column<R>>,
    names: Names,
    /// The text of one field; the buffer is kept, so that a field needs no new allocation.
    field: Vec<u8>,
}

impl<R> CsvTable<R> {
    /// Starts a csv table and writes its header to `file`.
    pub(super) fn create(
        file: PartFile,
        columns: Vec<Column<R>>,
        names: Names,
    ) -> Result<CsvTable<R>, OutputError> {
        let path = file.path().to_owned();
        let mut writer = csv::Writer::from_writer(file);
        writer
            .write_record(columns.iter().map(|c| c.name))
            .map_err(|e| OutputError::new(&path, e))?;
        Ok(CsvTable { writer, columns, names, field: Vec::with_capacity(32) })
    }

    /// Adds a row.
    pub(super) fn push(&mut self, row: &R) -> Result<(), OutputError> {
        for column in &self.columns {
            self.field.clear();
            match column.value {
                Value::Float(_) | Value::Nth(..) | Value::Known(_) => {
                    if let Some(value) = column.value.number(row) {
                        if !value.is_finite() {
                            return Err(not_finite(self.writer.get_ref(), column.name, value));
                        }
                        // Debug is the shortest form that reads back to the same bits, with an
                        // exponent for very large and very small numbers.
                        let _ = write!(self.field, "{value:?}");
                    }
                }
                Value::Name(list, index) => {
                    self.field.extend_from_slice(self.names.get(list, index(row)).as_bytes());
                }
                Value::Word(word) => self.field.extend_from_slice(word(row).as_bytes()),
                Value::Flag(flag) => {
                    let _ = write!(self.field, "{}", flag(row));
                }
                Value::Count(count) => {
                    let _ = write!(self.field, "{}", count(row));
                }
            }
            self.writer
                .write_field(&self.field)
                .map_err(|e| OutputError::new(self.writer.get_ref().path(), e))?;
        }
        self.writer
            .write_record(None::<&[u8]>)
            .map_err(|e| OutputError::new(self.writer.get_ref().path(), e))
    }

    /// Syncs the csv file to the disk; the file keeps its `.part` name.
    pub(super) fn finish(self) -> Result<Sealed, OutputError> {
        let path = self.writer.get_ref().path().to_owned();
        let file = self.writer.into_inner().map_err(|e| OutputError::new(&path, e.error()))?;
        file.seal()
    }
}

pub(super) fn not_finite(file: &PartFile, column: &str, value: f64) -> OutputError {
    OutputError::new(file.path(), format_args!("the simulation gave {value} for `{column}`"))
}
