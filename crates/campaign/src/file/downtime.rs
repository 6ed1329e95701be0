//! The hours that a berth loses to the weather.

use std::path::PathBuf;

use super::Read;
use fenderline_keys::checked::Table;
use fenderline_keys::origin::Origin;
use fenderline_keys::sources::Sources;

/// Which weather a berth has, and how it is run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Downtime {
    /// File of a series or scatter diagram, CSV or Parquet.
    pub file: PathBuf,
    /// Most states that the hours of a series are put together to.
    pub states: u64,
    /// Number of hours of a series that are run as they are.
    pub sample: u64,
    /// Where the campaign's file names the file; `None` only where the campaign was not read from a file.
    pub origin: Option<Origin>,
}

/// Keys of a campaign that do not go with it.
const OTHERS: [&str; 9] =
    ["variable", "plan", "number", "table", "correlation", "success", "stop", "design", "limit"];

/// Reads the table, if there is one.
pub(super) fn read(sources: &Sources<'_>, file: &Table) -> Read<Option<Downtime>> {
    let Some(item) = file.item("downtime") else { return Ok(None) };
    let given = |key: &'static str| {
        let item = file.item(key).filter(|item| !item.is_default)?;
        Some((key, item))
    };
    if let Some((key, item)) = OTHERS.into_iter().find_map(given) {
        let message = format!("`{key}` does not go with [downtime]");
        let error = sources.error(&item.span, key, message);
        return Err(error.with_help(match key {
            "limit" => {
                "the limits of a downtime are those of the scenario: write [limit.NAME] there"
            }
            _ => "the weather's file says what differs from run to run",
        }));
    }
    let table = item.table();
    let whole = |key: &str| {
        let item = table.given(key);
        let number = *item.number();
        match number == libm::trunc(number) {
            true => Ok(number as u64),
            false => {
                let path = table.path_of(key);
                let message = format!("`{path}` must be a whole number");
                Err(sources.error(&item.span, &path, message))
            }
        }
    };
    let named = table.given("file");
    Ok(Some(Downtime {
        file: PathBuf::from(named.text()),
        states: whole("states")?,
        sample: whole("sample")?,
        origin: Some(sources.origin(&named.span)),
    }))
}
