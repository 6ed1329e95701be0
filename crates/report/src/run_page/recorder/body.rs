//! Records the time series of a floating body for the report.

use fenderline_contact::{BodyState, Vec2};
use fenderline_sim::StepRecord;

use crate::plot::Decimator;

/// Largest number of points that are kept of a track.
const TRACK_POINTS: usize = 400;

/// Time series of one floating body.
pub(in crate::run_page) struct BodyTrace {
    /// Index of the body among the set-up's bodies.
    pub(in crate::run_page) body: usize,
    /// Speed over ground (m/s).
    pub(in crate::run_page) speed_mps: Decimator,
    track: Vec<Vec2>,
    track_stride: u64,
}

impl BodyTrace {
    /// Makes an empty record of body number `body`.
    pub(super) fn new(body: usize) -> BodyTrace {
        BodyTrace { body, speed_mps: Decimator::new(), track: Vec::new(), track_stride: 1 }
    }

    pub(super) fn push(&mut self, step: &StepRecord<'_>) {
        let state = &step.states[self.body];
        self.speed_mps.push(step.t_s, state.velocity_mps.length());
        if step.index.is_multiple_of(self.track_stride) {
            self.track.push(state.position_m);
            if self.track.len() > TRACK_POINTS {
                let mut index = 0;
                self.track.retain(|_| {
                    index += 1;
                    index % 2 == 1
                });
                self.track_stride *= 2;
            }
        }
    }

    /// The path of the centre of gravity, up to `end`.
    pub(in crate::run_page) fn track_to(&self, end: &BodyState) -> Vec<Vec2> {
        let mut track = self.track.clone();
        track.push(end.position_m);
        track
    }
}
