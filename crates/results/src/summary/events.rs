//! Writes events into `summary.json`.

use fenderline_contact::EventKind;
use fenderline_sim::Setup;

use crate::events::event_key;
use crate::json::{Json, object};
use crate::run_events::Events;

/// The JSON of the events in `summary.json`.
pub(super) fn events_json(events: &Events, setup: &Setup) -> Json {
    let counts: Json = events.counts().map(|(kind, n)| (event_key(kind).to_owned(), n)).collect();
    let first = events.first().iter().map(|(t_s, event)| {
        let bodies = event.bodies.map(|body| setup.bodies[body.0 as usize].name.as_str());
        let mut told = object!({ "t_s": t_s, "kind": event_key(event.kind), "bodies": bodies });
        if let EventKind::FenderRatingExceeded(id) | EventKind::FenderFailed(id) = event.kind {
            told.put("fender", &setup.fenders[id.0 as usize].name);
        }
        told
    });
    object!({ "counts": counts, "first": first.collect::<Vec<_>>() })
}
