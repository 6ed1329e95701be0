//! The table of fenders.

use fenderline_sim::FenderSetup;

use super::{Column, Layout, List, float, known, name};
use crate::touched::TouchedFender;

/// One touched fender in one step.
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

/// The table `fenders`.
pub(crate) fn fenders_table() -> Layout<FenderRow> {
    let columns: Vec<Column<FenderRow>> = vec![
        float("t_s", "s", "start of the step", |r| r.t_s),
        name("fender", "name of the fender", List::Fenders, |r| Some(r.fender)),
        float("deflection_m", "m", "deflection at the start of the step", |r| {
            r.touched.deflection_m
        }),
        float("reaction_n", "N", "mean reaction along the fender's axis over the step", |r| {
            r.touched.reaction_n
        }),
        float(
            "peak_reaction_n",
            "N",
            "largest reaction along the fender's axis within the step",
            |r| r.touched.peak_reaction_n,
        ),
        float("stored_j", "J", "energy stored in spring and stop at the start of the step", |r| {
            r.touched.stored_j
        }),
        known(
            "hull_pressure_npm2",
            "N/m²",
            "largest pressure on the hull within the step: reaction over width times height, or by inner \
             pressure; empty (csv) or NaN (parquet) where not known",
            |r| r.hull_pressure_npm2,
        ),
    ];
    Layout { name: "fenders", rows: "one row per touched fender and step", columns }
}
