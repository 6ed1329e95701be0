//! `fenderline statistics`: from a file of berthing speeds to a design value.

use crate::support;

use support::{Workplace, contains_all};

/// 200 speeds, drawn from a log-normal distribution.
const SPEEDS: &str = include_str!("../../../campaigns/berthing_speeds.csv");

#[test]
fn a_file_of_speeds_gives_a_design_value_with_its_band() {
    let place = Workplace::new("statistics");
    place.write("speeds.csv", SPEEDS.as_bytes());
    let run = place.run(&[
        "statistics",
        "speeds.csv",
        "--column",
        "speed",
        "--per-year",
        "60",
        "--return-period",
        "50",
        "--life",
        "50",
        "--threshold",
        "8",
        "--out",
        "speeds",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(
        &run.stdout,
        &[
            "speed of speeds.csv: 200 values",
            "for 60 berthings a year",
            "50 years: 1 in 2970 berthings",
            "beyond the data",
            "log-normal          28.5",
            "10 % in 50 years",
            "GPD over threshold",
            "in speeds: statistics.html, statistics.json",
        ],
    );
    let page = place.text("speeds/statistics.html");
    contains_all(
        &page,
        &[
            "<svg",
            "Design values",
            "Fits",
            "10⁻⁴",
            "the designer must judge whether they meet a guideline",
        ],
    );
    assert!(!page.contains("NaN"));
    let again = ["statistics", "speeds.csv", "--column", "speed [cm/s]", "--json"];
    let json: serde_json::Value = serde_json::from_str(&place.run(&again).stdout).unwrap();
    assert_eq!(json["count"], 200);
    assert_eq!(json["unit"], "cm/s");
    // Without a number of berthings a year: values of one berthing of 100, 1,000 and 3,000.
    let value = json["design_values"][2]["fits"]["lognormal"]["value"].as_f64().unwrap();
    assert!((value - 28.55).abs() < 0.01, "{value}");
    assert!(json["design_values"][2]["data"]["value"].is_null());
}

#[test]
fn the_columns_of_a_table_are_listed() {
    let place = Workplace::new("statistics_list");
    place.write("t.csv", b"speed [cm/s],ship\n1,a\n");
    let run = place.run(&["statistics", "t.csv"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.starts_with("speed [cm/s]\nship\n"), "{}", run.stdout);
    assert!(place.run(&["statistics", "t.csv", "--json"]).stdout.contains("\"unit\": \"cm/s\""));
}

#[test]
fn a_table_of_a_run_in_parquet_has_its_units() {
    let place = Workplace::new("statistics_parquet");
    place.write("berth.toml", support::BERTH.as_bytes());
    let run = place.run(&[
        "run",
        "berth.toml",
        "--out",
        "run",
        "--format",
        "parquet",
        "--allow-failures",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let run = place.run(&["statistics", "run/energy.parquet", "--column", "kinetic_j", "--json"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let json: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(json["unit"], "J");
}

#[test]
fn laws_that_the_data_speak_against_are_named() {
    let place = Workplace::new("statistics_remarks");
    // Two heaps: no law of one peak has them.
    let values = (0..300)
        .map(|i| if i % 3 == 0 { 90.0 + f64::from(i % 7) } else { 5.0 + f64::from(i % 11) });
    let lines: String = values.map(|value| format!("{value}\n")).collect();
    place.write("heaps.csv", format!("reaction (kN)\n{lines}").as_bytes());
    let command =
        ["statistics", "heaps.csv", "--column", "reaction", "--per-year", "100", "--out", "page"];
    let run = place.run(&command);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(
        &run.stdout,
        &[
            "Before a design value is used",
            "the data contradict",
            "mean nothing",
            "is rarer than 300 values can show",
        ],
    );
    contains_all(
        &place.text("page/statistics.html"),
        &["does not fit", "Before a design value is used:"],
    );
    assert_eq!(place.json("page/statistics.json")["fits"][0]["is_rejected"], true);
    // A negative speed.
    place.write("negative.csv", SPEEDS.replace("7.07", "-7.07").as_bytes());
    let run = place.run(&["statistics", "negative.csv", "--column", "speed"]);
    contains_all(&run.stdout, &["1 of 200 values are negative, the least −7.07"]);
}

#[test]
fn bad_input_is_refused_with_its_place() {
    let place = Workplace::new("statistics_bad");
    place.write("speeds.csv", SPEEDS.as_bytes());
    place.write("text.csv", b"speed\n7.1\nfast\n");
    place.write("few.csv", b"speed\n7.1\n");
    place.write("zero.csv", SPEEDS.replace("7.07", "0").as_bytes());
    place.write("bare.csv", b"7.1\n4.5\n");
    let refused = |arguments: &[&str], fragments: &[&str]| {
        let run = place.run(&[&["statistics"], arguments].concat());
        assert_eq!(run.code, 2, "{arguments:?}: {}", run.stdout);
        contains_all(&run.stderr, fragments);
    };
    let speed = ["speeds.csv", "--column", "speed"];
    let with = |more: &[&'static str]| [&speed, more].concat();
    refused(&["speeds.csv", "--column", "sped"], &["no column `sped`; did you mean `speed`?"]);
    refused(
        &["text.csv", "--column", "speed"],
        &["text.csv:3: column `speed`: `fast` is not a number"],
    );
    refused(
        &["few.csv", "--column", "speed"],
        &["few.csv: column `speed`: at least 2 values are needed, but there are 1"],
    );
    refused(&["bare.csv", "--column", "speed"], &["bare.csv:1", "must name the columns"]);
    refused(&["none.csv"], &["cannot read none.csv"]);
    refused(
        &["zero.csv", "--column", "speed", "--fit", "lognormal"],
        &["log-normal: the law has positive values only; 1 of the values are not positive"],
    );
    refused(
        &with(&["--per-year", "-3"]),
        &["--per-year: the number of berthings a year must be positive"],
    );
    refused(
        &with(&["--per-year", "60", "--return-period", "1"]),
        &["a return period must be a number of years above 1"],
    );
    refused(&with(&["--per-year", "60", "--life", "0"]), &["a lifetime must be a positive number"]);
    refused(&with(&["--return-period", "50"]), &["--per-year"]);
    refused(&with(&["--confidence", "95"]), &["such as 0.95"]);
    refused(&with(&["--fit", "gpd"]), &["--fit gpd needs --threshold"]);
    refused(
        &with(&["--fit", "weibull", "--threshold", "8"]),
        &["--threshold belongs to --fit gpd"],
    );
    refused(
        &with(&["--fit", "gpd", "--threshold", "1000"]),
        &["at least 20 values are needed, but there are 0"],
    );
    refused(&with(&["--fit", "gauss"]), &["`gauss` is no law; the laws are normal, lognormal"]);
    // A law that was not asked for by name is left out with its reason.
    let run = place.run(&["statistics", "zero.csv", "--column", "speed"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stdout, &["no fit: log-normal: the law has positive values only"]);
}
