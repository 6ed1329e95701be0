//! A ship that the seabed brakes loses a share of her speed in each step: after some minutes the squares of her speeds are
//! smaller than any number. Three formulas then divided 0 by 0, and the run ended with "north load of body `ship` is NaN".

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

const AGROUND: &str = r#"
title = "A ship that has stopped on the bottom"
[time]
step = "0.5 s"
duration = "40 min"
[environment]
wind = { speed = "0 m/s", from = "90 deg" }
depth = "5.8 m"
[vessel.coaster]
length_bp = "120 m"
beam = "18 m"
draught = "6 m"
block_coefficient = 0.7
propeller = { diameter = "4 m", full = "150 rpm" }
rudder = { area = "12 m^2", span = "4 m" }
windage = { frontal_area = "250 m^2", lateral_area = "1500 m^2", centroid_height = "8 m", type = "ferry" }
[body.ship]
vessel = "coaster"
outline = [[-60, -9], [45, -9], [60, 0], [45, 9], [-60, 9]]
position = [0, 0]
velocity = { surge = "0.1 m/s", sway = "-0.05 m/s", yaw = "0.1 deg/s" }
"#;

#[test]
fn a_ship_that_has_all_but_stopped_has_forces_that_are_numbers() {
    for (what, text) in [
        ("all three speeds", AGROUND.to_owned()),
        ("surge", AGROUND.replace(", sway = \"-0.05 m/s\", yaw = \"0.1 deg/s\"", "")),
        ("astern", AGROUND.replace("surge = \"0.1 m/s\", sway", "surge = \"-0.1 m/s\", sway")),
        (
            "sway",
            AGROUND.replace(
                "surge = \"0.1 m/s\", sway = \"-0.05 m/s\", yaw = \"0.1 deg/s\"",
                "sway = \"1 m/s\"",
            ),
        ),
        ("yaw", AGROUND.replace("surge = \"0.1 m/s\", sway = \"-0.05 m/s\", yaw", "yaw")),
    ] {
        let scenario = Scenario::parse(&text, "aground.toml").expect(what);
        let mut simulation = Simulation::new(scenario.setup).expect(what);
        while !simulation.is_done() {
            if let Err(error) = simulation.step() {
                panic!("{what}: {error}");
            }
        }
        let ship = simulation.states()[0];
        assert!(ship.velocity_mps.length() < 1e-100, "{what}: {:?}", ship.velocity_mps);
    }
}
