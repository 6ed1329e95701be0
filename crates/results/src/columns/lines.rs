//! The table of mooring lines.

use fenderline_contact::number::greater;
use fenderline_sim::Mooring;

use super::{Column, Layout, List, flag, float, name};
use crate::row::Row;

/// A row of the table of lines: one mooring line that was made fast, in one output interval.
pub(crate) struct LineRow {
    t_s: f64,
    line: usize,
    tension_n: f64,
    peak_tension_n: f64,
    length_m: f64,
    rendered_m: f64,
    parted: bool,
}

impl LineRow {
    /// The row of mooring line number `line`; `None` while the line is not made fast.
    pub(crate) fn new(t_s: f64, line: usize, now: &Mooring) -> Option<LineRow> {
        let (_, state) = now.line.as_ref()?;
        Some(LineRow {
            t_s,
            line,
            tension_n: now.load.tension_n,
            peak_tension_n: greater(now.load.tension_n, now.load.parted_at_n.unwrap_or(0.0)),
            length_m: state.length_m,
            rendered_m: now.load.winch.rendered_m,
            parted: state.parted,
        })
    }
}

impl Row for LineRow {
    type Key = usize;

    fn key(&self) -> usize {
        self.line
    }

    fn join(&mut self, later: LineRow) {
        self.tension_n += later.tension_n;
        self.peak_tension_n = greater(self.peak_tension_n, later.peak_tension_n);
        self.rendered_m += later.rendered_m;
        self.parted |= later.parted;
    }

    fn close(&mut self, own: f64, _all: f64) {
        self.tension_n /= own;
    }
}

/// The table `lines`.
pub(crate) fn lines_table() -> Layout<LineRow> {
    let columns: Vec<Column<LineRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("line", "name of the line", List::Lines, |r| Some(r.line)),
        float("tension_n", "N", "mean tension at the ship's end while the line is fast", |r| {
            r.tension_n
        }),
        float(
            "peak_tension_n",
            "N",
            "largest tension at the ship's end in a step of the interval; for a line that parts, \
             the tension at which it parts",
            |r| r.peak_tension_n,
        ),
        float(
            "unstretched_length_m",
            "m",
            "unstretched length outboard at the start of the interval, tail included",
            |r| r.length_m,
        ),
        float(
            "rendered_m",
            "m",
            "length of line that the winch brake rendered in the interval",
            |r| r.rendered_m,
        ),
        flag("parted", "whether the line has parted", |r| r.parted),
    ];
    Layout { name: "lines", rows: "one row per line that is made fast, and interval", columns }
}
