//! The sheets of fenders, of panels on several cones, and of chains.

use fenderline_results::{FenderVerdict, Outcome};
use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::{ChainKind, ConeUse, FenderSummary, Setup};
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::table::{Cell, Head, sheet_of};

/// Newtons of a tonne-force.
pub(super) const TONNE_N: f64 = 9806.65;

pub(super) fn fenders(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let heads = [
        Head("Fender", "", 22.0),
        Head("Type", "", 30.0),
        Head("On", "", 16.0),
        Head("Forward", "m", 10.0),
        Head("Starboard", "m", 10.0),
        Head("Touched", "", 9.0),
        Head("Verdict", "", 14.0),
        Head("Governed by", "", 11.0),
        Head("Deflection", "mm", 11.0),
        Head("of rated", "%", 9.0),
        Head("Reaction", "kN", 11.0),
        Head("of rated", "%", 9.0),
        Head("of catalogue", "%", 11.0),
        Head("Energy", "kJ (kN·m)", 12.0),
        Head("of rated", "%", 9.0),
        Head("of catalogue", "%", 11.0),
        Head("Hull pressure", "kN/m²", 11.0),
        Head("of permissible", "%", 12.0),
        Head("First touch", "s", 10.0),
        Head("Approach speed", "m/s", 10.0),
        Head("Approach speed", "kn", 10.0),
        Head("Angle", "deg", 9.0),
        Head("Factor on reaction", "–", 10.0),
        Head("Rated energy with factors", "kJ (kN·m)", 13.0),
        Head("Rated deflection", "mm", 11.0),
        Head("Rated reaction", "kN", 11.0),
        Head("Rated energy", "kJ (kN·m)", 12.0),
        Head("Middle of the face above datum or water", "m", 14.0),
        Head("Met at height on the hull", "m", 12.0),
        Head("Flare there", "deg", 9.0),
        Head("Peak vertical force on the hull", "kN", 13.0),
    ];
    let rows = (0..outcome.setup.fenders.len()).map(|index| fender(outcome, index));
    sheet_of(sheet, "Fenders", &heads, rows, 1)
}

fn fender(outcome: &Outcome<'_>, index: usize) -> Vec<Cell> {
    let Setup { fenders, bodies, .. } = outcome.setup;
    let fender = &fenders[index];
    let kind = fender.source.as_ref().map_or("", |source| source.designation.as_str());
    let summary = outcome.fenders.iter().find(|summary| summary.fender == index);
    let mut cells: Vec<Cell> = vec![
        fender.name.as_str().into(),
        kind.into(),
        bodies[fender.body].name.as_str().into(),
        fender.position_m.x.into(),
        fender.position_m.y.into(),
        Cell::Flag(summary.is_some()),
    ];
    let percent = |share: Option<f64>| Cell::from(share.map(|share| 100.0 * share));
    let kilo = |value: Option<f64>| Cell::from(value.map(|value| value / 1e3));
    let rated = fender.rated;
    let own = [
        rated.map(|rated| rated.deflection_m * 1e3).into(),
        kilo(rated.map(|rated| rated.reaction_n)),
        kilo(rated.map(|rated| rated.energy_j)),
        fender.above_water_m.into(),
    ];
    let Some(summary) = summary else {
        cells.extend((0..UNTOUCHED).map(|_| Cell::Empty));
        cells.extend(own);
        return cells;
    };
    let FenderSummary { capacity_j, hull, .. } = summary;
    cells.extend([
        FenderVerdict::of(fender, summary).text().into(),
        summary.governing().map_or(Cell::Empty, |(quantity, _)| quantity.into()),
        (summary.peak_deflection_m * 1e3).into(),
        percent(summary.share_of_rated_deflection),
        (summary.peak_reaction_n / 1e3).into(),
        percent(summary.share_of_rated_reaction),
        percent(summary.share_of_catalogue_reaction()),
        (summary.peak_energy_j / 1e3).into(),
        percent(summary.share_of_rated_energy),
        percent(summary.share_of_catalogue_energy(fender)),
        kilo(summary.peak_hull_pressure_npm2),
        percent(summary.share_of_hull_pressure),
        summary.first_touch_s.into(),
        summary.approach_speed_mps.into(),
        (summary.approach_speed_mps / KNOT_MPS).into(),
        summary.approach_angle_rad.to_degrees().into(),
        summary.factor.into(),
        kilo(*capacity_j),
    ]);
    cells.extend(own);
    cells.extend([
        hull.map(|hull| hull.height_m).into(),
        hull.map(|hull| hull.vertical_angle_rad.to_degrees()).into(),
        kilo(hull.map(|hull| hull.peak_vertical_force_n)),
    ]);
    cells
}

/// Columns of a fender that only a touched one has, up to its ratings.
const UNTOUCHED: usize = 18;

/// One row a cone of each touched fender with a panel on several.
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

/// One row a chain of each touched fender.
pub(super) fn chains(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let heads = [
        Head("Fender", "", 22.0),
        Head("Chain", "", 8.0),
        Head("Kind", "", 10.0),
        Head("Right of the middle", "m", 11.0),
        Head("Slack", "mm", 9.0),
        Head("Stiffness", "MN/m", 10.0),
        Head("Peak tension", "kN", 11.0),
        Head("Peak tension", "t", 11.0),
        Head("At", "s", 10.0),
        Head("Break load", "kN", 11.0),
        Head("Break load", "t", 11.0),
        Head("of break load", "%", 11.0),
        Head("Parted", "s", 10.0),
    ];
    let rows = outcome.fenders.iter().flat_map(|summary| {
        let fender = &outcome.setup.fenders[summary.fender];
        let chains = fender.chains.iter().zip(&summary.chains).enumerate();
        chains.map(move |(index, (chain, bore))| {
            let holds_along = chain.kind != ChainKind::Weight;
            vec![
                fender.name.as_str().into(),
                (index as f64 + 1.0).into(),
                chain.kind.word().into(),
                (chain.kind == ChainKind::Tension).then_some(chain.at_m).into(),
                holds_along.then_some(chain.slack_m * 1e3).into(),
                holds_along.then_some(chain.stiffness_npm / 1e6).into(),
                (bore.peak_tension_n / 1e3).into(),
                (bore.peak_tension_n / TONNE_N).into(),
                bore.peak_tension_at_s.into(),
                (chain.break_load_n / 1e3).into(),
                (chain.break_load_n / TONNE_N).into(),
                (100.0 * bore.share_of_break_load).into(),
                bore.parted_at_s.into(),
            ]
        })
    });
    sheet_of(sheet, "Chains", &heads, rows, 1)
}
