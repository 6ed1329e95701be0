//! The engine against `validation/independent/coupled`: an independent implementation of the coupled method, in another
//! language, with other geometry, another integrator and another solver. Its results are in
//! `validation/independent/berth/`; `cargo xtask test all` computes some of them again.
//!
//! Both run at steps much shorter than every period of the scenario. Tolerance: 0.5 % of each largest force, depth,
//! speed and yaw rate; of final speeds and yaw rates 0.5 % of the largest that the body has in the run, as most end
//! nearly at rest. The time steps of the two programs leave 0.1 % of a first peak.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

const TOLERANCE: f64 = 0.005;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: &str) -> String {
    let path = root().join(path);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The results of a run by (quantity, of), with the names of the files.
type Found = BTreeMap<(String, String), f64>;

/// The engine's run at this step.
fn ours(name: &str, step_s: f64) -> Found {
    let file = format!("scenarios/berth/{name}.toml");
    let mut setup = Scenario::parse(&read(&file), &file).expect("a good scenario").setup;
    setup.step_s = step_s;
    let bodies: Vec<String> = setup.bodies.iter().map(|b| b.name.clone()).collect();
    let floats: Vec<String> =
        setup.bodies.iter().filter(|b| b.mass.is_some()).map(|b| b.name.clone()).collect();
    let fenders: Vec<String> = setup.fenders.iter().map(|f| f.name.clone()).collect();
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    let mut found = Found::new();
    let mut note = |quantity: &str, of: &str, value: f64| {
        let largest = found.entry((quantity.to_owned(), of.to_owned())).or_insert(0.0);
        *largest = largest.max(value);
    };
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        let mut sums = BTreeMap::<String, (f64, f64)>::new();
        for c in record.contacts {
            let name = c.fender.map_or_else(
                || format!("{} - {}", bodies[c.body_1.0 as usize], bodies[c.body_2.0 as usize]),
                |fender| fenders[fender.0 as usize].clone(),
            );
            let sum = sums.entry(name).or_default();
            *sum = (sum.0 + c.peak_normal_force_n, sum.1.max(c.peak_depth_m));
        }
        for (name, (force_n, depth_m)) in sums {
            note("peak_force", &name, force_n);
            note("peak_depth", &name, depth_m);
        }
        for (body, state) in
            bodies.iter().zip(record.states_after).filter(|(b, _)| floats.contains(b))
        {
            note("largest_speed", body, state.velocity_mps.length());
            note("largest_yaw_rate", body, state.yaw_rate_radps.abs());
        }
    }
    for (body, state) in bodies.iter().zip(simulation.states()).filter(|(b, _)| floats.contains(b))
    {
        let speed_mps = state.velocity_mps.length();
        found.insert(("final_speed".to_owned(), body.clone()), speed_mps);
        found.insert(("final_yaw_rate".to_owned(), body.clone()), state.yaw_rate_radps);
    }
    found
}

/// The independent run at its fine step.
fn theirs(name: &str) -> Found {
    let text = read(&format!("validation/independent/berth/{name}.csv"));
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("quantity,of,unit,value,at_coarse_step"));
    lines
        .map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            let value = cells[3].parse().expect("a number");
            ((cells[0].to_owned(), cells[1].to_owned()), value)
        })
        .collect()
}

fn compare(name: &str, step_s: f64) {
    let (ours, theirs) = (ours(name, step_s), theirs(name));
    assert!(ours.keys().eq(theirs.keys()), "{name}: {:?} and {:?}", ours.keys(), theirs.keys());
    let mut worst = (0.0, String::new());
    let mut wrong = Vec::new();
    for ((quantity, of), their) in &theirs {
        let our = ours[&(quantity.clone(), of.clone())];
        let scale = theirs[&(quantity.replace("final", "largest"), of.clone())];
        let error = (our - their).abs() / scale;
        let line =
            format!("{quantity} of {of}: {our:.6e}, theirs {their:.6e}, {:.2} %", 1e2 * error);
        if error > TOLERANCE {
            wrong.push(line.clone());
        }
        if error > worst.0 {
            worst = (error, line);
        }
    }
    assert!(wrong.is_empty(), "{name}:\n{}", wrong.join("\n"));
    println!("{name}: {} numbers, farthest {}", theirs.len(), worst.1);
}

#[test]
fn a_non_convex_ship_against_a_corner_agrees_with_the_independent_implementation() {
    compare("bulb_and_stern_step_at_a_corner", 0.01);
}

#[test]
fn a_berthing_on_cones_agrees_with_the_independent_implementation() {
    compare("eight_cones_at_5_deg", 0.01);
}

#[test]
fn six_hours_in_the_wind_agree_with_the_independent_implementation() {
    compare("held_by_wind_six_hours", 0.1);
}

#[test]
fn a_ship_leaning_on_fenders_agrees_with_the_independent_implementation() {
    compare("leaning_on_eight_fenders", 0.1);
}

#[test]
fn a_tug_that_pushes_and_slides_agrees_with_the_independent_implementation() {
    compare("tug_pushes_then_slides", 0.01);
}

/// At steps of 5 ms and less the slide once broke off: N rises briefly, and static friction held her bow again.
#[test]
fn a_tugs_slide_is_the_same_at_any_time_step() {
    let right = ours("tug_pushes_then_slides", 0.002);
    let depth = ("peak_depth".to_owned(), "bow".to_owned());
    let largest = ("largest_speed".to_owned(), "tug".to_owned());
    let last = ("final_speed".to_owned(), "tug".to_owned());
    for step_s in [0.005, 0.01, 0.02, 0.1] {
        let found = ours("tug_pushes_then_slides", step_s);
        for (quantity, scale) in [(&depth, &depth), (&largest, &largest), (&last, &largest)] {
            let error = (found[quantity] - right[quantity]).abs() / right[scale];
            println!("{step_s}: {quantity:?} {} of {}, {error}", found[quantity], right[quantity]);
            assert!(error < TOLERANCE, "Δt {step_s}: {quantity:?} is off by {error}");
        }
    }
}

#[test]
fn two_ships_on_floating_fenders_agree_with_the_independent_implementation() {
    compare("two_ships_on_pneumatic_fenders", 0.01);
}
