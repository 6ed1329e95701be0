//! A scenario that can be run.

use fenderline_sim::Setup;

use crate::assemble::{self, Libraries};
use crate::checked::Table;
use crate::error::{Notice, ScenarioError};
use crate::files::{FILE_HELP, Files};
use crate::keys::SCENARIO;
use crate::library::FenderLibrary;
use crate::overrides::{self, Override};
use crate::reader;
use crate::sources::Sources;
use crate::syntax;
use crate::vessels::VesselLibrary;

/// A scenario file after all checks.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// Title of reports: from the file, or the file's name without its extension.
    pub title: String,
    /// The simulation, in SI units; bodies and materials in the order of the file.
    pub setup: Setup,
    /// Warnings: what was corrected or looks unintended, in the order of the file.
    pub notices: Vec<Notice>,
}

/// Largest total size of the files that a scenario names (bytes).
const LARGEST_TOTAL: usize = 256 << 20;

impl Scenario {
    /// Reads the text of a scenario file; `file_name` is for messages and the default title.
    ///
    /// # Errors
    /// The first mistake found: TOML syntax, then unknown keys and bad values in the order of the file, then keys that
    /// contradict each other.
    pub fn parse(text: &str, file_name: &str) -> Result<Scenario, ScenarioError> {
        Scenario::parse_with(text, file_name, &[])
    }

    /// As [`Scenario::parse`], with some keys replaced before anything is checked. Of two overrides of one key the later
    /// one counts.
    ///
    /// # Errors
    /// As [`Scenario::parse`]; mistakes in an override point at its option, not at the file.
    pub fn parse_with(
        text: &str,
        file_name: &str,
        overrides: &[Override],
    ) -> Result<Scenario, ScenarioError> {
        Scenario::parse_among(text, file_name, overrides, &mut |name| {
            Err(format!(
                "{name}: this scenario was given as text alone, so no other file can be read"
            ))
        })
    }

    /// As [`Scenario::parse_with`]. `read` reads the files that the scenario names: it gets the name as written in the
    /// scenario, and returns the text or why it cannot be read.
    ///
    /// # Errors
    /// As [`Scenario::parse_with`]; mistakes in such a file point at that file.
    pub fn parse_among(
        text: &str,
        file_name: &str,
        overrides: &[Override],
        read: &mut dyn FnMut(&str) -> Result<String, String>,
    ) -> Result<Scenario, ScenarioError> {
        let sources = Sources::new(file_name, text, overrides);
        let mut document = syntax::parse(&sources)?;
        overrides::apply(&sources, &mut document)?;
        // A key that is missing at the top level is reported at the end of the file.
        let end = text.trim_end().len();
        let file = reader::table(&sources, &SCENARIO, "", end..end, &document)?;
        let mut notices = Vec::new();
        let mut left = LARGEST_TOTAL;
        let mut read = |name: &str| {
            let text = read(name)?;
            left = left.checked_sub(text.len()).ok_or_else(|| {
                let most = LARGEST_TOTAL >> 20;
                format!("{name}: with this file the files of the scenario exceed {most} MiB")
            })?;
            Ok(text)
        };
        let libraries = libraries(&sources, &file, &mut read)?;
        let files = Files::read(&sources, &file, &mut read)?;
        let setup = assemble::setup(&sources, &file, &files, &libraries, &mut notices)?;
        let title =
            file.item("title").map_or_else(|| stem(file_name), |item| item.text().to_owned());
        Ok(Scenario { title, setup, notices })
    }
}

/// The fender and vessel libraries: built-in data and the files that the scenario names.
fn libraries(
    sources: &Sources<'_>,
    file: &Table,
    read: &mut dyn FnMut(&str) -> Result<String, String>,
) -> Result<Libraries, ScenarioError> {
    let mut read_text = |key: &str, name: &str| {
        read(name).map_err(|why| {
            let message = format!("`{key}`: cannot read {why}");
            sources.error(&file.given(key).span, key, message).with_help(FILE_HELP)
        })
    };
    let (mut fenders, mut vessels) = (FenderLibrary::built_in(), VesselLibrary::built_in());
    for name in file.given("fender_files").texts() {
        fenders = fenders.with_file(&read_text("fender_files", name)?, name)?;
    }
    for name in file.given("vessel_files").texts() {
        vessels = vessels.with_file(&read_text("vessel_files", name)?, name)?;
    }
    Ok(Libraries { fenders, vessels })
}

/// The name of a file without folders and extension.
fn stem(file_name: &str) -> String {
    let stem = std::path::Path::new(file_name).file_stem();
    stem.map_or_else(|| file_name.to_owned(), |stem| stem.to_string_lossy().into_owned())
}
