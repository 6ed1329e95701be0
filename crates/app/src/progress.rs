//! The progress bar of a long run, with its rate and the time left.

use core::fmt::Write;
use std::io::{self, IsTerminal as _};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use crate::terminal::is_quiet;

/// Runs shorter than this time show no progress bar.
const PATIENCE: Duration = Duration::from_millis(500);

/// A progress bar on standard error. The bar is not shown if standard error is not a terminal, if the run is short, or
/// with `--quiet`.
pub(crate) struct Progress {
    /// The progress bar; `None` if standard error is not a terminal.
    bar: Option<ProgressBar>,
    started: Instant,
    is_shown: bool,
}

impl Progress {
    /// A progress bar for a run of `steps` time steps.
    pub(crate) fn new(steps: u64) -> Progress {
        Progress::of(steps, "steps")
    }

    /// Shows no progress bar, even if standard error is a terminal.
    pub(crate) fn none() -> Progress {
        Progress { bar: None, started: Instant::now(), is_shown: false }
    }

    /// A progress bar for `count` things that are called `what`, such as cases.
    pub(crate) fn of(count: u64, what: &'static str) -> Progress {
        // The bar counts from the start while it is hidden, so that its estimate of the time left is right
        // when it appears.
        let bar = (io::stderr().is_terminal() && !is_quiet()).then(|| {
            ProgressBar::with_draw_target(Some(count), ProgressDrawTarget::hidden())
                .with_style(style(what))
        });
        Progress { bar, started: Instant::now(), is_shown: false }
    }

    /// Sets the number done.
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

fn style(what: &'static str) -> ProgressStyle {
    let template = format!("{{wide_bar}} {{percent}}% of {{len}} {what}, {{rate}}, {{eta}} left");
    let rate = move |state: &ProgressState, out: &mut dyn Write| {
        // An error is one of the bar's own text.
        let _ = out.write_str(&rate(state.per_sec(), what));
    };
    ProgressStyle::with_template(&template)
        .expect("the template of the progress bar is valid")
        .with_key("rate", rate)
}

/// The text of a rate with about two digits, such as `34 k steps/s`.
fn rate(per_s: f64, what: &str) -> String {
    let (number, prefix) = match per_s {
        1e6.. => (1e-6 * per_s, "M "),
        1e4.. => (1e-3 * per_s, "k "),
        _ => (per_s, ""),
    };
    let decimals = if number < 10.0 { 1 } else { 0 };
    format!("{number:.decimals$} {prefix}{what}/s")
}

/// Shows a progress bar while `work` reports how much is done and the total.
///
/// # Errors
/// Fails with the errors of `work`.
pub(crate) fn with_progress<T, E>(
    work: impl FnOnce(&mut dyn FnMut(u64, u64)) -> Result<T, E>,
) -> Result<T, E> {
    let mut bar = None;
    work(&mut |done, of| {
        bar.get_or_insert_with(|| Progress::new(of)).advance(done);
    })
}

#[cfg(test)]
mod tests {
    use super::rate;

    #[test]
    fn rates_have_about_two_digits() {
        assert_eq!(rate(0.25, "cases"), "0.2 cases/s");
        assert_eq!(rate(321.4, "steps"), "321 steps/s");
        assert_eq!(rate(34_210.0, "steps"), "34 k steps/s");
        assert_eq!(rate(2_340_000.0, "steps"), "2.3 M steps/s");
    }
}
