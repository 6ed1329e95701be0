//! Campaigns: many runs of one scenario, from a file that says what differs from run to run and how the values are
//! chosen.

mod downtime;
mod keys;
mod kinds;
pub(crate) mod law;
mod number;
mod plan;
pub(crate) mod schema;
mod variable;

use std::path::{Path, PathBuf};

pub use self::downtime::Downtime;
pub(crate) use self::keys::CAMPAIGN_FILE;
use self::kinds::Read;
pub use self::kinds::{MOST_CASES, Statistic};
pub(crate) use self::plan::Limit;
pub use self::plan::{Correlation, Design, Output, Plan, Stop};
use self::variable::changes;
pub use self::variable::{Change, Choice, Draw, Target, TargetOrigins, Variable};
use crate::file::keys::CampaignFileKey;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::sources::Sources;
use fenderline_keys::typed_key::AnyKey;
use fenderline_keys::{reader, syntax};
use fenderline_scenario::{LoadError, read_text};

/// A campaign: many runs of one scenario.
///
/// ```
/// use fenderline_campaign::{Campaign, Plan};
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
/// assert_eq!(campaign.plan, Plan::FullFactorial);
/// assert_eq!(campaign.cases(), 6);
/// assert_eq!(campaign.labels(4), ["0.2 m/s", "20"]);
///
/// let random = Campaign::parse(
///     r#"
///     scenario = "quay.toml"
///     number = 1000
///     [variable.speed]
///     key = "body.ship.velocity.sway"
///     distribution = "lognormal"
///     mean = "7.1 cm/s"
///     standard_deviation = "4.47 cm/s"
///     "#,
///     "campaign.toml",
/// )?;
/// assert_eq!(random.plan, Plan::MonteCarlo { number: 1000 });
/// # Ok::<(), fenderline_scenario::ScenarioError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Campaign {
    /// Title of the campaign, as its report shows it.
    pub title: String,
    /// The scenario's file, as the campaign's file names it.
    pub scenario: PathBuf,
    /// Changes of the scenario in all runs.
    pub changes: Vec<Change>,
    /// How the values of the variables are chosen.
    pub plan: Plan,
    /// Seed of the random numbers.
    pub seed: u64,
    /// The variables, whose values differ from run to run; in a full factorial the last variable changes fastest. A
    /// downtime campaign has no variables until its weather is read.
    pub variables: Vec<Variable>,
    /// Correlations of variables with a distribution.
    pub correlations: Vec<Correlation>,
    /// Further numbers of each run, as the file names them.
    pub outputs: Vec<String>,
    /// Outputs by expressions.
    pub expressions: Vec<Output>,
    /// Name of the output that is 1 if a run succeeds.
    pub success: Option<String>,
    /// Limits with which the report compares outputs.
    pub limits: Vec<Limit>,
    /// The stop rule, by which the campaign may end early.
    pub stop: Option<Stop>,
    /// The events to which design values refer.
    pub design: Option<Design>,
    /// Largest number of time steps of a run.
    pub most_steps: u64,
}

impl Campaign {
    /// Reads a campaign's file. The files that the campaign's file names lie beside it.
    ///
    /// # Errors
    /// [`LoadError`].
    pub fn load(path: &Path) -> Result<Campaign, LoadError> {
        let text = read_text(path).map_err(LoadError::Unreadable)?;
        let campaign = Campaign::parse(&text, &path.display().to_string());
        let mut campaign = campaign.map_err(LoadError::Refused)?;
        let folder = path.parent().unwrap_or(Path::new(""));
        campaign.scenario = folder.join(&campaign.scenario);
        match &mut campaign.plan {
            Plan::Table { file } | Plan::Downtime(Downtime { file, .. }) => {
                *file = folder.join(&*file);
            }
            _ => {}
        }
        for variable in &mut campaign.variables {
            if let Draw::Measured { file, .. } = &mut variable.draw {
                *file = folder.join(&*file);
            }
        }
        Ok(campaign)
    }

    /// Whether a text is a campaign rather than a scenario, by its keys; false for a text that is not TOML.
    #[must_use]
    pub fn is_one(text: &str) -> bool {
        let document = syntax::parse(&Sources::new("", text, &[]));
        document.is_ok_and(|keys| {
            let has = |key: AnyKey<CampaignFileKey>| keys.contains_key(key.name());
            has(CampaignFileKey::SCENARIO.any()) || has(CampaignFileKey::VARIABLE.any())
        })
    }

    /// Reads the text of a campaign's file; `name` is for messages.
    ///
    /// # Errors
    /// Reports the first mistake: text that is not TOML, an unknown key or a bad value, a variable without values or
    /// with two kinds of values, a law without parameters or without probability, two equal values, a change that is
    /// not KEY=VALUE, more than [`MOST_CASES`] cases of a full factorial, a plan that does not go with the variables,
    /// or correlations that contradict each other.
    pub fn parse(text: &str, name: &str) -> Read<Campaign> {
        let sources = Sources::new(name, text, &[]);
        let document = syntax::parse(&sources)?;
        let end = text.trim_end().len();
        let file = reader::table(&sources, &CAMPAIGN_FILE, "", end..end, &document)?;
        let file = file.of::<CampaignFileKey>();
        let downtime = downtime::read(&sources, file)?;
        let item = file.item(CampaignFileKey::VARIABLE);
        let tables = item.map(Entry::named).unwrap_or_default();
        if tables.is_empty() && downtime.is_none() {
            let span = item.map_or(&file.span, |item| &item.item().span);
            let error = sources.error(
                span,
                CampaignFileKey::VARIABLE.name(),
                "there is no variable".to_owned(),
            );
            return Err(error.with_help(
                "write [variable.NAME] with `key` and `values` below, or [downtime] with the `file` of a weather",
            ));
        }
        let kind = plan::kind(file);
        let read =
            |(name, table): (&String, Of<'_, _>)| variable::read(&sources, name, table, kind);
        let variables: Vec<Variable> = tables.iter().map(read).collect::<Read<_>>()?;
        let stem = Path::new(name).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        Ok(Campaign {
            title: file.item(CampaignFileKey::TITLE).map_or(stem, |item| item.text().to_owned()),
            scenario: PathBuf::from(file.given(CampaignFileKey::SCENARIO).text()),
            changes: changes(&sources, "set", file.given(CampaignFileKey::SET))?,
            plan: match downtime {
                Some(downtime) => Plan::Downtime(downtime),
                None => plan::read(&sources, file, kind, &variables)?,
            },
            seed: *file.given(CampaignFileKey::SEED).number() as u64,
            correlations: plan::correlations(&sources, file, &variables)?,
            outputs: file.given(CampaignFileKey::OUTPUTS).texts().to_vec(),
            expressions: plan::outputs(&sources, file, &variables)?,
            success: file.item(CampaignFileKey::SUCCESS).map(|item| item.text().to_owned()),
            limits: plan::limits(file),
            stop: plan::stop(&sources, file)?,
            design: plan::design(&sources, file)?,
            most_steps: *file.given(CampaignFileKey::MOST_STEPS).number() as u64,
            variables,
        })
    }

    /// The number of cases of a full factorial: the product of the variables' numbers of values.
    #[must_use]
    pub fn cases(&self) -> usize {
        self.variables.iter().map(|variable| variable.choices().len().max(1)).product()
    }

    /// The index of each variable's choice in a case of a full factorial; 0 for an expression.
    #[must_use]
    pub fn choices(&self, case: usize) -> Vec<usize> {
        let mut left = case;
        let mut chosen: Vec<usize> = self
            .variables
            .iter()
            .rev()
            .map(|variable| {
                let count = variable.choices().len().max(1);
                let own = left % count;
                left /= count;
                own
            })
            .collect();
        chosen.reverse();
        chosen
    }

    /// The value of each variable in a case of a full factorial, as written in the file; empty for an expression.
    #[must_use]
    pub fn labels(&self, case: usize) -> Vec<&str> {
        let choices = self.choices(case).into_iter();
        let mut labels = Vec::new();
        for (variable, own) in self.variables.iter().zip(choices) {
            labels.push(variable.choices().get(own).map_or("", |choice| choice.label.as_str()));
        }
        labels
    }
}
