//! `cargo xtask live-load`: the live server with eight clients that steer and fifty hostile ones.

use std::process::ExitCode;

use crate::command::{cargo, run};

/// Default length of a run (s), also in continuous integration.
pub(crate) const SECONDS: u64 = 20;

/// Prints late ticks, delays and memory. Fails if memory grew or a tick was missed; missed ticks do not count if times
/// are only reported.
pub(crate) fn live_load(seconds: u64, times_reported_only: bool) -> Result<(), String> {
    let test = ["test", "--release", "--package", "fenderline", "--test", "live_load", "--"];
    let mut command = cargo(test);
    command.args(["--ignored", "--nocapture"]);
    if times_reported_only {
        command.env("FENDERLINE_LIVE_TIMES_REPORTED_ONLY", "1");
    }
    run(command.env("FENDERLINE_LIVE_SECONDS", seconds.to_string()))
}

/// `cargo xtask live-load`.
pub(crate) fn live_load_command(seconds: u64) -> ExitCode {
    match live_load(seconds, false) {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}
