//! The sheets of fenders, of panels on several cones, and of chains.

use fenderline_results::{CHAINS, FENDERS, FenderVerdict, Outcome};
use fenderline_sim::{ConeUse, Setup};
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::table::{Cell, Head, cells_of, heads_of, sheet_of};

/// One row a fender.
pub(super) fn fenders(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let mut heads = vec![
        Head("Fender", "", 22.0),
        Head("Type", "", 30.0),
        Head("On", "", 16.0),
        Head("Forward", "m", 10.0),
        Head("Starboard", "m", 10.0),
        Head("Touched", "", 9.0),
        Head("Verdict", "", 14.0),
    ];
    heads.extend(heads_of(&FENDERS));
    let rows = (0..outcome.setup.fenders.len()).map(|index| fender(outcome, index));
    sheet_of(sheet, "Fenders", &heads, rows, 1)
}

fn fender(outcome: &Outcome<'_>, index: usize) -> Vec<Cell> {
    let Setup { fenders, bodies, .. } = outcome.setup;
    let fender = &fenders[index];
    let kind = fender.source.as_ref().map_or("", |source| source.designation.as_str());
    let summary = outcome.fenders.iter().find(|summary| summary.fender == index);
    let verdict = summary.map(|summary| FenderVerdict::of(fender, summary).text());
    let mut cells: Vec<Cell> = vec![
        fender.name.as_str().into(),
        kind.into(),
        bodies[fender.body].name.as_str().into(),
        fender.position_m.x.into(),
        fender.position_m.y.into(),
        Cell::Flag(summary.is_some()),
        verdict.map_or(Cell::Empty, Cell::from),
    ];
    cells.extend(cells_of(&FENDERS, fender, summary));
    cells
}

/// Writes one row for each cone of the touched fenders whose panel stands on several cones.
pub(super) fn panels(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let heads = [
        Head("Fender", "", 22.0),
        Head("Largest turn of the panel", "deg", 12.0),
        Head("At", "s", 10.0),
        Head("Largest moment of the panel", "kN·m", 13.0),
        Head("At", "s", 10.0),
        Head("Cone", "", 7.0),
        Head("Right of the middle", "m", 11.0),
        Head("Deflection", "mm", 11.0),
        Head("of rated", "%", 9.0),
        Head("Reaction by its curve", "kN", 12.0),
        Head("of rated", "%", 9.0),
        Head("Energy by its curve", "kJ (kN·m)", 12.0),
        Head("of rated", "%", 9.0),
        Head("Largest stretch", "mm", 11.0),
    ];
    let percent = |share: Option<f64>| Cell::from(share.map(|share| 100.0 * share));
    let panels = outcome.fenders.iter().filter_map(|of| Some((of, of.panel.as_ref()?)));
    let rows = panels.flat_map(|(summary, panel)| {
        let fender = &outcome.setup.fenders[summary.fender];
        panel.cones.iter().enumerate().map(move |(index, cone)| {
            let used = ConeUse::of(fender, summary, cone.peak_deflection_m);
            vec![
                fender.name.as_str().into(),
                panel.peak_tilt_rad.to_degrees().into(),
                panel.peak_tilt_at_s.into(),
                (panel.peak_moment_nm / 1e3).into(),
                panel.peak_moment_at_s.into(),
                (index as f64 + 1.0).into(),
                cone.at_m.into(),
                (cone.peak_deflection_m * 1e3).into(),
                percent(used.and_then(|of| of.share_of_rated_deflection)),
                used.map(|of| of.peak_reaction_n / 1e3).into(),
                percent(used.and_then(|of| of.share_of_rated_reaction)),
                used.map(|of| of.peak_energy_j / 1e3).into(),
                percent(used.and_then(|of| of.share_of_rated_energy)),
                (cone.peak_stretch_m * 1e3).into(),
            ]
        })
    });
    sheet_of(sheet, "Panels", &heads, rows, 1)
}

/// Writes one row for each chain of the touched fenders.
pub(super) fn chains(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let mut heads = vec![Head("Fender", "", 22.0), Head("Chain", "", 8.0)];
    heads.extend(heads_of(&CHAINS));
    let rows = outcome.fenders.iter().flat_map(|summary| {
        let fender = &outcome.setup.fenders[summary.fender];
        let chains = fender.chains.iter().zip(&summary.chains).enumerate();
        chains.map(move |(index, (setup, chain))| {
            let mut row = vec![fender.name.as_str().into(), (index as f64 + 1.0).into()];
            row.extend(cells_of(&CHAINS, setup, Some(chain)));
            row
        })
    });
    sheet_of(sheet, "Chains", &heads, rows, 1)
}
