//! Scenario files from the disk.

use core::fmt;
use std::io::Read;
use std::path::Path;

use crate::scenario::Scenario;
use fenderline_keys::bounded_file::{read_stream_of, read_text_of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::overrides::Override;

/// Largest file that is read (bytes).
const LARGEST_FILE: u64 = 16 << 20;

/// A scenario that could not be loaded.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LoadError {
    /// The file cannot be read, is not a regular file, is too large or is not UTF-8 text: its name and why.
    Unreadable(String),
    /// The file has a mistake.
    Refused(ScenarioError),
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LoadError::Unreadable(why) => write!(
                f,
                "error: cannot read {why}\n  = help: a scenario is a file of text in TOML; its path starts from the folder in which the \
                 program was started, the path of a campaign's `scenario` from the campaign's folder"
            ),
            LoadError::Refused(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for LoadError {}

impl Scenario {
    /// Reads the scenario file at `path`, with some keys replaced; the files that it names lie beside it.
    ///
    /// # Errors
    /// [`LoadError`].
    pub fn load(path: &Path, overrides: &[Override]) -> Result<Scenario, LoadError> {
        let text = read_text(path).map_err(LoadError::Unreadable)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        let name = path.display().to_string();
        Scenario::parse_beside(&text, &name, overrides, folder).map_err(LoadError::Refused)
    }

    /// As [`Scenario::parse_with`]; the files that the scenario names lie in `folder`.
    ///
    /// # Errors
    /// As [`Scenario::parse_among`].
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

/// The text of a regular file of at most 16 MiB.
///
/// # Errors
/// The file's name and why it cannot be read, in words.
pub fn read_text(path: &Path) -> Result<String, String> {
    read_text_of(path, LARGEST_FILE).map_err(|error| error.to_string())
}

/// The text of a stream of at most 16 MiB, such as standard input; `name` is its name in errors. Waits for its end.
///
/// # Errors
/// The stream's name and why it cannot be read, in words.
pub fn read_stream(stream: impl Read, name: &str) -> Result<String, String> {
    read_stream_of(stream, name, LARGEST_FILE).map_err(|error| error.to_string())
}
