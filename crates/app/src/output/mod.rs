//! Result files: tables of bodies and contacts, the summary, the report.
//!
//! A file has its final name only when the whole run is done and everything is on the disk; until
//! then it is called `NAME.part`. `summary.json` gets its name last of all: where it is, all of the
//! results are there.

mod columns;
mod csv;
mod parquet;
mod part_file;
mod summary;

use core::fmt;
use std::path::{Path, PathBuf};

use clap::ValueEnum;
use fenderline_sim::StepRecord;

pub(crate) use part_file::Folder;
pub(crate) use summary::{Events, Outcome, event_text, integrator_text, method_text, summary};

use columns::{BodyRow, Column, ContactRow, bodies_columns, contacts_columns};
use part_file::Sealed;

/// Every file that a run may leave; an earlier run's are removed at the start.
const RESULT_FILES: [&str; 6] =
    [SUMMARY, "bodies.csv", "bodies.parquet", "contacts.csv", "contacts.parquet", REPORT];
const SUMMARY: &str = "summary.json";
const REPORT: &str = "report.html";

/// How the tables are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Text with commas; floats in the shortest form that reads back to the same value.
    Csv,
    /// Apache Parquet, typed columns with units and meanings in the metadata.
    Parquet,
}

impl Format {
    fn extension(self) -> &'static str {
        match self {
            Format::Csv => "csv",
            Format::Parquet => "parquet",
        }
    }
}

/// A result file that could not be written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct OutputError {
    file: PathBuf,
    cause: String,
}

impl OutputError {
    fn new(file: &Path, cause: impl fmt::Display) -> OutputError {
        OutputError { file: file.to_owned(), cause: cause.to_string() }
    }
}

impl fmt::Display for OutputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "cannot write {}: {}", self.file.display(), self.cause)
    }
}

impl core::error::Error for OutputError {}

/// One table, in the format that the user asked for.
enum Table<R> {
    Csv(csv::CsvTable<R>),
    Parquet(parquet::ParquetTable<R>),
}

impl<R> Table<R> {
    fn create(
        folder: &Folder,
        format: Format,
        name: &'static str,
        columns: Vec<Column<R>>,
        body_names: &[String],
        facts: &[(&str, String)],
    ) -> Result<Table<R>, OutputError> {
        let file = folder.create(&format!("{name}.{}", format.extension()))?;
        let body_names = body_names.to_vec();
        Ok(match format {
            Format::Csv => Table::Csv(csv::CsvTable::create(file, columns, body_names)?),
            Format::Parquet => Table::Parquet(parquet::ParquetTable::create(
                file,
                name,
                columns,
                &body_names,
                facts,
            )?),
        })
    }

    fn push(&mut self, row: &R) -> Result<(), OutputError> {
        match self {
            Table::Csv(table) => table.push(row),
            Table::Parquet(table) => table.push(row),
        }
    }

    fn finish(self) -> Result<Sealed, OutputError> {
        match self {
            Table::Csv(table) => table.finish(),
            Table::Parquet(table) => table.finish(),
        }
    }
}

/// A file of the run and how many rows it has, for the summary; `None` where it is no table.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct WrittenFile {
    /// Name within the folder.
    pub(crate) name: String,
    /// Rows, the header apart.
    pub(crate) rows: Option<u64>,
}

/// The two tables of a run, written step by step.
pub(crate) struct Tables {
    bodies: Table<BodyRow>,
    contacts: Table<ContactRow>,
    bodies_rows: u64,
    contacts_rows: u64,
    format: Format,
}

impl Tables {
    /// Starts both files in `folder`. `facts` are keys and values for the metadata, where the
    /// format has any.
    ///
    /// # Errors
    /// A file that cannot be created.
    pub(crate) fn create(
        folder: &Folder,
        format: Format,
        body_names: &[String],
        facts: &[(&str, String)],
    ) -> Result<Tables, OutputError> {
        let bodies = bodies_columns();
        let contacts = contacts_columns();
        Ok(Tables {
            bodies: Table::create(folder, format, "bodies", bodies, body_names, facts)?,
            contacts: Table::create(folder, format, "contacts", contacts, body_names, facts)?,
            bodies_rows: 0,
            contacts_rows: 0,
            format,
        })
    }

    /// Adds the rows of one step.
    ///
    /// # Errors
    /// A file that cannot be written, or a value that is not finite.
    pub(crate) fn write(&mut self, step: &StepRecord<'_>) -> Result<(), OutputError> {
        for (body, (state, wrench)) in step.states.iter().zip(step.wrenches).enumerate() {
            self.bodies.push(&BodyRow::new(step.t_s, body, state, wrench))?;
            self.bodies_rows += 1;
        }
        for contact in step.contacts {
            self.contacts.push(&ContactRow { t_s: step.t_s, contact: *contact })?;
            self.contacts_rows += 1;
        }
        Ok(())
    }

    /// The files that there will be, the report and the summary included.
    pub(crate) fn files(&self) -> Vec<WrittenFile> {
        let extension = self.format.extension();
        let table = |name: &str, rows| WrittenFile { name: format!("{name}.{extension}"), rows };
        vec![
            table("bodies", Some(self.bodies_rows)),
            table("contacts", Some(self.contacts_rows)),
            WrittenFile { name: REPORT.to_owned(), rows: None },
            WrittenFile { name: SUMMARY.to_owned(), rows: None },
        ]
    }
}

/// Brings all files of a run to the disk and then gives them their final names, the summary last.
/// Where anything fails, none keeps its final name.
///
/// # Errors
/// The first file that could not be written or renamed.
pub(crate) fn publish(
    folder: Folder,
    tables: Tables,
    report: &str,
    summary: &str,
) -> Result<(), OutputError> {
    let mut report_file = folder.create(REPORT)?;
    report_file.put(report.as_bytes())?;
    let files = [tables.bodies.finish()?, tables.contacts.finish()?, report_file.seal()?];
    folder.publish(files, summary.as_bytes())
}
