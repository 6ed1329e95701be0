//! The JSON Schema against the reader: both accept and refuse the same files, key by key.
// The scenario with all keys is one macro.

use std::path::{Path, PathBuf};

use boon::{Compiler, SchemaIndex, Schemas};
use fenderline_campaign::{Campaign, campaign_schema};
use fenderline_scenario::{Scenario, schema};
use serde_json::{Map, Value as Json, json};
use toml::de::{DeTable, DeValue};

/// A compiled schema. Compiling checks it against its meta-schema.
struct Validator {
    schemas: Schemas,
    index: SchemaIndex,
}

impl Validator {
    fn of(schema: Json) -> Result<Validator, String> {
        let mut schemas = Schemas::new();
        let mut compiler = Compiler::new();
        compiler.add_resource("scenario.json", schema).map_err(|e| format!("{e:#}"))?;
        let compiled = compiler.compile("scenario.json", &mut schemas);
        let index = compiled.map_err(|e| format!("{e:#}"))?;
        Ok(Validator { schemas, index })
    }

    fn validate(&self, document: &Json) -> Result<(), String> {
        self.schemas.validate(document, self.index).map_err(|e| format!("{e:#}"))
    }
}

thread_local! {
    /// Compiled once for each thread: compiling takes longer than a thousand validations.
    static VALIDATOR: Validator = validator();
}

fn validator() -> Validator {
    Validator::of(schema()).expect("the schema is a schema")
}

#[test]
fn the_schema_is_a_schema() {
    assert!(Validator::of(schema()).is_ok());
    let mut broken = schema();
    broken["type"] = json!("tabel");
    assert!(Validator::of(broken).is_err(), "an invalid schema is refused");
    assert_eq!(schema()["$schema"], "https://json-schema.org/draft/2020-12/schema");
}

/// The campaign of the repository fits reader and schema; so do the two ways of giving a variable its values, and no third.
#[test]
fn campaigns_fit_reader_and_schema() {
    let validator = Validator::of(campaign_schema()).expect("a schema");
    let text = include_str!("../../../campaigns/quay_54_cases.toml");
    let campaign = Campaign::parse(text, "quay_54_cases.toml").unwrap();
    assert_eq!(campaign.cases(), 54);
    assert_eq!(campaign.labels(53), ["0.18 m/s", "6 deg", "9.5 m", "18 m"]);
    let start = "scenario = \"x.toml\"\n[variable.a]\n";
    for (rest, good) in [
        ("key = \"time.step\"\nvalues = [0.1, \"0.2 s\"]", true),
        ("[variable.a.choice.b]\nset = [\"time.step=1\"]", true),
        ("values = [1]", false),
        ("key = \"time.step\"\nvalues = []", false),
        ("key = \"time.step\"\nvalues = 3", false),
        ("key = \"time.step\"\nvalues = [[1]]", false),
        (
            "key = \"time.step\"\nvalues = [1]\n[variable.a.choice.b]\nset = [\"time.step=1\"]",
            false,
        ),
        ("[variable.a.choice.b]\n", false),
        ("keys = [\"time.step\"]\nvalues = [1]\nweights = [2]", true),
        ("key = \"time.step\"\nexpression = \"1 + 1\"", true),
        ("key = \"time.step\"\nvalues = [1]\nsource = 3", false),
    ] {
        let text = format!("{start}{rest}\n");
        assert_eq!(Campaign::parse(&text, "c.toml").is_ok(), good, "{text}");
        assert_eq!(validator.validate(&json_of(&text)).is_ok(), good, "{text}");
    }
    // A downtime in place of variables and what goes with them.
    let start = "scenario = \"x.toml\"\n";
    for (text, good) in [
        ("[downtime]\nfile = \"year.csv\"", true),
        (
            "seed = 3\noutputs = [\"energy\"]\n[downtime]\nfile = \"year.csv\"\nstates = 9\nsample = 0",
            true,
        ),
        ("", false),
        ("[downtime]\nstates = 9", false),
        ("[downtime]\nfile = \"year.csv\"\nstates = 0", false),
        ("plan = \"Sobol\"\n[downtime]\nfile = \"year.csv\"", false),
        ("number = 3\n[downtime]\nfile = \"year.csv\"", false),
        ("[downtime]\nfile = \"y.csv\"\n[limit.a]\noutput = \"energy\"\nvalue = 1", false),
        ("[downtime]\nfile = \"y.csv\"\n[variable.a]\nkey = \"time.step\"\nvalues = [1]", false),
    ] {
        let text = format!("{start}{text}\n");
        assert_eq!(Campaign::parse(&text, "c.toml").is_ok(), good, "{text}");
        assert_eq!(validator.validate(&json_of(&text)).is_ok(), good, "{text}");
    }
    let start = "scenario = \"x.toml\"\n[variable.a]\n";
    // A key alone is the column of a table: only the plan tells.
    let alone = format!("{start}key = \"time.step\"\n");
    assert!(Campaign::parse(&alone, "c.toml").is_err());
    let of_table = format!("plan = \"table\"\ntable = \"runs.csv\"\n{alone}");
    assert!(Campaign::parse(&of_table, "c.toml").is_ok());
    assert!(validator.validate(&json_of(&of_table)).is_ok());
    // Ten variables of ten values are 10^10 cases.
    let ten = |name: usize| {
        format!(
            "[variable.v{name}]\nkey = \"time.step\"\nvalues = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9]\n"
        )
    };
    let many = format!("scenario = \"x.toml\"\n{}", (0..10).map(ten).collect::<String>());
    let error = Campaign::parse(&many, "c.toml").unwrap_err().to_string();
    assert!(error.contains("are more than 1000000 cases"), "{error}");
}

/// All scenario files of the repository.
fn scenario_files() -> Vec<PathBuf> {
    fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
        for entry in std::fs::read_dir(folder).expect("the folder can be read") {
            let path = entry.expect("the entry can be read").path();
            if path.is_dir() {
                collect(&path, files);
            } else if path.extension().is_some_and(|extension| extension == "toml") {
                files.push(path);
            }
        }
    }
    let mut files = Vec::new();
    collect(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios"), &mut files);
    files.sort();
    files
}

#[test]
fn every_scenario_in_the_repository_fits_reader_and_schema() {
    let (files, validator) = (scenario_files(), validator());
    assert!(!files.is_empty());
    for file in files {
        let text = std::fs::read_to_string(&file).unwrap();
        let mut beside = |name: &str| {
            let path = file.parent().unwrap().join(name);
            std::fs::read_to_string(&path).map_err(|why| format!("{}: {why}", path.display()))
        };
        let name = file.to_string_lossy();
        let scenario = Scenario::parse_among(&text, &name, &[], &mut beside).unwrap();
        assert!(!scenario.setup.bodies.is_empty());
        let document = json_of(&text);
        if let Err(error) = validator.validate(&document) {
            panic!("{}: {error}", file.display());
        }
    }
}

/// Scenarios that together use every key of the schema: `full`, and others with the keys that exclude those of `full`.
fn fulls() -> Vec<Json> {
    let mut by_file = full();
    by_file["environment"]["wind"] = json!({ "file": "wind.csv" });
    by_file["environment"]["tide"] = json!({ "file": "tide.csv" });
    by_file["environment"]["current"] = json!({ "file": "current.csv" });
    by_file["environment"]["long_waves"] = json!({ "file": "long_waves.csv" });
    let mut by_depth = full();
    by_depth["environment"]["current"] = json!({ "profile": [
        { "depth": 0, "speed": "1 kn", "towards": 0 }, { "depth": "9 m", "speed": 0, "towards": 0 }
    ] });
    // Apart from the others: a line that a winch order is for has to have its winch.
    let mut on_winches = full();
    on_winches["order"] = json!([
        { "line": "spring", "heave": 0.1 },
        { "line": "spring", "pay_out": 0.1 },
        { "line": "spring", "hold": true }
    ]);
    let mut by_wall = full();
    for row in by_wall["fender_row"].as_object_mut().unwrap().values_mut() {
        let row = row.as_object_mut().unwrap();
        row.remove("first");
        row.remove("last");
        row.insert("spacing".to_owned(), json!("9 m"));
        row.insert("number".to_owned(), json!(2));
        row.insert("wall".to_owned(), json!([[-100, 0], [100, 0]]));
        row.insert("from_corner".to_owned(), json!("5 m"));
    }
    by_wall["body"]["coaster"]["approach"]["abnormal"] = json!({ "speed_factor": 1.25 });
    let mut on_dolphins = full();
    on_dolphins["exercise"]["berth"] = json!("b");
    on_dolphins["body"]["coaster"].as_object_mut().unwrap().remove("approach");
    for row in on_dolphins["fender_row"].as_object_mut().unwrap().values_mut() {
        let row = row.as_object_mut().unwrap();
        for key in ["on", "spacing", "number", "first", "last", "exception"] {
            row.remove(key);
        }
        row.insert("dolphins".to_owned(), json!([[700, 0], [800, 0]]));
        row.insert("outline".to_owned(), json!([[-2, 0], [2, 0], [2, 4], [-2, 4]]));
        row.insert("heading".to_owned(), json!("30 deg"));
        row.insert("dolphin".to_owned(), pile());
    }
    let mut on_tubes = on_dolphins.clone();
    for row in on_tubes["fender_row"].as_object_mut().unwrap().values_mut() {
        row["dolphin"] = tubes();
    }
    by_depth["berthing"]["added_mass_factor"] = json!(1.7);
    by_depth["berthing"].as_object_mut().expect("a table").remove("added_mass");
    let mut of_chart = full();
    of_chart["body"]["of the chart"] =
        json!({ "fixed": true, "chart_outline": "quay 3", "position": [0, 3000] });
    let mut on_shore = full();
    let chart = on_shore["chart"].as_object_mut().expect("a table");
    chart.insert("solid".to_owned(), json!(["quay"]));
    chart.insert("solid_material".to_owned(), json!("m"));
    chart.insert("solid_width".to_owned(), json!("2 m"));
    let by_data = json!({
        "time": { "step": "0.1 s", "duration": 10 },
        "vessel": { "barge": {
            "length_bp": 80, "beam": 20, "draught": 5, "block_coefficient": 1, "gyradius": 20,
            "hydrodynamics": "ship.hydro", "roll_damping": 0.04
        } },
        "body": { "barge": {
            "vessel": "barge", "outline": [[-40, -10], [40, -10], [40, 10], [-40, 10]]
        } },
        "tug": { "tug": {
            "vessel": "barge", "bollard_pull": "60 tf", "push_at": [0, -10], "above_water": "4 m"
        } }
    });
    let mut on_bottom = full();
    let environment = on_bottom["environment"].as_object_mut().expect("a table");
    environment.remove("depth");
    environment.insert(
        "bottom".to_owned(),
        json!({
            "survey": ["depths.asc"], "survey_coordinates": "metres", "survey_values": "depths",
            "chart": "interpolated", "cell": "50 m", "outside": "30 m", "banks": "image"
        }),
    );
    let mut planned = full();
    planned["plan"] = json!({ "in": { "vessel": "d", "reach": "200 m", "waypoint": [
        { "name": "Sea buoy", "position": [0, "1 km"] },
        { "position": [0, "3 km"], "turning_radius": "600 m", "speed": "6 kn", "half_width": "60 m" },
        { "name": "Quay", "position": ["2 km", "4 km"] }
    ] } });
    let square = json!([[-5, -5], [5, -5], [5, 5], [-5, 5]]);
    let quay_line = json!({
        "class": "SLCONS", "name": "Long Quay", "from": [500, 1700], "to": [500, 1300], "water": "left"
    });
    let along_the_chart = json!({
        "time": { "step": "0.1 s", "duration": 10 },
        "material": { "m": { "stiffness": "5 MN/m^2" } },
        "chart": {
            "files": ["quay.geojson"], "coordinates": "metres", "solid": ["LNDARE"], "solid_material": "m"
        },
        "body": {
            "barge": { "outline": square, "mass": 1000, "gyradius": 3 },
            "quay": {
                "fixed": true, "outline": [[-100, 0], [100, 0], [100, 9], [-100, 9]], "position": [0, 300]
            }
        },
        "fender_row": { "f": {
            "on": "shore", "quay_line": quay_line, "spacing": "20 m", "number": 3, "from_corner": "5 m",
            "width": "2 m", "type": "cone", "height": "1.2 m", "material": "m"
        } },
        "bollard_row": {
            "along": {
                "on": "shore", "quay_line": quay_line, "spacing": "20 m", "number": 3, "from_corner": "5 m",
                "behind": "2 m", "height": "4 m", "lines": 2
            },
            "of a wall": {
                "on": "quay", "wall": [[-100, 0], [100, 0]], "spacing": "20 m", "number": 3
            },
            "of ends": { "on": "quay", "first": [-60, 1], "last": [60, 1], "number": 3 }
        }
    });
    let mut anchored = full();
    anchored["exercise"] = exercise_at_anchor();
    vec![
        full(),
        by_data,
        by_file,
        by_depth,
        on_winches,
        by_wall,
        on_dolphins,
        on_tubes,
        of_chart,
        on_shore,
        on_bottom,
        planned,
        along_the_chart,
        anchored,
    ]
}

fn pile() -> Json {
    json!({ "stiffness": "5 MN/m", "mass": "60 t", "yield_load": "1500 kN", "damping": 0.02 })
}

fn exercise() -> Json {
    json!({
        "task": "make her fast", "vessel": "d", "goal": "all_fast", "berth": "long quay",
        "mark": { "name": "Bow at bollard 9", "at": [1.5, "75 m"], "of_ship": "-12 m" },
        "lines": ["spring", "breast"], "at_least": 1, "least_tension": "10 kN", "most_tension": "400 kN",
        "distance": "0.4 m", "rest_speed": "0.1 kn", "hold": 20, "time_limit": "1 h", "pass_mark": 70, "view_marks": false,
        "limit": {
            "approach_speed": { "most": 0.15, "worst": 0.3, "points": 20, "fails": true, "within": "50 m" },
            "ahead_speed": { "most": 0.3, "worst": 1, "points": 20, "fails": false, "within": 20 },
            "angle": { "most": "3 deg", "worst": "6 deg", "points": 20, "fails": false, "within": 20 },
            "engine": { "most": 0.3, "worst": 1, "points": 20, "fails": false, "within": 20 },
            "fender": { "most": "80 %", "worst": "120 %", "points": 20, "fails": false },
            "line": { "most": "50 %", "worst": 1, "points": 20, "fails": false },
            "clearance": { "least": 2, "worst": 1, "points": 20, "fails": false },
            "under_keel": { "least": 2, "worst": 1, "points": 20, "fails": false },
            "cross_track": { "most": "30 m", "worst": "60 m", "points": 20, "fails": false },
            "touch": { "points": 50, "fails": true },
            "time": { "most": "30 min", "worst": "1 h", "points": 20, "fails": false }
        }
    })
}

fn exercise_at_anchor() -> Json {
    json!({
        "task": "come to anchor", "vessel": "d", "goal": "anchored", "anchors": ["starboard"], "at_least": 1,
        "chain_out": "4 shackles", "position": [400, -120], "distance": "50 m", "rest_speed": "0.1 kn", "hold": 60,
        "limit": {
            "chain": { "most": "40 %", "worst": 1, "points": 20, "fails": false },
            "dragged": { "most": 20, "worst": "60 m", "points": 20, "fails": false }
        }
    })
}

fn tubes() -> Json {
    json!({
        "diameter": "2.5 m", "wall": "40 mm", "length": "25 m", "piles": 2, "modulus": "210 GPa",
        "yield_stress": "420 MPa", "head_mass": "40 t"
    })
}

/// Rows with all keys of fenders: one for each fender of `full` that stands on a quay, with an exception that has all
/// keys of that fender.
fn with_rows(mut full: Json) -> Json {
    let mut rows = Map::new();
    for (name, fender) in full["fender"].as_object().unwrap() {
        let mut row = fender.as_object().unwrap().clone();
        if row.contains_key("belting") {
            continue;
        }
        row.remove("position");
        row.remove("facing");
        let mut exception = row.clone();
        exception.remove("on");
        exception.insert("position".to_owned(), json!([50, 0]));
        exception.insert("facing".to_owned(), json!("-80 deg"));
        let member = format!("row {name}_1");
        row.insert("on".to_owned(), json!("long quay"));
        row.insert("first".to_owned(), json!([-70, 0]));
        row.insert("facing".to_owned(), json!("-90 deg"));
        match name.as_str() {
            "of a type" => row.insert("last".to_owned(), json!([70, 0])),
            _ => row.insert("number".to_owned(), json!(3)),
        };
        row.insert("spacing".to_owned(), json!("20 m"));
        row.insert("exception".to_owned(), json!({ member: exception }));
        rows.insert(format!("row {name}"), Json::Object(row));
    }
    full["fender_row"] = Json::Object(rows);
    let outline = json!([[-100, 0], [100, 0], [100, 9], [-100, 9]]);
    full["body"]["long quay"] = json!({ "fixed": true, "outline": outline, "position": [0, 300] });
    full["body"]["coaster"] = json!({
        "outline": [[-30, -5], [30, -5], [30, 5], [-30, 5]], "mass": "1500 t", "gyradius": "15 m",
        "approach": {
            "to": "long quay", "speed_normal": "0.15 m/s", "along": 0.1, "angle": "2 deg",
            "side": "port", "contact": "quarter point", "fender": "row of a size_2",
            "distance": "20 m", "abnormal": { "energy_factor": 1.5 }
        }
    });
    full["statistics"] = json!({ "from": "2 s" });
    own_coefficients(&mut full);
    full["limit"] = json!({
        "ahead": { "of": "surge", "vessel": "d", "statistic": "significant range", "distance": "0.8 m" },
        "heel": { "of": "roll", "vessel": "d", "statistic": "maximum", "angle": "2 deg" },
        "ropes": { "of": "lines", "share": 0.5 }
    });
    full
}

/// Coefficients, ropes and factors of one's own.
fn own_coefficients(full: &mut Json) {
    full["environment"]["air_density"] = json!("1.28 kg/m^3");
    full["factors"] = json!({
        "source": "a basis of design", "energy": 1.25, "reaction": 1.1, "reaction_limit": "2 MN", "line_load": 1.3,
        "line_capacity": "break_load"
    });
    let table = json!({
        "file": "forces.txt", "columns": ["angle_deg", "-", "x_kn", "y_kn", "n_knm"], "skip_lines": 2,
        "convention": "own", "angle_zero": "ahead", "angle_side": "from_starboard", "surge_positive": "forward",
        "sway_positive": "to_starboard", "yaw_positive": "bow_to_starboard", "surge_area": 400, "sway_area": 2000,
        "yaw_length": 150, "moment_about": -3, "quantity": "forces", "at_speed": "20 m/s", "at_density": 1.28,
        "source": "a wind tunnel"
    });
    let ship = &mut full["vessel"]["box ship"];
    ship["wind_coefficients"] = table.clone();
    ship["wind_coefficients"]["reference_height"] = json!("10 m");
    ship["wind_coefficients"]["centroid_height"] = json!("8 m");
    ship["current_coefficients"] = table;
    ship["current_coefficients"]["alone_until"] = json!("4 kn");
    ship["current_coefficients"]["gone_from"] = json!("7 kn");
    full["line"]["of its own"] = json!({
        "from": "d", "fairlead": [70, 2], "to": "b", "bollard": [0, 0], "rope": "own", "axial_stiffness": "20 MN",
        "break_load": "1000 kN", "working_load": "500 kN", "mass": "5 kg/m",
        "on_deck": { "length": "20 m", "friction": 0.2, "wrap": "60 deg" },
        "tail": { "rope": "own", "load_extension": "rope.csv", "break_load": "1300 kN" }, "length": 700
    });
    full["line"]["by a curve"] = json!({
        "from": "d", "fairlead": [70, 2], "to": "b", "bollard": [0, 0], "rope": "own", "load_extension": "rope.csv",
        "break_load": "1000 kN", "length": 700,
        "tail": { "rope": "own", "axial_stiffness": "5 MN", "break_load": "1300 kN" }
    });
}

/// The files that the scenarios name.
fn file_named(name: &str) -> Result<String, String> {
    let text = match name {
        "tide.csv" => "t_s,level_m\n0,1\n3600,-0.5\n",
        "long_waves.csv" => "t_s,level_m,north_mps,east_mps\n0,0,0,0\n10,0.1,0.2,0\n",
        "wind.csv" => "t_s,speed_mps,from_deg\n0,10,350\n600,12,10\n",
        "quay.geojson" => {
            r#"{ "type": "FeatureCollection", "features": [{ "type": "Feature",
                "properties": { "OBJL": 71 }, "geometry": { "type": "Polygon",
                "coordinates": [[[1000, 500], [2000, 500], [2000, 900], [1000, 500]]] } }, { "type": "Feature",
                "properties": { "OBJL": 122, "OBJNAM": "Long Quay" }, "geometry": { "type": "LineString",
                "coordinates": [[1300, 500], [1700, 500]] } }] }"#
        }
        "harbour.geojson" => {
            r#"{ "type": "FeatureCollection", "features": [{ "type": "Feature",
                "properties": { "kind": "quay", "name": "quay 3" }, "geometry": { "type": "Polygon",
                "coordinates": [[[7.2, 54], [7.2, 54.01], [7.21, 54.01], [7.2, 54]]] } }, { "type": "Feature",
                "properties": { "kind": "depth_area", "depth_m": 30 }, "geometry": { "type": "Polygon",
                "coordinates": [[[7.16, 53.99], [7.2, 53.99], [7.2, 54.02], [7.16, 53.99]]] } }, { "type": "Feature",
                "properties": { "OBJL": 71 }, "geometry": { "type": "Polygon",
                "coordinates": [[[7.3, 54], [7.3, 54.01], [7.31, 54.01], [7.3, 54]]] } }, { "type": "Feature",
                "properties": { "OBJL": 122 }, "geometry": { "type": "LineString",
                "coordinates": [[7.32, 54], [7.32, 54.01]] } }] }"#
        }
        "depths.asc" | "berth.asc" | "channel.xyz" => {
            "ncols 2\nnrows 2\nxllcorner -5000\nyllcorner -5000\ncellsize 5000\n30 30\n30 30\n"
        }
        "current.csv" => "north_m,east_m,north_mps,east_mps\n0,0,1,0\n0,9,1,1\n",
        // A binary glTF file without content, in base64: magic, version 2, length 12.
        "feeder.glb" => "Z2xURgIAAAAMAAAA",
        "response.csv" => {
            "omega_radps,heading_deg,heave_mpm,heave_phase_deg,roll_degpm,roll_phase_deg,pitch_degpm,\
             pitch_phase_deg\n0.5,0,1,180,0,0,1,90\n0.5,180,1,180,0,0,1,-90\n"
        }
        "forces.txt" => {
            "title\nAngle Run X Y N\n0 1 -90 0 0\n45 1 -60 -200 -900\n90 2 9 -390 100\n135 2 70 -190 900\n180 3 80 0 0\n"
        }
        "rope.csv" => "extension_percent,load_percent\n0,0\n5,40\n9,100\n",
        "ship.hydro" => include_str!("../../../hydrodynamics/barge_20m.hydro"),
        _ => return Err(format!("{name}: there is no such file")),
    };
    Ok(text.to_owned())
}

/// A scenario that uses most keys of the schema. Kept complete, with [`fulls`], by
/// `each_key_is_known_to_reader_and_schema`.
fn full() -> Json {
    let square = json!([[-1, -1], [1, -1], [1, 1], [-1, 1]]);
    with_rows(json!({
        "title": "All keys",
        "time": { "step": "0.1 s", "duration": 10, "integrator": "rk4" },
        "output": { "interval": "1 s", "tables": ["fenders", "lines"] },
        "contact": { "method": "paper" },
        "material": { "m": {
            "stiffness": "500 kN/m^2", "damping": 0, "shear_stiffness": "3 MN/m",
            "friction_static": 0.5, "friction_dynamic": 0.25, "restitution": 0.125
        } },
        "body": {
            "a": {
                "outline": square, "mass": "930 t", "gyradius": "8 m",
                "added_mass": { "surge": 0.5, "sway": 1, "yaw": 0.5 },
                "position": [0, "1 km"], "heading": "90 deg",
                "velocity": { "surge": "4 kn", "sway": -1, "yaw": "3 deg/s" }
            },
            "b": { "fixed": true, "outline": square },
            "on a pile": { "outline": square, "position": [0, 2500], "dolphin": pile() },
            "on a tube": { "outline": square, "position": [0, 2600], "dolphin": tubes() },
            "c": { "fixed": false, "outline": square, "mass": 1000, "yaw_inertia": "1e6 kg.m^2" },
            "d": { "outline": square, "vessel": "box ship", "position": [500, 0], "running": 0.25, "air_draught": "38 m" },
            "e": { "outline": square, "vessel": "tanker", "position": [900, 0] },
            "f": { "vessel": "container-ship", "position": [0, 900] },
            "g": { "vessel": "asd-tug", "position": [0, 1500] },
            "h": {
                "outlines": [{ "height": 0, "outline": square }, { "height": "12 m", "outline": square }],
                "draught": "5 m", "mass": 1000, "gyradius": 1, "position": [0, 1800]
            }
        },
        "chart": {
            "files": ["harbour.geojson"], "coordinates": "longitude_latitude", "projection": "utm",
            "clearance_datum": "3.2 m",
            "origin": { "latitude": "54 deg", "longitude": 0.125 }
        },
        "environment": {
            "depth": "30 m", "tide": { "level": 1, "constituent": [
                { "amplitude": "2 m", "period": "12.42 h", "lag": "90 deg" }
            ] },
            "water_density": 1025, "squat": "icorels",
            "wind": { "speed": "12 m/s", "from": "270 deg", "gusts": true, "gust_admittance": false, "seed": 3 },
            "current": { "speed": "1 kn", "towards": "10 deg" },
            "bank": [{ "from": [-500, 90], "to": [500, 90], "method": "image" }], "visibility": "500 m",
            "rain": "moderate", "start_time": "2026-06-21T05:30+02:00",
            "place": { "latitude": "53.5 deg", "longitude": "9.9 deg" },
            "interaction": { "between_vessels": true, "midship_coefficient": 0.95, "sections": "outline" },
            "waves": {
                "height": 1, "period": "8 s", "from": 0, "regular": false, "peakedness": 3.3,
                "spreading": 2, "seed": 1
            },
            "long_waves": {
                "height": 0.1, "period": "100 s", "towards": 0, "wall_distance": "300 m", "regular": false,
                "shortest_period": "50 s", "longest_period": "200 s", "peakedness": 2, "seed": 1
            }
        },
        "vessel": {
            "box ship": {
                "length_bp": 150, "beam": 25, "draught": 8, "block_coefficient": 0.7,
                "centre_of_gravity": -1, "gyradius": 37,
                "propeller": { "diameter": 5, "full": "100 rpm", "reversal": "40 s" },
                "rudder": { "area": 25, "span": 6, "rate": "2.5 deg/s", "stop": "35 deg" },
                "thruster": { "bow": { "along": 60, "force": "150 kN", "lag": 5 } },
                "azimuth": { "port": {
                    "along": -70, "across": 2, "force": "300 kN", "diameter": 3, "rate": "12 deg/s",
                    "lag": 4, "stop": "170 deg"
                } },
                "windage": {
                    "method": "blendermann", "frontal_area": 500, "lateral_area": 2000,
                    "length_overall": 160, "centroid_forward": 1, "centroid_height": 10, "type": "ferry"
                },
                "wave_response": "response.csv",
                "stability": { "gm": 1.5, "gravity_above_keel": 10, "waterplane_area": 3000 },
                "kind": "container", "conning": { "at": [-40, 0], "eye_height": "22 m" },
                "model": "feeder.glb"
            },
            "tanker": {
                "from": "kvlcc2", "propeller": { "full": "106 rpm" },
                "windage": {
                    "method": "isherwood", "frontal_area": 1200, "lateral_area": 4000,
                    "centroid_height": 8, "perimeter": 500, "superstructure_area": 700,
                    "mast_groups": 2
                }
            },
            "other tanker": {
                "from": "kvlcc2",
                "windage": {
                    "method": "fujiwara", "frontal_area": 1200, "lateral_area": 4000,
                    "centroid_height": 8, "deck_area": 900, "deck_centroid_forward": -120,
                    "top_height": 40
                }
            }
        },
        "tug": { "one": {
            "vessel": "d", "bollard_pull": "60 tf", "push_at": [60, -12], "pull_at": [70, 0],
            "length": 30, "beam": 12, "draught": 4, "delay": 3, "lag": 8
        } },
        "line": {
            "spring": {
                "from": "d", "fairlead": [70, 2], "fairlead_height": 8, "to": "b", "bollard": [0, 0],
                "bollard_height": 3, "rope": "hmpe", "break_load": "1000 kN",
                "tail": { "rope": "nylon", "break_load": "1300 kN", "length": 11 },
                "pretension": "50 kN", "winch": true, "made_fast": 3,
                "constant_tension": {
                    "tension": "50 kN", "band": 0.2, "heaving_speed": "0.2 m/s", "paying_out_speed": "0.3 m/s"
                }
            },
            "breast": {
                "from": "d", "fairlead": [70, 2], "to": "b", "bollard": [0, 0], "rope": "wire",
                "break_load": "1000 kN", "length": 700
            },
            "between ships": {
                "from": "f", "chock": "head-starboard", "to": "g", "bitts": "fore", "rope": "wire",
                "break_load": "1000 kN", "pretension": "50 kN"
            },
            "on board": {
                "from": "d", "fairlead": [70, 2], "rope": "wire", "break_load": "1000 kN", "rope_length": 180
            }
        },
        "passing": {
            "straight": {
                "length": 185, "beam": "26 m", "draught": 7, "midship_coefficient": 0.97, "sections": "outline",
                "outline": [[-92, -13], [92, 0], [-92, 13]], "position": [0, "9 km"], "heading": "90 deg",
                "speed": "8 kn", "time": "5 s", "depth_factors": "kriebel", "berth": "quay"
            },
            "bent": {
                "vessel": "kcs", "waypoints": [[-2000, 9000], [0, 9000], [2000, 9900]], "turning_radius": "600 m",
                "speeds": [[0, "8 kn"], [5, "5 kn"]], "depth_factors": "none"
            }
        },
        "anchor": {
            "port": {
                "on": "d", "side": "port", "hawse": [60, -3], "hawse_height": "8 m", "mass": "8.3 t",
                "type": "high_holding_power", "chain_diameter": "76 mm", "grade": "u3",
                "chain_length": "11 shackles", "holding_factor": 7, "dragging_factor": 2, "chain_friction": 0.6,
                "brake": "2 MN", "placed": [650, 0], "chain_out": "8 shackles"
            },
            "starboard": {
                "on": "d", "side": "starboard", "hawse_height": 8, "mass": "8.3 t", "chain_diameter": "76 mm",
                "chain_length": "11 shackles"
            }
        },
        "bollard": { "first": { "on": "b", "at": [0, 0], "height": 3, "lines": 2 } },
        "line_handling": {
            "gangs": 1, "heaving_line": 25, "time": 70, "boat": true, "boat_speed": "2 kn"
        },
        "exercise": exercise(),
        "order": [
            { "vessel": "d", "at": "1 s", "rudder": "10 deg" },
            { "vessel": "d", "engine": 0.5 },
            { "vessel": "d", "telegraph": "half ahead" },
            { "vessel": "d", "thruster": { "name": "bow", "power": 0.5 } },
            { "vessel": "d", "azimuth": { "name": "port", "power": 0.5, "direction": "30 deg" } },
            { "vessel": "d", "push_ship": {
                "ship": "a", "at": [1, 0], "force": "100 kN", "speed": "1 kn"
            } },
            { "vessel": "d", "pull_ship": {
                "line": "spring", "force": "100 kN", "direction": "90 deg", "speed": "1 kn"
            } },
            { "vessel": "d", "follow_ship": {
                "ship": "a", "at": [40, 40], "heading": "90 deg", "speed": "1 kn"
            } },
            { "vessel": "d", "course": "10 deg" },
            { "vessel": "d", "speed": "4 kn" },
            { "vessel": "d", "station": {
                "position": [0, 0], "heading": 0, "surge": 0.5, "sway": 0.2
            } },
            { "vessel": "d", "hands": true },
            { "tug": "one", "push": "300 kN", "direction": "90 deg" },
            { "tug": "one", "pull": "300 kN" },
            { "tug": "one", "stand_by": true },
            { "line": "spring", "let_go": true },
            { "line": "on board", "send": { "bollard": "first" } },
            { "anchor": "starboard", "let_go_anchor": "3 shackles" },
            { "anchor": "starboard", "at": 60, "veer": "137.5 m" },
            { "anchor": "starboard", "hold_chain": true },
            { "anchor": "starboard", "heave_in": 0 },
            { "anchor": "port", "slip": true }
        ],
        "event": [
            { "at": "1 s", "wind": { "speed": "10 m/s", "from": "270 deg", "over": "1 min" } },
            { "current": { "speed": "1 kn", "towards": "90 deg", "over": "1 min" } },
            { "visibility": { "distance": "300 m", "over": "1 min" } },
            { "vessel": "d", "fault": "engine_lost", "ends": true },
            { "vessel": "d", "thruster_out": "bow" },
            { "line_parts": "spring" },
            { "tug_out": "one" }
        ],
        "fender": {
            "of a type": {
                "on": "b", "position": [1, 0], "facing": "-90 deg", "width": "2 m",
                "face_height": 3, "above_water": "2 m", "floating": true, "material": "m", "type": "cone", "height": "1.2 m",
                "rated_reaction": "900 kN", "count": 2, "temperature": 10, "tolerance": "-10 %",
                "velocity_factor": false, "angle_factor": true, "unloading_law": true, "hull": "large tanker",
                "rolling_resistance": 0.1
            },
            "of a size": {
                "on": "b", "position": [1, 0], "facing": 0, "width": 6.5, "material": "m",
                "type": "pneumatic", "size": "3300x6500 50kPa", "projection": 3.3
            },
            "linear": {
                "on": "b", "position": [1, 0], "facing": 0, "width": 1, "material": "m",
                "projection": 1, "stiffness": "2 MN/m", "rated_deflection": "0.5 m", "returned_energy": "60 %",
                "stop": { "from": "0.9 m", "stiffness": "50 MN/m" },
                "hull_pressure_limit": "200 kN/m^2"
            },
            "tabulated": {
                "on": "a", "position": [1, 0], "facing": 0, "width": 1, "material": "m",
                "projection": 1, "curve": [[0, 0], ["0.5 m", "600 kN"]],
                "unloading": [[0, 0], ["0.5 m", "300 kN"]]
            },
            "on cones": {
                "on": "b", "position": [1, 0], "facing": 0, "width": 4, "face_height": "3 m", "material": "m",
                "projection": 1, "stiffness": "2 MN/m",
                "cones": [{ "at": "-1 m" }, { "at": 1.2, "height": "0.6 m" }],
                "chains": [
                    { "kind": "tension", "at": "1.5 m", "slack": "20 mm", "stiffness": "40 MN/m", "break_load": "300 kN" },
                    { "kind": "shear", "length": "1.3 m", "span": "1.25 m", "stiffness": 4e7, "break_load": "300 kN" },
                    {
                        "kind": "shear", "length": "1.3 m", "span": "1.25 m", "diameter": "28 mm", "grade": "u2",
                        "link": "stud"
                    },
                    { "kind": "weight", "break_load": "300 kN" }
                ],
                "panel_mass": "2.5 t"
            },
            "on a belting": {
                "on": "g", "belting": "bow", "material": "m", "projection": 1
            },
            "by area": {
                "on": "a", "position": [1, 0], "facing": 0, "width": 1, "material": "m",
                "projection": 1
            }
        },
        "fender_files": [],
        "vessel_files": [],
        "provider": [
            { "body": "a", "command": ["python3", "x.py"], "timeout": "0.5 s", "hold": 2 }
        ],
        "report": {
            "project": "p", "client": "c", "number": "1", "revision": "B", "status": "draft", "date": "2026-11-23",
            "author": "x", "checked_by": "y"
        },
        "berthing": {
            "ship": "d", "length_bp": 285, "beam": "46 m", "draught": 9, "block_coefficient": 0.75,
            "under_keel_clearance": 3, "softness": "hard", "configuration": "semi_open",
            "abnormal_factor": 1.5, "added_mass": "ufc"
        },
        "pair": [
            { "bodies": ["a", "b"], "material": "m" },
            { "bodies": ["*", "*"], "material": "m" }
        ],
        "load": [
            { "body": "a", "force": [0, "-5 kN"], "moment": "1 kN.m", "from": "1 s", "until": 1000 },
            { "body": "c", "moment": 1 }
        ]
    }))
}

/// Whether reader and schema accept a document; they must agree.
#[track_caller]
fn accepted(document: &Json) -> bool {
    let by_schema = VALIDATOR.with(|validator| validator.validate(document).is_ok());
    let by_reader = Scenario::parse_among(&toml_of(document), "x.toml", &[], &mut file_named);
    assert_eq!(by_schema, by_reader.is_ok(), "{document}\n{:?}", by_reader.err());
    by_schema
}

#[test]
fn a_scenario_with_every_key_is_accepted() {
    for document in fulls() {
        Scenario::parse_among(&toml_of(&document), "x.toml", &[], &mut file_named).unwrap();
        assert!(accepted(&document));
    }
}

#[test]
fn each_key_is_known_to_reader_and_schema() {
    let (schema, documents) = (schema(), fulls());
    let mut paths = Vec::new();
    collect_keys(&schema, &mut Vec::new(), &mut paths);
    assert!(paths.len() > 35, "the walk finds the keys");
    for path in paths {
        let (document, holders) = first_holders(&documents, &path);
        // All tables of a kind are read by the same keys; which keys they need depends on what else they have.
        misspelt_is_refused(document, &holders[0]);
        wrong_kind_is_refused(document, &holders[0]);
        for pointer in holders {
            absent_agrees(document, &pointer);
        }
    }
}

/// The first document that has a path, and the pointers to it there.
fn first_holders<'d>(documents: &'d [Json], path: &[String]) -> (&'d Json, Vec<String>) {
    let there = documents.iter().find_map(|document| {
        let mut holders = holders(document, path);
        holders.retain(|pointer| document.pointer(pointer).is_some());
        (!holders.is_empty()).then_some((document, holders))
    });
    there.unwrap_or_else(|| panic!("{} is not in the full scenarios", path.join(".")))
}

/// Paths of all keys of a schema; `*` stands for a name or a number.
fn collect_keys(schema: &Json, path: &mut Vec<String>, paths: &mut Vec<Vec<String>>) {
    for (name, inner) in schema["properties"].as_object().unwrap_or(&Map::new()) {
        path.push(name.clone());
        paths.push(path.clone());
        collect_keys(inner, path, paths);
        for each in ["additionalProperties", "items"] {
            if inner[each].is_object() {
                path.push("*".to_owned());
                collect_keys(&inner[each], path, paths);
                path.pop();
            }
        }
        path.pop();
    }
}

/// JSON pointers in a document that a path with `*` may mean.
fn holders(document: &Json, path: &[String]) -> Vec<String> {
    path.iter().fold(vec![String::new()], |pointers, name| {
        let below = |pointer: String| match (name.as_str(), document.pointer(&pointer)) {
            ("*", Some(Json::Object(map))) => {
                map.keys().map(|key| format!("{pointer}/{key}")).collect()
            }
            ("*", Some(Json::Array(items))) => {
                (0..items.len()).map(|index| format!("{pointer}/{index}")).collect()
            }
            _ => vec![format!("{pointer}/{name}")],
        };
        pointers.into_iter().flat_map(below).collect()
    })
}

fn parent_of<'d>(document: &'d mut Json, pointer: &str) -> (&'d mut Map<String, Json>, String) {
    let (parent, name) = pointer.rsplit_once('/').unwrap();
    let parent = document.pointer_mut(parent).and_then(Json::as_object_mut).unwrap();
    (parent, name.to_owned())
}

#[track_caller]
fn misspelt_is_refused(document: &Json, pointer: &str) {
    let mut changed = document.clone();
    let (parent, name) = parent_of(&mut changed, pointer);
    let value = parent.remove(&name).unwrap();
    parent.insert(format!("{name}x"), value);
    assert!(!accepted(&changed), "{pointer}x is accepted");
}

#[track_caller]
fn absent_agrees(document: &Json, pointer: &str) {
    let mut changed = document.clone();
    let (parent, name) = parent_of(&mut changed, pointer);
    parent.remove(&name);
    // Other keys may refer to the absent one or be compared with it, which only the reader checks.
    let referred_to = [
        "/material",
        "/body/b/fixed",
        "/material/m/friction_static",
        "/vessel",
        "/tug",
        "/line",
        "/anchor",
        // An anchor needs a bottom, and its chain reaches it from her place.
        "/body/d/position",
        "/environment",
        "/environment/depth",
        "/bollard",
        "/vessel/box ship/thruster",
        // The file has what they say.
        "/vessel/box ship/wind_coefficients/columns",
        "/vessel/box ship/wind_coefficients/skip_lines",
        "/vessel/box ship/current_coefficients/columns",
        "/vessel/box ship/current_coefficients/skip_lines",
        // Not every vessel has an outline.
        "/body/d/outline",
        "/vessel/box ship/azimuth",
        "/pair",
        // The fenders that a ship approaches.
        "/fender_row",
        "/fender_row/row of a size",
    ]
    .contains(&pointer);
    if !referred_to {
        accepted(&changed);
    }
}

#[track_caller]
fn wrong_kind_is_refused(document: &Json, pointer: &str) {
    for wrong in [json!([true]), json!({ "x": 1 }), json!("")] {
        let mut changed = document.clone();
        *changed.pointer_mut(pointer).unwrap() = wrong;
        assert!(!accepted(&changed), "{changed} is accepted");
    }
}

#[test]
fn bounds_words_and_rules_agree() {
    let cases = [
        ("/time/step", json!(0), false),
        ("/time/step", json!("fast"), false),
        ("/time/step", json!("1e-3 s"), true),
        ("/time/integrator", json!("euler"), true),
        ("/time/integrator", json!("leapfrog"), false),
        ("/contact/method", json!("coupled"), true),
        ("/contact/method", json!("impulse"), false),
        ("/material/m/restitution", json!(1), true),
        ("/material/m/restitution", json!(1.5), false),
        ("/material/m/stiffness", json!(-1), false),
        ("/material/m/stiffness", json!(1e16), false),
        ("/body/a/position", json!([0]), false),
        ("/body/a/position", json!([0, 1e9]), false),
        ("/body/a/outline", json!([[0, 0], [1, 0]]), false),
        ("/body/a/fixed", json!(true), false),
        ("/body/b/mass", json!(1000), false),
        ("/body/b/velocity", json!({}), false),
        ("/body/a/yaw_inertia", json!(1e6), false),
        ("/body/*", json!({}), false),
        ("/pair/0/bodies", json!(["a"]), false),
        ("/pair/0/bodies", json!(["a", "b", "c"]), false),
        ("/pair/0/bodies", json!(["a", ""]), false),
        ("/load", json!([]), true),
        ("/load/0", json!({ "body": "a" }), false),
        ("/load/0", json!({ "body": "a", "force": [1, 2] }), true),
    ];
    for (pointer, value, good) in cases {
        let mut document = full();
        let (parent, name) = match pointer {
            "/load/0" => {
                document["load"][0] = value;
                assert_eq!(accepted(&document), good, "{pointer}");
                continue;
            }
            _ => parent_of(&mut document, pointer),
        };
        parent.insert(name, value);
        assert_eq!(accepted(&document), good, "{pointer}");
    }
}

/// Every example that the schema shows is accepted in the place that it is an example of.
#[test]
fn examples_are_accepted() {
    let (schema, documents) = (schema(), fulls());
    let mut paths = Vec::new();
    collect_keys(&schema, &mut Vec::new(), &mut paths);
    // These name bodies and materials of other scenarios.
    let names = [
        "bodies", "material", "body", "on", "ship", "vessel", "tug", "line", "from", "to",
        "thruster", "azimuth", "chock", "bitts", "belting",
    ];
    let mut tried = 0;
    for path in paths.iter().filter(|path| !names.contains(&path.last().unwrap().as_str())) {
        let key = path.iter().fold(&schema, |schema, name| match name.as_str() {
            "*" if schema["items"].is_object() => &schema["items"],
            "*" => &schema["additionalProperties"],
            name => &schema["properties"][name],
        });
        assert!(key["description"].is_string() && key["title"].is_string(), "{path:?}");
        let (document, holders) = first_holders(&documents, path);
        let pointer = holders.into_iter().next().unwrap();
        for example in key["examples"].as_array().into_iter().flatten().chain(key.get("default")) {
            let mut changed = document.clone();
            *changed.pointer_mut(&pointer).unwrap() = example.clone();
            // And a type of fender goes with its sizes; a file of fenders needs to be there.
            let conflicts = [
                "/material",
                "/body/b/fixed",
                "/material/m/friction_static",
                // Friction needs shear stiffness.
                "/material/m/shear_stiffness",
                "/fender/of a size/type",
                "/fender_row",
                "/fender_row/row of a size/type",
                "/fender_row/row of a size/exception/row of a size_1/type",
                "/fender_files",
                "/vessel_files",
                // And each method of wind coefficients with its own particulars.
                "/vessel/box ship/windage/method",
                // A regular wave has no spreading and no seed.
                "/environment/waves/regular",
                "/environment/long_waves/regular",
                // Shorter than the distance of its ends.
                "/line/breast/length",
                // A point at the side of another ship, and another ship than the point is at.
                "/pair",
                "/order/5/push_ship/at",
                "/order/5/push_ship",
                "/body/a/outline",
                "/bollard",
                "/anchor",
                "/environment",
                // The depth of a sea may be more than a chain is long.
                "/environment/depth",
                "/order/16/send/bollard",
                // A berth has fenders.
                "/exercise/vessel",
                "/exercise/berth",
                "/exercise/lines",
                "/exercise/anchors",
                // A boat's speed goes with a boat.
                "/line_handling/boat",
                // A table of coefficients has its file, its columns and the keys of its convention.
                "/vessel/box ship/wind_coefficients/file",
                "/vessel/box ship/wind_coefficients/columns",
                "/vessel/box ship/wind_coefficients/convention",
                "/vessel/box ship/wind_coefficients/quantity",
                "/vessel/box ship/current_coefficients/file",
                "/vessel/box ship/current_coefficients/columns",
                "/vessel/box ship/current_coefficients/convention",
                "/vessel/box ship/current_coefficients/quantity",
                // A constant tension goes with a winch.
                "/line/spring/winch",
                // A survey has the coordinates that it has.
                "/environment/bottom/survey_coordinates",
            ];
            if !conflicts.contains(&pointer.as_str()) {
                assert!(accepted(&changed), "{pointer} = {example}");
                tried += 1;
            }
        }
    }
    assert!(tried > 30);
}

/// A TOML text as JSON.
fn json_of(text: &str) -> Json {
    fn value(node: &DeValue<'_>) -> Json {
        match node {
            DeValue::String(text) => json!(text),
            DeValue::Integer(number) => serde_json::from_str(number.as_str()).unwrap(),
            DeValue::Float(number) => serde_json::from_str(number.as_str()).unwrap(),
            DeValue::Boolean(flag) => json!(flag),
            DeValue::Datetime(time) => json!(time.to_string()),
            DeValue::Array(items) => items.iter().map(|item| value(item.get_ref())).collect(),
            DeValue::Table(map) => table(map),
        }
    }
    fn table(map: &DeTable<'_>) -> Json {
        let entries =
            map.iter().map(|(key, node)| (key.get_ref().to_string(), value(node.get_ref())));
        Json::Object(entries.collect())
    }
    table(DeTable::parse(text).unwrap().get_ref())
}

/// A JSON document as TOML: one inline value a line.
fn toml_of(document: &Json) -> String {
    fn value(json: &Json) -> String {
        match json {
            Json::Object(map) => {
                let entries = map.iter().map(|(key, inner)| format!("{key:?} = {}", value(inner)));
                format!("{{ {} }}", entries.collect::<Vec<_>>().join(", "))
            }
            Json::Array(items) => {
                format!("[{}]", items.iter().map(value).collect::<Vec<_>>().join(", "))
            }
            other => other.to_string(),
        }
    }
    let lines = document.as_object().unwrap().iter();
    lines.map(|(key, inner)| format!("{key} = {}\n", value(inner))).collect()
}
