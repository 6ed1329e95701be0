//! `cargo xtask passivity`: random hits on fender faces, of which none may make energy.

use std::process::ExitCode;

use crate::command::{cargo, run};

/// Hits of each kind where the caller does not say.
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

/// Plays `episodes` hits of each kind, optimised, and prints what came out.
///
/// # Errors
/// A hit gained, a closed loop along a face did work, or it was not built.
pub(crate) fn passivity(episodes: u64) -> Result<(), String> {
    let example = ["run", "--quiet", "--release", "--package", "fenderline-sim", "--example"];
    run(cargo(example).args(["passivity", "--"]).arg(episodes.to_string()))
}
