//! Reads a log of any kind.

use fenderline_nautical::ChartOrigin;

use super::row::{LogKind, LogsRead};
use super::{sentences, table};
use crate::mapping::Mapping;
use crate::remark::Remarks;

/// Reads the text of a log. `origin` gives metres from latitude and longitude; only tracks need it.
///
/// The function does not fail: a log that cannot be used gives no [`Log`](super::Log), and a remark with file and line that says
/// why.
#[must_use]
pub fn read_log(
    text: &str,
    file: &str,
    mapping: &Mapping,
    origin: Option<&ChartOrigin>,
) -> LogsRead {
    let mut remarks = Remarks::of(file);
    let logs = match mapping.kind.or_else(|| sentences::kind_of(text)) {
        Some(kind @ (LogKind::Nmea | LogKind::Ais)) => {
            sentences::read(text, file, kind, mapping, origin, &mut remarks)
        }
        kind => table::read(text, file, kind, mapping, origin, &mut remarks),
    };
    LogsRead { logs, remarks: remarks.all }
}
