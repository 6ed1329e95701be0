//! The sheets of vessels and tugs.

use fenderline_results::{Outcome, Peak};
use fenderline_sim::constants::KNOT_MPS;
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::fenders::TONNE_N;
use super::table::{Cell, Head, sheet_of};

/// One row a vessel: her particulars, and her largest motions.
pub(super) fn vessels(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let heads = [
        Head("Vessel", "", 22.0),
        Head("Length bp", "m", 10.0),
        Head("Beam", "m", 10.0),
        Head("Draught", "m", 10.0),
        Head("Block coefficient", "–", 11.0),
        Head("Speed over ground", "kn", 11.0),
        Head("At", "s", 10.0),
        Head("Speed through water", "kn", 11.0),
        Head("At", "s", 10.0),
        Head("Rate of turn", "deg/min", 10.0),
        Head("At", "s", 10.0),
        Head("Rudder", "deg", 10.0),
        Head("At", "s", 10.0),
        Head("Roll", "deg", 10.0),
        Head("At", "s", 10.0),
        Head("Pitch", "deg", 10.0),
        Head("At", "s", 10.0),
        Head("Squat", "m", 10.0),
        Head("At", "s", 10.0),
        Head("Least clearance under the keel", "m", 13.0),
        Head("At", "s", 10.0),
        Head("Time aground", "s", 10.0),
    ];
    let setup = outcome.setup;
    let rows = setup.world.vessels.iter().zip(&outcome.world.vessels).map(|(vessel, totals)| {
        let ship = &vessel.ship.particulars;
        let mut row: Vec<Cell> = vec![
            setup.bodies[vessel.body].name.as_str().into(),
            ship.length_m.into(),
            ship.beam_m.into(),
            ship.draught_m.into(),
            ship.block_coefficient().into(),
        ];
        let degrees =
            |peak: Peak, times: f64| Peak { value: times * peak.value.to_degrees(), ..peak };
        let knots = |peak: Peak| Peak { value: peak.value / KNOT_MPS, ..peak };
        let peaks = [
            knots(totals.over_ground_mps),
            knots(totals.through_water_mps),
            degrees(totals.rate_of_turn_radps, 60.0),
            degrees(totals.rudder_rad, 1.0),
            degrees(totals.roll_rad, 1.0),
            degrees(totals.pitch_rad, 1.0),
            totals.squat_m,
        ];
        row.extend(peaks.into_iter().flat_map(|peak| [peak.value.into(), peak.at_s.into()]));
        row.push(totals.under_keel_m.map(|least| least.value).into());
        row.push(totals.under_keel_m.map(|least| least.at_s).into());
        row.push(totals.aground.s().into());
        row
    });
    sheet_of(sheet, "Vessels", &heads, rows, 1)
}

/// One row a tug that is a force at a ship's side.
pub(super) fn tugs(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let heads = [
        Head("Tug", "", 22.0),
        Head("Serves", "", 22.0),
        Head("Bollard pull", "kN", 11.0),
        Head("Bollard pull", "t", 11.0),
        Head("Peak force", "kN", 11.0),
        Head("Peak force", "t", 11.0),
        Head("At", "s", 10.0),
        Head("Time at work", "s", 10.0),
        Head("Time with limited force", "s", 13.0),
    ];
    let setup = outcome.setup;
    let rows = setup.world.tugs.iter().zip(&outcome.world.tugs).map(|(tug, totals)| {
        let bollard_n = tug.tug.envelope.bollard_pull_n;
        vec![
            tug.tug.name.as_str().into(),
            setup.bodies[setup.world.vessels[tug.vessel].body].name.as_str().into(),
            (bollard_n / 1e3).into(),
            (bollard_n / TONNE_N).into(),
            (totals.force_n.value / 1e3).into(),
            (totals.force_n.value / TONNE_N).into(),
            totals.force_n.at_s.into(),
            totals.at_work.s().into(),
            totals.limited.s().into(),
        ]
    });
    sheet_of(sheet, "Tugs", &heads, rows, 1)
}
