//! `fenderline run`: scenario → simulation → files and a short summary.

mod fenders;
mod printed;
mod verdict;
mod world;

use std::path::{Path, PathBuf};

use fenderline_report::run_page::{self, Recorder};
use fenderline_results::{
    EstimateError, Events, Interrupted, Outcome, ProviderNotices, WorldTotals, integrator_text,
    method_text, summary,
};
use fenderline_scenario::{Notice, Place, Scenario};
use fenderline_sim::{FenderSummary, Setup, Simulation, StepRecord};

use crate::cli::RunArgs;
use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::load::load;
use crate::output::{Folder, OutputError, SUMMARY, Tables, publish};
use crate::progress::Progress;
use crate::provider::Providers;
use crate::terminal::{say, tell};
use fenderline_validate::errors_of;

/// Runs the scenario that `args` name. Nothing is written before the scenario is accepted.
///
/// A run in which something broke or was struck is complete and its files are right; its exit code is 1, unless
/// `--allow-failures` is given.
///
/// # Errors
/// Bad input. A simulation or a file that failed: no result file is left. A run that was interrupted: its files are complete
/// up to then and say so.
pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let scenario = load(&args.scenario, &args.changes)?;
    for notice in &scenario.notices {
        tell(&format!("notice: {notice}"));
    }
    let mut notices: Vec<String> = scenario.notices.iter().map(recorded).collect();
    let Scenario { title, setup, .. } = scenario;
    let mut simulation = Simulation::new(setup).map_err(error)?;
    for finding in simulation.start_findings() {
        tell(&format!("notice: {}", finding.sentence(simulation.setup())));
    }
    let interrupt = Interrupt::listen();
    let folder_path = args.out.clone().unwrap_or_else(|| default_folder(&args.scenario));
    let folder = Folder::open(&folder_path)?;
    let facts = facts(&title, &simulation);
    let (setup, start) = (simulation.setup(), simulation.energy());
    let mut tables = Tables::create(&folder, args.format, setup, start, &facts)?;
    let mut recorder = Recorder::new(simulation.setup(), simulation.energy());
    let mut events = Events::default();
    let mut world = WorldTotals::new(simulation.setup());
    let mut providers = Providers::start(&simulation)?;
    let mut provider_notices = ProviderNotices::default();

    play(
        &mut simulation,
        |simulation| providers.ask(simulation, &mut provider_notices),
        |step| {
            tables.write(step)?;
            recorder.record(step);
            events.count(step);
            world.add(step);
            Ok(())
        },
        || interrupt.is_asked(),
    )?;
    // The providers are ended before the files are written.
    drop(providers);
    let interrupted = (!simulation.is_done()).then(|| Interrupted::of(&simulation));

    if let Some(gain) = simulation.energy_gain() {
        tell(&format!("notice: {gain}"));
        notices.push(gain.to_string());
    }
    let fenders: Vec<FenderSummary> = simulation.fender_summaries().cloned().collect();
    let findings = simulation.findings();
    let outcome = Outcome {
        findings: &findings,
        title: &title,
        scenario_file: &file_name(&args.scenario),
        setup: simulation.setup(),
        notices: &notices,
        steps: simulation.steps_taken(),
        interrupted,
        states: simulation.states(),
        pairs: simulation.pair_summaries(),
        energy: simulation.energy(),
        events: &events,
        fenders: &fenders,
        berthing: simulation.berthing(),
        world: &world,
        providers: &provider_notices,
        estimate_errors: estimate_errors(simulation.setup()),
    };
    let files = tables.files();
    let summary = summary(&outcome, &files).map_err(|e| OutputError::new(SUMMARY.as_ref(), e))?;
    let report = run_page::render(&outcome, &recorder);
    let tables = tables.finish()?;
    publish(folder, tables, &report, &summary)?;
    say(&printed::summary(&outcome, &folder_path, &files))?;
    if outcome.interrupted.is_some() {
        return Err(Failure::Interrupted);
    }
    verdict::exit(&findings, args.allow_failures)
}

/// Steps `simulation` to its end, or until it `is_stopped`. `before` sets external forces before each step; `each` takes the
/// record of the step. A bar shows the progress on a terminal.
///
/// # Errors
/// A step that the simulation cannot make, or the first error of `each`.
pub(crate) fn play(
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

/// A notice for the results: without the file's path, so that a run gives the same bytes in any folder.
fn recorded(notice: &Notice) -> String {
    let Notice { place, key, message } = notice;
    match place {
        Place::File { line, .. } => format!("line {line}, {key}: {message}"),
        Place::WholeFile { .. } => format!("{key}: {message}"),
        Place::Option { text } => format!("{text}, {key}: {message}"),
    }
}

fn default_folder(scenario: &Path) -> PathBuf {
    Path::new("out").join(scenario.file_stem().unwrap_or_default())
}

fn file_name(scenario: &Path) -> String {
    scenario.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// Metadata of a table, for readers who have it without the other files.
fn facts(title: &str, simulation: &Simulation) -> Vec<(&'static str, String)> {
    let setup = simulation.setup();
    vec![
        ("title", title.to_owned()),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("method", method_text(setup.method).to_owned()),
        ("integrator", integrator_text(setup.integrator).to_owned()),
        ("step_s", format!("{:?}", setup.step_s)),
    ]
}

/// The errors of the formulas of estimated vessels; computed only if there is such a vessel.
fn estimate_errors(setup: &Setup) -> &'static [EstimateError] {
    let mut all = setup.world.vessels.iter().map(|vessel| errors_of(&vessel.origin));
    all.find(|errors| !errors.is_empty()).unwrap_or(&[])
}
