//! The past of a session for the strip charts and the log of a page. The session keeps the past, so that a page that is
//! opened or loaded later shows the same as the other pages. The past is limited: it has values once a second of
//! simulated time, with the peaks of loads between the samples, and the latest events. Each sample and event belongs to
//! the branch that made it, so that a rewind loses nothing.

use std::collections::VecDeque;

use fenderline_contact::number::greater;

use crate::message::{History, Then};

/// Simulated time between two samples of the past (s).
const EVERY_S: f64 = 1.0;
/// A page gets the past of this length before the present tick (s).
const SHOWN_S: f64 = 1800.0;
/// Largest number of samples of all branches: more than two hours of one branch.
const MOST_SAMPLES: usize = 8000;
/// Largest number of events of all branches, and the largest number that a page gets.
const MOST_EVENTS: usize = 1000;
const SHOWN_EVENTS: usize = 200;

/// The values for strip charts after a tick.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Sample {
    pub(crate) t_s: f64,
    /// The values of each ship that can be conned, in the order of [`crate::Cast::ships`]. Without a vessel the list
    /// has one entry, for a floating body.
    pub(crate) ships: Vec<ShipSample>,
    /// The values that frozen instruments show, for each ship with frozen instruments: the ship's index in `ships`, and
    /// the values.
    pub(crate) shown: Vec<(usize, ShipSample)>,
    /// Greatest load of a fender over its rating: `of_energy` and `of_reaction`. Greatest load of a line over its
    /// working load: `of_working`.
    pub(crate) of_energy: f64,
    pub(crate) of_reaction: f64,
    pub(crate) of_working: f64,
    /// Sum of the sizes of all contact forces (N).
    pub(crate) contact_n: f64,
}

/// Values of a ship. The distances and speeds of the ship's ends are those at the berth, if there is a berth. A value
/// that does not exist for the ship is `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ShipSample {
    pub(crate) bow_mps: Option<f64>,
    pub(crate) stern_mps: Option<f64>,
    pub(crate) ahead_mps: f64,
    pub(crate) turn_radps: f64,
    pub(crate) bow_m: Option<f64>,
    pub(crate) stern_m: Option<f64>,
    pub(crate) cross_track_m: Option<f64>,
    pub(crate) under_keel_m: Option<f64>,
}

impl Sample {
    /// The present sample, but with the loads of an earlier sample where those are greater.
    fn with_peaks(self, before: &Sample) -> Sample {
        Sample {
            of_energy: greater(self.of_energy, before.of_energy),
            of_reaction: greater(self.of_reaction, before.of_reaction),
            of_working: greater(self.of_working, before.of_working),
            contact_n: greater(self.contact_n, before.contact_n),
            ..self
        }
    }
}

/// Selects the ship whose past is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Of {
    /// Index of the ship among the ships that can be conned.
    pub(crate) place: usize,
    /// Index of the ship among the vessels.
    pub(crate) vessel: Option<usize>,
    /// True asks for the values that the ship's instruments showed, frozen instruments included. False asks for the
    /// ship's true values.
    pub(crate) as_shown: bool,
}

/// A sample or event of the past: its branch, the tick of the commands that led to it, and the tick from which people
/// see it.
#[derive(Clone, Debug, PartialEq)]
struct Entry<T> {
    branch: usize,
    cause_tick: u64,
    seen_tick: u64,
    what: T,
}

/// The past of all branches of a session.
#[derive(Clone, Debug)]
pub(crate) struct Past {
    /// Ticks between two samples.
    every: u64,
    samples: VecDeque<Entry<Sample>>,
    events: VecDeque<Entry<Then>>,
    /// For each branch, the last tick whose values are kept. Steps that are repeated after a rewind do not change the
    /// past.
    reached: Vec<u64>,
    /// The peaks of the loads since the last sample was kept.
    peaks: Option<Sample>,
    /// Number of times that the past has changed.
    version: u64,
}

impl Past {
    pub(crate) fn new(step_s: f64) -> Past {
        // A step is never extremely short, so this is a small whole number.
        let every = greater(libm::round(EVERY_S / step_s), 1.0) as u64;
        Past {
            every,
            samples: VecDeque::new(),
            events: VecDeque::new(),
            reached: Vec::new(),
            peaks: None,
            version: 0,
        }
    }

    /// A number that changes with each change of the past.
    pub(crate) fn version(&self) -> u64 {
        self.version
    }

    /// Keeps the values and events of the step that led a branch to `tick`. Does nothing if the past already has the
    /// step.
    pub(crate) fn keep_step(
        &mut self,
        branch: usize,
        tick: u64,
        sample: Sample,
        events: impl Iterator<Item = Then>,
    ) {
        if self.reached.len() <= branch {
            self.reached.resize(branch + 1, 0);
        }
        if tick <= self.reached[branch] {
            return;
        }
        self.reached[branch] = tick;
        let cause_tick = tick - 1;
        let entry = |what| Entry { branch, cause_tick, seen_tick: tick, what };
        let events: Vec<_> = events.map(entry).collect();
        for event in events {
            self.push_event(event);
        }
        let sample = match self.peaks.take() {
            Some(before) => sample.with_peaks(&before),
            None => sample,
        };
        if !tick.is_multiple_of(self.every) {
            self.peaks = Some(sample);
            return;
        }
        self.samples.push_back(Entry { branch, cause_tick, seen_tick: tick, what: sample });
        if self.samples.len() > MOST_SAMPLES {
            self.samples.pop_front();
        }
        self.version += 1;
    }

    /// Keeps the event of a command at a tick of a branch.
    pub(crate) fn keep_event(&mut self, branch: usize, tick: u64, what: Then) {
        self.push_event(Entry { branch, cause_tick: tick, seen_tick: tick, what });
    }

    fn push_event(&mut self, event: Entry<Then>) {
        self.events.push_back(event);
        if self.events.len() > MOST_EVENTS {
            self.events.pop_front();
        }
        self.version += 1;
    }

    /// The past before a tick, with the strip-chart values of one ship. `branch_at` gives the branch whose commands
    /// applied at a tick.
    pub(crate) fn before(
        &self,
        tick: u64,
        t_s: f64,
        Of { place: ship, vessel, as_shown }: Of,
        branch_at: impl Fn(u64) -> usize,
    ) -> History {
        let mut history = History { vessel, ..History::default() };
        for Entry { what: sample, .. } in self
            .samples
            .iter()
            .filter(|entry| entry.what.t_s >= t_s - SHOWN_S && is_of(entry, tick, &branch_at))
        {
            let shown = sample.shown.iter().find(|(place, _)| as_shown && *place == ship);
            let of = shown.map_or(&sample.ships[ship], |(_, shown)| shown);
            history.t_s.push(short(sample.t_s));
            history.bow_mps.push(of.bow_mps.map(short));
            history.stern_mps.push(of.stern_mps.map(short));
            history.ahead_mps.push(short(of.ahead_mps));
            history.turn_radps.push(libm::round(of.turn_radps * 1e6) / 1e6);
            history.bow_m.push(of.bow_m.map(short));
            history.stern_m.push(of.stern_m.map(short));
            history.cross_track_m.push(of.cross_track_m.map(short));
            history.under_keel_m.push(of.under_keel_m.map(short));
            history.of_energy.push(short(sample.of_energy));
            history.of_reaction.push(short(sample.of_reaction));
            history.of_working.push(short(sample.of_working));
            history.contact_n.push(libm::round(sample.contact_n));
        }
        let events = self.events.iter().filter(|entry| is_of(entry, tick, &branch_at));
        let events: Vec<_> = events.map(|entry| entry.what.clone()).collect();
        history.events = events[events.len().saturating_sub(SHOWN_EVENTS)..].to_vec();
        history
    }
}

/// True if a sample or event of the past belongs to the branch that leads to `tick`, and is not later than `tick`.
fn is_of<T>(entry: &Entry<T>, tick: u64, branch_at: impl Fn(u64) -> usize) -> bool {
    entry.seen_tick <= tick && branch_at(entry.cause_tick) == entry.branch
}

/// Rounds to four decimals. A strip chart does not show more decimals than four.
fn short(value: f64) -> f64 {
    libm::round(value * 1e4) / 1e4
}

#[cfg(test)]
mod tests {
    use super::*;

    const FIRST: Of = Of { place: 0, vessel: Some(0), as_shown: false };

    fn sample(t_s: f64, of_energy: f64) -> Sample {
        let ship = |ahead_mps| ShipSample {
            bow_mps: None,
            stern_mps: None,
            ahead_mps,
            turn_radps: 0.0,
            bow_m: None,
            stern_m: None,
            cross_track_m: None,
            under_keel_m: None,
        };
        Sample {
            t_s,
            ships: vec![ship(t_s), ship(-t_s)],
            shown: vec![(1, ship(7.0))],
            of_energy,
            of_reaction: 0.0,
            of_working: 0.0,
            contact_n: 0.0,
        }
    }

    fn said(t_s: f64, text: &str) -> Then {
        Then { t_s, text: text.into(), level: None }
    }

    /// Steps of 0.1 s in a branch, for a range of ticks.
    fn run(past: &mut Past, branch: usize, ticks: std::ops::RangeInclusive<u64>) {
        for tick in ticks {
            let of_energy = if tick == 13 { 0.9 } else { 0.1 };
            past.keep_step(branch, tick, sample(tick as f64 * 0.1, of_energy), std::iter::empty());
        }
    }

    #[test]
    fn a_load_between_two_samples_is_in_the_next_one() {
        let mut past = Past::new(0.1);
        run(&mut past, 0, 1..=40);
        let history = past.before(40, 4.0, FIRST, |_| 0);
        assert_eq!(history.t_s, [1.0, 2.0, 3.0, 4.0]);
        assert_eq!(history.of_energy, [0.1, 0.9, 0.1, 0.1]);
        assert_eq!(history.vessel, Some(0));
        assert_eq!(history.ahead_mps, [1.0, 2.0, 3.0, 4.0]);
        let other = Of { place: 1, vessel: Some(2), as_shown: false };
        let truth = past.before(40, 4.0, other, |_| 0);
        assert_eq!((truth.vessel, truth.ahead_mps), (Some(2), vec![-1.0, -2.0, -3.0, -4.0]));
        // The instruments of the other ship are frozen; those of the first are not.
        let as_shown = |of: Of| past.before(40, 4.0, Of { as_shown: true, ..of }, |_| 0);
        assert_eq!(as_shown(other).ahead_mps, [7.0; 4]);
        assert_eq!(as_shown(FIRST), history);
        // After a rewind, the past has only entries before the tick. Repeated steps change nothing.
        assert_eq!(past.before(25, 2.5, FIRST, |_| 0).t_s, [1.0, 2.0]);
        let version = past.version();
        run(&mut past, 0, 26..=40);
        assert_eq!(past.version(), version);
    }

    #[test]
    fn a_branch_has_the_past_of_its_parent_up_to_its_beginning_and_its_own() {
        let mut past = Past::new(0.1);
        run(&mut past, 0, 1..=40);
        past.keep_event(0, 35, said(3.5, "only in the first run"));
        past.keep_event(1, 20, said(2.0, "in the branch"));
        run(&mut past, 1, 21..=40);
        let on_branch = |tick| usize::from(tick >= 20);
        let history = past.before(40, 4.0, FIRST, on_branch);
        assert_eq!(history.t_s, [1.0, 2.0, 3.0, 4.0]);
        assert_eq!(history.events, [said(2.0, "in the branch")]);
        assert_eq!(past.before(40, 4.0, FIRST, |_| 0).events, [said(3.5, "only in the first run")]);
    }

    #[test]
    fn it_is_bounded() {
        let mut past = Past::new(1.0);
        for tick in 1..=20_000 {
            let event = said(tick as f64, "x");
            past.keep_step(0, tick, sample(tick as f64, 0.0), std::iter::once(event));
        }
        assert_eq!((past.samples.len(), past.events.len()), (MOST_SAMPLES, MOST_EVENTS));
        let history = past.before(20_000, 20_000.0, FIRST, |_| 0);
        assert_eq!(history.t_s.len(), 1801);
        assert_eq!(history.events.len(), SHOWN_EVENTS);
        assert_eq!(history.events.last(), Some(&said(20_000.0, "x")));
        let bytes = crate::message::text(&history).len();
        assert!(bytes < 150_000, "{bytes}");
    }
}
