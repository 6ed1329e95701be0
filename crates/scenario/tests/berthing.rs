//! The berthing of `scenarios/berth/alongside_with_two_tugs.toml` runs as its comments describe; the particulars of a `[berthing]`
//! come from its table, or from the vessel and the water.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::collections::BTreeSet;

use fenderline_scenario::{Override, Scenario, ScenarioError};
use fenderline_sim::Simulation;

const KNOT_MPS: f64 = 1852.0 / 3600.0;

/// She approaches at 4 knots and stops. Both tugs push. She touches all eight cones, none beyond its rating. Six lines
/// are made fast and hold. After the tugs stop pushing, the wind keeps her on the fenders.
#[test]
fn the_container_ship_comes_alongside_with_two_tugs_and_stays_there() {
    let text = include_str!("../../../scenarios/berth/alongside_with_two_tugs.toml");
    let scenario =
        Scenario::parse(text, "alongside.toml").unwrap_or_else(|error| panic!("{error}"));
    let fenders = scenario.setup.fenders.len();
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let (mut touched, mut pushed_n) = (BTreeSet::new(), [0.0_f64; 2]);
    let (mut at_end_n, mut fastest_at_touch_mps) = (f64::INFINITY, 0.0_f64);
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        let ship = &record.states[0];
        match record.t_s {
            t_s if t_s < 60.0 => {
                let knots = ship.velocity_mps.length() / KNOT_MPS;
                assert!((knots - 4.0).abs() < 0.3, "{knots} kn at {t_s} s");
            }
            t_s if t_s > 44.0 * 60.0 => {
                let press_n: f64 = record.contacts.iter().map(|c| c.normal_force_n).sum();
                at_end_n = at_end_n.min(press_n);
                assert!(ship.velocity_mps.length() < 0.02, "{ship:?}");
                assert!(ship.heading_rad.abs() < 0.5_f64.to_radians(), "{ship:?}");
                assert!(record.tugs.iter().all(|tug| tug.force.sway_n.abs() < 10e3));
                for line in record.lines {
                    let state = line.line.as_ref().map(|(_, state)| state.parted);
                    assert_eq!(state, Some(false), "made fast and not parted");
                }
            }
            _ => {}
        }
        if touched.is_empty() && !record.contacts.is_empty() {
            fastest_at_touch_mps = ship.velocity_mps.length();
        }
        touched.extend(record.contacts.iter().filter_map(|c| c.fender).map(|fender| fender.0));
        for (most_n, tug) in pushed_n.iter_mut().zip(record.tugs) {
            *most_n = most_n.max(tug.force.sway_n.abs());
        }
    }
    assert_eq!((fenders, touched.len()), (8, 8));
    assert!(fastest_at_touch_mps < 0.05, "{fastest_at_touch_mps} m/s");
    assert!(pushed_n.iter().all(|&most_n| most_n > 300e3), "{pushed_n:?}");
    assert!(at_end_n > 100e3, "{at_end_n} N on the fenders in the last minute");
    let over =
        simulation.fender_summaries().filter(|fender| fender.peak_reaction_n > 1500e3).count();
    assert_eq!(over, 0);
}

/// A vessel of 160 by 27 m, draught 8 m and block coefficient 0.66, in 9 m of water and 1 m of tide.
const FEEDER: &str = r#"
[time]
step = "0.1 s"
duration = "60 s"

[environment]
depth = "9 m"
tide = { level = "1 m" }

[material.facing]
stiffness = 0
shear_stiffness = "3000 kN/m"
friction_static = 0.2
friction_dynamic = 0.2

[vessel.feeder]
length_bp = "160 m"
beam = "27 m"
draught = "8 m"
block_coefficient = 0.66

[body.ship]
vessel = "feeder"
outline = [[-80, -13], [60, -13], [80, 0], [60, 13], [-80, 13]]
approach = { to = "quay", speed_normal = "0.15 m/s", contact = "midship", distance = "3 m" }

[body.quay]
fixed = true
outline = [[-100, 0], [100, 0], [100, 20], [-100, 20]]

[fender_row.a]
on = "quay"
first = [-30, 0]
spacing = "20 m"
number = 4
width = "2 m"
face_height = "3 m"
projection = "1.6 m"
type = "cone"
height = "1.3 m"
rated_reaction = "1000 kN"
material = "facing"

[[pair]]
bodies = ["ship", "quay"]
material = "facing"

[berthing]
ship = "ship"
"#;

fn feeder(settings: &[&str]) -> Result<Scenario, ScenarioError> {
    let overrides: Vec<_> = settings.iter().map(|text| Override::parse(text).unwrap()).collect();
    Scenario::parse_with(FEEDER, "feeder.toml", &overrides)
}

#[test]
fn vessel_and_water_give_the_particulars_of_a_berthing() {
    let scenario = feeder(&[]).unwrap_or_else(|error| panic!("{error}"));
    let berthing = scenario.setup.berthing.expect("a study");
    let close = |ours: f64, expected: f64| assert!((ours - expected).abs() < 1e-9, "{ours}");
    close(berthing.length_bp_m, 160.0);
    close(berthing.beam_m, 27.0);
    close(berthing.draught_m, 8.0);
    close(berthing.block_coefficient, 0.66);
    close(berthing.under_keel_clearance_m, 9.0 + 1.0 - 8.0);
    let about: Vec<_> =
        scenario.notices.iter().filter(|notice| notice.key.starts_with("berthing")).collect();
    assert!(about.is_empty(), "{about:?}");
}

#[test]
fn a_particular_that_contradicts_vessel_or_water_is_noted_with_both_values() {
    let noted = |setting: &str| {
        let (path, _) = setting.split_once('=').unwrap();
        let scenario = feeder(&[setting]).unwrap_or_else(|error| panic!("{error}"));
        let found = scenario.notices.iter().find(|notice| notice.key == path);
        (found.map(|notice| notice.message.clone()), scenario.setup.berthing.expect("a study"))
    };
    let (message, taken) = noted("berthing.beam=30");
    assert_eq!(
        message.unwrap(),
        "30 m is given, but the vessel of \"ship\" has 27 m: 30 m is used"
    );
    assert_eq!(taken.beam_m, 30.0);
    assert_eq!(
        noted("berthing.under_keel_clearance=3").0.unwrap(),
        "a clearance of 3 m is given, but `environment.depth` with the tide, 10 m, less the draught of 8 m is 2 m: 3 m is used"
    );
    assert!(noted("berthing.draught=9").0.is_some());
    assert!(noted("berthing.length_bp=150").0.is_some());
    assert!(noted("berthing.block_coefficient=0.7").0.is_some());
    for alike in ["berthing.beam=27.5", "berthing.under_keel_clearance=2.05"] {
        assert_eq!(noted(alike).0, None, "{alike}");
    }
}

#[test]
fn a_particular_that_nothing_gives_is_an_error() {
    let refused = |text: &str, key: &str| {
        let error = Scenario::parse(text, "feeder.toml").expect_err(key);
        assert_eq!(error.key(), Some(key), "{error}");
        error.to_string()
    };
    let key = "berthing.under_keel_clearance";
    let deep = FEEDER.replace("depth = \"9 m\"\ntide = { level = \"1 m\" }\n", "");
    assert!(refused(&deep, key).contains("[environment] has no depth"));
    let aground = FEEDER.replace("depth = \"9 m\"", "depth = \"6 m\"");
    assert!(refused(&aground, key).contains("aground: a draught of 8 m in 7 m of water"));
    let body = FEEDER.replace("vessel = \"feeder\"", "mass = \"23000 t\"\ngyradius = \"40 m\"");
    assert!(refused(&body, "berthing.length_bp").contains("\"ship\" is no vessel"));
}

/// Cm of the run is one plus the added mass in deep water times its factor in 10/8 draughts. The formula has the 0.15 m/s of the
/// approach, the run what drag has left of it.
#[test]
fn the_mass_of_the_run_is_made_of_added_mass_and_shallow_water() {
    let setup = feeder(&[]).unwrap_or_else(|error| panic!("{error}")).setup;
    let (vessel, kg_per_m3) =
        (setup.world.vessels[0].clone(), setup.world.environment.water_density_kgpm3);
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    while simulation.berthing().is_none() {
        simulation.step().expect("a good step");
    }
    let outcome = simulation.berthing().expect("touched").expect("a ship");
    let displaced_m3 = 160.0 * 27.0 * 8.0 * 0.66;
    let deep = vessel.deep.added_mass.sway_m3 / displaced_m3;
    assert!((outcome.added_sway.deep / deep - 1.0).abs() < 1e-9, "{outcome:?}");
    let shallow = outcome.added_sway.shallow.expect("10 m of water");
    assert!((shallow.depth_over_draught - 1.25).abs() < 1e-12);
    assert!(shallow.factor > 1.5 && shallow.factor < 4.0, "{shallow:?}");
    let by_parts = 1.0 + deep * shallow.factor;
    assert!((outcome.added_mass_simulated / by_parts - 1.0).abs() < 1e-9, "{outcome:?}");
    assert!((outcome.displacement_kg / (kg_per_m3 * displaced_m3) - 1.0).abs() < 1e-9);

    assert_eq!(outcome.design_speed_mps, Some(0.15));
    let (touch, design) = (outcome.speed_mps, 0.15);
    assert!(touch < 0.15 && touch > 0.13, "{touch}");
    let ratio = outcome.energy_j / outcome.energy_at_touch_j;
    assert!((ratio / (design * design / (touch * touch)) - 1.0).abs() < 1e-9, "{ratio}");
    // By hand: Cm = 1.875 − 0.75·2/8 and Ce = 1, as four fenders are met at once.
    let by_hand_j = 0.5 * outcome.displacement_kg * 0.15 * 0.15 * (1.875 - 0.75 * 2.0 / 8.0);
    assert!((outcome.energy_j / by_hand_j - 1.0).abs() < 1e-6, "{} {by_hand_j}", outcome.energy_j);
}

/// Below 1.2 draughts of water no published test is known: the sentence says so where the number stands.
#[test]
fn a_mass_of_the_run_that_is_extrapolated_says_so() {
    let said = |depth: &str| {
        let setup = feeder(&[depth]).unwrap_or_else(|error| panic!("{error}")).setup;
        let mut simulation = Simulation::new(setup).expect("a good set-up");
        while simulation.berthing().is_none() {
            simulation.step().expect("a good step");
        }
        simulation.berthing().expect("touched").expect("a ship").mass_of_run()
    };
    let of = |depth: &str| said(depth).contains("our extrapolation");
    // With the tide of 1 m: 1.25, 1.15 and 1.05 draughts.
    assert!(
        !of("environment.depth=9") && of("environment.depth=8.2") && of("environment.depth=7.4")
    );
    assert!(said("environment.depth=8.2").contains("published tests end at 1.2 draughts"));
}
