//! The events of a run, counted.

use core::mem::discriminant;

use fenderline_contact::{Event, EventKind};
use fenderline_sim::StepRecord;

/// Largest number of events that are kept: of contacts that begin and end, and of all other events.
const FIRST_EVENTS: usize = 20;

/// Events of a run: the count of each kind, and the first few. The size of this list does not grow with the length of
/// the run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Events {
    /// Count of each kind of event, in the order of first occurrence; the same event of different fenders is one kind.
    counts: Vec<(EventKind, u64)>,
    first: Vec<(f64, Event)>,
}

impl Events {
    /// Adds the events of one time step.
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

    /// The first events, each with the start of its time step (s).
    pub fn first(&self) -> &[(f64, Event)] {
        &self.first
    }

    /// The kinds of events that occurred, with their counts.
    pub fn counts(&self) -> impl Iterator<Item = (EventKind, u64)> {
        self.counts.iter().copied()
    }
}

/// Whether the event is the beginning or the end of a contact, which needs no attention.
pub fn is_plain(kind: EventKind) -> bool {
    matches!(kind, EventKind::ContactBegan | EventKind::ContactEnded)
}
