//! The tables of a run as files.

use fenderline_results::{Column, Medium, Names, Table};

use super::part_file::{Folder, Sealed};
use super::{Format, OutputError, csv, parquet};

/// Where and how the tables of a run are written.
pub(super) struct Files<'a> {
    pub(super) folder: &'a Folder,
    pub(super) format: Format,
    /// Keys and values for the metadata of the tables, if the format has metadata.
    pub(super) facts: &'a [(&'a str, String)],
}

/// The file of one table, in the chosen format.
pub(super) enum TableFile<R> {
    Csv(csv::CsvTable<R>),
    Parquet(parquet::ParquetTable<R>),
}

impl Medium for Files<'_> {
    type Error = OutputError;
    type Done = Sealed;
    type Table<R> = TableFile<R>;

    fn start<R>(
        &self,
        name: &'static str,
        columns: Vec<Column<R>>,
        names: &Names,
    ) -> Result<TableFile<R>, OutputError> {
        let file = self.folder.create(&format!("{name}.{}", self.format.extension()))?;
        Ok(match self.format {
            Format::Csv => TableFile::Csv(csv::CsvTable::create(file, columns, names.clone())?),
            Format::Parquet => {
                let table = parquet::ParquetTable::create(file, name, columns, names, self.facts)?;
                TableFile::Parquet(table)
            }
        })
    }
}

impl<R> Table<R> for TableFile<R> {
    type Error = OutputError;
    type Done = Sealed;

    fn push(&mut self, row: &R) -> Result<(), OutputError> {
        match self {
            TableFile::Csv(table) => table.push(row),
            TableFile::Parquet(table) => table.push(row),
        }
    }

    /// Syncs the table's file to the disk; the file keeps its `.part` name.
    fn finish(self) -> Result<Sealed, OutputError> {
        match self {
            TableFile::Csv(table) => table.finish(),
            TableFile::Parquet(table) => table.finish(),
        }
    }
}
