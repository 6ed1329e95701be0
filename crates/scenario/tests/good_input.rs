//! A correct scenario becomes the expected set-up.

use fenderline_contact::{Vec2, vec2};
use fenderline_scenario::{Place, Scenario};
use fenderline_sim::{BodyVelocity, Integrator, Method, PairSetup};

/// Bodies and materials are not in alphabetical order; every optional key is left out.
const SMALL: &str = r#"
[time]
step = 0.5
duration = 0.75

[material.soft]
stiffness = 1000

[material.hard]
stiffness = 2000
shear_stiffness = 5000
friction_static = 0.3

[body.tug]
outline = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
mass = 1000
gyradius = 2

[body.quay]
fixed = true
outline = [[-1, -1], [1, -1], [1, 1], [-1, 1]]

[body.barge]
outline = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
mass = 500
yaw_inertia = "3 t.m^2"

[[pair]]
bodies = ["*", "*"]
material = "hard"

[[pair]]
bodies = ["quay", "tug"]
material = "soft"
"#;

fn parse(text: &str) -> Scenario {
    Scenario::parse(text, "folder/small.toml").unwrap()
}

#[test]
fn defaults_and_file_order() {
    let scenario = parse(SMALL);
    assert_eq!(scenario.title, "small");
    assert_eq!(scenario.notices, []);
    let setup = scenario.setup;
    assert_eq!((setup.step_s, setup.duration_s), (0.5, 0.75));
    assert_eq!((setup.integrator, setup.method), (Integrator::SemiImplicit, Method::Coupled));
    let names: Vec<_> = setup.bodies.iter().map(|body| body.name.as_str()).collect();
    assert_eq!(names, ["tug", "quay", "barge"]);
    let names: Vec<_> = setup.materials.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(names, ["soft", "hard"]);
    assert_eq!(setup.pairs, [PairSetup { bodies: [1, 0], material: 0 }]);
    assert_eq!(setup.all_other_pairs, Some(1));
    assert_eq!(setup.loads, []);

    let tug = &setup.bodies[0];
    let mass = tug.mass.unwrap();
    assert_eq!((mass.mass_kg, mass.yaw_inertia_kgm2), (1000.0, 4000.0));
    assert_eq!((mass.added_surge_kg, mass.added_sway_kg, mass.added_yaw_kgm2), (0.0, 0.0, 0.0));
    assert_eq!((tug.position_m, tug.heading_rad), (Vec2::ZERO, 0.0));
    assert_eq!(tug.velocity, BodyVelocity::default());
    assert_eq!(setup.bodies[1].mass, None);
    assert_eq!(setup.bodies[2].mass.unwrap().yaw_inertia_kgm2, 3000.0);

    let hard = setup.materials[1].material;
    assert_eq!(
        (hard.damping_nspm2, hard.shear_stiffness_npm, hard.restitution),
        (0.0, 5000.0, 0.0)
    );
    assert_eq!((hard.friction_static, hard.friction_dynamic), (0.3, 0.3));
}

#[test]
fn units_and_fractions() {
    let text = SMALL
        .replace(
            "mass = 1000",
            "mass = \"1 t\"\nadded_mass = { surge = 0.25, sway = \"50 %\" }\n\
             position = [\"1 nmi\", -3]\nheading = \"270 deg\"\n\
             velocity.sway = \"36 km/h\"\nvelocity.yaw = \"-180 deg/s\"",
        )
        .replace("gyradius = 2", "gyradius = \"2 m\"\nadded_mass.yaw = 2");
    // A dotted key cannot extend an inline table: TOML's own rule.
    assert!(Scenario::parse(&text, "x.toml").is_err());
    let tug = parse(
        &text
            .replace("sway = \"50 %\" }", "sway = \"50 %\", yaw = 2 }")
            .replace("\nadded_mass.yaw = 2", ""),
    )
    .setup
    .bodies[0]
        .clone();
    let mass = tug.mass.unwrap();
    assert_eq!((mass.mass_kg, mass.added_surge_kg, mass.added_sway_kg), (1000.0, 250.0, 500.0));
    assert_eq!((mass.yaw_inertia_kgm2, mass.added_yaw_kgm2), (4000.0, 8000.0));
    assert_eq!(tug.position_m, vec2(1852.0, -3.0));
    assert_eq!(tug.heading_rad, 1.5 * core::f64::consts::PI);
    assert_eq!((tug.velocity.surge_mps, tug.velocity.sway_mps), (0.0, 10.0));
    assert_eq!(tug.velocity.yaw_radps, -core::f64::consts::PI);
}

#[test]
fn a_load_lasts_until_its_end_or_the_end_of_the_run() {
    let text = format!(
        "{SMALL}[[load]]\nbody = \"barge\"\nforce = [\"1 kN\", 2]\n\
         [[load]]\nbody = \"tug\"\nmoment = \"3 kN.m\"\nfrom = \"1 min\"\nuntil = \"2 min\"\n"
    );
    let loads = parse(&text).setup.loads;
    assert_eq!((loads[0].body, loads[0].force_n), (2, vec2(1000.0, 2.0)));
    assert_eq!((loads[0].moment_nm, loads[0].from_s), (0.0, 0.0));
    assert_eq!(loads[0].until_s, f64::INFINITY);
    assert_eq!((loads[1].force_n, loads[1].moment_nm), (Vec2::ZERO, 3000.0));
    assert_eq!((loads[1].from_s, loads[1].until_s), (60.0, 120.0));
}

#[test]
fn corrections_of_an_outline_give_notices() {
    let clockwise = "[body.barge]\noutline = [[-1, 1], [1, 1], [1, -1], [1, -1], [-1, -1]]";
    let square = "[body.barge]\noutline = [[-1, -1], [1, -1], [1, 1], [-1, 1]]";
    let scenario = parse(&SMALL.replace(square, clockwise));
    let keys: Vec<_> = scenario.notices.iter().map(|notice| notice.key.as_str()).collect();
    assert_eq!(keys, ["body.barge.outline", "body.barge.outline"]);
    let line = |place: &Place| match place {
        Place::File { line, .. } => *line,
        other => panic!("{other}"),
    };
    assert!(scenario.notices.iter().all(|notice| line(&notice.place) == 24));
    let shown = scenario.notices[0].to_string();
    assert!(shown.starts_with("folder/small.toml:24:11: `body.barge.outline`: "), "{shown}");
    assert_eq!(scenario.setup.bodies[2].outline.vertices().len(), 4);
}

#[test]
fn unused_bodies_and_materials_give_notices() {
    let scenario = parse(&SMALL.replace("[\"*\", \"*\"]", "[\"quay\", \"barge\"]"));
    assert_eq!(scenario.notices, []);
    let start = SMALL.find("[[pair]]").unwrap();
    let notices = |text: &str| -> Vec<String> {
        parse(text).notices.iter().map(ToString::to_string).collect()
    };
    let pair = "[[pair]]\nbodies = [\"tug\", \"quay\"]\nmaterial = \"hard\"";
    let shown = notices(&format!("{}{pair}", &SMALL[..start]));
    assert_eq!(shown.len(), 2);
    assert_eq!(
        shown[0],
        "folder/small.toml:6:1: `material.soft`: no effect: no pair or fender uses this material"
    );
    assert!(shown[1].contains("`body.barge`: no pair names this body"), "{}", shown[1]);
    let shown = notices(&SMALL[..start]);
    assert_eq!(shown.len(), 1, "one for all");
    assert!(
        shown[0].ends_with("`pair`: there are no pairs, so no bodies can touch"),
        "{}",
        shown[0]
    );
}

#[test]
fn windows_line_ends_and_a_byte_order_mark_change_nothing() {
    let plain = parse(SMALL);
    assert_eq!(parse(&SMALL.replace('\n', "\r\n")), plain);
    assert_eq!(parse(&format!("\u{feff}{SMALL}")), plain);
}
