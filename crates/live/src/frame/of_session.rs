//! Makes the frame of a session, with the session's branches.

use super::{causes, frame};
use crate::alarm_book::Alarm;
use crate::message::{BranchNow, Frame, RunState};
use crate::session::{Branch, Session};

impl Session {
    /// The causes of alarms that are active after the session's present tick.
    pub(crate) fn causes_for_alarm(&self) -> Vec<Alarm> {
        causes(self.now(), self.cast(), self.info())
    }

    /// The frame of the session's present tick. The owner of the session gives pause, pace and clients in `run`; this
    /// function fills in the branches.
    #[must_use]
    pub fn frame(&self, at_ms: u64, run: RunState) -> Frame {
        let run = RunState {
            branch: self.current_branch(),
            branches: self.branches().iter().enumerate().map(branch_now).collect(),
            last_tick: self.branches()[self.current_branch()].ends_tick,
            ..run
        };
        frame(self.now(), self.cast(), self.info(), at_ms, run)
    }
}

fn branch_now((id, branch): (usize, &Branch)) -> BranchNow {
    let Branch { parent, from_tick, ends_tick, .. } = *branch;
    BranchNow { id, from_tick, ends_tick, parent }
}
