//! `cargo xtask passivity`: random impacts on fenders, none of which may gain energy.

use std::process::{Command, ExitCode};

use crate::built;
use crate::command::run;

/// Default number of impacts of each kind.
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

/// Runs `episodes` impacts of each kind in a release build, and prints the results.
///
/// # Errors
/// An impact gained energy, a closed loop along a face did work, or the build failed.
pub(crate) fn passivity(episodes: u64) -> Result<(), String> {
    run(Command::new(built::example("release", "passivity")?).arg(episodes.to_string()))
}
