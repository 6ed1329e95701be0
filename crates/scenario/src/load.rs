//! Reads scenario files from the disk.

use core::fmt;
use std::io::Read;
use std::path::Path;

use crate::model;
use crate::scenario::Scenario;
use fenderline_keys::bounded_file::{read_bytes, read_stream_of, read_text_of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::overrides::Override;

/// Size of the largest file that the program reads (bytes): a survey of 4 million values has some 28 MB.
const LARGEST_FILE: u64 = 64 << 20;
/// Size of the largest model of a ship (bytes): its text in base64 is a third longer.
const LARGEST_MODEL: u64 = 16 << 20;
/// Size of the largest text that the program reads from a stream (bytes).
const LARGEST_STREAM: u64 = 16 << 20;

/// The error for a scenario that could not be loaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LoadError {
    /// The file cannot be read, is not a regular file, is too large or is not UTF-8 text; the text gives the file's
    /// name and the reason.
    Unreadable(String),
    /// The file has a mistake.
    Refused(ScenarioError),
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LoadError::Unreadable(why) => write!(
                f,
                "error: cannot read {why}\n  = help: a scenario is a TOML text file; its path \
                 starts from the folder in which the program was started, but the path of a \
                 campaign's `scenario` starts from the folder of the campaign"
            ),
            LoadError::Refused(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for LoadError {}

impl Scenario {
    /// Reads the scenario file at `path`, with some keys replaced; the files that the scenario names lie beside the
    /// scenario file.
    ///
    /// # Errors
    /// Returns a [`LoadError`] if the file cannot be read or has a mistake.
    pub fn load(path: &Path, overrides: &[Override]) -> Result<Scenario, LoadError> {
        let text = read_text(path).map_err(LoadError::Unreadable)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let name = path.display().to_string();
        Scenario::parse_beside(&text, &name, overrides, folder).map_err(LoadError::Refused)
    }

    /// Reads a scenario as [`Scenario::parse_with`] does; the files that the scenario names lie in `folder`.
    ///
    /// # Errors
    /// Fails like [`Scenario::parse_among`].
    pub fn parse_beside(
        text: &str,
        file_name: &str,
        overrides: &[Override],
        folder: &Path,
    ) -> Result<Scenario, ScenarioError> {
        let mut read = |file: &str| read_text(&folder.join(file));
        Scenario::parse_among(text, file_name, overrides, &mut read)
    }
}

/// Reads the text of a regular file of at most 64 MiB. The text of a model of a ship (`.glb`), which is no text, is its
/// bytes in base64.
///
/// # Errors
/// Returns a text with the file's name and the reason why the file cannot be read.
pub fn read_text(path: &Path) -> Result<String, String> {
    let read = if model::is_model(&path.to_string_lossy()) {
        read_bytes(path, LARGEST_MODEL).map(|bytes| model::text_of(&bytes))
    } else {
        read_text_of(path, LARGEST_FILE)
    };
    read.map_err(|error| error.to_string())
}

/// Reads the text of a stream of at most 16 MiB, such as standard input, and waits for the end of the stream. Errors
/// call the stream `name`.
///
/// # Errors
/// Returns a text with the stream's name and the reason why the stream cannot be read.
pub fn read_stream(stream: impl Read, name: &str) -> Result<String, String> {
    read_stream_of(stream, name, LARGEST_STREAM).map_err(|error| error.to_string())
}
