//! `fenderline check` and `fenderline schema`.

use fenderline_scenario::printable_number;
use fenderline_sim::Simulation;

use crate::cli::{CheckArgs, SchemaOf};
use crate::failure::Failure;
use crate::load::load;
use crate::run::error;
use crate::terminal::{say, say_json, tell};
use crate::vessels::estimates;
use fenderline_report::plot::counted;

/// Checks a scenario as `run` does, and writes nothing.
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
    for finding in simulation.start_findings() {
        tell(&format!("notice: {}", finding.sentence(setup)));
    }
    say(&format!(
        "{}: good; {}, {} named, {} of {} s\n",
        args.scenario.display(),
        counted(setup.bodies.len() as u64, "body", "bodies"),
        counted(setup.pairs.len() as u64, "pair", "pairs"),
        counted(simulation.steps_total(), "step", "steps"),
        printable_number(setup.step_s)
    ))?;
    for vessel in &setup.world.vessels {
        say(&estimates(&setup.bodies[vessel.body].name, &vessel.origin))?;
    }
    Ok(())
}

/// Prints the JSON Schema of a kind of file.
///
/// # Errors
/// Standard output that cannot be written.
pub(crate) fn schema(of: SchemaOf) -> Result<(), Failure> {
    let schema = match of {
        SchemaOf::Scenario => fenderline_scenario::schema(),
        SchemaOf::Fenders => fenderline_scenario::fender_schema(),
        SchemaOf::Vessels => fenderline_scenario::vessel_schema(),
    };
    say_json(&format!("{schema:#}\n"))
}
