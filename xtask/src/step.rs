//! Runs a list of steps in order, up to the first failure, each step with a heading and its time.

use std::process::ExitCode;
use std::time::Instant;

use crate::tools::Missing;

/// The outcome of a step that did not fail.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Done {
    /// The step passed.
    Good,
    /// The step did not run, because a tool that it needs is missing.
    NotRun(Missing),
}

/// One step.
pub(crate) struct Step {
    /// Heading.
    pub(crate) name: &'static str,
    /// Runs the step. The step's error is a message for the user.
    pub(crate) run: fn() -> Result<Done, String>,
}

/// Runs all of `steps`. In continuous integration (where `CI` is set) a missing tool is a failure, so that no step is
/// skipped unnoticed.
pub(crate) fn run_all(steps: &[Step]) -> ExitCode {
    let strict = std::env::var_os("CI").is_some_and(|v| !v.is_empty() && v != "false");
    let began = Instant::now();
    let mut not_run = Vec::new();
    for (index, step) in steps.iter().enumerate() {
        println!("\n== {}/{} {}", index + 1, steps.len(), step.name);
        let step_began = Instant::now();
        let seconds = || step_began.elapsed().as_secs_f64();
        match (step.run)() {
            Ok(Done::Good) => println!("== good, {:.1} s", seconds()),
            Ok(Done::NotRun(missing)) if !strict => {
                let line = not_run_line(step, &missing);
                println!("== {line}");
                not_run.push(line);
            }
            Ok(Done::NotRun(missing)) => return stop(step, &not_run_line(step, &missing)),
            Err(message) => return stop(step, &message),
        }
    }
    let good = steps.len() - not_run.len();
    println!("\n== {good} of {} steps good, {:.0} s", steps.len(), began.elapsed().as_secs_f64());
    not_run.iter().for_each(|line| println!("== {line}"));
    ExitCode::SUCCESS
}

fn not_run_line(step: &Step, Missing { tool, install }: &Missing) -> String {
    format!("not run: {}: {tool} is missing; install: {install}", step.name)
}

fn stop(step: &Step, message: &str) -> ExitCode {
    println!("== stopped at: {}", step.name);
    eprintln!("{message}");
    ExitCode::FAILURE
}
