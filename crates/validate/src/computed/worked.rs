//! Runs published worked examples of berthing, each a scenario of `scenarios/worked`, and gives what its fenders take
//! in the run, what the `[berthing]` study of the run gives, and what the formulas alone give.

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;
use fenderline_sim::berthing::{ContactPoint, gyradius_m, ueda_added_mass};

use super::Values;

/// Name and text of a scenario.
macro_rules! worked {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!(env!("FENDERLINE_DATA"), "/scenarios/worked/", $name, ".toml")))),*]
    };
}

const SCENARIOS: [(&str, &str); 6] = worked![
    "bulk_carrier_third_point",
    "case_study_39000_t",
    "container_ship_vizhinjam",
    "fleet_ship_broadside",
    "fleet_ship_quarter_point",
    "textbook_four_fenders",
];

pub(super) fn compute(values: &mut Values) {
    for (name, text) in SCENARIOS {
        run(name, text, values);
    }
    formulas(values);
}

/// Runs a scenario and gives peak energy, deflection and reaction of each fender, and the share of the ship's energy
/// that the fenders took.
///
/// # Panics
/// Panics if the scenario cannot be read or stepped, which would be a bug.
fn run(name: &str, text: &str, values: &mut Values) {
    let scenario = Scenario::parse(text, &format!("scenarios/worked/{name}.toml"))
        .unwrap_or_else(|e| panic!("the built-in {e}"));
    let names: Vec<String> = scenario.setup.fenders.iter().map(|f| f.name.clone()).collect();
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    for summary in simulation.fender_summaries() {
        let fender = &names[summary.fender];
        let of = |what: &str| format!("worked/{name}/{what} of {fender}");
        values.put(of("energy"), 1e-3 * summary.peak_energy_j, "kN·m");
        values.put(of("deflection"), 1e3 * summary.peak_deflection_m, "mm");
        values.put(of("reaction"), 1e-3 * summary.peak_reaction_n, "kN");
    }
    if let Some(outcome) = simulation.berthing() {
        let outcome = outcome.expect("particulars within their ranges");
        values.put(format!("worked/{name}/share"), outcome.eccentricity_measured, "");
        values.put(format!("worked/{name}/Cm"), outcome.chosen_added_mass, "");
        values.put(format!("worked/{name}/study"), 1e-3 * outcome.energy_j, "kN·m");
    }
}

/// Computes the berthing formulas without a simulation, with the particulars of the published examples.
///
/// # Panics
/// Panics if particulars are out of range, which would be a bug.
fn formulas(values: &mut Values) {
    let ce = |along_m: f64, beam_m: f64, block: f64, length_m: f64, angle_deg: f64| {
        let gyradius_m = gyradius_m(block, length_m).expect("particulars within their ranges");
        ContactPoint { along_m, beam_m }
            .eccentricity(gyradius_m, angle_deg.to_radians())
            .expect("the point of contact is within its range")
    };
    // ½ M V² Cm Ce Cs, in kN·m.
    let energy =
        |mass_t: f64, speed_mps: f64, factors: f64| 0.5 * mass_t * speed_mps * speed_mps * factors;

    values.put("worked/bulk_carrier_third_point/Ce", ce(236.0 / 6.0, 43.0, 0.796, 236.0, 5.0), "");

    let block = 39_000.0 / (1.025 * 170.0 * 26.4 * 10.9);
    let cm = ueda_added_mass(10.9, 26.4, block).expect("particulars within their ranges");
    let case_study = energy(39_000.0, 0.1, cm * ce(42.5, 26.4, block, 170.0, 5.0));
    values.put("worked/case_study_39000_t/formula", case_study, "kN·m");

    // Vasco Costa's Cm; the point of R = 74.52 m, and that of the quarter point.
    let block = 208_000.0 / (1.025 * 376.0 * 57.0 * 15.5);
    let cm = 1.0 + 2.0 * 15.5 / 57.0;
    let at = |along_m: f64| energy(208_000.0, 0.1, cm * ce(along_m, 57.0, block, 376.0, 6.0) * 0.9);
    let along_m = libm::sqrt(74.52 * 74.52 - 28.5 * 28.5);
    values.put("worked/container_ship_vizhinjam/formula", at(along_m), "kN·m");
    values.put("worked/container_ship_vizhinjam/formula at the quarter point", at(94.0), "kN·m");
}
