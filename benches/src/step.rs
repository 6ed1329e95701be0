//! A whole step of the engine.

use crate::rounds::{Contender, median, nanoseconds_a_call};
use crate::scenes::{Driven, Scene};
use crate::table::Table;

/// Scene, steps in a round, most microseconds a step (the prototype's machine set them).
const SCENES: [(&str, Scene, usize, Option<f64>); 4] = [
    ("1 tug, 1 fender", Scene::Tug, 4096, Some(0.2)),
    ("1 ship, 8 fenders", Scene::Ship, 1024, Some(1.0)),
    ("1,000 tugs on fenders", Scene::Pairs(1_000), 4, None),
    ("10,000 tugs on fenders", Scene::Pairs(10_000), 1, None),
];

/// Steps before the clock starts, so that all buffers have grown: a whole loop.
const WARM_UP: usize = 64;

pub(crate) fn bench(rounds: usize) -> Table {
    let mut table =
        Table::new(&["scene", "contacts", "a step [µs]", "a contact [ns]", "to reach [µs]", ""]);
    for (name, scene, steps, to_reach) in SCENES {
        let mut driven = Driven::new(scene);
        driven.steps(WARM_UP);
        let round = || driven.steps(steps);
        let mut contenders = [Contender { round: Box::new(round), calls: steps }];
        let times = nanoseconds_a_call(&mut contenders, rounds);
        drop(contenders);
        let (taken_ns, contacts) = (median(&times[0]), driven.contacts());
        table.row(vec![
            name.to_owned(),
            contacts.to_string(),
            format!("{:.3}", taken_ns / 1e3),
            format!("{:.0}", taken_ns / contacts as f64),
            to_reach.map_or(String::from("-"), |most| format!("≤ {most}")),
            to_reach.map_or("", |most| if taken_ns <= most * 1e3 { "✓" } else { "✗" }).to_owned(),
        ]);
    }
    table.note("medians, moving the bodies and the broad phase included; Δt 0.1 s");
    table
}
