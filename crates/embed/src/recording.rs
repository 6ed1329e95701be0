//! The last steps of an engine, recorded so that they can be sent and replayed.
//!
//! Steps are kept in two segments, each with the saved engine at its start. When the second segment is full, the first
//! is dropped. So the recording holds between once and twice the wanted number of steps.

use fenderline_contact::{BodyId, BodyState, Wrench};

use crate::bytes::Writer;

/// First word of an entry.
pub(crate) const MARK: u32 = 1;
pub(crate) const STEP: u32 = 2;

/// Outcome of a recorded step.
pub(crate) const UNFINISHED: u32 = 0;
pub(crate) const DONE: u32 = 1;
pub(crate) const REFUSED: u32 = 2;

/// Bytes of an outcome and the digest after it.
const OUTCOME: usize = 12;

/// The last steps of an engine.
#[derive(Clone, Debug)]
pub(crate) struct Recording {
    /// Steps of a full segment.
    pub(crate) wanted: usize,
    pub(crate) previous: Option<Segment>,
    pub(crate) current: Segment,
}

#[derive(Clone, Debug)]
pub(crate) struct Segment {
    /// The saved engine before the first step of the segment.
    start: Vec<u8>,
    entries: Vec<u8>,
    pub(crate) steps: usize,
}

impl Segment {
    pub(crate) fn new(start: Vec<u8>) -> Segment {
        Segment { start, entries: Vec::new(), steps: 0 }
    }
}

impl Recording {
    /// The saved engine at the start of the recording, and all entries since.
    pub(crate) fn parts(&self) -> (&[u8], [&[u8]; 2]) {
        match &self.previous {
            Some(previous) => (&previous.start, [&previous.entries, &self.current.entries]),
            None => (&self.current.start, [&self.current.entries, &[]]),
        }
    }

    pub(crate) fn mark_teleported(&mut self, body: BodyId) {
        self.write(|out| {
            out.word32(MARK);
            out.word32(body.0);
        });
    }

    /// Writes the input of a step before the step is taken, so the input is recorded even if the step does not end.
    /// There are no flags, because all states are set.
    pub(crate) fn begin_step(
        &mut self,
        states: &[BodyState],
        is_set: &[bool],
        loads: Option<&[Wrench]>,
        step_s: f64,
    ) {
        self.current.steps += 1;
        self.write(|out| {
            out.word32(STEP);
            out.word64(step_s.to_bits());
            for (body, state) in states.iter().enumerate() {
                out.state(state);
                out.word32(u32::from(is_set.get(body).is_none_or(|&is_set| is_set)));
            }
            out.word32(u32::from(loads.is_some()));
            loads.unwrap_or_default().iter().for_each(|load| out.wrench(load));
            out.word32(UNFINISHED);
            out.word64(0);
        });
    }

    pub(crate) fn refuse_step(&mut self) {
        self.end(REFUSED, 0);
    }

    pub(crate) fn end(&mut self, outcome: u32, digest: u64) {
        let entries = &mut self.current.entries;
        entries.truncate(entries.len() - OUTCOME);
        self.write(|out| {
            out.word32(outcome);
            out.word64(digest);
        });
    }

    fn write(&mut self, write: impl FnOnce(&mut Writer)) {
        let mut out = Writer(core::mem::take(&mut self.current.entries));
        write(&mut out);
        self.current.entries = out.0;
    }
}
