//! The table of flexible dolphins.

use fenderline_contact::PileMotion;
use fenderline_contact::number::greater;
use fenderline_sim::DolphinMotion;

use super::{Column, Layout, List, float, name};
use crate::row::Row;

/// A row of the table of dolphins: one flexible dolphin in one output interval.
pub(crate) struct DolphinRow {
    t_s: f64,
    body: usize,
    pile: PileMotion,
}

impl DolphinRow {
    /// The row of a dolphin in a time step.
    pub(crate) fn new(t_s: f64, now: &DolphinMotion) -> DolphinRow {
        DolphinRow { t_s, body: now.body, pile: now.pile }
    }
}

impl Row for DolphinRow {
    type Key = usize;

    fn key(&self) -> usize {
        self.body
    }

    fn join(&mut self, later: DolphinRow) {
        let before = self.pile;
        let now = later.pile;
        self.pile = PileMotion {
            peak_deflection_m: greater(before.peak_deflection_m, now.peak_deflection_m),
            peak_load_n: greater(before.peak_load_n, now.peak_load_n),
            peak_stored_j: greater(before.peak_stored_j, now.peak_stored_j),
            work_j: before.work_j + now.work_j,
            damping_j: before.damping_j + now.damping_j,
            yield_j: before.yield_j + now.yield_j,
            ..now
        };
    }

    fn close(&mut self, _own: f64, _all: f64) {}
}

/// The table `dolphins`.
pub(crate) fn dolphins_table() -> Layout<DolphinRow> {
    let columns: Vec<Column<DolphinRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("dolphin", "name of the dolphin's body", List::Bodies, |r| Some(r.body)),
        float(
            "deflection_north_m",
            "m",
            "deflection of the head at the end of the interval, north, the permanent part included",
            |r| r.pile.deflection_m.x,
        ),
        float("deflection_east_m", "m", "the same, east", |r| r.pile.deflection_m.y),
        float("peak_deflection_m", "m", "largest deflection within the interval", |r| {
            r.pile.peak_deflection_m
        }),
        float("load_n", "N", "load on the pile at the end of the interval", |r| {
            r.pile.force_n.length()
        }),
        float("peak_load_n", "N", "largest load on the pile within the interval", |r| {
            r.pile.peak_load_n
        }),
        float("stored_j", "J", "energy in the pile's bending at the end of the interval", |r| {
            r.pile.stored_j
        }),
        float(
            "peak_stored_j",
            "J",
            "largest energy in the pile's bending within the interval",
            |r| r.pile.peak_stored_j,
        ),
        float("damping_j", "J", "energy lost to damping of the pile in the interval", |r| {
            r.pile.damping_j
        }),
        float("yield_j", "J", "energy lost to yielding of the pile in the interval", |r| {
            r.pile.yield_j
        }),
        float("offset_m", "m", "permanent deflection at the end of the interval", |r| {
            r.pile.offset_m.length()
        }),
    ];
    Layout { name: "dolphins", rows: "one row per flexible dolphin and interval", columns }
}
