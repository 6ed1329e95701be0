//! Times one ship along many fenders as the number of fenders grows: a step of the engine, and a step of the whole
//! simulator with its ledger and summaries.

use std::hint::black_box;
use std::time::{Duration, Instant};

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

use crate::rounds::{Contender, least, nanoseconds_a_call};
use crate::world::Engine;
use fenderline_bench_scenes::engine::Variant;
use fenderline_bench_scenes::play::{BURST, STEP_S, burst};
use fenderline_bench_scenes::scenes::Scene;
use fenderline_bench_scenes::table::Table;

/// Numbers of fenders.
const COUNTS: [usize; 3] = [100, 300, 1000];

/// With the largest number of fenders a step is to take at most this time (µs), and the time is to grow at most with
/// this power of the number of fenders.
const MOST_US: f64 = 800.0;
const MOST_POWER: f64 = 1.15;

/// What a row times.
#[derive(Clone, Copy)]
enum What {
    Engine(Engine, fn(usize) -> Scene),
    Simulator,
}

const ROWS: [(&str, What); 4] = [
    ("engine, fenders on one quay", What::Engine(Engine::Own(Variant::Coupled), Scene::Fenders)),
    ("engine, each fender is a body", What::Engine(Engine::Own(Variant::Coupled), Scene::Blocks)),
    ("simulator, fenders on one quay", What::Simulator),
    ("rapier2d, each fender is a body", What::Engine(Engine::Rapier, Scene::Fenders)),
];

pub(crate) fn bench(rounds: usize) -> Table {
    let mut table = Table::new(&[
        "a step of",
        "100 [µs]",
        "300 [µs]",
        "1,000 [µs]",
        "of rapier2d",
        "growth",
        "",
    ]);
    let mut times: Vec<Vec<Vec<f64>>> = Vec::new();
    for count in COUNTS {
        let mut contenders = ROWS.map(|(_, what)| what.contender(count));
        times.push(nanoseconds_a_call(&mut contenders, rounds));
    }
    for (row, (name, what)) in ROWS.iter().enumerate() {
        let us: Vec<f64> = times.iter().map(|of_count| 1e-3 * least(&of_count[row])).collect();
        let (first, most) = (us[0], us[us.len() - 1]);
        let power = libm::log(most / first) / libm::log(COUNTS[2] as f64 / COUNTS[0] as f64);
        let ratio = most / (1e-3 * least(&times[2][ROWS.len() - 1]));
        let reached = match what {
            What::Engine(Engine::Rapier, _) => "",
            _ if most <= MOST_US && power <= MOST_POWER => "✓",
            _ => "✗",
        };
        let mut cells = vec![(*name).to_owned()];
        cells.extend(us.iter().map(|us| format!("{us:.1}")));
        cells.extend([format!("{ratio:.3}"), format!("n^{power:.2}"), reached.to_owned()]);
        table.row(cells);
    }
    table.note(&format!("To reach: ≤ {MOST_US} µs at 1,000 fenders and growth ≤ n^{MOST_POWER}; times are the least of the rounds."));
    table.note("A ship of 298 m is pressed on fenders side by side; the engine and rapier2d begin anew every 17 steps, as in `step`.");
    table.note("growth: the power of the number of fenders with which the time grows from 100 to 1,000 fenders.");
    table
}

impl What {
    fn contender(self, count: usize) -> Contender<'static> {
        match self {
            What::Engine(engine, scene) => {
                let mut world = engine.world(&scene(count).plan(), STEP_S);
                Contender { round: Box::new(move || burst(world.as_mut())), calls: BURST }
            }
            What::Simulator => {
                let mut simulation = ship_alongside(count);
                Contender { round: Box::new(move || steps(&mut simulation)), calls: BURST }
            }
        }
    }
}

/// Runs `steps` steps of a settled ship along `count` fenders, so that a profiler can count them.
pub(crate) fn run(count: usize, steps: usize) {
    let mut simulation = ship_alongside(count);
    for _ in 0..steps {
        black_box(simulation.step().expect("a good step"));
    }
}

/// Takes some steps of a simulation that never ends, and says how long they took.
fn steps(simulation: &mut Simulation) -> Duration {
    let start = Instant::now();
    for _ in 0..BURST {
        black_box(simulation.step().expect("a good step"));
    }
    start.elapsed()
}

/// A ship like that of `Scene::Fenders`, pressed on `count` fenders of a quay and settled there.
fn ship_alongside(count: usize) -> Simulation {
    let apart_m = 240.0 / count as f64;
    let (first_m, width_m) = (-145.0 + 0.5 * apart_m, 0.8 * apart_m);
    let mut text = format!(
        "[time]\nstep = {STEP_S}\nduration = 1e5\n\
         [material.rubber]\nstiffness = 500e3\nshear_stiffness = 3e6\nfriction_static = 0.5\nrestitution = 0.1\n\
         [body.ship]\noutline = [[-149, -23], [104, -23], [149, -3], [149, 3], [104, 23], [-149, 23]]\n\
         mass = 87.8e6\ngyradius = 74.5\n\
         [body.quay]\nfixed = true\nposition = [0, 24]\noutline = [[-200, 0], [200, 0], [200, 20], [-200, 20]]\n\
         [[load]]\nbody = \"ship\"\nforce = [0, 16e6]\n[[pair]]\nbodies = [\"ship\", \"quay\"]\nmaterial = \"rubber\"\n"
    );
    for k in 0..count {
        let x_m = first_m + apart_m * k as f64;
        text += &format!(
            "[fender.f{k}]\non = \"quay\"\nposition = [{x_m}, 0]\nfacing = \"-90 deg\"\nwidth = {width_m}\n\
             projection = 1\nmaterial = \"rubber\"\n"
        );
    }
    let scenario = Scenario::parse(&text, "fenders.toml").unwrap_or_else(|error| panic!("{error}"));
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    for _ in 0..200 {
        simulation.step().expect("a good step");
    }
    simulation
}
