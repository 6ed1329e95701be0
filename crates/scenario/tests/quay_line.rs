//! Rows of fenders and bollards along a quay line of the chart: where they stand, how the side of the water is decided,
//! and every mistake.

use core::f64::consts::PI;

use fenderline_contact::{Vec2, vec2};
use fenderline_scenario::{Scenario, ScenarioError};

/// Land in the south with a quay line that has a corner, water in the north and east; a mole as a line with water on one
/// side, and another with water on both sides; two lines of one name.
const CHART: &str = r#"{ "type": "FeatureCollection", "features": [
{ "type": "Feature", "properties": { "OBJL": 71, "OBJNAM": "Land" }, "geometry": { "type": "Polygon", "coordinates":
  [[[-400, -300], [100, -300], [100, -200], [0, -100], [-400, -100], [-400, -300]]] } },
{ "type": "Feature", "properties": { "OBJL": 122, "OBJNAM": "Front" }, "geometry": { "type": "LineString", "coordinates":
  [[-300, -100], [0, -100], [100, -200]] } },
{ "type": "Feature", "properties": { "OBJL": 122, "OBJNAM": "Mole" }, "geometry": { "type": "LineString", "coordinates":
  [[-200, 100], [200, 100]] } },
{ "type": "Feature", "properties": { "OBJL": 122, "OBJNAM": "Breakwater" }, "geometry": { "type": "LineString", "coordinates":
  [[-200, 0], [-100, 0]] } },
{ "type": "Feature", "properties": { "OBJL": 122, "OBJNAM": "Twin" }, "geometry": { "type": "LineString", "coordinates":
  [[300, 0], [300, 50]] } },
{ "type": "Feature", "properties": { "OBJL": 122, "OBJNAM": "Twin" }, "geometry": { "type": "LineString", "coordinates":
  [[340, 0], [340, 50]] } },
{ "type": "Feature", "properties": { "OBJL": 42, "DRVAL1": 9, "DRVAL2": 12 }, "geometry": { "type": "Polygon", "coordinates":
  [[[-400, -100], [0, -100], [100, -200], [400, -200], [400, 100], [-400, 100], [-400, -100]]] } }
] }"#;

const HEAD: &str = r#"
[time]
step = "0.1 s"
duration = "60 s"
[chart]
files = ["port.geojson"]
coordinates = "metres"
solid = ["LNDARE", "SLCONS"]
solid_material = "rock"
[material.rock]
stiffness = "5 MN/m^2"
[material.facing]
stiffness = 0
shear_stiffness = "3 MN/m"
friction_static = 0.2
[body.barge]
mass = "2000 t"
gyradius = "15 m"
outline = [[-30, -6], [30, -6], [30, 6], [-30, 6]]
position = [50, 0]
"#;

const FENDER: &str = r#"
width = "2 m"
type = "cone"
height = "1.2 m"
material = "facing"
"#;

fn parse(row: &str) -> Result<Scenario, ScenarioError> {
    let text = format!("{HEAD}{row}");
    Scenario::parse_among(&text, "s.toml", &[], &mut |_| Ok(CHART.to_owned()))
}

fn fenders(line: &str, more: &str) -> Result<Scenario, ScenarioError> {
    parse(&format!("[fender_row.f]\non = \"shore\"\nquay_line = {{ {line} }}\n{more}{FENDER}"))
}

fn good(line: &str, more: &str) -> Scenario {
    fenders(line, more).unwrap_or_else(|error| panic!("{error}"))
}

fn is_near(one: Vec2, other: Vec2) -> bool {
    (one - other).length() < 1e-9
}

/// On the border of the land the fenders face away from the land, whichever way the line runs, and go round the corner.
#[test]
fn fenders_stand_along_the_line_and_face_the_water() {
    for (ends, order) in [("[-100, -250]", "[-100, -50]"), ("[-100, -50]", "[-100, -250]")]
        .map(|(from, to)| (format!("from = {from}, to = {to}"), from == "[-100, -250]"))
    {
        let scenario = good(&ends, "spacing = \"50 m\"");
        let mut places: Vec<Vec2> =
            scenario.setup.fenders.iter().map(|fender| fender.position_m).collect();
        if !order {
            places.reverse();
        }
        // 200 m have room for four fenders of 2 m, 25 m from the ends.
        let expected = [-225.0, -175.0, -125.0, -75.0].map(|east| vec2(-100.0, east));
        assert!(places.iter().zip(expected).all(|(a, b)| is_near(*a, b)), "{places:?}");
        assert_eq!(places.len(), 4);
        assert!(scenario.setup.fenders.iter().all(|fender| fender.facing_rad.abs() < 1e-9));
        assert_eq!(scenario.notices, []);
    }
    // The whole line: 300 m, then 141 m to the south-east, which faces the north-east.
    let whole = good("name = \"Front\"", "spacing = \"100 m\"\nfrom_corner = \"40 m\"");
    let facings: Vec<f64> = whole.setup.fenders.iter().map(|fender| fender.facing_rad).collect();
    assert_eq!(facings.len(), 5);
    assert!(facings[..3].iter().all(|rad| rad.abs() < 1e-9), "{facings:?}");
    assert!(facings[3..].iter().all(|rad| (rad - 0.25 * PI).abs() < 1e-9), "{facings:?}");
    let fourth = whole.setup.fenders[3].position_m;
    let along = 40.0 / core::f64::consts::SQRT_2;
    assert!(is_near(fourth, vec2(-100.0 - along, along)), "{fourth:?}");
}

/// A strip 4 m wide has its face 2 m from the line; the depth area lies to the south of the mole.
#[test]
fn at_a_strip_the_charted_depths_decide() {
    let mole = good("name = \"Mole\"", "spacing = \"50 m\"");
    assert_eq!(mole.setup.fenders.len(), 8);
    for fender in &mole.setup.fenders {
        assert!((fender.position_m.x - 98.0).abs() < 1e-9, "{fender:?}");
        assert!((fender.facing_rad.abs() - PI).abs() < 1e-9, "{fender:?}");
    }
    // With water on both sides the scenario decides.
    let left = good("name = \"Breakwater\", water = \"left\"", "spacing = \"50 m\"\nnumber = 2");
    assert!(is_near(left.setup.fenders[0].position_m, vec2(2.0, -175.0)));
    assert_eq!(left.setup.fenders[0].facing_rad, 0.0);
}

#[test]
fn bollards_stand_behind_the_face() {
    let row = "[bollard_row.b]\non = \"shore\"\nquay_line = { from = [-100, -250], to = [-100, -50] }\n\
               spacing = \"25 m\"\nbehind = \"1.5 m\"\nheight = \"4 m\"\nlines = 2\n";
    let scenario = parse(row).unwrap();
    let bollards = &scenario.setup.world.bollards;
    assert_eq!(bollards.len(), 9);
    assert_eq!((bollards[0].name.as_str(), bollards[8].name.as_str()), ("b_1", "b_9"));
    assert!(is_near(bollards[0].at_m, vec2(-101.5, -250.0)), "{bollards:?}");
    assert!(is_near(bollards[8].at_m, vec2(-101.5, -50.0)), "{bollards:?}");
    assert_eq!((bollards[0].above_water_m, bollards[0].most_lines), (4.0, 2));
    let quay = "[body.quay]\nfixed = true\noutline = [[-50, 0], [50, 0], [50, 9], [-50, 9]]\nposition = [50, 300]\n";
    let places = |keys: &str| -> Vec<Vec2> {
        let scenario = parse(&format!("{quay}[bollard_row.b]\non = \"quay\"\n{keys}")).unwrap();
        scenario.setup.world.bollards.iter().map(|bollard| bollard.at_m).collect()
    };
    let wall = places("wall = [[-50, 0], [50, 0]]\nspacing = 30\nnumber = 3\n");
    assert_eq!(wall, [vec2(-30.0, 1.0), vec2(0.0, 1.0), vec2(30.0, 1.0)]);
    let open = places("first = [-40, 2]\nlast = [40, 2]\nnumber = 3\n");
    assert_eq!(open, [vec2(-40.0, 2.0), vec2(0.0, 2.0), vec2(40.0, 2.0)]);
}

#[test]
fn each_mistake_names_row_key_and_line() {
    let spacing = "spacing = \"50 m\"";
    for (line, more, key, why) in [
        ("name = \"Frunt\"", spacing, "quay_line.name", "the chart has \"Front\""),
        ("name = \"Twin\"", spacing, "quay_line.name", "2 lines of this name"),
        ("name = \"Land\"", spacing, "quay_line.name", "not a line of the chart, but an area"),
        ("class = \"SLCONS\"", spacing, "quay_line.name", "is missing"),
        ("from = [0, 0]", spacing, "quay_line.to", "is missing"),
        (
            "from = [-100, -250], to = [-60, -50]",
            spacing,
            "quay_line.to",
            "no such line within 25 m",
        ),
        ("from = [-100, -250], to = [97, 0]", spacing, "quay_line.to", "lie on different lines"),
        (
            "from = [-100, -250], to = [-100, -249]",
            spacing,
            "quay_line",
            "1 m long, shorter than one fender of 2 m",
        ),
        ("from = [-100, -250], to = [-99, -250]", spacing, "quay_line.to", "has no length"),
        (
            "class = \"DEPARE\", from = [0, 0], to = [9, 9]",
            spacing,
            "quay_line.class",
            "not a class of quays",
        ),
        ("name = \"Breakwater\"", spacing, "quay_line", "the chart has water on both sides"),
        (
            "name = \"Front\", water = \"right\"",
            spacing,
            "quay_line",
            "has no face towards the water",
        ),
        (
            "name = \"Front\"",
            "spacing = \"50 m\"\nnumber = 20",
            "number",
            "longer than the line, which is 441.421 m",
        ),
        ("name = \"Front\"", "spacing = \"1 m\"", "width", "overlap"),
        ("name = \"Front\"", "", "spacing", "is missing"),
        (
            "name = \"Front\"",
            "spacing = 9\nfirst = [0, 0]",
            "first",
            "does not go together with `quay_line`",
        ),
        (
            "name = \"Front\"",
            "spacing = 9\nfrom_corner = \"441 m\"",
            "from_corner",
            "does not fit there",
        ),
    ] {
        let error = fenders(line, more).expect_err(line);
        let text = error.to_string();
        assert!(text.contains(&format!("fender_row.f.{key}")), "{line}: {text}");
        assert!(text.contains(why), "{line}: {text}");
        assert!(text.contains("s.toml:"), "{line}: {text}");
    }
    let on_barge = parse(&format!(
        "[fender_row.f]\non = \"barge\"\nquay_line = {{ name = \"Front\" }}\nspacing = 50{FENDER}"
    ));
    assert!(on_barge.unwrap_err().to_string().contains("stands on a fixed body"));
    for (keys, why) in [
        ("quay_line = { name = \"Front\" }", "`bollard_row.b.spacing` is missing"),
        ("quay_line = { name = \"Front\" }\nspacing = 9\nlast = [0, 0]", "does not go together"),
        ("first = [0, 0]\nspacing = 9\nnumber = 2", "`bollard_row.b.last` is missing"),
        ("first = [0, 0]\nlast = [9, 0]\nnumber = 2\nbehind = \"2 m\"", "does not go together"),
        ("spacing = 9", "`bollard_row.b.first` is missing"),
    ] {
        let error = parse(&format!("[bollard_row.b]\non = \"shore\"\n{keys}\n")).unwrap_err();
        assert!(error.to_string().contains(why), "{keys}: {error}");
    }
}

/// The harbour of `scenarios/harbours`: its berth on the chart's quay line stands where the quay body's row stood.
#[test]
fn the_berth_of_the_made_up_harbour() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../scenarios/harbours/inbound.toml");
    let scenario = Scenario::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"));
    let setup = &scenario.setup;
    let cones: Vec<Vec2> = setup
        .fenders
        .iter()
        .filter(|fender| fender.name.starts_with("cone_"))
        .map(|fender| fender.position_m)
        .collect();
    assert_eq!(cones.len(), 8);
    assert!(is_near(cones[0], vec2(500.0, 1374.0)) && is_near(cones[7], vec2(500.0, 1626.0)));
    let bollards = &setup.world.bollards;
    assert!(is_near(bollards[0].at_m, vec2(501.5, 1375.0)), "{bollards:?}");
    assert_eq!(bollards.len(), 11);
}
