//! The latest events of the session, for frames.

use std::collections::VecDeque;
use std::sync::Arc;

use fenderline_live::message::EventNow;

/// Number of events that are kept for frames, for clients that missed some frames.
const KEPT: usize = 64;

/// The latest events. Each event has a number that is never used twice. With the numbers, the server sends each
/// event to a client only once.
#[derive(Debug)]
pub(super) struct EventLog {
    next: u64,
    latest: VecDeque<(u64, EventNow)>,
}

impl EventLog {
    pub(super) fn new() -> EventLog {
        EventLog { next: 1, latest: VecDeque::new() }
    }

    pub(super) fn add(&mut self, t_s: f64, text: String) {
        self.latest.push_back((self.next, EventNow { t_s, text }));
        self.next += 1;
        if self.latest.len() > KEPT {
            self.latest.pop_front();
        }
    }

    /// Drops all events. The numbers of dropped events are not used again.
    pub(super) fn clear(&mut self) {
        self.latest.clear();
    }

    pub(super) fn latest(&self) -> Arc<[(u64, EventNow)]> {
        self.latest.iter().cloned().collect()
    }
}
