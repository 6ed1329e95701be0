//! Tables as Apache Parquet files.

use core::fmt::Write as _;
use std::path::PathBuf;
use std::sync::Arc;

use fenderline_results::{Column, Names, Value};
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

/// Rows held in memory before they are written: about 6 MB a table.
const ROWS_PER_GROUP: usize = 1 << 16;

/// A parquet file being written.
pub(super) struct ParquetTable<R> {
    writer: SerializedFileWriter<PartFile>,
    path: PathBuf,
    columns: Vec<Column<R>>,
    /// Values of the current row group, one store a column.
    stores: Vec<Store>,
    names: Names,
    rows: usize,
}

/// Values of one column.
enum Store {
    Float(Vec<f64>),
    Text(Vec<ByteArray>),
    Flag(Vec<bool>),
    Count(Vec<i32>),
}

impl Store {
    fn for_value<R>(value: &Value<R>) -> Store {
        match value {
            Value::Float(_) | Value::Known(_) => Store::Float(Vec::new()),
            Value::Name(..) | Value::Word(_) => Store::Text(Vec::new()),
            Value::Flag(_) => Store::Flag(Vec::new()),
            Value::Count(_) => Store::Count(Vec::new()),
        }
    }

    /// Type in the language of parquet's schemas.
    fn schema_type(&self) -> (&'static str, &'static str) {
        match self {
            Store::Float(_) => ("DOUBLE", ""),
            Store::Text(_) => ("BYTE_ARRAY", " (STRING)"),
            Store::Flag(_) => ("BOOLEAN", ""),
            Store::Count(_) => ("INT32", ""),
        }
    }

    /// Writes the values as one column chunk and forgets them.
    fn write(&mut self, column: SerializedColumnWriter<'_>) -> Result<(), ParquetError> {
        match self {
            Store::Float(values) => write_chunk::<DoubleType>(column, values),
            Store::Text(values) => write_chunk::<ByteArrayType>(column, values),
            Store::Flag(values) => write_chunk::<BoolType>(column, values),
            Store::Count(values) => write_chunk::<Int32Type>(column, values),
        }
    }
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
    /// Starts a table called `name` in `file`; `facts` go to its metadata beside the columns' units
    /// and meanings.
    pub(super) fn create(
        file: PartFile,
        name: &str,
        columns: Vec<Column<R>>,
        names: &Names,
        facts: &[(&str, String)],
    ) -> Result<ParquetTable<R>, OutputError> {
        let path = file.path().to_owned();
        let stores: Vec<Store> = columns.iter().map(|c| Store::for_value(&c.value)).collect();
        let mut schema = format!("message {name} {{");
        for (column, store) in columns.iter().zip(&stores) {
            let (physical, logical) = store.schema_type();
            let _ = write!(schema, " REQUIRED {physical} {}{logical};", column.name);
        }
        schema.push_str(" }");
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_created_by(format!("fenderline {}", env!("CARGO_PKG_VERSION")))
            .set_key_value_metadata(Some(metadata(&columns, facts)))
            .build();
        let writer = parse_message_type(&schema)
            .and_then(|schema| {
                SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))
            })
            .map_err(|e| OutputError::new(&path, e))?;
        Ok(ParquetTable { writer, path, columns, stores, names: names.clone(), rows: 0 })
    }

    /// Adds a row.
    pub(super) fn push(&mut self, row: &R) -> Result<(), OutputError> {
        for (column, store) in self.columns.iter().zip(&mut self.stores) {
            match (&column.value, store) {
                (Value::Float(_) | Value::Known(_), Store::Float(values)) => {
                    let value = column.value.number(row);
                    if let Some(value) = value.filter(|value| !value.is_finite()) {
                        return Err(not_finite(self.writer.inner(), column.name, value));
                    }
                    values.push(value.unwrap_or(f64::NAN));
                }
                (Value::Name(list, index), Store::Text(values)) => {
                    values.push(ByteArray::from(self.names.get(*list, index(row))));
                }
                (Value::Word(word), Store::Text(values)) => {
                    values.push(ByteArray::from(word(row)));
                }
                (Value::Flag(flag), Store::Flag(values)) => values.push(flag(row)),
                (Value::Count(count), Store::Count(values)) => {
                    // Patches are numbered from 0; a pair never has 2³¹ of them.
                    values.push(i32::try_from(count(row)).unwrap_or(i32::MAX));
                }
                _ => unreachable!("every store was made for its column"),
            }
        }
        self.rows += 1;
        if self.rows == ROWS_PER_GROUP { self.write_group() } else { Ok(()) }
    }

    fn write_group(&mut self) -> Result<(), OutputError> {
        self.rows = 0;
        let written = (|| {
            let mut group = self.writer.next_row_group()?;
            for store in &mut self.stores {
                let column = group.next_column()?;
                store.write(column.expect("as many columns as stores"))?;
            }
            group.close()?;
            Ok::<(), ParquetError>(())
        })();
        written.map_err(|e| OutputError::new(&self.path, e))
    }

    /// Writes what is held and the footer, and brings the file to the disk, still under its
    /// `.part` name.
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
