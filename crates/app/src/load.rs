//! Reads a scenario from a file or from standard input, applies the changes of the command line, and checks the
//! scenario.

use std::ffi::OsStr;
use std::io::{self, IsTerminal as _};
use std::path::{Path, PathBuf};

use fenderline_scenario::{LoadError, Override, Scenario, read_stream, read_text};

use crate::failure::Failure;
use crate::terminal::remark;

/// The path that stands for standard input.
const STANDARD_INPUT: &str = "-";
/// The name that stands for a scenario from standard input in messages and in the names of results.
const NAME: &str = "stdin";

/// The text of a scenario, and where it comes from.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    pub(crate) text: String,
    /// The path of the scenario as the user gave it, for messages.
    pub(crate) shown: String,
    /// Folder of the files that the scenario names: the folder of the scenario file, or the current folder for standard
    /// input.
    pub(crate) folder: PathBuf,
}

impl Source {
    /// Reads the file at `path`; for `-` it reads standard input to its end.
    ///
    /// # Errors
    /// Fails if the file cannot be read, is too large, or is not UTF-8 text.
    pub(crate) fn read(path: &Path) -> Result<Source, LoadError> {
        if path != STANDARD_INPUT {
            let text = read_text(path).map_err(LoadError::Unreadable)?;
            let folder = path.parent().unwrap_or(Path::new("")).to_owned();
            return Ok(Source { text, shown: path.display().to_string(), folder });
        }
        let input = io::stdin();
        if input.is_terminal() {
            remark("reading a scenario from standard input; end it with Ctrl-D on an empty line");
        }
        let text = read_stream(input.lock(), NAME).map_err(LoadError::Unreadable)?;
        Ok(Source { text, shown: NAME.to_owned(), folder: PathBuf::new() })
    }

    /// Reads the scenario with some of its keys replaced by `overrides`.
    ///
    /// # Errors
    /// Fails if the scenario reader refuses the text.
    pub(crate) fn scenario(&self, overrides: &[Override]) -> Result<Scenario, LoadError> {
        Scenario::parse_beside(&self.text, &self.shown, overrides, &self.folder)
            .map_err(LoadError::Refused)
    }
}

/// Reads and checks the scenario at `path`, or for `-` the scenario on standard input.
///
/// # Errors
/// [`Failure::Input`] if the file cannot be read, is too large, is not UTF-8 text, or is refused by the scenario
/// reader.
pub(crate) fn load(path: &Path, overrides: &[Override]) -> Result<Scenario, Failure> {
    let source = Source::read(path).map_err(Failure::input)?;
    source.scenario(overrides).map_err(Failure::input)
}

/// The file name of a scenario, without its folder.
pub(crate) fn file_name(path: &Path) -> &OsStr {
    named(path).file_name().unwrap_or_default()
}

/// The file name of a scenario without its extension, for the names of results.
pub(crate) fn stem(path: &Path) -> &OsStr {
    let stem = named(path).file_stem().unwrap_or_default();
    // `NAME.session.jsonl` is a recorded session.
    let whole = Path::new(stem);
    if whole.extension().is_some_and(|ending| ending == "session") {
        return whole.file_stem().unwrap_or_default();
    }
    stem
}

fn named(path: &Path) -> &Path {
    if path == STANDARD_INPUT { Path::new(NAME) } else { path }
}
