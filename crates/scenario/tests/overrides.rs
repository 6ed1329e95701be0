//! Keys set from the command line.

use std::path::Path;

use fenderline_contact::Wrench;
use fenderline_scenario::{Override, Place, Scenario, ScenarioError};
use fenderline_sim::{Setup, Simulation};

const TEXT: &str = r#"
[time]
step = "0.1 s"
duration = "20 s"

[material.paper]
stiffness = "500 kN/m^2"

[material.rubber]
stiffness = "5 kN/m^2"

[body.tug]
outline = [[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]
mass = "930 t"
gyradius = "8 m"

[body."old quay"]
fixed = true
outline = [[0, -50], [5, -50], [5, 50], [0, 50]]

[[pair]]
bodies = ["tug", "old quay"]
material = "paper"
"#;

fn with(settings: &[&str]) -> Result<Scenario, ScenarioError> {
    let overrides =
        settings.iter().map(|text| Override::parse(text)).collect::<Result<Vec<_>, _>>()?;
    Scenario::parse_with(TEXT, "x.toml", &overrides)
}

#[test]
fn values_are_toml_or_bare_words() {
    let setup = |settings: &[&str]| with(settings).unwrap().setup;
    assert_eq!(setup(&["time.step=0.5"]).step_s, 0.5);
    assert_eq!(setup(&["time.step=0.5 s"]).step_s, 0.5);
    assert_eq!(setup(&["time.step=\"500 ms\""]).step_s, 0.5);
    assert_eq!(setup(&[" time.step = 500 ms "]).step_s, 0.5);
    assert_eq!(setup(&["time.step=0.2", "time.step=0.5"]).step_s, 0.5);
    assert_eq!(setup(&["pair.0.material=rubber"]).pairs[0].material, 1);
    let tug = |settings: &[&str]| setup(settings).bodies[0].clone();
    assert_eq!(tug(&["body.tug.velocity.surge=36 km/h"]).velocity.surge_mps, 10.0);
    assert_eq!(tug(&["body.tug.velocity={surge=3}"]).velocity.surge_mps, 3.0);
    assert_eq!(tug(&["body.tug.position=[\"1 km\", 2]"]).position_m.x, 1000.0);
    assert_eq!(setup(&["body.\"old quay\".position=[1, 2]"]).bodies[1].position_m.x, 1.0);
    assert_eq!(with(&["title=Two tugs"]).unwrap().title, "Two tugs");
    assert_eq!(setup(&["load=[{body = \"tug\", moment = 1}]"]).loads[0].moment_nm, 1.0);
}

#[test]
fn new_bodies_come_last() {
    let quay = "{fixed = true, outline = [[0, 0], [1, 0], [1, 1]]}";
    let scenario = with(&[&format!("body.aaa={quay}")]).unwrap();
    let names: Vec<_> = scenario.setup.bodies.iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names, ["tug", "old quay", "aaa"]);
}

#[track_caller]
fn check_refused(setting: &str, key: Option<&str>, fragment: &str) {
    let error = with(&[setting]).expect_err(setting);
    let shown = error.to_string();
    assert_eq!(error.key(), key, "{shown}");
    assert_eq!(error.line(), None, "{shown}");
    assert_eq!(*error.place(), Place::Option { text: format!("--set {setting}") });
    assert!(shown.contains(fragment), "{shown}");
    assert!(shown.contains(&format!("\n --> --set {setting}")), "{shown}");
}

#[test]
fn mistakes_point_at_the_option() {
    check_refused("time.step=-1", Some("time.step"), "must be at least 1e-6 s, but is -1 s");
    check_refused("time.step=400", Some("time.step"), "is longer than `time.duration`");
    check_refused("time.step=4 kn", Some("time.step"), "is a speed [m/s]");
    check_refused("time.step=nan", Some("time.step"), "not a finite number");
    check_refused("time.stepp=1", Some("time.stepp"), "did you mean `step`?");
    check_refused("tiem.step=1", Some("tiem"), "did you mean `time`?");
    check_refused("body.tgu.mass=1", Some("body.tgu"), "did you mean `tug`?");
    check_refused("body.tug.velocity.surg=1", Some("body.tug.velocity.surg"), "`surge`");
    check_refused("body.tug.mass.kg=1", Some("body.tug.mass"), "no keys of its own");
    check_refused("body.tug=1", Some("body.tug"), "must be a table");
    check_refused("pair.1.material=paper", Some("pair.1"), "the file has 1 of `pair`");
    check_refused("pair.first.material=paper", Some("pair.first"), "numbered from 0");
    check_refused("pair.0.material=papper", Some("pair.0.material"), "did you mean \"paper\"?");
    check_refused("load.0.moment=1", Some("load"), "the file has no `load`");
    check_refused("contact.method=papr", Some("contact.method"), "did you mean \"paper\"?");
    check_refused("time.step", None, "there is no `=`");
    check_refused("time..step=1", None, "is not a key");
    check_refused("=1", None, "is not a key");
    check_refused("time.step=", Some("time.step"), "there is no value");
    check_refused("time.step=[1", None, "the value is not TOML");
    check_refused("body.tug.outline=[[0, 0], [1, 1]]", Some("body.tug.outline"), "");
}

#[test]
fn shorthands_are_named_as_the_user_wrote_them() {
    let step = Override::new("--step -1", "time.step", "-1").unwrap();
    let error = Scenario::parse_with(TEXT, "x.toml", &[step]).unwrap_err();
    assert_eq!(error.place().to_string(), "--step -1");
}

#[test]
fn mistakes_of_the_file_still_point_at_the_file() {
    let step = Override::parse("time.step=1").unwrap();
    let text = TEXT.replace("930 t", "0 t");
    let error = Scenario::parse_with(&text, "x.toml", &[step]).unwrap_err();
    assert_eq!(error.line(), Some(14));
}

#[test]
fn an_override_can_mend_the_file() {
    let step = Override::parse("time.step=1").unwrap();
    let text = TEXT.replace("0.1 s", "-0.1 s");
    assert!(Scenario::parse_with(&text, "x.toml", &[step]).is_ok());
}

/// The scenarios of the repository that need no other file, with their names.
fn scenarios() -> Vec<(String, String)> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios")];
    let mut found = vec![];
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "toml") {
                found.push((path.display().to_string(), std::fs::read_to_string(path).unwrap()));
            }
        }
    }
    found.sort();
    found
}

fn overrides(settings: &[String]) -> Vec<Override> {
    settings.iter().map(|text| Override::parse(text).unwrap()).collect()
}

/// Settings of the start of each body, and of the environment.
fn starts(setup: &Setup) -> Vec<Vec<String>> {
    let mut all: Vec<Vec<String>> = setup
        .bodies
        .iter()
        .map(|body| {
            let key = |name: &str| format!("body.\"{}\".{name}", body.name);
            vec![
                key("position = [\"1.5 km\", -3]"),
                key("velocity.sway = -0.2 m/s"),
                key("heading = 31 deg"),
                key("velocity = { surge = \"1 kn\", yaw = 0.01 }"),
                key("velocity.sway = 0.1"),
            ]
        })
        .collect();
    all.push(vec!["environment.wind = { speed = 7, from = \"200 deg\" }".to_owned()]);
    all.push(vec!["environment.current = { speed = \"1 kn\", towards = 1 }".to_owned()]);
    all
}

#[test]
fn the_start_of_a_variant_is_that_of_the_scenario_read_anew() {
    let mut in_place = 0;
    for (name, text) in scenarios() {
        // Some name files, which this text alone cannot read.
        let Ok(scenario) = Scenario::parse(&text, &name) else { continue };
        for settings in starts(&scenario.setup) {
            let overrides = overrides(&settings);
            let mut start = scenario.setup.start();
            if scenario.start_with(&overrides, &mut start) {
                let mut setup = scenario.setup.clone();
                setup.set_start(&start);
                let anew = Scenario::parse_with(&text, &name, &overrides).unwrap();
                assert!(setup == anew.setup, "{name}: {settings:?}");
                in_place += 1;
            }
        }
    }
    assert!(in_place > 30, "{in_place}");
}

#[test]
fn what_changes_more_than_the_start_or_is_refused_is_read_anew() {
    let scenario = Scenario::parse(TEXT, "x.toml").unwrap();
    let mut start = scenario.setup.start();
    for setting in [
        "time.step = 0.5",
        "material.rubber.stiffness = 1",
        "body.tug.mass = 100 t",
        "body.\"old quay\".position = [1, 2]",
        "body.*.heading = 1",
        "body.boat.heading = 1",
        "body.tug.heading = 1 m",
        "body.tug.heading = 1e9",
        "body.tug.position = [1]",
        "body.tug.velocity.surge = nan",
        "body.tug.velocity = { ahead = 1 }",
        "body.tug.velocity = 1",
        "body.tug.velocity.ahead = 1",
        "body.tug.position = [1",
        "environment.wind = { speed = 1, from = 0 }",
    ] {
        assert!(!scenario.start_with(&overrides(&[setting.to_owned()]), &mut start), "{setting}");
    }
    assert!(scenario.start_with(&[], &mut start));
    assert_eq!(start, scenario.setup.start());
}

/// All that a run reports at its end, with every bit: `{:?}` of a float is its shortest text that reads back the same bits.
fn end_of(simulation: &mut Simulation) -> String {
    for _ in 0..simulation.steps_total().min(150) {
        if let Err(error) = simulation.step() {
            return error.to_string();
        }
    }
    let fenders: Vec<_> = simulation.fender_summaries().collect();
    format!(
        "{:?}",
        (
            (simulation.states(), simulation.energy(), simulation.memory().snapshot()),
            (simulation.pair_summaries(), fenders, simulation.findings(), simulation.verdict()),
            (simulation.vessels(), simulation.tugs(), simulation.lines(), simulation.berthing()),
            (simulation.wrenches(), simulation.contacts(), simulation.dolphin_summaries()),
            (simulation.time_s(), simulation.setup().start()),
        )
    )
}

#[test]
fn a_restarted_simulation_is_a_new_one_to_the_bit() {
    for (name, text) in scenarios() {
        let Ok(scenario) = Scenario::parse(&text, &name) else { continue };
        let setup = &scenario.setup;
        let mut other = setup.start();
        for body in &mut other.bodies {
            body.velocity.surge_mps *= 0.75;
            body.velocity.sway_mps *= 0.75;
        }
        // With other gusts, where there are some.
        other.wind = other.wind.map(|wind| {
            let (speed_mps, from_rad) = wind.mean_at(0.0);
            wind.changed_to(0.75 * speed_mps, from_rad).unwrap()
        });
        let mut simulation = Simulation::new(setup.clone()).unwrap();
        let first = end_of(&mut simulation);
        simulation.set_wind(None);
        let load = Wrench { moment_nm: 1e5, ..Wrench::default() };
        simulation.set_external(&vec![load; setup.bodies.len()]);
        simulation.restart(&other).unwrap();
        let mut of_other = setup.clone();
        of_other.set_start(&other);
        let mut new = Simulation::new(of_other).unwrap();
        assert_eq!(
            format!("{:?}", simulation.start_findings()),
            format!("{:?}", new.start_findings())
        );
        assert!(end_of(&mut simulation) == end_of(&mut new), "{name}");
        simulation.restart(&setup.start()).unwrap();
        assert!(end_of(&mut simulation) == first, "{name}");
    }
}
