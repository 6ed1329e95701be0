//! What happened to vessels, tugs and lines, counted.

use fenderline_sim::{Setup, StepRecord, WorldEvent, WorldEventKind};

/// How many events are told one by one.
const FIRST: usize = 40;

/// Events of a run: how many of each kind, and the first few. Bounded, whatever the run's length.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct WorldEvents {
    /// In the order of first occurrence.
    counts: Vec<(WorldEventKind, u64)>,
    first: Vec<(f64, WorldEvent)>,
}

impl WorldEvents {
    pub(super) fn add(&mut self, step: &StepRecord<'_>) {
        for event in step.world_events {
            match self.counts.iter_mut().find(|(known, _)| *known == event.kind) {
                Some((_, count)) => *count += 1,
                None => self.counts.push((event.kind, 1)),
            }
            if self.first.len() < FIRST {
                self.first.push((step.t_s, *event));
            }
        }
    }

    /// The kinds that occurred, and how often.
    pub(crate) fn counts(&self) -> &[(WorldEventKind, u64)] {
        &self.counts
    }

    /// The first of them, with the start of their step (s).
    pub(crate) fn first(&self) -> &[(f64, WorldEvent)] {
        &self.first
    }
}

/// What an event is about: its kind, and its name.
pub(crate) struct Who<'a> {
    pub(crate) kind: &'static str,
    pub(crate) name: &'a str,
}

impl<'a> Who<'a> {
    /// Of an event.
    pub(crate) fn of(event: &WorldEvent, setup: &'a Setup) -> Who<'a> {
        let world = &setup.world;
        match event.kind {
            WorldEventKind::OrderClamped
            | WorldEventKind::Aground
            | WorldEventKind::ShallowHeld => {
                let body = world.vessels[event.who].body;
                Who { kind: "vessel", name: &setup.bodies[body].name }
            }
            WorldEventKind::TugLimited | WorldEventKind::TugOrderRefused => {
                Who { kind: "tug", name: &world.tugs[event.who].tug.name }
            }
            WorldEventKind::LineNotMadeFast
            | WorldEventKind::LineParted
            | WorldEventKind::LineRenders => {
                Who { kind: "line", name: &world.lines[event.who].line.name }
            }
        }
    }
}

/// What a reader of the report is told of a kind of event.
pub(crate) fn world_event_text(kind: WorldEventKind) -> &'static str {
    match kind {
        WorldEventKind::OrderClamped => "an order was beyond a stop: the stop was ordered",
        WorldEventKind::Aground => "AGROUND: the water is no deeper than her draught and her squat",
        WorldEventKind::ShallowHeld => {
            "less than 1.1 draughts of water, for which no formula is made: what shallow water does is held"
        }
        WorldEventKind::TugLimited => "cannot give at this speed and angle what she is ordered to",
        WorldEventKind::TugOrderRefused => "an order was refused: no such force or direction",
        WorldEventKind::LineNotMadeFast => {
            "could not be made fast where its ends were: too short, or no such pretension"
        }
        WorldEventKind::LineParted => "PARTED",
        WorldEventKind::LineRenders => "the brake of the winch rendered",
    }
}
