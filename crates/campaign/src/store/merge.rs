//! Merges the shares of a campaign into one table.

use std::path::{Path, PathBuf};

use super::folder::{begin_merged, open_share};
use super::journal::Journal;
use super::tables::write_tables;
use crate::error::CampaignError;
use crate::row::Row;
use crate::run::Runs;

/// Merges the shares in `folders` into the tables of `out`. The result equals the result of a single campaign, byte for
/// byte.
///
/// # Errors
/// Fails if a folder holds no share of this campaign, if a share is missing, given twice or not finished, or if a
/// folder cannot be written.
pub fn merge(runs: &Runs, folders: &[PathBuf], out: &Path) -> Result<(), CampaignError> {
    let mut shares: Vec<Option<(Journal, &PathBuf)>> = Vec::new();
    for folder in folders {
        let (shard, journal) = open_share(folder, runs)?;
        if shares.is_empty() {
            shares
                .resize_with(usize::try_from(shard.of).unwrap_or(usize::MAX).min(1 << 20), || None);
        }
        if shard.of != shares.len() as u64 {
            let why = format!(
                "it is one of {} shards, but the first folder is one of {}",
                shard.of,
                shares.len()
            );
            return Err(CampaignError::folder(folder, why));
        }
        let wanted = shard.count(runs.count());
        if journal.done() < wanted {
            let why = format!(
                "shard {}/{} has only {} of its {wanted} runs: make the others with --resume",
                shard.number,
                shard.of,
                journal.done()
            );
            return Err(CampaignError::folder(folder, why));
        }
        let place = &mut shares[shard.number as usize - 1];
        if let Some((_, other)) = place {
            let why = format!("shard {}/{} is also in {}", shard.number, shard.of, other.display());
            return Err(CampaignError::folder(folder, why));
        }
        *place = Some((journal, folder));
    }
    let missing: Vec<String> = shares
        .iter()
        .enumerate()
        .filter(|(_, share)| share.is_none())
        .map(|(index, _)| format!("{}", index + 1))
        .collect();
    if !missing.is_empty() || shares.is_empty() {
        let why = format!("shards are missing: {} of {}", missing.join(", "), shares.len());
        return Err(CampaignError::part("merge", why));
    }
    let journals: Vec<Journal> = shares.into_iter().flatten().map(|(journal, _)| journal).collect();
    let _lock = begin_merged(out, runs)?;
    write_tables(out, runs, runs.count(), &mut |use_row| in_turn(&journals, use_row))
}

/// Reads the rows of all shares in the order of the runs. Every n-th run belongs to the same share, so the shares take
/// turns.
fn in_turn(
    journals: &[Journal],
    use_row: &mut dyn FnMut(&Row) -> Result<(), CampaignError>,
) -> Result<(), CampaignError> {
    let mut readers = Vec::new();
    for journal in journals {
        readers.push(journal.reader()?);
    }
    loop {
        for reader in &mut readers {
            match reader.next()? {
                Some(row) => use_row(&row)?,
                None => return Ok(()),
            }
        }
    }
}
