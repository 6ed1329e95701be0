//! Reads the keys of a downtime campaign, which counts the hours that a berth loses to the weather.

use std::path::PathBuf;

use super::kinds::Read;
use crate::file::keys::downtime::DowntimeKey;
use crate::file::keys::{BESIDE_DOWNTIME, CampaignFileKey};
use fenderline_keys::checked::Of;
use fenderline_keys::held::Number;
use fenderline_keys::origin::Origin;
use fenderline_keys::sources::Sources;
use fenderline_keys::typed_key::{AnyKey, Key};

/// The weather at a berth, and how the hours of the weather become runs of the scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Downtime {
    /// Weather file with a series or a scatter diagram, CSV or Parquet.
    pub file: PathBuf,
    /// Largest number of states into which the hours of a series are grouped.
    pub states: u64,
    /// Number of single hours of a series that are run with their own weather.
    pub sample: u64,
    /// Place of the weather file's name in the campaign's file; `None` only if the campaign was not read from a file.
    pub origin: Option<Origin>,
}

/// Reads the table `[downtime]` of a campaign's file, if there is one.
pub(super) fn read(sources: &Sources<'_>, file: Of<'_, CampaignFileKey>) -> Read<Option<Downtime>> {
    let Some(item) = file.item(CampaignFileKey::DOWNTIME) else { return Ok(None) };
    let given = |key: &AnyKey<CampaignFileKey>| {
        let item = file.item(*key).filter(|item| !item.is_default)?;
        Some((*key, item))
    };
    if let Some((key, item)) = BESIDE_DOWNTIME.iter().find_map(given) {
        let message = format!("`{key}` does not go with [downtime]");
        let error = sources.error(&item.span, key.name(), message);
        return Err(error.with_help(match key == CampaignFileKey::LIMIT.any() {
            true => {
                "a downtime campaign uses the limits of the scenario: write [limit.NAME] in the \
                 scenario"
            }
            false => "the file of the weather determines what differs from run to run",
        }));
    }
    let table = item.table();
    let whole = |key: Key<DowntimeKey, Number>| {
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
    let named = table.given(DowntimeKey::FILE);
    Ok(Some(Downtime {
        file: PathBuf::from(named.text()),
        states: whole(DowntimeKey::STATES)?,
        sample: whole(DowntimeKey::SAMPLE)?,
        origin: Some(sources.origin(&named.span)),
    }))
}
