//! Runs of a campaign.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::file::{Campaign, Change, Draw, Plan, TargetOrigins};
use fenderline_contact::hash::Fnv1a;
use fenderline_results::WorldTotals;
use fenderline_scenario::{LoadError, Notice, Override, Place, Scenario, ScenarioError, read_text};
use fenderline_sim::{Simulation, Start};

use super::motion::Excursion;
use super::numbers::Numbers;
use super::outputs::Outputs;
use crate::downtime::DowntimePlan;
use crate::draw::{Drawn, Draws};
use crate::error::CampaignError;
use crate::limit::Limit;
use crate::row::{Cell, Head, Row};

/// A campaign with everything that its runs share.
pub struct Runs {
    campaign: Campaign,
    draws: Draws,
    source: Source,
    base: Scenario,
    /// Whether the base is the scenario with the changes of all runs, so that a run may differ from the base only in
    /// its start.
    is_common: bool,
    outputs: Outputs,
    limits: Vec<Limit>,
}

/// The scenario's text and the files that the scenario names, which are read only once.
struct Source {
    name: String,
    text: String,
    folder: PathBuf,
    files: BTreeMap<String, String>,
}

impl Source {
    fn parse(&self, overrides: &[Override]) -> Result<Scenario, ScenarioError> {
        let mut read = |file: &str| match self.files.get(file) {
            Some(text) => Ok(text.clone()),
            // A file that only this run names.
            None => read_text(&self.folder.join(file)),
        };
        Scenario::parse_among(&self.text, &self.name, overrides, &mut read)
    }

    /// Reads the scenario with the changes that all runs have. If the scenario with these changes is not valid, reads
    /// it also with the changes of the run `first`, and returns false.
    fn load(
        path: &Path,
        changes: &[Override],
        first: &[Override],
    ) -> Result<(Source, Scenario, bool), LoadError> {
        let text = read_text(path).map_err(LoadError::Unreadable)?;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        let mut files = BTreeMap::new();
        let name = path.display().to_string();
        let mut read = |file: &str| {
            let text = read_text(&folder.join(file))?;
            files.insert(file.to_owned(), text.clone());
            Ok(text)
        };
        let (base, is_common) = match Scenario::parse_among(&text, &name, changes, &mut read) {
            Ok(base) => (base, true),
            Err(_) => {
                let all: Vec<Override> = changes.iter().chain(first).cloned().collect();
                let base = Scenario::parse_among(&text, &name, &all, &mut read);
                // Neither is valid: `refuse_hopeless` tries other runs, and needs a base to describe them.
                (base.map_err(LoadError::Refused)?, false)
            }
        };
        Ok((Source { name, text, folder, files }, base, is_common))
    }
}

impl Runs {
    /// Reads the scenario and everything that the campaign names.
    ///
    /// # Errors
    /// [`CampaignError`] if there is a mistake in the campaign, in one of its files, or in the scenario with the
    /// changes that all runs have; or if none of the first thousand runs can be made.
    pub fn new(campaign: Campaign) -> Result<Runs, CampaignError> {
        let draws = Draws::new(&campaign)?;
        let changes: Vec<Override> =
            campaign.changes.iter().map(|change| change.set.clone()).collect();
        let first = draws.located(&draws.of_run(0), Some(0)).map_err(LoadError::Refused)?;
        let (source, base, is_common) = Source::load(&campaign.scenario, &changes, &first)?;
        if !base.setup.world.providers.is_empty() {
            let why = "the scenario has a [[provider]], which only `fenderline run` starts";
            return Err(CampaignError::part("scenario", why));
        }
        let mut campaign = campaign;
        if let Some(downtime) = draws.downtime() {
            downtime.check(&base)?;
            let variables = downtime.variables(&campaign).into_iter();
            campaign.variables = variables.map(|(variable, _)| variable).collect();
            let limits = base.setup.world.statistics.limits.iter();
            let mut outputs: Vec<String> =
                limits.map(|limit| format!("limit.{}", limit.name)).collect();
            let own = campaign.outputs.iter().filter(|name| !outputs.contains(name)).cloned();
            outputs.extend(own.collect::<Vec<_>>());
            campaign.outputs = outputs;
        }
        let outputs = Outputs::new(&campaign, &base.setup, draws.heads())?;
        if let Some(stop) = &campaign.stop
            && !outputs.heads.iter().any(|head| head.name == stop.output && !head.is_text)
        {
            let names = outputs.heads.iter().map(|head| head.name.as_str());
            let near = fenderline_scenario::nearest(&stop.output, names);
            let near = near.map_or(String::new(), |near| format!("; did you mean `{near}`?"));
            return Err(CampaignError::part(
                "stop.output",
                format!("the campaign has no number `{}`{near}", stop.output),
            ));
        }
        let limits = Limit::all(&campaign, &outputs.heads)?;
        let runs = Runs { campaign, draws, source, base, is_common, outputs, limits };
        runs.refuse_hopeless()?;
        Ok(runs)
    }

    /// The campaign.
    #[must_use]
    pub fn campaign(&self) -> &Campaign {
        &self.campaign
    }

    /// The draws of the campaign's variables.
    #[must_use]
    pub fn draws(&self) -> &Draws {
        &self.draws
    }

    /// The base: the scenario with the changes that all runs have.
    #[must_use]
    pub fn base(&self) -> &Scenario {
        &self.base
    }

    /// The states and hours of a downtime campaign; `None` for another campaign.
    #[must_use]
    pub fn downtime(&self) -> Option<&DowntimePlan> {
        self.draws.downtime()
    }

    /// The number of runs.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.draws.runs()
    }

    /// The heads of the table's columns, without the column of the run's number.
    #[must_use]
    pub fn heads(&self) -> &[Head] {
        &self.outputs.heads
    }

    /// Its limits of outputs.
    #[must_use]
    pub fn limits(&self) -> &[Limit] {
        &self.limits
    }

    /// The fingerprint of a campaign: a hash of the draws, the scenario with its files, and the columns. The hashes of
    /// two campaigns differ if their rows may differ.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        let mut hash = Fnv1a::default();
        let mut add = |text: &str| {
            hash.bytes(text.as_bytes());
            hash.bytes(&[0]);
        };
        add(env!("CARGO_PKG_VERSION"));
        add(&format!("{:?}", rows_of(&self.campaign)));
        add(&self.source.text);
        for (name, text) in &self.source.files {
            add(name);
            add(text);
        }
        for head in self.heads() {
            add(&head.name);
        }
        self.draws.add_values(&mut hash);
        hash.finish()
    }

    /// All changes of a run, written as for `--set`: first the changes that all runs have, then those of this run.
    #[must_use]
    pub fn settings(&self, run: u64) -> Vec<String> {
        let common = self.campaign.changes.iter().map(|change| change.text.clone());
        common.chain(self.draws.of_run(run).settings).collect()
    }

    /// Refuses a campaign if none of its first runs can start: the error then concerns the campaign's file, not a
    /// single run.
    fn refuse_hopeless(&self) -> Result<(), CampaignError> {
        let mut first = None;
        for run in 0..self.count().min(TRIED) {
            match self.begun(run) {
                Ok(_) => return Ok(()),
                Err(error) => {
                    first.get_or_insert(error);
                }
            }
        }
        first.map_or(Ok(()), |first| Err(CampaignError::Hopeless(Box::new(first))))
    }

    /// Makes the simulation of run `run` (counted from 0) before its first step, and the notices of its scenario.
    ///
    /// # Errors
    /// Fails if the scenario with the run's values is refused (the error has a place in the campaign's file, or in the
    /// file of the values), cannot start, or has more than `most_steps` time steps.
    pub fn begun(&self, run: u64) -> Result<(Simulation, Vec<Notice>), CampaignError> {
        let own =
            self.draws.located(&self.draws.of_run(run), Some(run)).map_err(LoadError::Refused)?;
        let Scenario { setup, notices, .. } = self.scenario(&own).map_err(LoadError::Refused)?;
        let refused =
            |why: String| CampaignError::part("scenario", format!("run {}: {why}", run + 1));
        let simulation = Simulation::new(setup).map_err(|why| refused(why.to_string()))?;
        self.check_steps(&simulation).map_err(refused)?;
        Ok((simulation, notices))
    }

    /// Refuses a run that would never end.
    fn check_steps(&self, simulation: &Simulation) -> Result<(), String> {
        let (steps, most) = (simulation.steps_total(), self.campaign.most_steps);
        match steps > most {
            true => Err(format!("the run has {steps} time steps, more than `most_steps` {most}")),
            false => Ok(()),
        }
    }

    /// The reason why a run's scenario was refused, with the file and line of the value if the value came from a file.
    fn with_row(&self, drawn: &Drawn, why: String) -> String {
        let refused = match self.draws.located(drawn, None) {
            Ok(overrides) => self.scenario(&overrides).err(),
            Err(error) => Some(error),
        };
        match refused.as_ref().map(ScenarioError::place) {
            Some(Place::File { name, line, .. }) if self.draws.reads(name) => {
                // Without its folder: a table has the same bytes on every machine.
                let file = Path::new(name).file_name().unwrap_or_default().to_string_lossy();
                format!("{why}; {file}, line {line}")
            }
            _ => why,
        }
    }

    /// Reads the scenario with the values of a run.
    fn scenario(&self, own: &[Override]) -> Result<Scenario, ScenarioError> {
        let common = self.campaign.changes.iter().map(|change| change.set.clone());
        let all: Vec<Override> = common.chain(own.iter().cloned()).collect();
        self.source.parse(&all)
    }
}

/// Copies a campaign without the parts that change no row of its table: title, parts for the report, and the folders of
/// its files. The hash takes the content of the files instead.
fn rows_of(campaign: &Campaign) -> Campaign {
    let mut campaign = campaign.clone();
    campaign.title = String::new();
    campaign.scenario = PathBuf::new();
    (campaign.design, campaign.success) = (None, None);
    campaign.limits.clear();
    campaign.changes.iter_mut().for_each(unplaced);
    match &mut campaign.plan {
        Plan::Table { file } => *file = PathBuf::new(),
        Plan::Downtime(of) => (of.file, of.origin) = (PathBuf::new(), None),
        _ => {}
    }
    for variable in &mut campaign.variables {
        variable.source = None;
        match &mut variable.draw {
            Draw::Choices(choices) => {
                choices.iter_mut().flat_map(|choice| &mut choice.changes).for_each(unplaced);
            }
            Draw::Measured { file, target, .. } => {
                *file = PathBuf::new();
                target.origins = TargetOrigins::default();
            }
            Draw::Law(_, target)
            | Draw::Expression { target, .. }
            | Draw::Column { target, .. } => target.origins = TargetOrigins::default(),
        }
    }
    campaign
}

/// Forgets at which place of the campaign's file a key stands.
fn unplaced(change: &mut Change) {
    change.set = change.set.clone().without_origins();
}

/// Number of first runs of which at least one must be able to start.
const TRIED: u64 = 1000;

/// Makes runs one after the other; one for each thread.
pub struct Runner<'r> {
    runs: &'r Runs,
    start: Start,
    /// The simulation of the last run, which is restarted if runs differ only in their start.
    own: Option<Simulation>,
    /// Whether `own` is a simulation of the base scenario.
    is_of_base: bool,
}

impl<'r> Runner<'r> {
    /// A runner.
    #[must_use]
    pub fn new(runs: &'r Runs) -> Runner<'r> {
        Runner { runs, start: runs.base.setup.start(), own: None, is_of_base: false }
    }

    /// Makes the run of the given number, counted from 0; `None` if the run was stopped before its end. A run that
    /// cannot be made becomes a row with the reason.
    pub fn run(&mut self, run: u64, is_stopped: &dyn Fn() -> bool) -> Option<Row> {
        let drawn = self.runs.draws.of_run(run);
        self.of(drawn, is_stopped).map(|cells| Row { run, cells })
    }

    /// The cells of a run with the given drawn values; `None` if the run was stopped before its end.
    pub fn of(&mut self, drawn: Drawn, is_stopped: &dyn Fn() -> bool) -> Option<Vec<Cell>> {
        let outputs = &self.runs.outputs;
        let failed = |values: Vec<Cell>, why: String| Some(outputs.cells_of_failure(values, why));
        let notices = match self.begin(&drawn) {
            Ok(notices) => notices,
            Err(why) => return failed(drawn.values, why),
        };
        let simulation = self.own.as_mut().expect("a run has begun");
        if let Err(why) = self.runs.check_steps(simulation) {
            return failed(drawn.values, why);
        }
        let mut world = WorldTotals::new(simulation.setup());
        let states = simulation.states();
        let mut motions: Vec<(usize, Excursion)> =
            outputs.bodies.iter().map(|body| (*body, Excursion::new(&states[*body]))).collect();
        let mut touching = 0_u64;
        while !simulation.is_done() {
            match simulation.step() {
                Ok(step) => {
                    world.add(&step);
                    touching +=
                        u64::from(step.contacts.iter().any(|contact| contact.fender.is_some()));
                    for (body, motion) in &mut motions {
                        motion.add(&step.states_after[*body]);
                    }
                }
                Err(error) => return failed(drawn.values, error.to_string()),
            }
            if is_stopped() {
                return None;
            }
        }
        let alongside_s = touching as f64 * simulation.setup().step_s;
        let numbers = Numbers::of(simulation, &world, alongside_s, notices);
        Some(outputs.cells(drawn.values, simulation, &world, &motions, &numbers))
    }

    /// The simulation of a run before its first step; `None` for a run that cannot be made or has too many steps.
    pub(super) fn started(&mut self, run: u64) -> Option<&mut Simulation> {
        let drawn = self.runs.draws.of_run(run);
        self.begin(&drawn).ok()?;
        let most = self.runs.campaign.most_steps;
        self.own.as_mut().filter(|own| own.steps_total() <= most)
    }

    /// Puts the simulation of a run before its first step into `own`; returns the number of the scenario's notices.
    fn begin(&mut self, drawn: &Drawn) -> Result<usize, String> {
        let runs = self.runs;
        let overrides = drawn.overrides().map_err(|why| runs.with_row(drawn, why))?;
        let base = &runs.base;
        if runs.is_common
            && base.setup.restarts_in_place()
            && base.start_with(&overrides, &mut self.start)
        {
            let own = match self.own.take().filter(|_| self.is_of_base) {
                Some(own) => own,
                None => Simulation::new(base.setup.clone()).map_err(|error| one_line(&error))?,
            };
            self.is_of_base = true;
            let own = self.own.insert(own);
            own.restart(&self.start).map_err(|error| one_line(&error))?;
            return Ok(base.notices.len());
        }
        let scenario =
            runs.scenario(&overrides).map_err(|error| runs.with_row(drawn, one_line(&error)))?;
        let notices = scenario.notices.len();
        self.is_of_base = false;
        self.own = Some(Simulation::new(scenario.setup).map_err(|error| one_line(&error))?);
        Ok(notices)
    }
}

/// Puts the message and the help of an error into one line, without the place that stands between them.
fn one_line(error: &dyn core::fmt::Display) -> String {
    let text = error.to_string();
    let line = text.lines().next().unwrap_or_default();
    let message = line.strip_prefix("error: ").unwrap_or(line);
    let help = text.lines().find_map(|line| line.trim_start().strip_prefix("= help: "));
    help.map_or_else(|| message.to_owned(), |help| format!("{message}; {help}"))
}
