//! Times ships that take a step one after the other, each in a simulation of its own with its quay: what a docking
//! environment of the Python package does, without observations and rewards. The scenario is that of the docking
//! environment.

use std::hint::black_box;
use std::time::{Duration, Instant};

use fenderline_contact::vec2;
use fenderline_scenario::Scenario;
use fenderline_sim::environment::current::Current;
use fenderline_sim::environment::wind::{MeanWind, Wind, WindProfile};
use fenderline_sim::{Action, Order, Simulation, VesselAction};

use crate::rounds::{Contender, least, nanoseconds_a_call};
use fenderline_bench_scenes::table::Table;

const FILE: &str = "docking.toml";
const TEXT: &str = include_str!("../../crates/python/python/fenderline/scenarios/docking.toml");

/// Numbers of ships.
const COUNTS: [usize; 3] = [1, 64, 1024];
/// Steps of all ships together in a round, which takes some milliseconds.
const STEPS: usize = 4096;
/// Steps a second that one core is to reach with many ships; two cores then reach half a million.
const AIM: f64 = 250e3;
/// Number of steps after which a ship starts again, as at the end of an episode.
const EPISODE: u64 = 900;

/// Times a step for each number of ships.
pub(crate) fn bench(rounds: usize) -> Table {
    let mut table = Table::new(&["ships", "a step [µs]", "1,000 steps a second", "to reach", ""]);
    let mut contenders = COUNTS.map(|count| {
        let mut fleet = Fleet::new(count);
        Contender { round: Box::new(move || fleet.steps(STEPS / count)), calls: STEPS }
    });
    let times = nanoseconds_a_call(&mut contenders, rounds);
    for (count, taken_ns) in COUNTS.iter().zip(&times) {
        let rate = 1e9 / least(taken_ns);
        let is_many = *count > 1;
        table.row(vec![
            count.to_string(),
            format!("{:.2}", 1e-3 * least(taken_ns)),
            format!("{:.0}", 1e-3 * rate),
            if is_many { format!("≥ {:.0}", 1e-3 * AIM) } else { String::new() },
            if !is_many {
                ""
            } else if rate >= AIM {
                "✓"
            } else {
                "✗"
            }
            .to_owned(),
        ]);
    }
    table.note("Times are the least of the rounds on one core.");
    table.note("Ships are those of `fenderline.docking` with four orders a step, without observation and reward.");
    table.note("To reach: half a million steps a second on two cores.");
    table
}

/// Takes `steps` steps of a fleet of `count` ships, so that a profiler can count them.
pub(crate) fn steps(count: usize, steps: usize) {
    Fleet::new(count).steps(steps);
}

struct Fleet {
    simulations: Vec<Simulation>,
    /// Orders to rudder, engine and the two thrusters, each from −1 to 1.
    draws: Vec<[f64; 4]>,
    step: usize,
}

impl Fleet {
    fn new(count: usize) -> Fleet {
        let scenario = Scenario::parse(TEXT, FILE).expect("the scenario is good");
        let simulation = Simulation::new(scenario.setup).expect("the set-up is good");
        let start = simulation.setup().start();
        let mut seed = 1_u32;
        let mut number = |low: f64, high: f64| {
            // A linear congruential generator (Numerical Recipes, recalled); any would do.
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            low + (high - low) * f64::from(seed >> 8) / f64::from(1 << 24)
        };
        let draws = (0..61).map(|_| core::array::from_fn(|_| number(-1.0, 1.0))).collect();
        // Starts as the environment draws them.
        let mut ship = |_| {
            let mut start = start.clone();
            let along_m = number(-230.0, -130.0);
            let own = &mut start.bodies[0];
            own.position_m = vec2(along_m, -11.8 - number(30.0, 60.0));
            own.heading_rad = number(-0.15, 0.15);
            own.velocity.surge_mps = number(0.8, 1.8);
            let (speed_mps, from_rad) = (number(0.0, 9.0), number(0.0, core::f64::consts::TAU));
            let wind = MeanWind { speed_mps, from_rad, profile: WindProfile::Uniform };
            start.wind = Some(Wind::steady(wind).expect("a good wind"));
            let current_mps = vec2(number(-0.4, 0.4), 0.0);
            start.current = Some(Current::uniform(current_mps).expect("a good current"));
            let mut own = simulation.clone();
            own.restart(&start).expect("a restart in place");
            own
        };
        Fleet { simulations: (0..count).map(&mut ship).collect(), draws, step: 0 }
    }

    /// Steps of every ship.
    fn steps(&mut self, steps: usize) -> Duration {
        let begun = Instant::now();
        for _ in 0..steps {
            for (index, simulation) in self.simulations.iter_mut().enumerate() {
                if simulation.steps_taken() == EPISODE {
                    let start = simulation.setup().start();
                    simulation.restart(&start).expect("a restart in place");
                }
                let at_s = simulation.time_s();
                let [rudder, engine, bow, stern] =
                    self.draws[(self.step + index) % self.draws.len()];
                for action in [
                    VesselAction::Rudder(0.6 * rudder),
                    VesselAction::Engine(engine),
                    VesselAction::Thruster(0, bow),
                    VesselAction::Thruster(1, stern),
                ] {
                    let order = Order { at_s, action: Action::Vessel(0, action) };
                    simulation.order(order).expect("a good order");
                }
                black_box(simulation.step().expect("a good step"));
            }
            self.step += 1;
        }
        begun.elapsed()
    }
}
