//! The motions of a vessel, sampled at equal intervals of time.

use fenderline_contact::{BodyState, Rotation, vec2};

use super::peaks::MotionStatistics;
use fenderline_world::world::VesselState;

/// Largest number of samples of the motions that are kept. If a run has more samples, every second sample is dropped,
/// so that memory does not grow with the run.
const MOST: usize = 1 << 17;

/// Samples of a vessel's north, east, heave, roll, pitch and heading at equal intervals of time.
#[derive(Clone, Debug)]
pub(super) struct MotionSeries {
    samples: Vec<[f64; 6]>,
    /// Number of time steps from one sample to the next.
    every: u64,
    steps: u64,
}

impl Default for MotionSeries {
    fn default() -> MotionSeries {
        MotionSeries { samples: Vec::new(), every: 1, steps: 0 }
    }
}

impl MotionSeries {
    pub(super) fn push(&mut self, state: &BodyState, now: &VesselState) {
        let is_due = self.steps.is_multiple_of(self.every);
        self.steps += 1;
        if !is_due {
            return;
        }
        if self.samples.len() == MOST {
            let mut index = 0;
            self.samples.retain(|_| {
                index += 1;
                index % 2 == 1
            });
            self.every *= 2;
            if !(self.steps - 1).is_multiple_of(self.every) {
                return;
            }
        }
        let [surge_m, sway_m, heave_m, roll_rad, pitch_rad, yaw_rad] = now.wave_motion.motion;
        let place_m =
            state.position_m + Rotation::from_angle(state.heading_rad).apply(vec2(surge_m, sway_m));
        let attitude = &now.attitude;
        self.samples.push([
            place_m.x,
            place_m.y,
            attitude.heave.value + heave_m + now.squat_m,
            attitude.roll.value + roll_rad,
            attitude.pitch.value + pitch_rad,
            state.heading_rad + yaw_rad,
        ]);
    }

    pub(super) fn statistics(&self, step_s: f64) -> [MotionStatistics; 6] {
        let apart_s = step_s * self.every as f64;
        let of = |values: Vec<f64>| MotionStatistics::of(&values, apart_s);
        let column = |motion: usize| self.samples.iter().map(|sample| sample[motion]).collect();
        let yaw = of(column(5));
        let Some(first) = self.samples.first() else { return [MotionStatistics::default(); 6] };
        let ahead = Rotation::from_angle(yaw.mean);
        let place = |sample: &[f64; 6]| {
            ahead.apply_inverse(vec2(sample[0] - first[0], sample[1] - first[1]))
        };
        let surge = self.samples.iter().map(|sample| place(sample).x).collect();
        let sway = self.samples.iter().map(|sample| place(sample).y).collect();
        [of(surge), of(sway), of(column(2)), of(column(3)), of(column(4)), yaw]
    }
}
