//! Vessels, weather, tugs and lines from scenarios: runs, and mistakes that are refused.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use fenderline_scenario::Scenario;
use fenderline_sim::{Simulation, WorldEventKind};

/// A ship on her berth with lines, wind, current and waves; parts are replaced in the tests.
const MOORED: &str = r#"title = "Moored"

[time]
step = "0.5 s"
duration = "10 h"

[environment]
depth = "16 m"
wind = { speed = "15 m/s", from = "250 deg", gusts = true, seed = 4 }
current = { speed = "0.4 m/s", towards = "20 deg" }
waves = { height = "0.8 m", period = "7 s", from = "200 deg", seed = 9 }

[vessel.coaster]
length_bp = "130 m"
beam = "20 m"
draught = "7.5 m"
block_coefficient = 0.74
propeller = { diameter = "4.4 m", full = "130 rpm" }
rudder = { area = "18 m^2", span = "5 m" }
thruster.bow = { along = "55 m", force = "90 kN" }
windage = { frontal_area = "350 m^2", lateral_area = "1300 m^2", centroid_height = "7 m", type = "cargo vessel, loaded" }
stability = { gm = "1.1 m", gravity_above_keel = "7.4 m", waterplane_area = "2150 m^2" }

[body.ship]
vessel = "coaster"
outline = [[-68, -8], [-60, -10], [40, -10], [58, -6], [68, 0], [58, 6], [40, 10], [-60, 10], [-68, 8]]
position = [0, -11.8]

[body.quay]
fixed = true
outline = [[-120, 0], [120, 0], [120, 20], [-120, 20]]

[material.concrete]
stiffness = "30 MN/m^2"
restitution = 0.1

[material.facing]
stiffness = 0
shear_stiffness = "2 MN/m"
friction_static = 0.2
restitution = 0.1

[fender.aft]
on = "quay"
position = [-35, 0]
facing = "-90 deg"
width = "2 m"
type = "cone"
height = "1.2 m"
rated_reaction = "600 kN"
above_water = "2 m"
projection = "1.8 m"
material = "facing"

[fender.forward]
on = "quay"
position = [35, 0]
facing = "-90 deg"
width = "2 m"
type = "cone"
height = "1.2 m"
rated_reaction = "600 kN"
above_water = "2 m"
projection = "1.8 m"
material = "facing"

[[pair]]
bodies = ["ship", "quay"]
material = "concrete"

[line.head]
from = "ship"
fairlead = [66, 2]
fairlead_height = "7 m"
to = "quay"
bollard = [95, 4]
bollard_height = "3 m"
rope = "polyester"
break_load = "600 kN"
pretension = "40 kN"

[line.fore_spring]
from = "ship"
fairlead = [45, 8]
fairlead_height = "6 m"
to = "quay"
bollard = [0, 4]
bollard_height = "3 m"
rope = "polyester"
break_load = "600 kN"
pretension = "40 kN"
winch = true

[line.aft_spring]
from = "ship"
fairlead = [-45, 10]
fairlead_height = "6 m"
to = "quay"
bollard = [0, 4]
bollard_height = "3 m"
rope = "polyester"
break_load = "600 kN"
pretension = "40 kN"

[line.stern]
from = "ship"
fairlead = [-67, 6]
fairlead_height = "7 m"
to = "quay"
bollard = [-95, 4]
bollard_height = "3 m"
rope = "polyester"
break_load = "600 kN"
length = "40 m"

[tug.one]
vessel = "ship"
bollard_pull = "40 tf"
push_at = [30, -10]

[[order]]
at = "1 min"
vessel = "ship"
rudder = "5 deg"
"#;

fn simulation(text: &str) -> Simulation {
    let scenario = Scenario::parse(text, "x.toml").unwrap_or_else(|error| panic!("{error}"));
    Simulation::new(scenario.setup).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn ten_hours_moored_in_waves_wind_and_current_stay_bounded_and_replay_to_the_same_bits() {
    let play = || {
        let mut simulation = simulation(MOORED);
        let start = simulation.states()[0].position_m;
        let mut farthest_m = 0.0_f64;
        // The largest kinetic energy of each hour, and the largest residual of the energy ledger.
        let (mut kinetic_j, mut residual_j) = ([0.0_f64; 10], 0.0_f64);
        while !simulation.is_done() {
            let record = simulation.step().expect("a good step");
            let gone = record.world_events.iter().map(|event| event.kind);
            assert!(gone.into_iter().all(|kind| kind != WorldEventKind::LineParted));
            let hour = ((record.t_s / 3600.0) as usize).min(9);
            kinetic_j[hour] = kinetic_j[hour].max(record.energy().kinetic_j);
            residual_j = residual_j.max(record.energy().residual_j.abs());
            let roll_rad = record.vessels[0].attitude.roll.value;
            assert!(roll_rad.abs() < 0.1, "{roll_rad}");
            farthest_m = farthest_m.max((simulation.states()[0].position_m - start).length());
        }
        // She moves a metre or two on lines and fenders. After the first hour the motion does not grow.
        assert!(farthest_m < 3.0, "{farthest_m} m");
        let early_j: f64 = kinetic_j[1..5].iter().fold(0.0, |most, &j| most.max(j));
        let late_j: f64 = kinetic_j[5..].iter().fold(0.0, |most, &j| most.max(j));
        assert!(kinetic_j[0] < 5e6 && late_j < 1.5 * early_j, "{kinetic_j:?} J");
        // Her energy is the work done on her over 72,000 steps: the residual is below 0.1 % of the exchanged energy, the
        // criterion for every vessel.
        let exchanged_j = simulation.energy().exchanged_j();
        println!("residual {residual_j:.0} J of {exchanged_j:.0} J, kinetic {early_j:.0} J");
        assert!(residual_j < 1e-3 * exchanged_j, "{residual_j} J of {exchanged_j} J");
        simulation.states().to_vec()
    };
    assert_eq!(play(), play());
}

#[test]
fn a_ship_in_too_little_water_is_held_aground_and_reported() {
    let text = MOORED
        .replace("depth = \"16 m\"", "depth = \"7 m\"")
        .replace("duration = \"10 h\"", "duration = \"10 min\"");
    let mut simulation = simulation(&text);
    let mut events = 0;
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        events += record.world_events.iter().filter(|e| e.kind == WorldEventKind::Aground).count();
    }
    assert_eq!(events, 1);
    let state = simulation.states()[0];
    assert!(state.position_m.is_finite() && state.velocity_mps.length() < 0.01, "{state:?}");
}

#[test]
fn an_order_beyond_the_stop_is_clamped_with_one_event() {
    let text = MOORED
        .replace("rudder = \"5 deg\"", "rudder = \"70 deg\"")
        .replace("duration = \"10 h\"", "duration = \"5 min\"");
    let mut simulation = simulation(&text);
    let mut events = 0;
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        let clamped = |e: &&fenderline_sim::WorldEvent| e.kind == WorldEventKind::OrderClamped;
        events += record.world_events.iter().filter(clamped).count();
    }
    assert_eq!(events, 1);
    assert!((simulation.vessels()[0].rudder.value - 35.0_f64.to_radians()).abs() < 1e-9);
}

/// A part, what replaces it, the key of the error, and a part of the message.
#[rustfmt::skip]
const MISTAKES: &[(&str, &str, &str, &str)] = &[
    ("speed = \"15 m/s\"", "speed = \"1e6 m/s\"", "environment.wind.speed", "must be"),
    ("speed = \"0.4 m/s\"", "speed = \"1e6 m/s\"", "environment.current.speed", "must be"),
    ("speed = \"15 m/s\"", "speed = nan", "environment.wind.speed", "not a finite number"),
    ("height = \"0.8 m\", period = \"7 s\"", "height = \"9 m\", period = \"2 s\", regular = true", "environment.waves", "wave height"),
    ("block_coefficient = 0.74", "block_coefficient = 1.4", "vessel.coaster.block_coefficient", "must be"),
    ("block_coefficient = 0.74\n", "", "vessel.coaster.block_coefficient", "is missing"),
    ("beam = \"20 m\"", "beam = \"-20 m\"", "vessel.coaster.beam", "must be"),
    ("gm = \"1.1 m\"", "gm = \"-1.1 m\"", "vessel.coaster.stability.gm", "must be"),
    ("waterplane_area = \"2150 m^2\"", "waterplane_area = \"9000 m^2\"", "vessel.coaster.stability", "waterplane"),
    ("type = \"cargo vessel, loaded\"", "type = \"cargo vesel, loaded\"", "vessel.coaster.windage.type", "did you mean"),
    ("rudder = { area = \"18 m^2\", span = \"5 m\" }\n", "", "vessel.coaster.propeller", "needs `rudder` in the same table"),
    ("diameter = \"4.4 m\", ", "", "vessel.coaster.propeller.diameter", "is missing"),
    ("[vessel.coaster]", "[vessel.coaster]\nfrom = \"kcs\"", "vessel.coaster.length_bp", "does not go together with `from`"),
    ("vessel = \"coaster\"", "vessel = \"coster\"", "body.ship.vessel", "did you mean \"coaster\"?"),
    ("vessel = \"coaster\"", "vessel = \"coaster\"\nmass = \"1 t\"", "body.ship.mass", "does not go together with `vessel`"),
    ("length = \"40 m\"", "length = \"4 m\"", "line.stern", "is 4 m long, but its ends are"),
    ("length = \"40 m\"", "length = \"40 m\"\npretension = \"1 kN\"", "line.stern.pretension", "does not go together"),
    ("length = \"40 m\"\n", "", "line.stern.pretension", "is missing"),
    ("to = \"quay\"\nbollard = [95, 4]", "to = \"ship\"\nbollard = [95, 4]", "line.head.to", "both ends"),
    ("to = \"quay\"\nbollard = [95, 4]", "to = \"qay\"\nbollard = [95, 4]", "line.head.to", "did you mean \"quay\"?"),
    ("vessel = \"ship\"\nbollard_pull", "vessel = \"quay\"\nbollard_pull", "tug.one.vessel", "is not a vessel"),
    ("rudder = \"5 deg\"", "rudder = \"5 deg\"\nengine = 1", "order.0.engine", "a second order in one table"),
    ("rudder = \"5 deg\"", "push = \"5 kN\"", "order.0.push", "is not an order to a vessel"),
    ("rudder = \"5 deg\"", "thruster = { name = \"stern\", power = 1 }", "order.0.thruster.name", "no thruster \"stern\""),
    ("vessel = \"ship\"\nrudder = \"5 deg\"", "tug = \"two\"\npush = \"5 kN\"", "order.0.tug", "there is no tug \"two\""),
    ("vessel = \"ship\"\nrudder = \"5 deg\"", "line = \"hed\"\nlet_go = true", "order.0.line", "did you mean \"head\"?"),
    ("vessel = \"ship\"\nrudder = \"5 deg\"", "rudder = \"5 deg\"", "order.0", "must be for one of"),
    ("rudder = \"5 deg\"", "hands = false", "order.0.hands", "must be true"),
    ("rudder = \"5 deg\"", "", "order.0", "orders nothing"),
    ("vessel = \"ship\"\nrudder = \"5 deg\"", "line = \"head\"\nlet_go = false", "order.0.let_go", "must be true"),
    ("vessel = \"ship\"\nrudder = \"5 deg\"", "tug = \"one\"\nstand_by = false", "order.0.stand_by", "must be true"),
];

#[test]
fn every_mistake_names_its_key() {
    assert!(Scenario::parse(MOORED, "x.toml").is_ok());
    for (part, mistake, key, fragment) in MISTAKES {
        assert!(MOORED.contains(part), "{part} is not in the good scenario");
        let error = Scenario::parse(&MOORED.replacen(part, mistake, 1), "x.toml")
            .expect_err(&format!("{mistake}: {fragment}"));
        let shown = error.to_string();
        assert_eq!(error.key(), Some(*key), "{shown}");
        assert!(shown.contains(fragment), "{shown}");
        assert!(error.line().is_some(), "{shown}");
    }
}
