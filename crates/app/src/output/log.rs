//! The log of a recorded session as a file.

use fenderline_results::LogLine;

use super::part_file::{Folder, Sealed};
use super::{LOG, OutputError};

/// Writes the log of a session under its `.part` name: a line for each command, alarm, acknowledgement, note and event.
///
/// # Errors
/// Fails if the file cannot be written.
pub(crate) fn write_log(folder: &Folder, log: &[LogLine]) -> Result<Sealed, OutputError> {
    let file = folder.create(LOG)?;
    let path = file.path().to_owned();
    let failed = |e: csv::Error| OutputError::new(&path, e);
    let mut writer = csv::Writer::from_writer(file);
    writer
        .write_record(["t_s", "until_s", "kind", "who", "text", "acknowledged_s"])
        .map_err(failed)?;
    for LogLine { t_s, until_s, kind, who, text, acknowledged, .. } in log {
        let time = |at_s: Option<f64>| at_s.map_or_else(String::new, |at_s| format!("{at_s:?}"));
        let acknowledged_s = acknowledged.as_ref().map(|(at_s, _)| *at_s);
        writer
            .write_record([
                &time(Some(*t_s)),
                &time(*until_s),
                kind.word(),
                who,
                text,
                &time(acknowledged_s),
            ])
            .map_err(failed)?;
    }
    let file = writer.into_inner().map_err(|e| OutputError::new(&path, e.error()))?;
    file.seal()
}
