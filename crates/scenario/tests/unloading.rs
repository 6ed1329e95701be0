//! A moored ship on fenders with unloading laws, in gusts and over a day.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::path::Path;

use fenderline_contact::Vec2;
use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

/// The container ship on six lines and eight cone fenders, with the wind on to the quay.
fn moored(wind: &str, step: &str, duration: &str) -> Simulation {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let file = root.join("scenarios/live/moored_in_a_squall.toml");
    let text = std::fs::read_to_string(file)
        .unwrap()
        .replacen("wind = { file = \"squall.csv\" }", wind, 1)
        .replacen("step = \"0.1 s\"", step, 1)
        .replacen("duration = \"4 h\"", duration, 1);
    assert!(text.contains(wind) && text.contains(step) && text.contains(duration));
    let setup = Scenario::parse(&text, "moored.toml").expect("a good scenario").setup;
    assert!(setup.fenders.iter().all(|fender| fender.unloading.is_some()), "the default");
    Simulation::new(setup).expect("a good set-up")
}

/// Once 3.5 % of the samples of a ship at rest were below half of the curve, and reactions alternated from step to
/// step.
#[test]
fn in_gusts_no_reaction_falls_below_its_unloading_curve() {
    let wind = "wind = { speed = \"14 m/s\", from = \"260 deg\", gusts = true, seed = 3 }";
    let mut simulation = moored(wind, "step = \"0.1 s\"", "duration = \"40 min\"");
    let setup = simulation.setup().clone();
    let (mut samples, mut least, mut reversals) = (0_u32, f64::INFINITY, 0_u32);
    let mut before_n = vec![(0.0, 0.0); setup.fenders.len()];
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        for contact in record.contacts {
            let Some(id) = contact.fender else { continue };
            let fender = &setup.fenders[id.0 as usize];
            let unloading = fender.unloading.as_ref().expect("it has one");
            let loading_n = fender.law.reaction_n(contact.depth_m);
            let lower_n =
                contact.factor * unloading.reaction_n(&fender.law, contact.depth_m, loading_n);
            samples += 1;
            // Of a tilted hull's force the part along the axis.
            let share = contact.normal_force_n * libm::cos(contact.tilt_rad) / lower_n;
            if contact.depth_m > 1e-3 {
                least = least.min(share);
            }
            // What a comb has: a fall by a tenth of the reaction and back within two steps.
            let (last_n, earlier_n) = before_n[id.0 as usize];
            let falls = contact.normal_force_n > 1.1 * last_n && earlier_n > 1.1 * last_n;
            reversals += u32::from(falls && last_n > 1e3);
            before_n[id.0 as usize] = (contact.normal_force_n, last_n);
        }
    }
    println!("{samples} samples, least {least:.3} of the unloading curve, {reversals} teeth");
    assert!(samples > 100_000, "{samples}");
    assert!(least > 0.9, "{least}");
    assert_eq!(reversals, 0);
}

/// What is left are swings along the quay on the fenders' shear springs, which nothing damps: means over an hour tell.
#[test]
fn in_a_steady_wind_she_lies_where_she_is_for_a_day() {
    let wind = "wind = { speed = \"14 m/s\", from = \"260 deg\" }";
    let mut simulation = moored(wind, "step = \"1 s\"", "duration = \"24 h\"");
    let mut hours: Vec<Vec2> = Vec::new();
    let (mut nearest_m, mut farthest_m) = (f64::INFINITY, f64::NEG_INFINITY);
    for hour in 0..24 {
        let mut sum = Vec2::ZERO;
        for _ in 0..3600 {
            let record = simulation.step().expect("a good step");
            let ship_m = record.states[0].position_m;
            sum += ship_m;
            if hour >= 3 {
                (nearest_m, farthest_m) = (nearest_m.min(ship_m.y), farthest_m.max(ship_m.y));
            }
        }
        hours.push(sum * (1.0 / 3600.0));
    }
    let drift_m = (hours[23] - hours[3]).length();
    println!(
        "drift {:.4} mm, across the quay within {:.3} mm",
        1e3 * drift_m,
        1e3 * (farthest_m - nearest_m)
    );
    assert!(drift_m < 1e-4, "{drift_m} m in 20 hours");
    assert!(farthest_m - nearest_m < 1e-3, "{nearest_m} to {farthest_m} m");
}
