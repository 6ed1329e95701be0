//! Times the first step of many tugs on fenders, with all contacts new and every buffer empty, beside a warm step.

use std::time::{Duration, Instant};

use crate::rounds::{Contender, least, nanoseconds_a_call};
use crate::world::Engine;
use fenderline_bench_scenes::engine::Variant;
use fenderline_bench_scenes::play::{BURST, STEP_S, burst};
use fenderline_bench_scenes::scenes::{Plan, Scene};
use fenderline_bench_scenes::table::Table;

const COUNTS: [usize; 2] = [1_000, 10_000];

/// The first step may take at most this number of times as long as a warm step.
const MOST_RATIO: f64 = 3.0;

const ENGINES: [Engine; 3] =
    [Engine::Own(Variant::Coupled), Engine::Own(Variant::Paper), Engine::Rapier];

pub(crate) fn bench(rounds: usize) -> Table {
    let mut table = Table::new(&[
        "tugs on fenders",
        "engine",
        "first step [µs]",
        "warm step [µs]",
        "first/warm",
        "to reach",
        "",
    ]);
    for count in COUNTS {
        let plan = Scene::Pairs(count).plan();
        for engine in ENGINES {
            table.row(row(engine, &plan, count, rounds));
        }
    }
    table.note("least of the rounds. First step: with a new memory and an empty workspace; the time to make \
                the model does not count. Warm: as in `step`.");
    table
}

fn row(engine: Engine, plan: &Plan, count: usize, rounds: usize) -> Vec<String> {
    let mut world = engine.world(plan, STEP_S);
    let mut contenders = [
        Contender { round: Box::new(|| first(engine, plan)), calls: 1 },
        Contender { round: Box::new(move || burst(world.as_mut())), calls: BURST },
    ];
    let times = nanoseconds_a_call(&mut contenders, rounds);
    let [first_us, warm_us] = [0, 1].map(|index| 1e-3 * least(&times[index]));
    let ratio = first_us / warm_us;
    let reached = if ratio <= MOST_RATIO { "✓" } else { "✗" };
    let is_judged = engine != Engine::Rapier;
    vec![
        count.to_string(),
        engine.name().to_owned(),
        format!("{first_us:.0}"),
        format!("{warm_us:.0}"),
        format!("{ratio:.1}"),
        if is_judged { format!("≤ {MOST_RATIO}") } else { String::new() },
        if is_judged { reached } else { "" }.to_owned(),
    ]
}

fn first(engine: Engine, plan: &Plan) -> Duration {
    let mut world = engine.world(plan, STEP_S);
    let start = Instant::now();
    world.step();
    start.elapsed()
}
