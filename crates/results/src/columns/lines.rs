//! The table of mooring lines.

use fenderline_sim::Mooring;

use super::{Column, List, flag, float, name};

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

/// The columns of `lines`, in their order.
pub(crate) fn lines_columns() -> Vec<Column<LineRow>> {
    vec![
        float("t_s", "s", "start of the step", |r| r.t_s),
        name("line", "name of the line", List::Lines, |r| Some(r.line)),
        float("tension_n", "N", "tension at the ship's end", |r| r.tension_n),
        float("length_m", "m", "unstretched length outboard, the tail included", |r| r.length_m),
        float("rendered_m", "m", "rope that the brake of the winch let go in the step", |r| {
            r.rendered_m
        }),
        flag("parted", "whether it has parted", |r| r.parted),
    ]
}
