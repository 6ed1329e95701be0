//! `fenderline check` and `fenderline schema`.

use fenderline_sim::Simulation;

use crate::cli::CheckArgs;
use crate::failure::Failure;
use crate::load::load;
use crate::run::error;
use crate::terminal::{say, tell};

/// Checks a scenario as `run` would, and writes nothing.
///
/// # Errors
/// Bad input.
pub(crate) fn check(args: &CheckArgs) -> Result<(), Failure> {
    let scenario = load(&args.scenario, &args.changes)?;
    for notice in &scenario.notices {
        tell(&format!("notice: {notice}"));
    }
    let simulation = Simulation::new(scenario.setup).map_err(error)?;
    let setup = simulation.setup();
    say(&format!(
        "{}: good; {} bodies, {} pairs named, {} steps of {} s\n",
        args.scenario.display(),
        setup.bodies.len(),
        setup.pairs.len(),
        simulation.steps_total(),
        setup.step_s
    ))
}

/// Prints the JSON Schema of scenario files.
///
/// # Errors
/// Standard output that cannot be written.
pub(crate) fn schema() -> Result<(), Failure> {
    say(&format!("{:#}\n", fenderline_scenario::schema()))
}
