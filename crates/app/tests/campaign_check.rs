//! `fenderline check` of a campaign: what can be known before its first run.

use crate::support;

use serde_json::Value;
use support::{TUG, Workplace, contains_all};

const CAMPAIGN: &str = r#"
scenario = "tug.toml"
number = 200
seed = 7
[variable.speed]
key = "body.tug.velocity.surge"
distribution = "uniform"
lower = "0.2 m/s"
upper = "1.2 m/s"
"#;

fn place(name: &str, campaign: &str) -> Workplace {
    let place = Workplace::new(name);
    place.write("tug.toml", TUG.as_bytes());
    place.write("speeds.toml", campaign.as_bytes());
    place
}

#[test]
fn a_good_campaign_is_described_and_nothing_is_written() {
    let place = place("check_campaign", CAMPAIGN);
    let run = place.run(&["check", "speeds.toml"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let described = ["speeds.toml: good", "seed 7", "200 cases of 100 time steps of 0.1 s"];
    contains_all(&run.stdout, &described);
    contains_all(&run.stdout, &["speed: 0.20", "to 1.19", "m/s", "uniform", "columns"]);
    assert_eq!(run.stderr, "");
    assert!(!place.path("out").exists());
    let json: Value =
        serde_json::from_str(&place.run(&["check", "speeds.toml", "--json"]).stdout).expect("JSON");
    assert_eq!((&json["good"], &json["cases"]), (&Value::Bool(true), &Value::from(200)));
    assert_eq!(json["variables"][0]["unit"], "m/s");
    let names: Vec<&str> =
        json["columns"].as_array().unwrap().iter().map(|c| c["name"].as_str().unwrap()).collect();
    assert!(names.contains(&"speed") && names.contains(&"reaction"), "{names:?}");
}

/// Some draws make no scenario: the campaign would give rows with a reason, and the check says so before.
#[test]
fn cases_that_cannot_start_are_counted_with_their_line() {
    let campaign = CAMPAIGN.replace("body.tug.velocity.surge", "body.tug.gyradius");
    let campaign =
        campaign.replace(" m/s\"", " m\"").replace("0.2 m", "-1 m").replace("1.2 m", "9 m");
    let place = place("check_campaign_cases", &campaign);
    let run = place.run(&["check", "speeds.toml"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(
        &run.stderr,
        &["a case cannot start", "gyradius", "speeds.toml:7", "of 200, first in case"],
    );
    let strict = place.run(&["check", "speeds.toml", "--strict"]);
    assert_eq!(strict.code, 2, "{}", strict.stderr);
    let json: Value =
        serde_json::from_str(&place.run(&["check", "speeds.toml", "--json"]).stdout).expect("JSON");
    assert_eq!(json["refused"].as_array().map(Vec::len), Some(1), "{}", json["refused"]);
    let refused = json["refused"][0]["cases"].as_u64().unwrap();
    // One in ten of the values is below zero.
    assert!((5..40).contains(&refused), "{refused}");
    assert_eq!(json["refused"][0]["line"], 7);
}

#[test]
fn mistakes_are_those_of_the_campaign_command() {
    for (from, to, words) in [
        ("velocity.surge", "velocity.serge", "serge"),
        ("tug.toml", "none.toml", "none.toml"),
        ("lower = \"0.2 m/s\"", "lower = \"2 m/s\"", "lower"),
        ("seed = 7", "seed = 7\nsuccess = \"reached\"", "`success`"),
        ("seed = 7", "seed = 7\nmost_steps = 50", "most_steps"),
    ] {
        let place = place("check_campaign_mistake", &CAMPAIGN.replace(from, to));
        let (check, run) =
            (place.run(&["check", "speeds.toml"]), place.run(&["campaign", "speeds.toml"]));
        assert_eq!((check.code, run.code), (2, 2), "{to}: {}", check.stderr);
        assert!(check.stderr.contains(words), "{}", check.stderr);
        assert_eq!(check.stderr, run.stderr);
        let json = place.run(&["check", "speeds.toml", "--json"]);
        let json: Value = serde_json::from_str(&json.stdout).expect("JSON");
        assert_eq!(json["good"], false);
    }
}

#[test]
fn changes_of_the_command_line_are_refused_for_a_campaign() {
    let place = place("check_campaign_set", CAMPAIGN);
    let run = place.run(&["check", "speeds.toml", "--set", "time.step=0.2 s"]);
    assert_eq!(run.code, 2);
    assert!(run.stderr.contains("`set = [\"KEY=VALUE\"]`"), "{}", run.stderr);
}
