//! Totals of a tug over a run.

use fenderline_sim::TugAtWork;
use fenderline_sim::tug::TugOrder;

use super::{Lasting, Peak};

/// Totals of one tug.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TugTotals {
    /// Largest force of the tug on the ship (N).
    pub force_n: Peak,
    /// Time for which speed and angle allowed less than the ordered force.
    pub limited: Lasting,
    /// Time for which the tug had an order to push or pull.
    pub at_work: Lasting,
}

impl TugTotals {
    pub(super) fn add(&mut self, t_s: f64, step_s: f64, now: &TugAtWork) {
        self.force_n.raise(libm::hypot(now.force.surge_n, now.force.sway_n), t_s);
        self.limited.count(now.limited, step_s);
        self.at_work.count(now.state.order != TugOrder::StandBy, step_s);
    }
}
