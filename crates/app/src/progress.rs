//! The progress bar of a long run.

use std::io::{self, IsTerminal as _};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// Runs shorter than this show no bar.
const PATIENCE: Duration = Duration::from_millis(500);

/// A bar on the terminal's standard error; nothing where that is piped or the run is short.
pub(crate) struct Progress {
    steps: u64,
    started: Instant,
    bar: Option<ProgressBar>,
    is_terminal: bool,
}

impl Progress {
    /// A bar for a run of `steps` steps.
    pub(crate) fn new(steps: u64) -> Progress {
        let is_terminal = io::stderr().is_terminal();
        Progress { steps, started: Instant::now(), bar: None, is_terminal }
    }

    /// Tells that `done` steps are done.
    pub(crate) fn advance(&mut self, done: u64) {
        if !self.is_terminal {
            return;
        }
        match &self.bar {
            Some(bar) => bar.set_position(done),
            None if self.started.elapsed() > PATIENCE => {
                let bar = ProgressBar::with_draw_target(
                    Some(self.steps),
                    ProgressDrawTarget::stderr_with_hz(10),
                );
                bar.set_style(style());
                bar.set_position(done);
                self.bar = Some(bar);
            }
            None => {}
        }
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
