//! The tide in scenarios: depth, heights of fenders and bollards ashore, and a ship that grounds at low water.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use fenderline_scenario::{Scenario, ScenarioError};
use fenderline_sim::{Simulation, WorldEventKind};

/// A ship beside a quay with one fender and one line; parts are replaced in the tests.
const MOORED: &str = r#"
[time]
step = "0.5 s"
duration = "20 min"

[environment]
depth = "16 m"
wind = { speed = "15 m/s", from = "270 deg" }

[vessel.coaster]
length_bp = "130 m"
beam = "20 m"
draught = "8 m"
block_coefficient = 0.74
propeller = { diameter = "4.4 m", full = "130 rpm" }
rudder = { area = "18 m^2", span = "5 m" }
windage = { frontal_area = "350 m^2", lateral_area = "1300 m^2", centroid_height = "7 m", type = "cargo vessel, loaded" }
stability = { gm = "1.1 m", gravity_above_keel = "7.5 m", waterplane_area = "2150 m^2" }

[body.ship]
vessel = "coaster"
outline = [[-65, -10], [65, -10], [65, 10], [-65, 10]]
position = [0, -11.75]

[body.quay]
fixed = true
outline = [[-120, 0], [120, 0], [120, 20], [-120, 20]]

[material.smooth]
stiffness = "1 MN/m^2"
damping = "0.3 MN.s/m^2"

[fender.face]
on = "quay"
position = [0, 0]
facing = "-90 deg"
width = "100 m"
projection = "1.5 m"
above_water = "3 m"
material = "smooth"

[[pair]]
bodies = ["ship", "quay"]
material = "smooth"

[line.breast]
from = "ship"
fairlead = [60, 10]
fairlead_height = "6 m"
to = "quay"
bollard = [62, 4]
bollard_height = "3.5 m"
rope = "polyester"
break_load = "600 kN"
pretension = "40 kN"
"#;

fn read(changes: &[(&str, &str)], files: &[(&str, &str)]) -> Result<Scenario, ScenarioError> {
    let text = changes.iter().fold(MOORED.to_owned(), |text, (part, other)| {
        assert!(text.contains(part), "{part}");
        text.replacen(part, other, 1)
    });
    Scenario::parse_among(&text, "moored.toml", &[], &mut |name| {
        let file = files.iter().find(|(known, _)| *known == name);
        file.map(|(_, text)| (*text).to_owned()).ok_or(format!("{name}: there is no such file"))
    })
}

#[track_caller]
fn good(changes: &[(&str, &str)], files: &[(&str, &str)]) -> Scenario {
    read(changes, files).unwrap_or_else(|error| panic!("{error}"))
}

fn simulation(changes: &[(&str, &str)], files: &[(&str, &str)]) -> Simulation {
    Simulation::new(good(changes, files).setup).unwrap_or_else(|error| panic!("{error}"))
}

/// The choice of datum must not matter. With the depth 2 m smaller, the heights 2 m larger and the tide 2 m above
/// datum, all results are the same to the last bit.
#[test]
fn the_choice_of_datum_changes_no_bit() {
    let play = |changes: &[(&str, &str)]| {
        let mut simulation = simulation(changes, &[]);
        let mut tensions_n = Vec::new();
        while !simulation.is_done() {
            tensions_n.push(simulation.step().expect("a good step").lines[0].load.tension_n);
        }
        let vessel = simulation.vessels()[0].clone();
        (simulation.states().to_vec(), vessel.attitude, vessel.squat_m, tensions_n)
    };
    let at_datum = play(&[]);
    assert_eq!(at_datum.0, play(&[("[vessel", "tide = { level = 0 }\n[vessel")]).0);
    let higher = play(&[
        ("depth = \"16 m\"", "depth = \"14 m\"\ntide = { level = \"2 m\" }"),
        ("above_water = \"3 m\"", "above_water = \"5 m\""),
        ("bollard_height = \"3.5 m\"", "bollard_height = \"5.5 m\""),
    ]);
    assert_eq!(at_datum, higher);
    // A chock rises with the ship.
    let floating = play(&[("fairlead_height = \"6 m\"", "fairlead_height = \"8 m\"")]);
    assert_ne!(at_datum.3, floating.3);
}

/// The wind presses her on a fender 3 m above the water. With the water a metre lower it is 4 m above it, and heels her
/// by N · 1 m/(W GM) more. The tolerance of 2 % covers the remaining roll motion.
#[test]
fn a_lower_tide_raises_the_fender_on_the_quay() {
    let heel = |level: &str| {
        let tide = format!(
            "wind = {{ speed = \"15 m/s\", from = \"270 deg\" }}\ntide = {{ level = {level} }}"
        );
        let alone = MOORED.find("[line.breast]").expect("a line");
        let wind = "wind = { speed = \"15 m/s\", from = \"270 deg\" }";
        let mut simulation =
            simulation(&[(&MOORED[alone..], ""), (wind, &tide), ("depth = \"16 m\"", "")], &[]);
        let (mut force_n, mut roll_rad) = (0.0, 0.0);
        while !simulation.is_done() {
            let record = simulation.step().expect("a good step");
            force_n = record.contacts.iter().map(|c| c.normal_force_n).sum();
            roll_rad = record.vessels[0].attitude.roll.value;
        }
        (force_n, roll_rad)
    };
    let ((high_n, high_rad), (low_n, low_rad)) = (heel("0"), heel("-1"));
    assert!(high_n > 100e3 && (high_n / low_n - 1.0).abs() < 1e-3, "{high_n} {low_n}");
    let by_hand_rad = low_n / (1025.0 * 0.74 * 130.0 * 20.0 * 8.0 * 9.806_65 * 1.1);
    let more_rad = high_rad - low_rad;
    assert!((more_rad.abs() / by_hand_rad - 1.0).abs() < 0.02, "{more_rad} {by_hand_rad}");
}

/// A floating fender rides the tide: it acts 3 m above the water at any level.
#[test]
fn a_floating_fender_keeps_its_height_above_the_water() {
    let roll = |fender: &str, level: &str| {
        let tide = format!(
            "wind = {{ speed = \"15 m/s\", from = \"270 deg\" }}\ntide = {{ level = {level} }}"
        );
        let alone = MOORED.find("[line.breast]").expect("a line");
        let wind = "wind = { speed = \"15 m/s\", from = \"270 deg\" }";
        let above = "above_water = \"3 m\"";
        let changes = [
            (&MOORED[alone..], ""),
            (wind, tide.as_str()),
            ("depth = \"16 m\"", ""),
            ("\"20 min\"", "\"3 min\""),
            (above, fender),
        ];
        let mut simulation = simulation(&changes, &[]);
        while !simulation.is_done() {
            simulation.step().expect("a good step");
        }
        simulation.vessels()[0].attitude.roll.value
    };
    let floating = "above_water = \"3 m\"\nfloating = true";
    let fixed = "above_water = \"3 m\"";
    assert_eq!(roll(floating, "2").to_bits(), roll(fixed, "0").to_bits());
    assert!(roll(fixed, "2") != roll(fixed, "0"));
}

/// She drifts in the wind for two hours while the depth falls from 12 m to 7 m and rises back to 12 m. She passes 1.1
/// draughts at 8.8 m and her draught at 8 m; each gives one event at its time. The bottom stops and holds her, then she
/// floats and drifts again. Forces are continuous: with a quarter of the step they change about a quarter as much from
/// step to step (0.4 is allowed for sharp turns).
#[test]
fn a_falling_tide_grounds_a_ship_and_a_rising_tide_refloats_her() {
    let (coarse_n, fine_n) = (adrift_in_a_falling_tide(0.2), adrift_in_a_falling_tide(0.05));
    assert!(coarse_n < 20e3 && fine_n < 0.4 * coarse_n, "{coarse_n} {fine_n}");
}

/// The largest change of the force of water and bottom from one step to the next (N).
fn adrift_in_a_falling_tide(step_s: f64) -> f64 {
    let mut simulation = simulation(
        &[
            ("step = \"0.5 s\"", &format!("step = {step_s}")),
            ("depth = \"16 m\"", "depth = 0\ntide = { file = \"tide.csv\" }"),
            ("from = \"270 deg\"", "from = \"90 deg\""),
            ("duration = \"20 min\"", "duration = \"2 h\""),
            (&MOORED[MOORED.find("[line.breast]").expect("a line")..], ""),
        ],
        &[("tide.csv", "t_s,level_m\n0,12\n3600,7\n7200,12\n")],
    );
    let mut water_events = Vec::new();
    let (mut last, mut aground_s) = (None::<f64>, 0.0_f64);
    let (mut largest_n, mut wind_n, mut drift_mps) = (0.0_f64, 0.0_f64, 0.0_f64);
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        let of_water = |kind| matches!(kind, WorldEventKind::Aground | WorldEventKind::ShallowHeld);
        let events = record.world_events.iter().map(|event| event.kind);
        water_events.extend(events.filter(|kind| of_water(*kind)).map(|kind| (record.t_s, kind)));
        let forces = &record.vessel_forces[0];
        let sway_n = forces.hull.sway_n + forces.bottom.sway_n;
        if let Some(before) = last.filter(|_| record.t_s > 60.0) {
            largest_n = largest_n.max((sway_n - before).abs());
        }
        last = Some(sway_n);
        wind_n = wind_n.max(forces.wind.sway_n.abs());
        aground_s += if record.vessels[0].aground { step_s } else { 0.0 };
        let state = record.states_after[0];
        assert!(state.position_m.is_finite() && state.velocity_mps.is_finite());
        let speed_mps = state.velocity_mps.length();
        drift_mps = drift_mps.max(speed_mps);
        if (3300.0..3900.0).contains(&record.t_s) {
            assert!(speed_mps < 0.005, "{state:?}");
        }
    }
    // 5 m an hour: 8.8 m after 2304 s, 8 m after 2880 s.
    let [held, aground] = water_events.as_slice() else { panic!("{water_events:?}") };
    assert_eq!((held.1, aground.1), (WorldEventKind::ShallowHeld, WorldEventKind::Aground));
    assert!(
        (held.0 - 2304.0).abs() <= 1.0 && (aground.0 - 2880.0).abs() <= 1.0,
        "{water_events:?}"
    );
    // While the depth is below 8 m, plus the two centimetres that she needs to float again.
    assert!((aground_s - 1454.4).abs() < 3.0, "{aground_s}");
    assert!(!simulation.vessels()[0].aground && drift_mps > 0.3, "{drift_mps}");
    assert!(simulation.states()[0].velocity_mps.length() > 0.3);
    assert!(wind_n > 100e3, "{wind_n}");
    largest_n
}

/// A depth of 1.05 draughts is accepted with a notice, as depths below the draught are.
#[test]
fn depths_between_1_and_1_1_draughts_are_accepted_with_a_notice() {
    let scenario = good(&[("depth = \"16 m\"", "depth = \"8.4 m\"")], &[]);
    let noted = scenario.notices.iter().any(|notice| {
        notice.message.contains("water of 1.05 draughts") && notice.key == "vessel.coaster"
    });
    assert!(noted, "{:?}", scenario.notices);
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let record = simulation.step().expect("a good step");
    let events: Vec<_> = record.world_events.iter().map(|event| event.kind).collect();
    assert_eq!(events, [WorldEventKind::ShallowHeld]);
    // At 1.1 draughts there is no such notice, and the mass is the same.
    let mass = |depth: &str| {
        let scenario = good(&[("depth = \"16 m\"", &format!("depth = \"{depth} m\""))], &[]);
        let held =
            scenario.notices.iter().any(|notice| notice.message.contains("keep their values"));
        (held, scenario.setup.bodies[0].mass.expect("a mass").added_sway_kg)
    };
    let (edge, at, aground) = (mass("8.8001"), mass("8.4"), mass("7"));
    assert!(!edge.0 && at.0 && aground.0);
    assert_eq!(at.1, aground.1);
    // With 0.1 mm more water: the polynomial is steep there, 6 % in a centimetre.
    assert!((at.1 / edge.1 - 1.0).abs() < 1e-3, "{} {}", at.1, edge.1);
}

/// Constituents are added to the level. As the tide falls, a notice says that her added mass stays constant.
#[test]
fn a_tide_of_constituents_is_their_sum() {
    let tide = "depth = \"10 m\"\ntide = { level = 1, constituent = [{ amplitude = 1, period = \"12 h\" }, \
                { amplitude = \"50 cm\", period = \"6 h\", lag = \"90 deg\" }] }";
    let scenario = good(&[("depth = \"16 m\"", tide)], &[]);
    let water = &scenario.setup.world.environment;
    for (hour, level_m) in [(0.0, 2.0), (3.0, 1.0), (1.5, 1.0 + 0.5_f64.sqrt() + 0.5), (6.0, 0.0)] {
        let ours_m = water.tide.level_m(hour * 3600.0);
        assert!((ours_m - level_m).abs() < 1e-9, "{hour} h: {ours_m}");
    }
    let noted = |what: &str| scenario.notices.iter().any(|notice| notice.message.contains(what));
    assert!(noted("the added mass keeps its value at the start"), "{:?}", scenario.notices);
}

#[test]
fn mistakes_about_the_tide_name_their_key() {
    for (tide, file, key, fragment) in [
        ("{ level = -17 }", "", "environment.depth", "the bottom is above the water"),
        ("{ }", "", "environment.tide.level", "is missing"),
        (
            "{ level = 1, file = \"t.csv\" }",
            "t_s,level_m\n0,1\n",
            "environment.tide.level",
            "does not go together",
        ),
        (
            "{ file = \"t.csv\", constituent = [{ amplitude = 1, period = 3600 }] }",
            "t_s,level_m\n0,1\n",
            "environment.tide.constituent",
            "does not go together",
        ),
        ("{ level = \"31 m\" }", "", "environment.tide.level", "must be"),
        ("{ level = nan }", "", "environment.tide.level", "not a finite number"),
        ("{ file = \"u.csv\" }", "", "environment.tide.file", "there is no such file"),
        ("{ file = \"t.csv\" }", "t_s,level_m\n0,99\n", "environment.tide.file", "99"),
        ("{ file = \"t.csv\" }", "t_s,level_m\n0,1\n0,2\n", "environment.tide.file", "0"),
        ("{ file = \"t.csv\" }", "t_s,height_m\n0,1\n", "environment.tide.file", "height_m"),
        (
            "{ level = 1, constituent = [{ amplitude = -1, period = 3600 }] }",
            "",
            "environment.tide.constituent.0.amplitude",
            "must be",
        ),
        (
            "{ level = 1, constituent = [{ amplitude = 1, period = 0 }] }",
            "",
            "environment.tide.constituent.0.period",
            "must be",
        ),
    ] {
        let line = format!("depth = 16\ntide = {tide}");
        let error = read(&[("depth = \"16 m\"", &line)], &[("t.csv", file)]).expect_err(fragment);
        let shown = error.to_string();
        assert_eq!(error.key(), Some(key), "{shown}");
        assert!(shown.contains(fragment), "{fragment}: {shown}");
        assert!(error.line().is_some(), "{shown}");
    }
}
