//! The sheets of vessels and tugs.

use fenderline_results::{Outcome, TUGS, VESSELS};
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::table::{Cell, Head, cells_of, heads_of, sheet_of};

/// Writes one row for each vessel: her particulars, and her largest motions.
pub(super) fn vessels(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let mut heads = vec![
        Head("Vessel", "", 22.0),
        Head("Length bp", "m", 10.0),
        Head("Beam", "m", 10.0),
        Head("Draught", "m", 10.0),
        Head("Block coefficient", "–", 11.0),
    ];
    heads.extend(heads_of(&VESSELS));
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
        row.extend(cells_of(&VESSELS, vessel, Some(totals)));
        row
    });
    sheet_of(sheet, "Vessels", &heads, rows, 1)
}

/// Writes one row for each tug that is simulated as a force at a ship's side.
pub(super) fn tugs(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let mut heads = vec![Head("Tug", "", 22.0), Head("Serves", "", 22.0)];
    heads.extend(heads_of(&TUGS));
    let setup = outcome.setup;
    let rows = setup.world.tugs.iter().zip(&outcome.world.tugs).map(|(tug, totals)| {
        let mut row: Vec<Cell> = vec![
            tug.tug.name.as_str().into(),
            setup.bodies[setup.world.vessels[tug.vessel].body].name.as_str().into(),
        ];
        row.extend(cells_of(&TUGS, tug, Some(totals)));
        row
    });
    sheet_of(sheet, "Tugs", &heads, rows, 1)
}
