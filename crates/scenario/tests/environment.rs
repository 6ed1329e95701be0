//! Wind, current, waves, squat and banks from scenarios: their effect on a ship, and mistakes that are refused.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use fenderline_contact::{Vec2, vec2};
use fenderline_scenario::{Notice, Scenario, ScenarioError};
use fenderline_sim::environment::waves::{ShipInWaves, first_order_motion};
use fenderline_sim::environment::wind::ShipWindage;
use fenderline_sim::{Simulation, WorldEventKind};

/// The paper's container ship alone in open water.
const SHIP: &str = r#"
[time]
step = "0.5 s"
duration = "5 min"

[environment]
# environment

[vessel.container]
length_bp = "298 m"
beam = "46 m"
draught = "9 m"
block_coefficient = 0.694
propeller = { diameter = "7.8 m", full = "95 rpm" }
rudder = { area = "48 m^2", span = "8 m" }
# vessel

[body.ship]
vessel = "container"
outline = [[-149, -23], [149, -23], [149, 23], [-149, 23]]
# body
"#;

/// The scenario with lines in place of its comments, and files by name.
fn read(places: &[(&str, &str)], files: &[(&str, &str)]) -> Result<Scenario, ScenarioError> {
    let text = places.iter().fold(SHIP.to_owned(), |text, (place, lines)| {
        let comment = format!("# {place}\n");
        assert!(text.contains(&comment), "{place}");
        text.replace(&comment, &format!("{lines}\n"))
    });
    Scenario::parse_among(&text, "ship.toml", &[], &mut |name| {
        let file = files.iter().find(|(known, _)| *known == name);
        file.map(|(_, text)| (*text).to_owned()).ok_or(format!("{name}: there is no such file"))
    })
}

#[track_caller]
fn good(places: &[(&str, &str)], files: &[(&str, &str)]) -> Scenario {
    read(places, files).unwrap_or_else(|error| panic!("{error}"))
}

#[track_caller]
fn refused(places: &[(&str, &str)], files: &[(&str, &str)], key: &str, fragments: &[&str]) {
    let error = read(places, files).expect_err(fragments[0]);
    let shown = error.to_string();
    assert_eq!(error.key(), Some(key), "{shown}");
    assert!(error.line().is_some(), "{shown}");
    for fragment in fragments {
        assert!(shown.contains(fragment), "{fragment}: {shown}");
    }
}

const AREAS: &str =
    "frontal_area = \"1700 m^2\", lateral_area = \"9000 m^2\", centroid_height = \"15 m\"";

fn windage(method: &str) -> ShipWindage {
    let lines = format!("windage = {{ {AREAS}, {method} }}");
    let scenario = good(&[("vessel", &lines)], &[]);
    scenario.setup.world.vessels[0].windage.clone().expect("she has wind areas")
}

/// The numbers of validation/independent/ship_formulas.py, to half of the last digit.
#[test]
fn isherwood_and_blendermann_give_their_coefficients_through_a_scenario() {
    let isherwood = windage(
        "method = \"isherwood\", perimeter = 700, superstructure_area = 1500, mast_groups = 1",
    );
    let blendermann = windage("type = \"container ship, loaded\"");
    for (ship, [abeam, oblique, ahead]) in
        [(isherwood, [0.781, 0.664, -0.467]), (blendermann, [0.900, 0.899, -0.55])]
    {
        assert!((ship.coefficients(FRAC_PI_2).sway - abeam).abs() <= 0.5e-3);
        assert!((ship.coefficients(FRAC_PI_3).sway - oblique).abs() <= 0.5e-3);
        assert!((ship.coefficients(0.0).surge - ahead).abs() <= 0.5e-3);
    }
}

/// No printed number was found for Fujiwara's method. It has the signs of the others, and their size within a half.
#[test]
fn fujiwara_agrees_roughly_with_the_other_methods() {
    let ship = windage(
        "method = \"fujiwara\", deck_area = 5500, deck_centroid_forward = 0, top_height = \"45 m\"",
    );
    let abeam = ship.coefficients(FRAC_PI_2).sway;
    assert!((abeam / 0.84 - 1.0).abs() < 0.5, "{abeam}");
    assert!(ship.coefficients(0.0).surge < 0.0);
}

#[test]
fn wind_coefficients_refer_to_the_length_overall_where_it_is_given() {
    let of = |extra: &str| windage(&format!("type = \"ferry\"{extra}")).length_m;
    assert_eq!(of(""), 298.0);
    assert_eq!(of(", length_overall = \"310 m\""), 310.0);
}

#[test]
fn a_method_without_its_particulars_or_with_those_of_another_is_refused() {
    let of = |method: &str, key: &str, fragments: &[&str]| {
        let lines = format!("windage = {{ {AREAS}, {method} }}");
        refused(&[("vessel", &lines)], &[], key, fragments);
    };
    let windage = "vessel.container.windage";
    let key = |name: &str| format!("{windage}.{name}");
    of("type = \"fery\"", &key("type"), &["did you mean \"ferry\"?"]);
    of("method = \"blendermann\"", &key("type"), &["is missing", "needs this key"]);
    of("method = \"isherwod\"", &key("method"), &["did you mean \"isherwood\"?"]);
    of("method = \"isherwood\"", &key("perimeter"), &["is missing", "write perimeter"]);
    of(
        "method = \"isherwood\", perimeter = 700, superstructure_area = 1500, mast_groups = 1, type = \"ferry\"",
        &key("type"),
        &["is for the method \"blendermann\"", "remove it"],
    );
    of(
        "method = \"fujiwara\", deck_area = 5500, top_height = 45",
        &key("deck_centroid_forward"),
        &["missing"],
    );
    // Impossible particulars.
    let isherwood = |perimeter: &str, superstructure: &str| {
        format!(
            "method = \"isherwood\", perimeter = {perimeter}, superstructure_area = {superstructure}, mast_groups = 1"
        )
    };
    of(&isherwood("200", "1500"), windage, &["perimeter", "between 298 and 2980"]);
    of(&isherwood("700", "9500"), windage, &["superstructure", "between 0 and 9000"]);
    of(&isherwood("nan", "1500"), &key("perimeter"), &["not a finite number"]);
    // Far outside the range of the regression: an impossible coefficient.
    of(
        "method = \"fujiwara\", deck_area = 0.01, deck_centroid_forward = 0, top_height = 45",
        windage,
        &["coefficient of the longitudinal wind force"],
    );
}

/// The mean over a draught of 9 m of a current of 1 m/s at the surface and 0.4 m/s from 6 m down, by trapezoids:
/// (0.7·6 + 0.4·3)/9.
#[test]
fn a_current_by_depth_is_averaged_over_the_draught() {
    let lines = "current = { profile = [{ depth = 0, speed = 1, towards = \"90 deg\" }, \
                 { depth = 6, speed = 0.4, towards = \"90 deg\" }] }";
    let scenario = good(&[("environment", lines)], &[]);
    let current = scenario.setup.world.environment.current.expect("a current");
    let velocity = current.velocity(Vec2::ZERO, 0.0, 9.0);
    assert!((velocity - vec2(0.0, (4.2 + 1.2) / 9.0)).length() < 1e-12, "{velocity:?}");
}

/// A field that is linear in north, east and time is reproduced exactly for any order of the rows.
#[test]
fn a_current_on_a_grid_is_linear_in_place_and_time() {
    let field = |t: f64, n: f64, e: f64| vec2(0.5 + n / 1e3 - t / 3e3, -0.2 + e / 1e3);
    let mut rows = Vec::new();
    for east in [200.0, -200.0, 50.0] {
        for t in [600.0, 0.0] {
            for north in [0.0, 400.0] {
                let v = field(t, north, east);
                rows.push(format!("{t},{north},{east},{},{}", v.x, v.y));
            }
        }
    }
    let file = format!("t_s,north_m,east_m,north_mps,east_mps\n{}\n", rows.join("\n"));
    let lines = "current = { file = \"grid.csv\" }";
    let scenario = good(&[("environment", lines)], &[("grid.csv", &file)]);
    let current = scenario.setup.world.environment.current.expect("a current");
    for (t, n, e) in [(0.0, 0.0, 0.0), (150.0, 30.0, 120.0), (599.0, 399.0, -199.0)] {
        let velocity = current.velocity(vec2(n, e), t, 9.0);
        assert!((velocity - field(t, n, e)).length() < 1e-12, "{velocity:?}");
    }
    // Beyond the grid the value at the edge.
    assert_eq!(
        current.velocity(vec2(9e5, 0.0), 9e9, 9.0),
        current.velocity(vec2(400.0, 0.0), 600.0, 9.0)
    );
}

/// Accelerating water moves a hull by its pressure gradient, not by drag alone. A ship adrift in a current that grows
/// and turns has the current's velocity at every step, to rounding.
#[test]
fn a_ship_adrift_follows_a_current_as_it_sets_in() {
    let file = "t_s,north_mps,east_mps\n0,0,0\n1200,0.1,0.5\n2400,-0.4,0.2\n";
    let scenario =
        good(&[("environment", "current = { file = \"stream.csv\" }")], &[("stream.csv", file)]);
    let current = scenario.setup.world.environment.current.clone().expect("a current");
    let mut setup = scenario.setup;
    setup.duration_s = 3000.0;
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    while !simulation.is_done() {
        simulation.step().expect("a good step");
        let (state, t_s) = (simulation.states()[0], simulation.velocity_time_s());
        let behind = state.velocity_mps - current.velocity(state.position_m, t_s, 9.0);
        assert!(behind.length() < 1e-9 && state.yaw_rate_radps.abs() < 1e-12, "{t_s}: {state:?}");
    }
}

/// A steady stream that narrows, U = 0.2 + 0.8 n/10 000 m/s to the north. A particle that starts at n = 0 is at
/// 2500 (e^(t/12 500 s) − 1) after t. A ship adrift is there to within 0.1 %.
#[test]
fn a_ship_adrift_follows_a_stream_that_narrows() {
    let file = "north_m,east_m,north_mps,east_mps\n0,0,0.2,0\n10000,0,1,0\n";
    let scenario = good(
        &[
            ("environment", "current = { file = \"narrows.csv\" }"),
            ("body", "velocity = { surge = 0.2 }"),
        ],
        &[("narrows.csv", file)],
    );
    let mut setup = scenario.setup;
    setup.duration_s = 10_000.0;
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    let there_m = 2500.0 * ((10_000.0 / 12_500.0_f64).exp() - 1.0);
    let north_m = simulation.states()[0].position_m.x;
    assert!((north_m / there_m - 1.0).abs() < 1e-3, "{north_m} {there_m}");
}

#[test]
fn a_broken_file_of_currents_is_refused_at_its_line() {
    let of = |file: &str, fragments: &[&str]| {
        let lines = "current = { file = \"c.csv\" }";
        refused(
            &[("environment", lines)],
            &[("c.csv", file)],
            "environment.current.file",
            fragments,
        );
    };
    of("t_s,north_mps,east_mps\n0,1e6,0\n", &["c.csv:2:3", "between -15 and 15, but is 1000000"]);
    of(
        "t_s,north_mps,east_mps\n0,0.1,0\n60,NaN,0\n",
        &["c.csv:3:4", "not a finite number", "\"NaN\""],
    );
    of("t_s,north_mps,east_mps\n0,0.1,0\n60,,0\n", &["c.csv:3", "is empty here"]);
    of("t_s,north_mps,east_mps\n0,0.1,0\n0,0.2,0\n", &["c.csv:3", "second row for t_s = 0"]);
    of(
        "north_m,east_m,north_mps,east_mps\n0,0,0.1,0\n0,9,0.1,0\n9,9,0.1,0\n",
        &[
            "c.csv:1",
            "no row for north_m = 9, east_m = 0",
            "the file needs one row for each combination",
        ],
    );
    of("north_m,north_mps,east_mps\n0,0.1,0\n", &["c.csv:1", "`east_m` is missing"]);
    of("t_s,north_mps\n0,0.1\n", &["c.csv:1", "`east_mps` is missing"]);
    of("t_s,north_mps,east_mps,speed_mps\n0,0.1,0,0\n", &["c.csv:1", "not as both"]);
    of("north_mps,east_mps\n0.1,0\n", &["c.csv:1", "neither times"]);
    of("t_s,nort_mps,east_mps\n0,0.1,0\n", &["c.csv:1:5", "did you mean `north_mps`?"]);
    of("t_s,speed_mps,towards_deg\n0,-0.1,0\n", &["c.csv:2:3", "between 0 and 15"]);
    let error = read(&[("environment", "current = { file = \"d.csv\" }")], &[]).unwrap_err();
    assert!(error.to_string().contains("cannot read d.csv"), "{error}");
}

#[test]
fn a_current_or_wind_is_given_in_one_way() {
    let of = |lines: &str, key: &str, fragments: &[&str]| {
        refused(
            &[("environment", lines)],
            &[
                ("c.csv", "t_s,speed_mps,towards_deg\n0,1,0\n"),
                ("w.csv", "t_s,speed_mps,from_deg\n0,1,0\n"),
            ],
            key,
            fragments,
        );
    };
    of("current = { speed = 1 }", "environment.current.towards", &["is missing", "or a `file`"]);
    of("current = {}", "environment.current.speed", &["is missing"]);
    of(
        "current = { file = \"c.csv\", speed = 1 }",
        "environment.current.speed",
        &["together with `file`"],
    );
    of("current = { profile = [] }", "environment.current.profile", &["needs 1 entries"]);
    let layers = "[{ depth = 5, speed = 1, towards = 0 }, { depth = 5, speed = 1, towards = 0 }]";
    of(
        &format!("current = {{ profile = {layers} }}"),
        "environment.current.profile",
        &["must increase"],
    );
    of(
        "current = { speed = \"1e6 m/s\", towards = 0 }",
        "environment.current.speed",
        &["at most 15"],
    );
    of("wind = { from = 0 }", "environment.wind.speed", &["is missing"]);
    of(
        "wind = { file = \"w.csv\", gusts = true }",
        "environment.wind.gusts",
        &["together with `file`"],
    );
    of("wind = { file = \"w.csv\", from = 0 }", "environment.wind.from", &["together with `file`"]);
}

/// A regular wave runs in one direction.
#[test]
fn a_regular_wave_has_no_spreading() {
    let of = |lines: &str, key: &str, fragments: &[&str]| {
        refused(&[("environment", lines)], &[], key, fragments);
    };
    let wave = "waves = { height = 2, period = 8, from = 0, regular = true, spreading = 2 }";
    of(wave, "environment.waves.spreading", &["together with `regular`"]);
    let wide = "waves = { height = 2, period = 8, from = 0, spreading = 0.5 }";
    of(wide, "environment.waves.spreading", &["at least 1"]);
}

/// Regular waves of 5 s break at 5.5 m in deep water, and a sea of 12 s in 10 m of water at 8 m.
#[test]
fn a_sea_beyond_breaking_is_refused() {
    let of = |lines: &str, key: &str, fragments: &[&str]| {
        refused(&[("environment", lines)], &[], key, fragments);
    };
    let steep = "waves = { height = 6, period = 5, from = 0, regular = true }";
    of(steep, "environment.waves", &["wave height", "break"]);
    let sea = "waves = { height = 6, period = 5, from = 0 }";
    of(sea, "environment.waves", &["significant wave height", "break"]);
    let shallow = "depth = \"10 m\"\nwaves = { height = 9, period = 12, from = 0 }";
    of(shallow, "environment.waves", &["significant wave height", "break"]);
}

/// From 350° to 10° the wind turns through north, not through south.
#[test]
fn a_wind_in_time_turns_the_shorter_way() {
    let file = "t_s,speed_mps,from_deg\n0,10,350\n600,14,10\n";
    let scenario = good(&[("environment", "wind = { file = \"w.csv\" }")], &[("w.csv", file)]);
    let wind = scenario.setup.world.environment.wind.expect("a wind");
    assert!((wind.velocity(10.0, 300.0) - vec2(-12.0, 0.0)).length() < 1e-12);
    assert!((wind.velocity(10.0, -9.0).length() - 10.0).abs() < 1e-12, "held before the first");
    assert!((wind.velocity(10.0, 9e9).length() - 14.0).abs() < 1e-12, "and after the last");
    let of = |file: &str, fragments: &[&str]| {
        let lines = "wind = { file = \"w.csv\" }";
        refused(&[("environment", lines)], &[("w.csv", file)], "environment.wind.file", fragments);
    };
    of("t_s,speed_mps,from_deg\n0,1e6,0\n", &["w.csv:2:3", "between 0 and 120"]);
    of("t_s,speed_mps,from_deg\n0,inf,0\n", &["w.csv:2:3", "not a finite number"]);
    of("t_s,speed_mps\n0,1\n", &["`from_deg` is missing"]);
}

const HEADER: &str = "omega_radps,heading_deg,heave_mpm,heave_phase_deg,roll_degpm,roll_phase_deg,pitch_degpm,pitch_phase_deg";

/// One regular wave of 2 m height from port abeam. The table has 1.5 m/m of heave a quarter of a period ahead of the
/// crest, and 2 deg/m of roll in phase with it: the motions at midship are 1.5 cos(ωt + 90°) and 2° cos(ωt).
#[test]
fn a_response_table_gives_the_motions() {
    let file =
        format!("{HEADER}\n0.5,0,1,180,0,0,0,0\n0.5,90,1.5,90,2,0,0,0\n0.5,180,1,180,0,0,0,0\n");
    let scenario = good(
        &[
            (
                "environment",
                "waves = { height = 2, period = 10, from = \"270 deg\", regular = true }",
            ),
            ("vessel", "wave_response = \"response.csv\""),
        ],
        &[("response.csv", &file)],
    );
    assert!(other_notices(&scenario).is_empty(), "{:?}", scenario.notices);
    let environment = &scenario.setup.world.environment;
    let sea = environment.sea.as_ref().expect("waves");
    let response = scenario.setup.world.vessels[0].response.as_ref().expect("a response");
    let omega = core::f64::consts::TAU / 10.0;
    for t_s in [0.0, 1.3, 7.7] {
        let place =
            ShipInWaves { position_m: Vec2::ZERO, velocity_mps: Vec2::ZERO, heading_rad: 0.0 };
        let motion = first_order_motion(sea, response, &place, t_s).motion;
        let heave_m = 1.5 * (omega * t_s + FRAC_PI_2).cos();
        let roll_rad = 2.0_f64.to_radians() * (omega * t_s).cos();
        assert!((motion[2] - heave_m).abs() < 1e-9, "{t_s}: {motion:?}");
        assert!((motion[3] - roll_rad).abs() < 1e-9, "{t_s}: {motion:?}");
        assert_eq!([motion[0], motion[1], motion[5]], [0.0; 3], "no motion without a column");
    }
    // A step of the simulation reports it, also without `stability`.
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let record = simulation.step().expect("a good step");
    assert!(record.vessels[0].wave_motion.motion[2].abs() > 0.1);
}

#[test]
fn a_response_table_that_lacks_headings_or_has_holes_is_refused() {
    let of = |rows: &str, fragments: &[&str]| {
        let file = format!("{HEADER}\n{rows}");
        let files = [("response.csv", file.as_str())];
        let lines = [("vessel", "wave_response = \"response.csv\"")];
        refused(&lines, &files, "vessel.container.wave_response", fragments);
    };
    let row = |omega: f64, heading: f64| format!("{omega},{heading},1,180,0,0,0,0\n");
    of(&format!("{}{}", row(0.5, 0.0), row(0.5, 90.0)), &["from 0 to 180 degrees", "from 0 to 90"]);
    of(&row(0.5, 0.0), &["from 0 to 180 degrees"]);
    of(
        &format!("{}{}{}", row(0.5, 0.0), row(0.5, 180.0), row(0.7, 0.0)),
        &["no row for omega_radps = 0.7, heading_deg = 180"],
    );
    of(
        &format!("{}{}", row(0.5, 0.0), row(0.5, 270.0)),
        &["response.csv:3:5", "between 0 and 180"],
    );
    of("0.5,0,1,nan,0,0,0,0\n", &["response.csv:2:9", "not a finite number"]);
    of("0.5,0,-1,0,0,0,0,0\n0.5,180,1,0,0,0,0,0\n", &["response.csv:2:7", "`heave_mpm` must be"]);
    let files =
        [("response.csv", "omega_radps,heading_deg,heave_mpm,heave_phase_deg\n0.5,0,1,180\n")];
    let lines = [("vessel", "wave_response = \"response.csv\"")];
    let key = "vessel.container.wave_response";
    refused(&lines, &files, key, &["response.csv:1", "`roll_degpm` is missing"]);
}

/// The notices but one: the ship's beam over draught is outside the range of the estimate.
fn other_notices(scenario: &Scenario) -> Vec<&Notice> {
    let (of_her, other): (Vec<_>, Vec<_>) =
        scenario.notices.iter().partition(|notice| notice.key == "vessel.container.beam");
    assert_eq!(of_her.len(), 1, "{:?}", scenario.notices);
    // A table of response does nothing without waves, which is told too.
    other.into_iter().filter(|notice| !notice.is_without_effect()).collect()
}

/// With heave positive up in the table, the ship would sink on the crest of the longest wave. A notice says so.
#[test]
fn a_response_table_with_the_wrong_sign_of_heave_gets_a_notice() {
    let file = format!("{HEADER}\n0.2,0,1,0,0,0,0,0\n0.2,180,1,0,0,0,0,0\n");
    let lines = [("vessel", "wave_response = \"response.csv\"")];
    let scenario = good(&lines, &[("response.csv", &file)]);
    let [notice] = other_notices(&scenario)[..] else { panic!("{:?}", scenario.notices) };
    assert!(notice.message.contains("sinks on the crest"), "{notice:?}");
}

/// Squat at 8 kn and 1.2 draughts, computed by hand from the three formulas, to half of the last digit.
#[test]
fn a_ship_under_way_squats_by_the_chosen_formula() {
    for (squat, expected_m) in
        [("icorels", 0.404), ("barrass", 0.444), ("eryuzlu", 0.3396), ("none", 0.0)]
    {
        let water = format!("depth = 10.8\nsquat = \"{squat}\"");
        let scenario =
            good(&[("environment", &water), ("body", "velocity = { surge = \"8 kn\" }")], &[]);
        let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
        let record = simulation.step().expect("a good step");
        let ours_m = record.vessels[0].squat_m;
        assert!((ours_m - expected_m).abs() < 0.5e-3, "{squat}: {ours_m}");
    }
    // ICORELS is the default; there is no squat in deep water.
    for (water, expected_m) in [("depth = 10.8", 0.404), ("", 0.0)] {
        let scenario =
            good(&[("environment", water), ("body", "velocity = { surge = \"8 kn\" }")], &[]);
        let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
        let record = simulation.step().expect("a good step");
        assert!((record.vessels[0].squat_m - expected_m).abs() < 0.5e-3);
    }
    refused(
        &[("environment", "squat = \"barrass\"")],
        &[],
        "environment.squat",
        &["needs a `depth` or a `bottom` in the same table"],
    );
    let far = good(&[("environment", "depth = 40\nsquat = \"barrass\"")], &[]);
    let [notice] = other_notices(&far)[..] else { panic!("{:?}", far.notices) };
    assert!(notice.message.contains("covers depths of up to 1.4 draughts"), "{notice:?}");
}

/// With 0.95 m under the keel and more squat than that at 14 kn, she runs aground and slows down, and the run
/// continues. The event is reported when the grounding begins, not with every step.
#[test]
fn squat_runs_a_fast_ship_aground() {
    let water = [("environment", "depth = 9.95"), ("body", "velocity = { surge = \"14 kn\" }")];
    let mut simulation = Simulation::new(good(&water, &[]).setup).expect("a good set-up");
    let (mut events, mut deepest_m) = (0, 0.0_f64);
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        events += record.world_events.iter().filter(|e| e.kind == WorldEventKind::Aground).count();
        deepest_m = deepest_m.max(record.vessels[0].squat_m);
    }
    let speed_mps = simulation.states()[0].velocity_mps.length();
    assert!(deepest_m > 0.95 && (1..=3).contains(&events), "{deepest_m} m, {events} events");
    assert!(speed_mps > 0.0 && speed_mps < 14.0 * 1852.0 / 3600.0, "{speed_mps}");
    // Slowly over the same ground she floats.
    let slow = [("environment", "depth = 9.95"), ("body", "velocity = { surge = \"2 kn\" }")];
    let mut simulation = Simulation::new(good(&slow, &[]).setup).expect("a good set-up");
    let record = simulation.step().expect("a good step");
    assert!(!record.vessels[0].aground);
}

/// Shallow-water corrections cover 1.2 draughts and more. A notice names the vessel's key and the bound.
#[test]
fn water_too_shallow_for_the_corrections_gives_a_notice() {
    for (depth, expected) in [
        ("10.9", &[][..]),
        (
            "10.4",
            &[
                "in water of 1.16 draughts",
                "valid from 1.2 draughts on",
                "extrapolates them linearly",
            ],
        ),
        ("9.6", &["in water of 1.07 draughts", "less than 1.1", "keep their values at 1.1"]),
    ] {
        let water = format!("depth = {depth}");
        let scenario = good(&[("environment", &water)], &[]);
        let notices = other_notices(&scenario);
        assert_eq!(notices.len(), usize::from(!expected.is_empty()), "{notices:?}");
        for (notice, fragment) in notices.iter().flat_map(|n| expected.iter().map(move |f| (n, f)))
        {
            assert_eq!(notice.key, "vessel.container");
            assert!(notice.message.contains(fragment), "{fragment}: {}", notice.message);
        }
    }
}

/// Squat lowers the ship but not the fenders, so their force acts higher above her centre of gravity and heels her
/// more. She slides along a wall with a long face at 8 kn, pressed on it by 2 MN. With squat s the heel is larger by N
/// s/(W GM). The means are from 80 to 900 s because she still sways on the face: over only four minutes the heel would
/// vary by 4 %.
#[test]
fn squat_moves_the_height_of_contact() {
    let heel = |squat: &str| {
        let water = format!("depth = 10.8\nsquat = \"{squat}\"");
        let scenario = good(
            &[
                ("environment", &water),
                (
                    "vessel",
                    "stability = { gm = 5, gravity_above_keel = 19, waterplane_area = 10612 }",
                ),
                ("body", WALL),
            ],
            &[],
        );
        let mut setup = scenario.setup;
        setup.duration_s = 900.0;
        let mut simulation = Simulation::new(setup).expect("a good set-up");
        let (mut heel_rad, mut arm_nm, mut steps) = (0.0, 0.0, 0.0);
        while !simulation.is_done() {
            let record = simulation.step().expect("a good step");
            if record.t_s < 80.0 {
                continue;
            }
            let force_n: f64 = record.contacts.iter().map(|c| c.normal_force_n).sum();
            arm_nm += force_n * record.vessels[0].squat_m;
            heel_rad += record.vessels[0].attitude.roll.value;
            steps += 1.0;
        }
        (heel_rad / steps, arm_nm / steps)
    };
    let (deep, shallow) = (heel("none"), heel("barrass"));
    assert_eq!(deep.1, 0.0);
    let by_hand_rad = shallow.1 / (1025.0 * 0.694 * 298.0 * 46.0 * 9.0 * 9.806_65 * 5.0);
    let more_rad = (shallow.0 - deep.0).abs();
    assert!(by_hand_rad > 5e-5, "{by_hand_rad}");
    assert!((more_rad / by_hand_rad - 1.0).abs() < 0.02, "{more_rad} {by_hand_rad}");
}

const WALL: &str = r#"
velocity = { surge = "8 kn" }

[body.wall]
fixed = true
outline = [[-300, 25], [4000, 25], [4000, 45], [-300, 45]]

[material.smooth]
stiffness = "1 MN/m^2"
damping = "0.3 MN.s/m^2"

[fender.face]
on = "wall"
position = [310, 25]
facing = "-90 deg"
width = "1000 m"
projection = "1.5 m"
above_water = "2 m"
material = "smooth"

[[pair]]
bodies = ["ship", "wall"]
material = "smooth"

[[load]]
body = "ship"
force = ["0 kN", "2 MN"]
"#;

/// With the strongest wind and current and the highest sea that a scenario may have, in shallow water beside a bank,
/// every state is finite.
#[test]
fn the_largest_admissible_environment_leaves_the_state_finite() {
    let worst = "depth = 12\nbank = [{ from = [-2000, 30], to = [2000, 30] }]\n\
                 wind = { speed = 120, from = 1, gusts = true }\ncurrent = { file = \"c.csv\" }\n\
                 waves = { height = 10, period = 20, from = 2 }";
    let files = [(
        "c.csv",
        "t_s,north_m,east_m,north_mps,east_mps\n0,0,0,15,-15\n0,0,9,-15,15\n1,0,0,-15,15\n1,0,9,15,-15\n",
    )];
    let lines = format!("windage = {{ {AREAS}, type = \"ferry\" }}");
    let scenario = good(
        &[
            ("environment", worst),
            ("vessel", &lines),
            ("body", "velocity = { surge = \"60 kn\", sway = 10, yaw = \"5 deg/s\" }"),
        ],
        &files,
    );
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        let (state, vessel) = (record.states_after[0], &record.vessels[0]);
        assert!(state.position_m.is_finite() && state.velocity_mps.is_finite(), "{state:?}");
        assert!(state.yaw_rate_radps.is_finite() && vessel.squat_m.is_finite(), "{state:?}");
        assert!(vessel.wave_motion.motion.iter().all(|motion| motion.is_finite()));
    }
}

/// A bank to starboard draws her to starboard and turns her bow to port, and the mirror image to port. The force is
/// inverse to the distance. Two banks at equal distances cancel.
#[test]
fn a_bank_attracts_the_hull_turns_the_bow_away_and_fades_with_distance() {
    let forces = |banks: &str| {
        let water = format!("depth = 12\nbank = [{banks}]");
        let scenario =
            good(&[("environment", &water), ("body", "velocity = { surge = \"6 kn\" }")], &[]);
        let noted = scenario.notices.iter().any(|notice| notice.message.contains("UNVALIDATED"));
        assert!(
            noted || banks.is_empty(),
            "a notice says that it is unvalidated: {:?}",
            scenario.notices
        );
        let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
        simulation.step().expect("a good step").vessel_forces[0].banks
    };
    let bank = |east: f64| format!("{{ from = [-2000, {east}], to = [2000, {east}] }}");
    let (near, far) = (forces(&bank(60.0)), forces(&bank(120.0)));
    assert!(near.sway_n > 0.0 && near.yaw_nm < 0.0 && near.surge_n == 0.0, "{near:?}");
    assert!((near.sway_n / far.sway_n - 2.0).abs() < 1e-9);
    assert!((near.yaw_nm / far.yaw_nm - 2.0).abs() < 1e-9);
    let port = forces(&bank(-60.0));
    assert!((port.sway_n + near.sway_n).abs() < 1e-6 && (port.yaw_nm + near.yaw_nm).abs() < 1e-3);
    let both = forces(&format!("{}, {}", bank(60.0), bank(-60.0)));
    assert!(both.sway_n.abs() < 1e-6 && both.yaw_nm.abs() < 1e-3);
    // The order of a bank's ends does not matter; a bank ahead or astern has no effect.
    let turned = forces("{ from = [2000, 60], to = [-2000, 60] }");
    assert!((turned.sway_n - near.sway_n).abs() < 1e-6);
    assert_eq!(forces("{ from = [400, 60], to = [2000, 60] }").sway_n, 0.0);
    assert_eq!(forces("").sway_n, 0.0, "off by default");
    // Norrbin's form by hand: B/y 46/60, T/h 0.75, u 6 kn.
    let u = 6.0 * 1852.0 / 3600.0;
    let unit_n = 0.5 * 1025.0 * u * u * 46.0 * 9.0 * 46.0 / 60.0;
    assert!((near.sway_n - unit_n * (0.0925 + 0.372 * 0.5625)).abs() < 1.0);
    assert!((near.yaw_nm + unit_n * 298.0 * (0.0025 + 0.0755 * 0.5625)).abs() < 100.0);
    refused(
        &[("environment", "bank = [{ from = [0, 5], to = [0, 5] }]")],
        &[],
        "environment.bank.0.to",
        &["length of a bank"],
    );
}
