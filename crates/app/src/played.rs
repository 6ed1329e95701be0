//! Plays a scenario or a recorded session, from its file to the end of the run.

use std::path::Path;

use fenderline_live::{Repeat, Session};
use fenderline_report::run_page::{Recorder, WindTrace};
use fenderline_results::{
    EstimateError, Events, Interrupted, Outcome, ProviderNotices, RecordedSession, WorldTotals,
};
use fenderline_scenario::{Notice, Override, Place, Scenario};
use fenderline_sim::exercise::{Assessment, ExerciseSetup};
use fenderline_sim::{Energy, FenderSummary, Finding, OutputPlan, Setup, Simulation, StepRecord};
use fenderline_validate::errors_of;

use crate::branches::outcomes;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::load::{file_name, load};
use crate::progress::Progress;
use crate::provider::Providers;
use crate::session::{Recorded, lines_of};
use crate::terminal::notice;

/// A scenario or recorded session before its first time step.
pub(crate) struct Start {
    pub(crate) title: String,
    pub(crate) output: OutputPlan,
    report: Vec<(&'static str, String)>,
    scenario_file: String,
    notices: Vec<String>,
    /// Notices for the terminal, including those about the start of the simulation.
    told: Vec<String>,
    driven: Driven,
}

/// What drives the time steps of the run.
enum Driven {
    /// The scenario alone drives the run, with its own orders.
    Scenario(Box<Simulation>, Option<Assessment>),
    /// The commands of a recorded session drive the run. The set-up at its start is kept, because an instructor may
    /// change wind and current.
    Session(Box<Repeat>, RecordedSession, Box<Setup>, Box<Session>),
}

impl Driven {
    fn simulation(&self) -> &Simulation {
        match self {
            Driven::Scenario(simulation, _) => simulation,
            Driven::Session(repeat, ..) => repeat.simulation(),
        }
    }
}

/// A run at its end, complete or interrupted.
pub(crate) struct Played {
    pub(crate) recorder: Recorder,
    pub(crate) findings: Vec<Finding>,
    /// For each limit of the scenario, the value that is compared with it.
    pub(crate) limit_values: Vec<f64>,
    pub(crate) interrupted: Option<Interrupted>,
    title: String,
    report: Vec<(&'static str, String)>,
    scenario_file: String,
    session: Option<RecordedSession>,
    /// The set-up at the start of a recorded session; `None` for a scenario, whose set-up does not change.
    setup_at_start: Option<Box<Setup>>,
    notices: Vec<String>,
    simulation: Simulation,
    exercise: Option<Assessment>,
    events: Events,
    world: WorldTotals,
    providers: ProviderNotices,
    fenders: Vec<FenderSummary>,
}

impl Start {
    /// Reads a scenario, or one branch of a recorded session, and prints the notices.
    ///
    /// # Errors
    /// Fails if the input is bad, or if the replay of the recorded session differs.
    pub(crate) fn open(
        path: &Path,
        branch: Option<usize>,
        overrides: &[Override],
    ) -> Result<Start, Failure> {
        if fenderline_serve::is_recording(path) {
            let recorded = Recorded::load(path, branch, overrides)?;
            if let Some(missing) = &recorded.about.missing_at_end {
                notice(format_args!("{}: {missing}", path.display()));
            }
            let start = Start::of_session(recorded)?;
            return Ok(start.tell());
        }
        if branch.is_some() {
            return Err(Failure::input(format_args!(
                "error: --branch: {} is not a recorded session",
                path.display()
            )));
        }
        Start::load(path, overrides)
    }

    /// A recorded session. Tells nothing.
    ///
    /// # Errors
    /// Fails if the set-up cannot be simulated.
    pub(crate) fn of_session(recorded: Recorded) -> Result<Start, Failure> {
        let Recorded { scenario, scenario_file, repeat, session, about } = recorded;
        Start::of(scenario, scenario_file, |setup, _| {
            Ok(Driven::Session(Box::new(repeat), about, Box::new(setup), Box::new(session)))
        })
    }

    /// Reads the scenario and prints its notices.
    ///
    /// # Errors
    /// Bad input.
    pub(crate) fn load(path: &Path, overrides: &[Override]) -> Result<Start, Failure> {
        let scenario = load(path, overrides)?;
        let scenario_file = file_name(path).to_string_lossy().into_owned();
        let start = Start::of(scenario, scenario_file, |setup, exercise| {
            let simulation = Simulation::new(setup).map_err(error)?;
            let exercise = exercise.map(|exercise| Assessment::new(exercise, &simulation));
            Ok(Driven::Scenario(Box::new(simulation), exercise))
        })?;
        Ok(start.tell())
    }

    /// Prints the notices of the scenario and of its start.
    fn tell(self) -> Start {
        self.told.iter().for_each(notice);
        self
    }

    fn of(
        scenario: Scenario,
        scenario_file: String,
        driven: impl FnOnce(Setup, Option<ExerciseSetup>) -> Result<Driven, Failure>,
    ) -> Result<Start, Failure> {
        let mut told: Vec<String> = scenario.notices.iter().map(ToString::to_string).collect();
        let notices: Vec<String> = scenario.notices.iter().map(recorded).collect();
        let Scenario { title, report, setup, exercise, output, .. } = scenario;
        let driven = driven(setup, exercise)?;
        for finding in driven.simulation().start_findings() {
            told.push(finding.sentence(driven.simulation().setup()).to_string());
        }
        Ok(Start { title, output, report, scenario_file, notices, told, driven })
    }

    /// The number of notices about the scenario and about its start.
    pub(crate) fn notices(&self) -> usize {
        self.told.len()
    }

    pub(crate) fn setup(&self) -> &Setup {
        self.driven.simulation().setup()
    }

    /// The energy ledger before the first time step.
    pub(crate) fn energy(&self) -> Energy {
        self.driven.simulation().energy()
    }

    /// Plays the scenario to its end, or until Ctrl-C. The function `each` is called with the record of each step.
    ///
    /// # Errors
    /// Fails if a force provider does not start, if the simulation cannot make a step, or with the first error of
    /// `each`.
    pub(crate) fn play(
        self,
        each: impl FnMut(&StepRecord<'_>) -> Result<(), Failure>,
    ) -> Result<Played, Failure> {
        self.play_until(each, &Interrupt::listen(), Progress::new)
    }

    /// Plays the scenario like [`Start::play`], to its end or until `interrupt` is asked, but prints nothing.
    ///
    /// # Errors
    /// Fails like [`Start::play`].
    pub(crate) fn play_quietly(self, interrupt: &Interrupt) -> Result<Played, Failure> {
        self.play_until(|_| Ok(()), interrupt, |_| Progress::none())
    }

    fn play_until(
        self,
        mut each: impl FnMut(&StepRecord<'_>) -> Result<(), Failure>,
        interrupt: &Interrupt,
        progress: impl FnOnce(u64) -> Progress,
    ) -> Result<Played, Failure> {
        let Start { title, report, scenario_file, mut notices, driven, .. } = self;
        let start = driven.simulation();
        let mut recorder = Recorder::new(start.setup(), start.energy());
        let mut events = Events::default();
        let mut world = WorldTotals::new(start.setup());
        let mut providers = ProviderNotices::default();
        let mut wind = WindTrace::of(start);
        let mut each = |step: &StepRecord<'_>| {
            each(step)?;
            recorder.record(step);
            events.count(step);
            world.add(step);
            Ok(())
        };
        let (simulation, exercise, session, is_done, setup) = match driven {
            Driven::Scenario(mut simulation, mut exercise) => {
                let progress = progress(simulation.steps_total());
                let notices = &mut providers;
                let marked = (&mut *simulation, exercise.as_mut());
                play(marked, (notices, &mut wind), &mut each, interrupt, progress)?;
                let is_done = simulation.is_done();
                (*simulation, exercise, None, is_done, None)
            }
            Driven::Session(mut repeat, mut about, setup, session) => {
                let progress = progress(repeat.steps_total());
                step_through(&mut repeat, &mut wind, &mut each, interrupt, progress)?;
                let exercise = repeat.exercise().cloned();
                about.log = lines_of(repeat.log(), exercise.as_ref(), repeat.simulation().setup());
                about.beside = outcomes(&session, interrupt)?;
                (repeat.simulation().clone(), exercise, Some(about), repeat.is_done(), Some(setup))
            }
        };
        recorder.wind = Some(wind);
        if let Some(gain) = simulation.energy_gain() {
            notice(gain);
            notices.push(gain.to_string());
        }
        Ok(Played {
            recorder,
            findings: simulation.findings(),
            limit_values: simulation.limit_values(),
            interrupted: (!is_done).then(|| Interrupted::of(&simulation)),
            title,
            report,
            scenario_file,
            session,
            setup_at_start: setup,
            notices,
            events,
            world,
            providers,
            fenders: simulation.fender_summaries().cloned().collect(),
            simulation,
            exercise,
        })
    }
}

impl Played {
    /// The outcome of the run, from which summary, report and terminal text are made.
    pub(crate) fn outcome(&self) -> Outcome<'_> {
        let simulation = &self.simulation;
        Outcome {
            findings: &self.findings,
            title: &self.title,
            report: &self.report,
            scenario_file: &self.scenario_file,
            session: self.session.as_ref(),
            exercise: self.exercise.as_ref(),
            setup: self.setup_at_start.as_deref().unwrap_or(simulation.setup()),
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
            statistics: simulation.statistics(),
            limit_values: &self.limit_values,
            world: &self.world,
            providers: &self.providers,
            estimate_errors: estimate_errors(simulation.setup()),
        }
    }
}

/// The text of a notice for the result files: without the file's path, so that a run gives the same bytes in any
/// folder.
fn recorded(notice: &Notice) -> String {
    let Notice { place, key, message } = notice;
    match place {
        Place::File { line, .. } => format!("line {line}, {key}: {message}"),
        Place::WholeFile { .. } => format!("{key}: {message}"),
        Place::Option { text } => format!("{text}, {key}: {message}"),
    }
}

/// The errors of the formulas that estimate vessel data; computed only if the set-up has an estimated vessel.
fn estimate_errors(setup: &Setup) -> &'static [EstimateError] {
    let mut all = setup.world.vessels.iter().map(|vessel| errors_of(&vessel.origin));
    all.find(|errors| !errors.is_empty()).unwrap_or(&[])
}

/// Steps `simulation` to its end, or until Ctrl-C; the function `each` is called with the record of each step. The
/// force providers are asked before each step, and ended after the last step. On a terminal a bar shows the progress.
///
/// # Errors
/// Fails if a force provider does not start, if the simulation cannot make a step, or with the first error of `each`.
fn play(
    (simulation, mut exercise): (&mut Simulation, Option<&mut Assessment>),
    (notices, wind): (&mut ProviderNotices, &mut WindTrace),
    each: &mut impl FnMut(&StepRecord<'_>) -> Result<(), Failure>,
    interrupt: &Interrupt,
    mut progress: Progress,
) -> Result<(), Failure> {
    let mut providers = Providers::start(simulation)?;
    while !simulation.is_done() {
        providers.ask(simulation, notices);
        let step = simulation.step().map_err(|e| Failure::case(format_args!("error: {e}")))?;
        each(&step)?;
        progress.advance(step.index + 1);
        wind.note(simulation);
        if let Some(exercise) = &mut exercise {
            exercise.update(simulation);
        }
        if interrupt.is_asked() {
            break;
        }
    }
    Ok(())
}

/// Steps through a branch of a recorded session to its end, or until Ctrl-C.
///
/// # Errors
/// Fails if the simulation cannot make a step, or with the first error of `each`.
fn step_through(
    repeat: &mut Repeat,
    wind: &mut WindTrace,
    each: &mut impl FnMut(&StepRecord<'_>) -> Result<(), Failure>,
    interrupt: &Interrupt,
    mut progress: Progress,
) -> Result<(), Failure> {
    while !repeat.is_done() && !interrupt.is_asked() {
        let mut taken = Ok(());
        let stepped = repeat.step(|step| {
            taken = each(step);
            progress.advance(step.index + 1);
        });
        stepped.map_err(|e| Failure::case(format_args!("error: {e}")))?;
        taken?;
        wind.note(repeat.simulation());
    }
    Ok(())
}

/// A set-up that the simulation refuses is bad input.
pub(crate) fn error(error: fenderline_sim::SetupError) -> Failure {
    Failure::input(format_args!("error: {error}"))
}
