//! The table of fenders.

use fenderline_contact::number::greater;
use fenderline_sim::FenderSetup;

use super::{Column, Layout, List, float, known, name};
use crate::row::Row;
use crate::touched::TouchedFender;

/// A row of the table of fenders: one touched fender in one output interval.
pub(crate) struct FenderRow {
    t_s: f64,
    fender: usize,
    touched: TouchedFender,
    hull_pressure_npm2: Option<f64>,
}

impl FenderRow {
    /// The row of fender number `fender`, with its set-up.
    pub(crate) fn new(
        t_s: f64,
        fender: usize,
        setup: &FenderSetup,
        touched: TouchedFender,
    ) -> FenderRow {
        let hull_pressure_npm2 =
            setup.hull_pressure_npm2(touched.peak_deflection_m, touched.peak_reaction_n);
        FenderRow { t_s, fender, touched, hull_pressure_npm2 }
    }
}

impl Row for FenderRow {
    type Key = usize;

    fn key(&self) -> usize {
        self.fender
    }

    fn begin_late(&mut self) {
        (self.touched.deflection_m, self.touched.stored_j) = (0.0, 0.0);
    }

    fn join(&mut self, later: FenderRow) {
        let (touched, later_touched) = (&mut self.touched, &later.touched);
        touched.reaction_n += later_touched.reaction_n;
        touched.peak_reaction_n = greater(touched.peak_reaction_n, later_touched.peak_reaction_n);
        touched.peak_deflection_m =
            greater(touched.peak_deflection_m, later_touched.peak_deflection_m);
        let both = self.hull_pressure_npm2.zip(later.hull_pressure_npm2);
        self.hull_pressure_npm2 = both.map(|(pressure, later)| greater(pressure, later));
    }

    fn close(&mut self, _own: f64, all: f64) {
        self.touched.reaction_n /= all;
    }
}

/// The table `fenders`.
pub(crate) fn fenders_table() -> Layout<FenderRow> {
    let columns: Vec<Column<FenderRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("fender", "name of the fender", List::Fenders, |r| Some(r.fender)),
        float("deflection_m", "m", "deflection at the start of the interval", |r| {
            r.touched.deflection_m
        }),
        float("peak_deflection_m", "m", "largest deflection within the interval", |r| {
            r.touched.peak_deflection_m
        }),
        float("reaction_n", "N", "mean reaction along the fender's axis over the interval", |r| {
            r.touched.reaction_n
        }),
        float(
            "peak_reaction_n",
            "N",
            "largest reaction along the fender's axis within the interval",
            |r| r.touched.peak_reaction_n,
        ),
        float(
            "stored_j",
            "J",
            "energy stored in spring and stop at the start of the interval",
            |r| r.touched.stored_j,
        ),
        known(
            "hull_pressure_npm2",
            "N/m²",
            "largest pressure on the hull within the interval: reaction divided by the area of the \
             face (width times height), or from the inner pressure; empty (csv) or NaN (parquet) \
             if not known",
            |r| r.hull_pressure_npm2,
        ),
    ];
    Layout {
        name: "fenders",
        rows: "one row per fender and interval in which it is touched",
        columns,
    }
}
