//! What the view out of the window gets: heights, families, sea and time, against the set-up of the run.

use crate::support;

use fenderline_contact::{Rotation, vec2};
use fenderline_live::message::{Frame, LineEndInfo, RunState};
use fenderline_live::{Session, Source};
use serde_json::{Value, json};

fn frame(session: &Session) -> Frame {
    session.frame(0, RunState::default())
}

#[test]
fn fenders_bollards_and_lines_have_the_heights_of_the_run() {
    let session = support::open("scenarios/live/berthing.toml", &[]);
    let (setup, info) = (session.simulation().setup(), session.info());
    for (fender, shown) in setup.fenders.iter().zip(&info.fenders) {
        assert_eq!(
            (shown.height_m, shown.above_water_m, shown.floating),
            (fender.height_m, fender.above_water_m, fender.floating)
        );
    }
    let cones = info.fenders.iter().filter(|fender| fender.family.as_deref() == Some("cone"));
    assert_eq!(
        cones.count(),
        4,
        "the quay's fenders are of the family cone; the tugs' are of none"
    );
    for (line, shown) in setup.world.lines.iter().zip(&info.lines) {
        assert_eq!(shown.fairlead_above_water_m, line.fairlead_above_water_m);
    }
    assert!(info.lines.iter().any(|line| line.fairlead_above_water_m == 6.0));
    for (bollard, shown) in setup.world.bollards.iter().zip(&info.bollards) {
        assert_eq!(shown.above_water_m, bollard.above_water_m);
    }
    let moored = support::open("scenarios/live/moored_while_a_ship_passes.toml", &[]);
    let ends = moored.info().lines.iter().filter_map(|line| line.end);
    let heights: Vec<f64> = ends
        .map(|end| match end {
            LineEndInfo::OnBody { above_water_m, .. } => above_water_m,
            LineEndInfo::Fixed { above_datum_m, .. } => above_datum_m,
        })
        .collect();
    assert!(!heights.is_empty() && heights.iter().all(|&height_m| height_m == 4.0), "{heights:?}");
}

#[test]
fn a_hull_by_outlines_at_several_heights_is_drawn_by_them_and_upright_sides_by_one_outline() {
    let session = support::open("scenarios/berth/bow_flare_on_a_fender.toml", &[]);
    let (setup, info) = (session.simulation().setup(), session.info());
    let ship = info.bodies.iter().position(|body| body.name == "ship").unwrap();
    let levels = &info.bodies[ship].levels;
    // Outlines at 2 m, 8 m and 16 m above the keel, and a draught of 8 m.
    let heights: Vec<f64> = levels.iter().map(|level| level.height_m).collect();
    assert_eq!(heights, [-6.0, 0.0, 8.0]);
    let hull = setup.bodies[ship].hull.as_ref().unwrap();
    for (shown, given) in levels.iter().zip(hull.levels()) {
        let given: Vec<[f64; 2]> = given.vertices_m.iter().map(|at| [at.x, at.y]).collect();
        assert_eq!(shown.outline, given);
    }
    // Vessels that heave and roll have upright sides by height: one outline says all.
    assert!(setup.bodies.len() > 1 && info.bodies[1 - ship].levels.is_empty());
    let berthing = support::open("scenarios/live/berthing.toml", &[]);
    assert!(berthing.info().bodies.iter().all(|body| body.levels.is_empty()));
}

/// The text that stands for a binary glTF file without content: magic, version 2, length 12.
const MODEL: &str = "Z2xURgIAAAAMAAAA";

fn with_model(key: &str, text: &str) -> Result<Session, String> {
    let path = support::repository("scenarios/live/harbour.toml");
    let toml = std::fs::read_to_string(&path).expect("the scenario");
    let toml = format!(
        "{toml}\n[vessel.modelled]\nfrom = \"bulk-carrier\"\n{key}\n[body.guest]\nvessel = \"modelled\"\nposition = [3000, 3000]\n"
    );
    let read = |file: &str| match file.strip_suffix(".glb") {
        Some(_) => Ok(text.to_owned()),
        None => fenderline_scenario::read_text(&path.with_file_name(file)),
    };
    let (source, _) =
        Source::collect("harbour.toml", toml, vec![], read).map_err(|error| error.to_string())?;
    Ok(Session::open(source).expect("a good set-up"))
}

#[test]
fn a_model_of_a_ship_is_kept_with_the_session_and_told_to_the_pages() {
    let mut session = with_model("model = \"guest.glb\"", MODEL).unwrap();
    let setup = session.simulation().setup();
    let guest = session.info().vessels.iter().position(|vessel| vessel.name == "guest").unwrap();
    let told = session.info().vessels[guest].model.clone().expect("a model");
    assert_eq!(told.file, "guest.glb");
    let other = with_model("model = \"guest.glb\"", "Z2xURgIAAAAQAAAAYm9keQ==").unwrap();
    let sum = other.info().vessels[guest].model.as_ref().map(|model| model.crc32);
    assert_ne!(sum, Some(told.crc32), "a changed file is told");
    // Midship, seen from the centre of gravity.
    let ahead_m = setup.world.vessels[guest].ship.particulars.centre_of_gravity_m;
    assert_eq!(told.origin_m, [-ahead_m, 0.0]);
    let bytes = |session: &Session| {
        let vessels = &session.simulation().setup().world.vessels;
        vessels[guest].looks.model.clone().expect("a model").bytes
    };
    assert_eq!(&*bytes(&session), b"glTF\x02\0\0\0\x0c\0\0\0");
    support::go(&mut session, 5);
    let again = support::replay(&support::saved(&mut session)).expect("a sound recording").session;
    assert_eq!(bytes(&again), bytes(&session), "the recording has the model");
    assert!(session.info().vessels.iter().filter(|vessel| vessel.model.is_some()).count() == 1);
}

#[test]
fn a_broken_model_is_refused_with_key_and_line() {
    let why = |key: &str, text: &str| with_model(key, text).expect_err("a refusal");
    let error = why("model = \"guest.glb\"", "UEsDBA==");
    for words in ["vessel.modelled.model", "does not begin with glTF", "harbour.toml:", "Blender"] {
        assert!(error.contains(words), "{words}: {error}");
    }
    let error = why("model = \"harbour.geojson\"", MODEL);
    assert!(error.contains("ends with .glb"), "{error}");
}

#[test]
fn a_panel_has_the_places_of_its_cones() {
    let session = support::open("scenarios/berth/two_cones_behind_one_panel.toml", &[]);
    let panel = &session.info().fenders[0];
    assert_eq!(
        panel.cones_m,
        session.simulation().setup().fenders[0].panel.as_ref().unwrap().cones_m
    );
    assert_eq!(panel.cones_m.len(), 2);
}

#[test]
fn the_water_stands_as_high_above_datum_as_the_tide_says() {
    let tide = "environment.tide={ level = \"1.8 m\" }";
    let session = support::open("scenarios/live/berthing.toml", &[tide]);
    assert_eq!(frame(&session).water_level_m, 1.8);
    let without = support::open("scenarios/live/berthing.toml", &[]);
    assert_eq!(frame(&without).water_level_m, 0.0);
}

#[test]
fn pages_are_told_the_highest_water_of_the_run_and_the_level_of_clearances() {
    let highest = |tide: &str| {
        let tide = format!("environment.tide={tide}");
        let session = support::open("scenarios/live/berthing.toml", &[&tide]);
        (session.info().highest_water_m, session.info().clearance_datum_m)
    };
    assert_eq!(highest("{ level = \"1.8 m\" }"), (1.8, None));
    // The tide is at its lowest when the run begins.
    let tide =
        "{ level = 2, constituent = [{ amplitude = 1.25, period = \"12 h\", lag = \"180 deg\" }] }";
    assert_eq!(highest(tide), (3.25, None));
    assert_eq!(support::under_bridge().info().clearance_datum_m, Some(2.0));
    // The view draws the bridge from this level up, whether a ship has an air draught or not.
    assert_eq!(support::before_bridge("").info().clearance_datum_m, Some(2.0));
}

/// The harmonics of the greeting add up to the sea that moves the ship, at bow, side and stern; the page's tests read the
/// same numbers.
#[test]
fn the_sea_of_the_greeting_is_the_sea_of_the_run() {
    let waves = "environment.waves={ height = \"1.5 m\", period = \"8 s\", from = \"300 deg\", spreading = 2, seed = 3 }";
    let mut session = support::open("scenarios/live/berthing.toml", &[waves]);
    support::go(&mut session, 600);
    let info = session.info();
    let simulation = session.simulation();
    let sea = simulation.setup().world.environment.sea.as_ref().expect("waves");
    let state = &simulation.states()[info.vessels[0].body];
    let t_s = simulation.time_s();
    let turn = Rotation::from_angle(state.heading_rad);
    let mut places: Vec<Value> = Vec::new();
    for at_m in [vec2(88.0, 0.0), vec2(0.0, 15.0), vec2(-80.0, -13.0)] {
        let place_m = state.position_m + turn.apply(at_m);
        let height_m = sea.elevation_m(place_m, t_s);
        let sum: f64 = info
            .sea
            .iter()
            .map(|[a, north, east, omega, phase]| {
                a * libm::cos(omega * t_s - north * place_m.x - east * place_m.y + phase)
            })
            .sum();
        assert!((sum - height_m).abs() < 1e-12, "{sum} {height_m}");
        places.push(json!([place_m.x, place_m.y, t_s, height_m]));
    }
    // She moves with this sea: heave is not squat.
    let heave_m = frame(&session).vessels[0].heave_m;
    let own = &simulation.vessels()[0];
    assert_eq!(heave_m, own.attitude.heave.value + own.wave_motion.motion[2]);
    // A map's keys would stand in an order that depends on what other crates ask of `serde_json`.
    let [places, sea] = [json!(places), json!(info.sea)].map(|value| value.to_string());
    let text = format!("{{\"places\":{places},\"sea\":{sea}}}");
    let path = support::repository("web/test/sea.json");
    if std::env::var_os("FENDERLINE_WRITE").is_some() {
        std::fs::write(&path, text.clone() + "\n").expect("the file is written");
    }
    let found = std::fs::read_to_string(&path).expect("web/test/sea.json");
    assert_eq!(
        found.trim_end(),
        text,
        "FENDERLINE_WRITE=1 cargo test -p fenderline-live --test all view:: writes web/test/sea.json"
    );
}

#[test]
fn a_scenario_says_where_and_when_she_sails_what_she_is_and_where_her_bridge_is() {
    let set = [
        "environment.start_time=\"2026-06-21T05:30+02:00\"",
        "vessel.bulker.kind=\"tanker\"",
        "vessel.bulker.conning={ at = [-60, 2], eye_height = \"24 m\" }",
    ];
    let place = "environment.place={ latitude = \"53.5 deg\", longitude = \"-9.5 deg\" }";
    let session = support::open("scenarios/live/berthing.toml", &[&set[..], &[place]].concat());
    let daylight = session.info().daylight.expect("a time");
    assert_eq!(daylight.start_unix_s, 1_782_012_600.0);
    assert!((daylight.longitude_rad.to_degrees() + 9.5).abs() < 1e-12);
    let vessel = &session.info().vessels[0];
    assert_eq!(vessel.kind, Some("tanker"));
    let conning = vessel.conning.expect("a place");
    let ahead_m =
        session.simulation().setup().world.vessels[0].ship.particulars.centre_of_gravity_m;
    assert_eq!(conning.at_m, [-60.0 - ahead_m, 2.0]);
    assert_eq!(conning.eye_above_water_m, 24.0);
    let rain = |set: &[&str]| support::open("scenarios/live/berthing.toml", set).info().rain;
    assert_eq!(rain(&["environment.rain=\"heavy\""]), Some("heavy"));
    assert_eq!(rain(&[]), None);
    assert!(support::open("scenarios/live/berthing.toml", &[]).info().daylight.is_none());
}
