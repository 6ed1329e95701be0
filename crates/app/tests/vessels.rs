//! Vessels, tugs and lines in the results of a run.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use crate::support;

use std::collections::BTreeMap;

use support::{Workplace, contains_all};

/// A ship with two thrusters, a tug and two lines at a quay without fenders; the wind blows off it, and the
/// second line is far too weak.
const HARBOUR: &str = r#"
title = "A ship on two lines"

[time]
step = "0.5 s"
duration = "5 min"

[environment]
wind = { speed = "15 m/s", from = "90 deg" }
current = { speed = "0.2 m/s", towards = "180 deg" }

[vessel.coaster]
length_bp = "120 m"
beam = "18 m"
draught = "6 m"
block_coefficient = 0.7
propeller = { diameter = "4 m", full = "150 rpm" }
rudder = { area = "12 m^2", span = "4 m" }
thruster.bow = { along = "50 m", force = "80 kN", lag = "3 s" }
thruster.stern = { along = "-50 m", force = "40 kN", lag = "3 s" }
azimuth."drop-down" = { along = "40 m", force = "30 kN", diameter = "1.2 m" }
windage = { frontal_area = "250 m^2", lateral_area = "1500 m^2", centroid_height = "8 m", type = "ferry" }
stability = { gm = "1 m", gravity_above_keel = "7 m", waterplane_area = "1700 m^2" }

[body.ship]
vessel = "coaster"
outline = [[-60, -9], [45, -9], [60, 0], [45, 9], [-60, 9]]
position = [0, 0]

[body.quay]
fixed = true
outline = [[-150, 0], [150, 0], [150, 10], [-150, 10]]
position = [0, 14]

[tug."<b>one"]
vessel = "ship"
bollard_pull = "30 tf"
push_at = [30, -9]

[line.strong]
from = "ship"
fairlead = [50, 6]
to = "quay"
bollard = [80, 2]
rope = "hmpe"
break_load = "2000 kN"
pretension = "20 kN"

[line.weak]
from = "ship"
fairlead = [-55, 8]
to = "quay"
bollard = [-80, 2]
rope = "hmpe"
break_load = "40 kN"
pretension = "5 kN"

[[order]]
at = "10 s"
vessel = "ship"
rudder = "60 deg"

[[order]]
at = "20 s"
vessel = "ship"
thruster = { name = "stern", power = -0.5 }

[[order]]
at = "200 s"
vessel = "ship"
azimuth = { name = "drop-down", power = 0.4, direction = "-90 deg" }

[[order]]
at = "150 s"
tug = "<b>one"
push = "100 kN"
"#;

fn harbour(name: &str, text: &str, args: &[&str]) -> (Workplace, String) {
    let place = Workplace::new(name);
    place.write("harbour.toml", text.as_bytes());
    let run = place.run(&[&["run", "harbour.toml", "--allow-failures"], args].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    (place, run.stdout)
}

/// The rows of a table by column.
fn columns(place: &Workplace, name: &str) -> BTreeMap<String, Vec<String>> {
    let mut table =
        csv::Reader::from_path(place.path(&format!("out/harbour/{name}.csv"))).expect("csv");
    let names: Vec<String> = table.headers().expect("a header").iter().map(str::to_owned).collect();
    let mut columns: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for record in table.records() {
        for (name, text) in names.iter().zip(record.expect("a record").iter()) {
            columns.entry(name.clone()).or_default().push(text.to_owned());
        }
    }
    columns
}

fn numbers(texts: &[String]) -> Vec<f64> {
    texts.iter().map(|text| text.parse().expect("a number")).collect()
}

#[test]
fn a_vessel_s_forces_and_controls_are_written_for_each_step() {
    let (place, _) = harbour("vessel_tables", HARBOUR, &[]);
    let vessels = columns(&place, "vessels");
    assert_eq!(vessels["vessel"].len(), 600);
    // The order stands as it was given; the rudder stops at its stop of 35 degrees.
    let column = |name: &str| numbers(&vessels[name]);
    let last = |name: &str| *column(name).last().expect("a row");
    assert!((last("rudder_order_rad") - 60.0_f64.to_radians()).abs() < 1e-12);
    assert!((last("rudder_rad") - 35.0_f64.to_radians()).abs() < 1e-12);
    // Through the water she starts at the current's speed, the other way: she lies with her bow north.
    assert!((column("surge_through_water_mps")[0] - 0.2).abs() < 1e-12);
    // The wind comes over her starboard side, pushes her to port and heels her to port, until she swings.
    assert!(column("wind_sway_n")[..100].iter().all(|n| *n < 0.0));
    assert!(column("roll_rad")[..100].iter().all(|rad| *rad < 0.0));
    // A thruster that is half on to port gives half its force, less what speed takes.
    let thrusters = columns(&place, "thrusters");
    assert_eq!(thrusters["thruster"].len(), 1200);
    assert_eq!((&*thrusters["thruster"][0], &*thrusters["thruster"][1]), ("bow", "stern"));
    let power = numbers(&thrusters["thrust"]);
    assert!((power[1199] + 0.5).abs() < 1e-9 && power[1198] == 0.0);
    let given_n = column("thrusters_sway_n")[599];
    // From 200 s on an azimuth unit too pushes to port, with 0.4 of its 30 kN.
    let azimuths = columns(&place, "azimuths");
    assert_eq!(azimuths["azimuth"].len(), 600);
    assert_eq!((&*azimuths["azimuth"][0], &*azimuths["vessel"][0]), ("drop-down", "ship"));
    let last = |name: &str| *numbers(&azimuths[name]).last().expect("a row");
    assert!((last("power") - 0.4).abs() < 1e-9);
    assert!((last("direction_rad") + std::f64::consts::FRAC_PI_2).abs() < 1e-9);
    let unit_n = last("sway_n");
    assert!((-14e3..=-10e3).contains(&unit_n), "{unit_n}");
    let tunnels_n = given_n - unit_n;
    assert!((-20e3..=-15e3).contains(&tunnels_n), "{tunnels_n}");
}

#[test]
fn a_parted_line_and_a_pushing_tug_are_reported() {
    let (place, printed) = harbour("lines_and_tugs", HARBOUR, &[]);
    let summary = place.json("out/harbour/summary.json");
    let [strong, weak] = [0, 1].map(|k| &summary["lines"][k]);
    assert_eq!((&weak["verdict"], &weak["parted"]), (&"parted".into(), &true.into()));
    assert_eq!(strong["parted"], false);
    assert!(weak["share_of_break_load"].as_f64() > Some(1.0), "{weak}");
    assert_eq!(weak["working_load_n"].as_f64(), Some(20e3));
    let row = printed.lines().find(|line| line.starts_with("weak")).expect("its row");
    assert!(row.ends_with("PARTED"), "{row}");

    // The table's largest tension is the summary's, but for the step in which it parted.
    let lines = columns(&place, "lines");
    let tensions = numbers(&lines["tension_n"]);
    let of_strong = lines["line"].iter().zip(&tensions).filter(|(name, _)| *name == "strong");
    let peak_n = of_strong.map(|(_, n)| *n).fold(0.0, f64::max);
    assert_eq!(strong["peak_tension_n"].as_f64(), Some(peak_n));

    // The tug begins after her delay and comes to what was ordered.
    let tugs = columns(&place, "tugs");
    let force_n = numbers(&tugs["force_n"]);
    assert!(force_n[299] == 0.0 && (force_n[599] - 100e3).abs() < 100.0, "{}", force_n[599]);
    assert_eq!(summary["tugs"][0]["name"], "<b>one");

    let counts = &summary["events"]["counts"];
    assert_eq!((&counts["line_parted"], &counts["order_clamped"]), (&1.into(), &1.into()));
    let told = summary["events"]["world"].as_array().expect("events");
    let parted = told.iter().find(|event| event["kind"] == "line_parted").expect("told");
    assert_eq!(parted["line"], "weak");
    assert_eq!(summary["vessels"][0]["vessel"], "coaster");
    let estimated = summary["vessels"][0]["estimated"].as_array().expect("a list");
    // By how much such estimates are off, by measure.
    let estimate = &summary["vessels"][0]["estimate"];
    assert_eq!(estimate["errors"].as_array().map(Vec::len), Some(4), "{estimate}");
    let wake = estimated.iter().find(|estimate| estimate["group"] == "wake").expect("the wake");
    assert_eq!((&wake["figures"]["w"], &wake["standing"]), (&"0.3000".into(), &"found".into()));
}

#[test]
fn the_report_has_only_the_sections_that_a_scenario_needs() {
    let (place, _) = harbour("vessel_report", HARBOUR, &[]);
    let report = place.text("out/harbour/report.html");
    contains_all(
        &report,
        &[
            "ESTIMATED",
            "How far these estimates are to be relied on",
            "advance at 35°: off by",
            "<h2>Vessels</h2>",
            "<h2>Tugs</h2>",
            "<h2>Mooring lines</h2>",
            "<h2>Orders</h2>",
            "wind 15 m/s (29.2 kn) from 090°",
            "current 0.2 m/s (0.4 kn) towards 180°",
            "PARTED",
            "Thruster stern, positive to starboard, ship",
            "rudder 60° to starboard",
        ],
    );
    assert!(!report.contains("NaN") && !report.contains("<b>one"));
    assert!(!report.contains("Distance to the line of the fenders"));
    let place = Workplace::new("no_vessels");
    assert_eq!(place.run(&["run", "tug.toml"]).code, 0);
    let report = place.text("out/tug/report.html");
    for word in ["<h2>Vessels", "<h2>Tugs", "<h2>Mooring", "<h2>Orders", "What happened", "Lines:"]
    {
        assert!(!report.contains(word), "{word}");
    }
    let files = place.files("out/tug");
    for name in ["vessels.csv", "thrusters.csv", "azimuths.csv", "tugs.csv", "lines.csv"] {
        assert!(!files.iter().any(|file| file == name), "{files:?}");
    }
}

#[test]
fn a_vessel_on_the_seabed_is_reported_aground() {
    let shallow = HARBOUR.replace("[environment]\n", "[environment]\ndepth = \"5.8 m\"\n");
    let (place, printed) = harbour("aground", &shallow, &[]);
    contains_all(&printed, &["verdict: AGROUND", "ship was aground from 0.0 s for 300.0 s"]);
    let summary = place.json("out/harbour/summary.json");
    assert_eq!(summary["vessels"][0]["aground_s"].as_f64(), Some(300.0));
    contains_all(&place.text("out/harbour/report.html"), &["ship was aground"]);
}

#[test]
fn the_same_run_writes_the_same_bytes_also_with_vessels() {
    let (one, _) = harbour("vessel_bytes_1", HARBOUR, &[]);
    let (two, _) = harbour("vessel_bytes_2", HARBOUR, &[]);
    for name in one.files("out/harbour") {
        let path = format!("out/harbour/{name}");
        assert!(one.read(&path) == two.read(&path), "{name}");
    }
}

#[test]
fn both_formats_have_the_same_tables() {
    let (place, _) = harbour("vessel_parquet", HARBOUR, &["--format", "parquet"]);
    let files = place.files("out/harbour");
    for name in ["vessels", "thrusters", "azimuths", "tugs", "lines"] {
        assert!(files.contains(&format!("{name}.parquet")), "{files:?}");
    }
}

/// Squat, what it leaves under the keel, and a bank's pull: in the tables, the summary, the report and `check`.
#[test]
fn squat_and_a_bank_are_reported_with_their_standing() {
    let canal = HARBOUR
        .replace(
            "[environment]\n",
            "[environment]\ndepth = \"7 m\"\nbank = [{ from = [-900, 40], to = [900, 40] }]\n",
        )
        .replace("position = [0, 0]", "position = [0, -60]\nvelocity = { surge = \"6 kn\" }");
    let without_lines = canal.find("[line.strong]").expect("lines");
    let orders = canal.find("[[order]]").expect("orders");
    let canal = format!("{}{}", &canal[..without_lines], &canal[orders..]);
    let (place, _) = harbour("canal", &canal, &[]);
    let vessels = columns(&place, "vessels");
    let column = |name: &str| numbers(&vessels[name]);
    let squat = column("squat_m");
    // ICORELS at 6 kn and the current's 0.2 m/s against her, by hand: 2.4 ∇/L² Fh²/√(1 − Fh²).
    let square = (6.0 * 1852.0 / 3600.0 + 0.2_f64).powi(2) / (9.80665 * 7.0);
    let by_hand_m = 2.4 * 0.7 * 18.0 * 6.0 / 120.0 * square / (1.0 - square).sqrt();
    assert!((squat[0] - by_hand_m).abs() < 1e-9, "{} {by_hand_m}", squat[0]);
    // The bank is to starboard: it draws her there and turns her bow away.
    assert!(column("banks_sway_n")[0] > 0.0 && column("banks_yaw_nm")[0] < 0.0);
    let vessel = &place.json("out/harbour/summary.json")["vessels"][0];
    let peak_m = squat.iter().copied().fold(0.0, f64::max);
    assert_eq!(vessel["peak_squat_m"].as_f64(), Some(peak_m));
    assert_eq!(vessel["min_under_keel_clearance_m"].as_f64(), Some(7.0 - 6.0 - peak_m));
    let report = place.text("out/harbour/report.html");
    contains_all(
        &report,
        &[
            "UNVALIDATED",
            "Norrbin",
            "minimum under-keel clearance",
            "by ICORELS",
            "Squat, ship",
            "wind coefficients by Blendermann 1994",
            "bank (the pull of a bank is unvalidated)",
        ],
    );
    let check = place.run(&["check", "harbour.toml"]);
    contains_all(&check.stderr, &["bank suction is UNVALIDATED"]);
}

/// A file beside the scenario, and a mistake in it: told at its line, nothing written.
#[test]
fn a_file_of_currents_is_read_beside_the_scenario() {
    let by_file = HARBOUR
        .replace("{ speed = \"0.2 m/s\", towards = \"180 deg\" }", "{ file = \"stream.csv\" }");
    let place = Workplace::new("stream");
    place.write("harbour.toml", by_file.as_bytes());
    let missing = place.run(&["check", "harbour.toml"]);
    assert_eq!(missing.code, 2);
    contains_all(&missing.stderr, &["`environment.current.file`: cannot read", "stream.csv"]);
    place.write("stream.csv", b"t_s,north_mps,east_mps\n0,-0.2,0\n300,nan,0\n");
    let broken = place.run(&["run", "harbour.toml", "--allow-failures"]);
    assert_eq!(broken.code, 2);
    contains_all(&broken.stderr, &["stream.csv:3:5", "`north_mps` is not a finite number"]);
    place.write("stream.csv", b"t_s,north_mps,east_mps\n0,-0.2,0\n300,-0.4,0\n");
    assert_eq!(place.run(&["run", "harbour.toml", "--allow-failures"]).code, 0);
    let report = place.text("out/harbour/report.html");
    contains_all(&report, &["current 0.4 m/s (0.8 kn) towards 180°, the fastest of a table"]);
}
