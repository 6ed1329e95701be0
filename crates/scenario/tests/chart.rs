//! Charts from GeoJSON: what is read, the quay that is taken from it, and every mistake with file, feature and reason.

use std::time::{Duration, Instant};

use fenderline_contact::vec2;
use fenderline_scenario::{Place, Scenario, ScenarioError};
use fenderline_sim::chart::{ChartKind, ChartShape, MarkColour, MarkSide};

const HEAD: &str =
    "[time]\nstep = 1\nduration = 1\n[body.a]\nfixed = true\noutline = [[0, 0], [1, 0], [0, 1]]\n";
const METRES: &str = "[chart]\nfiles = [\"c.geojson\"]\ncoordinates = \"metres\"\n";

fn read(toml: &str, geojson: &str) -> Result<Scenario, ScenarioError> {
    Scenario::parse_among(toml, "s.toml", &[], &mut |_| Ok(geojson.to_owned()))
}

fn collection(features: &str) -> String {
    format!("{{ \"type\": \"FeatureCollection\", \"features\": [\n{features}\n] }}")
}

fn feature(properties: &str, geometry: &str, coordinates: &str) -> String {
    format!(
        "{{ \"type\": \"Feature\", \"properties\": {{ {properties} }}, \
         \"geometry\": {{ \"type\": \"{geometry}\", \"coordinates\": {coordinates} }} }}"
    )
}

/// The error of a chart in metres with one feature.
fn refused(properties: &str, geometry: &str, coordinates: &str) -> ScenarioError {
    let file = collection(&feature(properties, geometry, coordinates));
    read(&format!("{HEAD}{METRES}"), &file).expect_err("it has a mistake")
}

#[test]
fn every_kind_is_read() {
    let square = "[[[0, 0], [40, 0], [40, 9], [0, 9], [0, 0]]]";
    let line = "[[0, 0, 3.5], [9, 1, 3.5]]";
    let file = collection(
        &[
            feature("\"kind\": \"coast\", \"source\": { \"any\": [1] }", "Polygon", square),
            feature("\"kind\": \"coast\"", "LineString", line),
            feature("\"kind\": \"depth_area\", \"depth_m\": -0.5", "Polygon", square),
            feature("\"kind\": \"depth_contour\", \"depth_m\": 10", "LineString", line),
            feature(
                "\"kind\": \"quay\", \"name\": \"Quay\"",
                "MultiPolygon",
                &format!("[{square}, {square}]"),
            ),
            feature(
                "\"kind\": \"buoy\", \"colour\": \"red\", \"side\": \"port\", \"name\": \"2\"",
                "Point",
                "[7, 8]",
            ),
            feature(
                "\"kind\": \"beacon\", \"colour\": \"green\", \"side\": null",
                "MultiPoint",
                "[[1, 2], [3, 4]]",
            ),
            feature("\"kind\": \"leading_line\", \"name\": null", "LineString", line),
            feature("\"kind\": \"name\", \"name\": \"Basin\"", "Point", "[-1e3, 0]"),
            feature(
                "\"kind\": \"light\", \"colour\": \"red\", \"character\": \"Fl R 4s\", \"period_s\": 4, \
                 \"sector_deg\": [350, 20], \"range_m\": 9e3",
                "Point",
                "[1, 1]",
            ),
            feature("\"kind\": \"dredged_area\", \"depth_m\": 12, \"deepest_m\": 13", "Polygon", square),
            feature("\"kind\": \"bridge\", \"clearance_m\": 31.5", "LineString", line),
            feature("\"kind\": \"sounding\", \"depth_m\": 9.5", "Point", "[3, 3]"),
        ]
        .join(",\n"),
    );
    let chart = read(&format!("{HEAD}{METRES}"), &file).unwrap().setup.world.chart;
    assert_eq!(chart.origin, None);
    let kinds: Vec<&str> = chart.features.iter().map(|feature| feature.kind.word()).collect();
    assert_eq!(
        kinds,
        [
            "coast",
            "coast",
            "depth_area",
            "depth_contour",
            "quay",
            "quay",
            "buoy",
            "beacon",
            "beacon",
            "leading_line",
            "name",
            "light",
            "dredged_area",
            "bridge",
            "sounding"
        ]
    );
    let buoy = &chart.features[6];
    assert_eq!(buoy.kind, ChartKind::Buoy);
    // GeoJSON has east before north.
    assert_eq!(buoy.shape, ChartShape::Point(vec2(8.0, 7.0)));
    let mark = buoy.mark.unwrap();
    assert_eq!((mark.colour, mark.side), (MarkColour::Red, Some(MarkSide::Port)));
    assert_eq!(chart.features[3].shape, ChartShape::Line(vec![vec2(0.0, 0.0), vec2(1.0, 9.0)]));
    assert_eq!(chart.features[2].depth_m, Some(-0.5));
    let light = chart.features[11].light.as_ref().unwrap();
    assert_eq!((light.colour, light.character.as_str()), (MarkColour::Red, "Fl R 4s"));
    assert_eq!(light.sector_rad, Some([350.0, 20.0].map(f64::to_radians)));
    assert_eq!(chart.features[12].deepest_m, Some(13.0));
    assert_eq!(chart.features[13].clearance_m, Some(31.5));
    let quays = chart.classes.iter().find(|class| class.class == "quay").unwrap();
    assert_eq!((quays.read, quays.left_out()), (1, 0));
    let ChartShape::Area(rings) = &chart.features[0].shape else { panic!("it is an area") };
    assert_eq!(rings[0].len(), 4, "the last point repeats the first");
}

#[test]
fn a_quay_has_the_outline_of_the_chart_in_its_own_axes() {
    let square = "[[[10, 100], [40, 100], [40, 300], [10, 300], [10, 100]]]";
    let file = collection(&feature("\"kind\": \"quay\", \"name\": \"quay 3\"", "Polygon", square));
    let body = "[body.quay]\nfixed = true\nchart_outline = \"quay 3\"\nposition = [100, 10]\nheading = \"90 deg\"\n";
    let scenario = read(&format!("{HEAD}{METRES}{body}"), &file).unwrap();
    let quay = &scenario.setup.bodies[1];
    let (low, high) = quay.outline.bounds();
    // Forward is east, starboard is south: the quay is 30 m forward and 200 m to port of its origin.
    assert!(
        (low - vec2(0.0, -200.0)).length() < 1e-12 && (high - vec2(30.0, 0.0)).length() < 1e-12
    );
    assert_eq!(quay.outline.area_m2(), 6000.0);
    // On the earth it is where the chart has it.
    let pose = fenderline_contact::Pose::new(quay.position_m, quay.heading_rad);
    assert!((pose.apply(low) - vec2(300.0, 10.0)).length() < 1e-12);
}

#[test]
fn an_outline_that_the_chart_cannot_give_is_refused() {
    let square = "[[[10, 100], [40, 100], [40, 300], [10, 300], [10, 100]]]";
    let holed = "[[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]], [[2, 2], [3, 2], [3, 3], [2, 2]]]";
    let area = |name: &str, of: &str| {
        feature(&format!("\"kind\": \"quay\", \"name\": \"{name}\""), "Polygon", of)
    };
    let line = feature("\"kind\": \"quay\", \"name\": \"wall\"", "LineString", "[[0, 0], [9, 0]]");
    let all = [
        area("quay 3", square),
        area("twice", square),
        area("twice", square),
        area("ring", holed),
        line,
    ];
    let file = collection(&all.join(",\n"));
    for (body, fragments) in [
        (
            "fixed = true\nchart_outline = \"quay 4\"",
            ["no area named \"quay 4\"", "did you mean \"quay 3\""],
        ),
        (
            "fixed = true\nchart_outline = \"wall\"",
            ["\"wall\" is not an area", "a line or a point"],
        ),
        (
            "fixed = true\nchart_outline = \"twice\"",
            ["2 areas named \"twice\"", "each needs another name"],
        ),
        ("fixed = true\nchart_outline = \"ring\"", ["\"ring\" has a hole", "cannot have"]),
        (
            "mass = 1\ngyradius = 1\nchart_outline = \"quay 3\"",
            ["for a fixed body", "fixed = true"],
        ),
        (
            "fixed = true\nchart_outline = \"quay 3\"\noutline = [[0, 0], [1, 0], [0, 1]]",
            ["`body.q.chart_outline` and `outline` both", "keep only one"],
        ),
        (
            "fixed = true\nchart_outline = \"quay 3\"\noutlines = [{ height = 0, outline = [[0, 0], [1, 0], [0, 1]] }, \
             { height = 2, outline = [[0, 0], [1, 0], [0, 1]] }]",
            ["does not go together with `outlines`", "keep only one"],
        ),
    ] {
        let error = read(&format!("{HEAD}{METRES}[body.q]\n{body}\n"), &file).expect_err(body);
        assert_eq!(error.key(), Some("body.q.chart_outline"));
        let text = error.to_string();
        assert!(fragments.iter().all(|fragment| text.contains(fragment)), "{text}");
    }
    let alone = format!("{HEAD}[body.q]\nfixed = true\nchart_outline = \"quay 3\"\n");
    assert!(read(&alone, "").unwrap_err().to_string().contains("no [chart]"));
}

#[test]
fn longitude_and_latitude_need_a_projection_and_an_origin() {
    let file = collection("");
    for (keys, key) in [
        ("coordinates = \"longitude_latitude\"", "chart.projection"),
        (
            "coordinates = \"longitude_latitude\"\norigin = { latitude = 0, longitude = 0 }",
            "chart.projection",
        ),
        ("coordinates = \"longitude_latitude\"\nprojection = \"utm\"", "chart.origin"),
        ("coordinates = \"metres\"\nprojection = \"utm\"", "chart.projection"),
        ("coordinates = \"metres\"\norigin = { latitude = 0, longitude = 0 }", "chart.origin"),
        ("", "chart.coordinates"),
    ] {
        let toml = format!("{HEAD}[chart]\nfiles = [\"c.geojson\"]\n{keys}\n");
        let error = read(&toml, &file).expect_err(keys);
        assert_eq!(error.key(), Some(key), "{error}");
        assert!(error.help().is_some(), "{error}");
    }
    let toml = format!("{HEAD}[chart]\nfiles = []\ncoordinates = \"metres\"\n");
    assert!(read(&toml, &file).unwrap_err().to_string().contains("must name a GeoJSON file"));
    let toml = format!(
        "{HEAD}[chart]\nfiles = [\"c.geojson\"]\ncoordinates = \"longitude_latitude\"\nprojection = \"utm\"\n\
         origin = {{ latitude = 53.5, longitude = \"9.9 deg\" }}\n"
    );
    let error = read(&toml, &file).unwrap_err().to_string();
    assert!(error.contains("chart.origin.latitude") && error.contains("53.5 deg"), "{error}");
}

#[test]
fn each_mistake_of_a_feature_names_file_line_feature_and_reason() {
    let ring = "[[[0, 0], [9, 0], [9, 9], [0, 0]]]";
    let deep = format!("{}1{}", "[".repeat(500), "]".repeat(500));
    for (properties, geometry, coordinates, reason) in [
        (
            "\"kind\": \"quay\", \"name\": \"q\"",
            "Polygon",
            "[[[0, 0], [9, 0], [9, 9], [0, 9]]]",
            "(\"q\"): the feature's ring is not closed",
        ),
        (
            "\"kind\": \"quay\"",
            "Polygon",
            "[[[0, 0], [9, 9], [9, 0], [0, 9], [0, 0]]]",
            "crosses or touches itself",
        ),
        ("\"kind\": \"quay\"", "Polygon", "[[[0, 0], [9, 9], [0, 0]]]", "three corners or more"),
        ("\"kind\": \"quay\"", "Polygon", "[[[0, 0], [9, 9], [18, 18], [0, 0]]]", "not an area"),
        ("\"kind\": \"quay\"", "Polygon", "[[0, 0], [9, 9], [9, 0], [0, 0]]", "nested"),
        ("\"kind\": \"quay\"", "Polygon", "[]", "no ring"),
        ("\"kind\": \"quay\"", "Polygon", "[[]]", "a list of positions"),
        ("\"kind\": \"quay\"", "LineString", "[[0, 0]]", "two points or more"),
        ("\"kind\": \"quay\"", "Point", "[0, 0]", "cannot be a point"),
        ("\"kind\": \"quay\"", "GeometryCollection", "[]", "GeometryCollection cannot be read"),
        ("\"kind\": \"quay\"", "Circle", "[0, 0]", "\"Circle\", which is not a geometry"),
        ("\"kind\": \"quay\"", "Polygon", "[[[NaN, 0]]]", "not GeoJSON"),
        ("\"kind\": \"quay\"", "Polygon", "[[[1e999, 0]]]", "out of range"),
        ("\"kind\": \"quay\"", "Polygon", "[[[1, \"2\"]]]", "expected a list of coordinates"),
        ("\"kind\": \"quay\"", "Polygon", "[[[1]]]", "a position must be a list of two numbers"),
        (
            "\"kind\": \"quay\"",
            "LineString",
            "[[1, 2], 3]",
            "a position must be a list of two numbers",
        ),
        (
            "\"kind\": \"quay\"",
            "LineString",
            "[[0, 0], [0, 3e5]]",
            "more than 200 km from the scenario's origin",
        ),
        ("\"kind\": \"quay\"", "Polygon", &deep, "nested too deep"),
        ("\"kind\": \"qay\"", "Polygon", ring, "did you mean \"quay\""),
        ("\"name\": \"a\"", "Polygon", ring, "no property `kind`"),
        ("\"kind\": 3", "Polygon", ring, "expected a string"),
        ("\"kind\": \"depth_area\"", "Polygon", ring, "needs `depth_m`"),
        ("\"kind\": \"depth_area\", \"depth_m\": \"5 m\"", "Polygon", ring, "expected f64"),
        ("\"kind\": \"depth_area\", \"depth_m\": 1e5", "Polygon", ring, "between -30 and 12000"),
        ("\"kind\": \"coast\", \"depth_m\": 5", "Polygon", ring, "a coast has no `depth_m`"),
        ("\"kind\": \"buoy\"", "Point", "[0, 0]", "needs `colour`"),
        ("\"kind\": \"buoy\", \"colour\": \"blue\"", "Point", "[0, 0]", "not one of red, green"),
        (
            "\"kind\": \"buoy\", \"colour\": \"red\", \"side\": \"left\"",
            "Point",
            "[0, 0]",
            "port, starboard",
        ),
        ("\"kind\": \"coast\", \"colour\": \"red\"", "Polygon", ring, "a coast has no `colour`"),
        ("\"kind\": \"light\"", "Point", "[0, 0]", "a light needs `colour`"),
        ("\"kind\": \"sounding\"", "Point", "[0, 0]", "a sounding needs `depth_m`"),
        ("\"kind\": \"coast\", \"period_s\": 3", "Polygon", ring, "a coast has no `period_s`"),
        (
            "\"kind\": \"depth_area\", \"depth_m\": 5, \"deepest_m\": 4",
            "Polygon",
            ring,
            "its `deepest_m` of 4 is less than its `depth_m` of 5",
        ),
        ("\"kind\": \"name\"", "Point", "[0, 0]", "no property `name`"),
        ("\"kind\": \"name\", \"name\": \"a\\u0007\"", "Point", "[0, 0]", "control character"),
    ] {
        let error = refused(properties, geometry, coordinates);
        let text = error.to_string();
        assert!(text.contains(reason), "{text}\n{reason}");
        // Where JSON ends early, no feature is known.
        assert!(text.contains("feature 1") || text.contains("not GeoJSON"), "{text}");
        let Place::File { name, line, .. } = error.place() else { panic!("{text}") };
        assert_eq!((name.as_str(), *line), ("c.geojson", 2), "{text}");
    }
}

#[test]
fn each_mistake_of_a_file_is_answered() {
    for (file, reason) in [
        ("", "not GeoJSON: EOF"),
        ("{", "not GeoJSON: EOF"),
        ("[1, 2]", "not GeoJSON"),
        ("{ \"type\": \"Feature\" }", "\"Feature\", not a FeatureCollection"),
        ("{ \"type\": \"FeatureCollection\" }", "no `features`"),
        ("{ \"type\": \"FeatureCollection\", \"features\": [3] }", "feature 1: invalid type"),
        (
            "{ \"type\": \"FeatureCollection\", \"features\": [{ \"type\": \"Point\" }] }",
            "not \"Feature\"",
        ),
        (
            "{ \"type\": \"FeatureCollection\", \"features\": [{ \"type\": \"Feature\", \"geometry\": null, \
             \"properties\": { \"kind\": \"quay\" } }] }",
            "no `geometry`",
        ),
    ] {
        let error = read(&format!("{HEAD}{METRES}"), file).expect_err(file).to_string();
        assert!(error.contains(reason) && error.contains("c.geojson"), "{error}");
    }
    let of_gauss = "{ \"type\": \"FeatureCollection\", \"features\": [], \"crs\": { \"type\": \"name\", \
                    \"properties\": { \"name\": \"EPSG:31467\" } } }";
    let degrees = "coordinates = \"longitude_latitude\"\nprojection = \"utm\"\norigin = { latitude = 0, longitude = 0 }";
    let toml = format!("{HEAD}[chart]\nfiles = [\"c.geojson\"]\n{degrees}\n");
    let error = read(&toml, of_gauss).unwrap_err().to_string();
    assert!(error.contains("31467") && error.contains("EPSG:4326"), "{error}");
    assert!(read(&toml, &of_gauss.replace("EPSG:31467", "urn:ogc:def:crs:OGC:1.3:CRS84")).is_ok());
    // Latitude before longitude.
    let swapped = collection(&feature("\"kind\": \"coast\"", "LineString", "[[54, 8], [54.1, 8]]"));
    let error = read(&toml, &swapped).unwrap_err().to_string();
    assert!(error.contains("longitude stands before latitude"), "{error}");
    let beyond = collection(&feature("\"kind\": \"coast\"", "LineString", "[[8, 254], [8, 0]]"));
    let error = read(&toml, &beyond).unwrap_err().to_string();
    assert!(error.contains("[8, 254] is not a longitude and a latitude"), "{error}");
}

/// Two million points, sixty thousand features, and a ring of thousands of corners that nearly all meet: refused within a
/// second each in the profile of the tests, in which the engine is optimised.
#[test]
fn a_chart_that_is_too_large_is_refused_in_bounded_time() {
    let ring = |corners: usize| {
        let corner = |i: usize| format!("[{}, {}]", i % 2 * 9, i / 2 % 1000);
        let corners: Vec<String> = (0..corners).chain([0]).map(corner).collect();
        feature("\"kind\": \"coast\"", "Polygon", &format!("[[{}]]", corners.join(",")))
    };
    let buoy = feature("\"kind\": \"buoy\", \"colour\": \"red\"", "Point", "[0, 0]");
    let line = format!("[{}]", vec!["[1,2]"; 600_000].join(","));
    for (file, reason) in [
        (collection(&ring(2_000_000)), "larger than 16 MiB"),
        (
            collection(&feature("\"kind\": \"coast\"", "LineString", &line)),
            "more than 500000 points",
        ),
        (
            collection(&vec![buoy.as_str(); 60_000].join(",\n")),
            "60000 features, but may have at most 50000",
        ),
        (collection(&ring(9_000)), "crosses or touches itself"),
    ] {
        let begun = Instant::now();
        let error = read(&format!("{HEAD}{METRES}"), &file).unwrap_err().to_string();
        let took = begun.elapsed();
        println!("{reason}: {took:?}");
        assert!(error.contains(reason), "{error}");
        // A wide margin: other programs run on the machine.
        assert!(took < Duration::from_secs(20), "{reason}: {took:?}");
    }
}
