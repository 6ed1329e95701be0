//! A scenario from its file to the end of its run.

use std::path::Path;

use fenderline_report::run_page::Recorder;
use fenderline_results::{
    EstimateError, Events, Interrupted, Outcome, ProviderNotices, WorldTotals,
};
use fenderline_scenario::{Notice, Override, Place, Scenario};
use fenderline_sim::{Energy, FenderSummary, Finding, OutputPlan, Setup, Simulation, StepRecord};
use fenderline_validate::errors_of;

use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::load::{file_name, load};
use crate::progress::Progress;
use crate::provider::Providers;
use crate::terminal::notice;

/// A scenario before its first step.
pub(crate) struct Start {
    pub(crate) title: String,
    pub(crate) output: OutputPlan,
    report: Vec<(&'static str, String)>,
    scenario_file: String,
    notices: Vec<String>,
    /// Notices that were printed, with those of the start.
    told: usize,
    simulation: Simulation,
}

/// A run at its end, complete or interrupted.
pub(crate) struct Played {
    pub(crate) recorder: Recorder,
    pub(crate) findings: Vec<Finding>,
    pub(crate) interrupted: Option<Interrupted>,
    title: String,
    report: Vec<(&'static str, String)>,
    scenario_file: String,
    notices: Vec<String>,
    simulation: Simulation,
    events: Events,
    world: WorldTotals,
    providers: ProviderNotices,
    fenders: Vec<FenderSummary>,
}

impl Start {
    /// Reads the scenario and tells its notices.
    ///
    /// # Errors
    /// Bad input.
    pub(crate) fn load(path: &Path, overrides: &[Override]) -> Result<Start, Failure> {
        let scenario = load(path, overrides)?;
        scenario.notices.iter().for_each(notice);
        let notices = scenario.notices.iter().map(recorded).collect();
        let scenario_notices = scenario.notices.len();
        let Scenario { title, report, setup, output, .. } = scenario;
        let simulation = Simulation::new(setup).map_err(error)?;
        let mut told = scenario_notices;
        for finding in simulation.start_findings() {
            told += 1;
            notice(finding.sentence(simulation.setup()));
        }
        let scenario_file = file_name(path).to_string_lossy().into_owned();
        Ok(Start { title, output, report, scenario_file, notices, told, simulation })
    }

    /// The number of notices, of the scenario and of its start.
    pub(crate) fn notices(&self) -> usize {
        self.told
    }

    pub(crate) fn setup(&self) -> &Setup {
        self.simulation.setup()
    }

    /// The ledger before the first step.
    pub(crate) fn energy(&self) -> Energy {
        self.simulation.energy()
    }

    /// Plays the scenario to its end, or to Ctrl-C. `each` takes the record of each step.
    ///
    /// # Errors
    /// A provider that does not start, a step that the simulation cannot make, or the first error of `each`.
    pub(crate) fn play(
        self,
        mut each: impl FnMut(&StepRecord<'_>) -> Result<(), Failure>,
    ) -> Result<Played, Failure> {
        let Start { title, report, scenario_file, mut notices, mut simulation, .. } = self;
        let interrupt = Interrupt::listen();
        let mut recorder = Recorder::new(simulation.setup(), simulation.energy());
        let mut events = Events::default();
        let mut world = WorldTotals::new(simulation.setup());
        let mut processes = Providers::start(&simulation)?;
        let mut providers = ProviderNotices::default();
        play(
            &mut simulation,
            |simulation| processes.ask(simulation, &mut providers),
            |step| {
                each(step)?;
                recorder.record(step);
                events.count(step);
                world.add(step);
                Ok(())
            },
            || interrupt.is_asked(),
        )?;
        // The providers are ended before the files are written.
        drop(processes);
        if let Some(gain) = simulation.energy_gain() {
            notice(gain);
            notices.push(gain.to_string());
        }
        Ok(Played {
            recorder,
            findings: simulation.findings(),
            interrupted: (!simulation.is_done()).then(|| Interrupted::of(&simulation)),
            title,
            report,
            scenario_file,
            notices,
            events,
            world,
            providers,
            fenders: simulation.fender_summaries().cloned().collect(),
            simulation,
        })
    }
}

impl Played {
    /// The run for summary, report and terminal.
    pub(crate) fn outcome(&self) -> Outcome<'_> {
        let simulation = &self.simulation;
        Outcome {
            findings: &self.findings,
            title: &self.title,
            report: &self.report,
            scenario_file: &self.scenario_file,
            setup: simulation.setup(),
            notices: &self.notices,
            steps: simulation.steps_taken(),
            interrupted: self.interrupted.clone(),
            states: simulation.states(),
            pairs: simulation.pair_summaries(),
            energy: simulation.energy(),
            events: &self.events,
            fenders: &self.fenders,
            dolphins: simulation.dolphin_summaries(),
            berthing: simulation.berthing(),
            world: &self.world,
            providers: &self.providers,
            estimate_errors: estimate_errors(simulation.setup()),
        }
    }
}

/// A notice for the results: without the file's path, so that a run gives the same bytes in any folder.
fn recorded(notice: &Notice) -> String {
    let Notice { place, key, message } = notice;
    match place {
        Place::File { line, .. } => format!("line {line}, {key}: {message}"),
        Place::WholeFile { .. } => format!("{key}: {message}"),
        Place::Option { text } => format!("{text}, {key}: {message}"),
    }
}

/// The errors of the formulas of estimated vessels; computed only if there is such a vessel.
fn estimate_errors(setup: &Setup) -> &'static [EstimateError] {
    let mut all = setup.world.vessels.iter().map(|vessel| errors_of(&vessel.origin));
    all.find(|errors| !errors.is_empty()).unwrap_or(&[])
}

/// Steps `simulation` to its end, or until it `is_stopped`. `before` sets external forces before each step; `each` takes the
/// record of the step. A bar shows the progress on a terminal.
///
/// # Errors
/// A step that the simulation cannot make, or the first error of `each`.
fn play(
    simulation: &mut Simulation,
    mut before: impl FnMut(&mut Simulation),
    mut each: impl FnMut(&StepRecord<'_>) -> Result<(), Failure>,
    is_stopped: impl Fn() -> bool,
) -> Result<(), Failure> {
    let mut progress = Progress::new(simulation.steps_total());
    while !simulation.is_done() {
        before(simulation);
        let step = simulation.step().map_err(|e| Failure::case(format_args!("error: {e}")))?;
        each(&step)?;
        progress.advance(step.index + 1);
        if is_stopped() {
            break;
        }
    }
    Ok(())
}

/// A set-up that the simulation refuses is bad input.
pub(crate) fn error(error: fenderline_sim::SetupError) -> Failure {
    Failure::input(format_args!("error: {error}"))
}
