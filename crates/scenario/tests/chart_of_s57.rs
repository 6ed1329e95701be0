//! Charts of S-57 as ogr2ogr and pyogrio write them: classes by layer name or number, attributes as numbers, texts and
//! lists, soundings with their depths, and what is left out.

use fenderline_contact::vec2;
use fenderline_scenario::{Scenario, ScenarioError};
use fenderline_sim::chart::{
    Chart, ChartKind, ChartShape, MarkColour, MarkMeaning, MarkShape, MarkSide,
};

const TOML: &str = "[time]\nstep = 1\nduration = 1\n[body.a]\nfixed = true\noutline = [[0, 0], [1, 0], [0, 1]]\n\
                    [chart]\nfiles = [\"c.geojson\"]\ncoordinates = \"metres\"\n";

fn read(file: &str) -> Result<Scenario, ScenarioError> {
    Scenario::parse_among(TOML, "s.toml", &[], &mut |_| Ok(file.to_owned()))
}

/// A file as GDAL writes it: the layer's name, and one feature in a line.
fn layer(name: &str, features: &[String]) -> String {
    format!(
        "{{\n\"type\": \"FeatureCollection\",\n\"name\": \"{name}\",\n\"crs\": {{ \"type\": \"name\", \"properties\": \
         {{ \"name\": \"urn:ogc:def:crs:OGC:1.3:CRS84\" }} }},\n\"features\": [\n{}\n]\n}}\n",
        features.join(",\n")
    )
}

fn feature(properties: &str, geometry: &str) -> String {
    format!(
        "{{ \"type\": \"Feature\", \"properties\": {{ {properties} }}, \"geometry\": {geometry} }}"
    )
}

fn of(geometry: &str, coordinates: &str) -> String {
    format!("{{ \"type\": \"{geometry}\", \"coordinates\": {coordinates} }}")
}

fn chart(file: &str) -> Chart {
    read(file).unwrap().setup.world.chart
}

const SQUARE: &str = "[[0, 0], [40, 0], [40, 90], [0, 90], [0, 0]]";
const HOLE: &str = "[[10, 10], [20, 10], [20, 20], [10, 20], [10, 10]]";

#[test]
fn a_layer_by_its_name_and_a_feature_by_its_number_are_the_same() {
    let area = of("MultiPolygon", &format!("[[{SQUARE}, {HOLE}], [{SQUARE}]]"));
    let by_name = chart(&layer("DEPARE", &[feature("\"DRVAL1\": 5.4, \"DRVAL2\": 9.1", &area)]));
    let by_number = chart(&layer(
        "everything",
        &[feature("\"OBJL\": 42, \"DRVAL1\": \"5.4\", \"DRVAL2\": [9.1]", &area)],
    ));
    assert_eq!(by_name, by_number);
    assert_eq!(by_name.features.len(), 2, "one for each part");
    let first = &by_name.features[0];
    assert_eq!(
        (first.kind, first.depth_m, first.deepest_m),
        (ChartKind::DepthArea, Some(5.4), Some(9.1))
    );
    let ChartShape::Area(rings) = &first.shape else { panic!("it is an area") };
    assert_eq!(rings.len(), 2, "a ring and a hole");
    assert_eq!(by_name.read_in_words().as_deref(), Some("1 DEPARE"));
    assert_eq!(by_name.left_out_in_words(), None);
}

#[test]
fn soundings_have_their_depths_in_the_third_coordinate_or_beside_it() {
    let file = layer(
        "SOUNDG",
        &[
            feature("\"OBJL\": 129", &of("MultiPoint", "[[1, 2, 7.4], [3, 4, -0.3]]")),
            feature("\"OBJL\": 129, \"DEPTH\": 12.5", &of("Point", "[5, 6]")),
            feature("\"OBJL\": 129", &of("Point", "[5, 6]")),
        ],
    );
    let chart = chart(&file);
    let depths: Vec<Option<f64>> = chart.features.iter().map(|feature| feature.depth_m).collect();
    assert_eq!(depths, [Some(7.4), Some(-0.3), Some(12.5)]);
    assert_eq!(chart.features[1].shape, ChartShape::Point(vec2(4.0, 3.0)));
    assert_eq!(chart.left_out_in_words().as_deref(), Some("1 SOUNDG (no depth)"));
}

#[test]
fn marks_and_lights_have_their_colours_sides_and_sectors() {
    let point = of("Point", "[0, 0]");
    let buoys = chart(&layer(
        "BOYLAT",
        &[
            feature("\"CATLAM\": 1, \"COLOUR\": [ \"4\" ], \"OBJNAM\": \"Buoy 3\"", &point),
            feature("\"CATLAM\": 2, \"COLOUR\": \"3,1\", \"OBJNAM\": null, \"BOYSHP\": 4", &point),
        ],
    ));
    let mark = |index: usize| buoys.features[index].mark.unwrap();
    assert_eq!((mark(0).colour, mark(0).side), (MarkColour::Green, Some(MarkSide::Port)));
    assert_eq!((mark(1).colour, mark(1).side), (MarkColour::Red, Some(MarkSide::Starboard)));
    assert_eq!(buoys.features[0].name, "Buoy 3");
    assert_eq!((mark(0).shape, mark(1).shape), (None, Some(MarkShape::Pillar)));
    assert_eq!(mark(0).meaning, MarkMeaning::Lateral);
    let of_mark = |class, properties: &str| {
        chart(&layer(class, &[feature(properties, &point)])).features[0].mark.unwrap()
    };
    let cardinal = of_mark("BOYCAR", "\"COLOUR\": [2, 6], \"CATCAM\": 3, \"BOYSHP\": 5");
    assert_eq!((cardinal.colour, cardinal.meaning), (MarkColour::Black, MarkMeaning::South));
    assert_eq!(cardinal.shape, Some(MarkShape::Spar));
    let safe = of_mark("BOYSAW", "\"COLOUR\": [3, 1], \"BOYSHP\": 3");
    assert_eq!((safe.meaning, safe.shape), (MarkMeaning::SafeWater, Some(MarkShape::Ball)));
    let tower = of_mark("BCNISD", "\"BCNSHP\": 3");
    assert_eq!((tower.meaning, tower.shape), (MarkMeaning::IsolatedDanger, Some(MarkShape::Tower)));
    assert_eq!(of_mark("BOYSPP", "\"COLOUR\": 6").meaning, MarkMeaning::Special);
    // A mooring buoy is known by its mark; a dolphin has none.
    let mooring = of_mark("MORFAC", "\"CATMOR\": 7, \"COLOUR\": [6]");
    assert_eq!((mooring.colour, mooring.meaning), (MarkColour::Yellow, MarkMeaning::Other));
    let dolphin = chart(&layer("MORFAC", &[feature("\"CATMOR\": 1", &point)]));
    assert_eq!(dolphin.features[0].mark, None);

    let lights = chart(&layer(
        "LIGHTS",
        &[
            feature(
                "\"COLOUR\": [ \"3\" ], \"LITCHR\": 2, \"SIGGRP\": \"(2)\", \"SIGPER\": 6.0, \"SECTR1\": 170.0, \
                 \"SECTR2\": 200.0, \"VALNMR\": 5.0",
                &point,
            ),
            feature(
                "\"COLOUR\": [ \"1\" ], \"LITCHR\": 7, \"SIGGRP\": \"(1)\", \"SIGPER\": 2.5",
                &point,
            ),
        ],
    ));
    let light = |index: usize| lights.features[index].light.as_ref().unwrap();
    assert_eq!((light(0).colour, light(0).character.as_str()), (MarkColour::Red, "Fl(2) R 6s"));
    // A ship that sees the light on 170° is to the north of it.
    assert_eq!(light(0).sector_rad, Some([350.0, 20.0].map(f64::to_radians)));
    assert_eq!(light(0).range_m, Some(5.0 * 1852.0));
    assert_eq!((light(1).character.as_str(), light(1).sector_rad), ("Iso W 2.5s", None));
}

#[test]
fn bridges_cables_and_dangers_have_their_numbers() {
    let line = of("LineString", "[[0, 0], [9, 1]]");
    let of_line =
        |class: &str, properties: &str| chart(&layer(class, &[feature(properties, &line)]));
    let bridge = of_line("BRIDGE", "\"VERCLR\": 23.1, \"VERCCL\": null");
    assert_eq!(bridge.features[0].clearance_m, Some(23.1));
    let cable = of_line("CBLOHD", "\"VERCLR\": 30.0, \"VERCSA\": 26.5");
    assert_eq!(cable.features[0].clearance_m, Some(26.5), "the safe clearance counts");
    let wreck = chart(&layer("WRECKS", &[feature("\"VALSOU\": 6.2", &of("Point", "[0, 0]"))]));
    assert_eq!((wreck.features[0].kind, wreck.features[0].depth_m), (ChartKind::Wreck, Some(6.2)));
}

#[test]
fn what_is_left_out_is_counted_with_its_reason() {
    let square = of("Polygon", &format!("[{SQUARE}]"));
    let crossed = of("Polygon", "[[[0, 0], [40, 90], [40, 0], [0, 90], [0, 0]]]");
    let file = layer(
        "DEPARE",
        &[
            feature("\"DRVAL1\": 1.8, \"DRVAL2\": 3.6", &square),
            feature("\"DRVAL1\": null", &square),
            feature("\"DRVAL1\": 9.1, \"DRVAL2\": 5.4", &square),
            feature("\"DRVAL1\": 9.1", "null"),
            feature("\"DRVAL1\": 9.1", &of("Point", "[0, 0]")),
            feature("\"DRVAL1\": 9.1", &crossed),
            feature("\"OBJL\": 119", &square),
            feature("\"OBJL\": 302, \"CATCOV\": 2", &square),
        ],
    );
    let scenario = read(&file).unwrap();
    let chart = &scenario.setup.world.chart;
    assert_eq!(chart.features.len(), 1);
    let left_out = chart.left_out_in_words().unwrap();
    for words in [
        "1 DEPARE (no DRVAL1)",
        "1 DEPARE (DRVAL2 is less than DRVAL1)",
        "1 DEPARE (no geometry)",
        "1 DEPARE (its class does not allow its geometry)",
        "1 DEPARE (its ring crosses itself)",
        "1 OBJL 119 (the class is not read)",
        "1 M_COVR (CATCOV 2: no coverage)",
    ] {
        assert!(left_out.contains(words), "{left_out}\n{words}");
    }
    // A hole in the depths is more than a class that is not read: the file and its line are named.
    let notice = &scenario.notices[0];
    let text = notice.to_string();
    assert!(text.contains("feature 6 (DEPARE) is left out: its ring crosses itself"), "{text}");
    assert!(text.contains("c.geojson"), "{text}");
}

#[test]
fn a_feature_that_is_neither_of_s57_nor_has_a_kind_is_refused() {
    let file = layer("quays of the port", &[feature("\"DRVAL1\": 3", &of("Point", "[0, 0]"))]);
    let text = read(&file).unwrap_err().to_string();
    assert!(text.contains("no property `kind`"), "{text}");
    assert!(text.contains("S-57"), "{text}");
}
