//! Writes the tables of a campaign, with a row for each run.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

use parquet::basic::Compression;
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::parser::parse_message_type;
use parquet::schema::types::{Type, TypePtr};

use super::whole;
use crate::error::CampaignError;
use crate::row::{Cell, Head, Row};
use crate::run::Runs;

/// File name of the table of all runs.
pub const TABLE_PARQUET: &str = "cases.parquet";
/// File name of the table of all runs as text.
pub const TABLE_CSV: &str = "cases.csv";
/// Largest number of rows of the table as text.
pub const MOST_CSV_ROWS: u64 = 100_000;
/// Number of rows of a row group, which is held in memory.
const ROWS_PER_GROUP: usize = 1 << 15;

/// A function that calls the given function with each row in order.
pub type EachRow<'a> = &'a mut dyn FnMut(
    &mut dyn FnMut(&Row) -> Result<(), CampaignError>,
) -> Result<(), CampaignError>;

/// Writes the tables of `count` rows into a folder; `each` gives the rows in the order of the runs, as often as it is
/// called.
///
/// # Errors
/// Fails with an error of the disk, or with the error that `each` returns.
pub fn write_tables(
    folder: &Path,
    runs: &Runs,
    count: u64,
    each: EachRow<'_>,
) -> Result<(), CampaignError> {
    let heads = runs.heads();
    let csv = folder.join(TABLE_CSV);
    if count <= MOST_CSV_ROWS {
        whole::write(&csv, |file| write_csv(file, "case", heads, &csv, each))?;
    }
    let path = folder.join(TABLE_PARQUET);
    let facts = [
        ("title", runs.campaign().title.clone()),
        ("scenario", runs.base().title.clone()),
        ("plan", runs.campaign().plan.word().to_owned()),
        ("seed", runs.campaign().seed.to_string()),
    ];
    let about = About { first: "case", facts: &facts };
    whole::write(&path, |file| write_parquet(file, &about, heads, &path, each))
}

/// What a table says about itself: the name of its first column, which numbers the rows, and facts for the metadata of
/// a Parquet file.
#[derive(Clone, Copy, Debug)]
pub struct About<'a> {
    /// Name of the first column.
    pub first: &'a str,
    /// Facts with their names.
    pub facts: &'a [(&'a str, String)],
}

/// Writes a table of rows to a file: Parquet if the name of the file ends in `.parquet`, else text with commas.
///
/// # Errors
/// Fails with an error of the disk.
pub fn write_rows(
    path: &Path,
    about: &About<'_>,
    heads: &[Head],
    rows: &[Row],
) -> Result<(), CampaignError> {
    let each: EachRow<'_> = &mut |add| rows.iter().try_for_each(&mut *add);
    let is_parquet = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("parquet"));
    whole::write(path, |file| match is_parquet {
        true => write_parquet(file, about, heads, path, each),
        false => write_csv(file, about.first, heads, path, each),
    })
}

fn write_csv(
    file: &mut BufWriter<File>,
    first: &str,
    heads: &[Head],
    path: &Path,
    each: EachRow<'_>,
) -> Result<(), CampaignError> {
    let failed = |error: csv::Error| CampaignError::folder(path, error);
    let mut writer = csv::Writer::from_writer(file);
    let named = |head: &Head| match head.unit.as_str() {
        "" => head.name.clone(),
        unit => format!("{} [{unit}]", head.name),
    };
    let titles = [first.to_owned()].into_iter().chain(heads.iter().map(named));
    writer.write_record(titles).map_err(failed)?;
    each(&mut |row| {
        let cells =
            [format!("{}", row.run + 1)].into_iter().chain(row.cells.iter().map(Cell::shown));
        writer.write_record(cells).map_err(failed)
    })?;
    writer.flush().map_err(|error| CampaignError::disk(path, &error))
}

/// The values of a column in the current row group.
enum Column {
    Numbers(Vec<f64>),
    Texts(Vec<ByteArray>),
}

impl Column {
    fn push(&mut self, cell: &Cell) {
        match self {
            Column::Numbers(values) => values.push(cell.number().unwrap_or(f64::NAN)),
            Column::Texts(values) => values.push(match cell {
                Cell::Text(text) => ByteArray::from(text.as_str()),
                other => ByteArray::from(other.shown().as_str()),
            }),
        }
    }
}

fn write_parquet(
    file: &mut BufWriter<File>,
    about: &About<'_>,
    heads: &[Head],
    path: &Path,
    each: EachRow<'_>,
) -> Result<(), CampaignError> {
    let failed = |error: ParquetError| CampaignError::folder(path, error);
    let facts = about
        .facts
        .iter()
        .map(|(key, value)| KeyValue::new(format!("fenderline.{key}"), value.clone()));
    let columns = heads.iter().map(|head| {
        let text = format!("{}; {}", head.unit, head.meaning);
        KeyValue::new(format!("fenderline.column.{}", head.name), text)
    });
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_created_by(format!("fenderline {}", env!("CARGO_PKG_VERSION")))
        .set_key_value_metadata(Some(facts.chain(columns).collect()))
        .build();
    let schema = schema(about.first, heads).map_err(failed)?;
    let mut writer =
        SerializedFileWriter::new(file, schema, Arc::new(properties)).map_err(failed)?;
    let mut numbers: Vec<i64> = Vec::new();
    let mut values: Vec<Column> = heads
        .iter()
        .map(
            |head| {
                if head.is_text { Column::Texts(Vec::new()) } else { Column::Numbers(Vec::new()) }
            },
        )
        .collect();
    each(&mut |row| {
        numbers.push(row.run as i64 + 1);
        for (column, cell) in values.iter_mut().zip(&row.cells) {
            column.push(cell);
        }
        if numbers.len() == ROWS_PER_GROUP {
            write_group(&mut writer, &mut numbers, &mut values).map_err(failed)?;
        }
        Ok(())
    })?;
    if !numbers.is_empty() {
        write_group(&mut writer, &mut numbers, &mut values).map_err(failed)?;
    }
    writer.finish().map_err(failed)?;
    Ok(())
}

/// The schema of the Parquet file: the column of numbers of rows, then a column for each head. Names may have any characters, so
/// the schema is not written as text.
fn schema(first: &str, heads: &[Head]) -> Result<TypePtr, ParquetError> {
    let plain = parse_message_type(
        "message m { REQUIRED INT64 case; REQUIRED DOUBLE number; REQUIRED BYTE_ARRAY text (STRING); }",
    )?;
    let [case, number, text] = plain.get_fields() else { unreachable!("three fields") };
    let named = |model: &TypePtr, name: &str| -> Result<TypePtr, ParquetError> {
        let info = model.get_basic_info();
        let own = Type::primitive_type_builder(name, model.get_physical_type())
            .with_repetition(info.repetition())
            .with_logical_type(info.logical_type_ref().cloned())
            .with_converted_type(info.converted_type())
            .build()?;
        Ok(Arc::new(own))
    };
    let mut fields = vec![named(case, first)?];
    for head in heads {
        fields.push(named(if head.is_text { text } else { number }, &head.name)?);
    }
    Ok(Arc::new(Type::group_type_builder("cases").with_fields(fields).build()?))
}

fn write_group<W: Write + Send>(
    writer: &mut SerializedFileWriter<W>,
    numbers: &mut Vec<i64>,
    values: &mut [Column],
) -> Result<(), ParquetError> {
    let mut group = writer.next_row_group()?;
    let mut next =
        |fill: &mut dyn FnMut(SerializedColumnWriter<'_>) -> Result<(), ParquetError>| {
            let column = group.next_column()?;
            fill(column.expect("the schema has every column"))
        };
    next(&mut |column| write_chunk::<Int64Type>(column, numbers))?;
    for own in values {
        match own {
            Column::Numbers(all) => next(&mut |column| write_chunk::<DoubleType>(column, all))?,
            Column::Texts(all) => next(&mut |column| write_chunk::<ByteArrayType>(column, all))?,
        }
    }
    group.close()?;
    Ok(())
}

fn write_chunk<T: DataType>(
    mut column: SerializedColumnWriter<'_>,
    values: &mut Vec<T::T>,
) -> Result<(), ParquetError> {
    column.typed::<T>().write_batch(values, None, None)?;
    values.clear();
    column.close()
}
