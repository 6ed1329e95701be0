//! The tables of a run, written step by step.

use fenderline_results::WrittenFile;
use fenderline_sim::{Energy, OutputPlan, Setup, StepRecord};

use super::files::Files;
use super::part_file::{Folder, Sealed};
use super::{Format, OutputError, REPORT, SUMMARY};

/// All tables of a run; tables of fenders, vessels, tugs and lines exist only if the set-up has such parts.
pub(crate) struct Tables<'a> {
    tables: fenderline_results::Tables<Files<'a>>,
    format: Format,
}

impl<'a> Tables<'a> {
    /// Starts the tables' files in `folder`, and the energy ledger with the energies at the `start`. `facts` are keys
    /// and values for the metadata, if the file format has metadata.
    ///
    /// # Errors
    /// Fails if a file cannot be created or written.
    pub(crate) fn create(
        folder: &'a Folder,
        format: Format,
        setup: &Setup,
        start: Energy,
        plan: &OutputPlan,
        facts: &'a [(&'a str, String)],
    ) -> Result<Tables<'a>, OutputError> {
        let files = Files { folder, format, facts };
        let tables = fenderline_results::Tables::start(&files, setup, start, plan)?;
        Ok(Tables { tables, format })
    }

    /// Adds the rows of one time step to the tables.
    ///
    /// # Errors
    /// Fails if a file cannot be written, or if a value is not finite.
    pub(crate) fn write(&mut self, step: &StepRecord<'_>) -> Result<(), OutputError> {
        self.tables.write(step)
    }

    /// Adds the rows of the last output interval, which the end of the run cut short.
    ///
    /// # Errors
    /// Fails if a file cannot be written.
    pub(crate) fn end_interval(&mut self) -> Result<(), OutputError> {
        self.tables.end_interval()
    }

    /// The files of the run, with the report and the summary.
    pub(crate) fn files(&self) -> Vec<WrittenFile> {
        let whole = |name: &str| WrittenFile { name: name.to_owned(), rows: None };
        let table = |(name, rows): (&str, u64)| {
            let name = format!("{name}.{}", self.format.extension());
            WrittenFile { name, rows: Some(rows) }
        };
        let mut files: Vec<WrittenFile> = self.tables.rows().into_iter().map(table).collect();
        files.extend([whole(REPORT), whole(SUMMARY)]);
        files
    }

    /// Syncs all tables to the disk; their files keep their `.part` names.
    ///
    /// # Errors
    /// Fails if a file cannot be written.
    pub(crate) fn finish(self) -> Result<Vec<Sealed>, OutputError> {
        self.tables.finish()
    }
}
