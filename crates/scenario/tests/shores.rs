//! Solid shores: which features of a chart become the body `shore`, and every mistake with file, feature and place.

use std::time::Instant;

use fenderline_contact::{BodyState, Vec2, vec2};
use fenderline_scenario::{Scenario, ScenarioError};
use fenderline_sim::{Setup, Simulation};

/// A basin: land on three sides with a quay area on top of it, a breakwater as a line, a hole in the land, a post.
const CHART: &str = r#"{ "type": "FeatureCollection", "features": [
{ "type": "Feature", "properties": { "OBJL": 71, "OBJNAM": "Main" }, "geometry": { "type": "Polygon", "coordinates":
  [[[-400, -300], [400, -300], [400, 300], [300, 300], [300, 0], [-300, 0], [-300, 300], [-400, 300], [-400, -300]],
   [[350, 100], [390, 100], [390, 200], [350, 200], [350, 100]]] } },
{ "type": "Feature", "properties": { "OBJL": 122, "OBJNAM": "Pier" }, "geometry": { "type": "Polygon", "coordinates":
  [[[-50, -20], [50, -20], [50, 0], [-50, 0], [-50, -20]]] } },
{ "type": "Feature", "properties": { "OBJL": 122, "OBJNAM": "Mole" }, "geometry": { "type": "LineString", "coordinates":
  [[300, 300], [100, 320], [20, 320]] } },
{ "type": "Feature", "properties": { "OBJL": 122, "OBJNAM": "Front" }, "geometry": { "type": "LineString", "coordinates":
  [[-300, 0], [300, 0]] } },
{ "type": "Feature", "properties": { "OBJL": 84 }, "geometry": { "type": "Point", "coordinates": [0, 150] } }
] }"#;

const HEAD: &str = r#"
[time]
step = "0.1 s"
duration = "60 s"
[material.rock]
stiffness = "5 MN/m^2"
shear_stiffness = "3 MN/m"
friction_static = 0.3
friction_dynamic = 0.3
[contact]
method = "coupled"
"#;

fn scenario(chart: &str, more: &str, geojson: &str) -> Result<Scenario, ScenarioError> {
    let text = format!(
        "{HEAD}[chart]\nfiles = [\"port.geojson\"]\ncoordinates = \"metres\"\n{chart}\n{more}"
    );
    Scenario::parse_among(&text, "s.toml", &[], &mut |_| Ok(geojson.to_owned()))
}

/// A barge at a place, north and east, with a speed ahead.
fn barge(at: &str, heading: &str, surge: &str) -> String {
    format!(
        "[body.barge]\nmass = \"2000 t\"\ngyradius = \"15 m\"\noutline = [[-30, -6], [30, -6], [30, 6], [-30, 6]]\n\
         position = {at}\nheading = \"{heading}\"\nvelocity = {{ surge = \"{surge}\" }}\n"
    )
}

const SOLID: &str = "solid = [\"LNDARE\", \"SLCONS\"]\nsolid_material = \"rock\"";

fn read(at: &str, heading: &str, surge: &str) -> Scenario {
    match scenario(SOLID, &barge(at, heading, surge), CHART) {
        Ok(scenario) => scenario,
        Err(error) => panic!("{error}"),
    }
}

fn run(setup: Setup) -> (BodyState, Simulation) {
    let mut simulation = Simulation::new(setup).unwrap();
    while !simulation.is_done() {
        simulation.step().unwrap();
    }
    (simulation.states()[0], simulation)
}

#[test]
fn the_shore_is_one_body_with_the_parts_that_were_taken() {
    let scenario = read("[150, 0]", "0 deg", "0 m/s");
    assert_eq!(scenario.notices, vec![]);
    let setup = &scenario.setup;
    let names: Vec<&str> = setup.bodies.iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names, ["barge", "shore"]);
    let shore = &setup.bodies[1].outline;
    assert!(shore.is_of_parts());
    // Land and hole, and the mole, 4 m wide.
    let land_m2 = 800.0 * 300.0 + 2.0 * 100.0 * 300.0 - 40.0 * 100.0;
    let mole_m2 = 4.0 * (libm::hypot(200.0, 20.0) + 80.0);
    assert!((shore.area_m2() - land_m2 - mole_m2).abs() < 1e-6, "{}", shore.area_m2());
    assert_eq!(
        setup.world.chart.solid_in_words().unwrap(),
        "1 LNDARE, 1 SLCONS; not taken: 1 SLCONS (lies within a solid area that is taken); 1 SLCONS (runs along or within a solid area)"
    );
    assert_eq!(setup.pairs.len(), 1);
}

#[test]
fn a_ship_that_runs_into_the_shore_is_stopped() {
    // Southward at the quay, northward at the mole, eastward at the land.
    for (at, heading, way) in [
        ("[60, 0]", "180 deg", vec2(-1.0, 0.0)),
        ("[260, 60]", "0 deg", vec2(1.0, 0.0)),
        ("[150, 240]", "90 deg", vec2(0.0, 1.0)),
    ] {
        // How far the bow is off the border that she runs into.
        let border_m = match way {
            Vec2 { x: -1.0, .. } => 0.0,
            Vec2 { y: 1.0, .. } => 300.0,
            _ => 318.0,
        };
        let off_m = |state: &BodyState| border_m - (state.position_m.dot(way) + 30.0);
        let (state, simulation) = run(read(at, heading, "1 m/s").setup);
        // A material without restitution stops her where the spring has taken her energy: m v² = k b δ² for her flat bow
        // against a level border.
        let sunk_m = libm::sqrt(2e6 / (5e6 * 12.0));
        let error_m = if border_m == 318.0 { 0.5 } else { 1e-3 };
        assert!((off_m(&state) + sunk_m).abs() < error_m, "{at}: {state:?}");
        let speed_mps = state.velocity_mps.length();
        assert!(state.velocity_mps.dot(way) < 1e-3, "{at}: {state:?}");
        assert!(speed_mps < 1.0 + 1e-9, "{at}: {state:?}");
        let energy = simulation.energy();
        println!("{at}: {speed_mps} m/s, {energy:?}");
        assert!(energy.residual_j.abs() < 1.0, "{at}: {energy:?}");
        assert!(energy.contact_gained_j < 1.0, "{at}: {energy:?}");
    }
}

#[test]
fn a_ship_in_a_hole_of_the_land_is_afloat_and_a_ship_on_the_land_is_refused() {
    read("[150, 370]", "0 deg", "0 m/s");
    let error = scenario(SOLID, &barge("[-100, 20]", "0 deg", "0 m/s"), CHART).unwrap_err();
    assert_eq!(error.key(), Some("body.barge.position"));
    let text = error.to_string();
    assert!(
        text.contains("\"barge\" begins on the solid LNDARE \"Main\", feature 1 of port.geojson, -100 m north and 20 m east"),
        "{text}"
    );
    assert!(text.contains("s.toml:"), "{text}");
}

#[test]
fn each_mistake_names_its_key_or_its_feature() {
    let ship = barge("[150, 0]", "0 deg", "0 m/s");
    let refused = |chart: &str, more: &str| {
        let error = scenario(chart, &format!("{ship}{more}"), CHART).unwrap_err();
        (error.key().map(str::to_owned), error.to_string())
    };
    let with = |classes: &str| format!("solid = {classes}\nsolid_material = \"rock\"");
    for (chart, more, key, words) in [
        (with("[\"LNDARA\"]"), "", "chart.solid", "did you mean \"LNDARE\"?"),
        (with("[\"DEPARE\"]"), "", "chart.solid", "not a class of features that can be solid"),
        (with("[\"PONTON\"]"), "", "chart.solid", "no feature of PONTON"),
        (with("[\"MORFAC\"]"), "", "chart.solid", "points have no width"),
        (with("[]"), "", "chart.solid", "is empty"),
        (with("[\"LNDARE\", \"LNDARE\"]"), "", "chart.solid", "twice"),
        ("solid = [\"LNDARE\"]".to_owned(), "", "chart.solid_material", "is missing"),
        ("solid_material = \"rock\"".to_owned(), "", "chart.solid_material", "with `solid`"),
        (SOLID.replace("rock", "rok"), "", "chart.solid_material", "did you mean \"rock\"?"),
        (
            SOLID.to_owned(),
            "[body.shore]\nfixed = true\noutline = [[0, 0], [1, 0], [0, 1]]\n",
            "chart.solid",
            "a body of this name already",
        ),
    ] {
        let (found, text) = refused(&chart, more);
        assert_eq!(found.as_deref(), Some(key), "{text}");
        assert!(text.contains(words), "{text}");
    }
    // A ring that crosses itself, of a feature with a kind of our own, is refused when the chart is read; one that
    // touches itself along an edge is refused when it is made solid.
    let touching = r#"{ "type": "FeatureCollection", "features": [
{ "type": "Feature", "properties": { "OBJL": 71 }, "geometry": { "type": "Polygon", "coordinates":
  [[[0, 0], [100, 0], [100, 50], [50, 0], [0, 50], [0, 0]]] } }] }"#;
    let error = scenario(SOLID.replace(", \"SLCONS\"", "").as_str(), &ship, touching).unwrap_err();
    let text = error.to_string();
    assert!(text.contains("feature 1: its border crosses or touches itself"), "{text}");
    assert!(text.contains("port.geojson"), "{text}");
}

#[test]
fn a_pair_of_the_file_counts_before_the_pair_with_the_shore() {
    let more = "[material.mud]\nstiffness = \"1 MN/m^2\"\nfriction_static = 0\nfriction_dynamic = 0\n\
                [[pair]]\nbodies = [\"barge\", \"shore\"]\nmaterial = \"mud\"\n";
    let ship = barge("[150, 0]", "0 deg", "0 m/s");
    let setup = scenario(SOLID, &format!("{ship}{more}"), CHART).unwrap().setup;
    assert_eq!(setup.pairs.len(), 1);
    assert_eq!(setup.materials[setup.pairs[0].material].name, "mud");
}

#[test]
fn the_area_of_a_body_is_not_solid_twice() {
    let more = format!(
        "{}[body.pier]\nfixed = true\nchart_outline = \"Pier\"\n",
        barge("[150, 0]", "0 deg", "0 m/s")
    );
    let setup = scenario(SOLID, &more, CHART).unwrap().setup;
    let words = setup.world.chart.solid_in_words().unwrap();
    assert!(words.contains("1 SLCONS (is the outline of a body)"), "{words}");
}

#[test]
fn a_fender_meets_the_shore_as_it_meets_the_same_quay_as_a_body() {
    let fender = "[fender.bow]\non = \"barge\"\nposition = [30, 2]\nfacing = \"0 deg\"\nwidth = 2\nprojection = 1\n\
                  stiffness = \"2 MN/m\"\nmaterial = \"rock\"\n";
    let quay = "[body.pier]\nfixed = true\noutline = [[-20, -50], [-20, 50], [0, 50], [0, -50]]\n\
                [[pair]]\nbodies = [\"barge\", \"pier\"]\nmaterial = \"rock\"\n";
    // The quay alone: the land and the mole become areas and lines that are not solid.
    let pier = CHART
        .replace("\"OBJL\": 71, \"OBJNAM\": \"Main\"", "\"OBJL\": 109")
        .replace("\"OBJL\": 122, \"OBJNAM\": \"Mole\"", "\"OBJL\": 109");
    // Slow, and so fast that the fender covers several metres in a step.
    for (surge, at) in [("0.5 m/s", "[32, 10]"), ("8 m/s", "[60, 10]"), ("0.3 m/s", "[35, -38]")] {
        let ship = format!("{}{fender}", barge(at, "175 deg", surge));
        let classes = SOLID.replace("\"LNDARE\", ", "");
        let as_shore = scenario(&classes, &ship, &pier).unwrap().setup;
        let as_body = scenario("", &format!("{ship}{quay}"), &pier).unwrap().setup;
        let mut simulation = Simulation::new(as_shore).unwrap();
        let mut is_fender_touched = false;
        while !simulation.is_done() {
            let record = simulation.step().unwrap();
            is_fender_touched |= record.contacts.iter().any(|contact| contact.fender.is_some());
        }
        assert!(is_fender_touched, "{surge}");
        let met = simulation.states()[0];
        let (expected, _) = run(as_body);
        assert!(
            (met.position_m - expected.position_m).length() < 1e-9,
            "{surge}: {met:?} {expected:?}"
        );
        assert!(
            (met.velocity_mps - expected.velocity_mps).length() < 1e-9,
            "{surge}: {met:?} {expected:?}"
        );
    }
}

/// A coast of 20,000 corners north of a channel: a band of land with a ragged border towards the south, 10 miles long.
fn ragged_coast() -> String {
    let count = 19_998;
    let corner = |k: usize| {
        let east_m = 18_520.0 * k as f64 / (count - 1) as f64;
        let north_m = 100.0 + 40.0 * libm::sin(0.7 * k as f64) * libm::cos(0.013 * k as f64);
        format!("[{east_m}, {north_m}]")
    };
    let border: Vec<String> = (0..count).map(corner).collect();
    format!(
        "{{ \"type\": \"FeatureCollection\", \"features\": [{{ \"type\": \"Feature\", \"properties\": {{ \"OBJL\": 71 }}, \
         \"geometry\": {{ \"type\": \"Polygon\", \"coordinates\": [[[0, 2000], {}, [18520, 2000], [0, 2000]]] }} }}] }}",
        border.join(", ")
    )
}

#[test]
#[ignore = "a measurement"]
fn what_a_coast_of_20000_corners_costs() {
    let coast = ragged_coast();
    // Far off the coast, and with the side 10 m off its border.
    let fender = "[fender.side]\non = \"barge\"\nposition = [0, -6]\nfacing = \"-90 deg\"\nwidth = 2\nprojection = 1\n\
                  stiffness = \"2 MN/m\"\nmaterial = \"rock\"\n";
    for (place, at, more) in [
        ("far", "[-2000, 9000]", ""),
        ("near", "[40, 9000]", ""),
        ("far, with a fender", "[-2000, 9000]", fender),
        ("near, with a fender", "[40, 9000]", fender),
    ] {
        let times = ["solid = [\"LNDARE\"]\nsolid_material = \"rock\"", ""].map(|solid| {
            let began = Instant::now();
            let setup = scenario(solid, &format!("{}{more}", barge(at, "90 deg", "1 m/s")), &coast)
                .unwrap()
                .setup;
            let load_s = began.elapsed().as_secs_f64();
            let best = (0..5)
                .map(|_| {
                    let mut simulation = Simulation::new(setup.clone()).unwrap();
                    simulation.step().unwrap();
                    let began = Instant::now();
                    for _ in 0..500 {
                        simulation.step().unwrap();
                    }
                    began.elapsed().as_secs_f64() / 500.0
                })
                .fold(f64::INFINITY, |best, time| if time < best { time } else { best });
            (load_s, best)
        });
        let [(load_s, solid_s), (_, without_s)] = times;
        println!(
            "{place}: {:.3} µs a step with the coast, {:.3} µs without, ratio {:.2}; loaded in {load_s:.2} s",
            1e6 * solid_s,
            1e6 * without_s,
            solid_s / without_s
        );
    }
}
