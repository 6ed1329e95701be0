//! Events of the force providers of a run.

use fenderline_sim::external::ProviderEvent;

/// Largest number of notices that are kept one by one.
const FIRST: usize = 20;

/// An event of a force provider.
#[derive(Clone, Debug, PartialEq)]
pub struct ProviderNotice {
    /// Start of the time step in which the event occurred (s).
    pub t_s: f64,
    /// Index of the provider among the set-up's providers.
    pub provider: usize,
    /// The event.
    pub event: ProviderEvent,
}

/// The first events of the force providers in a run, and the count of each kind. The size of this list does not grow
/// with the length of the run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProviderNotices {
    first: Vec<ProviderNotice>,
    /// Count of each kind of event, in the order of first occurrence.
    counts: Vec<(&'static str, u64)>,
}

impl ProviderNotices {
    /// Adds a notice.
    pub fn add(&mut self, notice: ProviderNotice) {
        let key = provider_event_key(&notice.event);
        match self.counts.iter_mut().find(|(known, _)| *known == key) {
            Some((_, count)) => *count += 1,
            None => self.counts.push((key, 1)),
        }
        if self.first.len() < FIRST {
            self.first.push(notice);
        }
    }

    /// The first of them.
    pub fn first(&self) -> &[ProviderNotice] {
        &self.first
    }

    /// The kinds of events that occurred, with their counts.
    pub fn counts(&self) -> &[(&'static str, u64)] {
        &self.counts
    }
}

/// The word for an event of a force provider in `summary.json`.
pub fn provider_event_key(event: &ProviderEvent) -> &'static str {
    match event {
        ProviderEvent::Held => "provider_held",
        ProviderEvent::Dropped => "provider_dropped",
        ProviderEvent::Resumed => "provider_resumed",
        ProviderEvent::Refused => "provider_refused",
        ProviderEvent::Died(_) => "provider_died",
    }
}
