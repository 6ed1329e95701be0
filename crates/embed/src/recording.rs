//! The last steps of an engine, recorded so that they can be sent and replayed.
//!
//! The recorded steps are kept in two segments, each with the saved engine at its start. When the second segment of the
//! recording is full, the first segment is dropped. The recording therefore holds between once and twice as many steps
//! as were asked for.

use fenderline_contact::{BodyId, BodyState, Wrench};

use crate::bytes::Writer;

/// First word of an entry in the recording; says of which kind the entry is.
pub(crate) const MARK: u32 = 1;
pub(crate) const STEP: u32 = 2;

/// Word for the outcome of a recorded step: the step did not end, was taken, or was refused.
pub(crate) const UNFINISHED: u32 = 0;
pub(crate) const DONE: u32 = 1;
pub(crate) const REFUSED: u32 = 2;

/// Number of bytes of a step's outcome and of the digest of its results after the outcome.
const OUTCOME: usize = 12;

/// The recorded last steps of an engine.
#[derive(Clone, Debug)]
pub(crate) struct Recording {
    /// Number of steps in a full segment.
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
    /// The saved engine at the start of the recording, and all entries since then.
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

    /// Writes the input of a step before the step is taken, so the input is recorded even if the step does not end. The
    /// entry of a step has no flags for the states that are set, because all states are set.
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
