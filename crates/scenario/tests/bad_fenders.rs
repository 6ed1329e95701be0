//! Every mistake in a fender or a berthing study gives one message that names key and line. A correct one becomes the
//! expected set-up.

use fenderline_contact::{FenderLaw, Stop};
use fenderline_scenario::Scenario;
use fenderline_sim::HullPressure;

/// A scenario without a mistake; each case below replaces a part of it.
const GOOD: &str = r#"[time]
step = "0.1 s"
duration = "20 s"

[material.facing]
stiffness = 0
damping = 0

[material.rubber]
stiffness = "500 kN/m^2"

[body.ship]
outline = [[-50, -10], [50, -10], [50, 10], [-50, 10]]
mass = "9000 t"
gyradius = "25 m"

[body.quay]
fixed = true
outline = [[-100, 0], [100, 0], [100, 9], [-100, 9]]
position = [0, 12]

[fender.cone]
on = "quay"
position = [-20, 0]
facing = "-90 deg"
width = "2 m"
type = "cone"
height = "1 m"
rated_reaction = "600 kN"
temperature = -15
material = "facing"
hull = "bulk carrier"

[fender.pneumatic]
on = "quay"
position = [20, 0]
facing = "-90 deg"
width = "6.5 m"
type = "pneumatic"
size = "3300x6500 50kPa"
material = "facing"

[fender.table]
on = "ship"
position = [0, -10]
facing = "-90 deg"
width = "1 m"
projection = "0.8 m"
curve = [[0, 0], ["0.3 m", "300 kN"], ["0.6 m", "500 kN"]]
rated_deflection = "0.5 m"
tolerance = "-10 %"
material = "facing"

[fender.area]
on = "quay"
position = [0, 0]
facing = "-90 deg"
width = "2 m"
projection = "1 m"
material = "rubber"

[[pair]]
bodies = ["ship", "quay"]
material = "rubber"

[berthing]
ship = "ship"
length_bp = "96 m"
beam = "20 m"
draught = "7 m"
under_keel_clearance = "1 m"
block_coefficient = 0.7
"#;

/// `part` becomes `mistake`; the error is about `key`, at the line of the text `at`, and has `fragment`
/// in its message or help.
struct Case {
    part: &'static str,
    mistake: &'static str,
    at: &'static str,
    key: &'static str,
    fragment: &'static str,
}

const fn case(
    part: &'static str,
    mistake: &'static str,
    at: &'static str,
    key: &'static str,
    fragment: &'static str,
) -> Case {
    Case { part, mistake, at, key, fragment }
}

#[rustfmt::skip]
const CASES: &[Case] = &[
    case("on = \"quay\"\nposition = [-20", "on = \"quai\"\nposition = [-20", "on = \"quai\"", "fender.cone.on", "did you mean \"quay\"?"),
    case("material = \"facing\"\nhull", "material = \"facin\"\nhull", "material = \"facin\"", "fender.cone.material", "did you mean \"facing\"?"),
    case("type = \"cone\"", "type = \"coen\"", "type = \"coen\"", "fender.cone.type", "did you mean \"cone\"?"),
    case("size = \"3300x6500 50kPa\"", "size = \"3300x6500 50kP\"", "size = \"33", "fender.pneumatic.size", "did you mean \"3300x6500 50kPa\"?"),
    case("hull = \"bulk carrier\"", "hull = \"bulker\"", "hull = ", "fender.cone.hull", "there is no type of ship named \"bulker\""),
    case("temperature = -15", "temperature = -55", "temperature = -55", "fender.cone.temperature", "must be between -30 and 50 °C"),
    case("temperature = -15", "temperature = 99", "temperature = 99", "fender.cone.temperature", "must be at most 80 °C, but is 99 °C"),
    case("temperature = -15", "temperature = \"15 m\"", "temperature = ", "fender.cone.temperature", "`m` is not a unit of temperature"),
    case("height = \"1 m\"\nrated_reaction = \"600 kN\"", "", "[fender.cone]", "fender.cone.size", "is missing"),
    case("height = \"1 m\"", "height = \"1 m\"\nsize = \"1050 F1.1\"", "height = ", "fender.cone.height", "does not go together with `size`"),
    case("type = \"cone\"", "type = \"cone\"\nstiffness = \"1 MN/m\"", "stiffness = \"1 MN/m\"", "fender.cone.stiffness", "does not go together with `type`"),
    case("type = \"cone\"", "type = \"unit element\"", "temperature = ", "fender.cone.temperature", "put the maker's factors into the fender file: [family.\"unit element\".temperature]"),
    case("type = \"cone\"\nheight = \"1 m\"\nrated_reaction", "type = \"unit element\"\nheight = \"1 m\"\n#", "height = \"1 m\"", "fender.cone.height", "give the rated reaction of the fender yourself"),
    case("rated_deflection = \"0.5 m\"", "returned_energy = 1.2", "returned_energy = 1.2", "fender.table.returned_energy", "must be at most 1, but is 1.2"),
    case("rated_deflection = \"0.5 m\"", "returned_energy = -0.1", "returned_energy = -0.1", "fender.table.returned_energy", "must be at least 0.05, but is -0.1"),
    case("rated_deflection = \"0.5 m\"", "returned_energy = 0.5\nunloading = [[0, 0], [1, 1]]", "unloading = ", "fender.table.unloading", "does not go together with `returned_energy`"),
    case("rated_deflection = \"0.5 m\"", "unloading = [[0, 0], [\"0.6 m\", \"501 kN\"]]", "unloading = ", "fender.table.unloading", "at a deflection of 0.6 the reaction must be between 0 and 500000, but is 501000"),
    case("rated_deflection = \"0.5 m\"", "unloading = [[0, 0], [\"0.2 m\", \"50 kN\"], [\"0.2 m\", \"60 kN\"]]", "unloading = ", "fender.table.unloading[2]", "the deflection must rise"),
    case("rated_deflection = \"0.5 m\"", "unloading = [[0, 0], [\"0.2 m\", \"-50 kN\"]]", "unloading = ", "fender.table.unloading[1][1]", "must be"),
    case("rated_deflection = \"0.5 m\"", "unloading = [[0, \"1 N\"], [\"0.2 m\", \"50 kN\"]]", "unloading = ", "fender.table.unloading", "must begin with [0, 0]"),
    case("rated_deflection = \"0.5 m\"", "unloading = [[0, 0], [\"0.2 m\", \"50 kN\"]]\nunloading_law = false", "unloading_law = ", "fender.table.unloading_law", "does not go together with `unloading`"),
    case("hull = \"bulk carrier\"", "unloading = [[0, 0], [1, 1]]", "unloading = ", "fender.cone.unloading", "does not go together with `type`"),
    case("hull = \"bulk carrier\"", "returned_energy = 0.5\nunloading_law = true", "unloading_law = ", "fender.cone.unloading_law", "does not go together with `returned_energy`"),
    case("projection = \"1 m\"\nmaterial = \"rubber\"", "projection = \"1 m\"\nunloading = [[0, 0], [1, 1]]\nmaterial = \"rubber\"", "unloading = ", "fender.area.unloading", "is for fenders with a `stiffness` or a `curve`"),
    case("[[0, 0], [\"0.3 m\"", "[[0, \"1 kN\"], [\"0.3 m\"", "curve = ", "fender.table.curve", "must begin with [0, 0]"),
    case("[\"0.6 m\", \"500 kN\"]", "[\"0.2 m\", \"500 kN\"]", "curve = ", "fender.table.curve[2]", "the deflection must rise"),
    case("[\"0.6 m\", \"500 kN\"]", "[\"0.6 m\", \"-500 kN\"]", "curve = ", "fender.table.curve[2][1]", "must be"),
    case("curve = [[0, 0], [\"0.3 m\", \"300 kN\"], [\"0.6 m\", \"500 kN\"]]", "curve = [[0, 0]]", "curve = ", "fender.table.curve", "needs at least 2 rows"),
    case("projection = \"0.8 m\"\n", "", "[fender.table]", "fender.table.projection", "is missing"),
    case("projection = \"1 m\"\nmaterial", "projection = \"1 m\"\nheight = \"1 m\"\nmaterial", "height = \"1 m\"\nmaterial", "fender.area.height", "is for fenders of a `type`"),
    case("projection = \"1 m\"\nmaterial", "projection = \"1 m\"\nrated_deflection = 1\nmaterial", "rated_deflection = 1\n", "fender.area.rated_deflection", "is for fenders with a `stiffness` or a `curve`"),
    case("projection = \"1 m\"\nmaterial = \"rubber\"", "projection = \"1 m\"\nmaterial = \"facing\"", "material = \"facing\"\n\n[[pair]]", "fender.area.material", "the fender has no law of reaction, and its material"),
    case("projection = \"1 m\"\nmaterial", "projection = \"1 m\"\ncount = 2\nmaterial", "count = 2\nmaterial", "fender.area.count", "is for fenders of a `type`"),
    case("width = \"2 m\"\ntype", "width = 0\ntype", "width = 0", "fender.cone.width", "must be"),
    case("width = \"2 m\"\ntype", "width = nan\ntype", "width = nan", "fender.cone.width", "not a finite number"),
    case("position = [-20, 0]", "position = [-20]", "position = [-20]", "fender.cone.position", "is [forward, starboard], but has 1 numbers"),
    case("position = [-20, 0]\nfacing = \"-90 deg\"", "position = [-20, 1]", "[fender.cone]", "fender.cone.facing", "is missing"),
    case("ship = \"ship\"", "ship = \"quay\"", "ship = \"quay\"", "berthing.ship", "is fixed"),
    case("block_coefficient = 0.7", "block_coefficient = 1.2", "block_coefficient = ", "berthing.block_coefficient", "must be"),
    case("block_coefficient = 0.7", "block_coefficient = 0.7\nadded_mass = \"pianc\"", "added_mass = ", "berthing.added_mass", "pianc_2002"),
    case("block_coefficient = 0.7", "block_coefficient = 0.7\nadded_mass_factor = 0.9", "added_mass_factor = ", "berthing.added_mass_factor", "at least 1"),
    case("block_coefficient = 0.7", "block_coefficient = 0.7\nadded_mass = \"ufc\"\nadded_mass_factor = 1.8", "added_mass_factor = ", "berthing.added_mass_factor", "does not go together with `added_mass`"),
    case("beam = \"20 m\"\n", "", "[berthing]", "berthing.beam", "is missing"),
    case("[berthing]", "fender_files = [\"x\"]\n[berthing]", "fender_files", "pair.0.fender_files", "not a key of a pair"),
];

#[test]
fn every_mistake_names_key_and_line() {
    assert!(Scenario::parse(GOOD, "x.toml").is_ok(), "{:?}", Scenario::parse(GOOD, "x.toml"));
    for Case { part, mistake, at, key, fragment } in CASES {
        assert!(GOOD.contains(part), "{part} is not in the good scenario");
        let text = GOOD.replacen(part, mistake, 1);
        let error = Scenario::parse(&text, "x.toml").expect_err(fragment);
        let shown = error.to_string();
        let line = text[..text.find(at).expect(at)].lines().count() + 1;
        assert_eq!(error.key(), Some(*key), "{shown}");
        assert_eq!(error.line(), Some(line), "{mistake}: {shown}");
        assert!(shown.contains(fragment), "{shown}");
    }
}

#[test]
fn a_fender_file_is_read_with_the_scenario_and_its_mistakes_name_that_file() {
    let own = r#"
        [family.cone]
        [[family.cone.size]]
        designation = "ours"
        height = "1.1 m"
        reaction = "700 kN"
        source = "our maker's sheet"
        standing = "found"
    "#;
    let text = format!("fender_files = [\"own.toml\"]\n{GOOD}").replacen(
        "height = \"1 m\"\nrated_reaction = \"600 kN\"",
        "size = \"ours\"",
        1,
    );
    let read = |content: &'static str| {
        move |name: &str| {
            assert_eq!(name, "own.toml");
            Ok(content.to_owned())
        }
    };
    let leaked: &'static str = Box::leak(own.to_owned().into_boxed_str());
    let scenario = Scenario::parse_among(&text, "x.toml", &[], &mut read(leaked)).unwrap();
    let fender = &scenario.setup.fenders[0];
    assert_eq!(fender.projection_m, 1.1);
    assert!((fender.rated.unwrap().reaction_n - 700e3).abs() < 1e-6);
    assert!(fender.source.as_ref().unwrap().source.contains("our maker's sheet"));

    let broken = "[family.cone]\n[[family.cone.size]]\ndesignation = \"ours\"\n";
    let error = Scenario::parse_among(&text, "x.toml", &[], &mut read(broken)).unwrap_err();
    assert!(error.to_string().contains("own.toml"), "{error}");
    let mut none = |_: &str| Err("own.toml: no such file".to_owned());
    let error = Scenario::parse_among(&text, "x.toml", &[], &mut none).unwrap_err();
    assert_eq!((error.key(), error.line()), (Some("fender_files"), Some(1)), "{error}");
    assert!(Scenario::parse(&text, "x.toml").is_err(), "a scenario given as text reads no files");
}

#[test]
fn an_unknown_hull_pressure_stays_unknown() {
    let good = "size = \"3300x6500 50kPa\"";
    let own = "height = \"3.3 m\"\nrated_reaction = \"3 MN\"";
    let setup = Scenario::parse(&GOOD.replacen(good, own, 1), "x.toml").unwrap().setup;
    assert_eq!(setup.fenders[1].hull_pressure, HullPressure::Unknown);
    assert_eq!(setup.fenders[1].height_m, 3.3);

    let text = format!("fender_files = [\"own.toml\"]\n{GOOD}");
    let mut read = |_: &str| {
        let size = "[family.pneumatic]\n[[family.pneumatic.size]]\ndesignation = \"ours\"\n\
                    height = \"1 m\"\nreaction = \"182 kN\"\nsource = \"us\"\nstanding = \"found\"\n";
        Ok(format!("{size}hull_pressure = \"50 kPa\"\ninitial_pressure = \"50 kPa\"\n"))
    };
    let error = Scenario::parse_among(&text, "x.toml", &[], &mut read).unwrap_err();
    assert_eq!(error.line(), Some(9), "{error}");
    assert!(
        error.to_string().contains("needs a `hull_pressure` that is higher than this pressure"),
        "{error}"
    );
}

#[test]
fn fenders_become_the_expected_set_up() {
    let setup = Scenario::parse(GOOD, "x.toml").unwrap().setup;
    let [cone, pneumatic, table, area] = setup.fenders.as_slice() else { panic!("four fenders") };
    // −15 °C lies between 1.249 at −20 and 1.130 at −10.
    assert!((cone.factors.constant - 0.5 * (1.249 + 1.130)).abs() < 1e-12);
    assert_eq!(cone.projection_m, 1.0);
    assert_eq!(cone.height_m, cone.width_m);
    assert_eq!(cone.hull_pressure_limit_npm2, Some(200e3));
    assert!((cone.rated.unwrap().reaction_n - 600e3).abs() < 1e-6);
    assert_eq!(cone.factors.by_compression_time.last(), Some(&[1000.0, 1.0]));
    assert_eq!(cone.energy_by_angle.len(), 7);
    assert_eq!(cone.hull_pressure, HullPressure::OverFace);
    assert_eq!(pneumatic.projection_m, 3.3);
    // It has no panel: its diameter.
    assert_eq!(pneumatic.height_m, 3.3);
    let HullPressure::Inner { initial_npm2, rated_npm2, .. } = pneumatic.hull_pressure else {
        panic!("pneumatic")
    };
    assert_eq!((initial_npm2, rated_npm2), (50e3, 146e3));
    assert_eq!(pneumatic.stop.unwrap().from_m, 0.6 * 3.3);
    let FenderLaw::Curve(points) = &table.law else { panic!("a curve") };
    assert_eq!(points[2], [0.6, 500e3]);
    assert_eq!(table.factors.constant, 0.9);
    // Neither height nor limit of a panel: no pressure over an area that nobody gave.
    assert_eq!(table.hull_pressure, HullPressure::Unknown);
    assert_eq!(table.rated.unwrap().deflection_m, 0.5);
    // 50 times the mean stiffness of 500 kN over 0.6 m.
    let Some(Stop { from_m, stiffness_npm }) = table.stop else { panic!("a stop") };
    assert!((from_m, (stiffness_npm / (50.0 * 500e3 / 0.6) - 1.0).abs() < 1e-12) == (0.6, true));
    assert_eq!(area.law, FenderLaw::Area);
    assert_eq!(area.rated, None);
    assert_eq!(setup.berthing.unwrap().block_coefficient, 0.7);
}
