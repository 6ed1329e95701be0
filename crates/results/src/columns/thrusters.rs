//! The table of thrusters: one row per thruster, so that the columns do not depend on the number of thrusters.

use super::{Column, Layout, List, float, name};
use crate::row::Row;

/// A row of the table: one thruster of a vessel at the start of an output interval.
pub(crate) struct ThrusterRow {
    pub(crate) t_s: f64,
    pub(crate) vessel: usize,
    /// Index of the thruster among the thrusters of all vessels.
    pub(crate) thruster: usize,
    pub(crate) order: f64,
    pub(crate) power: f64,
}

impl Row for ThrusterRow {
    type Key = usize;

    fn key(&self) -> usize {
        self.thruster
    }

    fn join(&mut self, _later: ThrusterRow) {}

    fn close(&mut self, _own: f64, _all: f64) {}
}

/// The table `thrusters`.
pub(crate) fn thrusters_table() -> Layout<ThrusterRow> {
    let columns: Vec<Column<ThrusterRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("vessel", "name of the vessel's body", List::Vessels, |r| Some(r.vessel)),
        name("thruster", "name of the thruster", List::Thrusters, |r| Some(r.thruster)),
        float(
            "thrust_order",
            "1",
            "ordered thrust divided by full thrust, −1 (to port) to 1 (to starboard)",
            |r| r.order,
        ),
        float(
            "thrust",
            "1",
            "thrust divided by full thrust, −1 (to port) to 1 (to starboard)",
            |r| r.power,
        ),
    ];
    Layout {
        name: "thrusters",
        rows: "one row per tunnel thruster and interval, with the thruster's state at the start of the interval",
        columns,
    }
}
