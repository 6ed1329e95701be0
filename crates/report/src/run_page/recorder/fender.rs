//! Records the time series of a fender for the report.

use super::{PartsTrace, Path};
use crate::plot::Decimator;
use fenderline_results::TouchedFender;

/// Time series of one touched fender, and its path in the diagram of reaction against deflection.
pub(in crate::run_page) struct FenderTrace {
    /// Index of the fender among the set-up's fenders.
    pub(in crate::run_page) fender: usize,
    /// Mean reaction of each step (N).
    pub(in crate::run_page) reaction_n: Decimator,
    /// Components of the fender's force over time.
    pub(in crate::run_page) parts: PartsTrace,
    /// Path of the run in the diagram of reaction (N) against deflection (m).
    pub(in crate::run_page) path: Path,
    /// The fender in the time step before. Its deflection at the start of that step is kept until the deflection at the
    /// end is known.
    last: TouchedFender,
}

impl FenderTrace {
    /// Starts the record of fender number `fender`, which is first touched in the step that begins at `t_s`.
    pub(super) fn begin(fender: usize, t_s: f64, step_s: f64) -> FenderTrace {
        let mut trace = FenderTrace {
            fender,
            reaction_n: Decimator::new(),
            parts: PartsTrace::default(),
            path: Path::default(),
            last: TouchedFender::default(),
        };
        if t_s > 0.0 {
            // Nothing touched from the start until the step before this one.
            trace.reaction_n.rest_until(t_s - step_s);
            trace.parts.rest_until(t_s - step_s);
            trace.path.push(0.0, 0.0);
        }
        trace
    }

    /// Adds one time step; `now` is `None` if the fender is not touched.
    pub(super) fn push(&mut self, t_s: f64, now: Option<&TouchedFender>) {
        let now = now.copied().unwrap_or_default();
        self.push_forces(t_s, &now);
        // The mean force of a step belongs to its mean deflection.
        if self.last != TouchedFender::default() {
            let deflection_m = 0.5 * (self.last.deflection_m + now.deflection_m);
            self.path.push(deflection_m, self.last.reaction_n);
            if now.reaction_n == 0.0 {
                self.path.push(now.deflection_m, 0.0);
            }
        }
        self.last = now;
    }

    fn push_forces(&mut self, t_s: f64, now: &TouchedFender) {
        self.reaction_n.push(t_s, now.reaction_n);
        self.parts.push(t_s, &now.parts);
    }
}
