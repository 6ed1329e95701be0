//! Other programs that put forces on bodies: one that works, and those that do not.

use crate::support;

use std::path::Path;
use std::process::Command;

use support::{Workplace, contains_all};

/// Whether there is a Python 3; continuous integration must have one.
fn has_python() -> bool {
    let found = Command::new("python3").arg("--version").output().is_ok_and(|o| o.status.success());
    assert!(found || std::env::var_os("CI").is_none(), "python3 is missing in CI");
    if !found {
        println!("skipped: python3 is missing");
    }
    found
}

/// A body with a provider that is this Python program.
fn with_provider(name: &str, program: &str, timings: &str) -> Workplace {
    let place = Workplace::new(name);
    place.write("provider.py", program.as_bytes());
    let scenario = format!(
        r#"
title = "A provider"

[time]
step = "0.5 s"
duration = "20 s"

[body.ship]
outline = [[-45, -7], [45, -7], [45, 7], [-45, 7]]
mass = "4200 t"
gyradius = "22 m"
velocity = {{ surge = "1 m/s" }}

[[provider]]
body = "ship"
command = ["python3", "provider.py"]
{timings}
"#
    );
    place.write("case.toml", scenario.as_bytes());
    place
}

/// Answers 42 kN forward, but for what `instead` does to question n.
fn program(instead: &str) -> String {
    format!(
        r#"
import json, sys, time
sys.stdin.readline()
for line in sys.stdin:
    n = json.loads(line)["n"]
    force = 42e3
    moment = 0
    {instead}
    print(json.dumps({{"n": n, "body_force_n": [force, 0], "moment_nm": moment}}), flush=True)
"#
    )
}

/// Runs the case and hands back its summary and what was printed.
fn outcome(place: &Workplace) -> (serde_json::Value, String) {
    let run = place.run(&["run", "case.toml"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(!place.text("out/case/bodies.csv").contains("NaN"));
    (place.json("out/case/summary.json"), run.stdout)
}

/// What half a step of 0.5 s with the force adds to the speed: velocities are of the middle of a step, so that the first
/// step adds half (m/s).
const HALF_KICK_MPS: f64 = 0.0025;

/// Speed ahead at the end (m/s): 1 m/s and 0.01 m/s² for the 20 s.
fn speed_mps(summary: &serde_json::Value) -> f64 {
    summary["bodies"][0]["final"]["u_mps"].as_f64().expect("a speed")
}

#[test]
fn the_example_in_python_drags_a_ship_with_its_current() {
    if !has_python() {
        return;
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let place = Workplace::new("provider_example");
    for name in ["examples/provider/drag.py", "scenarios/provider/drag_in_python.toml"] {
        place.write(name, &std::fs::read(root.join(name)).expect("it is in the repository"));
    }
    // With the same added mass both ways nothing turns her: each axis has a closed form.
    let same = ["--set", "body.coaster.added_mass.surge=0.7"];
    let run = place.run(&[&["run", "scenarios/provider/drag_in_python.toml"], &same[..]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(!run.stdout.contains("provider:"), "{}", run.stdout);
    let summary = place.json("out/drag_in_python/summary.json");
    assert_eq!(summary["events"]["counts"], serde_json::json!({}));
    // w = w₀/(1 + k |w₀| t) for the speed w through the water with m ẇ = −c w|w|.
    let at = &summary["bodies"][0]["final"];
    let heading = 40.0_f64.to_radians();
    let (t_s, mass_kg) = (600.0, 4.2e6);
    let current = [0.5 * libm::cos(heading), -0.5 * libm::sin(heading)];
    let knot_mps = 1852.0 / 3600.0;
    for (key, start, drag, current) in
        [("u_mps", knot_mps, 4.0e4, current[0]), ("v_mps", 0.0, 8.0e5, current[1])]
    {
        let water: f64 = start - current;
        let k = drag / (1.7 * mass_kg);
        let right = current + water / (1.0 + k * water.abs() * t_s);
        let ours = at[key].as_f64().expect("a speed");
        // The force is held through steps of 0.5 s: 1e-3 of the speed through the water.
        assert!((ours - right).abs() < 1e-3 * water.abs(), "{key}: {ours}, {right}");
    }
}

#[test]
fn the_force_of_a_provider_that_dies_is_held_then_dropped_and_reported() {
    if !has_python() {
        return;
    }
    let dies = program("if n == 20: sys.exit(3)");
    let place = with_provider("provider_dies", &dies, "hold = \"2 s\"");
    let (summary, printed) = outcome(&place);
    let counts = &summary["events"]["counts"];
    let verdict = &summary["verdict"];
    assert_eq!(verdict["key"], "outside_data");
    let finding = &verdict["findings"][0];
    assert_eq!(finding["law"], "provider_silent");
    let text = finding["text"].as_str().expect("a text");
    assert!(text.contains(" did not reply: ") && text.ends_with(" of the run)"), "{text}");
    for kind in ["provider_died", "provider_held", "provider_dropped"] {
        assert_eq!(counts[kind], 1, "{summary}");
    }
    let told = summary["events"]["providers"].to_string();
    contains_all(&told, &["\"body\":\"ship\"", "\"t_s\":10.0", "exit status: 3"]);
    contains_all(&printed, &["ENDED before the run did", "DROPPED"]);
    // 20 steps with its force, 4 with the force held.
    let right = 1.0 + 0.01 * 24.0 * 0.5;
    assert!((speed_mps(&summary) + HALF_KICK_MPS - right).abs() < 1e-9, "{}", speed_mps(&summary));
}

#[test]
fn a_provider_that_answers_nan_is_ignored_after_its_timeouts() {
    if !has_python() {
        return;
    }
    let nan = program("if n >= 20: force = float(\"nan\")");
    let place = with_provider("provider_nan", &nan, "hold = \"2 s\"\ntimeout = \"2 s\"");
    let start = std::time::Instant::now();
    let (summary, _) = outcome(&place);
    // Three timeouts of the 20 steps, not all.
    assert!(start.elapsed().as_secs_f64() < 20.0, "{:?}", start.elapsed());
    let counts = &summary["events"]["counts"];
    assert_eq!((&counts["provider_held"], &counts["provider_dropped"]), (&1.into(), &1.into()));
    assert!((speed_mps(&summary) + HALF_KICK_MPS - 1.12).abs() < 1e-9, "{}", speed_mps(&summary));
}

#[test]
fn a_force_that_is_too_large_is_refused() {
    if !has_python() {
        return;
    }
    let place = with_provider("provider_huge", &program("if n == 3: moment = 1e30"), "");
    let (summary, printed) = outcome(&place);
    let counts = &summary["events"]["counts"];
    assert_eq!((&counts["provider_refused"], &counts["provider_resumed"]), (&1.into(), &1.into()));
    contains_all(&printed, &["REFUSED", "answered again"]);
    assert!((speed_mps(&summary) + HALF_KICK_MPS - 1.2).abs() < 1e-9, "{}", speed_mps(&summary));
}

#[test]
fn a_provider_that_sleeps_and_reads_nothing_does_not_stop_the_run() {
    if !has_python() {
        return;
    }
    let place =
        with_provider("provider_sleeps", "import time\ntime.sleep(600)\n", "timeout = \"50 ms\"");
    // More questions than a pipe holds.
    let run = place.run(&["run", "case.toml", "--step", "0.01 s"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let summary = place.json("out/case/summary.json");
    assert_eq!(summary["events"]["counts"]["provider_held"], 1);
    assert!((speed_mps(&summary) - 1.0).abs() < 1e-12);
}

#[test]
fn a_provider_that_answers_again_is_used_again() {
    if !has_python() {
        return;
    }
    // Python alone may take a second to start where the machine is busy: that must not count as late.
    let naps = program("if n == 5: time.sleep(6)");
    let place = with_provider("provider_naps", &naps, "timeout = \"4 s\"");
    let (summary, _) = outcome(&place);
    let counts = &summary["events"]["counts"];
    assert_eq!((&counts["provider_held"], &counts["provider_resumed"]), (&1.into(), &1.into()));
    assert!(counts.get("provider_dropped").is_none(), "{counts}");
    // Held through the nap, so that nothing is missing.
    assert!((speed_mps(&summary) + HALF_KICK_MPS - 1.2).abs() < 1e-9, "{}", speed_mps(&summary));
}

#[test]
fn a_provider_that_cannot_be_started_is_reported_with_its_command() {
    let place = with_provider("provider_missing", "", "");
    let text = place.text("case.toml").replace("python3", "no-such-program-at-all");
    place.write("case.toml", text.as_bytes());
    let run = place.run(&["run", "case.toml"]);
    assert_eq!(run.code, 1);
    contains_all(&run.stderr, &["no-such-program-at-all provider.py"]);
    assert!(!place.exists("out/case/summary.json"));
}
