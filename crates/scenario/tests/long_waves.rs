//! Long waves at a berth: their motion of a moored ship against closed forms, their level, and mistakes that are refused.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::f64::consts::{PI, TAU};
use std::fs;
use std::path::Path;

use fenderline_contact::{Wrench, vec2};
use fenderline_scenario::{Override, Scenario, ScenarioError};
use fenderline_sim::environment::waves::wave_number;
use fenderline_sim::{Simulation, mass_matrix};

/// A coaster alone; lines are put in place of the comments.
const COASTER: &str = r#"
[time]
step = "0.5 s"
duration = "20 min"

[environment]
depth = "16 m"
# environment

[vessel.coaster]
length_bp = "100 m"
beam = "18 m"
draught = "6 m"
block_coefficient = 0.7

[body.ship]
vessel = "coaster"
outline = [[-50, -9], [50, -9], [50, 9], [-50, 9]]
# body
"#;

/// The barge with hydrodynamic data of the repository.
const BARGE: &str = r#"
[time]
step = "0.2 s"
duration = "2 h"

[environment]
depth = "20 m"
squat = "none"
# environment

[vessel.barge]
length_bp = "80 m"
beam = "20 m"
draught = "5 m"
block_coefficient = 1.0
gyradius = "20 m"
hydrodynamics = "barge_20m.hydro"

[body.barge]
vessel = "barge"
outline = [[-40, -10], [40, -10], [40, 10], [-40, 10]]
"#;

fn read_with(
    text: &str,
    environment: &str,
    files: &[(&str, &str)],
    settings: &[&str],
) -> Result<Scenario, ScenarioError> {
    let text = text.replace("# environment", environment);
    let settings: Vec<Override> =
        settings.iter().map(|text| Override::parse(text).expect("a setting")).collect();
    Scenario::parse_among(&text, "berth.toml", &settings, &mut |name| {
        let given = files.iter().find(|(known, _)| *known == name);
        if let Some((_, text)) = given {
            return Ok((*text).to_owned());
        }
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../hydrodynamics").join(name);
        fs::read_to_string(data).map_err(|why| why.to_string())
    })
}

fn read(text: &str, environment: &str, files: &[(&str, &str)]) -> Result<Scenario, ScenarioError> {
    read_with(text, environment, files, &[])
}

#[track_caller]
fn good(text: &str, environment: &str) -> Scenario {
    read(text, environment, &[]).unwrap_or_else(|error| panic!("{error}"))
}

/// Half of the range of surge at the end of a run (m) of a ship on a linear spring and damper along north.
fn surge_on_a_spring_m(
    scenario: Scenario,
    (spring_npm, damper_nspm): (f64, f64),
    last_s: f64,
) -> f64 {
    let duration_s = scenario.setup.duration_s;
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let (mut low_m, mut high_m) = (f64::INFINITY, f64::NEG_INFINITY);
    while simulation.time_s() < duration_s {
        let state = simulation.states()[0];
        let along_n = -spring_npm * state.position_m.x - damper_nspm * state.velocity_mps.x;
        simulation.set_external(&[Wrench { force_n: vec2(along_n, 0.0), moment_nm: 0.0 }]);
        simulation.step().expect("a good step");
        if simulation.time_s() > duration_s - last_s {
            low_m = low_m.min(simulation.states()[0].position_m.x);
            high_m = high_m.max(simulation.states()[0].position_m.x);
        }
    }
    0.5 * (high_m - low_m)
}

/// A regular long wave of 0.02 m and 100 s along a ship on a spring: m (ẍ − u̇) + c ẋ + k x = 0 with her mass and added mass m gives the
/// amplitude m ω u / |k − m ω² + i ω c|, for springs of shorter, the same and longer periods. The closed form has no hull resistance, which goes
/// with the square of the speed: in resonance with a wave of 0.2 m it takes 7 % of the surge, so here 0.7 %; hence 1 %.
#[test]
fn a_ship_on_a_linear_mooring_surges_as_the_linear_oscillator() {
    let waves = "long_waves = { height = 0.02, period = 100, towards = 0, regular = true }";
    let w = TAU / 100.0;
    let water_mps = 0.01 * w / (wave_number(w, 16.0) * 16.0);
    for natural_s in [60.0, 100.0, 170.0] {
        let scenario = good(&COASTER.replace("20 min", "2 h"), waves);
        let mass_kg = mass_matrix(&scenario.setup.world.vessels[0].ship, 1025.0)[0][0];
        let of_spring = TAU / natural_s;
        let (spring_npm, damper_nspm) =
            (mass_kg * of_spring * of_spring, 0.1 * mass_kg * of_spring);
        let by_hand_m =
            mass_kg * w * water_mps / (spring_npm - mass_kg * w * w).hypot(w * damper_nspm);
        let found_m = surge_on_a_spring_m(scenario, (spring_npm, damper_nspm), 200.0);
        println!("on a spring of {natural_s} s: {found_m:.4} m, by hand {by_hand_m:.4} m");
        assert!((found_m / by_hand_m - 1.0).abs() < 0.01, "{found_m} {by_hand_m}");
    }
}

/// The same for the barge with hydrodynamic data: her added mass and damping are those of the frequency, 0.1 rad/s, which answer her velocity
/// through the water. The coupling with pitch, which the closed form has not, is under 1 %.
#[test]
fn a_barge_with_data_surges_as_the_linear_oscillator_of_the_frequency() {
    let w: f64 = 0.1;
    let waves = format!(
        "long_waves = {{ height = 0.2, period = {}, towards = 0, regular = true }}",
        TAU / w
    );
    let scenario = good(BARGE, &waves);
    let data = scenario.setup.world.vessels[0].seakeeping.as_ref().expect("data").data.clone();
    let (_, added, damping) =
        data.radiation().find(|(at, ..)| (at - w).abs() < 1e-9).expect("a frequency of the data");
    let (mass_kg, own_nspm) = (data.mass_kg() + added[0][0], damping[0][0]);
    let water_mps = 0.1 * w / (wave_number(w, 20.0) * 20.0);
    let (spring_npm, damper_nspm) = (0.36 * mass_kg * w * w, 0.06 * mass_kg * w);
    let by_hand_m = water_mps * (w * mass_kg).hypot(own_nspm)
        / (spring_npm - mass_kg * w * w).hypot(w * (damper_nspm + own_nspm));
    let found_m = surge_on_a_spring_m(scenario, (spring_npm, damper_nspm), 200.0);
    println!("barge: {found_m:.4} m, by hand {by_hand_m:.4} m");
    assert!((found_m / by_hand_m - 1.0).abs() < 0.01, "{found_m} {by_hand_m}");
}

/// The force of a long wave on the barge, (m + A) u̇, against Capytaine's exciting force in its longest waves, of 0.1 and 0.15 rad/s: 860 and 560 m
/// long, 11 and 7 barges. The panel code has the phase of the wave along her, a mean of sin(kL/2)/(kL/2) = 0.986 and 0.967, by which the
/// long wave is too large; depth and draught differ in velocity by less than 1 %.
#[test]
fn the_force_of_a_long_wave_is_that_of_the_panel_code_in_its_longest_waves() {
    let scenario = good(BARGE, "");
    let data = scenario.setup.world.vessels[0].seakeeping.as_ref().expect("data").data.clone();
    for (w, largest) in [(0.1, 0.02), (0.15, 0.04)] {
        let (_, added, _) =
            data.radiation().find(|(at, ..)| (at - w).abs() < 1e-9).expect("a frequency");
        let number = wave_number(w, 20.0);
        let long_n = (data.mass_kg() + added[0][0]) * w * w / (number * 20.0);
        let panels = data.excitation_towards(w, 0.0)[0];
        let panels_n = panels.re.hypot(panels.im);
        let half = 0.5 * number * 80.0;
        println!(
            "{w} rad/s: long wave {:.1} kN/m, panels {:.1} kN/m, ratio {:.4}, along her {:.4}",
            long_n / 1e3,
            panels_n / 1e3,
            panels_n / long_n,
            half.sin() / half
        );
        assert!((panels_n / long_n - 1.0).abs() < largest, "{panels_n} {long_n}");
        // It leads the crest by a quarter of a period.
        assert!((panels.im.atan2(panels.re) - 0.5 * PI).abs() < 0.05, "{panels:?}");
    }
}

/// A file of long waves does what files of tide and current do together, to the bit; in deep water, where hull forces do not follow the tide.
#[test]
fn a_file_moves_a_ship_and_her_lines_as_tide_and_current_together() {
    let moored = COASTER.replace("depth = \"16 m\"", "").replace(
        "# body",
        r#"
[body.quay]
fixed = true
outline = [[-100, 20], [100, 20], [100, 40], [-100, 40]]

[line.spring]
from = "ship"
fairlead = [40, 9]
fairlead_height = "6 m"
to = "quay"
bollard = [0, 21]
bollard_height = "3 m"
rope = "nylon"
break_load = "900 kN"
pretension = "100 kN"
"#,
    );
    let rows: Vec<[f64; 4]> = (0..=120)
        .map(|row| {
            let t_s = 10.0 * f64::from(row);
            let (sine, cosine) = (TAU * t_s / 110.0).sin_cos();
            [t_s, 0.3 * cosine, 0.25 * cosine, 0.04 * sine]
        })
        .collect();
    let table = |header: &str, columns: &[usize]| {
        let rows = rows.iter().map(|row| {
            let cells: Vec<String> = columns.iter().map(|&k| row[k].to_string()).collect();
            cells.join(",") + "\n"
        });
        format!("{header}\n{}", rows.collect::<String>())
    };
    let files = [
        ("waves.csv", table("t_s,level_m,north_mps,east_mps", &[0, 1, 2, 3])),
        ("tide.csv", table("t_s,level_m", &[0, 1])),
        ("current.csv", table("t_s,north_mps,east_mps", &[0, 2, 3])),
    ];
    let files = files.each_ref().map(|(name, text)| (*name, text.as_str()));
    let run = |environment: &str| {
        let scenario = read(&moored, environment, &files).unwrap_or_else(|error| panic!("{error}"));
        let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
        let mut tensions_n = Vec::new();
        while simulation.time_s() < 1200.0 {
            tensions_n.push(simulation.step().expect("a good step").lines[0].load.tension_n);
        }
        (tensions_n, simulation.states()[0])
    };
    let (tensions_n, state) = run("long_waves = { file = \"waves.csv\" }");
    let (with_tide_n, with_tide) =
        run("tide = { file = \"tide.csv\" }\ncurrent = { file = \"current.csv\" }");
    assert_eq!((&tensions_n, state), (&with_tide_n, with_tide));
    let (without_n, _) = run("");
    assert!(tensions_n != without_n && state.position_m.x != 0.0);
}

#[test]
fn tide_and_current_are_added_and_keys_are_set_from_outside() {
    let with = |lines: &str, settings: &[&str]| {
        let scenario = read_with(COASTER, lines, &[], settings);
        scenario.unwrap_or_else(|error| panic!("{error}")).setup.world.environment
    };
    let lines = "tide = { level = 1.5 }\nlong_waves = { height = 0.4, period = \"2 min\", towards = \"90 deg\", regular = true }";
    let environment = with(lines, &["environment.long_waves.height=0.6 m"]);
    assert!((environment.level_m(0.0) - 1.8).abs() < 1e-12);
    assert!((environment.level_m(60.0) - 1.2).abs() < 1e-9);
    assert_eq!(environment.depth_m.map(|m| m + environment.tide.level_m(0.0)), Some(17.5));
    let table = "long_waves = { height = 0.4, period = 100, towards = 0 }";
    let sets = ["environment.long_waves.seed=9", "environment.long_waves.shortest_period=70"];
    assert_ne!(with(table, &sets[..1]).long_waves, with(table, &[]).long_waves);
    assert_ne!(with(table, &sets[1..]).long_waves, with(table, &[]).long_waves);
    // At the wall of a seiche there is level only, at its node velocity only.
    let seiche = |wall: &str| {
        with(
            &format!(
                "long_waves = {{ height = 0.4, period = 100, towards = 0, regular = true, wall_distance = {wall} }}"
            ),
            &[],
        )
        .long_waves
        .expect("long waves")
    };
    assert!(seiche("0").velocity_deviation().length() < 1e-12);
    let quarter_m = 0.5 * PI / wave_number(TAU / 100.0, 16.0);
    let node = seiche(&quarter_m.to_string());
    assert!(node.significant_height_m() < 1e-12 && node.velocity_deviation().x > 0.1);
}

#[track_caller]
fn refused(lines: &str, files: &[(&str, &str)], key: &str, fragments: &[&str]) {
    let error = read(COASTER, lines, files).expect_err(fragments[0]);
    let shown = error.to_string();
    assert_eq!(error.key(), Some(key), "{shown}");
    assert!(error.line().is_some(), "{shown}");
    for fragment in fragments {
        assert!(shown.contains(fragment), "{fragment}: {shown}");
    }
}

#[test]
fn mistakes_are_refused_at_their_keys() {
    let of = |more: &str, key: &str, fragments: &[&str]| {
        let lines = format!("long_waves = {{ {more} }}");
        let file = ("l.csv", "t_s,level_m,north_mps,east_mps\n0,0,0,0\n1200,0,0,0\n");
        refused(&lines, &[file], &format!("environment.long_waves{key}"), fragments);
    };
    of("height = 0.2", ".period", &["is missing", "or a `file`"]);
    of("height = 0.2, period = 12, towards = 0", ".period", &["25"]);
    of("height = 13, period = 90, towards = 0", ".height", &["break at 0.78 depths", "12.48"]);
    of(
        "height = 0.2, period = 90, towards = 0, shortest_period = 95",
        "",
        &["peak period of the long waves", "95"],
    );
    of(
        "height = 0.2, period = 90, towards = 0, regular = true, seed = 3",
        ".seed",
        &["does not go together with `regular`"],
    );
    of("file = \"l.csv\", wall_distance = 9", ".wall_distance", &["with `file`"]);
    of("file = \"l.csv\", regular = true", ".regular", &["with `file`"]);
    let deep = COASTER.replace("depth = \"16 m\"", "depth = \"200 m\"");
    let lines = "long_waves = { height = 0.2, period = 60, towards = 0 }";
    let error = read(&deep, lines, &[]).expect_err("too short").to_string();
    assert!(error.contains("a wave of 30 s is 1130 m long in 200 m of water"), "{error}");
    let error = read(&COASTER.replace("depth = \"16 m\"", ""), lines, &[]).expect_err("no depth");
    assert!(error.to_string().contains("needs a `depth` in the same table"), "{error}");
    // Swell of 20 s has harmonics of up to 40 s.
    let both = "waves = { height = 1, period = 20, from = 0 }\nlong_waves = { height = 0.2, period = 70, towards = 0 }";
    refused(
        both,
        &[],
        "environment.long_waves.period",
        &["35 s", "environment.waves", "counted twice"],
    );
    let both = "waves = { height = 1, period = 20, from = 0 }\nlong_waves = { height = 0.2, period = 70, towards = 0, shortest_period = 41 }";
    assert!(read(COASTER, both, &[]).is_ok());
    let still = "waves = { height = 0, period = 20, from = 0 }\nlong_waves = { height = 0.2, period = 70, towards = 0 }";
    assert!(read(COASTER, still, &[]).is_ok());
}

#[test]
fn a_broken_file_is_refused_at_its_line() {
    let header = "t_s,level_m,north_mps,east_mps\n";
    let of = |rows: &str, fragments: &[&str]| {
        let file = format!("{header}{rows}");
        let lines = "long_waves = { file = \"l.csv\" }";
        refused(lines, &[("l.csv", &file)], "environment.long_waves.file", fragments);
    };
    of(
        "0,0,0,0\n400,0,0,0\n1100,0,0,0\n1200,0,0,0\n",
        &["l.csv:4:1", "a gap before this row: 700 s, where 400 s are usual"],
    );
    of("0,0,0,0\n600,0,0,0\n600,0,0,0\n", &["l.csv:4:1", "not later"]);
    of("0,0,0,0\n600,0,0,0\n", &["from 0 to 600 s", "0 to 1200 s"]);
    of("600,0,0,0\n1200,0,0,0\n", &["from 600 to 1200 s"]);
    of("0,11,0,0\n1200,0,0,0\n", &["l.csv:2:3", "between -10 and 10"]);
    of("0,0,0,0\n1200,0,,0\n", &["l.csv:3", "is empty here"]);
    let short = "long_waves = { file = \"l.csv\" }";
    let key = "environment.long_waves.file";
    refused(short, &[("l.csv", "t_s,level_m\n0,0\n")], key, &["l.csv:1", "`north_mps` is missing"]);
}

#[test]
fn notices_name_a_ship_too_long_for_the_waves_and_a_trough_without_water() {
    let notices = |depth: &str, lines: &str| -> Vec<String> {
        let text = COASTER.replace("depth = \"16 m\"", &format!("depth = \"{depth}\""));
        let scenario = good(&text, lines);
        let of_waves = scenario.notices.iter().filter(|notice| notice.key.contains("long_waves"));
        of_waves.map(|notice| notice.message.clone()).collect()
    };
    let [only] =
        &notices("16 m", "long_waves = { height = 0.2, period = 30, towards = 0, regular = true }")
            [..]
    else {
        panic!("one notice")
    };
    assert!(only.contains("a wave of 30 s is 3") && only.contains("more than a quarter"), "{only}");
    let [only] = &notices("6.5 m", "long_waves = { height = 1.2, period = 100, towards = 0 }")[..]
    else {
        panic!("one notice")
    };
    assert!(
        only.contains("1.20 m below the level of the tide, the water is 5.30 m deep"),
        "{only}"
    );
    assert!(notices("16 m", "long_waves = { height = 0.2, period = 100, towards = 0 }").is_empty());
}
