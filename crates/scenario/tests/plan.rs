//! Passage plans from scenarios: what is read, what a run finds on them, and mistakes that are refused.

use fenderline_contact::vec2;
use fenderline_scenario::{Scenario, ScenarioError};
use fenderline_sim::{Simulation, Verdict};

const KNOT_MPS: f64 = 1852.0 / 3600.0;

/// A ship that goes straight on, beside the first leg of her plan.
const PLANNED: &str = r#"
[time]
step = "0.5 s"
duration = "60 s"

[vessel.coaster]
length_bp = 100
beam = 16
draught = 6
block_coefficient = 0.7
rudder = { area = "12 m^2", span = "4 m" }
propeller = { diameter = "4 m", full = "130 rpm" }

[body.ship]
vessel = "coaster"
outline = [[-50, -8], [50, -8], [50, 8], [-50, 8]]
position = [0, 25]
velocity = { surge = "6 kn" }
running = 0.4

[body.quay]
fixed = true
outline = [[-900, 0], [-800, 0], [-800, 50], [-900, 50]]

[plan.inbound]
vessel = "ship"
reach = "120 m"

[[plan.inbound.waypoint]]
name = "Sea buoy"
position = [0, 0]

[[plan.inbound.waypoint]]
name = "Bend"
position = [1000, 0]
turning_radius = "400 m"
speed = "6 kn"
half_width = "20 m"

[[plan.inbound.waypoint]]
position = [1000, 1200]
"#;

fn with(from: &str, to: &str) -> Result<Scenario, ScenarioError> {
    assert!(PLANNED.contains(from), "{from}");
    Scenario::parse(&PLANNED.replacen(from, to, 1), "planned.toml")
}

#[test]
fn a_plan_has_its_waypoints_turns_and_wheel_over_points() {
    let scenario = with("", "").unwrap();
    let plan = scenario.setup.world.vessels[0].plan.as_ref().expect("a plan");
    assert_eq!((plan.name.as_str(), plan.waypoints().len()), ("inbound", 3));
    let bend = &plan.waypoints()[1];
    assert_eq!((bend.name.as_str(), bend.half_width_m), ("Bend", Some(20.0)));
    assert!((bend.speed_mps.unwrap() - 6.0 * KNOT_MPS).abs() < 1e-12);
    // A quarter turn of 400 m, and the reach of 120 m before it.
    let wheel = plan.wheel_overs().next().expect("a turn");
    assert!((wheel.at_m - vec2(480.0, 0.0)).length() < 1e-9, "{wheel:?}");
    // Without keys: three lengths of the ship, and one length.
    let plain = with("turning_radius = \"400 m\"\n", "").unwrap();
    let plan = plain.setup.world.vessels[0].plan.as_ref().unwrap();
    assert_eq!(plan.waypoints()[1].turning_radius_m, 300.0);
    let plain = with("reach = \"120 m\"\n", "").unwrap();
    assert_eq!(plain.setup.world.vessels[0].plan.as_ref().unwrap().reach_m(), 100.0);
}

#[test]
fn a_ship_beside_her_track_has_left_the_corridor_and_the_verdict_says_so() {
    let run = |scenario: Scenario| {
        let mut simulation = Simulation::new(scenario.setup).unwrap();
        while !simulation.is_done() {
            simulation.step().unwrap();
        }
        let setup = simulation.setup().clone();
        let findings = simulation.findings();
        let text: Vec<String> = findings.iter().map(|finding| finding.sentence(&setup)).collect();
        (text, Verdict::of(&findings).key())
    };
    let (text, verdict) = run(with("", "").unwrap());
    assert_eq!(verdict, "limit_exceeded", "{text:?}");
    let says = "ship left the corridor of her passage plan from 0.0 s for ";
    assert!(text[0].starts_with(says) && text[0].contains("to starboard"), "{text:?}");
    assert!(text[0].contains("on the leg to Bend, where 20 m are planned"), "{text:?}");
    let (text, _) = run(with("\"20 m\"", "\"90 m\"").unwrap());
    assert!(text.iter().all(|text| !text.contains("corridor")), "{text:?}");
}

#[test]
fn a_plan_that_no_ship_can_follow_is_refused_with_its_key() {
    for (from, to, key, says) in [
        ("vessel = \"ship\"", "vessel = \"quay\"", "plan.inbound.vessel", "has no vessel"),
        ("vessel = \"ship\"", "vessel = \"shop\"", "plan.inbound.vessel", "did you mean"),
        ("\"400 m\"", "\"1100 m\"", "plan.inbound.waypoint.1.position", "turning radius of 1000"),
        ("[1000, 0]", "[0, 0.5]", "plan.inbound.waypoint.1.position", "less than a metre"),
    ] {
        let error = with(from, to).expect_err(to);
        let text = format!("{error} {}", error.help().unwrap_or_default());
        assert!(text.contains(says), "{to}: {text}");
        assert_eq!(error.key(), Some(key), "{text}");
        assert!(error.line().is_some(), "{text}");
    }
    let second = format!(
        "{PLANNED}\n[plan.outbound]\nvessel = \"ship\"\n[[plan.outbound.waypoint]]\nposition = [0, 0]\n[[plan.outbound.waypoint]]\nposition = [0, 900]\n"
    );
    let error = Scenario::parse(&second, "planned.toml").expect_err("two plans");
    assert!(error.to_string().contains("already has the plan \"inbound\""), "{error}");
}

#[test]
fn keys_of_the_first_waypoint_that_do_nothing_are_told() {
    let scenario = with("name = \"Sea buoy\"", "speed = \"3 kn\"").unwrap();
    let notices: Vec<String> = scenario.notices.iter().map(ToString::to_string).collect();
    assert!(notices.iter().any(|notice| notice.contains("no effect")), "{notices:?}");
}
