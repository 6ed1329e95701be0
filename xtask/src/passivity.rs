//! `cargo xtask passivity` computes random impacts on fenders, none of which may gain energy.

use std::process::{Command, ExitCode};

use crate::built;
use crate::command::run;

/// Default number of random impacts of each kind.
pub(crate) const EPISODES: u64 = 100_000;

/// `cargo xtask passivity`.
pub(crate) fn passivity_command(episodes: u64) -> ExitCode {
    match passivity(episodes) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("{message}");
            ExitCode::FAILURE
        }
    }
}

/// Runs `episodes` random impacts of each kind in a release build, and prints the results.
///
/// # Errors
/// Fails if an impact gained energy, if a closed loop along a fender face did work, or if the build failed.
pub(crate) fn passivity(episodes: u64) -> Result<(), String> {
    run(Command::new(built::example("release", "passivity")?).arg(episodes.to_string()))
}
