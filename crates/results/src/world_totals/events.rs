//! Counts the events of vessels, tugs, mooring lines and anchors.

use fenderline_sim::{Setup, StepRecord, WorldEvent, WorldEventKind};

/// Largest number of events that are kept one by one.
const FIRST: usize = 40;

/// Events of a run: the count of each kind, and the first few. The size of this list does not grow with the length of
/// the run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorldEvents {
    /// Count of each kind of event, in the order of first occurrence.
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

    /// The kinds of events that occurred, with their counts.
    pub fn counts(&self) -> &[(WorldEventKind, u64)] {
        &self.counts
    }

    /// The first events, each with the start of its time step (s).
    pub fn first(&self) -> &[(f64, WorldEvent)] {
        &self.first
    }
}

/// The vessel, tug, line or anchor that an event is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Who<'a> {
    /// Kind of the part: `vessel`, `tug`, `line` or `anchor`.
    pub kind: &'static str,
    /// Name of the vessel, tug, line or anchor in the scenario.
    pub name: &'a str,
}

impl<'a> Who<'a> {
    /// Finds the vessel, tug, line or anchor that an event is about.
    pub fn of(event: &WorldEvent, setup: &'a Setup) -> Who<'a> {
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
            | WorldEventKind::LineMadeFast
            | WorldEventKind::LineParted
            | WorldEventKind::LineNotParted
            | WorldEventKind::LineRenders => {
                Who { kind: "line", name: &world.lines[event.who].line.name }
            }
            WorldEventKind::Anchor(_) => {
                Who { kind: "anchor", name: &world.anchors[event.who].gear.name }
            }
        }
    }
}
