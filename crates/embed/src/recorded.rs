//! Recording the steps of an engine.

use fenderline_contact::hash::Fnv1a;

use crate::bytes::Writer;
use crate::engine::Engine;
use crate::error::EngineError;
use crate::recording::{DONE, Recording, Segment};
use crate::results::Results;
use crate::snapshot::write_results;

/// The largest number of steps that [`Engine::record`] keeps.
pub const MOST_RECORDED_STEPS: usize = 1_000_000;

/// Hashes all results of a step.
pub(crate) fn digest(results: &Results<'_>) -> u64 {
    let mut out = Writer::default();
    write_results(&mut out, results);
    Fnv1a::of(&out.0)
}

impl Engine {
    /// Records the engine's steps from now on, and keeps at least the last `steps` steps; `steps` = 0 ends the
    /// recording. [`Engine::dump`] makes a file of the recorded steps. While the engine records, a step takes longer,
    /// because its input is copied and its results are hashed.
    ///
    /// # Errors
    /// More than [`MOST_RECORDED_STEPS`].
    pub fn record(&mut self, steps: usize) -> Result<(), EngineError> {
        if steps > MOST_RECORDED_STEPS {
            return Err(EngineError::Settings(
                "at most 1000000 steps of an engine can be recorded",
            ));
        }
        self.recording = (steps > 0).then(|| {
            let current = Segment::new(self.save());
            Box::new(Recording { wanted: steps, previous: None, current })
        });
        Ok(())
    }

    /// Begins the recording anew, if the engine records, because the recorded steps do not lead to the engine's new
    /// state.
    pub(crate) fn restart_recording(&mut self) {
        if let Some(recording) = &self.recording {
            let wanted = recording.wanted;
            let current = Segment::new(self.save());
            self.recording = Some(Box::new(Recording { wanted, previous: None, current }));
        }
    }

    /// Begins a new segment of the recording if the current segment is full.
    pub(crate) fn make_room_in_recording(&mut self) {
        if self.recording.as_ref().is_some_and(|own| own.current.steps >= own.wanted) {
            let next = Segment::new(self.save());
            if let Some(recording) = &mut self.recording {
                recording.previous = Some(core::mem::replace(&mut recording.current, next));
            }
        }
    }

    /// Writes the hash of the step's results to the recording.
    pub(crate) fn end_step_of_recording(&mut self) {
        let Some(mut recording) = self.recording.take() else { return };
        if let Ok(results) = self.results() {
            recording.end(DONE, digest(&results));
        }
        self.recording = Some(recording);
    }
}
