//! Notices of what can be computed but is hardly meant.

use fenderline_scenario::{Override, Scenario, ScenarioError};

const TEXT: &str = r#"[time]
step = "0.1 s"
duration = "20 s"

[environment]
depth = "12 m"

[material.facing]
stiffness = 0

[material.concrete]
stiffness = "50 MN/m^2"

[body.ship]
outline = [[-100, -16], [100, -16], [100, 16], [-100, 16]]
mass = "39000 t"
gyradius = "50 m"

[body.quay]
fixed = true
outline = [[-100, 0], [100, 0], [100, 9], [-100, 9]]
position = [0, 20]

[fender_row.a]
on = "quay"
first = [-60, 0]
spacing = "20 m"
number = 7
width = "2.4 m"
face_height = "3 m"
above_water = "1 m"
type = "cone"
height = "1.2 m"
material = "facing"

[[pair]]
bodies = ["ship", "quay"]
material = "concrete"

[berthing]
ship = "ship"
length_bp = "192 m"
beam = "32 m"
draught = "9.5 m"
under_keel_clearance = "2.5 m"
block_coefficient = 0.65
"#;

fn with(settings: &[&str]) -> Result<Scenario, ScenarioError> {
    let overrides: Vec<_> = settings.iter().map(|text| Override::parse(text).unwrap()).collect();
    Scenario::parse_with(TEXT, "x.toml", &overrides)
}

/// The only notice is about `key` and has `fragment` in it.
#[track_caller]
fn noted(settings: &[&str], key: &str, fragment: &str) {
    let notices = with(settings).unwrap_or_else(|error| panic!("{error}")).notices;
    let [notice] = notices.as_slice() else { panic!("{settings:?}: {notices:?}") };
    assert_eq!(notice.key, key, "{notice}");
    assert!(notice.message.contains(fragment), "{notice}");
}

#[test]
fn a_sound_scenario_has_no_notices() {
    assert_eq!(with(&[]).unwrap().notices, []);
}

/// 1025 kg/m³ over 6400 m²: 39,000 kg is a draught of 5.9 mm. The berthing's displacement tells too.
#[test]
fn kilograms_for_tonnes() {
    let notices = with(&["body.ship.mass=39000 kg"]).unwrap().notices;
    let about = |key: &str| {
        let found = notices.iter().find(|notice| notice.key == key);
        found.unwrap_or_else(|| panic!("{notices:?}")).message.as_str()
    };
    let mass = about("body.ship.mass");
    assert!(
        mass.contains("39 t over the 6400 m² of the outline is a draught of 0.00595 m"),
        "{mass}"
    );
    assert!(mass.contains("tonnes, \"t\", in place of kilograms?"), "{mass}");
    assert!(about("berthing.block_coefficient").contains("displace 38900 t"));
    assert_eq!(notices.len(), 2);
}

/// 192 · 32 · 9.5 · 0.5 · 1025 kg/m³ = 29,900 t.
#[test]
fn a_block_coefficient_that_does_not_fit_the_mass() {
    let key = "berthing.block_coefficient";
    noted(
        &["berthing.block_coefficient=0.5"],
        key,
        "displace 29900 t, but \"ship\" has a mass of 39000 t",
    );
    noted(&["berthing.block_coefficient=0.5"], key, "a block coefficient of 0.652 would fit");
    let shallow = ["berthing.draught=5", "berthing.under_keel_clearance=7"];
    noted(&shallow, key, "displace 20500 t");
    assert_eq!(with(&["berthing.block_coefficient=0.7"]).unwrap().notices, [], "within a tenth");
}

#[test]
fn particulars_of_another_ship() {
    let more = ["berthing.length_bp=120", "berthing.block_coefficient=1"];
    noted(
        &more,
        "berthing.length_bp",
        "the outline of \"ship\" measures 200 m, but 120 m is given",
    );
    let more = ["berthing.beam=22", "berthing.block_coefficient=0.94"];
    noted(&more, "berthing.beam", "the outline of \"ship\" measures 32 m, but 22 m is given");
}

#[test]
fn a_fender_under_the_seabed_or_far_from_the_water() {
    let error = with(&["fender_row.a.above_water=-30 m"]).unwrap_err();
    assert_eq!(error.key(), Some("fender_row.a.above_water"));
    assert!(error.message().contains("30 m below the water, under the seabed at 12 m"), "{error}");
    let key = "fender_row.a.above_water";
    noted(
        &["fender_row.a.above_water=-11 m"],
        key,
        "reaches 12.5 m below the water, under the seabed at 12 m",
    );
    noted(&["fender_row.a.above_water=25 m"], key, "25 m above the water");
    let without_depth =
        TEXT.replace("[environment]\ndepth = \"12 m\"\n", "").replace("\"1 m\"", "\"-30 m\"");
    let notices = Scenario::parse(&without_depth, "x.toml").unwrap().notices;
    assert!(notices[0].message.contains("30 m below the water"), "{notices:?}");
}

#[test]
fn faces_that_overlap_are_noted_once_for_each_two() {
    let wide = "fender.a_3.width=40 m";
    let notices = with(&[wide]).unwrap().notices;
    let messages: Vec<_> = notices.iter().map(|notice| notice.message.as_str()).collect();
    assert_eq!(
        messages,
        [
            "the face of \"a_3\" overlaps that of \"a_2\" by 1.2 m",
            "the face of \"a_4\" overlaps that of \"a_3\" by 1.2 m"
        ]
    );
    // One above the other do not.
    let higher = ["fender.a_3.width=40 m", "fender.a_3.above_water=4.5 m"];
    assert_eq!(with(&higher).unwrap().notices, []);
}

/// 0.585 kN where a cone of 1.2 m has some 900 kN; a curve in newtons in place of kilonewtons.
#[test]
fn newtons_for_kilonewtons() {
    let key = "fender_row.a.rated_reaction";
    noted(
        &["fender_row.a.rated_reaction=585"],
        key,
        "a rated reaction of 0.585 kN at a height of 1.2 m",
    );
    noted(&["fender_row.a.rated_reaction=585"], key, "\"585 kN\" in place of 585 N?");
    noted(&["fender_row.a.rated_reaction=585 N"], key, "from 14.4 to 144000 kN was expected");
    assert_eq!(with(&["fender_row.a.rated_reaction=585 kN"]).unwrap().notices, []);
    assert_eq!(with(&["fender_row.a.rated_reaction=60 tf"]).unwrap().notices, []);
    let own = |law: &str| {
        let laws = format!("projection = \"1 m\"\n{law}");
        let text = TEXT.replace("type = \"cone\"\nheight = \"1.2 m\"", &laws);
        let notices = Scenario::parse(&text, "x.toml").unwrap().notices;
        notices
            .iter()
            .map(|notice| format!("{}: {}", notice.key, notice.message))
            .collect::<String>()
    };
    let weak = own("curve = [[0, 0], [0.35, 700], [0.7, 700]]");
    assert!(
        weak.starts_with("fender_row.a.curve: a rated reaction of 0.7 kN at a projection"),
        "{weak}"
    );
    assert!(own("stiffness = 900").starts_with("fender_row.a.stiffness: "));
    assert_eq!(own("stiffness = \"900 kN/m\""), "");
    let long = own("curve = [[0, 0], [\"0.7 m\", \"700 kN\"], [\"1.1 m\", \"900 kN\"]]");
    assert!(long.contains("goes on to a deflection of 1.1 m, but the face is only 1 m"), "{long}");
}

#[test]
fn a_face_nearer_to_the_quay_than_the_fender_is_high() {
    let key = "fender_row.a.projection";
    noted(
        &["fender_row.a.projection=0.9 m"],
        key,
        "is 0.9 m from the mounting, but the fender itself is 1.2 m high",
    );
    assert_eq!(with(&["fender_row.a.projection=1.5 m"]).unwrap().notices, []);
    let high = with(&["fender_row.a.height=10 m"]).unwrap().notices;
    assert!(
        high[0].message.contains("10 m high is higher than the fenders of catalogues"),
        "{high:?}"
    );
}

/// 39,000 t in 192 m by 32 m by 9.5 m: she has perhaps 4 to 6 m of side above the water.
#[test]
fn a_face_where_no_side_may_be() {
    let key = "fender_row.a.above_water";
    noted(
        &["fender_row.a.above_water=9 m"],
        key,
        "7.5 to 10.5 m above the water, and \"ship\" draws 9.5 m",
    );
    noted(&["fender_row.a.above_water=9 m"], key, "or give `outlines`");
    assert_eq!(with(&["fender_row.a.above_water=6 m"]).unwrap().notices, []);
    let with_tide = ["fender_row.a.above_water=9 m", "environment.tide={level = \"5 m\"}"];
    let notices = with(&with_tide).unwrap().notices;
    assert!(notices.iter().all(|notice| notice.key != key), "high water: {notices:?}");
}

/// Her displacement over her outline is 39,000 t / (1.025 t/m³ · 6400 m²) = 5.9 m.
#[test]
fn less_water_than_she_draws() {
    let about = |settings: &[&str]| {
        let notices = with(settings).unwrap().notices;
        let found = notices.iter().find(|notice| notice.key == "environment.depth");
        found.map(|notice| notice.message.clone()).unwrap_or_default()
    };
    let message = about(&["environment.depth=8 m"]);
    assert!(
        message
            .starts_with("there are 8 m of water at the lowest level, but \"ship\" draws 9.5 m:"),
        "{message}"
    );
    assert!(
        about(&["environment.depth=11 m", "environment.tide={level = \"-2 m\"}"])
            .contains("9 m of water")
    );
    assert_eq!(about(&["environment.depth=9.6 m"]), "");
    let (without_study, _) = TEXT.split_once("[berthing]").unwrap();
    let text = without_study.replace("depth = \"12 m\"", "depth = \"5 m\"");
    let notices = Scenario::parse(&text, "x.toml").unwrap().notices;
    assert!(
        notices[0].message.contains("draws 5.945 m or more, which follows from her mass"),
        "{notices:?}"
    );
}

#[test]
fn a_clearance_that_does_not_make_up_the_depth() {
    let key = "berthing.under_keel_clearance";
    noted(
        &["berthing.under_keel_clearance=8 m"],
        key,
        "8 m is given, but `environment.depth` with the tide, 12 m, less the draught of 9.5 m is 2.5 m",
    );
    noted(&["environment.depth=16 m"], key, "with the tide, 16 m, less");
}

/// The scenarios of the repository are plausible, but for those that reproduce an example which is not.
#[test]
fn the_scenarios_of_the_repository_have_no_such_notices() {
    fn toml_files(folder: &std::path::Path, found: &mut Vec<std::path::PathBuf>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                toml_files(&path, found);
            } else if path.extension().is_some_and(|extension| extension == "toml") {
                found.push(path);
            }
        }
    }
    let mut files = Vec::new();
    toml_files(
        &std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios"),
        &mut files,
    );
    files.sort();
    let mut told = Vec::new();
    for file in files {
        let name = file.file_name().unwrap().to_string_lossy().into_owned();
        let keys = [
            ".mass",
            ".above_water",
            ".width",
            ".number",
            "berthing.",
            ".rated_reaction",
            ".curve",
            ".stiffness",
            ".projection",
            ".height",
            "environment.depth",
        ];
        let notices = Scenario::load(&file, &[]).unwrap().notices;
        // She goes aground there on purpose.
        let is_meant =
            |key: &str| name == "aground_at_low_water.toml" && key == "environment.depth";
        let about = notices.iter().filter(|notice| {
            keys.iter().any(|key| notice.key.contains(key)) && !is_meant(&notice.key)
        });
        told.extend(about.map(|notice| format!("{name}: {}: {}", notice.key, notice.message)));
    }
    assert_eq!(told, Vec::<String>::new());
}
