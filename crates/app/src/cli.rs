//! The command line.

use std::path::PathBuf;

use clap::{Args, Parser, Subcommand};
use fenderline_scenario::{Override, ScenarioError};

use crate::output::Format;

/// Ship, fender, quay and tug contact: run, check and validate scenarios.
///
/// Exit codes: 0 done, 1 the case failed, 2 bad input.
#[derive(Debug, Parser)]
#[command(name = "fenderline", version, propagate_version = true)]
pub(crate) struct Cli {
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Run a scenario: print a summary, write tables, summary.json and report.html
    Run(RunArgs),
    /// Reproduce published cases: a table of ours beside theirs; exit code 1 where one is out of
    /// tolerance
    Validate(ValidateArgs),
    /// Print the JSON Schema of scenario files
    Schema,
    /// Parse and check a scenario without running it
    Check(CheckArgs),
}

#[derive(Debug, Args)]
pub(crate) struct RunArgs {
    /// Scenario file
    #[arg(value_name = "SCENARIO.toml")]
    pub(crate) scenario: PathBuf,
    /// Folder for the results; without it `out/`, then the name of the scenario file
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Format of the tables of bodies, contacts, fenders and energy
    #[arg(long, value_enum, default_value_t = Format::Csv)]
    pub(crate) format: Format,
    #[command(flatten)]
    pub(crate) changes: Changes,
}

#[derive(Debug, Args)]
pub(crate) struct ValidateArgs {
    /// Folder for validation.html, validation.csv and validation.json [default: none is written]
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    /// Scenario file
    #[arg(value_name = "SCENARIO.toml")]
    pub(crate) scenario: PathBuf,
    #[command(flatten)]
    pub(crate) changes: Changes,
}

/// Keys of the scenario that the command line overrides.
#[derive(Debug, Default, Args)]
pub(crate) struct Changes {
    /// Time step, such as 0.5 or "0.5 s"; short for --set time.step=S
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    step: Option<String>,
    /// Length of the run, such as 60 or "1 min"; short for --set time.duration=S
    #[arg(long, value_name = "S", allow_hyphen_values = true)]
    duration: Option<String>,
    /// Contact method; short for --set contact.method=METHOD
    #[arg(long, value_name = "METHOD")]
    method: Option<String>,
    /// Override one key of the scenario, such as body.tug.velocity.surge="2 kn"; repeatable
    #[arg(long = "set", value_name = "KEY=VALUE")]
    set: Vec<String>,
}

impl Changes {
    /// All changes, the shorthands first.
    ///
    /// # Errors
    /// A text that is no `KEY=VALUE`.
    pub(crate) fn overrides(&self) -> Result<Vec<Override>, ScenarioError> {
        let shorthands = [
            ("--step", "time.step", &self.step),
            ("--duration", "time.duration", &self.duration),
            ("--method", "contact.method", &self.method),
        ];
        let shorthands = shorthands.into_iter().filter_map(|(option, key, value)| {
            let value = value.as_ref()?;
            Some(Override::new(&format!("{option} {value}"), key, value))
        });
        shorthands.chain(self.set.iter().map(|text| Override::parse(text))).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::CommandFactory as _;

    #[test]
    fn the_command_line_is_well_formed() {
        Cli::command().debug_assert();
    }
}
