//! The table of fenders.

use fenderline_sim::FenderSetup;

use super::{Column, List, float, known, name};
use crate::touched::TouchedFender;

/// One touched fender in one step.
pub(crate) struct FenderRow {
    t_s: f64,
    fender: usize,
    touched: TouchedFender,
    hull_pressure_npm2: Option<f64>,
}

impl FenderRow {
    /// The row of fender number `fender`, which this is the set-up of.
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

/// The columns of `fenders`, in their order.
pub(crate) fn fenders_columns() -> Vec<Column<FenderRow>> {
    vec![
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
        float("stored_j", "J", "stored in spring and stop at the start of the step", |r| {
            r.touched.stored_j
        }),
        known(
            "hull_pressure_npm2",
            "N/m²",
            "largest pressure on the hull within the step: reaction over width times height, or by inner \
             pressure; empty or NaN where not known",
            |r| r.hull_pressure_npm2,
        ),
    ]
}
