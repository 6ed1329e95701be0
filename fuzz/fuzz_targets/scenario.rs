//! Fuzzes the scenario reader with any text: no panic and no hang, and an accepted scenario can be built and stepped.
#![no_main]

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let scenario = match Scenario::parse(text, "fuzz.toml") {
        Ok(scenario) => scenario,
        Err(error) => {
            assert!(!error.to_string().is_empty());
            return;
        }
    };
    let Ok(mut simulation) = Simulation::new(scenario.setup) else { return };
    for _ in 0..3 {
        if simulation.is_done() || simulation.step().is_err() {
            return;
        }
    }
});
