//! One past step of a body in a co-simulation.

use crate::report::Wrench;

/// A step of the host, with the wrench on one body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct PastStep {
    pub(super) step_s: f64,
    pub(super) wrench: Wrench,
    /// The load, if the host reported it.
    pub(super) reported_load: Option<Wrench>,
}
