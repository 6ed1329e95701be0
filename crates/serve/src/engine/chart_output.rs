//! Sends the instruments' sentences to chart programs.

use std::time::{Duration, Instant};

use fenderline_live::Session;
use fenderline_nautical::{ChartOrigin, Moment};

use crate::hub::Hub;
use crate::instruments;

/// Wall time between two rounds of sentences.
const INTERVAL: Duration = Duration::from_secs(1);

/// The clock of the sentences. They go by wall time, paused or not, because chart programs do.
#[derive(Debug)]
pub(super) struct ChartOutput {
    /// The scenario's origin on the chart.
    origin: ChartOrigin,
    /// When the last round was sent.
    sent: Option<Instant>,
    rounds: u64,
}

impl ChartOutput {
    pub(super) fn new(origin: ChartOrigin) -> ChartOutput {
        ChartOutput { origin, sent: None, rounds: 0 }
    }

    /// Sends a round of sentences if one is due.
    pub(super) fn send_if_due(&mut self, now: Instant, session: &Session, hub: &Hub) {
        if self.sent.is_some_and(|at| now < at + INTERVAL) {
            return;
        }
        let at = Moment::from_unix(super::unix_ms() as f64 * 1e-3);
        let round = instruments::sentences(session, &self.origin, at, self.rounds);
        hub.sentences.send_replace(Some(round.into()));
        self.sent = Some(now);
        self.rounds += 1;
    }
}
