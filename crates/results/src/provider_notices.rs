//! What happened to the providers of a run.

use fenderline_sim::external::ProviderEvent;

/// How many notices are told one by one.
const FIRST: usize = 20;

/// Something that happened to a provider, as results tell it.
#[derive(Clone, Debug, PartialEq)]
pub struct ProviderNotice {
    /// Start of the step (s).
    pub t_s: f64,
    /// Index into the set-up's providers.
    pub provider: usize,
    /// What.
    pub event: ProviderEvent,
}

/// The first notices of a run, and how many of each kind there were: bounded, whatever the run's length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ProviderNotices {
    first: Vec<ProviderNotice>,
    /// In the order of first occurrence.
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

    /// The kinds that occurred, and how often.
    pub fn counts(&self) -> &[(&'static str, u64)] {
        &self.counts
    }
}

/// The word for an event in `summary.json`.
pub fn provider_event_key(event: &ProviderEvent) -> &'static str {
    match event {
        ProviderEvent::Held => "provider_held",
        ProviderEvent::Dropped => "provider_dropped",
        ProviderEvent::Resumed => "provider_resumed",
        ProviderEvent::Refused => "provider_refused",
        ProviderEvent::Died(_) => "provider_died",
    }
}
