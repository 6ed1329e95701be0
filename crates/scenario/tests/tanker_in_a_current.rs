//! A tanker of 250,000 dwt on eight wires in a current of 1 knot from any direction, in 1.1 draughts of water.

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

/// The current grows to 1 knot within half an hour, so that she does not swing into her lines.
const CURRENT: &str = "t_s,north_mps,east_mps\n0,0,0\n1800,NORTH,EAST\n2400,NORTH,EAST\n";

const MOORED: &str = r#"title = "A tanker on eight wires"

[time]
step = "2 s"
duration = "40 min"

[environment]
depth = "21.12 m"
current = { file = "current.csv" }

[vessel.tanker]
length_bp = "329.3 m"
beam = "51.8 m"
draught = "19.2 m"
block_coefficient = 0.85

[body.ship]
vessel = "tanker"
outline = [[-164, -20], [-140, -26], [120, -26], [164, 0], [120, 26], [-140, 26], [-164, 20]]

[body.starboard]
fixed = true
outline = [[-230, 0], [230, 0], [230, 10], [-230, 10]]
position = [0, 110]

[body.port]
fixed = true
outline = [[-230, -10], [230, -10], [230, 0], [-230, 0]]
position = [0, -110]
"#;

/// The tanker, with two wires forward and two aft on each side.
fn moored(off_the_bow_deg: f64) -> Scenario {
    let mut text = MOORED.to_owned();
    for (side, sign) in [("starboard", 1.0), ("port", -1.0)] {
        for (index, [fairlead, breadth, bollard]) in [
            [148.0, 10.0, 180.0],
            [118.0, 26.0, 130.0],
            [-118.0, 26.0, -130.0],
            [-148.0, 20.0, -180.0],
        ]
        .into_iter()
        .enumerate()
        {
            text += &format!(
                "\n[line.{side}_{index}]\nfrom = \"ship\"\nfairlead = [{fairlead}, {}]\nto = \"{side}\"\n\
                 bollard = [{bollard}, {}]\nrope = \"wire\"\nbreak_load = \"1110 kN\"\n\
                 tail = {{ rope = \"nylon\", break_load = \"1500 kN\", length = \"22 m\" }}\npretension = \"50 kN\"\n",
                sign * breadth,
                sign * 2.0,
            );
        }
    }
    // She heads north; the water comes from starboard.
    let (east, north) = libm::sincos(off_the_bow_deg.to_radians());
    let knot_mps = 1852.0 / 3600.0;
    let current = CURRENT
        .replace("NORTH", &format!("{}", -knot_mps * north))
        .replace("EAST", &format!("{}", -knot_mps * east));
    Scenario::parse_among(&text, "moored.toml", &[], &mut |_| Ok(current.clone()))
        .unwrap_or_else(|error| panic!("{error}"))
}

/// The force from 50° off the bow was 2.5 times that from abeam: she parted all eight.
#[test]
fn eight_wires_hold_a_tanker_in_a_current_of_one_knot_from_every_direction() {
    for off_the_bow_deg in (0..=180).step_by(10) {
        let scenario = moored(f64::from(off_the_bow_deg));
        let mut simulation =
            Simulation::new(scenario.setup).unwrap_or_else(|error| panic!("{error}"));
        while !simulation.is_done() {
            simulation.step().expect("a good step");
        }
        let parted = simulation.lines().iter().filter(|line| line.has_parted()).count();
        assert_eq!(parted, 0, "{off_the_bow_deg}° off the bow");
    }
}
