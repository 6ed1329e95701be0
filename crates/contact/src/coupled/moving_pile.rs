//! A pile within a step of the coupled method.

use crate::pile::PileState;
use crate::vec2::Vec2;

/// A pile within a step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct MovingPile {
    pub(crate) state: PileState,
    /// Whether the pile has neither load nor motion. Such a pile needs no sub-steps of its own.
    pub(crate) is_still: bool,
    /// The body's velocity before the sub-step (m/s), and the κ for this velocity (s).
    pub(crate) before_mps: Vec2,
    pub(crate) kick_s: f64,
}
