//! Fenders and energy in the results of a run: the laws that the tables must obey, and what a user is
//! told.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use crate::support;

use std::collections::BTreeMap;

use support::{Workplace, contains_all};

/// The rows of a table; a field that is no number is NaN.
struct Rows {
    names: Vec<String>,
    rows: Vec<(Vec<String>, Vec<f64>)>,
}

impl Rows {
    fn read(place: &Workplace, name: &str) -> Rows {
        let mut table = csv::Reader::from_path(place.path(name)).expect("csv");
        let names = table.headers().expect("a header").iter().map(str::to_owned).collect();
        let rows = table.records().map(|record| {
            let record = record.expect("a record");
            let texts: Vec<String> = record.iter().map(str::to_owned).collect();
            let numbers = texts.iter().map(|text| text.parse().unwrap_or(f64::NAN)).collect();
            (texts, numbers)
        });
        Rows { names, rows: rows.collect() }
    }

    fn index(&self, name: &str) -> usize {
        self.names.iter().position(|n| n == name).unwrap_or_else(|| panic!("no column {name}"))
    }

    fn column(&self, name: &str) -> Vec<f64> {
        let index = self.index(name);
        self.rows.iter().map(|(_, numbers)| numbers[index]).collect()
    }

    fn texts(&self, name: &str) -> Vec<&str> {
        let index = self.index(name);
        self.rows.iter().map(|(texts, _)| texts[index].as_str()).collect()
    }

    fn sum(&self, name: &str) -> f64 {
        self.column(name).iter().sum()
    }
}

/// Runs the berth with these arguments and hands back its folder.
fn berth(name: &str, args: &[&str]) -> Workplace {
    let place = Workplace::new(name);
    let run = place.run(&[&["run", "berth.toml", "--allow-failures"], args].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    place
}

#[test]
fn the_energies_add_up_at_every_time() {
    for (name, args) in [
        ("balance_coupled", &[][..]),
        ("balance_large_step", &["--step", "1 s"][..]),
        ("balance_rk4", &["--set", "time.integrator=rk4"][..]),
    ] {
        let place = berth(name, args);
        let energy = Rows::read(&place, "out/berth/energy.csv");
        let column = |name: &str| energy.column(name);
        let parts = [
            "stored_j",
            "shear_stored_j",
            "hysteresis_j",
            "damping_j",
            "restitution_j",
            "friction_j",
            "contact_residual_j",
        ];
        let parts = parts.map(column);
        let (kinetic, loads, residual) =
            (column("kinetic_j"), column("load_work_j"), column("residual_j"));
        // ½ · 20 000 t · 1.5 · (0.2 m/s)² before the first step.
        assert!((kinetic[0] - 600e3).abs() < 1e-6, "{}", kinetic[0]);
        for k in 0..kinetic.len() {
            let taken_j: f64 = parts.iter().map(|part| part[k]).sum();
            let off_j = kinetic[0] + loads[k] + residual[k] - kinetic[k] - taken_j;
            // Rounding of sums over some hundred steps.
            assert!(off_j.abs() < 1e-9 * kinetic[0], "{name}, row {k}: {off_j} J");
        }
        // The works in the table of contacts are those of the ledger.
        let contacts = Rows::read(&place, "out/berth/contacts.csv");
        let work_j = contacts.sum("normal_work_j") + contacts.sum("tangential_work_j");
        let taken_j: f64 = parts.iter().map(|part| part[part.len() - 1]).sum();
        assert!((work_j + taken_j).abs() < 1e-9 * kinetic[0], "{name}: {work_j} and {taken_j}");
    }
}

#[test]
fn the_ledger_has_the_times_of_the_bodies() {
    let place = berth("energy_times", &[]);
    let energy = Rows::read(&place, "out/berth/energy.csv");
    let bodies = Rows::read(&place, "out/berth/bodies.csv");
    let of_ship = bodies.texts("body").iter().map(|name| *name == "ship").collect::<Vec<_>>();
    let (u, v, r) = (bodies.column("u_mps"), bodies.column("v_mps"), bodies.column("r_radps"));
    let times = bodies.texts("t_s");
    let rows = (0..of_ship.len()).filter(|k| of_ship[*k]);
    let (kinetic, at) = (energy.column("kinetic_j"), energy.texts("t_s"));
    assert_eq!(kinetic.len(), 601);
    for (index, k) in rows.enumerate() {
        assert_eq!(times[k], at[index]);
        // ½ m u² and so on, with the scenario's added mass.
        let mass_kg = 20e6;
        let by_hand_j = 0.5
            * mass_kg
            * (1.05 * u[k] * u[k] + 1.5 * v[k] * v[k] + 1.5 * 45.0 * 45.0 * r[k] * r[k]);
        assert!((kinetic[index] - by_hand_j).abs() < 1e-9 * kinetic[0], "row {index}");
    }
}

#[test]
fn a_normal_force_is_the_sum_of_its_parts() {
    for (name, args) in [
        ("parts_coupled", &["--step", "0.5 s"][..]),
        ("parts_damped", &["--set", "material.facing.damping=200 kN.s/m^2"][..]),
    ] {
        let place = berth(name, args);
        let contacts = Rows::read(&place, "out/berth/contacts.csv");
        let column = |name: &str| contacts.column(name);
        let parts = ["spring_n", "stop_n", "damper_n", "limiter_n"].map(column);
        let [spring, stop, damper, limiter] = &parts;
        for (k, normal_n) in column("normal_force_n").into_iter().enumerate() {
            let sum_n = spring[k] + stop[k] + damper[k] - limiter[k];
            // Rounding, beside the largest part: a force of nothing is a difference.
            assert!((sum_n - normal_n).abs() < 1e-9 * (spring[k] + stop[k] + 1.0), "{name} {k}");
        }
    }
}

#[test]
fn the_tables_know_each_fender_by_name_and_agree_with_the_summary() {
    let place = berth("fender_tables", &[]);
    let fenders = Rows::read(&place, "out/berth/fenders.csv");
    assert_eq!(
        fenders.names,
        [
            "t_s",
            "fender",
            "deflection_m",
            "peak_deflection_m",
            "reaction_n",
            "peak_reaction_n",
            "stored_j",
            "hull_pressure_npm2"
        ]
    );
    let mut peaks: BTreeMap<&str, f64> = BTreeMap::new();
    let reactions = fenders.column("peak_reaction_n");
    for (name, reaction_n) in fenders.texts("fender").into_iter().zip(&reactions) {
        let peak = peaks.entry(name).or_default();
        *peak = peak.max(*reaction_n);
    }
    assert_eq!(peaks.keys().copied().collect::<Vec<_>>(), ["large", "small one"]);
    let summary = place.json("out/berth/summary.json");
    let told = summary["fenders"].as_array().expect("fenders");
    let names: Vec<_> = told.iter().map(|fender| fender["name"].as_str()).collect();
    // In the order of the scenario; the third was not touched.
    assert_eq!(names, [Some("small one"), Some("large")]);
    for fender in told {
        let name = fender["name"].as_str().expect("a name");
        assert_eq!(fender["peak_reaction_n"].as_f64(), Some(peaks[name]), "{name}");
    }
    let contacts = Rows::read(&place, "out/berth/contacts.csv");
    let named = contacts.texts("fender");
    assert!(named.contains(&"large") && named.contains(&"small one"), "{named:?}");
    // Pressure is force over the face: 3 m by 4 m.
    let pressures = fenders.column("hull_pressure_npm2");
    for (k, name) in fenders.texts("fender").into_iter().enumerate() {
        if name == "large" {
            assert!((pressures[k] - reactions[k] / 12.0).abs() < 1e-9 * reactions[k].max(1.0));
        }
    }
}

#[test]
fn a_failed_fender_is_reported_and_ends_with_exit_code_1_and_whole_results() {
    let place = Workplace::new("failed_fender");
    let run = place.run(&["run", "berth.toml"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    contains_all(&run.stderr, &["error: fender failed", "--allow-failures"]);
    let failed = run.stdout.lines().find(|line| line.starts_with("small one"));
    assert!(failed.is_some_and(|line| line.ends_with("FAILED")), "{}", run.stdout);
    contains_all(&run.stdout, &["verdict: FENDER FAILED", "Fender small one was compressed"]);
    let large = run.stdout.lines().find(|line| line.starts_with("large")).expect("its line");
    assert!(!large.contains("FAILED"), "{large}");

    let summary = place.json("out/berth/summary.json");
    let [small, large] = [0, 1].map(|index| &summary["fenders"][index]);
    assert_eq!((&small["verdict"], &small["failed"]), (&"failed".into(), &true.into()));
    assert_eq!((&large["verdict"], &large["failed"]), (&"ok".into(), &false.into()));
    assert!(small["share_of_rated_deflection"].as_f64() > Some(1.0), "{small}");
    assert!(large["share_of_hull_pressure"].is_f64() && small["share_of_hull_pressure"].is_null());
    contains_all(small["designation"].as_str().expect("a type"), &["cone"]);
    let counts = &summary["events"]["counts"];
    assert_eq!(
        (&counts["fender_rating_exceeded"], &counts["fender_failed"]),
        (&1.into(), &1.into())
    );
    let first = summary["events"]["first"].as_array().expect("events");
    let failure = first.iter().find(|event| event["kind"] == "fender_failed").expect("told");
    assert_eq!(failure["fender"], "small one");

    let report = place.text("out/berth/report.html");
    contains_all(
        &report,
        &["Fender failed", "Fender small one was compressed", "not touched", "rating given"],
    );
}

#[test]
fn the_report_lists_the_most_used_of_many_fenders_and_counts_the_others() {
    let place = Workplace::new("many_fenders");
    let mut berth = support::BERTH.to_owned();
    for k in 0..44 {
        let north_m = 1.5 * f64::from(k) - 33.0;
        berth += &format!(
            "[fender.\"row {k}\"]\non = \"quay\"\nposition = [{north_m}, 0]\nfacing = \"-90 deg\"\n\
             width = \"1 m\"\nprojection = \"2 m\"\nmaterial = \"facing\"\nstiffness = \"500 kN/m\"\n\
             rated_deflection = \"1 m\"\n"
        );
    }
    place.write("berth.toml", berth.as_bytes());
    let run = place.run(&["run", "berth.toml", "--allow-failures"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stdout, &["and 34 more fenders, in summary.json"]);
    let told = place.json("out/berth/summary.json")["fenders"].as_array().map(Vec::len);
    assert_eq!(told, Some(46));
    let report = place.text("out/berth/report.html");
    contains_all(
        &report,
        &[
            "The table has the 40 most used of 47",
            "The 16 most used of 46",
            "The 8 fenders with the largest reactions",
        ],
    );
    assert!(!report.contains("NaN"));
}

#[test]
fn the_berthing_energy_by_formula_is_beside_that_of_the_run() {
    let place = berth("berthing", &[]);
    let summary = place.json("out/berth/summary.json");
    let berthing = &summary["berthing"];
    let number = |value: &serde_json::Value| value.as_f64().expect("a number");
    // Vasco Costa: 1 + 2D/B.
    let cm = number(&berthing["added_masses"]["vasco_costa"]);
    assert!((cm - (1.0 + 2.0 * 6.0 / 30.0)).abs() < 1e-12, "{cm}");
    let speed_mps = number(&berthing["speed_mps"]);
    let ce = number(&berthing["eccentricity"]);
    let by_hand_j = 0.5 * 20e6 * speed_mps * speed_mps * cm * ce;
    let energy_j = number(&berthing["energies_j"]["vasco_costa"]);
    assert!((energy_j / by_hand_j - 1.0).abs() < 1e-12, "{energy_j} and {by_hand_j}");
    contains_all(&place.text("out/berth/report.html"), &["Vasco Costa", "no conformity"]);
    let run = place.run(&[
        "run",
        "berth.toml",
        "--allow-failures",
        "--set",
        "berthing.abnormal_factor=1.5",
    ]);
    contains_all(
        &run.stdout,
        &[
            "berthing: ",
            " kJ by the formula (",
            " kJ abnormal), on ",
            " with the speed at the first touch, ",
            " by PIANC 2002 and Ce ",
            "in the run the fenders took ",
            " by UFC 4-152-01",
            " of the run: 1 + ",
            ", her added mass in sway over her displacement",
            "it differs from the formula's: the run has the added mass of the ship in the scenario",
        ],
    );
    contains_all(
        &place.text("out/berth/report.html"),
        &[" % of the rated energy of one fender. This fender is ", "Abnormal energy by formula"],
    );
}

#[test]
fn a_scenario_without_fenders_has_no_empty_sections() {
    let place = Workplace::new("no_fenders");
    let run = place.run(&["run", "tug.toml"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(!run.stdout.contains("fender"), "{}", run.stdout);
    let report = place.text("out/tug/report.html");
    for word in ["<h2>Fenders", "<h2>Berthing", "Fenders:", "Reactions of the fenders"] {
        assert!(!report.contains(word), "{word}");
    }
    let summary = place.json("out/tug/summary.json");
    assert_eq!(summary["fenders"], serde_json::json!([]));
    assert!(summary.get("berthing").is_none());
}

#[test]
fn untouched_fenders_are_reported_as_such() {
    let place = berth("untouched", &["--duration", "1 s"]);
    let fenders = Rows::read(&place, "out/berth/fenders.csv");
    assert!(fenders.rows.is_empty());
    let report = place.text("out/berth/report.html");
    contains_all(&report, &["None of the 3 fenders was touched", "nothing to compare"]);
    assert!(!report.contains("NaN"));
}

#[test]
fn a_fender_s_name_cannot_put_markup_into_the_report() {
    let place = Workplace::new("fender_markup");
    let evil = support::BERTH.replace("\"small one\"", "\"<img src=x onerror=alert(1)>\"");
    place.write("evil.toml", evil.as_bytes());
    let run = place.run(&["run", "evil.toml", "--allow-failures"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let report = place.text("out/evil/report.html");
    assert!(!report.contains("<img") && !report.contains("NaN") && !report.contains("inf\""));
}
