//! The table of fenders.

use super::{Column, List, float, name};
use crate::touched::TouchedFender;

/// One touched fender in one step.
pub(crate) struct FenderRow {
    t_s: f64,
    fender: usize,
    touched: TouchedFender,
    hull_pressure_npm2: f64,
}

impl FenderRow {
    /// The row of fender number `fender`, whose face has this area.
    pub(crate) fn new(t_s: f64, fender: usize, face_m2: f64, touched: TouchedFender) -> FenderRow {
        let hull_pressure_npm2 = touched.peak_reaction_n / face_m2;
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
        float(
            "hull_pressure_npm2",
            "N/m²",
            "largest pressure on the hull within the step: reaction over width times height",
            |r| r.hull_pressure_npm2,
        ),
    ]
}
