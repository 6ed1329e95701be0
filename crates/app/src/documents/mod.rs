//! Documents of a run for people: the report as PDF, the results as an Excel workbook.

mod browser;
mod pdf;
mod sheets;
mod workbook;

use std::path::{Path, PathBuf};

use fenderline_sim::{OutputTable, Setup};

use crate::cli;
use crate::failure::Failure;
use crate::output::write_whole;
use crate::played::{Played, Start};
use crate::terminal::say;
use browser::Browser;
use sheets::Sheets;
pub(crate) use workbook::cases_workbook;

/// The documents (PDF, workbook) that the command line asks for.
pub(crate) struct Documents {
    pdf: Option<Pdf>,
    xlsx: Option<PathBuf>,
    /// The tables that the workbook holds as time series.
    series: Vec<OutputTable>,
}

impl Documents {
    /// Checks before the run whether the documents can be made: after hours of simulation it would be too late to learn
    /// that the browser is missing.
    ///
    /// # Errors
    /// Fails if there is no browser, if a table is unknown, or if a time series is too long for a sheet.
    pub(crate) fn of(asked: &cli::Documents, setup: &Setup) -> Result<Documents, Failure> {
        let pdf = Pdf::of(asked.pdf.as_deref())?;
        let series = sheets::chosen(asked.sheets.as_deref(), setup)?;
        Ok(Documents { pdf, xlsx: asked.xlsx.clone(), series })
    }

    /// Whether the command line asks for no document.
    pub(crate) fn is_none(&self) -> bool {
        self.pdf.is_none() && self.xlsx.is_none()
    }

    /// Starts the time series of the workbook, which the run fills.
    ///
    /// # Errors
    /// As [`Sheets::write`].
    pub(crate) fn sheets(&self, start: &Start) -> Result<Sheets, Failure> {
        Sheets::start(&self.series, start)
    }

    /// Writes the documents and says where they are. `page` is the report.
    ///
    /// # Errors
    /// Fails if a file cannot be written or the browser fails; the documents that were written before are complete.
    pub(crate) fn write(&self, played: &Played, page: &str, sheets: Sheets) -> Result<(), Failure> {
        if let Some(path) = &self.xlsx {
            let series = sheets.finish()?;
            let bytes =
                workbook::workbook(&played.outcome(), &series).map_err(|e| refused(path, &e))?;
            write_whole(path, &bytes)?;
            say(&format!("workbook: {}\n", path.display()))?;
        }
        match &self.pdf {
            Some(pdf) => pdf.write(page),
            None => Ok(()),
        }
    }
}

/// A report as PDF: where it goes, and the browser that prints it.
pub(crate) struct Pdf {
    path: PathBuf,
    browser: Browser,
}

impl Pdf {
    /// Looks for a browser before the runs if a PDF is asked for; after hours of runs it would be too late to learn
    /// that the browser is missing.
    ///
    /// # Errors
    /// Fails if there is no browser.
    pub(crate) fn of(path: Option<&Path>) -> Result<Option<Pdf>, Failure> {
        let Some(path) = path else { return Ok(None) };
        let browser = Browser::find().map_err(Failure::input)?;
        Ok(Some(Pdf { path: path.to_owned(), browser }))
    }

    /// Prints a page and says where the PDF is.
    ///
    /// # Errors
    /// Fails if a file cannot be written or the browser fails.
    pub(crate) fn write(&self, page: &str) -> Result<(), Failure> {
        let path = &self.path;
        let bytes = pdf::print(&self.browser, page, path).map_err(|e| refused(path, &e))?;
        write_whole(path, &bytes)?;
        say(&format!("PDF: {}\n", path.display()))
    }
}

fn refused(path: &Path, error: &dyn core::fmt::Display) -> Failure {
    Failure::case(format_args!("error: cannot make {}: {error}", path.display()))
}
