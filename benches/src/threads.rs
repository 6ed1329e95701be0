//! Times thousands of independent pairs of bodies on several threads: a model, a memory and a workspace for each
//! thread.

use std::thread;
use std::time::{Duration, Instant};

use fenderline_contact::BodyState;

use crate::rounds::{Contender, least, nanoseconds_a_call};
use fenderline_bench_scenes::engine::{Method, Ours};
use fenderline_bench_scenes::play::{BURST, STEP_S};
use fenderline_bench_scenes::scenes::{Plan, Scene};
use fenderline_bench_scenes::table::Table;
use fenderline_bench_scenes::world::World;

const PAIRS: usize = 10_000;
const THREADS: [usize; 4] = [1, 2, 4, 8];

pub(crate) fn bench(rounds: usize) -> Table {
    let plan = Scene::Pairs(PAIRS).plan();
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let mut teams: Vec<Vec<Ours>> = THREADS.iter().map(|&count| team(&plan, count)).collect();
    let states: Vec<Vec<BodyState>> = teams
        .iter_mut()
        .map(|team| {
            burst(team);
            team.iter().flat_map(Ours::states).copied().collect()
        })
        .collect();
    let contender =
        |mut team: Vec<Ours>| Contender { round: Box::new(move || burst(&mut team)), calls: BURST };
    let mut contenders: Vec<Contender<'_>> = teams.into_iter().map(contender).collect();
    let times = nanoseconds_a_call(&mut contenders, rounds);
    let mut table = Table::new(&["threads", "a step [µs]", "times as fast", "same bits"]);
    for ((count, taken_ns), own) in THREADS.iter().zip(&times).zip(&states) {
        table.row(vec![
            count.to_string(),
            format!("{:.0}", least(taken_ns) / 1e3),
            format!("{:.2}", least(&times[0]) / least(taken_ns)),
            if *own == states[0] { "✓" } else { "✗" }.to_owned(),
        ]);
    }
    table.note(&format!("{PAIRS} tugs on fenders, by the coupled method without reports of contacts, on {cores} cores."));
    table.note(
        "Each thread has a model of its own tugs and their fenders, and is started for each step.",
    );
    table.note("Times are the least of the rounds: where other programs run too, times on more threads are \
                slower in all rounds.");
    table
}

/// The scene split into `count` models of our engine, one for each thread.
fn team(plan: &Plan, count: usize) -> Vec<Ours> {
    // A tug and its fender are neighbours in the list.
    let each = (plan.parts.len() / 2).div_ceil(count) * 2;
    let part = |parts: &[_]| Plan { parts: parts.to_vec(), ..plan.clone() };
    plan.parts
        .chunks(each)
        .map(|parts| Ours::new(&part(parts), Method::Coupled, STEP_S).brief())
        .collect()
}

/// Restarts the models off the clock, and times the steps after the restart.
fn burst(team: &mut [Ours]) -> Duration {
    team.iter_mut().for_each(Ours::restart);
    let start = Instant::now();
    for _ in 0..BURST {
        let Some((first, others)) = team.split_first_mut() else { continue };
        thread::scope(|scope| {
            for other in others {
                scope.spawn(move || other.step());
            }
            first.step();
        });
    }
    start.elapsed()
}
