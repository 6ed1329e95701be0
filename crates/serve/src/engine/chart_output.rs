//! Sends the sentences of the ships' instruments to chart programs.

use std::time::{Duration, Instant};

use fenderline_live::Session;
use fenderline_nautical::{ChartOrigin, GeoPoint, Moment};

use super::clock::unix_ms;
use crate::hub::Hub;
use crate::instruments;

/// Wall time between two rounds of sentences to chart programs.
const INTERVAL: Duration = Duration::from_secs(1);

/// The timing of the sentences for chart programs. Chart programs go by wall time, so that sentences are sent by wall
/// time too, even while the session is paused.
#[derive(Debug)]
pub(super) struct ChartOutput {
    /// The geographic position of the scenario's origin, if the user gave one.
    given: Option<ChartOrigin>,
    /// Time at which the last round of sentences was sent.
    sent: Option<Instant>,
    rounds: u64,
}

impl ChartOutput {
    /// Uses the given origin for the positions in sentences. With `None`, positions count from the origin of the
    /// scenario's nautical chart, or from 0° N 0° E if there is no chart.
    pub(super) fn new(given: Option<ChartOrigin>) -> ChartOutput {
        ChartOutput { given, sent: None, rounds: 0 }
    }

    /// Sends a round of sentences to chart programs if a round is due.
    pub(super) fn send_if_due(&mut self, now: Instant, session: &Session, hub: &Hub) {
        if self.sent.is_some_and(|at| now < at + INTERVAL) {
            return;
        }
        let at = Moment::from_unix(unix_ms() as f64 * 1e-3);
        let origin = self.given.or_else(|| of_chart(session)).unwrap_or_default();
        let round = instruments::sentences(session, &origin, at, self.rounds);
        hub.sentences.send_replace(Some(round.into()));
        self.sent = Some(now);
        self.rounds += 1;
    }
}

/// The geographic position of the origin of a session's nautical chart. The origin is `None` without a chart, and
/// beyond 85° of latitude.
fn of_chart(session: &Session) -> Option<ChartOrigin> {
    let place = session.simulation().setup().world.chart.origin?;
    let (latitude_deg, longitude_deg) =
        (place.latitude_rad.to_degrees(), place.longitude_rad.to_degrees());
    ChartOrigin::new(GeoPoint { latitude_deg, longitude_deg }).ok()
}
