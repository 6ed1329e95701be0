//! The sheet of contacts.

use fenderline_results::Outcome;
use fenderline_sim::constants::KNOT_MPS;
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::table::{Cell, Head, sheet_of};

/// One row a pair that touched.
pub(super) fn contacts(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let heads = [
        Head("Body", "", 20.0),
        Head("Other body", "", 20.0),
        Head("First touch", "s", 10.0),
        Head("Peak normal force", "kN", 12.0),
        Head("At", "s", 10.0),
        Head("Peak penetration or deflection", "m", 14.0),
        Head("of the fender", "", 20.0),
        Head("Impulse", "kN·s", 12.0),
        Head("Approach speed", "m/s", 12.0),
        Head("Approach speed", "kn", 12.0),
        Head("Final speed", "m/s", 12.0),
        Head("Final speed", "kn", 12.0),
    ];
    let setup = outcome.setup;
    let rows = outcome.pairs.iter().map(|pair| {
        let [one, other] = pair.bodies.map(|body| setup.bodies[body].name.as_str());
        let fender = pair.peak_depth_fender.map(|fender| setup.fenders[fender].name.as_str());
        vec![
            one.into(),
            other.into(),
            pair.first_touch_s.into(),
            (pair.peak_normal_force_n / 1e3).into(),
            pair.peak_normal_force_at_s.into(),
            pair.peak_depth_m.into(),
            fender.map_or(Cell::Empty, Cell::from),
            (pair.impulse_ns / 1e3).into(),
            pair.approach_speed_mps.into(),
            (pair.approach_speed_mps / KNOT_MPS).into(),
            pair.final_speed_mps.into(),
            (pair.final_speed_mps / KNOT_MPS).into(),
        ]
    });
    sheet_of(sheet, "Contacts", &heads, rows, 2)
}
