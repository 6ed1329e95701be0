//! Tugs that are vessels with azimuth units, from scenario text, working at a ship.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use fenderline_contact::Rotation;
use fenderline_scenario::Scenario;
use fenderline_sim::{Simulation, WorldEventKind};

/// An ASD tug of 32 m with 60 t of bollard pull beside a ship that lies still; parts are replaced.
const ASSIST: &str = r#"title = "A tug at a ship's side"

[time]
step = "0.1 s"
duration = "8 min"

[material.rubber]
stiffness = "500 kN/m^2"
shear_stiffness = "3000 kN/m"
friction_static = 0.5
friction_dynamic = 0.4
restitution = 0.1

[vessel.asd]
length_bp = "30 m"
beam = "12 m"
draught = "4.5 m"
block_coefficient = 0.56
azimuth.port = { along = "-12 m", across = "-2.6 m", force = "30 tf", diameter = "2.4 m", rate = "18 deg/s" }
azimuth.starboard = { along = "-12 m", across = "2.6 m", force = "30 tf", diameter = "2.4 m", rate = "18 deg/s" }

[vessel.tanker]
from = "kvlcc2"
propeller = { full = "106 rpm" }

[body.tug]
vessel = "asd"
outline = [[-16, -5], [-13, -6], [12, -6], [16, -4.5], [16, 4.5], [12, 6], [-13, 6], [-16, 5]]
position = [30, -90]
heading = "40 deg"

[body.ship]
fixed = true
outline = [[-160, -29], [130, -29], [160, 0], [130, 29], [-160, 29]]

[fender.bow]
on = "tug"
position = [16, 0]
facing = 0
width = "8 m"
projection = "0.9 m"
material = "rubber"

[[pair]]
bodies = ["tug", "ship"]
material = "rubber"

[[order]]
vessel = "tug"
push_ship = { ship = "ship", at = [60, -29], force = "300 kN" }
"#;

fn simulation(text: &str) -> Simulation {
    let scenario = Scenario::parse(text, "x.toml").unwrap_or_else(|error| panic!("{error}"));
    Simulation::new(scenario.setup).unwrap_or_else(|error| panic!("{error}"))
}

/// ASSIST without its order, the ship far away, with orders instead.
fn alone(orders: &str) -> String {
    let (before, _) = ASSIST.split_once("[[order]]").expect("an order");
    let text = before.replace("heading = \"40 deg\"", "heading = \"0 deg\"");
    text.replace("position = [30, -90]", "position = [0, -900]") + orders
}

/// The ship is KVLCC2, north at 2.5 knots through the water with her engine turning for it.
fn ship_under_way(text: &str) -> String {
    let ship = "vessel = \"tanker\"\nrunning = 0.15\nvelocity = { surge = \"2.5 kn\" }";
    let order = "\n[[order]]\nvessel = \"ship\"\nspeed = \"2.5 kn\"\n\
                 \n[[order]]\nvessel = \"ship\"\ncourse = \"0 deg\"\n";
    text.replace("fixed = true", ship) + order
}

const TF_N: f64 = 9806.65;

#[test]
fn a_tug_touches_gently_and_holds_the_ordered_push_in_still_water() {
    let mut simulation = simulation(ASSIST);
    let (mut pushed_n, mut steps, mut touched_s) = (0.0, 0.0, None);
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        let now_n: f64 = record.contacts.iter().map(|contact| contact.normal_force_n).sum();
        if now_n > 0.0 && touched_s.is_none() {
            touched_s = Some(record.t_s);
        }
        if record.t_s > 300.0 {
            let worst = (now_n / 300e3 - 1.0).abs();
            assert!(worst < 0.05, "{now_n} N at {} s", record.t_s);
            (pushed_n, steps) = (pushed_n + now_n, steps + 1.0);
        }
    }
    // Within 5 % at every moment of the last three minutes, and within 1 % in their mean.
    let mean_n = pushed_n / steps;
    assert!((mean_n / 300e3 - 1.0).abs() < 0.01, "{mean_n} N");
    let touched_s = touched_s.expect("she touches");
    assert!(touched_s < 200.0, "{touched_s} s");
    // She aims at 0.1 m/s; half as much again allows for the lag of her thrusters.
    let pair = &simulation.pair_summaries()[0];
    assert!(pair.approach_speed_mps > 0.0 && pair.approach_speed_mps < 0.15, "{pair:?}");
    let tug = simulation.states()[0];
    assert!((tug.heading_rad.to_degrees() - 90.0).abs() < 2.0, "{tug:?}");
    assert!((tug.position_m.x - 60.0).abs() < 1.0, "{tug:?}");
}

#[test]
fn a_tug_comes_alongside_a_ship_under_way_pushes_and_stays_with_her() {
    let mut simulation = simulation(&ship_under_way(ASSIST));
    let (mut touching, mut steps) = (0, 0);
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        if record.t_s > 300.0 {
            steps += 1;
            touching += usize::from(!record.contacts.is_empty());
        }
    }
    let [tug, ship] = simulation.states() else { panic!("two bodies") };
    for state in [tug, ship] {
        assert!(state.position_m.is_finite() && state.velocity_mps.length() < 3.0, "{state:?}");
    }
    assert!(ship.velocity_mps.length() > 1.0, "still under way: {ship:?}");
    // Her bow is in contact almost all the time, within a ship's beam of the ordered place.
    assert!(touching as f64 > 0.95 * f64::from(steps), "{touching} of {steps}");
    let own = ship.pose().apply_inverse(tug.pose().apply(fenderline_contact::vec2(16.9, 0.0)));
    assert!((own.x - 60.0).abs() < 58.0 && (own.y + 29.0).abs() < 1.0, "{own:?}");
    let pair = &simulation.pair_summaries()[0];
    assert!(pair.approach_speed_mps < 0.25, "{pair:?}");
}

#[test]
fn a_tug_behind_a_ship_at_six_knots_keeps_her_place() {
    // At speed her side thrust turned her bow the wrong way: she crabbed along 20 m beside her place.
    let text = include_str!("../../../scenarios/live/tug_escort.toml");
    let mut simulation = simulation(&text.replace("duration = \"4 h\"", "duration = \"6 min\""));
    while !simulation.is_done() {
        simulation.step().expect("a good step");
        let [ship, tug] = [&simulation.states()[0], &simulation.states()[1]];
        if simulation.time_s() > 60.0 {
            let own = fenderline_contact::Rotation::from_angle(ship.heading_rad);
            let off = own.apply_inverse(tug.position_m - ship.position_m);
            // Her place is 195 m astern. A quarter of her beam allows for leeway, which is not corrected.
            assert!(off.y.abs() < 3.0 && (off.x + 195.0).abs() < 3.0, "{off:?}");
        }
    }
}

#[test]
fn a_tug_on_her_line_pulls_with_the_ordered_force() {
    let line = r#"
[line.tow]
from = "tug"
fairlead = [15, 0]
to = "ship"
bollard = [100, -29]
rope = "nylon"
break_load = "1500 kN"
length = "60 m"

[[order]]
vessel = "tug"
pull_ship = { line = "tow", force = "250 kN", direction = "-70 deg" }
"#;
    let (before, _) = ASSIST.split_once("[[order]]").expect("an order");
    let mut simulation =
        simulation(&(before.replace("position = [30, -90]", "position = [90, -80]") + line));
    let mut most_n = 0.0_f64;
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        let tension_n = record.lines[0].load.tension_n;
        most_n = most_n.max(tension_n);
        if record.t_s > 360.0 {
            assert!((tension_n / 250e3 - 1.0).abs() < 0.05, "{tension_n} N at {} s", record.t_s);
        }
    }
    assert!(most_n < 2.0 * 250e3, "no jerk beyond twice the pull: {most_n} N");
    // 70° to port of the bow, and facing the ship as the line leads over her bow.
    let tug = simulation.states()[0];
    let off = tug.position_m - fenderline_contact::vec2(100.0, -29.0);
    let along =
        Rotation::from_angle(-70_f64.to_radians()).apply(fenderline_contact::vec2(1.0, 0.0));
    assert!(off.dot(along) > 0.0 && (off.cross(along) / off.length()).abs() < 0.05, "{off:?}");
    assert!((tug.heading_rad.to_degrees() - 110.0).abs() < 3.0, "{tug:?}");
}

#[test]
fn a_tug_keeps_her_place_beside_a_ship_under_way() {
    let order = "[[order]]\nvessel = \"tug\"\n\
                 follow_ship = { ship = \"ship\", at = [20, -60], heading = \"0 deg\" }\n";
    let (before, _) = ASSIST.split_once("[[order]]").expect("an order");
    let mut simulation = simulation(&ship_under_way(&(before.to_owned() + order)));
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    let [tug, ship] = simulation.states() else { panic!("two bodies") };
    let own = ship.pose().apply_inverse(tug.position_m);
    assert!((own - fenderline_contact::vec2(20.0, -60.0)).length() < 1.0, "{own:?}");
    assert!((tug.heading_rad - ship.heading_rad).abs() < 0.02, "{tug:?}");
}

/// A bulk carrier of 180 m at 7 knots, north, with a tug 60 m off at each shoulder and quarter. From 100 s on she turns,
/// and from 150 s on she has another speed.
fn ship_with_four_tugs(places: &[[f64; 2]], turn_deg: f64, speed_kn: f64) -> String {
    let mut text = String::from(
        "[time]\nstep = \"0.1 s\"\nduration = \"500 s\"\n\
         [vessel.bulker]\nlength_bp = \"180 m\"\nbeam = \"30 m\"\ndraught = \"10.5 m\"\n\
         block_coefficient = 0.82\npropeller = { diameter = \"6 m\", full = \"110 rpm\" }\n\
         rudder = { area = \"34 m^2\", span = \"7.5 m\" }\n\
         [body.ship]\nvessel = \"bulker\"\nvelocity = { surge = \"7 kn\" }\nrunning = 0.6\n\
         outline = [[-90, -15], [70, -15], [90, 0], [70, 15], [-90, 15]]\n",
    );
    for (i, [ahead, across]) in places.iter().enumerate() {
        text += &format!(
            "[body.tug_{i}]\nvessel = \"asd-tug\"\nposition = [{ahead}, {across}]\n\
             velocity = {{ surge = \"7 kn\" }}\n\
             [[order]]\nvessel = \"tug_{i}\"\nfollow_ship = {{ ship = \"ship\", at = [{ahead}, {across}], \
             heading = \"0 deg\", speed = \"8 kn\" }}\n"
        );
    }
    for (at_s, order) in [(0, "speed = \"7 kn\"".to_owned()), (0, "course = \"0 deg\"".to_owned())]
    {
        text += &format!("[[order]]\nat = \"{at_s} s\"\nvessel = \"ship\"\n{order}\n");
    }
    for i in 1..=15 {
        let (at_s, course_deg) = (95 + 5 * i, turn_deg * f64::from(i) / 15.0);
        text += &format!(
            "[[order]]\nat = \"{at_s} s\"\nvessel = \"ship\"\ncourse = \"{course_deg} deg\"\n"
        );
    }
    text + &format!("[[order]]\nat = \"150 s\"\nvessel = \"ship\"\nspeed = \"{speed_kn} kn\"\n")
}

/// When a tug has to slow down, her units must not turn astern through the stream: their side forces turned the tug, and
/// she went into the ship or fell back by 100 m. The tug's place is 45 m off the ship's side: she comes at most half of
/// this distance nearer, and stays within her length of 32 m of the place.
#[test]
fn tugs_keep_off_a_ship_that_turns_and_slows_down() {
    let places = [[45.0, 60.0], [-84.0, 60.0], [45.0, -60.0], [-84.0, -60.0]];
    for turn_deg in [0.0, 15.0, 45.0] {
        for speed_kn in [2.0, 3.0, 4.0, 5.0, 7.0, 9.0] {
            let mut simulation = simulation(&ship_with_four_tugs(&places, turn_deg, speed_kn));
            let (mut farthest_m, mut nearer_m) = (0.0_f64, 0.0_f64);
            while !simulation.is_done() {
                simulation.step().expect("a good step");
                let [ship, tugs @ ..] = simulation.states() else { panic!("a ship and her tugs") };
                for (tug, &[ahead, across]) in tugs.iter().zip(&places) {
                    let own = ship.pose().apply_inverse(tug.position_m);
                    farthest_m = farthest_m.max((own.x - ahead).hypot(own.y - across));
                    nearer_m = nearer_m.max((across - own.y) * across.signum());
                }
            }
            println!(
                "turn of {turn_deg}°, {speed_kn} kn: {farthest_m:.1} m off, {nearer_m:.1} m nearer"
            );
            assert!(farthest_m < 32.0 && nearer_m < 22.5, "turn of {turn_deg}°, {speed_kn} kn");
        }
    }
}

#[test]
fn an_azimuth_unit_has_its_thrust_at_rest_its_turning_rate_and_less_thrust_with_speed() {
    let unit = |name: &str| {
        format!(
            "[[order]]\nvessel = \"tug\"\n\
             azimuth = {{ name = \"{name}\", power = 1, direction = \"90 deg\" }}\n"
        )
    };
    let text = alone(&(unit("port") + &unit("starboard")))
        .replace("rate = \"18 deg/s\"", "rate = \"18 deg/s\", lag = 0");
    // In the first step at rest: full thrust, turned for 0.1 s.
    let mut at_rest = simulation(&text);
    let record = at_rest.step().expect("a good step");
    let thrust_n = record.vessel_forces[0].thrusters;
    let turned_rad = 1.8_f64.to_radians();
    let turned = Rotation::from_angle(turned_rad).apply(fenderline_contact::vec2(1.0, 0.0));
    assert!((thrust_n.surge_n / (60.0 * TF_N * turned.x) - 1.0).abs() < 1e-12, "{thrust_n:?}");
    assert!((thrust_n.sway_n / (60.0 * TF_N * turned.y) - 1.0).abs() < 1e-9, "{thrust_n:?}");
    let unit = record.vessels[0].azimuths[0];
    assert!((unit.direction.angle_rad - turned_rad).abs() < 1e-12, "{unit:?}");
    // K_T of a B4-70 of pitch 1.0 falls from 0.45 at rest to about 0.27 at J = 0.47 (from the curves, from memory).
    let ahead = text
        .replace("heading = \"0 deg\"", "velocity = { surge = \"5 m/s\" }")
        .replace("90 deg", "0 deg");
    let mut under_way = simulation(&ahead);
    let record = under_way.step().expect("a good step");
    let share = record.vessel_forces[0].thrusters.surge_n / (60.0 * TF_N);
    assert!((share - 0.27 / 0.45).abs() < 0.05, "{share}");
}

#[test]
fn an_azimuth_order_beyond_its_stop_is_clamped_with_one_event() {
    for (order, angle_deg, power) in [
        ("power = 1, direction = \"170 deg\"", 120.0, 1.0),
        ("power = 0, direction = \"-170 deg\"", -120.0, 0.0),
    ] {
        let order =
            format!("[[order]]\nvessel = \"tug\"\nazimuth = {{ name = \"port\", {order} }}\n");
        let text = alone(&order)
            .replace("rate = \"18 deg/s\"", "stop = \"120 deg\"")
            .replace("duration = \"8 min\"", "duration = \"60 s\"");
        let mut simulation = simulation(&text);
        let mut events = 0;
        while !simulation.is_done() {
            let record = simulation.step().expect("a good step");
            let clamped = |e: &&fenderline_sim::WorldEvent| e.kind == WorldEventKind::OrderClamped;
            events += record.world_events.iter().filter(clamped).count();
        }
        assert_eq!(events, 1);
        let unit = simulation.vessels()[0].azimuths[0];
        assert!((unit.direction.angle_rad.to_degrees() - angle_deg).abs() < 1e-9, "{unit:?}");
        assert!((unit.power.value - power).abs() < 1e-6, "{unit:?}");
    }
}

#[test]
fn a_station_is_kept_with_azimuth_units_in_current_and_wind() {
    let orders = "[[order]]\nvessel = \"tug\"\n\
                  station = { position = [40, -880], heading = \"20 deg\" }\n";
    let weather = "[environment]\ncurrent = { speed = \"0.5 m/s\", towards = \"120 deg\" }\n\
                   wind = { speed = \"10 m/s\", from = \"200 deg\" }\n\n[vessel.asd]\n\
                   windage = { frontal_area = \"90 m^2\", lateral_area = \"150 m^2\", \
                   centroid_height = \"4 m\", type = \"offshore supply vessel\" }\n";
    let text = alone(orders).replace("[vessel.asd]\n", weather).replace("8 min", "60 min");
    let mut simulation = simulation(&text);
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    let tug = simulation.states()[0];
    assert!((tug.position_m - fenderline_contact::vec2(40.0, -880.0)).length() < 0.5, "{tug:?}");
    assert!((tug.heading_rad.to_degrees() - 20.0).abs() < 1.0, "{tug:?}");
}

#[test]
fn without_a_propeller_course_and_speed_go_to_the_azimuth_units() {
    let orders = "[[order]]\nvessel = \"tug\"\ncourse = \"60 deg\"\n\
                  [[order]]\nvessel = \"tug\"\nspeed = \"6 kn\"\n";
    let mut simulation = simulation(&alone(orders));
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    let tug = simulation.states()[0];
    let along = Rotation::from_angle(tug.heading_rad).apply_inverse(tug.velocity_mps);
    assert!((tug.heading_rad.to_degrees() - 60.0).abs() < 1.0, "{tug:?}");
    assert!((along.x / (6.0 * 1852.0 / 3600.0) - 1.0).abs() < 0.02, "{along:?}");
}

/// A part, what replaces it, the key of the error, and a part of the message.
#[rustfmt::skip]
const MISTAKES: &[(&str, &str, &str, &str)] = &[
    ("at = [60, -29]", "at = [60, 0]", "order.0.push_ship.at", "29.0 m from the ship's outline"),
    ("force = \"300 kN\"", "force = \"900 kN\"", "order.0.push_ship.force", "at most the tug's bollard pull of 588.399 kN"),
    ("ship = \"ship\"", "ship = \"tug\"", "order.0.push_ship.ship", "is the tug herself"),
    ("ship = \"ship\"", "ship = \"shop\"", "order.0.push_ship.ship", "did you mean \"ship\"?"),
    ("bodies = [\"tug\", \"ship\"]", "bodies = [\"tug\", \"other\"]", "order.0.push_ship.ship", "no pair in the scenario lets the tug touch"),
    ("vessel = \"asd\"", "vessel = \"tanker\"", "order.0.push_ship", "has no azimuth units"),
    ("push_ship = { ship = \"ship\", at = [60, -29],", "pull_ship = { line = \"tow\", direction = 0,", "order.0.pull_ship.line", "there is no line \"tow\""),
    ("push_ship = { ship = \"ship\", at = [60, -29], force = \"300 kN\" }", "azimuth = { name = \"prt\", power = 1 }", "order.0.azimuth.name", "did you mean \"port\"?"),
    ("push_ship = { ship = \"ship\", at = [60, -29], force = \"300 kN\" }", "azimuth = { name = \"port\" }", "order.0.azimuth", "asks for nothing"),
    ("push_ship = { ship = \"ship\", at = [60, -29], force = \"300 kN\" }", "rudder = 0", "order.0.rudder", "has no propeller and rudder"),
    ("diameter = \"2.4 m\", ", "", "vessel.asd.azimuth.port.diameter", "is missing"),
    ("across = \"-2.6 m\", force = \"30 tf\"", "across = \"-2.6 m\", force = \"-30 tf\"", "vessel.asd.azimuth.port.force", "must be"),
];

#[test]
fn every_mistake_names_its_key() {
    let good = ASSIST.to_owned()
        + "\n[body.other]\nfixed = true\noutline = [[900, 0], [910, 0], [910, 9]]\n";
    assert!(Scenario::parse(&good, "x.toml").is_ok());
    for (part, mistake, key, fragment) in MISTAKES {
        assert!(good.contains(part), "{part} is not in the good scenario");
        let error = Scenario::parse(&good.replacen(part, mistake, 1), "x.toml")
            .expect_err(&format!("{mistake}: {fragment}"));
        let shown = error.to_string();
        assert_eq!(error.key(), Some(*key), "{shown}");
        assert!(shown.contains(fragment), "{shown}");
        assert!(error.line().is_some(), "{shown}");
    }
}
