//! Events as `summary.json` has them.

use fenderline_contact::EventKind;
use fenderline_sim::Setup;
use serde_json::{Map, Value, json};

use crate::events::event_key;
use crate::run_events::Events;

/// The events as `summary.json` has them.
pub(super) fn events_json(events: &Events, setup: &Setup) -> Value {
    let counts: Map<String, Value> =
        events.counts().map(|(kind, n)| (event_key(kind).to_owned(), json!(n))).collect();
    let first = events.first().iter().map(|(t_s, event)| {
        let bodies = event.bodies.map(|body| setup.bodies[body.0 as usize].name.as_str());
        let mut told = json!({ "t_s": t_s, "kind": event_key(event.kind), "bodies": bodies });
        if let EventKind::FenderRatingExceeded(id) | EventKind::FenderFailed(id) = event.kind {
            told["fender"] = json!(setup.fenders[id.0 as usize].name);
        }
        told
    });
    json!({ "counts": counts, "first": first.collect::<Vec<_>>() })
}
