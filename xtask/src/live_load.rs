//! `cargo xtask live-load` tests the live server with eight clients that steer and fifty hostile clients.

use std::process::ExitCode;

use crate::built;
use crate::command::run;

/// Default length of a run under load (s), also in continuous integration.
pub(crate) const SECONDS: u64 = 20;

/// Runs the live server under load and prints late ticks, delays and memory. Fails if the server's memory grew or a
/// tick was missed; missed ticks are no failure if times are only reported.
pub(crate) fn live_load(seconds: u64, times_reported_only: bool) -> Result<(), String> {
    let program = built::program("release")?;
    // The clients are built without optimisation, the server under load as users have it.
    let mut command = built::tests(&["--ignored", "--nocapture", "live_load::"]);
    command.env("FENDERLINE_PROGRAM", program);
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
