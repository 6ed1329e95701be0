//! Approaches: speed and angle at a fender become position, heading and velocity, by hand calculation.

use core::f64::consts::PI;

use fenderline_contact::{Rotation, Vec2, vec2};
use fenderline_scenario::{Override, Scenario, ScenarioError};
use fenderline_sim::{Side, Simulation};

/// A ship of 100 by 20 m and a quay to the east with five fenders, whose faces are 1.2 m off it.
const TEXT: &str = r#"[time]
step = "0.05 s"
duration = "20 s"

[material.facing]
stiffness = 0

[material.concrete]
stiffness = "50 MN/m^2"

[body.ship]
outline = [[-60, -10], [40, -10], [40, 10], [-60, 10]]
mass = "9000 t"
gyradius = "25 m"
approach = { to = "quay", speed_normal = "0.15 m/s", contact = "quarter point" }

[body.quay]
fixed = true
outline = [[-100, 0], [100, 0], [100, 9], [-100, 9]]
position = [7, 30]

[fender_row.a]
on = "quay"
first = [-40, 0]
spacing = "20 m"
number = 5
width = "2.4 m"
type = "cone"
height = "1.2 m"
material = "facing"

[[pair]]
bodies = ["ship", "quay"]
material = "concrete"
"#;

fn parse(text: &str, settings: &[&str]) -> Result<Scenario, ScenarioError> {
    let overrides: Vec<_> = settings.iter().map(|text| Override::parse(text).unwrap()).collect();
    Scenario::parse_with(text, "x.toml", &overrides)
}

fn with(settings: &[&str]) -> Scenario {
    let settings: Vec<_> = settings.iter().map(|key| format!("body.ship.approach.{key}")).collect();
    let settings: Vec<&str> = settings.iter().map(String::as_str).collect();
    parse(TEXT, &settings).unwrap_or_else(|error| panic!("{error}"))
}

#[track_caller]
fn near(one: Vec2, other: Vec2) {
    assert!((one - other).length() < 1e-9, "{one:?} {other:?}");
}

#[test]
fn a_parallel_approach_is_sway_alone() {
    let setup = with(&[]).setup;
    let ship = &setup.bodies[0];
    // Midship is 10 m aft of the origin, the quarter point 25 m before midship; fender a_3 stands at 7 m north, its face
    // at 30 - 1.2 m east, and the side starts 1 m before it.
    near(ship.position_m, vec2(7.0 - 15.0, 28.8 - 1.0 - 10.0));
    assert_eq!(ship.heading_rad, 0.0);
    assert_eq!((ship.velocity.surge_mps, ship.velocity.sway_mps), (0.0, 0.15));
    let approach = &setup.approaches[0];
    assert_eq!(setup.fenders[approach.fender].name, "a_3");
    assert_eq!((approach.contact_m, approach.side), (25.0, Side::Starboard));
    assert!(!approach.is_abnormal());
}

#[test]
fn each_point_of_her_side_can_be_met() {
    let along =
        |contact: &str| with(&[&format!("contact={contact}")]).setup.approaches[0].contact_m;
    assert_eq!(along("midship"), 0.0);
    assert!((along("third point") - 100.0 / 6.0).abs() < 1e-9);
    assert_eq!(along("quarter-point"), 25.0);
    assert_eq!(along("-20 m"), -20.0);
    assert_eq!(along("12"), 12.0);
    let stern = with(&["angle=-3 deg", "distance=4"]).setup.approaches[0].contact_m;
    assert_eq!(stern, -25.0, "stern first: the quarter point aft");
}

/// At any angle, side, speed along and distance the point reaches the middle of the fender's face when the distance is
/// run, at the speed towards the berth.
#[test]
fn the_point_meets_the_middle_of_the_face() {
    for (side, angle_deg, along_mps, to_m) in [
        ("starboard", 5.0, 0.3, 4.0),
        ("starboard", -4.0, 0.0, 4.0),
        ("port", 6.0, -0.2, 4.0),
        ("port", 0.0, 0.1, 0.0),
    ] {
        let scenario = with(&[
            &format!("side={side}"),
            &format!("angle={angle_deg} deg"),
            &format!("along={along_mps}"),
            &format!("distance={to_m}"),
            "fender=a_4",
        ]);
        let setup = scenario.setup;
        let (ship, approach) = (&setup.bodies[0], &setup.approaches[0]);
        assert_eq!(setup.fenders[approach.fender].name, "a_4");
        let attitude = Rotation::from_angle(ship.heading_rad);
        let velocity = attitude.apply(vec2(ship.velocity.surge_mps, ship.velocity.sway_mps));
        let across_m = if side == "port" { -10.0 } else { 10.0 };
        let point = ship.position_m + attitude.apply(vec2(approach.contact_m - 10.0, across_m));
        assert!((velocity.y - 0.15).abs() < 1e-12, "towards the berth");
        near(point + velocity * (to_m / 0.15), vec2(27.0, 28.8));
        // Bow first: the bow is nearer to the quay than the stern.
        let bow = attitude.apply(vec2(1.0, 0.0)).y;
        assert!((bow - libm::sin(f64::to_radians(angle_deg))).abs() < 1e-12, "{side} {angle_deg}");
        let forward = if side == "port" { -1.0 } else { 1.0 };
        assert!((velocity.x - forward * along_mps).abs() < 1e-12, "forward along the berth");
    }
    let port = with(&["side=port"]).setup.bodies[0].heading_rad;
    assert!((port.abs() - PI).abs() < 1e-12);
}

#[test]
fn a_fender_by_name_is_met_by_what_comes_first() {
    let setup = with(&["contact=a_5"]).setup;
    assert_eq!(setup.approaches[0].contact_m, 0.0, "her flat side: its middle");
    near(setup.bodies[0].position_m, vec2(47.0 + 10.0, 17.8));
    let bow_first = with(&["contact=a_5", "angle=5 deg"]).setup;
    assert_eq!(bow_first.approaches[0].contact_m, 50.0, "her bow corner");
}

#[test]
fn the_run_meets_the_fender_at_that_speed() {
    let setup = parse(
        TEXT,
        &[
            "fender_row.a.number=1",
            "body.ship.approach.angle=2 deg",
            "fender_row.a.facing=-90 deg",
            "fender_row.a.first=[30, 0]",
            "fender_row.a.spacing=20",
        ],
    )
    .unwrap()
    .setup;
    let mut simulation = Simulation::new(setup).unwrap();
    while simulation.fender_summaries().next().is_none() && simulation.steps_taken() < 400 {
        simulation.step().unwrap();
    }
    let touched = simulation.fender_summaries().next().expect("the fender is touched");
    // The bow corner is nearer than the quarter point by 25 m times tan 2°, but meets no fender.
    assert!((touched.approach_speed_mps - 0.15).abs() < 0.005, "{touched:?}");
    assert!((touched.first_touch_s - 1.0 / 0.15).abs() < 0.6, "{touched:?}");
}

#[test]
fn an_abnormal_berthing_has_the_factor_in_its_speed() {
    let sway = |settings: &[&str]| {
        let setup = with(settings).setup;
        (setup.bodies[0].velocity.sway_mps, setup.approaches[0].energy_factor)
    };
    assert_eq!(sway(&["abnormal={energy_factor = 2.25}"]), (0.15 * 1.5, 2.25));
    assert_eq!(sway(&["abnormal.energy_factor=2.25"]), (0.15 * 1.5, 2.25));
    let (by_speed, factor) = sway(&["abnormal.speed_factor=1.25"]);
    assert!((by_speed - 0.1875).abs() < 1e-15 && factor == 1.5625);
    let setup = with(&["abnormal.energy_factor=1.5", "along=0.2"]).setup;
    assert!((setup.bodies[0].velocity.surge_mps - 0.2).abs() < 1e-15, "the speed along stays");
    let sentence = setup.approaches[0].sentence(&setup);
    assert_eq!(
        sentence,
        "ship meets quay, fender a_3, with her starboard side 25.0 m forward of midship at 0.184 m/s and 0.0°; abnormal \
         berthing: 1.50 times the energy, 1.22 times the normal speed of 0.150 m/s"
    );
    assert_eq!(
        setup.approaches[0].start_sentence(&setup),
        "ship starts at [-9.089 m, 17.800 m], heading 0.00°, surge 0.2000 m/s, sway 0.1837 m/s"
    );
}

const BERTHING: &str = r#"
[berthing]
ship = "ship"
length_bp = "96 m"
beam = "20 m"
draught = "6 m"
under_keel_clearance = "1 m"
block_coefficient = 0.76
abnormal_factor = 1.5
"#;

#[test]
fn the_abnormal_factor_is_not_applied_twice() {
    let text = format!("{TEXT}{BERTHING}");
    let normal = parse(&text, &[]).unwrap();
    assert_eq!(normal.setup.berthing.unwrap().abnormal_factor, Some(1.5));
    let abnormal = parse(&text, &["body.ship.approach.abnormal.energy_factor=1.5"]).unwrap();
    assert_eq!(abnormal.setup.berthing.unwrap().abnormal_factor, None);
    let [notice] = abnormal.notices.as_slice() else { panic!("{:?}", abnormal.notices) };
    assert_eq!(notice.key, "berthing.abnormal_factor");
}

#[test]
fn a_row_of_dolphins_is_a_berth() {
    let row = "[fender_row.a]\ndolphins = [[-40, 30], [7, 30], [54, 30]]\noutline = [[-3, 0], [3, 0], [3, 5], [-3, 5]]\n";
    let text = TEXT
        .replace(
            "[fender_row.a]\non = \"quay\"\nfirst = [-40, 0]\nspacing = \"20 m\"\nnumber = 5\n",
            row,
        )
        .replace("bodies = [\"ship\", \"quay\"]", "bodies = [\"ship\", \"a\"]")
        .replace("to = \"quay\"", "to = \"a\"");
    let setup = parse(&text, &[]).unwrap().setup;
    assert_eq!(setup.fenders[setup.approaches[0].fender].name, "a_2");
    near(setup.bodies[0].position_m, vec2(-8.0, 17.8));
}

/// What is met before the fender is noted: at 5 degrees her bow meets the quay before the quarter point its fender.
#[test]
fn what_is_met_first_is_noted() {
    assert_eq!(with(&[]).notices, []);
    let notices = with(&["angle=5 deg", "fender=a_3", "distance=4 m", "speed_normal=0.3"]).notices;
    let [notice] = notices.as_slice() else { panic!("{notices:?}") };
    assert_eq!(notice.key, "body.ship.approach.contact");
    assert!(notice.message.contains("the hull meets the fender \"a_4\" first"), "{notice}");
}

/// 5 m at 0.15 m/s are 33.3 s; the run lasts 20 s.
#[test]
fn an_approach_that_takes_longer_than_the_run_is_noted() {
    let notices = with(&["distance=5 m"]).notices;
    let [notice] = notices.as_slice() else { panic!("{notices:?}") };
    assert_eq!(notice.key, "body.ship.approach.distance");
    assert!(
        notice
            .message
            .contains("the 5 m to the fender take 34 s at 0.15 m/s, but the run lasts 20 s")
    );
    assert_eq!(with(&["distance=2.9 m"]).notices, []);
    assert_eq!(with(&["speed_normal=0.01 m/s"]).notices[0].key, "body.ship.approach.speed_normal");
    assert_eq!(with(&["distance=4 m", "abnormal.energy_factor=2"]).notices, [], "18.9 s");
}

#[track_caller]
fn check(part: &str, mistake: &str, key: &str, fragment: &str) {
    assert!(TEXT.contains(part), "{part}");
    let error = parse(&TEXT.replacen(part, mistake, 1), &[]).expect_err(mistake);
    assert_eq!(error.key(), Some(key), "{error}");
    assert!(error.line().is_some() && error.to_string().contains(fragment), "{error}");
}

#[test]
fn mistakes_in_approaches() {
    let bad = |mistake: &str, key: &str, fragment| {
        let whole = "contact = \"quarter point\" }";
        let key = match key {
            "position" | "heading" | "velocity" => format!("body.ship.{key}"),
            _ => format!("body.ship.approach.{key}"),
        };
        check(whole, mistake, &key, fragment);
    };
    bad("contact = \"half point\" }", "contact", "no fender \"half point\"");
    bad("contact = \"quarter pont\" }", "contact", "did you mean \"quarter point\"?");
    bad("contact = \"a_6\" }", "contact", "did you mean \"a_1\"?");
    bad("contact = \"60 m\" }", "contact", "off the hull, which reaches from -50 to 50 m");
    bad("contact = \"3 kn\" }", "contact", "a speed");
    bad("fender = \"b\", contact = 0 }", "fender", "no fender \"b\"");
    bad("fender = \"a_1\", contact = \"a_2\" }", "fender", "does not go together");
    bad("contact = 0, angle = \"50 deg\" }", "angle", "at most");
    bad("contact = 0, side = \"left\" }", "side", "\"port\"");
    bad("contact = 50, angle = \"-20 deg\" }", "distance", "starts inside the");
    bad("contact = 50, angle = \"-20 deg\" }", "distance", "or take a smaller angle");
    bad("contact = 50, angle = \"-20 deg\" }", "distance", "from 3");
    bad("contact = 0 }\nposition = [0, 0]", "position", "`approach`");
    bad("contact = 0 }\nheading = 0", "heading", "`approach`");
    bad("contact = 0 }\nvelocity = { surge = 1 }", "velocity", "`approach`");
    bad("contact = 0, abnormal = {} }", "abnormal.energy_factor", "missing");
    bad(
        "contact = 0, abnormal = { energy_factor = 1.5, speed_factor = 1.2 } }",
        "abnormal.speed_factor",
        "together",
    );
    bad(
        "contact = 0, abnormal = { energy_factor = 0.5 } }",
        "abnormal.energy_factor",
        "at least 1",
    );
    check(
        "speed_normal = \"0.15 m/s\", ",
        "speed_normal = 0, ",
        "body.ship.approach.speed_normal",
        "at least",
    );
    check("to = \"quay\"", "to = \"ship\"", "body.ship.approach.to", "alongside herself");
    check("to = \"quay\"", "to = \"kway\"", "body.ship.approach.to", "no body \"kway\"");
    check(
        "[[pair]]\nbodies = [\"ship\", \"quay\"]\nmaterial = \"concrete\"\n",
        "",
        "body.ship.approach.to",
        "never meets",
    );
    let no_fenders = TEXT.split("[fender_row.a]").next().unwrap().to_owned()
        + "[[pair]]\nbodies = [\"ship\", \"quay\"]\nmaterial = \"concrete\"\n";
    let error = parse(&no_fenders, &[]).unwrap_err();
    assert!(error.to_string().contains("\"quay\" has no fenders to meet"), "{error}");
    let fixed = TEXT.replace(
        "fixed = true",
        "fixed = true\napproach = { to = \"ship\", speed_normal = 1, contact = 0 }",
    );
    assert_eq!(parse(&fixed, &[]).unwrap_err().key(), Some("body.quay.approach"));
}
