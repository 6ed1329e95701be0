//! Times chains of tugs and rafts of barges: one island of many floating bodies that touch, as its size grows.

use crate::rounds::{Contender, least, nanoseconds_a_call};
use crate::world::Engine;
use fenderline_bench_scenes::engine::Variant;
use fenderline_bench_scenes::play::{BURST, STEP_S, burst};
use fenderline_bench_scenes::scenes::Scene;
use fenderline_bench_scenes::table::Table;

/// A kind of island with rising sizes, and the times to reach.
struct Kind {
    name: &'static str,
    /// Number of bodies in an island whose size parameter is given (the side of a raft, for instance).
    bodies: fn(usize) -> usize,
    scene: fn(usize) -> Scene,
    sizes: &'static [usize],
    /// For some sizes, the most milliseconds that a step may take.
    most_ms: &'static [(usize, f64)],
    /// Largest power of the number of bodies with which the time may grow from the first size to the last.
    most_power: f64,
}

const KINDS: [Kind; 2] = [
    Kind {
        name: "chain of tugs",
        bodies: |count| count,
        scene: Scene::Chain,
        sizes: &[10, 30, 100, 300, 1000],
        most_ms: &[(100, 1.0)],
        most_power: 1.2,
    },
    Kind {
        name: "raft of barges",
        bodies: |side| side * side,
        scene: Scene::Raft,
        sizes: &[3, 5, 10, 18, 32],
        most_ms: &[(10, 4.0), (32, 150.0)],
        most_power: 1.6,
    },
];

const ENGINES: [Engine; 2] = [Engine::Own(Variant::Coupled), Engine::Rapier];

pub(crate) fn bench(rounds: usize) -> Table {
    let mut table = Table::new(&[
        "island",
        "bodies",
        "a step [ms]",
        "rapier2d [ms]",
        "of rapier2d",
        "to reach",
        "",
        "growth",
        "",
    ]);
    for kind in &KINDS {
        rows(kind, rounds).into_iter().for_each(|row| table.row(row));
    }
    table.note(
        "Times are the least of the rounds; each engine begins anew every 17 steps, as in `step`.",
    );
    table.note("rapier2d does not solve for the exact forces: its solver stops after a fixed number of sweeps.");
    table.note("growth: the power of the number of bodies with which the time grows from the first size to the size of the row.");
    table
}

fn rows(kind: &Kind, rounds: usize) -> Vec<Vec<String>> {
    let times_ms: Vec<[f64; 2]> =
        kind.sizes.iter().map(|&size| step_ms(kind, size, rounds)).collect();
    let last = kind.sizes.len() - 1;
    let row = |(index, &size): (usize, &usize)| {
        let [own_ms, rapier_ms] = times_ms[index];
        let [first, count] = [kind.sizes[0], size].map(|size| (kind.bodies)(size) as f64);
        let power = libm::log(own_ms / times_ms[0][0]) / libm::log(count / first);
        let most_ms = kind.most_ms.iter().find(|(of, _)| *of == size).map(|(_, most_ms)| *most_ms);
        let judged = |reached: bool| if reached { "✓" } else { "✗" };
        vec![
            kind.name.to_owned(),
            count.to_string(),
            format!("{own_ms:.3}"),
            format!("{rapier_ms:.3}"),
            format!("{:.1}", own_ms / rapier_ms),
            most_ms.map_or_else(String::new, |most_ms| format!("≤ {most_ms} ms")),
            most_ms.map_or("", |most_ms| judged(own_ms <= most_ms)).to_owned(),
            if index == 0 { String::new() } else { format!("n^{power:.2}") },
            match index == last {
                true => format!("≤ n^{} {}", kind.most_power, judged(power <= kind.most_power)),
                false => String::new(),
            },
        ]
    };
    kind.sizes.iter().enumerate().map(row).collect()
}

/// Milliseconds that each engine takes for a step of an island of a size.
fn step_ms(kind: &Kind, size: usize, rounds: usize) -> [f64; 2] {
    let plan = (kind.scene)(size).plan();
    let mut contenders = ENGINES.map(|engine| {
        let mut world = engine.world(&plan, STEP_S);
        Contender { round: Box::new(move || burst(world.as_mut())), calls: BURST }
    });
    let times = nanoseconds_a_call(&mut contenders, rounds);
    [0, 1].map(|index| 1e-6 * least(&times[index]))
}
