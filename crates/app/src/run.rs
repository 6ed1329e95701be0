//! `fenderline run`: scenario → simulation → files and a short summary.

mod berthing;
mod cells;
mod exercise;
mod fenders;
mod printed;
mod verdict;
mod world;

use std::path::{Path, PathBuf};

use fenderline_report::run_page;
use fenderline_results::{WrittenFile, integrator_text, method_text, summary};
use fenderline_sim::OutputPlan;

use crate::cli::RunArgs;
use crate::documents::Documents;
use crate::failure::Failure;
use crate::load::stem;
use crate::mistake::refuse_notices;
use crate::output::{Folder, LOG, OutputError, SUMMARY, Tables, publish, write_log};
use crate::played::{Played, Start};
use crate::terminal::{say, say_json};

/// Runs the scenario that `args` name. No file is written before the scenario is accepted.
///
/// A run in which something broke or was struck is complete and its files are right; its exit code is 1, unless
/// `--allow-failures` is given. The exit code is also 1 if the results are not valid, and with `--strict` if the run
/// left the range of its data.
///
/// # Errors
/// Fails if the input is bad. If the simulation or a file failed, no result file is left. If the run was interrupted,
/// its files are complete up to that time and say that it was interrupted. If a document could not be made, the result
/// files are kept.
pub(crate) fn run(args: &RunArgs) -> Result<(), Failure> {
    let overrides = args.overrides().map_err(Failure::input)?;
    let start = Start::open(&args.scenario, args.branch, &overrides)?;
    if args.strict {
        refuse_notices(start.notices())?;
    }
    let documents = Documents::of(&args.documents, start.setup())?;
    let folder_path = args.out.clone().unwrap_or_else(|| default_folder(&args.scenario));
    let folder = Folder::open(&folder_path)?;
    let output = start.output.clone();
    let facts = facts(&start, &output);
    let (setup, energy) = (start.setup(), start.energy());
    let mut tables = Tables::create(&folder, args.format, setup, energy, &output, &facts)?;
    let mut sheets = documents.sheets(&start)?;
    let played = start.play(|step| {
        tables.write(step)?;
        sheets.write(step)
    })?;
    let outcome = played.outcome();
    tables.end_interval()?;
    let mut files = tables.files();
    if let Some(session) = outcome.session {
        let rows = Some(session.log.len() as u64);
        files.push(WrittenFile { name: LOG.to_owned(), rows });
    }
    let summary = summary(&outcome, &files).map_err(|e| OutputError::new(SUMMARY.as_ref(), e))?;
    let report = run_page::render(&outcome, &played.recorder);
    let mut tables = tables.finish()?;
    if let Some(session) = outcome.session {
        tables.push(write_log(&folder, &session.log)?);
    }
    publish(folder, tables, &report, &summary)?;
    if args.json {
        say_json(&summary)?;
    } else {
        say(&printed::summary(&outcome, &folder_path, &files))?;
    }
    documents.write(&played, &report, sheets)?;
    end(&played, args.allow_failures, args.strict)
}

/// The outcome of a command that has written all its files.
///
/// # Errors
/// Fails if the run was interrupted; unless failures are allowed, if something broke or was struck or the results are
/// not valid; if `is_strict`, if the run left the range of its data.
pub(crate) fn end(played: &Played, allow_failures: bool, is_strict: bool) -> Result<(), Failure> {
    if played.interrupted.is_some() {
        return Err(Failure::Interrupted);
    }
    verdict::exit(&played.findings, allow_failures, is_strict)
}

/// A line that says that and when the run was interrupted; empty if it was not.
pub(crate) fn interrupted_line(played: &Played) -> String {
    printed::interrupted(&played.outcome())
}

/// The result of the exercise, as `run` prints it.
pub(crate) fn exercise_lines(played: &Played) -> String {
    exercise::lines(&played.outcome())
}

/// The verdict with its findings, as `run` prints it.
pub(crate) fn verdict_lines(played: &Played) -> String {
    verdict::lines(&played.outcome())
}

fn default_folder(scenario: &Path) -> PathBuf {
    Path::new("out").join(stem(scenario))
}

/// Metadata of a result table, for readers who have the table without the other files.
fn facts(start: &Start, output: &OutputPlan) -> Vec<(&'static str, String)> {
    let setup = start.setup();
    vec![
        ("title", start.title.clone()),
        ("version", env!("CARGO_PKG_VERSION").to_owned()),
        ("method", method_text(setup.method).to_owned()),
        ("integrator", integrator_text(setup.integrator).to_owned()),
        ("step_s", format!("{:?}", setup.step_s)),
        ("steps_per_row", output.steps_per_row.to_string()),
    ]
}
