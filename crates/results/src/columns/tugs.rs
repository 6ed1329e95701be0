//! The table of tugs.

use core::f64::consts::TAU;

use fenderline_contact::number::greater;
use fenderline_sim::TugAtWork;
use fenderline_sim::tug::TugOrder;

use super::{Column, Layout, List, flag, float, name};
use crate::row::Row;

/// A row of the table of tugs: one tug in one output interval.
pub(crate) struct TugRow {
    t_s: f64,
    tug: usize,
    ordered_n: f64,
    force_n: f64,
    peak_force_n: f64,
    direction_rad: f64,
    on_line: bool,
    limited: bool,
}

impl TugRow {
    /// The row of tug number `tug`.
    pub(crate) fn new(t_s: f64, tug: usize, now: &TugAtWork) -> TugRow {
        let force_n = libm::hypot(now.force.surge_n, now.force.sway_n);
        TugRow {
            t_s,
            tug,
            ordered_n: match now.state.order {
                TugOrder::StandBy => 0.0,
                TugOrder::Push { force_n, .. } | TugOrder::Pull { force_n, .. } => force_n,
            },
            force_n,
            peak_force_n: force_n,
            direction_rad: libm::remainder(now.state.direction_rad, TAU),
            on_line: now.state.on_line,
            limited: now.limited,
        }
    }
}

impl Row for TugRow {
    type Key = usize;

    fn key(&self) -> usize {
        self.tug
    }

    fn join(&mut self, later: TugRow) {
        self.force_n += later.force_n;
        self.peak_force_n = greater(self.peak_force_n, later.peak_force_n);
        self.limited |= later.limited;
    }

    fn close(&mut self, _own: f64, all: f64) {
        self.force_n /= all;
    }
}

/// The table `tugs`.
pub(crate) fn tugs_table() -> Layout<TugRow> {
    let columns: Vec<Column<TugRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("tug", "name of the tug", List::Tugs, |r| Some(r.tug)),
        float("force_order_n", "N", "ordered force at the start of the interval", |r| r.ordered_n),
        float("force_n", "N", "mean force on the assisted ship", |r| r.force_n),
        float(
            "peak_force_n",
            "N",
            "largest force on the assisted ship in a step of the interval",
            |r| r.peak_force_n,
        ),
        float(
            "force_direction_rad",
            "rad",
            "direction of the force at the start of the interval, from the assisted ship's bow, positive to starboard",
            |r| r.direction_rad,
        ),
        flag(
            "pulls_on_line",
            "whether the tug pulls on a line at the start of the interval; otherwise she pushes",
            |r| r.on_line,
        ),
        flag(
            "force_limited",
            "whether the tug could not give the ordered force at this speed and angle in a step of the interval",
            |r| r.limited,
        ),
    ];
    Layout { name: "tugs", rows: "one row per tug and interval", columns }
}
