//! Why a campaign cannot begin or go on.

use core::fmt;
use std::path::{Path, PathBuf};

use fenderline_scenario::LoadError;

use crate::table::TableError;

/// A mistake of the user or a failure of the disk.
#[derive(Clone, Debug, PartialEq)]
pub enum CampaignError {
    /// The campaign's file, or its scenario with the campaign's changes, was refused.
    File(Box<LoadError>),
    /// A mistake in a variable, output or rule of the campaign, with its name.
    Part {
        /// Name of the part as in the campaign's file, such as `variable.speed`, `output.margin`, `stop.output` or
        /// `correlation`.
        name: String,
        /// What is wrong.
        why: String,
    },
    /// A table that cannot be read.
    Table(TableError),
    /// A mistake in a file from which a variable takes its values, with the place of the mistake.
    Values {
        /// The file.
        file: PathBuf,
        /// What is wrong, with line and column if known.
        why: String,
    },
    /// None of the first runs can be made; holds the error of the first run.
    Hopeless(Box<CampaignError>),
    /// A file or folder that cannot be written, with the reason.
    Disk {
        /// The file or folder.
        path: PathBuf,
        /// Why.
        why: String,
        /// Whether the disk is full, which is no mistake of the user.
        is_full: bool,
    },
    /// A fault of the results folder.
    Folder {
        /// The folder or file.
        path: PathBuf,
        /// What is wrong.
        why: String,
    },
}

impl CampaignError {
    pub(crate) fn part(name: impl Into<String>, why: impl Into<String>) -> CampaignError {
        CampaignError::Part { name: name.into(), why: why.into() }
    }

    pub(crate) fn folder(path: &Path, why: impl fmt::Display) -> CampaignError {
        CampaignError::Folder { path: path.to_owned(), why: why.to_string() }
    }

    pub(crate) fn disk(path: &Path, error: &std::io::Error) -> CampaignError {
        let is_full = error.kind() == std::io::ErrorKind::StorageFull;
        CampaignError::Disk { path: path.to_owned(), why: error.to_string(), is_full }
    }

    /// Whether the disk is full.
    #[must_use]
    pub fn is_disk_full(&self) -> bool {
        matches!(self, CampaignError::Disk { is_full: true, .. })
    }

    pub(crate) fn values(path: &Path, why: impl fmt::Display) -> CampaignError {
        CampaignError::Values { file: path.to_owned(), why: why.to_string() }
    }
}

impl fmt::Display for CampaignError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            CampaignError::File(error) => error.fmt(f),
            CampaignError::Part { name, why } => write!(f, "error: `{name}`: {why}"),
            CampaignError::Hopeless(error) => {
                write!(f, "{error}\nno case of the campaign can be run")
            }
            CampaignError::Table(error) => write!(f, "error: {error}"),
            CampaignError::Values { file, why } => write!(f, "error: {}: {why}", file.display()),
            CampaignError::Disk { path, why, .. } => {
                write!(f, "error: cannot write {}: {why}", path.display())
            }
            CampaignError::Folder { path, why } => write!(f, "error: {}: {why}", path.display()),
        }
    }
}

impl std::error::Error for CampaignError {}

impl From<LoadError> for CampaignError {
    fn from(error: LoadError) -> CampaignError {
        CampaignError::File(Box::new(error))
    }
}

impl From<TableError> for CampaignError {
    fn from(error: TableError) -> CampaignError {
        CampaignError::Table(error)
    }
}
