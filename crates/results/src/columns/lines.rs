//! The table of mooring lines.

use fenderline_sim::Mooring;

use super::{Column, Layout, List, flag, float, name};

/// One line that was made fast, in one step.
pub(crate) struct LineRow {
    t_s: f64,
    line: usize,
    tension_n: f64,
    length_m: f64,
    rendered_m: f64,
    parted: bool,
}

impl LineRow {
    /// The row of line number `line`; `None` while it is not fast.
    pub(crate) fn new(t_s: f64, line: usize, now: &Mooring) -> Option<LineRow> {
        let (_, state) = now.line.as_ref()?;
        Some(LineRow {
            t_s,
            line,
            tension_n: now.load.tension_n,
            length_m: state.length_m,
            rendered_m: now.load.winch.rendered_m,
            parted: state.parted,
        })
    }
}

/// The table `lines`.
pub(crate) fn lines_table() -> Layout<LineRow> {
    let columns: Vec<Column<LineRow>> = vec![
        float("t_s", "s", "start of the step", |r| r.t_s),
        name("line", "name of the line", List::Lines, |r| Some(r.line)),
        float("tension_n", "N", "tension at the ship's end", |r| r.tension_n),
        float("unstretched_length_m", "m", "unstretched length outboard, tail included", |r| {
            r.length_m
        }),
        float("rendered_m", "m", "line that the winch brake rendered in the step", |r| {
            r.rendered_m
        }),
        flag("parted", "whether it has parted", |r| r.parted),
    ];
    Layout { name: "lines", rows: "one row per line that is made fast, and step", columns }
}
