//! One past step of a body in a co-simulation host.

use crate::state::report::Wrench;

/// A step of the host, with the wrench on one body in this step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct PastStep {
    pub(super) step_s: f64,
    pub(super) wrench: Wrench,
    /// The load on the body; `None` if the host did not report the load.
    pub(super) reported_load: Option<Wrench>,
}
