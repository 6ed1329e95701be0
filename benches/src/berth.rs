//! How much faster than real time one core runs the whole berthing of `scenarios/berth/alongside_with_two_tugs.toml`:
//! ship, tugs, gusts, current, eight fenders, six lines and the pilots, without result files.

use std::hint::black_box;

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

use crate::rounds::{Contender, median, nanoseconds_a_call};
use fenderline_bench_scenes::table::Table;

const FILE: &str = "alongside_with_two_tugs.toml";
const TEXT: &str = include_str!("../../scenarios/berth/alongside_with_two_tugs.toml");
/// Largest number of rounds of this bench, because one run of the berthing takes half a second.
const MOST_ROUNDS: usize = 9;

/// Times the whole run.
pub(crate) fn bench(rounds: usize) -> Table {
    let scenario = Scenario::parse(TEXT, FILE).expect("the scenario is good");
    let simulation = Simulation::new(scenario.setup).expect("the set-up is good");
    let steps = simulation.steps_total();
    let simulated_s = steps as f64 * simulation.setup().step_s;
    let mut contenders = [Contender::clocked(|| play(simulation.clone()), 1)];
    let times = nanoseconds_a_call(&mut contenders, rounds.min(MOST_ROUNDS));
    let wall_s = 1e-9 * median(&times[0]);
    let mut table = Table::new(&["scenario", "simulated [s]", "one core [s]", "times real time"]);
    table.row(vec![
        FILE.to_owned(),
        format!("{simulated_s:.0}"),
        format!("{wall_s:.3}"),
        format!("{:.0}", simulated_s / wall_s),
    ]);
    table.note(&format!(
        "The time is the median of the rounds: {steps} steps on one core, without result files."
    ));
    table
}

/// Runs the first `count` steps of the berthing, so that a profiler can count their instructions.
pub(crate) fn steps(count: usize) {
    let scenario = Scenario::parse(TEXT, FILE).expect("the scenario is good");
    let mut simulation = Simulation::new(scenario.setup).expect("the set-up is good");
    for _ in 0..count {
        black_box(simulation.step().expect("a good step"));
    }
}

fn play(mut simulation: Simulation) {
    while !simulation.is_done() {
        black_box(simulation.step().expect("a good step"));
    }
}
