//! A whole step of the engine, by both methods, against rapier2d-f64.

use std::time::{Duration, Instant};

use crate::rounds::{Contender, median, median_ratio, nanoseconds_a_call};
use crate::scenes::Scene;
use crate::table::Table;
use crate::world::{Engine, World};

pub(crate) const STEP_S: f64 = 0.1;

/// Steps on the clock after each restart: the bodies come on and are pressed in, and every contact
/// lives through all of them.
pub(crate) const BURST: usize = 16;

/// A scene and what to reach in it.
struct Case {
    name: &'static str,
    scene: Scene,
    /// Restarts a round.
    bursts: usize,
    /// Most microseconds a step, most of rapier2d's time: either will do.
    most_us: Option<f64>,
    most_of_rapier: Option<f64>,
}

const CASES: [Case; 5] = [
    Case {
        name: "1 tug, 1 fender",
        scene: Scene::Tug,
        bursts: 64,
        most_us: Some(0.2),
        most_of_rapier: None,
    },
    Case {
        name: "1 ship, 8 fenders",
        scene: Scene::Ship,
        bursts: 16,
        most_us: Some(1.0),
        most_of_rapier: Some(0.1),
    },
    Case {
        name: "1 ship, 8 faces",
        scene: Scene::Faces,
        bursts: 16,
        most_us: Some(1.0),
        most_of_rapier: Some(0.1),
    },
    Case {
        name: "1,000 tugs on fenders",
        scene: Scene::Pairs(1_000),
        bursts: 1,
        most_us: None,
        most_of_rapier: Some(0.3),
    },
    Case {
        name: "10,000 tugs on fenders",
        scene: Scene::Pairs(10_000),
        bursts: 1,
        most_us: None,
        most_of_rapier: Some(0.2),
    },
];

pub(crate) fn bench(rounds: usize) -> Table {
    let mut table = Table::new(&[
        "scene",
        "engine",
        "contacts",
        "a step [µs]",
        "a contact [ns]",
        "of rapier2d",
        "to reach",
        "",
    ]);
    for case in &CASES {
        for row in rows(case, rounds) {
            table.row(row);
        }
    }
    table.note("medians; ratios are taken round by round. Δt 0.1 s; moving the bodies and the broad phase included.");
    table.note("Each engine starts anew every 17 steps from the same state, pressed by the same steady load; the first of");
    table.note("the 17 is off the clock. contacts: pairs in the last step's solve. faces: of one quay; to rapier2d, blocks.");
    table.note(
        "brief: without a report of each contact; wrenches, motions and events are the same.",
    );
    table
}

fn rows(case: &Case, rounds: usize) -> Vec<Vec<String>> {
    let plan = case.scene.plan();
    let mut worlds = Engine::TIMED.map(|engine| engine.world(&plan, STEP_S));
    let contacts = worlds.each_mut().map(|world| {
        burst(world.as_mut());
        world.touching()
    });
    let calls = case.bursts * BURST;
    let mut contenders = worlds.map(|mut world| {
        let round = move || (0..case.bursts).map(|_| burst(world.as_mut())).sum();
        Contender { round: Box::new(round), calls }
    });
    let times = nanoseconds_a_call(&mut contenders, rounds);
    let by_engine = Engine::TIMED.iter().zip(&times);
    let rapier = by_engine.clone().find(|(engine, _)| **engine == Engine::Rapier);
    let (_, rapier) = rapier.expect("rapier2d is timed");
    by_engine
        .zip(contacts)
        .map(|((&engine, taken_ns), contacts)| {
            let (step_ns, ratio) = (median(taken_ns), median_ratio(taken_ns, rapier));
            let (aim, reached) = match engine {
                Engine::Rapier => (String::new(), ""),
                _ => case.judged(step_ns, ratio),
            };
            vec![
                case.name.to_owned(),
                engine.name().to_owned(),
                contacts.to_string(),
                format!("{:.3}", step_ns / 1e3),
                format!("{:.0}", step_ns / contacts as f64),
                format!("{ratio:.3}"),
                aim,
                reached.to_owned(),
            ]
        })
        .collect()
}

impl Case {
    fn judged(&self, step_ns: f64, ratio: f64) -> (String, &'static str) {
        let aims = [
            self.most_us.map(|most| (format!("≤ {most} µs"), step_ns <= most * 1e3)),
            self.most_of_rapier.map(|most| (format!("≤ {most}"), ratio <= most)),
        ];
        let aims: Vec<(String, bool)> = aims.into_iter().flatten().collect();
        let reached = aims.iter().any(|&(_, reached)| reached);
        let text = aims.into_iter().map(|(text, _)| text).collect::<Vec<_>>().join(" or ");
        (text, if reached { "✓" } else { "✗" })
    }
}

/// One restart, off the clock, and the steps on it.
pub(crate) fn burst(world: &mut dyn World) -> Duration {
    world.restart();
    let start = Instant::now();
    for _ in 0..BURST {
        world.step();
    }
    start.elapsed()
}

/// So many warm steps of our engine, restarts and their copying included, to be counted.
pub(crate) fn steps(scene: Scene, engine: Engine, count: usize) {
    let mut world = engine.world(&scene.plan(), STEP_S);
    for step in 0..count {
        if step % BURST == 0 {
            world.restart();
        }
        world.step();
    }
}
