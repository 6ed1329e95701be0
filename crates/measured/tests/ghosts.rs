//! Tracks for live sessions: a log of our own run gives the way of the run back.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::vec2;
use fenderline_measured::{
    BerthAxes, GhostError, GhostTrack, GhostWanted, Lie, Mapping, Motion, ghost, read_log,
};

use crate::support::{
    ANTENNA_M, Approach, Laser, Random, SENSORS, berth, docking_log, origin, run, track_log,
};

const QUIET: Laser = Laser { noise_m: 0.005, lost: 0.0, outliers: 0.0, pause_s: 0.0 };
const WANTED: GhostWanted = GhostWanted { number: 1, most_points: 2000 };

fn approach() -> Approach {
    let lie = Lie { along_m: 0.0, off_m: 26.0, angle_rad: 0.02 };
    let nearest = berth().axes.nearest(&lie).expect("abreast");
    let lie = Lie { off_m: lie.off_m + 10.0 - nearest.gap_m, ..lie };
    run(&Motion { lie, rates: [0.0, -0.12, 0.0] })
}

fn of(text: &str, mapping: &str, wanted: GhostWanted) -> Result<GhostTrack, GhostError> {
    let mapping = Mapping::parse(mapping, "mapping.toml").expect("a mapping");
    let read = read_log(text, "log.csv", &mapping, Some(&origin()));
    ghost(read, "log.csv", &mapping, &berth().axes, wanted)
}

fn antenna() -> String {
    format!("antenna = [{:?}, {:?}]\nposition_deviation = \"2 cm\"\n", ANTENNA_M.x, ANTENNA_M.y)
}

/// The largest distances of the points from the run, along and off the quay (m); the states of the run are 0.1 s apart and begin
/// `first_s` before the track.
fn farthest_m(track: &GhostTrack, approach: &Approach, first_s: f64) -> [f64; 2] {
    let axes = berth().axes;
    let mut most = [0.0; 2];
    for [t_s, north_m, east_m, heading_rad] in &track.points {
        let index = ((t_s + first_s) * 10.0).round() as usize;
        let state = &approach.states[index];
        let turned = (heading_rad - state.heading_rad + 1.0).rem_euclid(core::f64::consts::TAU);
        assert!((turned - 1.0).abs() < 0.01, "{heading_rad} {}", state.heading_rad);
        let (own, true_m) = (axes.in_axes(vec2(*north_m, *east_m)), axes.in_axes(state.position_m));
        for (most, (own, true_m)) in most.iter_mut().zip(own.into_iter().zip(true_m)) {
            *most = greater(*most, (own - true_m).abs());
        }
    }
    most
}

#[test]
fn a_track_gives_the_way_of_the_run_back() {
    let approach = approach();
    let text = track_log(&approach, 0.02, &mut Random::new(3));
    let track = of(&text, &antenna(), WANTED).expect("a track");
    // The ship lies at rest at the end and the track is moved to the fenders, which are compressed by some centimetres; the
    // antenna is 70 m off, so that 0.02° of its heading are 2 cm.
    let off_m = farthest_m(&track, &approach, 0.0);
    assert!(off_m[0] < 0.2 && off_m[1] < 0.4, "{off_m:?}");
    let touch_s = track.touch_s.expect("a touch");
    assert!((touch_s - approach.truth.t_s).abs() < 2.0, "{touch_s} {}", approach.truth.t_s);
    assert_eq!(track.of, 1);
    assert_eq!(track.outline_m, berth().axes.hull());
    // Thinned.
    let few = of(&text, &antenna(), GhostWanted { most_points: 50, ..WANTED }).expect("a track");
    assert!(few.points.len() <= 50 && few.points.len() > 20);
    assert_eq!(few.points.last(), track.points.last());
}

#[test]
fn a_docking_log_gives_the_way_of_the_run_back() {
    let approach = approach();
    let text = docking_log(&approach, QUIET, &mut Random::new(5));
    let track = of(&text, SENSORS, WANTED).expect("a track");
    // The first row is one of the first ten states. The place along the quay is not measured.
    let nearest = (0..10).map(|first| farthest_m(&track, &approach, f64::from(first) * 0.1)[1]);
    let off_m = nearest.fold(f64::INFINITY, lesser);
    assert!(off_m < 0.2, "{off_m}");
    let touch_s = track.touch_s.expect("a touch");
    assert!((touch_s - approach.truth.t_s).abs() < 2.0, "{touch_s} {}", approach.truth.t_s);
}

#[test]
fn tracks_of_another_place_and_numbers_that_are_not_there_are_named() {
    let approach = approach();
    let text = track_log(&approach, 0.02, &mut Random::new(3));
    let far = text.replace(",51.9", ",52.1");
    let error = of(&far, &antenna(), WANTED).expect_err("far away");
    assert!(matches!(error, GhostError::AnotherPlace { .. }), "{error:?}");
    let words = error.to_string();
    // 0.2° of latitude are 22.3 km.
    assert!(words.starts_with("log.csv: the track is of another place: it stays 22."), "{words}");
    let error = of(&text, &antenna(), GhostWanted { number: 2, ..WANTED }).expect_err("one only");
    assert_eq!(error.to_string(), "log.csv: number 2 is wanted, but the log has 1 track");
    let error = of("a,b\n1,2\n", "", WANTED).expect_err("no log");
    assert!(error.to_string().contains("log.csv:1: the log has no column of the time"), "{error}");
}

#[test]
fn a_track_without_a_touch_is_a_track() {
    let approach = approach();
    let text = track_log(&approach, 0.02, &mut Random::new(3));
    let until = approach.truth.t_s - 20.0;
    let rows = (until * 5.0) as usize;
    let short: String = text.lines().take(rows).flat_map(|line| [line, "\n"]).collect();
    let track = of(&short, &antenna(), WANTED).expect("a track");
    assert_eq!(track.touch_s, None);
    let off_m = farthest_m(&track, &approach, 0.0);
    assert!(off_m[0] < 0.2 && off_m[1] < 0.2, "{off_m:?}");
    // A berth for ships without a `[berthing]` is enough.
    let mut setup = berth().setup;
    setup.berthing = None;
    assert!(BerthAxes::of_ship(&setup, berth().axes.ship).is_ok());
}
