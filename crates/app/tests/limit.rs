//! `fenderline limit`: the largest value of a key with which a run keeps its limits.

use crate::support;

use support::{Workplace, contains_all};

/// A ship alone in deep water, whose way in the run grows with her speed at the start.
const PASSED: &str = r#"
[time]
step = "1 s"
duration = "400 s"

[vessel.tanker]
length_bp = 243.5
beam = 39
draught = 15.3
block_coefficient = 0.8
rudder = { area = "60 m^2", span = "9 m" }
propeller = { diameter = "7 m", full = "90 rpm" }

[body.ship]
vessel = "tanker"
outline = [[-121.75, -19.5], [121.75, -19.5], [121.75, 19.5], [-121.75, 19.5]]

[statistics]

[limit.ahead]
of = "surge"
statistic = "maximum"
distance = "100 m"
"#;

#[test]
fn the_largest_speed_that_keeps_a_limit_is_found_by_bisection() {
    let place = Workplace::new("limit");
    place.write("passed.toml", PASSED.as_bytes());
    let args =
        ["limit", "passed.toml", "--key", "body.ship.velocity.surge", "--within", "0.1", "--json"];
    let run = place.run(&[&args[..], &["--from", "0.1 m/s", "--to", "5 m/s"]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let found: serde_json::Value = serde_json::from_str(&run.stdout).expect("JSON");
    let limit = found["limit"].as_f64().expect("a limit");
    assert!((0.1..5.0).contains(&limit), "{found}");
    let runs = found["runs"].as_array().expect("runs");
    // 4.9 m/s to 0.1 m/s: six halvings after both ends.
    assert_eq!(runs.len(), 8, "{found}");
    for run in runs {
        let is_within = run["value"].as_f64().expect("a value") <= limit;
        assert_eq!(run["within"], is_within, "{run}");
        let verdict = run["verdict"].as_str().expect("a verdict");
        assert_eq!(verdict == "limit_exceeded", !is_within, "{run}");
    }
    // As text, with the reason.
    let run = place.run(&[&args[..6], &["--from", "0.1 m/s", "--to", "5 m/s"]].concat());
    contains_all(
        &run.stdout,
        &["Limit ahead: surge of ship, maximum was", "Largest body.ship.velocity.surge within"],
    );
    // Nothing within, and all within.
    let run = place.run(&[&args[..6], &["--from", "4 m/s", "--to", "5 m/s"]].concat());
    assert_eq!(run.code, 1, "{}", run.stdout);
    contains_all(&run.stderr, &["4 m/s is beyond the limits already"]);
    let run = place.run(&[&args[..6], &["--from", "0.1 m/s", "--to", "0.2 m/s"]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stdout, &["Within all limits up to 0.2 m/s, the end of the range"]);
}

#[test]
fn ranges_that_are_none_are_refused() {
    let place = Workplace::new("limit_refused");
    place.write("passed.toml", PASSED.as_bytes());
    for (key, from, to, says) in [
        ("body.ship.velocity.surge", "x", "2 kn", "not a number with a unit"),
        ("body.ship.velocity.surge", "1 kn", "2 m/s", "the same unit"),
        ("body.ship.velocity.surge", "2 kn", "1 kn", "not below"),
        ("body.ship.velocity.surg", "1 kn", "2 kn", "did you mean"),
        ("body.ship.velocity.surge", "1 m", "2 m", "body.ship.velocity.surge"),
    ] {
        let run = place.run(&["limit", "passed.toml", "--key", key, "--from", from, "--to", to]);
        assert_eq!(run.code, 2, "{from}: {}", run.stdout);
        contains_all(&run.stderr, &[says]);
    }
}
