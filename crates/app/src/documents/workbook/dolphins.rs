//! The sheet of flexible dolphins.

use fenderline_results::Outcome;
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::fenders::TONNE_N;
use super::table::{Head, sheet_of};

/// One row a flexible dolphin.
pub(super) fn dolphins(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let heads = [
        Head("Dolphin", "", 22.0),
        Head("Stiffness", "MN/m", 10.0),
        Head("Moving mass", "t", 10.0),
        Head("Period", "s", 9.0),
        Head("Deflection", "mm", 11.0),
        Head("At", "s", 10.0),
        Head("Load", "kN", 11.0),
        Head("Load", "t", 11.0),
        Head("At", "s", 10.0),
        Head("Energy", "kJ (kN·m)", 12.0),
        Head("Yield load", "kN", 11.0),
        Head("of yield load", "%", 10.0),
        Head("Yielded first", "s", 10.0),
        Head("Permanent deflection", "mm", 12.0),
    ];
    let rows = outcome.dolphins.iter().map(|of| {
        let body = &outcome.setup.bodies[of.body];
        let own = body.dolphin.as_ref();
        vec![
            body.name.as_str().into(),
            own.map(|own| own.stiffness_npm / 1e6).into(),
            own.map(|own| own.mass_kg / 1e3).into(),
            own.map(fenderline_sim::DolphinSetup::period_s).into(),
            (of.peak_deflection_m * 1e3).into(),
            of.peak_deflection_at_s.into(),
            (of.peak_load_n / 1e3).into(),
            (of.peak_load_n / TONNE_N).into(),
            of.peak_load_at_s.into(),
            (of.peak_energy_j / 1e3).into(),
            own.and_then(|own| own.yield_load_n).map(|load_n| load_n / 1e3).into(),
            of.share_of_yield_load.map(|share| 100.0 * share).into(),
            of.yielded_at_s.into(),
            (of.offset_m * 1e3).into(),
        ]
    });
    sheet_of(sheet, "Dolphins", &heads, rows, 1)
}
