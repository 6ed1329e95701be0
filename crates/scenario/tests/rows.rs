//! Rows of fenders: where they stand, what they are called, how single keys of them are set, and their mistakes.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

use fenderline_contact::{Vec2, vec2};
use fenderline_scenario::{Override, Scenario, ScenarioError, set_keys};
use fenderline_sim::FenderSetup;

const START: &str = r#"[time]
step = "0.1 s"
duration = "20 s"

[material.facing]
stiffness = 0
shear_stiffness = "3 MN/m"
friction_static = 0.2

[material.concrete]
stiffness = "50 MN/m^2"

[body.ship]
outline = [[-50, -10], [50, -10], [50, 10], [-50, 10]]
mass = "9000 t"
gyradius = "25 m"

[body.quay]
fixed = true
outline = [[-100, 0], [100, 0], [100, 9], [-100, 9]]
position = [0, 15]

[[pair]]
bodies = ["ship", "quay"]
material = "concrete"
"#;

/// The four lines of a row.
const ROW: &str = r#"
[fender_row.a]
on = "quay"
first = [-70, 0]
spacing = "20 m"
number = 8
"#;

/// What each fender is.
const TYPE: &str = r#"
width = "2.4 m"
type = "cone"
height = "1.2 m"
material = "facing"
"#;

fn parse(text: &str, settings: &[&str]) -> Result<Scenario, ScenarioError> {
    let overrides: Vec<_> = settings.iter().map(|text| Override::parse(text).unwrap()).collect();
    Scenario::parse_with(text, "x.toml", &overrides)
}

fn with_row(row: &str) -> Scenario {
    parse(&format!("{START}{row}{TYPE}"), &[]).unwrap_or_else(|error| panic!("{error}"))
}

fn fenders(settings: &[&str]) -> Vec<FenderSetup> {
    parse(&format!("{START}{ROW}{TYPE}"), settings).unwrap().setup.fenders
}

fn places(scenario: &Scenario) -> Vec<Vec2> {
    scenario.setup.fenders.iter().map(|fender| fender.position_m).collect()
}

fn facings(scenario: &Scenario) -> Vec<f64> {
    scenario.setup.fenders.iter().map(|fender| fender.facing_rad).collect()
}

#[test]
fn eight_fenders_in_four_lines() {
    let scenario = with_row(ROW);
    let names: Vec<_> = scenario.setup.fenders.iter().map(|fender| fender.name.as_str()).collect();
    assert_eq!(names, ["a_1", "a_2", "a_3", "a_4", "a_5", "a_6", "a_7", "a_8"]);
    let along: Vec<f64> = places(&scenario).iter().map(|place| place.x).collect();
    assert_eq!(along, [-70.0, -50.0, -30.0, -10.0, 10.0, 30.0, 50.0, 70.0]);
    assert!(places(&scenario).iter().all(|place| place.y == 0.0));
    assert!(facings(&scenario).iter().all(|rad| *rad == -FRAC_PI_2), "out of the edge");
    assert_eq!(scenario.notices, []);
}

/// A row is the same to the bit as its fenders written out.
#[test]
fn a_row_equals_its_fenders_written_out() {
    let mut text = START.to_owned();
    for number in 1..=8 {
        let along = -70 + 20 * (number - 1);
        text += &format!(
            "\n[fender.a_{number}]\non = \"quay\"\nposition = [{along}, 0]\nfacing = \"-90 deg\"{TYPE}"
        );
    }
    assert_eq!(parse(&text, &[]).unwrap().setup, with_row(ROW).setup);
}

#[test]
fn two_of_spacing_number_and_last_give_the_third() {
    let start = "\n[fender_row.a]\non = \"quay\"\nfirst = [-70, 0]\n";
    let whole = places(&with_row(ROW));
    for rest in ["last = [70, 0]\nspacing = 20", "last = [70, 0]\nnumber = 8"] {
        assert_eq!(places(&with_row(&format!("{start}{rest}"))), whole, "{rest}");
    }
    let back =
        with_row("\n[fender_row.a]\non = \"quay\"\nfirst = [70, 0]\nlast = [-70, 0]\nspacing = 20");
    assert_eq!(places(&back).iter().rev().copied().collect::<Vec<_>>(), whole);
    let one =
        with_row("\n[fender_row.a]\non = \"quay\"\nfirst = [-100, 4]\nspacing = 3\nnumber = 1");
    assert_eq!((places(&one), facings(&one)), (vec![vec2(-100.0, 4.0)], vec![PI]));
}

#[test]
fn a_row_stands_in_the_middle_of_its_wall_or_from_a_corner() {
    let wall = |more: &str| {
        with_row(&format!(
            "\n[fender_row.a]\non = \"quay\"\nwall = [[100, 0], [-100, 0]]\nspacing = 20\nnumber = 3\n{more}"
        ))
    };
    assert_eq!(places(&wall("")), [vec2(20.0, 0.0), vec2(0.0, 0.0), vec2(-20.0, 0.0)]);
    let from_corner = wall("from_corner = 5");
    assert_eq!(places(&from_corner), [vec2(95.0, 0.0), vec2(75.0, 0.0), vec2(55.0, 0.0)]);
    assert!(facings(&from_corner).iter().all(|rad| *rad == -FRAC_PI_2));
}

#[test]
fn dolphins_are_bodies_with_a_fender_each() {
    let row = r#"
[fender_row.bd]
dolphins = [[-30, 12], [30, 12]]
outline = [[-2, 0], [2, 0], [2, 4], [-2, 4]]
heading = "10 deg"
"#;
    let text = format!("{START}{row}{TYPE}").replace("\"quay\"]", "\"bd\"]");
    let setup = parse(&text, &[]).unwrap().setup;
    let bodies: Vec<_> = setup.bodies.iter().map(|body| body.name.as_str()).collect();
    assert_eq!(bodies, ["ship", "quay", "bd_1", "bd_2"]);
    assert_eq!(setup.bodies[3].position_m, vec2(30.0, 12.0));
    assert_eq!(setup.bodies[3].heading_rad, 10.0_f64.to_radians());
    assert!(setup.bodies[3].is_fixed());
    let fenders: Vec<_> = setup.fenders.iter().map(|f| (f.name.as_str(), f.body)).collect();
    assert_eq!(fenders, [("bd_1", 2), ("bd_2", 3)]);
    assert!(setup.fenders.iter().all(|f| f.facing_rad == -FRAC_PI_2));
    let pairs: Vec<_> = setup.pairs.iter().map(|pair| pair.bodies).collect();
    assert_eq!(pairs, [[0, 2], [0, 3]], "the pair with the row is one with each dolphin");
}

#[test]
fn a_corner_fender_faces_between_its_edges() {
    let corner = format!("{START}\n[fender.c]\non = \"quay\"\nposition = [100, 0]{TYPE}");
    let facing = |text: &str| parse(text, &[]).unwrap().setup.fenders[0].facing_rad;
    assert_eq!(facing(&corner), -FRAC_PI_4);
    assert_eq!(facing(&corner.replace("[100, 0]\n", "[0, 9]\n")), FRAC_PI_2);
}

#[test]
fn rolling_resistance_takes_the_place_of_friction() {
    let text = format!("{START}{ROW}{TYPE}rolling_resistance = 0.05\n");
    let setup = parse(&text, &["fender.a_2.rolling_resistance=0.1"]).unwrap().setup;
    let of = |index: usize| &setup.materials[setup.fenders[index].material];
    assert_eq!(of(0).name, "facing, rolling resistance 0.05");
    assert_eq!((of(0).material.friction_static, of(0).material.friction_dynamic), (0.05, 0.05));
    assert_eq!(of(0).material.shear_stiffness_npm, 3e6);
    assert_eq!(of(1).material.friction_static, 0.1);
    assert_eq!(setup.fenders[2].material, setup.fenders[0].material);
    assert_eq!(setup.materials[0].material.friction_static, 0.2, "the material itself stays");
    let notices = parse(&text, &[]).unwrap().notices;
    let [notice] = notices.as_slice() else { panic!("{notices:?}") };
    assert!(notice.is_without_effect() && notice.key == "material.facing.friction_static");
    let without =
        text.replace("shear_stiffness = \"3 MN/m\"\n", "").replace("friction_static = 0.2\n", "");
    let error = parse(&without, &[]).unwrap_err();
    assert_eq!(error.key(), Some("fender_row.a.rolling_resistance"));
    assert!(error.message().contains("needs `material.facing.shear_stiffness`"), "{error}");
}

#[test]
fn a_floating_fender_says_so() {
    let row = format!("{ROW}floating = true\nabove_water = \"0.3 m\"");
    let scenario = with_row(&row);
    assert!(scenario.setup.fenders.iter().all(|f| f.floating && f.above_water_m == 0.3));
    assert!(fenders(&[]).iter().all(|fender| !fender.floating));
}

fn tolerances(settings: &[&str]) -> Vec<f64> {
    let percent = |fender: &FenderSetup| (fender.factors.constant - 1.0) * 100.0;
    fenders(settings).iter().map(percent).map(f64::round).collect()
}

#[test]
fn keys_of_a_row_and_of_its_fenders_can_be_set() {
    assert_eq!(tolerances(&["fender_row.a.tolerance=10 %"]), [10.0; 8]);
    assert_eq!(tolerances(&["fender.*.tolerance=10 %"]), [10.0; 8]);
    assert_eq!(tolerances(&["fender.a_*.tolerance=10 %"]), [10.0; 8]);
    let one = [0.0, 0.0, -10.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(tolerances(&["fender.a_3.tolerance=-10 %"]), one);
    assert_eq!(tolerances(&["fender_row.a.exception={a_3 = {tolerance = -0.1}}"]), one);
    assert_eq!(tolerances(&["fender.*3.tolerance=-10 %"]), one);
    // Of two settings of one key the later one counts.
    assert_eq!(tolerances(&["fender.a_3.tolerance=-10 %", "fender.*.tolerance=10 %"]), [10.0; 8]);
    let both = tolerances(&["fender.*.tolerance=10 %", "fender.a_3.tolerance=-10 %"]);
    assert_eq!(both, [10.0, 10.0, -10.0, 10.0, 10.0, 10.0, 10.0, 10.0]);
    assert_eq!(fenders(&["fender_row.a.number=3"]).len(), 3);
    assert_eq!(fenders(&["fender.a_1.position=[-75, 0]"])[0].position_m, vec2(-75.0, 0.0));
}

#[test]
fn exceptions_of_the_file_stay_under_settings_of_the_command_line() {
    let text = format!("{START}{ROW}{TYPE}\n[fender_row.a.exception.a_3]\ntolerance = \"-10 %\"\n");
    let third = |settings: &[&str]| {
        let fenders = parse(&text, settings).unwrap().setup.fenders;
        [1, 2].map(|index: usize| (fenders[index].factors.constant * 100.0).round())
    };
    assert_eq!(third(&[]), [100.0, 90.0]);
    assert_eq!(third(&["fender_row.a.tolerance=10 %"]), [110.0, 110.0]);
    assert_eq!(third(&["fender.a_3.tolerance=5 %"]), [100.0, 105.0]);
}

#[test]
fn a_pattern_holds_for_single_fenders_and_for_any_table() {
    let single = "\n[fender.b]\non = \"quay\"\nposition = [90, 0]";
    let text = format!("{START}{ROW}{TYPE}{single}{TYPE}");
    let setup = parse(
        &text,
        &[
            "fender.*.tolerance=10 %",
            "material.*.shear_stiffness=3 MN/m",
            "material.*.friction_static=0.3",
        ],
    );
    let setup = setup.unwrap().setup;
    assert_eq!(setup.fenders.len(), 9);
    assert!(setup.fenders.iter().all(|fender| fender.factors.constant == 1.1));
    assert!(setup.materials.iter().all(|material| material.material.friction_static == 0.3));
}

#[track_caller]
fn check_set(setting: &str, key: &str, fragment: &str) {
    let error = parse(&format!("{START}{ROW}{TYPE}"), &[setting]).expect_err(setting);
    assert_eq!(error.key(), Some(key), "{error}");
    assert!(error.to_string().contains(fragment), "{error}");
    assert!(error.to_string().contains(&format!("--set {setting}")), "{error}");
}

/// What Python's tree of a scenario is made of.
#[test]
fn the_keys_that_a_setting_stands_for() {
    let text = format!("{START}{ROW}{TYPE}");
    let set = |settings: &[&str]| {
        let settings: Vec<_> = settings.iter().map(|text| Override::parse(text).unwrap()).collect();
        let keys = set_keys(&text, "x.toml", &settings).unwrap();
        keys.into_iter()
            .map(|(path, value)| format!("{}={value}", path.join(".")))
            .collect::<Vec<_>>()
    };
    assert_eq!(set(&["fender.a_3.tolerance=1 %"]), ["fender_row.a.exception.a_3.tolerance=1 %"]);
    assert_eq!(
        set(&["fender.a_3.tolerance=0.1", "fender.*.tolerance=0.2"])[1..],
        ["fender_row.a.tolerance=0.2", "fender_row.a.exception.a_3.tolerance=0.2"]
    );
    assert_eq!(
        set(&["material.*.restitution=0"]),
        ["material.concrete.restitution=0", "material.facing.restitution=0"]
    );
    assert_eq!(set(&["time.step=1"]), ["time.step=1"]);
}

#[test]
fn settings_that_meet_nothing_are_refused() {
    check_set("fender.b_*.tolerance=0", "fender.b_*.tolerance", "no table that the pattern");
    check_set("fender.a_9.tolerance=0", "fender_row.a.exception.a_9", "\"a_1\" to \"a_8\"");
    check_set("fender.b.tolerance=0", "fender", "the file has no `fender`");
    check_set("body.x*.mass=0", "body.x*.mass", "no table that the pattern");
    check_set("material.*=0", "material.*", "stands for whole tables");
    check_set("fender_row.a.tolerence=0", "fender_row.a.tolerence", "did you mean `tolerance`?");
    check_set("fender.a_3.tolerence=0", "fender_row.a.exception.a_3.tolerence", "`tolerance`");
    check_set("fender_row.a.temperature=300", "fender_row.a.temperature", "at most 80");
}

/// `part` becomes `mistake`; the error is about `key`, in the line of the mistake.
#[track_caller]
fn check(text: &str, part: &str, mistake: &str, key: &str, fragment: &str) {
    assert!(text.contains(part), "{part}");
    let error = parse(&text.replacen(part, mistake, 1), &[]).expect_err(mistake);
    assert_eq!(error.key(), Some(key), "{error}");
    assert!(error.line().is_some() && error.to_string().contains(fragment), "{error}");
}

#[test]
fn mistakes_in_rows_name_row_key_and_line() {
    let text = format!("{START}{ROW}{TYPE}");
    let bad = |part, mistake, key: &str, fragment| {
        check(&text, part, mistake, &format!("fender_row.a{key}"), fragment);
    };
    bad("number = 8", "number = 9.5", ".number", "whole number");
    bad("number = 8", "number = 0", ".number", "at least 1");
    bad("number = 8", "number = 10", ".number", "hangs over the end of the quay");
    bad(
        "number = 8",
        "number = 10",
        ".number",
        "on 170 m there is room for 9 at a spacing of 20 m",
    );
    bad("number = 8", "number = 10", ".number", "or for 10 at a spacing of 18.888 m");
    bad("number = 8\n", "", ".number", "two of the keys `spacing`, `number` and `last`");
    bad("number = 8", "number = 8\nlast = [0, 0]", ".last", "two of");
    bad("number = 8", "last = [71, 0]", ".last", "not a multiple of the spacing");
    bad("number = 8", "last = [-70, 0]", ".last", "at the place of the first fender");
    bad("\"20 m\"", "\"2 m\"", ".width", "overlap at a spacing of 2 m");
    bad("[-70, 0]", "[-70, 4]", ".first", "not on the outline");
    bad("[-70, 0]", "[-100, 0]", ".first", "is a corner");
    bad("first = [-70, 0]\n", "", ".first", "or give a `wall`, a `quay_line` or `dolphins`");
    bad("on = \"quay\"\n", "", ".on", "name the body");
    bad("on = \"quay\"", "on = \"kway\"", ".on", "no body \"kway\"");
    bad("[-70, 0]", "[-70, 0]\nfacing = \"90 deg\"", ".facing", "faces into \"quay\"");
    bad("[-70, 0]", "[-70, 0]\nfacing = \"90 deg\"", ".facing", "is -90 deg");
    bad("[-70, 0]", "[-70, 0]\noutline = [[0, 0], [1, 0], [1, 1]]", ".outline", "`dolphins`");
    bad("[-70, 0]", "[-70, 0]\nfrom_corner = 3", ".from_corner", "`wall`");
    bad("[-70, 0]", "[-70, 0]\nwall = [[-100, 0], [100, 0]]", ".first", "`wall`");
    bad("first = [-70, 0]", "wall = [[-100, 5], [100, 0]]", ".wall", "no edge");
    bad("first = [-70, 0]", "wall = [[-100, 0]]", ".wall", "must be 2 points, but has 1");
    bad("first = [-70, 0]", "wall = [[-60, 0], [60, 0]]", ".number", "hangs over the end");
    // 120 m hold seven at 20 m, or eight at 120 / 7 = 17.143 m.
    bad(
        "first = [-70, 0]",
        "wall = [[-60, 0], [60, 0]]",
        ".number",
        "on 120 m there is room for 7 at",
    );
    bad(
        "first = [-70, 0]",
        "wall = [[-60, 0], [60, 0]]",
        ".number",
        "or for 8 at a spacing of 17.142 m",
    );
    bad(
        "first = [-70, 0]",
        "wall = [[100, 0], [-100, 0]]\nfrom_corner = 90",
        ".number",
        "on 110 m there is room for 6 at",
    );
    bad("[-70, 0]", "[-70, 0]\nfacing = -90", ".facing", "write \"-90 deg\" if you meant");
    bad("[-70, 0]", "[-70, 0]\nfacing = \"-400 deg\"", ".facing", "must be at least -6.3 rad");
    bad("\"1.2 m\"", "1200", ".height", "write \"1200 mm\" if you meant");
    bad("\"2.4 m\"", "2400", ".width", "write \"2400 mm\" if you meant");
    bad("height = ", "tolerance = 10\nheight = ", ".tolerance", "for a percentage write \"10 %\"");
    bad("[-70, 0]", "[-70, 0]\ndolphins = [[0, 0]]", ".on", "does not go together");
    bad("type = \"cone\"", "type = \"kone\"", ".type", "did you mean \"cone\"?");
    bad("width = \"2.4 m\"\n", "", ".width", "missing");
    bad("[-70, 0]", "[-70, 0]\nexception = {b_1 = {}}", ".exception.b_1", "\"a_1\" to \"a_8\"");
}

#[test]
fn names_of_rows_do_not_clash() {
    let single = "\n[fender.a_3]\non = \"quay\"\nposition = [90, 0]";
    let text = format!("{START}{single}{TYPE}{ROW}{TYPE}");
    check(&text, "", "", "fender_row.a", "a fender named \"a_3\" already");
    let row = "\n[fender_row.q]\ndolphins = [[0, 0]]\noutline = [[-2, 0], [2, 0], [2, 4]]";
    let text = format!("{START}{row}{TYPE}")
        .replace("body.quay", "body.q_1")
        .replace("\"quay\"]", "\"q_1\"]");
    check(&text, "", "", "fender_row.q.dolphins", "a body named \"q_1\" already");
}

#[test]
fn a_panel_beyond_the_end_of_the_quay_gives_a_notice() {
    let scenario = with_row(&ROW.replace("[-70, 0]", "[-99, 0]"));
    let [notice] = scenario.notices.as_slice() else { panic!("{:?}", scenario.notices) };
    assert_eq!(notice.key, "fender_row.a.number");
    assert!(notice.message.contains("reaches beyond the edge from [-100, 0] to [100, 0]"));
}

#[test]
fn the_temperature_of_a_row_by_the_command_line() {
    let constant = |setting: &str| fenders(&[setting])[7].factors.constant;
    let forty = constant("fender_row.a.temperature=40");
    assert!(forty < 1.0, "warm rubber is softer");
    assert_eq!(constant("fender_row.a.temperature=\"40 degC\""), forty);
    assert_eq!(constant("fender_row.a.temperature=40 degC"), forty);
    assert_eq!(constant("fender.*.temperature=104 degF"), forty);
    check_set("fender_row.a.temperature=300", "fender_row.a.temperature", "write 26.85");
    check_set("fender_row.a.temperature=300 K", "fender_row.a.temperature", "\"26.85 degC\"");
    check_set("fender_row.a.temperature=300 degC", "fender_row.a.temperature", "at most 80 °C");
    check_set("fender_row.a.rated_reaction=60 t", "fender_row.a.rated_reaction", "write tf");
}
