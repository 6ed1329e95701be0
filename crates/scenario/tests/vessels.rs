//! The vessel data against published numbers, and every mistake in a vessel file.

use std::path::{Path, PathBuf};

use boon::{Compiler, Schemas};
use fenderline_contact::vec2;
use fenderline_scenario::{Scenario, Standing, VesselData, VesselLibrary, vessel_schema};
use fenderline_sim::hydro::{Polynomial, VALIDATED_RATIOS};
use fenderline_sim::{LineEnd, Simulation};
use serde_json::{Value as Json, json};
use toml::de::{DeTable, DeValue};

fn built_in(name: &str) -> VesselData {
    VesselLibrary::built_in().vessel(name).unwrap_or_else(|error| panic!("{error}")).clone()
}

/// The data files of the repository.
fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../vessels");
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("the entry can be read").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
        .collect();
    files.sort();
    files
}

/// A built-in file cannot be added again, as its names exist already.
#[test]
fn every_file_of_the_folder_is_built_in_and_fits_the_schema() {
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    compiler.add_resource("vessels.json", vessel_schema()).unwrap();
    let index = compiler.compile("vessels.json", &mut schemas).expect("the schema is a schema");
    assert!(!files().is_empty());
    for file in files() {
        let text = std::fs::read_to_string(&file).unwrap();
        let error = VesselLibrary::built_in().with_file(&text, "again.toml").unwrap_err();
        assert!(error.message().contains("already"), "{}: {error}", file.display());
        let document = json_of(&DeValue::Table(DeTable::parse(&text).unwrap().into_inner()));
        if let Err(error) = schemas.validate(&document, index) {
            panic!("{}: {error:#}", file.display());
        }
    }
}

/// The schema refuses what the reader refuses, where that needs no computation.
#[test]
fn the_schema_of_vessel_files_knows_what_goes_together() {
    let (mut schemas, mut compiler) = (Schemas::new(), Compiler::new());
    compiler.add_resource("vessels.json", vessel_schema()).unwrap();
    let index = compiler.compile("vessels.json", &mut schemas).expect("the schema is a schema");
    let fits = |text: &str| {
        let document = json_of(&DeValue::Table(DeTable::parse(text).unwrap().into_inner()));
        schemas.validate(&document, index).is_ok()
    };
    assert!(fits(GOOD));
    for (part, other) in [
        ("beam = \"20 m\"\n", ""),
        ("block_coefficient = 0.74\n", ""),
        ("block_coefficient = 0.74", "block_coefficient = 0.74\nvolume = 14000"),
        ("block_coefficient = 0.74", "block_coefficient = 1.4"),
        ("span = \"5 m\"\n", ""),
        ("span = \"5 m\"", "span = \"5 m\"\naspect_ratio = 1.4"),
        ("[vessel.coaster.rudder]\narea = \"18 m^2\"\nspan = \"5 m\"\n", ""),
        ("standing = \"assumed\"", "standing = \"sure\""),
        ("draught = ", "draft = "),
    ] {
        let text = GOOD.replacen(part, other, 1);
        assert!(!fits(&text), "{other} is accepted by the schema");
        assert!(VesselLibrary::built_in().with_file(&text, "x.toml").is_err(), "{other}");
    }
}

fn json_of(value: &DeValue<'_>) -> Json {
    match value {
        DeValue::String(text) => json!(text),
        DeValue::Integer(number) => serde_json::from_str(number.as_str()).unwrap(),
        DeValue::Float(number) => serde_json::from_str(number.as_str()).unwrap(),
        DeValue::Boolean(flag) => json!(flag),
        DeValue::Datetime(time) => json!(time.to_string()),
        DeValue::Array(items) => items.iter().map(|item| json_of(item.get_ref())).collect(),
        DeValue::Table(table) => {
            let entry = table.iter().map(|(k, v)| (k.get_ref().to_string(), json_of(v.get_ref())));
            Json::Object(entry.collect())
        }
    }
}

#[test]
fn every_built_in_vessel_is_there_and_has_a_source_for_every_number() {
    let library = VesselLibrary::built_in();
    let names: Vec<&str> = library.vessels().iter().map(|vessel| vessel.name.as_str()).collect();
    for name in ["kvlcc2", "kvlcc2-model", "kcs", "esso-osaka", "container-ship", "paper-tug"] {
        assert!(names.contains(&name), "{name}");
    }
    for vessel in library.vessels() {
        assert!(vessel.ship.check().is_ok(), "{}", vessel.name);
        // A vessel that may berth has chocks and bitts; a tug has a belting to push with.
        if vessel.outline_m.is_some() && vessel.name != "paper-tug" {
            assert!(!vessel.chocks.is_empty() && !vessel.bitts.is_empty(), "{}", vessel.name);
        }
        for source in &vessel.origin.sources {
            let listed = !source.source.is_empty() && !source.group.is_empty();
            assert!(listed && (source.is_estimate || !source.figures.is_empty()), "{source:?}");
        }
    }
}

/// Yasukawa & Yoshimura (2015), tables 1 and 3, number by number.
#[test]
#[rustfmt::skip]
fn kvlcc2_has_the_published_numbers() {
    for (name, numbers) in [
        ("kvlcc2", [320.0, 58.0, 20.8, 312_600.0, 11.2, 9.86, 15.8, 112.5, 0.35]),
        ("kvlcc2-model", [7.0, 1.27, 0.46, 3.27, 0.25, 0.216, 0.345, 0.0539, 0.40]),
    ] {
        let ship = built_in(name).ship;
        let (hull, gear) = (ship.particulars, ship.propulsion.expect("a propeller"));
        let rudder = gear.rudder;
        let [length, beam, draught, volume, gravity, diameter, span, area, wake] = numbers;
        assert_eq!([hull.length_m, hull.beam_m, hull.draught_m], [length, beam, draught]);
        assert_eq!([hull.volume_m3, hull.centre_of_gravity_m], [volume, gravity]);
        assert_eq!([gear.propeller.diameter_m, gear.wake.straight], [diameter, wake]);
        assert_eq!([rudder.area_m2, rudder.propeller_to_span], [area, diameter / span]);
        assert_eq!(hull.yaw_gyradius_ratio, 0.25);
        let Some(Polynomial::Sway(p)) = ship.hull.under_way else { panic!("{name}") };
        assert_eq!(
            [p.resistance, p.x_vv, p.x_vr, p.x_rr, p.x_vvvv],
            [0.022, -0.040, 0.002, 0.011, 0.771]
        );
        assert_eq!(
            [p.y_v, p.y_r, p.y_vvv, p.y_vvr, p.y_vrr, p.y_rrr],
            [-0.315, 0.083, -1.607, 0.379, -0.391, 0.008]
        );
        assert_eq!(
            [p.n_v, p.n_r, p.n_vvv, p.n_vvr, p.n_vrr, p.n_rrr],
            [-0.137, -0.049, -0.030, -0.294, 0.055, -0.013]
        );
        let unit = hull.mass_unit_m3();
        assert_eq!(
            [ship.added_mass.surge_m3, ship.added_mass.sway_m3],
            [0.022 * unit, 0.223 * unit]
        );
        assert_eq!(ship.added_mass.yaw_m5, 0.011 * hull.inertia_unit_m5());
        assert_eq!(gear.propeller.thrust_polynomial, Some([0.2931, -0.2753, -0.1385]));
        assert_eq!([gear.thrust_deduction, gear.wake.rate, gear.wake.place], [0.220, 2.0, -0.48]);
        assert_eq!(gear.wake.limits, [1.1, 1.6]);
        assert_eq!(
            [rudder.resistance_deduction, rudder.hull_gain, rudder.hull_place, rudder.place],
            [0.387, 0.312, -0.464, -0.5]
        );
        assert_eq!(
            [rudder.straightening[0], rudder.straightening[1], rudder.straightening_place],
            [0.395, 0.640, -0.710]
        );
        assert_eq!(
            [rudder.wake_ratio, rudder.race_gain, rudder.lift_gradient],
            [1.09, 0.50, 2.747]
        );
    }
    let (ship, model) = (built_in("kvlcc2"), built_in("kvlcc2-model"));
    // By Froude's law: times go with the root of the lengths.
    let time_scale = (320.0_f64 / 7.0).sqrt();
    let [of_ship, of_model] = [&ship, &model].map(|v| v.approach_mps.expect("a speed"));
    assert!((of_ship - 15.5 * 1852.0 / 3600.0).abs() < 1e-12);
    assert!((of_ship / of_model - time_scale).abs() < 1e-12);
    assert!((model.rudder.rate_per_s / ship.rudder.rate_per_s - time_scale).abs() < 1e-12);
    // Inherited numbers are listed as such.
    let listed = |part: &str| {
        let mut all = model.origin.sources.iter();
        all.any(|source| source.figures.iter().any(|figure| figure.name == part))
    };
    assert!(listed("sway_polynomial.x_vvvv") && listed("rudder.race_gain") && listed("rudder.rate"));
}

/// KCS, number by number (vessels/kcs.toml says where they are from). 1 − (1 − t) is t to the last bit in all three.
#[test]
#[rustfmt::skip]
fn kcs_has_the_published_numbers() {
    let vessel = built_in("kcs");
    let ship = vessel.ship;
    let (hull, gear) = (ship.particulars, ship.propulsion.expect("a propeller"));
    let rudder = gear.rudder;
    assert_eq!(
        [hull.length_m, hull.beam_m, hull.draught_m, hull.centre_of_gravity_m],
        [230.0, 32.2, 10.8, -3.404]
    );
    assert_eq!(hull.volume_m3, 0.651 * 230.0 * 32.2 * 10.8);
    let Some(Polynomial::Drift(p)) = ship.hull.under_way else { panic!("no polynomial") };
    assert_eq!(
        [p.x_0, p.x_bb, p.x_br, p.x_rr, p.x_bbbb],
        [-0.0167, -0.0549, -0.1084, -0.0120, -0.0417]
    );
    assert_eq!(
        [p.y_b, p.y_r, p.y_bbb, p.y_bbr, p.y_brr, p.y_rrr],
        [0.2252, 0.0398, 1.7179, -0.4832, 0.8341, -0.005]
    );
    assert_eq!(
        [p.n_b, p.n_r, p.n_bbb, p.n_bbr, p.n_brr, p.n_rrr],
        [0.1111, -0.0465, 0.1752, -0.6168, 0.0512, -0.0387]
    );
    let added = ship.added_mass;
    assert_eq!([added.surge_m3, added.sway_m3, added.yaw_m5], [1790.85, 44_324.18, 140_067_300.0]);
    assert_eq!(gear.propeller.thrust_polynomial, Some([0.5228, -0.4390, -0.0609]));
    assert_eq!([gear.propeller.diameter_m, gear.wake.place], [7.9, -0.4565]);
    assert_eq!(
        [1.0 - gear.wake.straight, 1.0 - gear.thrust_deduction, 1.0 - rudder.resistance_deduction],
        [0.645, 0.793, 0.742]
    );
    assert_eq!(rudder.area_m2, 230.0 * 10.8 / 54.86);
    assert_eq!(
        [rudder.wake_ratio, rudder.propeller_to_span, rudder.race_gain],
        [0.956, 0.798, 0.633]
    );
    assert_eq!(
        [rudder.straightening[0], rudder.straightening[1], rudder.straightening_place],
        [0.338, 0.492, -0.755]
    );
    assert_eq!([rudder.hull_gain, rudder.hull_place], [0.361, -0.436]);
    assert!((vessel.shaft.expect("a shaft").full_rps - 115.5 / 60.0).abs() < 1e-12);
}

/// Esso Osaka by Miyauchi et al. (2022), number by number.
#[test]
#[rustfmt::skip]
fn esso_osaka_has_the_published_numbers() {
    let ship = built_in("esso-osaka").ship;
    let (hull, low) = (ship.particulars, ship.hull.low_speed);
    assert_eq!([hull.length_m, hull.beam_m, hull.draught_m], [3.0, 0.489, 0.201]);
    let unit = hull.mass_unit_m3();
    let added = ship.added_mass;
    assert_eq!([added.surge_m3 / unit, added.sway_m3 / unit], [0.0467, 0.2579]);
    let inertia = (hull.yaw_inertia_m5() + added.yaw_m5) / hull.inertia_unit_m5();
    assert!((inertia - 0.0286).abs() < 1e-15 && (hull.volume_m3 / unit - 0.2708).abs() < 1e-15);
    assert_eq!([low.ahead, low.astern, low.surge_vr], [-0.0214, -0.0319, -0.0081]);
    assert_eq!([low.sway_v, low.sway_r, low.yaw_v, low.yaw_r], [-0.3728, 0.116, -0.1458, -0.0485]);
    let flow = low.cross_flow;
    assert_eq!(
        [flow.drag_coefficient, flow.yaw_gain_force, flow.yaw_gain_moment],
        [0.9665, 2.217, 0.8097]
    );
    let propulsion = ship.propulsion.expect("she has a propeller and a rudder");
    let (propeller, rudder) = (propulsion.propeller, propulsion.rudder);
    assert_eq!([propeller.diameter_m, rudder.area_m2], [0.084, 0.01063]);
}

/// Estimates are listed with their formula and its standing, quantity by quantity.
#[test]
fn a_vessel_from_main_particulars_lists_everything_that_is_estimated() {
    let vessel = built_in("bulk-carrier");
    let estimates: Vec<_> = vessel.origin.estimates().collect();
    for (group, standing) in [
        ("added mass", Standing::Found),
        ("hull under way", Standing::Found),
        ("resistance ahead", Standing::Recalled),
        ("resistance astern", Standing::Found),
        ("cross-flow drag", Standing::Found),
        ("wake", Standing::Found),
        ("thrust deduction", Standing::Found),
        ("lift gradient of the rudder", Standing::Found),
        ("wake in a turn", Standing::Derived),
        ("flow straightening", Standing::Found),
        ("rudder and hull", Standing::Found),
    ] {
        let found = estimates.iter().find(|source| source.group == group);
        let found = found.unwrap_or_else(|| panic!("{group} is not listed"));
        assert_eq!((found.standing, found.figures.is_empty()), (standing, false), "{group}");
    }
    // Taylor's wake, by hand: 0.5 · 0.817 − 0.05.
    let wake = estimates.iter().find(|source| source.group == "wake").expect("listed");
    assert_eq!(wake.figures[0].text, "0.3585");
    // Esso Osaka's hull was measured: only her propeller outside of ahead operation is estimated.
    let esso_osaka = built_in("esso-osaka");
    let estimated: Vec<_> =
        esso_osaka.origin.estimates().map(|source| source.group.as_str()).collect();
    assert_eq!(
        estimated,
        ["propeller outside its first quadrant, and its torque", "thrust deduction astern"]
    );
}

/// The worked examples of the guide are correct: the library's S175, and a scenario that runs.
#[test]
fn the_examples_of_the_guide_to_vessels_are_good() {
    let guide = include_str!("../../../vessels/README.md");
    let blocks: Vec<(&str, &str)> = guide
        .split("```toml")
        .skip(1)
        .filter_map(|rest| rest.split("```").next()?.split_once('\n'))
        .collect();
    let [("", file), (" scenario", scenario)] = blocks[..] else { panic!("{blocks:?}") };
    let library = VesselLibrary::built_in().with_file(file, "my_ship.toml").expect("a good file");
    let (mine, theirs) = (library.vessel("my-ship").expect("there"), built_in("s175"));
    assert_eq!((mine.ship, mine.approach_mps), (theirs.ship, theirs.approach_mps));
    assert!(theirs.origin.outside.is_empty(), "she is within the range: {:?}", theirs.origin);

    let scenario = Scenario::parse(scenario, "my_scenario.toml").expect("a good scenario");
    let about_her =
        scenario.notices.iter().filter(|notice| notice.key.starts_with("vessel.my-ship"));
    assert_eq!(about_her.count(), 0, "{:?}", scenario.notices);
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    for _ in 0..20 {
        simulation.step().expect("a good step");
    }
    // The guide's table of ranges is the program's.
    for (ratio, [low, high]) in VALIDATED_RATIOS {
        let name = ratio.name().replace('_', " ").replace("length bp", "length");
        let row = format!("| {name} | {low} to {high} |");
        assert!(guide.contains(&row), "{row}");
    }
}

/// A scenario with one vessel of its own and a body of the library's tug.
fn ship_and_tug(beam: &str, block: &str) -> String {
    format!(
        r#"title = "Outside"
time = {{ step = "0.5 s", duration = "10 s" }}
[vessel.mine]
length_bp = "175 m"
beam = "{beam}"
draught = "8.5 m"
block_coefficient = {block}
[body.mine]
vessel = "mine"
outline = [[-87, -8], [87, -8], [87, 8], [-87, 8]]
position = [0, 0]
[body.tug]
vessel = "asd-tug"
position = [0, 100]
"#
    )
}

/// A vessel outside the range of the formulas is estimated too; the notice names line, key, value and range.
#[test]
fn particulars_outside_the_range_of_the_estimate_give_a_notice_with_key_and_range() {
    let listed = |beam: &str, block: &str| {
        let scenario = Scenario::parse(&ship_and_tug(beam, block), "outside.toml");
        let notices = scenario.expect("a good scenario").notices;
        let lines = notices
            .iter()
            .filter(|notice| notice.message.contains("the range in which the formulas"));
        lines.map(ToString::to_string).collect::<Vec<String>>()
    };
    let tug =
        "outside.toml:13:10: `body.tug.vessel`: length_bp over beam is 2.500, outside 5.3 to 7.3";
    let [only] = &listed("25.4 m", "0.56")[..] else { panic!("within the range") };
    assert!(only.starts_with(tug), "{only}");
    let [fine, of_tug] = &listed("25.4 m", "0.45")[..] else { panic!("a fine ship and a tug") };
    let expected = "outside.toml:7:21: `vessel.mine.block_coefficient`: block_coefficient is 0.450, outside 0.55 to 0.85";
    assert!(fine.starts_with(expected) && of_tug.starts_with(tug), "{fine} {of_tug}");
    let [broad, deep, _] = &listed("35 m", "0.56")[..] else { panic!("too broad twice") };
    assert!(broad.contains("`vessel.mine.length_bp`: length_bp over beam is 5.000"), "{broad}");
    assert!(deep.contains("`vessel.mine.beam`: beam over draught is 4.118, outside 2.2"), "{deep}");
}

/// A vessel file without a mistake; each case below replaces a part of it.
const GOOD: &str = r#"[vessel.coaster]
title = "Coaster, 130 m"
length_overall = "136 m"
length_bp = "130 m"
beam = "20 m"
draught = "7.5 m"
block_coefficient = 0.74
centre_of_gravity = "1 m"

[vessel.coaster.propeller]
diameter = "4.4 m"
full = "130 rpm"

[vessel.coaster.rudder]
area = "18 m^2"
span = "5 m"

[vessel.coaster.thruster.bow]
along = "55 m"
force = "90 kN"

[vessel.coaster.windage]
frontal_area = "350 m^2"
lateral_area = "1300 m^2"
centroid_height = "7 m"
type = "cargo vessel, loaded"

[vessel.coaster.stability]
gm = "1.1 m"
gravity_above_keel = "7.4 m"
waterplane_area = "2150 m^2"

[vessel.coaster.outline]
origin = "after perpendicular"
points = [[-3, -8], [5, -10], [105, -10], [123, -6], [133, 0], [123, 6], [105, 10], [5, 10], [-3, 8]]

[vessel.coaster.chock.head]
at = [66, 2]
height = "7 m"

[vessel.coaster.bitts.waist]
at = [0, 9]
height = "6 m"

[vessel.coaster.belting.side]
from = [-40, 10]
to = [40, 10]
height = "2 m"
extent = "0.6 m"

[[vessel.coaster.source]]
of = [
    "length_overall", "length_bp", "beam", "draught", "block_coefficient", "centre_of_gravity", "propeller", "rudder",
    "thruster", "windage", "stability", "outline", "chock", "bitts", "belting",
]
source = "ours"
standing = "assumed"
"#;

/// A part, what replaces it, the key of the error, and a part of the message.
#[rustfmt::skip]
const MISTAKES: &[(&str, &str, &str, &str)] = &[
    ("length_bp = \"130 m\"\n", "", "vessel.coaster.length_bp", "is missing"),
    ("beam = \"20 m\"\n", "", "vessel.coaster.beam", "is missing"),
    ("title = \"Coaster, 130 m\"\n", "", "vessel.coaster.title", "is missing"),
    ("block_coefficient = 0.74\n", "", "vessel.coaster.block_coefficient", "is missing"),
    ("block_coefficient = 0.74", "block_coefficient = 1.4", "vessel.coaster.block_coefficient", "must be at most 1"),
    ("block_coefficient = 0.74", "volume = \"-100 m^3\"", "vessel.coaster.volume", "must be at least"),
    ("block_coefficient = 0.74", "displacement = \"-9000 t\"", "vessel.coaster.displacement", "must be at least"),
    ("block_coefficient = 0.74", "volume = \"30000 m^3\"", "vessel.coaster.volume", "block coefficient must be between 0.1 and 1"),
    ("block_coefficient = 0.74", "displacement = \"90000 t\"", "vessel.coaster.displacement", "block coefficient must be between 0.1 and 1"),
    ("block_coefficient = 0.74", "block_coefficient = 0.74\nvolume = \"14000 m^3\"", "vessel.coaster.block_coefficient", "does not go together"),
    ("beam = \"20 m\"", "beam = \"200 m\"", "vessel.coaster.beam", "beam [m] must be between"),
    ("centre_of_gravity = \"1 m\"", "centre_of_gravity = \"100 m\"", "vessel.coaster.centre_of_gravity", "must be between"),
    ("gm = \"1.1 m\"", "gm = \"-1.1 m\"", "vessel.coaster.stability.gm", "must be at least"),
    ("gm = \"1.1 m\"", "gm = \"9 m\"", "vessel.coaster.stability.gm", "in a hull of this size it is at most"),
    ("waterplane_area = \"2150 m^2\"", "waterplane_area = \"9000 m^2\"", "vessel.coaster.stability", "waterplane"),
    ("[123, 6], [105, 10], [5, 10]", "[123, 6], [105, 14], [5, 14]", "vessel.coaster.outline.points", "but the vessel's beam is 20 m"),
    ("[133, 0]", "[150, 0]", "vessel.coaster.outline.points", "but the vessel's length overall is 136 m"),
    ("length_overall = \"136 m\"\nlength_bp = \"130 m\"", "length_bp = \"100 m\"", "vessel.coaster.outline.points", "length between perpendiculars is 100 m"),
    ("[123, -6], [133, 0], [123, 6]", "[123, 6], [133, 0], [123, -6]", "vessel.coaster.outline.points", "cross"),
    ("at = [66, 2]", "at = [80, 2]", "vessel.coaster.chock.head.at", "is not on the vessel"),
    ("at = [0, 9]", "at = [0, 29]", "vessel.coaster.bitts.waist.at", "is not on the vessel"),
    ("to = [40, 10]", "to = [40, -10]", "vessel.coaster.belting.side", "not pass through midship"),
    ("along = \"55 m\"", "along = \"90 m\"", "vessel.coaster.thruster.bow.along", "is outside a ship of 130 m"),
    ("full = \"130 rpm\"\n", "", "vessel.coaster.propeller.full", "is missing"),
    ("span = \"5 m\"\n", "", "vessel.coaster.rudder.span", "or give `propeller_to_span`"),
    ("span = \"5 m\"", "span = \"5 m\"\naspect_ratio = 1.4", "vessel.coaster.rudder.aspect_ratio", "does not go together"),
    ("area = \"18 m^2\"", "area = \"5000 m^2\"", "vessel.coaster.rudder", "area of the rudder"),
    ("type = \"cargo vessel, loaded\"", "type = \"cargo vesel, loaded\"", "vessel.coaster.windage.type", "did you mean"),
    ("block_coefficient = 0.74\n", "block_coefficient = 0.74\ngyradius = \"300 m\"\n", "vessel.coaster.gyradius", "yaw gyradius over length must be"),
    ("block_coefficient = 0.74\n", "block_coefficient = 0.74\ngyradius = \"33 m\"\n", "vessel.coaster.gyradius", "has no source"),
    ("\"belting\",\n", "\n", "vessel.coaster.belting.side.from", "has no source"),
    ("\"belting\",", "\"belting\", \"low_speed\",", "vessel.coaster.source.0.of", "has no number under \"low_speed\""),
    ("\"belting\",", "\"belting\", \"beam\",", "vessel.coaster.source.0.of", "has two sources"),
    ("standing = \"assumed\"", "standing = \"sure\"", "vessel.coaster.source.0.standing", "is one of"),
    ("source = \"ours\"\n", "", "vessel.coaster.source.0.source", "is missing"),
    ("title =", "coefficients_of = \"kcss\"\ntitle =", "vessel.coaster.coefficients_of", "did you mean \"kcs\"?"),
    ("[vessel.coaster.rudder]\narea = \"18 m^2\"\nspan = \"5 m\"\n", "", "vessel.coaster.propeller", "needs `rudder` in the same table"),
    ("draught = \"7.5 m\"", "draft = \"7.5 m\"", "vessel.coaster.draft", "is not a key of"),
];

#[test]
fn every_mistake_in_a_vessel_file_names_file_key_and_line() {
    let good = VesselLibrary::built_in().with_file(GOOD, "ours.toml");
    let good = good.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(good.vessels().len(), VesselLibrary::built_in().vessels().len() + 1);
    for (part, mistake, key, fragment) in MISTAKES {
        assert!(GOOD.contains(part), "{part} is not in the good file");
        let error = VesselLibrary::built_in()
            .with_file(&GOOD.replacen(part, mistake, 1), "ours.toml")
            .expect_err(&format!("{mistake}: {fragment}"));
        let shown = error.to_string();
        assert_eq!(error.key(), Some(*key), "{shown}");
        assert!(shown.contains(fragment) && shown.contains("ours.toml:"), "{shown}");
        assert!(error.line().is_some(), "{shown}");
    }
    let twice = VesselLibrary::built_in().with_file(&GOOD.replace("coaster", "kcs"), "ours.toml");
    assert!(twice.unwrap_err().to_string().contains("there is a vessel named \"kcs\" already"));
}

/// A body's outline is a list of points, that of a vessel file a table.
#[test]
fn an_outline_that_is_a_list_of_points_is_told_the_keys_of_its_table() {
    let (before, rest) = GOOD.split_once("[vessel.coaster.outline]\n").unwrap();
    let (_, after) = rest.split_once("]]\n").unwrap();
    let list = "length_bp = \"130 m\"\noutline = [[-65, -10], [65, -10], [65, 10], [-65, 10]]";
    let text = format!("{before}{after}").replacen("length_bp = \"130 m\"", list, 1);
    let error = VesselLibrary::built_in().with_file(&text, "ours.toml").unwrap_err();
    assert_eq!(error.key(), Some("vessel.coaster.outline"), "{error}");
    let help = "write outline = { origin = \"midship\", points = [[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]] }";
    assert!(error.to_string().contains(help), "{error}");
}

/// A coaster of a user's file beside a quay and a tug of the library.
const HARBOUR: &str = r#"vessel_files = ["ours.toml"]

[time]
step = "0.5 s"
duration = "1 min"

[body.ship]
vessel = "coaster"
running = 0.5

[body.tug]
vessel = "asd-tug"
position = [0, 40]

[body.quay]
fixed = true
outline = [[-100, 0], [100, 0], [100, 9], [-100, 9]]
position = [0, -30]

[material.rubber]
stiffness = "500 kN/m^2"

[[pair]]
bodies = ["ship", "tug"]
material = "rubber"

[fender.bow]
on = "tug"
belting = "bow"
projection = "0.9 m"
material = "rubber"

[line.head]
from = "ship"
chock = "head"
to = "quay"
bollard = [90, 4]
bollard_height = "3 m"
rope = "polyester"
break_load = "600 kN"
pretension = "40 kN"

[line.towing]
from = "tug"
chock = "fore"
to = "ship"
bitts = "waist"
rope = "hmpe"
break_load = "900 kN"
pretension = "10 kN"
"#;

fn parse(text: &str) -> Result<Scenario, fenderline_scenario::ScenarioError> {
    Scenario::parse_among(text, "x.toml", &[], &mut |name| match name {
        "ours.toml" => Ok(GOOD.to_owned()),
        _ => Err(format!("{name}: not there")),
    })
}

#[test]
fn a_body_has_outline_mass_and_deck_of_its_vessel_about_the_centre_of_gravity() {
    let setup = parse(HARBOUR).unwrap_or_else(|error| panic!("{error}")).setup;
    let ship = &setup.bodies[0];
    // From the after perpendicular to midship 65 m, and one more to the centre of gravity.
    let (low, high) = ship.outline.bounds();
    assert_eq!((low, high), (vec2(-69.0, -10.0), vec2(67.0, 10.0)));
    let mass_kg = ship.mass.expect("she floats").mass_kg;
    assert_eq!(mass_kg, 1025.0 * (0.74 * 130.0 * 20.0 * 7.5));
    let vessel = &setup.world.vessels[0];
    assert!((vessel.shaft.value - 0.5 * 130.0 / 60.0).abs() < 1e-12);
    assert_eq!(vessel.origin.title, "Coaster, 130 m");
    let [head, towing] = [0, 1].map(|index| &setup.world.lines[index]);
    assert_eq!((head.fairlead_m, head.fairlead_above_water_m), (vec2(65.0, 2.0), 7.0));
    let Some(LineEnd::OnBody { body, at_m, above_water_m }) = towing.end else {
        panic!("on the ship")
    };
    assert_eq!((body, at_m, above_water_m), (0, vec2(-1.0, 9.0), 6.0));
    let bow = &setup.fenders[0];
    assert_eq!((bow.position_m, bow.facing_rad, bow.width_m), (vec2(16.0, 0.0), 0.0, 6.0));
    assert_eq!((bow.height_m, bow.above_water_m), (2.0, 1.5));
}

#[rustfmt::skip]
const HARBOUR_MISTAKES: &[(&str, &str, &str, &str)] = &[
    ("vessel = \"coaster\"", "vessel = \"coster\"", "body.ship.vessel", "did you mean \"coaster\"?"),
    ("vessel = \"asd-tug\"", "vessel = \"asd-tug\"\nrunning = 0.5", "body.tug.running", "has no propeller"),
    ("fixed = true", "fixed = true\nrunning = 0.5", "body.quay.running", "is for floating bodies"),
    ("vessel = \"asd-tug\"", "mass = \"9 t\"\ngyradius = 3\nrunning = 0.5\noutline = [[0, 0], [1, 0], [1, 1]]", "body.tug.running", "with a `vessel`"),
    ("vessel = \"asd-tug\"", "vessel = \"esso-osaka\"", "body.tug.outline", "is missing"),
    ("belting = \"bow\"", "belting = \"bw\"", "fender.bow.belting", "did you mean \"bow\"?"),
    ("belting = \"bow\"", "belting = \"bow\"\nwidth = 3", "fender.bow.width", "does not go together with `belting`"),
    ("on = \"tug\"", "on = \"quay\"", "fender.bow.belting", "the body that is named there is not a vessel"),
    ("belting = \"bow\"\n", "", "fender.bow.position", "is missing"),
    ("chock = \"head\"", "chock = \"hed\"", "line.head.chock", "did you mean \"head\"?"),
    ("chock = \"head\"", "chock = \"head\"\nfairlead_height = 3", "line.head.fairlead_height", "does not go together with `chock`"),
    ("chock = \"head\"", "chock = \"head\"\nfairlead = [1, 1]", "line.head.chock", "does not go together with `fairlead`"),
    ("chock = \"head\"\n", "", "line.head.fairlead", "is missing"),
    ("bollard = [90, 4]\nbollard_height = \"3 m\"", "bitts = \"waist\"", "line.head.bitts", "the body that is named there is not a vessel"),
    ("[body.ship]", "[vessel.kcs]\nfrom = \"kvlcc2\"\n\n[body.ship]", "vessel.kcs", "has a vessel named \"kcs\" already"),
    ("[body.ship]", "[vessel.x]\nfrom = \"kvlc2\"\n\n[body.ship]", "vessel.x.from", "did you mean \"kvlcc2\"?"),
    ("[body.ship]", "[vessel.x]\nfrom = \"kcs\"\nrudder = { area = 3 }\n\n[body.ship]", "vessel.x.rudder.area", "does not go together with `from`"),
    ("[body.ship]", "[vessel.x]\nfrom = \"asd-tug\"\nrudder = { rate = 0.1 }\n\n[body.ship]", "vessel.x.rudder", "has no rudder"),
    ("\"ours.toml\"", "\"theirs.toml\"", "vessel_files", "cannot read theirs.toml"),
];

#[test]
fn every_mistake_in_a_reference_to_a_vessel_names_its_key() {
    for (part, mistake, key, fragment) in HARBOUR_MISTAKES {
        assert!(HARBOUR.contains(part), "{part} is not in the good scenario");
        let error = parse(&HARBOUR.replacen(part, mistake, 1))
            .expect_err(&format!("{mistake}: {fragment}"));
        let shown = error.to_string();
        assert_eq!(error.key(), Some(*key), "{shown}");
        assert!(shown.contains(fragment), "{shown}");
    }
    // A mistake in the vessel file points at that file.
    let error = Scenario::parse_among(HARBOUR, "x.toml", &[], &mut |_| {
        Ok(GOOD.replace("gm = \"1.1 m\"", "gm = \"-1 m\""))
    });
    assert!(error.unwrap_err().to_string().contains("ours.toml:"));
}

#[test]
fn a_vessel_with_from_differs_only_in_the_given_keys() {
    let text = |own: &str| {
        HARBOUR.replace("vessel = \"coaster\"", "vessel = \"mine\"").replace(
            "[body.ship]",
            &format!("[vessel.mine]\nfrom = \"coaster\"\n{own}\n[body.ship]"),
        )
    };
    let vessel = |own: &str| {
        let scenario = parse(&text(own)).unwrap_or_else(|error| panic!("{error}"));
        scenario.setup.world.vessels[0].clone()
    };
    let plain = parse(HARBOUR).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(vessel(""), plain.setup.world.vessels[0]);

    let faster = vessel("rudder = { rate = \"4 deg/s\" }");
    assert!((faster.rudder.rate_per_s.to_degrees() - 4.0).abs() < 1e-12);
    let rate = |vessel: &fenderline_sim::VesselSetup| {
        let listed = vessel
            .origin
            .sources
            .iter()
            .filter(|source| source.figures.iter().any(|figure| figure.name == "rudder.rate"));
        listed.map(|source| source.standing).collect::<Vec<_>>()
    };
    assert_eq!(rate(&faster), [Standing::Given]);
    assert_eq!(rate(&plain.setup.world.vessels[0]), [Standing::Assumed]);
    let rest = |vessel: &fenderline_sim::VesselSetup| {
        (vessel.ship, vessel.shaft, vessel.thrusters.clone(), vessel.windage.clone(), vessel.float)
    };
    assert_eq!(rest(&faster), rest(&plain.setup.world.vessels[0]));
    assert_eq!(faster.rudder.stop, plain.setup.world.vessels[0].rudder.stop);

    // Tables other than propeller and rudder are replaced whole.
    let other = vessel("thruster.stern = { along = \"-50 m\", force = \"50 kN\" }");
    assert_eq!(other.thrusters.len(), 1);
    assert_eq!(other.thrusters[0].name, "stern");
    let listed =
        |name: &str| other.origin.sources.iter().flat_map(|s| &s.figures).any(|f| f.name == name);
    assert!(listed("thruster.stern.force") && !listed("thruster.bow.force"));
}
