//! Times a whole step of our engine, by both methods, against rapier2d-f64, and with the feature `peers` against Box2D
//! and Chipmunk.

use fenderline_bench_scenes::play::{BURST, Play, SETTLING, STEP_S, burst, on_clock};
use fenderline_bench_scenes::scenes::Scene;
use fenderline_bench_scenes::table::Table;
use fenderline_bench_scenes::world::World;

use crate::rounds::{Contender, median, median_ratio, nanoseconds_a_call};
use crate::world::Engine;

/// A scene of the bench and the times to reach in it.
struct Case {
    name: &'static str,
    scene: Scene,
    /// Whether the paper's method plays the scene. The paper's method does not play islands of many bodies, because it
    /// does not solve them together.
    paper: bool,
    /// Restarts a round.
    bursts: usize,
    /// The most microseconds that a step may take, and the largest share of rapier2d's time that it may take: meeting
    /// one of these limits is enough.
    most_us: Option<f64>,
    most_of_rapier: Option<f64>,
}

const CASES: [Case; 9] = [
    Case {
        name: "1 tug, 1 fender",
        scene: Scene::Tug,
        paper: true,
        bursts: 64,
        most_us: Some(0.2),
        most_of_rapier: None,
    },
    Case {
        name: "1 ship, 8 fenders",
        scene: Scene::Ship,
        paper: true,
        bursts: 16,
        most_us: Some(1.0),
        most_of_rapier: Some(0.1),
    },
    Case {
        name: "1 ship, 8 faces",
        scene: Scene::Faces,
        paper: true,
        bursts: 16,
        most_us: Some(1.0),
        most_of_rapier: Some(0.1),
    },
    Case {
        name: "1 ship, 100 fenders",
        scene: Scene::Blocks(100),
        paper: true,
        bursts: 4,
        most_us: None,
        most_of_rapier: None,
    },
    Case {
        name: "1 ship, 1,000 fenders",
        scene: Scene::Blocks(1_000),
        paper: true,
        bursts: 1,
        most_us: None,
        most_of_rapier: None,
    },
    Case {
        name: "1,000 tugs on fenders",
        scene: Scene::Pairs(1_000),
        paper: true,
        bursts: 1,
        most_us: None,
        most_of_rapier: Some(0.3),
    },
    Case {
        name: "10,000 tugs on fenders",
        scene: Scene::Pairs(10_000),
        paper: true,
        bursts: 1,
        most_us: None,
        most_of_rapier: Some(0.2),
    },
    Case {
        name: "chain of 100 tugs",
        scene: Scene::Chain(100),
        paper: false,
        bursts: 1,
        most_us: None,
        most_of_rapier: None,
    },
    Case {
        name: "raft of 10 × 10 barges",
        scene: Scene::Raft(10),
        paper: false,
        bursts: 1,
        most_us: None,
        most_of_rapier: None,
    },
];

/// Times all scenes, or only the scene `only`.
pub(crate) fn bench(rounds: usize, only: Option<Scene>) -> Table {
    let mut head = vec![
        "scene",
        "plays",
        "engine",
        "contacts",
        "a step [µs]",
        "a contact [ns]",
        "of rapier2d",
    ];
    head.extend(Engine::PEERS[1..].iter().map(|peer| of(*peer)));
    head.extend(["to reach", ""]);
    let mut table = Table::new(&head);
    for case in CASES.iter().filter(|case| only.is_none_or(|scene| scene == case.scene)) {
        for play in Play::ALL {
            for row in rows(case, play, rounds) {
                table.row(row);
            }
        }
    }
    table.note("Times are medians, and ratios of times are taken round by round.");
    table.note("A step is 0.1 s; its time includes moving the bodies and the broad phase.");
    table.note("anew: each engine begins anew every 17 steps from the same state, pressed by the same steady load.");
    table.note("The first of the 17 steps of `anew` is off the clock.");
    table.note("steady: each engine runs without restarts, and the clock starts 200 steps after the start.");
    table.note("contacts: the number of pairs in the last step's solve.");
    table.note("faces: our engine has the fenders as faces of one quay, the other engines have them as blocks.");
    table.note("brief: a step without a report of each contact; wrenches, motions and events are the same as with the report.");
    table.note(
        "A ratio above 1 says that the peer is faster. Solvers of peers stop after a fixed number of sweeps.",
    );
    table
}

/// Head of the column that holds the ratios to a peer's time.
fn of(peer: Engine) -> &'static str {
    match peer {
        #[cfg(feature = "peers")]
        Engine::Box2d => "of Box2D",
        #[cfg(feature = "peers")]
        Engine::Chipmunk => "of Chipmunk",
        _ => "of rapier2d",
    }
}

fn rows(case: &Case, play: Play, rounds: usize) -> Vec<Vec<String>> {
    let plan = case.scene.plan();
    let own = Engine::OURS.iter().filter(|engine| case.paper || !engine.is_paper());
    let engines: Vec<Engine> = own.chain(Engine::PEERS).copied().collect();
    let mut worlds: Vec<_> = engines.iter().map(|engine| engine.world(&plan, STEP_S)).collect();
    let contacts: Vec<usize> = worlds
        .iter_mut()
        .map(|world| {
            burst(world.as_mut());
            if play == Play::Steady {
                (BURST..SETTLING).for_each(|_| world.step());
            }
            world.touching()
        })
        .collect();
    let calls = case.bursts * BURST;
    let contender = |mut world: Box<dyn World>| {
        let round = move || match play {
            Play::Anew => (0..case.bursts).map(|_| burst(world.as_mut())).sum(),
            Play::Steady => on_clock(world.as_mut(), calls),
        };
        Contender { round: Box::new(round), calls }
    };
    let mut contenders: Vec<Contender<'_>> = worlds.into_iter().map(contender).collect();
    let times = nanoseconds_a_call(&mut contenders, rounds);
    let of_peers =
        || engines.iter().zip(&times).filter(|(engine, _)| Engine::PEERS.contains(engine));
    let row = |((&engine, taken_ns), contacts): ((&Engine, &Vec<f64>), usize)| {
        let step_ns = median(taken_ns);
        let ratios: Vec<f64> =
            of_peers().map(|(_, peer_ns)| median_ratio(taken_ns, peer_ns)).collect();
        let judged = !Engine::PEERS.contains(&engine) && play == Play::Anew;
        let (aim, reached) =
            if judged { case.judged(step_ns, ratios[0]) } else { (String::new(), "") };
        let mut row = vec![
            case.name.to_owned(),
            play.name().to_owned(),
            engine.name().to_owned(),
            contacts.to_string(),
            format!("{:.3}", step_ns / 1e3),
            format!("{:.0}", step_ns / contacts as f64),
        ];
        row.extend(ratios.iter().map(|ratio| format!("{ratio:.3}")));
        row.extend([aim, reached.to_owned()]);
        row
    };
    engines.iter().zip(&times).zip(contacts).map(row).collect()
}

impl Case {
    fn judged(&self, step_ns: f64, ratio: f64) -> (String, &'static str) {
        let aims = [
            self.most_us.map(|most| (format!("≤ {most} µs"), step_ns <= most * 1e3)),
            self.most_of_rapier.map(|most| (format!("≤ {most}"), ratio <= most)),
        ];
        let aims: Vec<(String, bool)> = aims.into_iter().flatten().collect();
        if aims.is_empty() {
            return (String::new(), "");
        }
        let reached = aims.iter().any(|&(_, reached)| reached);
        let text = aims.into_iter().map(|(text, _)| text).collect::<Vec<_>>().join(" or ");
        (text, if reached { "✓" } else { "✗" })
    }
}
