//! The approach of a ship, normal and abnormal, from one file.

use crate::support;

use support::{BERTH, Workplace, contains_all};

/// The berth of the other tests, with her start given as an approach.
fn scenario() -> String {
    let mut text = String::new();
    let mut is_ship = false;
    for line in BERTH.lines() {
        if line.starts_with('[') {
            is_ship = line == "[body.ship]";
        }
        let is_start = ["position", "heading", "velocity"].iter().any(|key| line.starts_with(key));
        if !(is_ship && is_start) {
            text += line;
            text.push('\n');
        }
        if line == "[body.ship]" {
            text +=
                "approach = { to = \"quay\", speed_normal = \"0.2 m/s\", contact = \"midship\" }\n";
        }
    }
    text
}

#[test]
fn the_normal_and_the_abnormal_case_come_from_one_file() {
    let place = Workplace::new("approach");
    place.write("ship.toml", scenario().as_bytes());
    let checked = place.run(&["check", "ship.toml"]);
    assert_eq!(checked.code, 0, "{}", checked.stderr);
    contains_all(
        &checked.stdout,
        &["ship meets quay, fender", "of midship at 0.200 m/s and 0.0°", "ship starts at ["],
    );
    place.run(&["run", "ship.toml", "--out", "normal", "--allow-failures"]);
    assert_eq!(place.json("normal/summary.json")["approaches"][0]["abnormal"], false);

    let factor = "body.ship.approach.abnormal.energy_factor=1.44";
    let run =
        place.run(&["run", "ship.toml", "--out", "abnormal", "--allow-failures", "--set", factor]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stdout, &["at 0.240 m/s", "abnormal berthing: 1.44 times the energy"]);
    contains_all(
        &place.text("abnormal/report.html"),
        &["Abnormal berthing.", "1.44 times the energy"],
    );
    let approach = &place.json("abnormal/summary.json")["approaches"][0];
    assert_eq!(approach["energy_factor"], 1.44);
    assert!((approach["speed_mps"].as_f64().expect("a number") - 0.24).abs() < 1e-12);
    assert_eq!(approach["normal_berthing_speed_mps"], 0.2);
}
