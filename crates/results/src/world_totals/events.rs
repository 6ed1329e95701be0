//! Events of vessels, tugs and lines, counted.

use fenderline_sim::{Setup, StepRecord, WorldEvent, WorldEventKind};

/// Events kept one by one at most.
const FIRST: usize = 40;

/// Events of a run: the count of each kind, and the first few. Its size does not grow with the run.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WorldEvents {
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

    /// The kinds that occurred, with their counts.
    pub fn counts(&self) -> &[(WorldEventKind, u64)] {
        &self.counts
    }

    /// The first of them, with the start of their step (s).
    pub fn first(&self) -> &[(f64, WorldEvent)] {
        &self.first
    }
}

/// The vessel, tug, line or anchor that an event is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Who<'a> {
    /// `vessel`, `tug`, `line` or `anchor`.
    pub kind: &'static str,
    /// Name of the vessel in the scenario.
    pub name: &'a str,
}

impl<'a> Who<'a> {
    /// The subject of an event.
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
