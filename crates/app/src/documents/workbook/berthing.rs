//! The sheet of the berthing energy.

use fenderline_results::Outcome;
use fenderline_sim::berthing::{AddedSway, BerthingOutcome, ShallowFactor};
use rust_xlsxwriter::{Worksheet, XlsxError};

use super::table::{Cell, Head, sheet_of};

/// Writes the sheet that shows the berthing energy by formula beside the energy of the run.
pub(super) fn berthing(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let Some(Ok(of)) = outcome.berthing else { return Ok(()) };
    let heads = [
        Head("Quantity", "", 44.0),
        Head("Unit", "", 12.0),
        Head("Used", "", 14.0),
        Head("Run, first hit", "", 14.0),
        Head("PIANC 2002", "", 14.0),
        Head("Ueda", "", 14.0),
        Head("Vasco Costa", "", 14.0),
        Head("UFC 4-152-01", "", 14.0),
    ];
    const NONE: [Option<f64>; 4] = [None; 4];
    let row = |name: &str,
               unit: &'static str,
               used: Option<f64>,
               run: Option<f64>,
               all: [Option<f64>; 4]| {
        let cell = |value: Option<f64>| value.map_or(Cell::Empty, |value| Cell::Of(value, unit));
        let mut cells: Vec<Cell> = vec![name.into(), unit.into(), cell(used), cell(run)];
        cells.extend(all.map(cell));
        cells
    };
    let run = |name: &str, unit: &'static str, value: f64| row(name, unit, None, Some(value), NONE);
    let kilo = |value_j: f64| value_j / 1e3;
    let abnormal = of.abnormal_energy_j.map(|abnormal_j| abnormal_j / of.energy_j);
    let displacements = displacements(outcome, of);
    let mut rows: Vec<Vec<Cell>> =
        displacements.into_iter().map(|(name, mass_kg)| run(name, "t", mass_kg / 1e3)).collect();
    let speed = Some(of.formula_speed_mps());
    rows.extend([
        row("Speed V at right angles to the face", "m/s", speed, Some(of.speed_mps), NONE),
        run("Berthing angle, bow towards the berth positive", "deg", of.angle_rad.to_degrees()),
        run("Contact forward of the centre of gravity", "m", of.along_m),
        row(
            "Added mass Cm",
            "–",
            Some(of.chosen_added_mass),
            Some(of.added_mass_simulated),
            of.added_mass,
        ),
        row("Eccentricity Ce", "–", Some(of.eccentricity), Some(of.eccentricity_measured), NONE),
        row("Softness Cs", "–", Some(of.softness), Some(1.0), NONE),
        row("Configuration Cc", "–", Some(of.configuration), Some(1.0), NONE),
        row(
            "Energy into the fenders",
            "kJ (kN·m)",
            Some(kilo(of.energy_j)),
            Some(kilo(of.fender_energy_j)),
            of.energies_j.map(|energy_j| energy_j.map(kilo)),
        ),
        row(
            "Energy by formula with the speed at the first touch",
            "kJ (kN·m)",
            Some(kilo(of.energy_at_touch_j)),
            None,
            NONE,
        ),
    ]);
    if let Some(factor) = abnormal {
        let all = of.energies_j.map(|energy_j| energy_j.map(|energy_j| factor * kilo(energy_j)));
        rows.push(row("Abnormal berthing", "kJ (kN·m)", of.abnormal_energy_j.map(kilo), None, all));
    }
    if let Some(later) = of.later {
        let name = "Energy into the fenders, largest later hit";
        rows.push(run(name, "kJ (kN·m)", kilo(later.energy_j)));
        rows.push(run("Time of that", "s", later.at_s));
        rows.push(run("Number of that hit", "", f64::from(later.number)));
    }
    let AddedSway { deep, shallow } = of.added_sway;
    rows.push(run("Added mass in sway divided by displacement, in deep water", "–", deep));
    if let Some(ShallowFactor { factor, depth_over_draught }) = shallow {
        rows.push(run("Factor on the added mass in shallow water", "–", factor));
        rows.push(run("Water depth divided by the draught", "–", depth_over_draught));
    }
    rows.push(vec![of.mass_of_run().into()]);
    rows.push(vec![
        format!("It differs from the Cm of the formula: {}", of.why_masses_differ()).into(),
    ]);
    sheet_of(sheet, "Berthing", &heads, rows, 1)
}

/// The mass M of the energy formula in words and kg; for a contact of two ships also the two displacements, of which M
/// is the reduced mass.
fn displacements(outcome: &Outcome<'_>, of: &BerthingOutcome) -> Vec<(&'static str, f64)> {
    let Some(other) = of.other else {
        return vec![("Displacement M", of.displacement_kg)];
    };
    let ship = outcome.setup.berthing.as_ref().map(|study| &outcome.setup.bodies[study.ship]);
    let own = ship.and_then(|ship| ship.mass);
    let own = own.map(|mass| ("Displacement of the ship", mass.mass_kg));
    own.into_iter()
        .chain([
            ("Displacement of the other ship", other.displacement_kg),
            ("Reduced mass M of the two ships", of.displacement_kg),
        ])
        .collect()
}
