//! Times two outlines that are not convex, of 100, 300 and 1,000 corners: a step of our engine, a step of rapier2d with
//! the same convex pieces, and i_overlay's area of the overlap alone.

use fenderline_contact::Vec2;

use crate::peers::Overlay;
use crate::rounds::{Contender, least, nanoseconds_a_call};
use crate::world::Engine;
use fenderline_bench_scenes::engine::Variant;
use fenderline_bench_scenes::play::{BURST, STEP_S, burst};
use fenderline_bench_scenes::scenes::{Plan, Scene};
use fenderline_bench_scenes::table::Table;

/// Corners of each outline.
const SIZES: [usize; 3] = [100, 300, 1000];

/// A step of the largest outlines is to take at most this time (µs).
const MOST_US: f64 = 300.0;

/// Name of a pair of outlines, and the scene of outlines of a given number of corners.
type Kind = (&'static str, fn(usize) -> Scene);

const KINDS: [Kind; 3] = [
    ("a star slides along a star", Scene::Stars),
    ("a star slides along a comb", Scene::StarOnComb),
    ("a comb on a comb, tooth on tooth", Scene::Combs),
];

const ENGINES: [Engine; 2] = [Engine::Own(Variant::Coupled), Engine::Rapier];

pub(crate) fn bench(rounds: usize) -> Table {
    let mut table = Table::new(&[
        "outlines",
        "corners of each",
        "contacts",
        "a step [µs]",
        "rapier2d [µs]",
        "of rapier2d",
        "i_overlay [µs]",
        "to reach",
        "",
    ]);
    for (name, scene) in KINDS {
        for corners in SIZES {
            table.row(row(name, &scene(corners).plan(), corners, rounds));
        }
    }
    table.note("Times are the least of the rounds; the engine and rapier2d begin anew every 17 steps, as in `step`.");
    table.note("rapier2d has the convex pieces that our engine cuts the outlines into.");
    table.note("i_overlay finds the overlap of the two outlines at their start, without contacts or motion.");
    table.note("contacts: the number of connected overlaps.");
    table
}

fn row(name: &str, plan: &Plan, corners: usize, rounds: usize) -> Vec<String> {
    let mut worlds = ENGINES.map(|engine| engine.world(plan, STEP_S));
    burst(worlds[0].as_mut());
    let contacts = worlds[0].touching();
    let [own, rapier] = worlds.map(|mut world| Contender {
        round: Box::new(move || burst(world.as_mut())),
        calls: BURST,
    });
    let outlines = [0, 1].map(|part| plan.parts[part].outline_m.as_slice());
    let times = nanoseconds_a_call(&mut [own, rapier, overlay(outlines, plan)], rounds);
    let [own_us, rapier_us, overlay_us] = [0, 1, 2].map(|index| 1e-3 * least(&times[index]));
    let largest = corners == SIZES[SIZES.len() - 1];
    vec![
        name.to_owned(),
        corners.to_string(),
        contacts.to_string(),
        format!("{own_us:.1}"),
        format!("{rapier_us:.1}"),
        format!("{:.2}", own_us / rapier_us),
        format!("{overlay_us:.1}"),
        if largest { format!("≤ {MOST_US} µs") } else { String::new() },
        match largest {
            true if own_us <= MOST_US => "✓",
            true => "✗",
            false => "",
        }
        .to_owned(),
    ]
}

fn overlay<'a>([first, second]: [&'a [Vec2]; 2], plan: &Plan) -> Contender<'a> {
    let mut overlay = Overlay::new(first, second);
    let path = vec![[0, 1].map(|part| plan.parts[part].state.pose()); BURST];
    let calls = path.len();
    Contender::clocked(move || overlay.round(&path), calls)
}
