//! The state of a pile within a step of the coupled method.

use crate::maths::vec2::Vec2;
use crate::model::pile::PileState;

/// A pile that moves with its body within a step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct MovingPile {
    pub(crate) state: PileState,
    /// True if the pile has neither load nor motion. A pile without load and motion needs no sub-steps of its own.
    pub(crate) is_still: bool,
    /// Velocity of the pile's body before the sub-step (m/s), and the time κ for which forces act on this velocity (s).
    pub(crate) before_mps: Vec2,
    pub(crate) kick_s: f64,
}
