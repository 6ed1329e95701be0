//! Runs a ship against a flexible dolphin: the peaks of the berthing, and the dolphin's period when the ship has gone.

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

use super::Values;

const SCENARIO: &str = include_str!(concat!(
    env!("FENDERLINE_DATA"),
    "/scenarios/closed_form/fender_and_dolphin_in_series.toml"
));

/// # Panics
/// Panics if the scenario cannot be read or stepped, or if the dolphin does not swing; either would be a bug.
pub(super) fn compute(values: &mut Values) {
    let file_name = "scenarios/closed_form/fender_and_dolphin_in_series.toml";
    let scenario =
        Scenario::parse(SCENARIO, file_name).unwrap_or_else(|e| panic!("the built-in {e}"));
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let (mut crossings_s, mut before_m): (Vec<f64>, f64) = (Vec::new(), 0.0);
    while !simulation.is_done() {
        let step = simulation.step().expect("a good step");
        let (now_m, from_s) = (step.dolphins[0].pile.deflection_m.y, step.t_s);
        let is_free = step.contacts.is_empty();
        if is_free && before_m < 0.0 && now_m >= 0.0 {
            let end_s = simulation.time_s();
            crossings_s.push(from_s + (end_s - from_s) * before_m / (before_m - now_m));
        }
        before_m = now_m;
    }
    let fender = simulation.fender_summaries().next().expect("it is touched");
    values.put("dolphin/reaction", 1e-3 * fender.peak_reaction_n, "kN");
    let dolphin = &simulation.dolphin_summaries()[0];
    values.put("dolphin/deflection", 1e3 * dolphin.peak_deflection_m, "mm");
    values.put("dolphin/energy", 1e-3 * dolphin.peak_energy_j, "kJ");
    let [first_s, .., last_s] = crossings_s[..] else { panic!("it swings") };
    values.put("dolphin/period", (last_s - first_s) / (crossings_s.len() - 1) as f64, "s");
}
