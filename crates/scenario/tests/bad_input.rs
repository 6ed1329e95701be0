//! Every mistake in a scenario file gives one message that names key and line.

use std::time::{Duration, Instant};

use fenderline_campaign::Campaign;
use fenderline_scenario::{Scenario, ScenarioError};

/// A scenario without a mistake; each case below replaces a part of it.
const GOOD: &str = r#"title = "Tug against a quay"

[time]
step = "0.1 s"
duration = "20 s"

[contact]
method = "paper"

[material.paper]
stiffness = "500 kN/m^2"
damping = "20 kN.s/m^2"
shear_stiffness = "3000 kN/m"
friction_static = 0.5
friction_dynamic = 0.4
restitution = 0.1

[body.tug]
outline = [[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]
mass = "930 t"
gyradius = "8 m"
added_mass = { surge = 0.086, sway = 0.84, yaw = 0.40 }
position = [-20, 0]
heading = "0 deg"
velocity = { surge = "4 kn", yaw = "3 deg/s" }

[body.quay]
fixed = true
outline = [[0, -50], [5, -50], [5, 50], [0, 50]]

[body.fender]
fixed = true
outline = [[-1, -1], [1, -1], [1, 1], [-1, 1]]

[[pair]]
bodies = ["tug", "quay"]
material = "paper"

[[pair]]
bodies = ["fender", "tug"]
material = "paper"

[[load]]
body = "tug"
force = ["0 kN", "-500 kN"]
until = "10 s"
"#;

/// `part` of the good scenario becomes `mistake`; the error is at the line where `part` starts, or of
/// `at` in the whole text, about `key`, and its message or help has `fragment` in it.
struct Case {
    part: &'static str,
    mistake: &'static str,
    at: Option<&'static str>,
    key: &'static str,
    fragment: &'static str,
}

const fn case(
    part: &'static str,
    mistake: &'static str,
    key: &'static str,
    fragment: &'static str,
) -> Case {
    Case { part, mistake, at: None, key, fragment }
}

const fn case_at(
    part: &'static str,
    mistake: &'static str,
    at: &'static str,
    key: &'static str,
    fragment: &'static str,
) -> Case {
    Case { part, mistake, at: Some(at), key, fragment }
}

const TUG: &str = "[[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]";
const STIFFNESS: &str = "\"500 kN/m^2\"";
const K: &str = "material.paper.stiffness";
const PAIR: &str = "[\"fender\", \"tug\"]";

#[rustfmt::skip]
const CASES: &[Case] = &[
    // NaN and infinities
    case("\"0.1 s\"", "nan", "time.step", "not a finite number"),
    case("\"0.1 s\"", "\"nan s\"", "time.step", "NaN and infinity are not allowed"),
    case("\"20 s\"", "inf", "time.duration", "not a finite number"),
    case(STIFFNESS, "inf", K, "not a finite number"),
    case(STIFFNESS, "-inf", K, "not a finite number"),
    case(STIFFNESS, "1e999", K, "not a finite number"),
    case(STIFFNESS, "\"1e999 N/m^2\"", K, "too large"),
    case("[-20, 0]", "[nan, 0]", "body.tug.position[0]", "not a finite number"),
    case("[16, 6.5]", "[16, inf]", "body.tug.outline[2][1]", "not a finite number"),
    case("\"-500 kN\"", "-inf", "load.0.force[1]", "not a finite number"),
    // output
    case("title = \"Tug against a quay\"", "output = { interval = \"0.25 s\" }", "output.interval", "0.25 s is not a whole number of time steps of 0.1 s"),
    case("title = \"Tug against a quay\"", "output = { interval = \"0.25 s\" }", "output.interval", "take 0.2 s or 0.3 s"),
    case("title = \"Tug against a quay\"", "output = { interval = 0.05 }", "output.interval", "take 0.1 s or 0, which both write every step"),
    case("title = \"Tug against a quay\"", "output = { interval = \"1 min\" }", "output.interval", "longer than `time.duration`, which is 20 s"),
    case("title = \"Tug against a quay\"", "output = { interval = -1 }", "output.interval", "at least 0 s"),
    case("title = \"Tug against a quay\"", "output = { tables = [\"fender\"] }", "output.tables", "did you mean \"fenders\"?"),
    case("title = \"Tug against a quay\"", "output = { tables = [\"waves\"] }", "output.tables", "there is no result table \"waves\""),
    case("title = \"Tug against a quay\"", "output = { tables = \"fenders\" }", "output.tables", "list"),
    // wrong units
    case(STIFFNESS, "\"4 kn\"", K, "must be a stiffness per area or pressure [N/m²], but \"4 kn\" is a speed [m/s]"),
    case("\"4 kn\"", "\"4 kN\"", "body.tug.velocity.surge", "must be a speed [m/s], but \"4 kN\" is a force [N]"),
    case("\"4 kn\"", "\"4 knotts\"", "body.tug.velocity.surge", "`knotts` is not a known unit"),
    case("\"4 kn\"", "\"4 knots\"", "body.tug.velocity.surge", "did you mean `kn`?"),
    case("\"4 kn\"", "\"4\"", "body.tug.velocity.surge", "a number without a unit"),
    case("\"4 kn\"", "\"fast\"", "body.tug.velocity.surge", "the text does not start with a number"),
    case("\"4 kn\"", "\"slow\"", "body.tug.velocity.surge", "write a speed, as \"4 kn\""),
    case("\"20 s\"", "\"abc\"", "time.duration", "write a time, as \"0.1 s\""),
    case("\"20 s\"", "\"20 m\"", "time.duration", "write a time, as \"0.1 s\""),
    case("restitution = 0.1", "restitution = \"abc\"", "material.paper.restitution", "write a plain number, as 0.5"),
    case("\"930 t\"", "\"930 kN\"", "body.tug.mass", "must be a mass [kg], but \"930 kN\" is a force [N]"),
    case("\"3 deg/s\"", "\"3 1/s\"", "body.tug.velocity.yaw", "must be a rate of turn [rad/s], but \"3 1/s\" is a frequency [1/s]"),
    case("\"0 deg\"", "\"0 m\"", "body.tug.heading", "must be an angle [rad]"),
    case("= 0.5", "= \"0.5 m\"", "material.paper.friction_static", "must be a plain number, but \"0.5 m\" is a length [m]"),
    case("\"20 kN.s/m^2\"", "\"20 kN.s/m\"", "material.paper.damping", "is a damping [N·s/m]"),
    case("[-20, 0]", "[-20, \"1 t\"]", "body.tug.position[1]", "is a mass [kg]"),
    // unknown keys
    case("stiffness = \"500", "stifness = \"500", "material.paper.stifness", "did you mean `stiffness`?"),
    case("title", "titel", "titel", "did you mean `title`?"),
    case("[time]", "[tiem]", "tiem", "did you mean `time`?"),
    case("surge = \"4", "surgee = \"4", "body.tug.velocity.surgee", "did you mean `surge`?"),
    case("until", "untill", "load.0.untill", "did you mean `until`?"),
    case("method", "colour", "contact.colour", "a contact table has the keys method"),
    case_at("[body.quay]", "[body.quay.paint]\n[body.quay]", "[body.quay.paint]", "body.quay.paint", "not a key of a body"),
    // words
    case("\"paper\"\n\n[mat", "\"couppled\"\n\n[mat", "contact.method", "did you mean \"coupled\"?"),
    case("\"paper\"\n\n[mat", "\"papr\"\n\n[mat", "contact.method", "did you mean \"paper\"?"),
    case_at("\"20 s\"", "\"20 s\"\nintegrator = \"euler2\"", "euler2", "time.integrator", "did you mean \"euler\"?"),
    // kinds of value
    case("\"0.1 s\"", "true", "time.step", "must be a time [s], but is true or false"),
    case("\"0.1 s\"", "1979-05-27", "time.step", "is a date"),
    case("\"0.1 s\"", "[1]", "time.step", "is a list"),
    case("\"0.1 s\"", "0xffffffffffffffffffff", "time.step", "not a finite number"),
    case("fixed = true\noutline = [[0", "fixed = 1\noutline = [[0", "body.quay.fixed", "must be true or false, but is a number"),
    case("\"Tug against a quay\"", "4", "title", "must be a text in quotes"),
    case("\"Tug against a quay\"", "\"\"", "title", "is empty"),
    case("\"Tug against a quay\"", "\"a\\u001bb\"", "title", "control character"),
    case("[-20, 0]", "[-20]", "body.tug.position", "is [north, east], but has 1 numbers"),
    case("[-20, 0]", "[-20, 0, 0]", "body.tug.position", "but has 3 numbers"),
    case("[-20, 0]", "-20", "body.tug.position", "must be [north, east], but is a number"),
    case("{ surge = \"4 kn\", yaw = \"3 deg/s\" }", "\"4 kn\"", "body.tug.velocity", "must be a table"),
    case("[[load]]", "[load]", "load", "write [[load]] with two brackets"),
    case_at("[material.paper]", "[material]", "stiffness = ", "material.stiffness", "a material has a name: [material.NAME]"),
    case("[body.quay]", "[body.\"*\"]", "body.\"*\"", "stands for all"),
    case("[body.quay]", "[body.\"\"]", "body.\"\"", "is empty"),
    // unknown bodies and materials
    case(PAIR, "[\"fender\", \"tgu\"]", "pair.1.bodies", "did you mean \"tug\"?"),
    case(PAIR, "[\"fender\", \"lighthouse\"]", "pair.1.bodies", "there is no body \"lighthouse\""),
    case("body = \"tug\"", "body = \"ship\"", "load.0.body", "the scenario has the bodies"),
    case("material = \"paper\"\n\n[[load", "material = \"papier\"\n\n[[load", "pair.1.material", "did you mean \"paper\"?"),
    case_at("material = \"paper\"\n\n[[load", "\n[[load", "[[pair]]\nbodies = [\"fender", "pair.1.material", "is missing"),
    case_at("bodies = [\"fender\", \"tug\"]\n", "", "[[pair]]\nmaterial = \"paper\"", "pair.1.bodies", "is missing"),
    // pairs
    case(PAIR, "[\"tug\"]", "pair.1.bodies", "names two bodies, but has 1"),
    case(PAIR, "[\"tug\", \"quay\", \"fender\"]", "pair.1.bodies", "names two bodies, but has 3"),
    case(PAIR, "\"tug\"", "pair.1.bodies", "must be the names of two bodies"),
    case(PAIR, "[\"tug\", 3]", "pair.1.bodies[1]", "must be a text in quotes"),
    case(PAIR, "[\"tug\", \"tug\"]", "pair.1.bodies", "cannot touch itself"),
    case(PAIR, "[\"quay\", \"tug\"]", "pair.1.bodies", "given twice"),
    case(PAIR, "[\"quay\", \"fender\"]", "pair.1.bodies", "both fixed"),
    case(PAIR, "[\"*\", \"tug\"]", "pair.1.bodies", "for both bodies or for none"),
    case_at(PAIR, "[\"*\", \"*\"]\nmaterial = \"paper\"\n[[pair]]\nbodies = [\"*\" , \"*\"]", "\"*\" ,", "pair.2.bodies", "given twice"),
    // outlines
    case(TUG, "[[0, 0], [1, 0]]", "body.tug.outline", ""),
    case(TUG, "[]", "body.tug.outline", ""),
    case(TUG, "[[0, 0], [1, 0], [2, 0], [3, 0]]", "body.tug.outline", "area"),
    case(TUG, "[[0, 0], [10, 10], [10, 0], [0, 10]]", "body.tug.outline", ""),
    case(TUG, "[[0, 0], [1, 0], 3]", "body.tug.outline[2]", "must be [forward, starboard], but is a number"),
    case(TUG, "[[0, 0], [1, 0], [1]]", "body.tug.outline[2]", "has 1 numbers"),
    case(TUG, "[[0, 0], [1, 0], [1, \"1 kg\"]]", "body.tug.outline[2][1]", "is a mass"),
    case(TUG, "\"round\"", "body.tug.outline", "must be a list of points [forward, starboard]"),
    case_at(TUG, "[\n[0, 0],\n[1, 0],\n[1, 2e8],\n[0, 1]]", "[1, 2e8]", "body.tug.outline[2][1]", "must be at most 1e8 m"),
    case_at("outline = [[-1, -1], [1, -1], [1, 1], [-1, 1]]\n", "", "[body.fender]", "body.fender.outline", "is missing"),
    // masses
    case("\"930 t\"", "0", "body.tug.mass", "must be at least 0.001 kg, but is 0 kg"),
    case("\"930 t\"", "\"-930 t\"", "body.tug.mass", "must be at least 0.001 kg"),
    case("\"930 t\"", "1e16", "body.tug.mass", "must be at most 1e15 kg"),
    case("\"8 m\"", "0", "body.tug.gyradius", "must be at least 0.001 m"),
    case("\"8 m\"", "\"-8 m\"", "body.tug.gyradius", "must be at least"),
    case("gyradius = \"8 m\"", "yaw_inertia = 0", "body.tug.yaw_inertia", "must be at least"),
    case("gyradius = \"8 m\"", "yaw_inertia = -1", "body.tug.yaw_inertia", "must be at least"),
    case_at("gyradius = \"8 m\"", "gyradius = \"8 m\"\nyaw_inertia = 1e9", "yaw_inertia = 1e9", "body.tug.yaw_inertia", "both give the yaw inertia"),
    case_at("gyradius = \"8 m\"\n", "", "[body.tug]", "body.tug.gyradius", "or yaw_inertia"),
    case_at("mass = \"930 t\"\n", "", "[body.tug]", "body.tug.mass", "or fixed = true"),
    case("surge = 0.086", "surge = -0.1", "body.tug.added_mass.surge", "must be at least 0"),
    case("yaw = 0.40", "yaw = 1e9", "body.tug.added_mass.yaw", "must be at most 1000"),
    case_at("mass = \"930 t\"", "fixed = true\nmass = \"930 t\"", "mass = \"930 t\"", "body.tug.mass", "is for floating bodies, but this body is fixed"),
    case_at("fixed = true\noutline = [[0", "fixed = true\nvelocity = { surge = 0 }\noutline = [[0", "velocity = { surge = 0", "body.quay.velocity", "for floating bodies"),
    case_at("fixed = true\noutline = [[0", "fixed = true\nadded_mass = {}\noutline = [[0", "added_mass = {}", "body.quay.added_mass", "for floating bodies"),
    // materials
    case(STIFFNESS, "-1", K, "must be at least 0 N/m², but is -1 N/m²"),
    case(STIFFNESS, "1e16", K, "must be at most 1e15 N/m²"),
    case("\"20 kN.s/m^2\"", "-1", "material.paper.damping", "must be at least 0"),
    case("\"20 kN.s/m^2\"", "inf", "material.paper.damping", "not a finite number"),
    case("\"3000 kN/m\"", "-1", "material.paper.shear_stiffness", "must be at least 0"),
    case("\"3000 kN/m\"", "inf", "material.paper.shear_stiffness", "not a finite number"),
    case("friction_static = 0.5", "friction_static = -0.5", "material.paper.friction_static", "must be at least 0"),
    case("friction_dynamic = 0.4", "friction_dynamic = -0.4", "material.paper.friction_dynamic", "must be at least 0"),
    case("friction_dynamic = 0.4", "friction_dynamic = 0.6", "material.paper.friction_dynamic", "at most `friction_static`, which is 0.5, but is 0.6"),
    case("restitution = 0.1", "restitution = 1.1", "material.paper.restitution", "must be at most 1, but is 1.1"),
    case("restitution = 0.1", "restitution = -0.1", "material.paper.restitution", "must be at least 0"),
    case_at("stiffness = \"500 kN/m^2\"\n", "", "[material.paper]", K, "is missing"),
    // time
    case("\"0.1 s\"", "0", "time.step", "must be at least 1e-6 s, but is 0 s"),
    case("\"0.1 s\"", "\"-0.1 s\"", "time.step", "must be at least 1e-6 s"),
    case("\"20 s\"", "0", "time.duration", "must be at least"),
    case("\"20 s\"", "\"-20 s\"", "time.duration", "must be at least"),
    case("\"0.1 s\"", "\"20.1 s\"", "time.step", "`time.step` of 20.1 s is longer than `time.duration`, which is 20 s"),
    case("\"20 s\"", "1e9", "time.duration", "more than 1e9 steps"),
    case_at("step = \"0.1 s\"\n", "", "[time]", "time.step", "is missing"),
    // coordinates and speeds
    case("[-20, 0]", "[-2e8, 0]", "body.tug.position[0]", "must be at least -1e8 m"),
    case("[-20, 0]", "[\"200000 km\", 0]", "body.tug.position[0]", "must be at most 1e8 m"),
    case("\"4 kn\"", "1e5", "body.tug.velocity.surge", "must be at most 10000 m/s"),
    case("\"3 deg/s\"", "1e5", "body.tug.velocity.yaw", "must be at most 1000 rad/s"),
    case("\"0 deg\"", "1e9", "body.tug.heading", "must be at most 6.3 rad (361 deg)"),
    case("\"0 deg\"", "90", "body.tug.heading", "write \"90 deg\" if you meant deg"),
    // loads
    case("body = \"tug\"", "body = \"quay\"", "load.0.body", "is fixed, no load moves it"),
    case_at("force = [\"0 kN\", \"-500 kN\"]\n", "", "[[load]]", "load.0.force", "and so is `moment`"),
    case("\"10 s\"", "0", "load.0.until", "must be later than `from`, which is 0 s, but is 0 s"),
    case("\"10 s\"", "-1", "load.0.until", "must be at least 0 s"),
    case("\"-500 kN\"", "1e16", "load.0.force[1]", "must be at most 1e15 N"),
    // broken TOML
    case("step = \"0.1 s\"", "step = ", "time.step", "this is not TOML"),
    case("step = \"0.1 s\"", "step = 0.1 s", "time.step", "number with a unit in quotes"),
    case("step = \"0.1 s\"", "step = 0.1s", "time.step", "number with a unit in quotes"),
    case("step = \"0.1 s\"", "step = 0,1", "time.step", "write a decimal point"),
    case("title", "duration", "duration", "`duration` belongs under [time]"),
    case("step = \"0.1 s\"", "step = \"0.1 s", "time.step", "this is not TOML"),
    case("[body.quay]", "[body.quay", "body.quay", "this is not TOML"),
    case("[body.quay]", "body.quay]", "body.tug", "this is not TOML"),
    case_at("mass = \"930 t\"", "mass = \"930 t\"\nmass = \"931 t\"", "mass = \"931 t\"", "body.tug.mass", "`body.tug.mass` is given twice; it is first given in line 20"),
    case("[body.fender]", "[body.quay]", "body.quay", "`body.quay` is given twice; it is first given in line 27"),
    case_at("until = \"10 s\"", "until = 1\nbody=\"tug\"", "body=\"tug\"", "load.body", "`load.body` is given twice; it is first given in line 44"),
];

#[test]
fn the_good_scenario_has_no_notices() {
    let scenario = Scenario::parse(GOOD, "good.toml").unwrap();
    assert_eq!(scenario.notices, []);
}

#[test]
fn unusual_friction_gives_a_notice_with_its_line() {
    let parse = |friction: &str| {
        let text = GOOD.replace("friction_static = 0.5", &format!("friction_static = {friction}"));
        Scenario::parse(&text, "slippery.toml")
    };
    assert_eq!(parse("1.5").unwrap().notices, []);
    let rough = parse("3").unwrap();
    let [notice] = &rough.notices[..] else { panic!("{:?}", rough.notices) };
    assert_eq!(notice.key, "material.paper.friction_static");
    assert!(notice.to_string().contains("slippery.toml:14:"), "{notice}");
    assert!(
        notice.message.starts_with("a coefficient of friction of 3 is more than 1.5"),
        "{notice}"
    );
    let absurd = parse("11").unwrap_err();
    assert_eq!(absurd.key(), Some("material.paper.friction_static"));
    assert!(absurd.to_string().contains("must be at most 10"), "{absurd}");
}

#[test]
fn every_mistake_names_key_and_line() {
    let mut faults = Vec::new();
    for case in CASES {
        if let Err(fault) = check(case) {
            faults.push(format!("{:?} for {:?}: {fault}", case.mistake, case.part));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n\n"));
}

fn check(case: &Case) -> Result<(), String> {
    if GOOD.matches(case.part).count() != 1 {
        return Err("the part to replace does not occur exactly once".to_owned());
    }
    let text = GOOD.replace(case.part, case.mistake);
    let position = match case.at {
        None => GOOD.find(case.part),
        Some(at) => text.find(at),
    };
    let position = position.ok_or("the place is not in the text")?;
    let line = text[..position].matches('\n').count() + 1;
    let Err(error) = Scenario::parse(&text, "bad.toml") else {
        return Err("accepted".to_owned());
    };
    let shown = error.to_string();
    if error.line() != Some(line) || !shown.contains(&format!("bad.toml:{line}:")) {
        return Err(format!("not at line {line}:\n{shown}"));
    }
    if error.key() != Some(case.key) {
        return Err(format!("about {:?}, not {:?}:\n{shown}", error.key(), case.key));
    }
    if !shown.contains(case.fragment) || shown.matches("error: ").count() != 1 {
        return Err(format!("lacks {:?}:\n{shown}", case.fragment));
    }
    Ok(())
}

#[test]
fn a_missing_top_level_key_is_named() {
    let without = |start: &str, end: &str| {
        let (from, to) = (GOOD.find(start).unwrap(), GOOD.find(end).unwrap());
        Scenario::parse(&[&GOOD[..from], &GOOD[to..]].concat(), "bad.toml").unwrap_err()
    };
    assert_eq!(without("[time]", "[contact]").key(), Some("time"));
    assert_eq!(without("[material", "[body.tug").key(), Some("pair.0.material"));
    assert_eq!(without("[body.tug", "[[pair").key(), Some("body"));
    let empty = Scenario::parse("", "bad.toml").unwrap_err();
    assert_eq!((empty.key(), empty.line()), (Some("time"), Some(1)));
    let no_bodies = Scenario::parse("body = {}\ntime = {step = 1, duration = 2}", "bad.toml");
    assert_eq!(no_bodies.unwrap_err().message(), "the scenario has no bodies");
}

#[test]
fn messages_look_as_documented() {
    let text = GOOD.replace("stiffness = \"500", "stifness = \"500");
    let shown = Scenario::parse(&text, "scenarios/x.toml").unwrap_err().to_string();
    let expected = r#"error: `material.paper.stifness` is not a key of a material
  --> scenarios/x.toml:11:1
   |
11 | stifness = "500 kN/m^2"
   | ^^^^^^^^
   = help: did you mean `stiffness`?"#;
    assert_eq!(shown, expected);
}

/// A huge file is refused in reasonable time, even in a debug build on a busy machine.
fn refused_soon(text: &str) -> ScenarioError {
    let start = Instant::now();
    let error = Scenario::parse(text, "huge.toml").expect_err("a huge file is no scenario");
    assert!(start.elapsed() < Duration::from_secs(60), "took {:?}", start.elapsed());
    assert!(error.to_string().len() < 1000, "the message is cut: {error}");
    error
}

const TEN_MB: usize = 10_000_000;

#[test]
fn ten_megabytes_of_garbage() {
    let garbage: String = (0..TEN_MB)
        .map(|i| char::from(b' ' + (i.wrapping_mul(2_654_435_761) >> 7) as u8 % 95))
        .collect();
    refused_soon(&garbage);
    refused_soon(&garbage.replace(' ', "\n"));
    refused_soon(&"\"".repeat(TEN_MB));
    refused_soon(&"é".repeat(TEN_MB / 2));
    refused_soon(&"\0".repeat(TEN_MB));
}

#[test]
fn ten_megabytes_of_brackets() {
    refused_soon(&"[".repeat(TEN_MB));
    refused_soon(&format!("a = {}", "[".repeat(TEN_MB)));
    let error = refused_soon(&format!("a = {}{}", "[".repeat(TEN_MB / 2), "]".repeat(TEN_MB / 2)));
    assert!(error.message().contains("nested too deeply"), "{error}");
    refused_soon(&format!("a = {}", "{a=".repeat(TEN_MB / 3)));
}

#[test]
fn ten_megabytes_of_key() {
    refused_soon(&format!("{} = 1", "a".repeat(TEN_MB)));
    refused_soon(&format!("{}a = 1", "a.".repeat(TEN_MB / 2)));
    refused_soon(&format!("[{}a]", "a.".repeat(TEN_MB / 2)));
    refused_soon(&GOOD.replace("tug", &"t".repeat(TEN_MB / 5)));
}

#[test]
fn ten_megabytes_of_value() {
    let long = "4".repeat(TEN_MB);
    refused_soon(&GOOD.replace("\"500 kN/m^2\"", &long));
    refused_soon(&GOOD.replace("500 kN/m^2", &long));
    refused_soon(&GOOD.replace("Tug against a quay", &long));
}

#[test]
fn ten_megabytes_of_outline() {
    let points = "[10000, 10001], ".repeat(TEN_MB / 16);
    let error = refused_soon(&GOOD.replace("[[-16, ", &format!("[{points} [-16, ")));
    assert_eq!(error.key(), Some("body.tug.outline"));
    assert_eq!(error.line(), Some(19));
}

#[test]
fn ten_megabytes_of_tables() {
    let tables: String = (0..TEN_MB / 14).map(|i| format!("[x.{i:08}]\n")).collect();
    refused_soon(&tables);
    let pairs = "[[pair]]\nbodies = [\"tug\", \"quay\"]\nmaterial = \"paper\"\n";
    let error = refused_soon(&format!("{GOOD}{}", pairs.repeat(TEN_MB / pairs.len())));
    assert!(error.message().contains("given twice"), "{error}");
}

#[test]
fn more_than_sixteen_mebibytes_are_not_read() {
    let error = refused_soon(&format!("{GOOD}#{}", " ".repeat(16 << 20)));
    assert!(error.message().contains("bytes"), "{error}");
}

#[test]
fn ten_megabytes_of_comment_are_fine() {
    let text = format!("{GOOD}#{}", "ü".repeat(TEN_MB / 2));
    assert!(Scenario::parse(&text, "huge.toml").is_ok());
}

/// Counts of campaigns have bounds, and the error names them: a million million runs ended the program for want of memory.
#[test]
fn counts_of_campaigns_have_bounds() {
    let refused = |plan: &str, variables: usize, expected: &str| {
        let variable = |name: usize| {
            format!(
                "[variable.v{name}]\nkey = \"time.step\"\ndistribution = \"uniform\"\nlower = 1\nupper = 2\n"
            )
        };
        let text = format!(
            "scenario = \"x.toml\"\n{plan}\n{}",
            (0..variables).map(variable).collect::<String>()
        );
        let error = Campaign::parse(&text, "c.toml").unwrap_err();
        assert!(error.message().contains(expected), "{error}");
        assert_eq!(error.key(), Some("number"), "{error}");
    };
    let most = "must be at most 1e8, but is 1e12";
    for plan in ["Monte Carlo", "Latin hypercube", "Sobol"] {
        refused(&format!("plan = \"{plan}\"\nnumber = 1000000000000"), 1, most);
    }
    refused(
        "plan = \"Latin hypercube\"\nnumber = 50000001",
        2,
        "a Latin hypercube of 2 variables has at most 50000000 runs",
    );
    refused("plan = \"Sobol\"\nnumber = 65537", 1, "at most 65536");
}

/// Friction acts through the shear spring: without its stiffness there would be none at any slip, in silence.
#[test]
fn friction_without_shear_stiffness_is_refused() {
    for shear in ["", "shear_stiffness = 0\n"] {
        let text = GOOD.replace("shear_stiffness = \"3000 kN/m\"\n", shear);
        let error = Scenario::parse(&text, "x.toml").unwrap_err();
        assert_eq!(error.key(), Some("material.paper.friction_static"), "{error}");
        assert!(error.message().contains("needs `material.paper.shear_stiffness`"), "{error}");
        let without =
            text.replace("friction_static = 0.5\n", "").replace("friction_dynamic = 0.4\n", "");
        assert!(Scenario::parse(&without, "x.toml").is_ok());
    }
}
