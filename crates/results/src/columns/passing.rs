//! The table of passing ships.

use fenderline_sim::passing::PassingSetup;
use fenderline_sim::track::OnTrack;

use super::{Column, Layout, List, float, name};
use crate::row::Row;

/// A row of the table: one passing ship at the start of one output interval.
pub(crate) struct PassingRow {
    t_s: f64,
    ship: usize,
    now: OnTrack,
}

impl PassingRow {
    /// The row of passing ship number `ship` at the start of an interval.
    pub(crate) fn new(t_s: f64, ship: usize, setup: &PassingSetup) -> PassingRow {
        PassingRow { t_s, ship, now: setup.track.at(t_s) }
    }
}

impl Row for PassingRow {
    type Key = usize;

    fn key(&self) -> usize {
        self.ship
    }

    fn join(&mut self, _later: PassingRow) {}

    fn close(&mut self, _own: f64, _all: f64) {}
}

/// The table `passing`.
pub(crate) fn passing_table() -> Layout<PassingRow> {
    let columns: Vec<Column<PassingRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("ship", "name of the passing ship", List::Passing, |r| Some(r.ship)),
        float("x_m", "m", "midship: north", |r| r.now.pose.position_m.x),
        float("y_m", "m", "midship: east", |r| r.now.pose.position_m.y),
        float("heading_rad", "rad", "heading, clockwise from north", |r| r.now.heading_rad),
        float("speed_mps", "m/s", "speed over ground along the track", |r| r.now.speed_mps),
    ];
    Layout {
        name: "passing",
        rows: "one row per passing ship and interval, with the state at the start of the interval",
        columns,
    }
}
