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
    /// Title of reports: the file's, else the stem of its name.
    pub title: String,
    /// The simulation, in SI units; bodies and materials in the order of the file.
    pub setup: Setup,
    /// What was put right or looks unintended, in the order of the file.
    pub notices: Vec<Notice>,
}

/// What all files together may have that a scenario names (bytes).
const LARGEST_TOTAL: usize = 256 << 20;

impl Scenario {
    /// Reads the text of a scenario file; `file_name` is for messages and the default title.
    ///
    /// # Errors
    /// The first mistake found: what is no TOML, then unknown keys and bad values in the order of
    /// the file, then what does not fit together.
    pub fn parse(text: &str, file_name: &str) -> Result<Scenario, ScenarioError> {
        Scenario::parse_with(text, file_name, &[])
    }

    /// As [`Scenario::parse`], with some keys replaced before anything is checked; where two
    /// overrides name one key, the later one holds.
    ///
    /// # Errors
    /// As [`Scenario::parse`]; mistakes in an override point at its option, not at the file.
    pub fn parse_with(
        text: &str,
        file_name: &str,
        overrides: &[Override],
    ) -> Result<Scenario, ScenarioError> {
        Scenario::parse_among(text, file_name, overrides, &mut |name| {
            Err(format!("{name}: this text stands alone, no other file can be read"))
        })
    }

    /// As [`Scenario::parse_with`], with a way to `read` the files that the scenario names: from
    /// the name as it stands in the file to the file's text, or why there is none.
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
        // What the file as a whole lacks is lacking at its end.
        let end = text.trim_end().len();
        let file = reader::table(&sources, &SCENARIO, "", end..end, &document)?;
        let mut notices = Vec::new();
        let mut left = LARGEST_TOTAL;
        let mut read = |name: &str| {
            let text = read(name)?;
            left = left.checked_sub(text.len()).ok_or_else(|| {
                let most = LARGEST_TOTAL >> 20;
                format!("{name}: with it the files of the scenario have more than {most} MiB")
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

/// Fenders and vessels: the program's own, with the files that the scenario names.
fn libraries(
    sources: &Sources<'_>,
    file: &Table,
    read: &mut dyn FnMut(&str) -> Result<String, String>,
) -> Result<Libraries, ScenarioError> {
    let mut libraries =
        Libraries { fenders: FenderLibrary::built_in(), vessels: VesselLibrary::built_in() };
    for key in ["fender_files", "vessel_files"] {
        let item = file.given(key);
        for name in item.texts() {
            let text = read(name).map_err(|why| {
                let message = format!("`{key}`: cannot read {why}");
                sources.error(&item.span, key, message).with_help(FILE_HELP)
            })?;
            libraries = match key {
                "fender_files" => {
                    Libraries { fenders: libraries.fenders.with_file(&text, name)?, ..libraries }
                }
                _ => Libraries { vessels: libraries.vessels.with_file(&text, name)?, ..libraries },
            };
        }
    }
    Ok(libraries)
}

/// The name of a file without folders and extension.
fn stem(file_name: &str) -> String {
    let stem = std::path::Path::new(file_name).file_stem();
    stem.map_or_else(|| file_name.to_owned(), |stem| stem.to_string_lossy().into_owned())
}
