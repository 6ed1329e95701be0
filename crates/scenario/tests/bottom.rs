//! The bottom by place from surveys and charts: what is read, known depths, and every mistake with file, line and key.

use fenderline_contact::vec2;
use fenderline_scenario::{Place, Scenario, ScenarioError};
use fenderline_sim::environment::{BankMethod, DepthField};
use fenderline_sim::{Bottom, Outside, Simulation};

const HEAD: &str =
    "[time]\nstep = 1\nduration = 1\n[body.a]\nfixed = true\noutline = [[0, 0], [1, 0], [0, 1]]\n";
const SHIP: &str = "[body.ship]\nvessel = \"bulk-carrier\"\n";
const METRES: &str = "[chart]\nfiles = [\"c.geojson\"]\ncoordinates = \"metres\"\n";

/// A scenario with this table of the bottom, and files by their names.
fn read(toml: &str, files: &[(&str, &str)]) -> Result<Scenario, ScenarioError> {
    Scenario::parse_among(toml, "s.toml", &[], &mut |name| {
        let found = files.iter().find(|(file, _)| *file == name);
        found.map(|(_, text)| (*text).to_owned()).ok_or_else(|| format!("{name}: no such file"))
    })
}

fn bottom(keys: &str, files: &[(&str, &str)]) -> Result<Bottom, ScenarioError> {
    let chart = if files.iter().any(|(name, _)| *name == "c.geojson") { METRES } else { "" };
    let toml = format!("{HEAD}{chart}[environment.bottom]\n{keys}\n");
    Ok(read(&toml, files)?.setup.world.environment.bottom.expect("a bottom"))
}

fn survey(text: &str) -> Result<Bottom, ScenarioError> {
    bottom("survey = [\"a.asc\"]", &[("a.asc", text)])
}

const GRID: &str = "ncols 3\nnrows 2\nxllcorner -15\nyllcorner 85\ncellsize 10\nNODATA_value -9999\n\
                    7 8 9\n4 5 -9999\n";

#[test]
fn a_grid_is_the_field_itself_with_its_rows_from_the_north() {
    let bottom = survey(GRID).unwrap();
    let field = &bottom.field;
    assert_eq!((field.cell_m(), field.nodes()), (10.0, [2, 3]));
    // The centre of the cell in the south-west is 10 m west and 90 m north.
    assert_eq!(field.corners_m(), [vec2(90.0, -10.0), vec2(100.0, 10.0)]);
    for (north, east, depth_m) in [
        (90.0, -10.0, 4.0),
        (90.0, 0.0, 5.0),
        (100.0, -10.0, 7.0),
        (100.0, 10.0, 9.0),
        (95.0, -5.0, 6.0),
    ] {
        assert_eq!(field.depth_m(vec2(north, east)), Some(depth_m), "{north} {east}");
    }
    assert_eq!(field.depth_m(vec2(90.0, 10.0)), None, "a hole");
    assert_eq!(bottom.outside, Outside::Error);
}

#[test]
fn outside_may_be_a_depth() {
    let bottom = bottom("survey = [\"a.asc\"]\noutside = \"15 m\"", &[("a.asc", GRID)]).unwrap();
    assert_eq!(bottom.depth_m(vec2(0.0, 0.0)), Some(15.0));
    assert_eq!(bottom.depth_m(vec2(90.0, 0.0)), Some(5.0));
}

/// A grid of 500 m around the origin, with cells of 10 m: 12 m deep, and 5 m from 50 m east of the origin on.
fn step_grid() -> String {
    let row: Vec<&str> = (0..50).map(|column| if column < 30 { "12" } else { "5" }).collect();
    let row = row.join(" ") + "\n";
    let head =
        "ncols 50\nnrows 50\nxllcorner -250\nyllcorner -250\ncellsize 10\nNODATA_value -9999\n";
    head.to_owned() + &row.repeat(50)
}

#[test]
fn banks_of_the_bottom_act_by_the_chosen_method_and_are_told() {
    let grid = step_grid();
    let ship = "[body.ship]\nvessel = \"bulk-carrier\"\nposition = [0, 0]\nvelocity = { surge = \"6 kn\" }\n";
    let with = |keys: &str, more: &str| {
        let toml = format!(
            "{HEAD}position = [240, -240]\n{ship}{more}[environment.bottom]\nsurvey = [\"a.asc\"]\noutside = \"12 m\"\n{keys}\n"
        );
        read(&toml, &[("a.asc", &grid)]).unwrap_or_else(|error| panic!("{error}"))
    };
    let banks = |scenario: Scenario| {
        let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
        simulation.step().expect("a good step").vessel_forces[0].banks
    };
    let told = |scenario: &Scenario| -> Vec<String> {
        let all = scenario.notices.iter().map(ToString::to_string);
        all.filter(|notice| notice.contains("bank")).collect()
    };
    let plain = with("", "");
    assert_eq!(
        plain.setup.world.environment.bottom.as_ref().unwrap().banks,
        Some(BankMethod::Norrbin)
    );
    let [notice] = &told(&plain)[..] else { panic!("{:?}", told(&plain)) };
    assert!(notice.contains("`environment.bottom`") && notice.contains("UNVALIDATED"), "{notice}");
    let words = plain.setup.world.environment.bottom.as_ref().unwrap().in_words();
    assert!(words.ends_with("banks by Norrbin's formulas (unvalidated)"), "{words}");
    let norrbin = banks(plain);
    assert!(norrbin.sway_n > 0.0 && norrbin.yaw_nm < 0.0, "{norrbin:?}");
    let by_image = with("banks = \"image\"", "");
    let [notice] = &told(&by_image)[..] else { panic!("{:?}", told(&by_image)) };
    assert!(
        notice.contains("`environment.bottom`") && notice.contains("images of the images"),
        "{notice}"
    );
    let image = banks(by_image);
    assert!(image.sway_n > 0.0 && image.sway_n != norrbin.sway_n, "{image:?}");
    let none = with("banks = \"none\"", "");
    assert!(told(&none).is_empty() && none.setup.world.flow.hulls.is_empty());
    assert!(
        none.setup
            .world
            .environment
            .bottom
            .as_ref()
            .unwrap()
            .in_words()
            .ends_with("no force of banks")
    );
    assert_eq!(banks(none).sway_n, 0.0);
    let twice = with("", "[environment]\nbank = [{ from = [-500, 50], to = [500, 50] }]\n");
    assert!(
        told(&twice).iter().any(|notice| notice.contains("counted twice")),
        "{:?}",
        told(&twice)
    );
    let error = read(
        &format!("{HEAD}[environment.bottom]\nsurvey = [\"a.asc\"]\nbanks = \"lataire\"\n"),
        &[("a.asc", GRID)],
    );
    let error = error.unwrap_err().to_string();
    assert!(error.contains("s.toml:9:") && error.contains("environment.bottom.banks"), "{error}");
}

#[test]
fn waves_over_a_bottom_have_one_depth_and_are_told() {
    let told = |waves: &str, grid: &str| {
        let toml =
            format!("{HEAD}[environment]\n{waves}\n[environment.bottom]\nsurvey = [\"a.asc\"]\n");
        let scenario = read(&toml, &[("a.asc", grid)]).unwrap_or_else(|error| panic!("{error}"));
        let all = scenario.notices.into_iter().map(|notice| notice.to_string());
        all.filter(|notice| notice.contains("median depth")).collect::<Vec<_>>()
    };
    let waves = "waves = { height = \"1 m\", period = \"8 s\", from = 0 }";
    // 4, 5, 7, 8 and 9 m: the median is 7 m.
    let [notice] = &told(waves, GRID)[..] else { panic!("one notice") };
    assert!(notice.contains("s.toml:8:1: `environment.waves`"), "{notice}");
    assert!(notice.contains("7.0 m below datum"), "{notice}");
    assert!(told("", GRID).is_empty());
    // Where nothing is wet at datum, the tide decides.
    let dry = GRID.replace("7 8 9", "-1 -3 -1").replace("4 5", "-3 -2");
    let keys = format!("{waves}\ntide = {{ level = \"2.5 m\" }}");
    let toml = format!(
        "{HEAD}[environment]\n{keys}\n[environment.bottom]\nsurvey = [\"a.asc\"]\nsurvey_values = \"depths\"\n"
    );
    let scenario = read(&toml, &[("a.asc", &dry)]).unwrap_or_else(|error| panic!("{error}"));
    let found = scenario.notices.iter().any(|notice| notice.message.contains("-1.0 m below datum"));
    assert!(found, "{:?}", scenario.notices);
    let toml = toml.replace("2.5 m", "0.5 m").replace(waves, "");
    let error = read(&toml, &[("a.asc", &dry)]).expect_err("no water anywhere").to_string();
    assert!(error.contains("the bottom is above the water throughout the run"), "{error}");
}

#[test]
fn heights_are_recognised_and_told() {
    let heights = GRID.replace("7 8 9", "-7 -8 -9").replace("4 5", "1 -5");
    let toml = format!("{HEAD}[environment.bottom]\nsurvey = [\"a.asc\"]\n");
    let scenario = read(&toml, &[("a.asc", &heights)]).unwrap();
    let field = &scenario.setup.world.environment.bottom.unwrap().field;
    assert_eq!(field.depth_m(vec2(100.0, 0.0)), Some(8.0));
    assert_eq!(field.depth_m(vec2(90.0, -10.0)), Some(-1.0));
    let notice = scenario.notices.iter().find(|notice| notice.key == "environment.bottom.survey");
    assert!(notice.unwrap().message.contains("taken as heights above datum"), "{notice:?}");
    // What the scenario says counts, without a word.
    let toml = format!("{toml}survey_values = \"depths\"\n");
    let scenario = read(&toml, &[("a.asc", &heights)]).unwrap();
    let is_told =
        scenario.notices.iter().any(|notice| notice.key.starts_with("environment.bottom"));
    assert!(!is_told, "{:?}", scenario.notices);
    assert_eq!(scenario.setup.world.environment.bottom.unwrap().field.range_m(), [-9.0, 1.0]);
}

/// Points of a plane, 5 m apart, as rows.
fn rows(line: impl Fn(f64, f64, f64) -> String) -> String {
    let mut text = String::new();
    for i in 0..20 {
        for j in 0..30 {
            let (east, north) = (5.0 * f64::from(i), 5.0 * f64::from(j));
            text += &line(east, north, 12.0 + 0.02 * north - 0.01 * east);
        }
    }
    text
}

fn is_the_plane(field: &DepthField) {
    for (north, east) in [(3.0, 4.0), (77.7, 60.1), (140.0, 90.0)] {
        let depth_m = field.depth_m(vec2(north, east)).expect("data");
        assert!((depth_m - (12.0 + 0.02 * north - 0.01 * east)).abs() < 1e-5, "{depth_m}");
    }
    assert_eq!(field.depth_m(vec2(200.0, 50.0)), None);
}

#[test]
fn rows_of_points_are_read_however_they_are_separated() {
    let xyz = |text: String| bottom("survey = [\"a.xyz\"]", &[("a.xyz", &text)]).unwrap();
    is_the_plane(&xyz(rows(|x, y, z| format!("{x} {y}\t{z}\n"))).field);
    is_the_plane(&xyz(format!("# m\nx;y;z\n{}", rows(|x, y, z| format!("{x};{y};{z}\r\n")))).field);
    let named = rows(|x, y, z| format!("{y},{x},{z}\n"));
    is_the_plane(&xyz(format!("northing,easting,depth\n{named}")).field);
}

#[test]
fn a_gap_between_points_is_a_hole() {
    let all = rows(|x, y, z| match (30.0..=70.0).contains(&x) && (40.0..=110.0).contains(&y) {
        true => String::new(),
        false => format!("{x} {y} {z}\n"),
    });
    let field = bottom("survey = [\"a.xyz\"]", &[("a.xyz", &all)]).unwrap().field;
    assert_eq!(field.depth_m(vec2(75.0, 50.0)), None, "in the gap");
    assert!(field.depth_m(vec2(75.0, 10.0)).is_some(), "beside the gap");
}

#[test]
fn longitude_and_latitude_and_utm_come_to_the_same_place() {
    // About the origin a degree of longitude is 64.6 km, of latitude 111.3 km.
    let chart = "[chart]\nfiles = [\"e.geojson\"]\ncoordinates = \"longitude_latitude\"\n\
                 projection = \"PROJECTION\"\norigin = { latitude = \"54.5 deg\", longitude = \"10.2 deg\" }\n";
    let empty = "{ \"type\": \"FeatureCollection\", \"features\": [] }";
    let made = |projection: &str, coordinates: &str, text: &str| {
        let chart = chart.replace("PROJECTION", projection);
        let toml = format!(
            "{HEAD}{chart}[environment.bottom]\nsurvey = [\"a.xyz\"]\nsurvey_coordinates = \"{coordinates}\"\n"
        );
        let scenario = read(&toml, &[("a.xyz", text), ("e.geojson", empty)]);
        scenario.map(|scenario| scenario.setup.world.environment.bottom.unwrap().field)
    };
    let degrees = rows(|x, y, z| format!("{} {} {z}\n", 10.2 + x / 64_696.0, 54.5 + y / 111_324.0));
    let field = made("transverse_mercator", "longitude_latitude", &degrees).unwrap();
    let depth_m = field.depth_m(vec2(70.0, 50.0)).unwrap();
    assert!((depth_m - 12.9).abs() < 0.01, "{depth_m}");
    // UTM of the origin in zone 32 by PROJ (`rasterio.warp.transform` of rasterio 1.4.4): 577,711.99 east, 6,039,816.79 north.
    let utm = rows(|x, y, z| format!("{:.2} {:.2} {z}\n", 577_711.99 + x, 6_039_816.79 + y));
    let of_grid = made("utm", "utm", &utm).unwrap();
    let depth_m = of_grid.depth_m(vec2(70.0, 50.0)).unwrap();
    assert!((depth_m - 12.9).abs() < 0.01, "{depth_m}");
    // True north is 1° to the left of grid north here.
    let of_true_north = made("transverse_mercator", "utm", &utm).unwrap();
    let depth_m = of_true_north.depth_m(vec2(70.0, 50.0)).unwrap();
    assert!((depth_m - 12.9).abs() < 0.05, "{depth_m}");

    let swapped = rows(|x, y, z| format!("{} {} {z}\n", 54.5 + y / 111_324.0, 10.2 + x / 64_696.0));
    let error = made("transverse_mercator", "longitude_latitude", &swapped).unwrap_err();
    assert!(error.to_string().contains("latitude before longitude"), "{error}");
    let error = made("utm", "metres", &utm).unwrap_err();
    assert!(error.to_string().contains("survey_coordinates = \"utm\""), "{error}");
    let error = made("utm", "longitude_latitude", &utm).unwrap_err();
    assert!(error.to_string().contains("not a longitude and a latitude"), "{error}");
}

#[test]
fn each_mistake_of_a_survey_names_file_and_line() {
    for (text, line, reason) in [
        (GRID.replace("nrows 2\n", ""), 5, "the head has no `nrows`"),
        (GRID.replace("ncols 3", "ncols 2.5"), 6, "`ncols` must be a whole number"),
        (
            GRID.replace("ncols 3", "ncols 3000").replace("nrows 2", "nrows 2000"),
            6,
            "at most 4000000",
        ),
        (GRID.replace("cellsize 10", "cellsize 0"), 6, "`cellsize` must be above 0"),
        (GRID.replace("cellsize", "cell"), 5, "\"cell\" is not a key"),
        (GRID.replace("7 8 9", "7 x 9"), 7, "\"x\" is not a number"),
        (GRID.replace("7 8 9", "7 99999 9"), 7, "between -12000 and 12000"),
        (format!("{GRID}3 3\n"), 9, "more than 3 × 2 values"),
        (GRID.replace("xllcorner -15", "xllcorner 5e5"), 6, "more than 200 km"),
        ("1 2 3\n1 2\n".to_owned(), 2, "each row of a survey needs three numbers: x, y and z"),
        ("1 2 3\n1 2 a\n".to_owned(), 2, "\"a\" is not a number"),
        ("1 2 3\n\n6e5 2 3\n".to_owned(), 3, "more than 200 km"),
    ] {
        let error = survey(&text).expect_err(reason);
        assert!(error.to_string().contains(reason), "{error}\n{reason}");
        assert_eq!(error.key(), Some("environment.bottom.survey"), "{error}");
        let Place::File { name, line: found, .. } = error.place() else { panic!("{error}") };
        assert_eq!((name.as_str(), *found), ("a.asc", line), "{error}");
    }
    for (text, reason) in [
        (GRID.replace("4 5 -9999", "4 5"), "the grid has 5 values, but 3 × 2"),
        (GRID.replace("7 8 9\n4 5", "-9999 -9999 -9999\n-9999 -9999"), "no data"),
        (String::new(), "no data"),
        ("1 2 3\n2 3 4\n".to_owned(), "three points or more"),
        ("1 1 3\n2 2 4\n3 3 4\n".to_owned(), "lie on one line"),
    ] {
        let error = survey(&text).expect_err(reason).to_string();
        assert!(error.contains(reason), "{error}\n{reason}");
    }
}

#[test]
fn keys_that_do_not_fit_are_refused() {
    let files = [("a.asc", GRID), ("c.geojson", CHART_OF_NAMES)];
    for (keys, key, reason) in [
        ("", "environment.bottom", "neither a `survey` nor a `chart`"),
        ("survey = []", "environment.bottom.survey", "must name a survey"),
        (
            "survey = [\"a.asc\"]\noutside = \"deep\"",
            "environment.bottom.outside",
            "\"error\" or a depth",
        ),
        (
            "chart = \"least\"\nsurvey_values = \"depths\"",
            "environment.bottom.survey_values",
            "for a `survey`",
        ),
        ("chart = \"least\"", "environment.bottom.chart", "no depth areas"),
        (
            "survey = [\"a.asc\"]\nsurvey_coordinates = \"utm\"",
            "environment.bottom.survey_coordinates",
            "a chart with an origin",
        ),
        ("survey = [\"b.asc\"]", "environment.bottom.survey", "cannot read b.asc"),
    ] {
        let error = bottom(keys, &files).expect_err(reason);
        assert!(error.to_string().contains(reason), "{error}\n{reason}");
        assert_eq!(error.key(), Some(key), "{error}");
    }
    let toml = format!("{HEAD}[environment]\ndepth = 9\nbottom = {{ survey = [\"a.asc\"] }}\n");
    let error = read(&toml, &files).unwrap_err().to_string();
    assert!(error.contains("does not go together with `depth`"), "{error}");
    let error = bottom("chart = \"least\"", &[]).unwrap_err().to_string();
    assert!(error.contains("there is no [chart]"), "{error}");
}

const CHART_OF_NAMES: &str = "{ \"type\": \"FeatureCollection\", \"features\": [{ \"type\": \"Feature\", \"properties\": \
     { \"kind\": \"name\", \"name\": \"Basin\" }, \"geometry\": { \"type\": \"Point\", \"coordinates\": [0, 0] } }] }";

/// A made-up chart in the form of S-57, from west to east: land, 0 to 5 m, 5 to 10 m, a dredged area of 12 m that is
/// enclosed by more than 10 m; a quay along the land's northern half; a sounding; a hole without data.
fn made_up() -> String {
    let area = |class: u32, attributes: &str, west: f64, east: f64| {
        format!(
            "{{ \"type\": \"Feature\", \"properties\": {{ \"OBJL\": {class}{attributes} }}, \"geometry\": {{ \"type\": \"Polygon\", \
             \"coordinates\": [[[{west}, 0], [{east}, 0], [{east}, 400], [{west}, 400], [{west}, 0]]] }} }}"
        )
    };
    let line = |class: u32, attributes: &str, east: f64, [from, to]: [f64; 2]| {
        format!(
            "{{ \"type\": \"Feature\", \"properties\": {{ \"OBJL\": {class}{attributes} }}, \"geometry\": {{ \"type\": \"LineString\", \
             \"coordinates\": [[{east}, {from}], [{east}, {to}]] }} }}"
        )
    };
    let features = [
        area(71, "", -200.0, 0.0),
        area(42, ", \"DRVAL1\": 0, \"DRVAL2\": 5", 0.0, 100.0),
        area(42, ", \"DRVAL1\": 5, \"DRVAL2\": 10", 100.0, 200.0),
        area(42, ", \"DRVAL1\": 10, \"DRVAL2\": 20", 200.0, 400.0),
        area(46, ", \"DRVAL1\": 12", 400.0, 500.0),
        line(43, ", \"VALDCO\": 5", 100.0, [0.0, 400.0]),
        line(43, ", \"VALDCO\": 10", 200.0, [0.0, 400.0]),
        line(30, "", 0.0, [0.0, 200.0]),
        line(122, ", \"CATSLC\": 6", 0.0, [200.0, 400.0]),
        "{ \"type\": \"Feature\", \"properties\": { \"OBJL\": 129 }, \"geometry\": { \"type\": \"MultiPoint\", \"coordinates\": \
         [[300, 0, 14], [300, 200, 14], [300, 400, 14]] } }"
            .to_owned(),
    ];
    format!("{{ \"type\": \"FeatureCollection\", \"features\": [\n{}\n] }}", features.join(",\n"))
}

#[test]
fn the_least_depth_of_each_area_is_drval1() {
    let field = bottom("chart = \"least\"\ncell = 5", &[("c.geojson", &made_up())]).unwrap().field;
    assert_eq!(field.cell_m(), 5.0);
    for (north, east, depth_m) in [
        (150.0, 50.0, 0.0),
        (33.0, 188.0, 5.0),
        (390.0, 250.0, 10.0),
        (20.0, 480.0, 12.0),
        (50.0, -100.0, -20.0),
    ] {
        assert_eq!(field.depth_m(vec2(north, east)), Some(depth_m), "{north} {east}");
    }
    assert_eq!(field.depth_m(vec2(50.0, 600.0)), None);
    // The land rises within a cell of the coast, but goes on under the quay.
    assert_eq!(field.depth_m(vec2(300.0, -5.0)), Some(0.0));
    assert_eq!(field.depth_m(vec2(100.0, -5.0)), Some(-20.0));
}

#[test]
fn interpolated_depths_lie_between_contours_and_soundings_and_within_each_area() {
    let field =
        bottom("chart = \"interpolated\"\ncell = 5", &[("c.geojson", &made_up())]).unwrap().field;
    // Linear between coast, contours and soundings.
    for (north, east, depth_m) in [
        (100.0, 50.0, 2.5),
        (100.0, 150.0, 7.5),
        (300.0, 120.0, 6.0),
        (200.0, 250.0, 12.0),
        (200.0, 300.0, 14.0),
        (200.0, 450.0, 12.0),
    ] {
        let found_m = field.depth_m(vec2(north, east)).expect("data");
        assert!((found_m - depth_m).abs() < 0.1, "{north} {east}: {found_m}, not {depth_m}");
    }
    let bounds = [(0.0, 100.0, 0.0, 5.0), (100.0, 200.0, 5.0, 10.0), (200.0, 400.0, 10.0, 20.0)];
    let mut state = 1_u64;
    let mut random = || {
        // Knuth's MMIX.
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / f64::from(1_u32 << 31)
    };
    for _ in 0..200 {
        // The last node with data is 5 m before the edge of the areas, which belongs to the next area.
        let (north, share) = (395.0 * random(), random());
        for (west, east, least_m, most_m) in bounds {
            let at = vec2(north, west + share * (east - west));
            let depth_m = field.depth_m(at).expect("data");
            assert!(depth_m >= least_m && depth_m <= most_m, "{at:?}: {depth_m}");
        }
    }
}

#[test]
fn the_same_chart_gives_the_same_bits_in_any_order_of_its_lines() {
    let make = |file: &str| {
        bottom("chart = \"interpolated\"\ncell = 5", &[("c.geojson", file)]).unwrap().field
    };
    let file = made_up();
    let lines: Vec<&str> = file.lines().collect();
    let last = lines.len() - 1;
    let mut features: Vec<String> =
        lines[1..last].iter().map(|line| line.trim_end_matches(',').to_owned()).collect();
    features.reverse();
    let reversed = format!("{}\n{}\n{}", lines[0], features.join(",\n"), lines[last]);
    assert!(make(&file) == make(&reversed));
}

#[test]
fn a_survey_in_a_chart_counts_where_it_has_data() {
    let survey = "ncols 10\nnrows 10\nxllcorner 220\nyllcorner 100\ncellsize 10\n".to_owned()
        + &"15 ".repeat(100);
    let files = [("a.asc", survey.as_str()), ("c.geojson", &made_up())];
    let field = bottom("survey = [\"a.asc\"]\nchart = \"least\"", &files).unwrap().field;
    assert_eq!(field.cell_m(), 10.0);
    assert_eq!(field.depth_m(vec2(150.0, 270.0)), Some(15.0));
    assert_eq!(field.depth_m(vec2(300.0, 270.0)), Some(10.0));
    let elsewhere = survey.replace("xllcorner 220", "xllcorner 90220");
    let files = [("a.asc", elsewhere.as_str()), ("c.geojson", &made_up())];
    let error = bottom("survey = [\"a.asc\"]\nchart = \"least\"", &files).unwrap_err().to_string();
    assert!(error.contains("the survey lies outside of the chart"), "{error}");
}

#[test]
fn cells_that_are_too_many_are_refused_and_coarse_cells_are_told() {
    let file = made_up();
    let error = bottom("chart = \"least\"\ncell = 0.1", &[("c.geojson", &file)]).unwrap_err();
    assert!(error.to_string().contains("at most 4000000 are allowed"), "{error}");
    assert_eq!(error.key(), Some("environment.bottom.cell"));
    let large = file.replace("400]", "80000]").replace("500,", "90000,");
    let toml = format!("{HEAD}{METRES}[environment.bottom]\nchart = \"least\"\n");
    let scenario = read(&toml, &[("c.geojson", &large)]).unwrap();
    let notice =
        scenario.notices.iter().find(|notice| notice.message.contains("coarse for a berth"));
    assert!(notice.is_some(), "{:?}", scenario.notices);
}

#[test]
fn areas_over_each_other_are_told_and_the_lesser_depth_counts() {
    // The area of 5 to 10 m reaches over that of 0 to 5 m.
    let widened = |line: &str| match line.contains("\"DRVAL1\": 5,") {
        true => line.replace("[100,", "[60,"),
        false => line.to_owned(),
    };
    let file = made_up().lines().map(widened).collect::<Vec<_>>().join("\n");
    let toml = format!("{HEAD}{METRES}[environment.bottom]\nchart = \"least\"\ncell = 5\n");
    let scenario = read(&toml, &[("c.geojson", &file)]).unwrap();
    let notice =
        scenario.notices.iter().find(|notice| notice.message.contains("lie over each other"));
    assert_eq!(notice.expect("a notice").key, "environment.bottom.chart");
    let field = scenario.setup.world.environment.bottom.unwrap().field;
    assert_eq!(field.depth_m(vec2(100.0, 80.0)), Some(0.0));
}

#[test]
fn ships_begin_in_the_water_and_on_the_chart() {
    let file = made_up()
        .replace("400]", "4000]")
        .replace("500,", "5000,")
        .replace("\"DRVAL1\": 12", "\"DRVAL1\": 16");
    let at = |position: &str, keys: &str| {
        let toml = format!(
            "{HEAD}{METRES}[environment.bottom]\nchart = \"least\"\ncell = 20\n{keys}\n{SHIP}position = {position}\n"
        );
        read(&toml, &[("c.geojson", &file)])
    };
    let error = at("[2000, 9000]", "").unwrap_err();
    assert_eq!(error.key(), Some("body.ship.position"));
    assert!(error.to_string().contains("\"ship\" begins where the bottom has no data"), "{error}");
    assert!(at("[2000, 9000]", "outside = \"20 m\"").is_ok());
    let error = at("[2000, -120]", "").unwrap_err().to_string();
    assert!(error.contains("begins on land"), "{error}");
    let aground = at("[2000, 150]", "").unwrap();
    let notice = aground.notices.iter().find(|notice| notice.key == "body.ship.position");
    assert!(notice.expect("a notice").message.contains("begins aground"), "{notice:?}");
    let afloat = at("[2000, 2500]", "").unwrap();
    assert!(!afloat.notices.iter().any(|notice| notice.key == "body.ship.position"));
}

/// The known answers of a real cell, whose folder is made by
/// `python -m fenderline.charts US4MD81M.000 -o FOLDER` and named by `FENDERLINE_ENC`.
#[test]
#[ignore = "needs a real chart: FENDERLINE_ENC names the folder of the converted cell US4MD81M"]
fn a_real_cell_has_its_counts_and_its_depths() {
    use fenderline_sim::chart::{ChartKind, ChartShape};
    let folder = std::path::PathBuf::from(std::env::var("FENDERLINE_ENC").expect("FENDERLINE_ENC"));
    let snippet = std::fs::read_to_string(folder.join("chart.toml")).expect("chart.toml");
    let scenario = |choice: &str| {
        let tables = snippet.split("[environment.bottom]").next().expect("a chart");
        let toml = format!("{HEAD}{tables}[environment.bottom]\nchart = \"{choice}\"\ncell = 40\n");
        Scenario::parse_beside(&toml, "s.toml", &[], &folder).expect("a scenario")
    };
    let of_least = scenario("least");
    let chart = &of_least.setup.world.chart;
    println!("read: {}", chart.read_in_words().unwrap_or_default());
    println!("left out: {}", chart.left_out_in_words().unwrap_or_default());
    for (class, count) in [
        ("DEPARE", 525),
        ("DEPCNT", 566),
        ("SOUNDG", 56),
        ("COALNE", 1826),
        ("SLCONS", 666),
        ("LNDARE", 183),
        ("DRGARE", 7),
        ("BOYLAT", 71),
        ("BRIDGE", 51),
        ("OBSTRN", 219),
    ] {
        let found = chart.classes.iter().find(|of| of.class == class).expect(class);
        assert_eq!(found.read + found.left_out(), count, "{class}");
        assert_eq!(found.read, count, "{class}: {:?}", found.left_out);
    }
    let of_interpolated = scenario("interpolated");
    let fields = [&of_least, &of_interpolated]
        .map(|of| of.setup.world.environment.bottom.as_ref().expect("a bottom").field.clone());
    println!("nodes: {:?}, range {:?} m", fields[0].nodes(), fields[1].range_m());
    let areas: Vec<_> = chart
        .features
        .iter()
        .filter(|feature| feature.kind == ChartKind::DepthArea)
        .filter_map(|feature| match &feature.shape {
            ChartShape::Area(rings) => Some((feature, rings)),
            _ => None,
        })
        .collect();
    // Places whose whole cell lies in one area, as the depth between nodes of two areas lies between both.
    let inside = |rings: &[Vec<fenderline_contact::Vec2>], at: fenderline_contact::Vec2| {
        let crossings = rings
            .iter()
            .flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)).take(ring.len()));
        let crossed = crossings.filter(|(a, b)| {
            (a.y > at.y) != (b.y > at.y) && at.x < a.x + (b.x - a.x) * (at.y - a.y) / (b.y - a.y)
        });
        crossed.count() % 2 == 1
    };
    let [low, high] = fields[0].corners_m();
    let mut state = 38_u64;
    let mut random = || {
        state =
            state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / f64::from(1_u32 << 31)
    };
    let (mut tried, mut all) = (0, 0);
    let mut between = 0;
    while tried < 200 {
        let at = vec2(low.x + random() * (high.x - low.x), low.y + random() * (high.y - low.y));
        let Some((feature, rings)) = areas.iter().find(|(_, rings)| inside(rings, at)) else {
            continue;
        };
        all += 1;
        let corner = |of: f64, from: f64| from + libm::floor((of - from) / 40.0) * 40.0;
        let (x, y) = (corner(at.x, low.x), corner(at.y, low.y));
        let corners = [(0.0, 0.0), (40.0, 0.0), (0.0, 40.0), (40.0, 40.0)];
        if !corners.iter().all(|(dx, dy)| inside(rings, vec2(x + dx, y + dy))) {
            continue;
        }
        tried += 1;
        let (least_m, most_m) =
            (feature.depth_m.expect("DRVAL1"), feature.deepest_m.expect("DRVAL2"));
        let [of_least_m, of_interpolated_m] =
            [&fields[0], &fields[1]].map(|field| field.depth_m(at).expect("data"));
        // The nodes have single precision.
        let rounding = 1e-5;
        assert!((of_least_m - least_m).abs() < rounding, "{at:?}: {of_least_m}, not {least_m}");
        let is_within =
            of_interpolated_m > least_m - rounding && of_interpolated_m < most_m + rounding;
        assert!(is_within, "{at:?}: {of_interpolated_m} is not between {least_m} and {most_m}");
        between +=
            usize::from(of_interpolated_m > least_m + 0.01 && of_interpolated_m < most_m - 0.01);
    }
    println!("{tried} places in one area, of {all} in the depth areas; {between} strictly between");
}
