//! The progress bar of a long run.

use std::io::{self, IsTerminal as _};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Runs shorter than this show no bar.
const PATIENCE: Duration = Duration::from_millis(500);

/// A bar on standard error; none if that is not a terminal or the run is short.
pub(crate) struct Progress {
    /// `None` if standard error is not a terminal.
    bar: Option<ProgressBar>,
    started: Instant,
    is_shown: bool,
}

impl Progress {
    /// A bar for a run of `steps` steps.
    pub(crate) fn new(steps: u64) -> Progress {
        // The bar counts from the start while it is hidden, so that its estimate of the time left is right
        // when it appears.
        let bar = io::stderr().is_terminal().then(|| {
            ProgressBar::with_draw_target(Some(steps), ProgressDrawTarget::hidden())
                .with_style(style())
        });
        Progress { bar, started: Instant::now(), is_shown: false }
    }

    /// Sets the number of steps done.
    pub(crate) fn advance(&mut self, done: u64) {
        let Some(bar) = &self.bar else { return };
        if !self.is_shown && self.started.elapsed() > PATIENCE {
            bar.set_draw_target(ProgressDrawTarget::stderr_with_hz(10));
            self.is_shown = true;
        }
        bar.set_position(done);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn style() -> ProgressStyle {
    ProgressStyle::with_template("{wide_bar} {percent}% of {len} steps, {eta} left")
        .expect("the template is constant and right")
}
