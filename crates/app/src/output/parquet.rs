//! Tables as Apache Parquet files.

use core::fmt::Write as _;
use std::path::PathBuf;
use std::sync::Arc;

use fenderline_results::{Column, List, Names, Value};
use parquet::basic::Compression;
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int32Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::parser::parse_message_type;

use super::OutputError;
use super::csv::not_finite;
use super::part_file::{PartFile, Sealed};

/// Number of rows held in memory before they are written, about 6 MB for each table.
const ROWS_PER_GROUP: usize = 1 << 16;

/// A parquet file being written.
pub(super) struct ParquetTable<R> {
    writer: SerializedFileWriter<PartFile>,
    path: PathBuf,
    columns: Vec<Filled<R>>,
    names: Names,
    rows: usize,
}

/// A column of a table, and its values in the current row group.
struct Filled<R> {
    name: &'static str,
    values: Filling<R>,
}

/// The source of a column's values, and the values of the current row group.
enum Filling<R> {
    Float(fn(&R) -> f64, Vec<f64>),
    Nth(usize, fn(&R, usize) -> f64, Vec<f64>),
    Known(fn(&R) -> Option<f64>, Vec<f64>),
    Name(List, fn(&R) -> Option<usize>, Vec<ByteArray>),
    Word(fn(&R) -> &'static str, Vec<ByteArray>),
    Flag(fn(&R) -> bool, Vec<bool>),
    Count(fn(&R) -> u32, Vec<i32>),
}

impl<R> Filling<R> {
    fn of(value: Value<R>) -> Filling<R> {
        match value {
            Value::Float(number) => Filling::Float(number, Vec::new()),
            Value::Nth(index, number) => Filling::Nth(index, number, Vec::new()),
            Value::Known(number) => Filling::Known(number, Vec::new()),
            Value::Name(list, index) => Filling::Name(list, index, Vec::new()),
            Value::Word(word) => Filling::Word(word, Vec::new()),
            Value::Flag(flag) => Filling::Flag(flag, Vec::new()),
            Value::Count(count) => Filling::Count(count, Vec::new()),
        }
    }

    /// Type of the column, in the language of Parquet's schemas.
    fn schema_type(&self) -> (&'static str, &'static str) {
        match self {
            Filling::Float(..) | Filling::Nth(..) | Filling::Known(..) => ("DOUBLE", ""),
            Filling::Name(..) | Filling::Word(..) => ("BYTE_ARRAY", " (STRING)"),
            Filling::Flag(..) => ("BOOLEAN", ""),
            Filling::Count(..) => ("INT32", ""),
        }
    }

    /// Adds the column's value of a row.
    ///
    /// # Errors
    /// Gives the number back if it is not finite.
    fn push(&mut self, row: &R, names: &Names) -> Result<(), f64> {
        match self {
            Filling::Float(number, values) => values.push(finite(number(row))?),
            Filling::Nth(index, number, values) => values.push(finite(number(row, *index))?),
            Filling::Known(number, values) => {
                values.push(number(row).map_or(Ok(f64::NAN), finite)?);
            }
            Filling::Name(list, index, values) => {
                values.push(ByteArray::from(names.get(*list, index(row))));
            }
            Filling::Word(word, values) => values.push(ByteArray::from(word(row))),
            Filling::Flag(flag, values) => values.push(flag(row)),
            Filling::Count(count, values) => {
                // Patches are numbered from 0; a pair never has 2³¹ of them.
                values.push(i32::try_from(count(row)).unwrap_or(i32::MAX));
            }
        }
        Ok(())
    }

    /// Writes the column's values as one column chunk and forgets them.
    fn write(&mut self, column: SerializedColumnWriter<'_>) -> Result<(), ParquetError> {
        match self {
            Filling::Float(_, values) | Filling::Nth(_, _, values) | Filling::Known(_, values) => {
                write_chunk::<DoubleType>(column, values)
            }
            Filling::Name(_, _, values) | Filling::Word(_, values) => {
                write_chunk::<ByteArrayType>(column, values)
            }
            Filling::Flag(_, values) => write_chunk::<BoolType>(column, values),
            Filling::Count(_, values) => write_chunk::<Int32Type>(column, values),
        }
    }
}

fn finite(value: f64) -> Result<f64, f64> {
    if value.is_finite() { Ok(value) } else { Err(value) }
}

fn write_chunk<T: DataType>(
    mut column: SerializedColumnWriter<'_>,
    values: &mut Vec<T::T>,
) -> Result<(), ParquetError> {
    column.typed::<T>().write_batch(values, None, None)?;
    values.clear();
    column.close()
}

impl<R> ParquetTable<R> {
    /// Starts a table called `name` in `file`. The metadata of the table get `facts` beside the columns' units and
    /// meanings.
    pub(super) fn create(
        file: PartFile,
        name: &str,
        columns: Vec<Column<R>>,
        names: &Names,
        facts: &[(&str, String)],
    ) -> Result<ParquetTable<R>, OutputError> {
        let path = file.path().to_owned();
        let metadata = metadata(&columns, facts);
        let columns: Vec<Filled<R>> = columns
            .into_iter()
            .map(|column| Filled { name: column.name, values: Filling::of(column.value) })
            .collect();
        let mut schema = format!("message {name} {{");
        for column in &columns {
            let (physical, logical) = column.values.schema_type();
            let _ = write!(schema, " REQUIRED {physical} {}{logical};", column.name);
        }
        schema.push_str(" }");
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_created_by(format!("fenderline {}", env!("CARGO_PKG_VERSION")))
            .set_key_value_metadata(Some(metadata))
            .build();
        let writer = parse_message_type(&schema)
            .and_then(|schema| {
                SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))
            })
            .map_err(|e| OutputError::new(&path, e))?;
        Ok(ParquetTable { writer, path, columns, names: names.clone(), rows: 0 })
    }

    /// Adds a row.
    pub(super) fn push(&mut self, row: &R) -> Result<(), OutputError> {
        for column in &mut self.columns {
            if let Err(value) = column.values.push(row, &self.names) {
                return Err(not_finite(self.writer.inner(), column.name, value));
            }
        }
        self.rows += 1;
        if self.rows == ROWS_PER_GROUP { self.write_group() } else { Ok(()) }
    }

    fn write_group(&mut self) -> Result<(), OutputError> {
        self.rows = 0;
        let written = (|| {
            let mut group = self.writer.next_row_group()?;
            for column in &mut self.columns {
                let writer = group.next_column()?;
                column.values.write(writer.expect("the schema has every column"))?;
            }
            group.close()?;
            Ok::<(), ParquetError>(())
        })();
        written.map_err(|e| OutputError::new(&self.path, e))
    }

    /// Writes the last row group and the footer, and syncs the Parquet file to the disk; the file keeps its `.part`
    /// name.
    pub(super) fn finish(mut self) -> Result<Sealed, OutputError> {
        if self.rows > 0 {
            self.write_group()?;
        }
        let file = self.writer.into_inner().map_err(|e| OutputError::new(&self.path, e))?;
        file.seal()
    }
}

fn metadata<R>(columns: &[Column<R>], facts: &[(&str, String)]) -> Vec<KeyValue> {
    let facts =
        facts.iter().map(|(key, value)| KeyValue::new(format!("fenderline.{key}"), value.clone()));
    let columns = columns.iter().map(|column| {
        let text = format!("{}; {}", column.unit, column.meaning);
        KeyValue::new(format!("fenderline.column.{}", column.name), text)
    });
    facts.chain(columns).collect()
}
