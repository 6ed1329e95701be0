//! Runs the scenarios of `scenarios/berth` that have no hydrodynamics, with the time steps of the scenarios. The script
//! `validation/independent/coupled_berth.py` computes the same values independently.

use std::collections::BTreeMap;

use fenderline_contact::number::greater;
use fenderline_scenario::Scenario;
use fenderline_sim::{Simulation, StepRecord};

use super::Values;

/// Name and text of a scenario.
macro_rules! berth {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!(env!("FENDERLINE_DATA"), "/scenarios/berth/", $name, ".toml")))),*]
    };
}

const SCENARIOS: [(&str, &str); 6] = berth![
    "bulb_and_stern_step_at_a_corner",
    "eight_cones_at_5_deg",
    "held_by_wind_six_hours",
    "leaning_on_eight_fenders",
    "tug_pushes_then_slides",
    "two_ships_on_pneumatic_fenders",
];

pub(super) fn compute(values: &mut Values) {
    for (name, text) in SCENARIOS {
        run(name, text, values);
    }
}

/// Runs a scenario.
///
/// # Panics
/// Panics if the scenario cannot be read or stepped, which would be a bug.
fn run(name: &str, text: &str, values: &mut Values) {
    let scenario = Scenario::parse(text, &format!("scenarios/berth/{name}.toml"))
        .unwrap_or_else(|e| panic!("the built-in {e}"));
    let bodies: Vec<(String, bool)> =
        scenario.setup.bodies.iter().map(|b| (b.name.clone(), b.mass.is_some())).collect();
    let fenders: Vec<String> = scenario.setup.fenders.iter().map(|f| f.name.clone()).collect();
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let mut peaks = BTreeMap::<String, (f64, f64)>::new();
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        for (contact, (force_n, depth_m)) in step_peaks(&record, &bodies, &fenders) {
            let peak = peaks.entry(contact).or_default();
            *peak = (greater(peak.0, force_n), greater(peak.1, depth_m));
        }
    }
    for (contact, (force_n, depth_m)) in peaks {
        values.put(format!("berth/{name}/peak force of {contact}"), 1e-3 * force_n, "kN");
        values.put(format!("berth/{name}/peak depth of {contact}"), depth_m, "m");
    }
    for ((body, floats), state) in bodies.iter().zip(simulation.states()) {
        if *floats {
            let speed_mps = state.velocity_mps.length();
            values.put(format!("berth/{name}/final speed of {body}"), speed_mps, "m/s");
        }
    }
}

/// For each fender or pair of bodies: the sum of the peak normal forces of its contact patches in a step (N), and the
/// largest depth of penetration (m).
fn step_peaks(
    record: &StepRecord<'_>,
    bodies: &[(String, bool)],
    fenders: &[String],
) -> BTreeMap<String, (f64, f64)> {
    let mut sums = BTreeMap::<String, (f64, f64)>::new();
    for contact in record.contacts {
        let name = match contact.fender {
            Some(fender) => fenders[fender.0 as usize].clone(),
            None => {
                let [one, two] = [contact.body_1, contact.body_2].map(|b| &bodies[b.0 as usize].0);
                format!("{one} - {two}")
            }
        };
        let sum = sums.entry(name).or_default();
        *sum = (sum.0 + contact.peak_normal_force_n, greater(sum.1, contact.peak_depth_m));
    }
    sums
}
