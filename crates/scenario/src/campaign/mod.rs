//! Campaigns: many runs of one scenario, from a file that names what differs from run to run.

mod keys;

use std::path::{Path, PathBuf};

pub(crate) use self::keys::CAMPAIGN_FILE;
use crate::checked::{Item, Table};
use crate::error::ScenarioError;
use crate::load::{LoadError, read_text};
use crate::overrides::Override;
use crate::reader;
use crate::sources::{Sources, quoted};
use crate::syntax;

type Read<T> = Result<T, ScenarioError>;

/// Most cases of a campaign.
pub const MOST_CASES: usize = 1_000_000;

/// Many runs of one scenario: every combination of the values of some variables.
///
/// ```
/// use fenderline_scenario::Campaign;
///
/// let campaign = Campaign::parse(
///     r#"
///     scenario = "quay.toml"
///     [variable.speed]
///     key = "body.ship.velocity.sway"
///     values = ["0.1 m/s", "0.2 m/s"]
///     [variable.temperature]
///     key = "fender.*.temperature"
///     values = [10, 20, 30]
///     "#,
///     "campaign.toml",
/// )?;
/// assert_eq!(campaign.cases(), 6);
/// assert_eq!(campaign.labels(4), ["0.2 m/s", "20"]);
/// # Ok::<(), fenderline_scenario::ScenarioError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Campaign {
    /// Title of its page.
    pub title: String,
    /// The scenario's file, as the campaign's file names it.
    pub scenario: PathBuf,
    /// Changes of the scenario in all runs.
    pub changes: Vec<Change>,
    /// What differs from run to run; the last one changes fastest.
    pub variables: Vec<Variable>,
}

/// What differs from run to run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// Its name.
    pub name: String,
    /// Its values; at least one.
    pub choices: Vec<Choice>,
}

/// A value of a variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The value or the name, as the file has it.
    pub label: String,
    /// The keys that it sets.
    pub changes: Vec<Change>,
}

/// A change of a scenario.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    /// KEY=VALUE, as `--set` takes it.
    pub text: String,
    /// The same, read.
    pub set: Override,
}

impl Campaign {
    /// Reads a campaign's file.
    ///
    /// # Errors
    /// [`LoadError`].
    pub fn load(path: &Path) -> Result<Campaign, LoadError> {
        let text = read_text(path).map_err(LoadError::Unreadable)?;
        let campaign = Campaign::parse(&text, &path.display().to_string());
        let campaign = campaign.map_err(LoadError::Refused)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        Ok(Campaign { scenario: folder.join(&campaign.scenario), ..campaign })
    }

    /// Reads the text of a campaign's file; `name` is for messages.
    ///
    /// # Errors
    /// The first mistake: text that is not TOML, unknown keys and bad values, a variable without values or with two kinds
    /// of them, two equal values, changes that are not KEY=VALUE, more than [`MOST_CASES`] cases.
    pub fn parse(text: &str, name: &str) -> Read<Campaign> {
        let sources = Sources::new(name, text, &[]);
        let document = syntax::parse(&sources)?;
        let end = text.trim_end().len();
        let file = reader::table(&sources, &CAMPAIGN_FILE, "", end..end, &document)?;
        let item = file.given("variable");
        let tables = item.named();
        if tables.is_empty() {
            let error = sources.error(&item.span, "variable", "there is no variable".to_owned());
            return Err(error.with_help("write [variable.NAME] with `key` and `values` below"));
        }
        let read = |(name, table): &(String, Table)| variable(&sources, name, table);
        let variables: Vec<Variable> = tables.iter().map(read).collect::<Read<_>>()?;
        let counts = variables.iter().map(|variable| variable.choices.len());
        let cases = counts.clone().try_fold(1_usize, |product, count| product.checked_mul(count));
        if cases.is_none_or(|cases| cases > MOST_CASES) {
            let factors = counts.map(|count| count.to_string()).collect::<Vec<_>>().join(" × ");
            let message = format!("{factors} are more than {MOST_CASES} cases");
            return Err(sources.error(&item.span, "variable", message));
        }
        let stem = Path::new(name).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Ok(Campaign {
            title: file.item("title").map_or(stem, |item| item.text().to_owned()),
            scenario: PathBuf::from(file.given("scenario").text()),
            changes: changes(&sources, "set", file.given("set"))?,
            variables,
        })
    }

    /// The number of cases.
    #[must_use]
    pub fn cases(&self) -> usize {
        self.variables.iter().map(|variable| variable.choices.len()).product()
    }

    /// The index of each variable's choice in a case.
    #[must_use]
    pub fn choices(&self, case: usize) -> Vec<usize> {
        let mut left = case;
        let mut chosen: Vec<usize> = self
            .variables
            .iter()
            .rev()
            .map(|variable| {
                let count = variable.choices.len();
                let own = left % count;
                left /= count;
                own
            })
            .collect();
        chosen.reverse();
        chosen
    }

    /// The value of each variable in a case, as the file has it.
    #[must_use]
    pub fn labels(&self, case: usize) -> Vec<&str> {
        self.chosen(case).map(|choice| choice.label.as_str()).collect()
    }

    /// The changes of the scenario in a case: those of all runs, then those of each variable.
    #[must_use]
    pub fn changes_of(&self, case: usize) -> Vec<Override> {
        self.all_of(case).map(|change| change.set.clone()).collect()
    }

    /// The same as `--set` takes them.
    #[must_use]
    pub fn settings_of(&self, case: usize) -> Vec<&str> {
        self.all_of(case).map(|change| change.text.as_str()).collect()
    }

    fn all_of(&self, case: usize) -> impl Iterator<Item = &Change> {
        self.changes.iter().chain(self.chosen(case).flat_map(|choice| &choice.changes))
    }

    fn chosen(&self, case: usize) -> impl Iterator<Item = &Choice> {
        let choices = self.choices(case).into_iter();
        self.variables.iter().zip(choices).map(|(variable, own)| &variable.choices[own])
    }
}

fn variable(sources: &Sources<'_>, name: &str, table: &Table) -> Read<Variable> {
    let several = table.given("choice").named();
    let refused = |item: &Item, message: String| {
        let path = table.path_of(item.name);
        Err(sources.error(&item.span, &path, format!("`{path}` {message}")))
    };
    let choices = match (table.item("key"), table.item("values")) {
        (Some(item), _) | (_, Some(item)) if !several.is_empty() => {
            return refused(item, "does not go together with `choice`".to_owned());
        }
        (Some(key), Some(values)) => {
            let one = |value: &String| {
                let text = format!("{}={value}", key.text());
                let set = Override::new(&format!("--set {text}"), key.text(), value)?;
                Ok(Choice { label: value.clone(), changes: vec![Change { text, set }] })
            };
            values.texts().iter().map(one).collect::<Read<Vec<Choice>>>()?
        }
        (None, None) if !several.is_empty() => {
            let one = |(label, choice): &(String, Table)| {
                let changes = changes(sources, &choice.path_of("set"), choice.given("set"))?;
                Ok(Choice { label: label.clone(), changes })
            };
            several.iter().map(one).collect::<Read<Vec<Choice>>>()?
        }
        (key, _) => {
            let missing = if key.is_some() { "values" } else { "key" };
            let path = table.path_of(missing);
            let error = sources.error(&table.span, &path, format!("`{path}` is missing"));
            return Err(error.with_help(
                "give `key` and `values`, or a [variable.NAME.choice.NAME] for each value",
            ));
        }
    };
    let values = table.item("values").unwrap_or(table.given("choice"));
    if choices.is_empty() {
        return refused(values, "is empty".to_owned());
    }
    for (index, choice) in choices.iter().enumerate() {
        if choices[..index].iter().any(|other| other.label == choice.label) {
            return refused(values, format!("has {} twice", quoted(&choice.label)));
        }
    }
    Ok(Variable { name: name.to_owned(), choices })
}

/// The changes of a list of KEY=VALUE.
fn changes(sources: &Sources<'_>, path: &str, item: &Item) -> Read<Vec<Change>> {
    let one = |text: &String| {
        let read = Override::parse(text).map(|set| Change { text: text.clone(), set });
        read.map_err(|error| {
            let message = format!("`{path}`: {}: {}", quoted(text), error.message());
            let help = "write KEY=VALUE, as in \"time.step=0.5 s\"";
            sources.error(&item.span, path, message).with_help(help)
        })
    };
    item.texts().iter().map(one).collect()
}
