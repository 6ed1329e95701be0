//! A moored ship on fenders with unloading laws, in gusts and over a day.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::path::Path;

use fenderline_contact::{Unloading, Vec2};
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

/// A fender of the user's own, of which no unloading is known. By restitution there were 1680 such jumps in twenty minutes: the
/// limiter determines the sum of the eight forces alone, and each of them jumped from step to step.
#[test]
fn a_moored_ship_s_reactions_do_not_jump_by_10_kn_at_a_tenth_of_a_millimetre() {
    const TYPE: &str =
        "type = \"cone\"\nheight = \"1.6 m\"\nrated_reaction = \"1500 kN\"\ntemperature = 15\n";
    const OWN: &str = "curve = [[0, 0], [0.16, 600e3], [0.4, 1400e3], [0.56, 1500e3], [0.8, 1250e3], \
                       [1.0, 1400e3], [1.12, 1500e3]]\n";
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let file = root.join("scenarios/berth/moored_three_hours_in_gusts.toml");
    let text = std::fs::read_to_string(file).unwrap();
    let text = text.replacen("duration = \"3 h\"", "duration = \"20 min\"", 1);
    assert_eq!(text.matches(TYPE).count(), 1, "one row of eight");
    for (fenders, text) in [("cones", text.clone()), ("own", text.replace(TYPE, OWN))] {
        let setup = Scenario::parse(&text, "moored.toml").expect("a good scenario").setup;
        let mut simulation = Simulation::new(setup).expect("a good set-up");
        let mut before = vec![None; 8];
        let (mut samples, mut jumps) = (0_u32, 0_u32);
        while !simulation.is_done() {
            let mut now = vec![None; 8];
            for contact in simulation.step().expect("a good step").contacts {
                let Some(id) = contact.fender else { continue };
                let (depth_m, force_n) = (contact.depth_m, contact.normal_force_n);
                if let Some((depth_before_m, force_before_n)) = before[id.0 as usize] {
                    let (moved_m, jump_n): (f64, f64) =
                        (depth_m - depth_before_m, force_n - force_before_n);
                    samples += 1;
                    jumps += u32::from(jump_n.abs() > 10e3 && moved_m.abs() < 1e-4);
                }
                now[id.0 as usize] = Some((depth_m, force_n));
            }
            before = now;
        }
        assert!(samples > 90_000, "{fenders}: {samples}");
        assert_eq!(jumps, 0, "{fenders}");
    }
}

/// Of a fender of which nothing is known, 55 % of the energy is assumed to be returned, and the report marks it. What restitution
/// does not do any more, the notice of the check says.
#[test]
fn a_fender_s_restitution_has_no_effect_and_the_notice_says_where_it_went() {
    const TEXT: &str = r#"
        time = { step = 0.1, duration = 1 }
        material.facing = { stiffness = 0, restitution = 0.1, friction_static = 0.2, shear_stiffness = 3e6 }
        material.concrete = { stiffness = 1e6, restitution = 0.1 }
        body.ship = { outline = [[-9, -3], [9, -3], [9, 3], [-9, 3]], mass = 5e5, gyradius = 5 }
        body.quay = { outline = [[-9, 0], [9, 0], [9, 5], [-9, 5]], fixed = true, position = [0, 9] }
        pair = [{ bodies = ["ship", "quay"], material = "concrete" }]
        [fender.own]
        on = "quay"
        position = [0, 0]
        facing = "-90 deg"
        width = 1
        projection = 1
        stiffness = 1e6
        material = "facing"
    "#;
    let parse = |text: &str| Scenario::parse(text, "own.toml").expect("a good scenario");
    let scenario = parse(TEXT);
    let told: Vec<_> = scenario.notices.iter().map(|n| (n.key.as_str(), &n.message)).collect();
    let [("material.facing.restitution", message)] = told[..] else { panic!("{told:?}") };
    assert!(message.contains("no effect") && message.contains("`returned_energy`"), "{message}");
    let fender = &scenario.setup.fenders[0];
    assert_eq!(fender.unloading, Some(Unloading::ReturnedEnergy(0.55)));
    let source = &fender.source.as_ref().expect("a source").source;
    assert!(source.contains("unloading (assumed)"), "{source}");
    // It has an effect by the paper's method, and where the fender asks for it.
    for other in ["contact.method = \"paper\"\n[fender.own]", "[fender.own]\nunloading_law = false"]
    {
        let scenario = parse(&TEXT.replace("[fender.own]", other));
        assert_eq!(scenario.notices, [], "{other}");
        let source = &scenario.setup.fenders[0].source.as_ref().expect("a source").source;
        assert_eq!(source.contains("assumed"), !other.contains("unloading_law"), "{source}");
    }
}
