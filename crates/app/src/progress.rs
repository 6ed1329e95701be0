//! The progress bar of a long run, with its rate and the time left.

use core::fmt::Write;
use std::io::{self, IsTerminal as _};
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};

use crate::terminal::is_quiet;

/// Runs shorter than this show no bar.
const PATIENCE: Duration = Duration::from_millis(500);

/// A bar on standard error; none if that is not a terminal, the run is short, or with `--quiet`.
pub(crate) struct Progress {
    /// `None` if standard error is not a terminal.
    bar: Option<ProgressBar>,
    started: Instant,
    is_shown: bool,
}

impl Progress {
    /// A bar for a run of `steps` steps.
    pub(crate) fn new(steps: u64) -> Progress {
        Progress::of(steps, "steps")
    }

    /// No bar, whatever standard error is.
    pub(crate) fn none() -> Progress {
        Progress { bar: None, started: Instant::now(), is_shown: false }
    }

    /// A bar for `count` things of this name.
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
        .expect("the template is constant and right")
        .with_key("rate", rate)
}

/// A rate of about two digits, such as `34 k steps/s`.
fn rate(per_s: f64, what: &str) -> String {
    let (number, prefix) = match per_s {
        1e6.. => (1e-6 * per_s, "M "),
        1e4.. => (1e-3 * per_s, "k "),
        _ => (per_s, ""),
    };
    let decimals = if number < 10.0 { 1 } else { 0 };
    format!("{number:.decimals$} {prefix}{what}/s")
}

/// Shows a bar while `work` reports what is done and the total.
///
/// # Errors
/// Those of `work`.
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
