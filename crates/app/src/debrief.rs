//! Makes the report of a running session for the live server.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use fenderline_report::run_page;

use crate::failure::Failure;
use crate::interrupt::Interrupt;
use crate::played::Start;
use crate::session::Recorded;

/// Makes the report page of one branch of a recording, as `fenderline report` does, from the recording's file name and
/// bytes. Prints nothing.
///
/// # Errors
/// Says why there is no report: the recording cannot be replayed, or `stop` was set.
pub(crate) fn debrief(
    name: &str,
    recording: &[u8],
    branch: usize,
    stop: &Arc<AtomicBool>,
) -> Result<String, String> {
    let stopped = || "the report was stopped".to_owned();
    let made = || -> Result<Option<String>, Failure> {
        let replayed = fenderline_serve::replay_bytes(recording, || stop.load(Ordering::Relaxed))?;
        let start = Start::of_session(Recorded::of(replayed, name, Some(branch), &[])?)?;
        let played = start.play_quietly(&Interrupt::asked_by(stop))?;
        let is_whole = played.interrupted.is_none();
        Ok(is_whole.then(|| run_page::render(&played.outcome(), &played.recorder)))
    };
    match made() {
        Ok(page) => page.ok_or_else(stopped),
        Err(failure) => {
            let text = failure.message().unwrap_or("the report was stopped");
            Err(text.strip_prefix("error: ").unwrap_or(text).to_owned())
        }
    }
}
