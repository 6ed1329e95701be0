//! The table of panels on several cones.

use fenderline_contact::PanelMotion;
use fenderline_contact::number::{greater, lesser};

use super::{Column, Layout, List, float, name};
use crate::row::Row;

/// A row of the table of panels: one panel pressed by one hull in one output interval.
pub(crate) struct PanelRow {
    t_s: f64,
    motion: PanelMotion,
    /// Largest and smallest deflection of a cone (m).
    cones_m: [f64; 2],
}

impl PanelRow {
    /// The row of a panel on several cones.
    pub(crate) fn new(t_s: f64, motion: &PanelMotion, cones: usize) -> PanelRow {
        let most_m = motion.peak_deflections_m.iter().take(cones).copied().fold(0.0, greater);
        let least_m = motion.least_deflections_m.iter().take(cones).copied();
        let least_m = least_m.fold(f64::INFINITY, lesser);
        PanelRow { t_s, motion: *motion, cones_m: [most_m, least_m] }
    }
}

impl Row for PanelRow {
    /// Fender, hull.
    type Key = (u32, u32);

    fn key(&self) -> Self::Key {
        (self.motion.fender.0, self.motion.hull.0)
    }

    fn begin_late(&mut self) {
        let PanelMotion { deflection_m, tilt_rad, moment_nm, .. } = &mut self.motion;
        (*deflection_m, *tilt_rad, *moment_nm) = (0.0, 0.0, 0.0);
    }

    fn join(&mut self, later: PanelRow) {
        let larger = |now: f64, later: f64| if later.abs() > now.abs() { later } else { now };
        let (now, next) = (&mut self.motion, &later.motion);
        now.peak_tilt_rad = larger(now.peak_tilt_rad, next.peak_tilt_rad);
        now.peak_moment_nm = larger(now.peak_moment_nm, next.peak_moment_nm);
        let ([most_m, least_m], [later_most_m, later_least_m]) = (self.cones_m, later.cones_m);
        self.cones_m = [greater(most_m, later_most_m), lesser(least_m, later_least_m)];
    }

    fn close(&mut self, _own: f64, _all: f64) {}
}

/// The table `panels`.
pub(crate) fn panels_table() -> Layout<PanelRow> {
    let columns: Vec<Column<PanelRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("fender", "name of the fender with the panel", List::Fenders, |r| {
            Some(r.motion.fender.0 as usize)
        }),
        name("hull", "name of the body that presses the panel", List::Bodies, |r| {
            Some(r.motion.hull.0 as usize)
        }),
        float(
            "deflection_m",
            "m",
            "deflection of the panel's middle at the start of the interval; the deflection of a \
             cone at x m to the right of the middle is deflection_m + x tilt_rad",
            |r| r.motion.deflection_m,
        ),
        float(
            "tilt_rad",
            "rad",
            "turn of the panel about the vertical axis at the start of the interval, positive if the \
             right end, as seen from the water, is deflected more",
            |r| r.motion.tilt_rad,
        ),
        float(
            "moment_nm",
            "N·m",
            "moment of the cones' reactions about the panel's middle at the start of the interval, \
             positive if the right cones bear more",
            |r| r.motion.moment_nm,
        ),
        float(
            "peak_tilt_rad",
            "rad",
            "turn with the largest magnitude within the interval, with its sign",
            |r| r.motion.peak_tilt_rad,
        ),
        float(
            "peak_moment_nm",
            "N·m",
            "moment with the largest magnitude within the interval, with its sign",
            |r| r.motion.peak_moment_nm,
        ),
        float(
            "peak_cone_deflection_m",
            "m",
            "largest deflection of a cone within the interval",
            |r| r.cones_m[0],
        ),
        float(
            "least_cone_deflection_m",
            "m",
            "smallest deflection of a cone within the interval, negative if the cone was stretched",
            |r| r.cones_m[1],
        ),
    ];
    Layout {
        name: "panels",
        rows: "one row per panel on several cones, hull and interval in which the hull presses it",
        columns,
    }
}
