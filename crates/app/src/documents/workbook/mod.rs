//! The results of a run as an Excel workbook: cells hold numbers, not texts, and the heads have the units.

mod berthing;
mod cases;
mod contacts;
mod dolphins;
mod fenders;
mod lines;
mod series;
mod summary;
mod table;
mod vessels;

pub(crate) use self::cases::cases_workbook;

use fenderline_results::{KeptTable, Outcome};
use rust_xlsxwriter::{DocProperties, ExcelDateTime, Workbook, XlsxError};

/// The workbook's bytes. Each time series of `series` becomes a sheet after the other sheets.
///
/// # Errors
/// [`XlsxError`] if a sheet is too large for Excel.
pub(super) fn workbook(outcome: &Outcome<'_>, series: &[KeptTable]) -> Result<Vec<u8>, XlsxError> {
    let mut book = Workbook::new();
    // Without a clock: the same run writes the same bytes.
    let created = ExcelDateTime::from_ymd(2000, 1, 1)?;
    let detail = |key: &str| outcome.report.iter().find(|(own, _)| *own == key);
    let text = |key: &str| detail(key).map_or("", |(_, text)| text.as_str());
    let properties = DocProperties::new()
        .set_title(outcome.title)
        .set_author(text("author"))
        .set_company(text("client"))
        .set_subject(text("project"))
        .set_status(text("status"))
        .set_creation_datetime(&created);
    book.set_properties(&properties);
    summary::summary(book.add_worksheet(), outcome)?;
    summary::findings(book.add_worksheet(), outcome)?;
    if !outcome.setup.fenders.is_empty() {
        fenders::fenders(book.add_worksheet(), outcome)?;
    }
    if outcome.fenders.iter().any(|of| of.panel.is_some()) {
        fenders::panels(book.add_worksheet(), outcome)?;
    }
    if outcome.fenders.iter().any(|of| !of.chains.is_empty()) {
        fenders::chains(book.add_worksheet(), outcome)?;
    }
    if !outcome.dolphins.is_empty() {
        dolphins::dolphins(book.add_worksheet(), outcome)?;
    }
    if !outcome.setup.world.lines.is_empty() {
        lines::lines(book.add_worksheet(), outcome)?;
    }
    if !outcome.setup.world.vessels.is_empty() {
        vessels::vessels(book.add_worksheet(), outcome)?;
    }
    if !outcome.setup.world.tugs.is_empty() {
        vessels::tugs(book.add_worksheet(), outcome)?;
    }
    if let Some(Ok(_)) = outcome.berthing {
        berthing::berthing(book.add_worksheet(), outcome)?;
    }
    contacts::contacts(book.add_worksheet(), outcome)?;
    for table in series {
        series::time_series(book.add_worksheet(), table)?;
    }
    book.save_to_buffer()
}
