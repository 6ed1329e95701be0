//! A scenario that can be run.

use std::borrow::Cow;
use std::collections::BTreeSet;

use fenderline_sim::exercise::ExerciseSetup;
use fenderline_sim::{OutputPlan, Setup};

use crate::assemble::{self, Libraries};
use crate::files::{FILE_HELP, Files};
use crate::library::FenderLibrary;
use crate::vessels::VesselLibrary;
use fenderline_keys::checked::Of;
use fenderline_keys::error::{Notice, ScenarioError};
use fenderline_keys::held::Texts;
use fenderline_keys::keys::output::OutputKey;
use fenderline_keys::keys::{self, SCENARIO, ScenarioKey};
use fenderline_keys::overrides::{self, Override};
use fenderline_keys::sources::Sources;
use fenderline_keys::typed_key::Key;
use fenderline_keys::{any_keys, reader, syntax};

/// A scenario file after all checks.
#[derive(Clone, Debug, PartialEq)]
pub struct Scenario {
    /// Title of reports, which the scenario file gives, or else the name of the file without its extension.
    pub title: String,
    /// Keys and texts of the lines that the scenario gives for the title page of the report, in the order of the page.
    pub report: Vec<(&'static str, String)>,
    /// The set-up of the simulation, in SI units, with bodies and materials in the order of the file.
    pub setup: Setup,
    /// The exercise; `None` if the scenario has no exercise.
    pub exercise: Option<ExerciseSetup>,
    /// The result tables that a run writes.
    pub output: OutputPlan,
    /// Whether the file gives `output.interval`, and whether it gives `output.tables`.
    pub output_gives: [bool; 2],
    /// Warnings about what was corrected or looks unintended, in the order of the file.
    pub notices: Vec<Notice>,
}

/// Largest total size of the files that a scenario names (bytes).
const LARGEST_TOTAL: usize = 256 << 20;

impl Scenario {
    /// Reads the text of a scenario file; `file_name` is the name of the file in messages and in the default title.
    ///
    /// # Errors
    /// Returns the first mistake found: first mistakes of TOML syntax, then unknown keys and bad values in the order of
    /// the file, then keys that contradict each other.
    pub fn parse(text: &str, file_name: &str) -> Result<Scenario, ScenarioError> {
        Scenario::parse_with(text, file_name, &[])
    }

    /// Reads a scenario as [`Scenario::parse`] does, with some keys replaced before anything is checked. If two
    /// overrides set the same key, the later override counts.
    ///
    /// # Errors
    /// Fails like [`Scenario::parse`]; an error about an override points to the option of the override, not to the
    /// file.
    pub fn parse_with(
        text: &str,
        file_name: &str,
        overrides: &[Override],
    ) -> Result<Scenario, ScenarioError> {
        Scenario::parse_among(text, file_name, overrides, &mut |name| {
            Err(format!(
                "{name}: this scenario was given as text alone, so the program cannot read other \
                 files"
            ))
        })
    }

    /// Reads a scenario as [`Scenario::parse_with`] does. `read` reads the files that the scenario names: it gets a
    /// file's name as written in the scenario, and returns the text of the file or the reason why the file cannot be
    /// read.
    ///
    /// # Errors
    /// Fails like [`Scenario::parse_with`]; an error about a file that the scenario names points to that file.
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
        let mut file = reader::table(&sources, &SCENARIO, "", end..end, &document)?;
        assemble::add_dolphins(&sources, &mut file)?;
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
        let tables = file.of::<ScenarioKey>();
        let libraries = libraries(&sources, tables, &mut read)?;
        let files = Files::read(&sources, &file, &mut read)?;
        let (setup, output, exercise) =
            assemble::setup(&sources, tables, &files, &libraries, &mut notices)?;
        forget_repeated(&mut notices);
        let title = tables
            .item(ScenarioKey::TITLE)
            .map_or_else(|| stem(file_name), |item| item.text().to_owned());
        let output_gives = any_keys![OutputKey: INTERVAL, TABLES].map(|key| {
            tables.item(ScenarioKey::OUTPUT).is_some_and(|item| item.table().item(key).is_some())
        });
        let report = report(tables);
        Ok(Scenario { title, report, setup, exercise, output, output_gives, notices })
    }

    /// The result tables for a run of `steps` steps, which may be another number than follows from the file's duration,
    /// as in a session that people ended at any time. The defaults for the result tables depend on the number of steps.
    #[must_use]
    pub fn output_of_steps(&self, steps: u64) -> OutputPlan {
        let [gives_interval, gives_tables] = self.output_gives;
        let OutputPlan { steps_per_row: given_steps, tables: given_tables } = self.output.clone();
        let by_default = OutputPlan::of_steps(steps as f64).steps_per_row;
        let steps_per_row = if gives_interval { given_steps } else { by_default };
        let tables =
            if gives_tables { given_tables } else { OutputPlan::default_tables(steps_per_row) };
        OutputPlan { steps_per_row, tables }
    }
}

/// The lines of the report's title page that the scenario gives.
fn report(file: Of<'_, ScenarioKey>) -> Vec<(&'static str, String)> {
    let given = file.item(ScenarioKey::REPORT).map(|item| item.table());
    let line = |key: Key<_, _>| Some((key.name(), given?.item(key)?.text().to_owned()));
    keys::report::KEYS.into_iter().filter_map(line).collect()
}

/// Keeps only one of several equal warnings, because equal warnings about each fender of a row concern the whole row.
fn forget_repeated(notices: &mut Vec<Notice>) {
    let mut known = BTreeSet::new();
    notices.retain(|notice| known.insert(notice.to_string()));
}

/// The fender and vessel libraries, with the built-in data and the files that the scenario names.
fn libraries(
    sources: &Sources<'_>,
    file: Of<'_, ScenarioKey>,
    read: &mut dyn FnMut(&str) -> Result<String, String>,
) -> Result<Libraries, ScenarioError> {
    let mut read_text = |key: Key<ScenarioKey, Texts>, name: &str| {
        read(name).map_err(|why| {
            let message = format!("`{key}`: cannot read {why}");
            sources.error(&file.given(key).span, key.name(), message).with_help(FILE_HELP)
        })
    };
    let mut fenders = Cow::Borrowed(FenderLibrary::of_program());
    let mut vessels = Cow::Borrowed(VesselLibrary::of_program());
    for name in file.given(ScenarioKey::FENDER_FILES).texts() {
        let text = read_text(ScenarioKey::FENDER_FILES, name)?;
        fenders = Cow::Owned(fenders.into_owned().with_file(&text, name)?);
    }
    for name in file.given(ScenarioKey::VESSEL_FILES).texts() {
        let text = read_text(ScenarioKey::VESSEL_FILES, name)?;
        vessels = Cow::Owned(vessels.into_owned().with_file(&text, name)?);
    }
    Ok(Libraries { fenders, vessels })
}

/// The name of a file without folders and extension.
fn stem(file_name: &str) -> String {
    let stem = std::path::Path::new(file_name).file_stem();
    stem.map_or_else(|| file_name.to_owned(), |stem| stem.to_string_lossy().into_owned())
}
