//! Times many runs of one scenario, each with other numbers, on one core: the impact of a tug, 200 steps, by both
//! contact methods. A run is set up in one of two ways: its scenario is read and assembled anew, or one simulation is
//! started again.

use std::hint::black_box;

use fenderline_scenario::{Override, Scenario};
use fenderline_sim::Simulation;

use crate::rounds::{Contender, least, nanoseconds_a_call};
use fenderline_bench_scenes::table::Table;

const FILE: &str = "experiment_2_4kn.toml";
const TEXT: &str = include_str!("../../scenarios/paper/experiment_2_4kn.toml");

/// Runs in a round: so few that some rounds are not disturbed by other programs of the machine.
const RUNS: usize = 20;

/// Steps a second that each contact method is to reach.
const METHODS: [(&str, f64); 2] = [("paper", 3e6), ("coupled", 2e6)];

/// How the runs are set up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SetUp {
    /// The scenario is read and assembled anew with the numbers of the run.
    Anew,
    /// One simulation is started again with the numbers of the run.
    Restart,
    /// One simulation is started again as in `Restart`, but takes no step.
    RestartAlone,
}

/// The runs by one contact method.
struct Study {
    method: Vec<Override>,
    scenario: Scenario,
    simulation: Simulation,
}

impl Study {
    fn new(method: &str) -> Result<Study, String> {
        let integrator = if method == "paper" { "euler" } else { "semi_implicit" };
        let set = [format!("contact.method={method}"), format!("time.integrator={integrator}")];
        let set = set.iter().map(|text| Override::parse(text)).collect::<Result<Vec<_>, _>>();
        let method = set.map_err(|error| error.to_string())?;
        let scenario = Scenario::parse_with(TEXT, FILE, &method).map_err(|e| e.to_string())?;
        let simulation = Simulation::new(scenario.setup.clone()).map_err(|e| e.to_string())?;
        Ok(Study { method, scenario, simulation })
    }

    /// Makes `count` runs, with speeds of the tug that rise from 0.2 to 2.1 m/s.
    fn run(&mut self, count: usize, set_up: SetUp) {
        let mut start = self.scenario.setup.start();
        for run in 0..count {
            let surge = 0.2 + 1.9 * (run as f64 / count as f64);
            let value = format!("{surge:?}");
            let own = Override::new("surge", "body.tug.velocity.surge", &value).expect("a key");
            if set_up == SetUp::Anew {
                let all = [self.method.as_slice(), &[own]].concat();
                let scenario = Scenario::parse_with(TEXT, FILE, &all).expect("a good scenario");
                self.simulation = Simulation::new(scenario.setup).expect("a good set-up");
            } else {
                assert!(self.scenario.start_with(&[own], &mut start), "the start alone differs");
                self.simulation.restart(&start).expect("a restart in place");
            }
            while set_up != SetUp::RestartAlone && !self.simulation.is_done() {
                // As `run_many` of the Python package does, which takes no record.
                assert!(self.simulation.step().is_ok(), "a good step");
            }
            black_box(self.simulation.states());
        }
    }
}

/// Times the runs by both contact methods.
pub(crate) fn bench(rounds: usize) -> Table {
    let mut table = Table::new(&[
        "method",
        "set up",
        "a run [µs]",
        "set-up",
        "million steps a second",
        "to reach",
        "",
    ]);
    for (method, aim) in METHODS {
        let study = || Study::new(method).expect("the scenario is good");
        let steps = study().simulation.steps_total() as f64;
        let ways = [SetUp::Anew, SetUp::Restart, SetUp::RestartAlone];
        let mut contenders = ways.map(|set_up| {
            let mut study = study();
            Contender::clocked(move || study.run(RUNS, set_up), RUNS)
        });
        let times = nanoseconds_a_call(&mut contenders, rounds);
        let [anew_ns, restart_ns, alone_ns] = [0, 1, 2].map(|way| least(&times[way]));
        let steps_ns = restart_ns - alone_ns;
        for (name, run_ns, aim) in [("anew", anew_ns, None), ("restart", restart_ns, Some(aim))] {
            let rate = steps * 1e9 / run_ns;
            table.row(vec![
                method.to_owned(),
                name.to_owned(),
                format!("{:.1}", 1e-3 * run_ns),
                format!("{:.1} %", 100.0 * (1.0 - steps_ns / run_ns)),
                format!("{:.2}", 1e-6 * rate),
                aim.map_or(String::new(), |aim| format!("≥ {}", 1e-6 * aim)),
                aim.map_or("", |aim| if rate >= aim { "✓" } else { "✗" }).to_owned(),
            ]);
        }
    }
    table.note("Times are the least of the rounds on one core: the impact of a tug, 200 steps, speeds from 0.2 to 2.1 m/s.");
    table.note("anew: the scenario is read for each run.");
    table.note("restart: one simulation is started again with the run's numbers, as `run_many` of the Python package does.");
    table
}

/// Makes `count` runs, so that a profiler can count their instructions.
pub(crate) fn runs(method: &str, set_up: &str, count: usize) -> Result<(), String> {
    let set_up = match set_up {
        "anew" => SetUp::Anew,
        "restart" => SetUp::Restart,
        _ => return Err(format!("`{set_up}` is no way to set up a run: `anew` or `restart` is")),
    };
    Study::new(method)?.run(count, set_up);
    Ok(())
}
