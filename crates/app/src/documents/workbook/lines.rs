//! The sheet of mooring lines.

use fenderline_results::Outcome;
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::fenders::TONNE_N;
use super::table::{Head, sheet_of};

/// One row a mooring line.
pub(super) fn lines(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let heads = [
        Head("Line", "", 22.0),
        Head("Made fast", "s", 10.0),
        Head("Peak tension", "kN", 12.0),
        Head("Peak tension", "t", 12.0),
        Head("At", "s", 10.0),
        Head("Break load", "kN", 12.0),
        Head("of break load", "%", 12.0),
        Head("Working load", "kN", 12.0),
        Head("of working load", "%", 12.0),
        Head("Time above working load", "s", 13.0),
        Head("Rendered by its winch", "m", 12.0),
        Head("Parted", "s", 10.0),
        Head("Tension at the end", "kN", 12.0),
        Head("Verdict", "", 22.0),
    ];
    let all = outcome.setup.world.lines.iter().zip(&outcome.world.lines);
    let rows = all.map(|(line, totals)| {
        let kilo = |value: Option<f64>| value.map(|value| value / 1e3);
        let working = totals.working_load_n.map(|load_n| 100.0 * totals.tension_n.value / load_n);
        vec![
            line.line.name.as_str().into(),
            totals.made_fast_s.into(),
            (totals.tension_n.value / 1e3).into(),
            (totals.tension_n.value / TONNE_N).into(),
            totals.tension_n.at_s.into(),
            kilo(totals.break_load_n).into(),
            totals.share_of_break_load().map(|share| 100.0 * share).into(),
            kilo(totals.working_load_n).into(),
            working.into(),
            totals.over_working.s().into(),
            totals.rendered_m.into(),
            totals.parted_s.into(),
            (totals.last_tension_n / 1e3).into(),
            totals.verdict().text().into(),
        ]
    });
    sheet_of(sheet, "Lines", &heads, rows, 1)
}
