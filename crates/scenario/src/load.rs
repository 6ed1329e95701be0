//! Scenario files from the disk.

use core::fmt;
use std::fs::File;
use std::io::Read as _;
use std::path::Path;

use crate::error::ScenarioError;
use crate::overrides::Override;
use crate::scenario::Scenario;

/// Files above this size are not read [bytes].
const LARGEST_FILE: u64 = 16 << 20;

/// A scenario that could not be had from the disk.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LoadError {
    /// The file cannot be read, is too large or is no UTF-8 text: its name and why.
    Unreadable(String),
    /// It is read, and the scenario reader refuses it.
    Refused(ScenarioError),
}

impl fmt::Display for LoadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LoadError::Unreadable(why) => write!(
                f,
                "error: cannot read {why}\n  = help: a scenario is a file of text in TOML; its path starts \
                 from the folder in which the program was started"
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
        Scenario::parse_among(&text, &name, overrides, &mut |file| read_text(&folder.join(file)))
            .map_err(LoadError::Refused)
    }
}

/// The text of a file of at most 16 MiB.
///
/// # Errors
/// Its name and why there is none.
pub fn read_text(path: &Path) -> Result<String, String> {
    let name = path.display();
    let cannot = |e: &dyn fmt::Display| format!("{name}: {e}");
    let mut bytes = Vec::new();
    // One byte more than allowed tells a file that is too large, be it an endless one.
    File::open(path)
        .and_then(|file| file.take(LARGEST_FILE + 1).read_to_end(&mut bytes))
        .map_err(|e| cannot(&e))?;
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(cannot(&format_args!(
            "it is larger than {} MiB, which no scenario needs",
            LARGEST_FILE >> 20
        )));
    }
    String::from_utf8(bytes).map_err(|e| {
        let at = e.utf8_error().valid_up_to();
        let line = e.as_bytes()[..at].iter().filter(|b| **b == b'\n').count() + 1;
        cannot(&format_args!("line {line} is not UTF-8 text"))
    })
}
