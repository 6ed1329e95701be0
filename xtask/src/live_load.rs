//! `cargo xtask live-load`: the live server with eight clients that steer and fifty hostile ones.

use std::process::ExitCode;

use crate::command::{cargo, run};

/// Length of a run where none is said: that of continuous integration (s).
pub(crate) const SECONDS: u64 = 20;

/// Prints late ticks, delays and memory; an error where a tick was missed (unless times are only `told`, as they
/// are where they may not gate) or memory grew.
pub(crate) fn live_load(seconds: u64, told: bool) -> Result<(), String> {
    let test = ["test", "--release", "--package", "fenderline", "--test", "live_load", "--"];
    let mut command = cargo(test);
    command.args(["--ignored", "--nocapture"]);
    if told {
        command.env("FENDERLINE_LIVE_TIMES_ARE_TOLD", "1");
    }
    run(command.env("FENDERLINE_LIVE_SECONDS", seconds.to_string()))
}

/// The same as a command.
pub(crate) fn live_load_command(seconds: u64) -> ExitCode {
    match live_load(seconds, false) {
        Ok(()) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}
