//! What happened in a run, counted.

use core::mem::discriminant;

use crate::events::event_key;
use fenderline_contact::{Event, EventKind};
use fenderline_sim::{Setup, StepRecord};
use serde_json::{Map, Value, json};

/// How many events are told one by one: of contacts that come and go, and of all that is worse.
const FIRST_EVENTS: usize = 20;

/// Events of a run: how many of each kind, and the first few. Bounded, whatever the run's length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events {
    /// In the order of first occurrence; those of different fenders are of one kind.
    counts: Vec<(EventKind, u64)>,
    first: Vec<(f64, Event)>,
}

impl Events {
    /// Adds those of one step.
    pub fn count(&mut self, step: &StepRecord<'_>) {
        for event in step.events {
            let kind = discriminant(&event.kind);
            match self.counts.iter_mut().find(|(known, _)| discriminant(known) == kind) {
                Some((_, count)) => *count += 1,
                None => self.counts.push((event.kind, 1)),
            }
            let is_plain = is_plain(event.kind);
            let told = self.first.iter().filter(|(_, e)| self::is_plain(e.kind) == is_plain);
            if told.count() < FIRST_EVENTS {
                self.first.push((step.t_s, *event));
            }
        }
    }

    /// The kinds that occurred, and how often.
    pub fn counts(&self) -> impl Iterator<Item = (EventKind, u64)> {
        self.counts.iter().copied()
    }
}

/// Contacts that come and go: nothing to be looked at.
pub fn is_plain(kind: EventKind) -> bool {
    matches!(kind, EventKind::ContactBegan | EventKind::ContactEnded)
}

/// The events as `summary.json` has them.
pub(super) fn events_json(events: &Events, setup: &Setup) -> Value {
    let counts: Map<String, Value> =
        events.counts().map(|(kind, n)| (event_key(kind).to_owned(), json!(n))).collect();
    let first = events.first.iter().map(|(t_s, event)| {
        let bodies = event.bodies.map(|body| setup.bodies[body.0 as usize].name.as_str());
        let mut told = json!({ "t_s": t_s, "kind": event_key(event.kind), "bodies": bodies });
        if let EventKind::FenderRatingExceeded(id) | EventKind::FenderFailed(id) = event.kind {
            told["fender"] = json!(setup.fenders[id.0 as usize].name);
        }
        told
    });
    json!({ "counts": counts, "first": first.collect::<Vec<_>>() })
}
