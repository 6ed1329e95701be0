//! A scenario that can be run.

use fenderline_sim::Setup;

use crate::assemble;
use crate::checked::Table;
use crate::error::{Notice, ScenarioError};
use crate::files::Files;
use crate::keys::SCENARIO;
use crate::library::FenderLibrary;
use crate::overrides::{self, Override};
use crate::reader;
use crate::sources::Sources;
use crate::syntax;

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
        let sources = Sources { file_name, text, overrides };
        let mut document = syntax::parse(&sources)?;
        overrides::apply(&sources, &mut document)?;
        // What the file as a whole lacks is lacking at its end.
        let end = text.trim_end().len();
        let file = reader::table(&sources, &SCENARIO, "", end..end, &document)?;
        let mut notices = Vec::new();
        let library = library(&sources, &file, read)?;
        let files = Files::read(&sources, &file, read)?;
        let setup = assemble::setup(&sources, &file, &files, &library, &mut notices)?;
        let title =
            file.item("title").map_or_else(|| stem(file_name), |item| item.text().to_owned());
        Ok(Scenario { title, setup, notices })
    }
}

/// The fender data: the program's own, with the files that the scenario names.
fn library(
    sources: &Sources<'_>,
    file: &Table,
    read: &mut dyn FnMut(&str) -> Result<String, String>,
) -> Result<FenderLibrary, ScenarioError> {
    let item = file.given("fender_files");
    item.texts().iter().try_fold(FenderLibrary::built_in(), |library, name| {
        let text = read(name).map_err(|why| {
            let message = format!("`fender_files`: cannot read {why}");
            sources.error(&item.span, "fender_files", message)
        })?;
        library.with_file(&text, name)
    })
}

/// The name of a file without folders and extension.
fn stem(file_name: &str) -> String {
    let stem = std::path::Path::new(file_name).file_stem();
    stem.map_or_else(|| file_name.to_owned(), |stem| stem.to_string_lossy().into_owned())
}
