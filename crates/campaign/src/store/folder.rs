//! The results folder of a campaign, or of a share of a campaign.

use std::fs::{self, File, OpenOptions};
use std::io::Write as _;
use std::path::{Path, PathBuf};

use serde_json::{Value as Json, json};

use super::journal::Journal;
use super::tables::{TABLE_PARQUET, write_tables};
use super::whole;
use crate::error::CampaignError;
use crate::row::Row;
use crate::run::Runs;
use crate::run_numbers::RunNumbers;

const MANIFEST: &str = "campaign.json";
const JOURNAL: &str = "rows.journal";
const LOCK: &str = ".fenderline.lock";

/// A share (shard) of a campaign's runs: every n-th run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shard {
    /// Number of the shard, counted from 1.
    pub number: u64,
    /// Number of shards into which the runs are divided.
    pub of: u64,
}

impl Shard {
    /// The share that is the whole campaign: all runs.
    pub const WHOLE: Shard = Shard { number: 1, of: 1 };

    /// A share.
    ///
    /// # Errors
    /// Fails if the number is not between 1 and `of`.
    pub fn new(number: u64, of: u64) -> Result<Shard, String> {
        if (1..=of).contains(&number) {
            Ok(Shard { number, of })
        } else {
            Err(format!("shard {number} of {of}: shards are numbered from 1 to {of}"))
        }
    }

    /// The runs of the share.
    pub fn runs(self, count: u64) -> impl Iterator<Item = u64> {
        (self.number - 1..count).step_by(usize::try_from(self.of).unwrap_or(usize::MAX))
    }

    /// The number of runs of the shard.
    #[must_use]
    pub fn count(self, all: u64) -> u64 {
        let first = self.number - 1;
        if first >= all { 0 } else { (all - first).div_ceil(self.of) }
    }
}

/// How the results folder is opened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Opened {
    /// The folder must not hold a campaign.
    New,
    /// The campaign that the folder holds is continued.
    Resumed,
    /// The campaign that the folder holds is removed first.
    Replaced,
}

/// The folder, locked.
pub struct Store<'r> {
    folder: PathBuf,
    runs: &'r Runs,
    shard: Shard,
    journal: Journal,
    _lock: File,
}

impl<'r> Store<'r> {
    /// Opens the folder and reads its rows; `visit` gets each row.
    ///
    /// # Errors
    /// Fails if another program works in the folder, if a new folder already holds a campaign, if a resumed folder
    /// holds no campaign or another campaign, or if the folder cannot be written.
    pub fn open(
        folder: &Path,
        runs: &'r Runs,
        shard: Shard,
        opened: Opened,
        visit: &mut dyn FnMut(&Row),
    ) -> Result<Store<'r>, CampaignError> {
        fs::create_dir_all(folder).map_err(|error| CampaignError::disk(folder, &error))?;
        let lock = lock(folder)?;
        let manifest = folder.join(MANIFEST);
        let there = read_manifest(&manifest)?;
        match (opened, there) {
            (Opened::New, Some(_)) => {
                let why = "the folder holds a campaign already; add --resume to go on with it, or \
                           --replace to begin again";
                return Err(CampaignError::folder(folder, why));
            }
            (Opened::Resumed, None) => {
                let why = "the folder has no campaign to go on with; leave out --resume to begin the campaign";
                return Err(CampaignError::folder(folder, why));
            }
            (Opened::Resumed, Some(own)) => own.check(runs, shard, folder)?,
            (Opened::New | Opened::Replaced, _) => {
                // Removed in this order, so a manifest never stands beside the rows of another campaign.
                for name in [MANIFEST, JOURNAL, TABLE_PARQUET, super::tables::TABLE_CSV] {
                    match fs::remove_file(folder.join(name)) {
                        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
                            return Err(CampaignError::disk(&folder.join(name), &error));
                        }
                        _ => {}
                    }
                }
                Manifest::of(runs, shard).write(&manifest)?;
            }
        }
        let columns = runs.heads().len();
        if has_finished(folder) {
            let why = "the campaign in this folder is finished; use --replace to make it again";
            return Err(CampaignError::folder(folder, why));
        }
        let journal = Journal::open(&folder.join(JOURNAL), runs.count(), columns, visit)?;
        Ok(Store { folder: folder.to_owned(), runs, shard, journal, _lock: lock })
    }

    /// The runs of the share that have no row yet.
    #[must_use]
    pub fn missing(&self) -> RunNumbers {
        let (first, stride, all) = (self.shard.number - 1, self.shard.of, self.runs.count());
        match self.journal.done() {
            0 => RunNumbers::every(first, stride, all),
            _ => RunNumbers::among(first, stride, all, |run| !self.journal.has(run)),
        }
    }

    /// The number of rows.
    #[must_use]
    pub fn done(&self) -> u64 {
        self.journal.done()
    }

    /// Adds the row of a run; if the run already has a row, that row is kept.
    ///
    /// # Errors
    /// The disk.
    pub fn add(&mut self, row: &Row) -> Result<(), CampaignError> {
        self.journal.append(row)
    }

    /// Calls `use_row` for each row in the order of the runs below `most`.
    ///
    /// # Errors
    /// Fails with an error of the disk, or with the error that `use_row` returns.
    pub fn each(
        &self,
        most: u64,
        use_row: &mut dyn FnMut(&Row) -> Result<(), CampaignError>,
    ) -> Result<(), CampaignError> {
        self.journal.each(most, use_row)
    }

    /// Writes the tables of the runs below `most`, and removes the journal of rows. A share keeps its journal for
    /// [`super::merge()`] and gets no tables.
    ///
    /// # Errors
    /// Fails with an error of the disk; the rows are then still in the journal.
    pub fn finish(self, most: u64) -> Result<(), CampaignError> {
        if self.shard != Shard::WHOLE {
            return Ok(());
        }
        let count = most.min(self.runs.count());
        write_tables(&self.folder, self.runs, count, &mut |use_row| {
            self.journal.each(count, use_row)
        })?;
        let path = self.folder.join(JOURNAL);
        fs::remove_file(&path).map_err(|error| CampaignError::disk(&path, &error))
    }

    /// Writes the tables of the runs so far; the journal of rows is kept, so that the campaign can go on.
    ///
    /// # Errors
    /// The disk.
    pub fn write_so_far(&self) -> Result<(), CampaignError> {
        let count = self.journal.done();
        write_tables(&self.folder, self.runs, count, &mut |use_row| {
            self.journal.each(u64::MAX, use_row)
        })
    }
}

/// Refuses a folder that holds no campaign, or another campaign than the file describes.
///
/// # Errors
/// Says what the folder holds instead.
pub fn check(folder: &Path, runs: &Runs) -> Result<(), CampaignError> {
    match read_manifest(&folder.join(MANIFEST))? {
        Some(manifest) => manifest.check(runs, Shard::WHOLE, folder),
        None => Err(CampaignError::folder(
            folder,
            "the folder holds no campaign: there is no campaign.json",
        )),
    }
}

/// Whether a folder holds the whole table of this campaign, so that no run is left to make.
///
/// # Errors
/// Fails if the folder holds another campaign.
pub fn is_finished(folder: &Path, runs: &Runs, shard: Shard) -> Result<bool, CampaignError> {
    match read_manifest(&folder.join(MANIFEST))? {
        Some(manifest) if has_finished(folder) => {
            manifest.check(runs, shard, folder).map(|()| true)
        }
        _ => Ok(false),
    }
}

/// Whether the campaign in a folder has finished: the journal, which is removed last, is gone.
fn has_finished(folder: &Path) -> bool {
    folder.join(TABLE_PARQUET).exists() && !folder.join(JOURNAL).exists()
}

/// Takes the lock of a folder. The lock ends with the program, however the program ends; the lock file stays.
fn lock(folder: &Path) -> Result<File, CampaignError> {
    let path = folder.join(LOCK);
    let file = OpenOptions::new().write(true).create(true).truncate(false).open(&path);
    let file = file.map_err(|error| CampaignError::disk(&path, &error))?;
    match file.try_lock() {
        Ok(()) => Ok(file),
        Err(fs::TryLockError::WouldBlock) => Err(CampaignError::folder(
            folder,
            "another program writes in this folder; give each shard another folder",
        )),
        Err(fs::TryLockError::Error(error)) => Err(CampaignError::disk(&path, &error)),
    }
}

/// The manifest of a results folder: a description of the campaign that the folder holds.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Manifest {
    pub(super) fingerprint: String,
    pub(super) runs: u64,
    pub(super) shard: Shard,
}

impl Manifest {
    pub(super) fn of(runs: &Runs, shard: Shard) -> Manifest {
        Manifest { fingerprint: format!("{:016x}", runs.fingerprint()), runs: runs.count(), shard }
    }

    fn write(&self, path: &Path) -> Result<(), CampaignError> {
        let text = json!({
            "program": format!("fenderline {}", env!("CARGO_PKG_VERSION")),
            "fingerprint": self.fingerprint,
            "runs": self.runs,
            "shard": [self.shard.number, self.shard.of],
        });
        whole::write(path, |file| {
            writeln!(file, "{text:#}").map_err(|error| CampaignError::disk(path, &error))
        })
    }

    /// Refuses a folder of another campaign or share.
    pub(super) fn check(
        &self,
        runs: &Runs,
        shard: Shard,
        folder: &Path,
    ) -> Result<(), CampaignError> {
        let now = Manifest::of(runs, shard);
        if self.runs != now.runs {
            let why = format!(
                "the folder's campaign has {} runs, but this campaign has {}",
                self.runs, now.runs
            );
            return Err(CampaignError::folder(folder, why));
        }
        if self.fingerprint != now.fingerprint {
            let why = "the folder's campaign differs from this campaign: the campaign's file, the \
                       scenario, a file that they name or the program has changed; use another \
                       --out, or --replace to begin again";
            return Err(CampaignError::folder(folder, why));
        }
        if self.shard != shard {
            let (own, other) = (self.shard, shard);
            let why = format!(
                "the folder holds shard {}/{}, not {}/{}",
                own.number, own.of, other.number, other.of
            );
            return Err(CampaignError::folder(folder, why));
        }
        Ok(())
    }
}

/// Reads the manifest of a folder; `None` if the folder has no manifest.
fn read_manifest(path: &Path) -> Result<Option<Manifest>, CampaignError> {
    let text = match fs::read_to_string(path) {
        Ok(text) => text,
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(CampaignError::folder(path, error)),
    };
    let read = |json: &Json| {
        let shard = Shard::new(json["shard"][0].as_u64()?, json["shard"][1].as_u64()?).ok()?;
        Some(Manifest {
            fingerprint: json["fingerprint"].as_str()?.to_owned(),
            runs: json["runs"].as_u64()?,
            shard,
        })
    };
    let manifest = serde_json::from_str(&text).ok().and_then(|json: Json| read(&json));
    manifest.map(Some).ok_or_else(|| {
        CampaignError::folder(path, "this campaign.json is not a manifest of a campaign")
    })
}

/// Opens the manifest and the journal of a share, which is to be merged.
pub(super) fn open_share(folder: &Path, runs: &Runs) -> Result<(Shard, Journal), CampaignError> {
    let Some(manifest) = read_manifest(&folder.join(MANIFEST))? else {
        return Err(CampaignError::folder(folder, "the folder holds no share of a campaign"));
    };
    manifest.check(runs, manifest.shard, folder)?;
    let path = folder.join(JOURNAL);
    if !path.exists() {
        return Err(CampaignError::folder(
            folder,
            "the folder has no rows: its campaign is not a share, or did not begin",
        ));
    }
    // Nobody may append while the folder is read.
    let _lock = lock(folder)?;
    let journal = Journal::open(&path, runs.count(), runs.heads().len(), &mut |_| {})?;
    Ok((manifest.shard, journal))
}

/// Makes the folder of merged shares, which must not hold a campaign.
pub(super) fn begin_merged(folder: &Path, runs: &Runs) -> Result<File, CampaignError> {
    fs::create_dir_all(folder).map_err(|error| CampaignError::disk(folder, &error))?;
    let lock = lock(folder)?;
    let manifest = folder.join(MANIFEST);
    if read_manifest(&manifest)?.is_some() {
        return Err(CampaignError::folder(
            folder,
            "the folder holds a campaign already; merge into another folder",
        ));
    }
    Manifest::of(runs, Shard::WHOLE).write(&manifest)?;
    Ok(lock)
}
