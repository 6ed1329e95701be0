//! Result files: tables of bodies, contacts, fenders, vessels, tugs, lines and energy, the summary, the
//! report.
//!
//! Files get their final names only when the whole run is done and everything is on the disk; until
//! then they are called `NAME.part`. `summary.json` gets its name last: if it exists, the results are complete.

mod csv;
mod files;
mod lock;
mod log;
mod parquet;
mod part_file;
mod tables;
mod whole_file;

use core::fmt;
use std::path::{Path, PathBuf};

use clap::ValueEnum;

pub(crate) use lock::admit;
pub(crate) use log::write_log;
pub(crate) use part_file::{Folder, Sealed};
pub(crate) use tables::Tables;
pub(crate) use whole_file::{make_folder, write_new, write_whole};

/// Names of all files that a run may write, the summary first. Files of an earlier run with these names are removed at
/// the start.
fn result_files() -> Vec<String> {
    let tables = fenderline_results::reference();
    let tables = tables.iter().flat_map(|table| {
        [Format::Csv, Format::Parquet]
            .map(|format| format!("{}.{}", table.name, format.extension()))
    });
    [SUMMARY.to_owned()].into_iter().chain(tables).chain([REPORT, LOG].map(str::to_owned)).collect()
}

pub(crate) const SUMMARY: &str = "summary.json";
const REPORT: &str = "report.html";
/// File name of the log of a recorded session.
pub(crate) const LOG: &str = "log.csv";

/// File format of the result tables.
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
    /// Whether the path that the user gave cannot be used: bad input, no failed run.
    is_refused: bool,
}

impl OutputError {
    /// Makes an error for a file that could not be written.
    pub(crate) fn new(file: &Path, cause: impl fmt::Display) -> OutputError {
        OutputError { file: file.to_owned(), cause: cause.to_string(), is_refused: false }
    }

    /// Makes an error for a path that cannot be used, which is bad input.
    fn refused(file: &Path, cause: impl fmt::Display) -> OutputError {
        OutputError { is_refused: true, ..OutputError::new(file, cause) }
    }

    /// Whether the user's path cannot be used, which is bad input and no failed run.
    pub(crate) fn is_refused(&self) -> bool {
        self.is_refused
    }
}

impl fmt::Display for OutputError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "error: cannot write {}: {}", self.file.display(), self.cause)
    }
}

impl core::error::Error for OutputError {}

/// Syncs all files of a run to the disk and then gives them their final names, the summary last; `files` are the
/// tables. If a file cannot be synced or renamed, no file keeps its final name.
///
/// # Errors
/// Names the first file that could not be written or renamed.
pub(crate) fn publish(
    folder: Folder,
    mut files: Vec<Sealed>,
    report: &str,
    summary: &str,
) -> Result<(), OutputError> {
    let mut report_file = folder.create(REPORT)?;
    report_file.put(report.as_bytes())?;
    files.push(report_file.seal()?);
    folder.publish(files, summary.as_bytes())
}
