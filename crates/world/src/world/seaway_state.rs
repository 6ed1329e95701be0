//! The state of a vessel with hydrodynamic data.

use fenderline_contact::Vec2;
use fenderline_seakeeping::{MotionState, SlowPlace};

/// The values that one step leaves for the next step, as plain numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SeawayState {
    pub(super) motion: MotionState,
    pub(super) place: SlowPlace,
    /// Heading at the start of the step (rad), the current at the vessel (m/s), and the time for which forces act in
    /// the step (s).
    pub(super) heading_rad: f64,
    pub(super) stream_mps: Vec2,
    pub(super) acts_s: f64,
}

impl SeawayState {
    pub(super) fn copy_from(&mut self, other: &SeawayState) {
        self.motion.copy_from(&other.motion);
        let SeawayState { place, heading_rad, stream_mps, acts_s, .. } = *other;
        (self.place, self.heading_rad, self.stream_mps, self.acts_s) =
            (place, heading_rad, stream_mps, acts_s);
    }
}
