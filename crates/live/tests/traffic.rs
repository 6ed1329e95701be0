//! Traffic on tracks, and ships with their own pilots.

use crate::support;

use fenderline_live::Session;
use fenderline_live::message::{Role, RunState};
use support::{go, open};

const FAIRWAY: &str = "scenarios/live/two_pilots_in_a_fairway.toml";
const KNOT_MPS: f64 = 1852.0 / 3600.0;

fn traffic(session: &Session) -> Vec<[f64; 6]> {
    let seen = session.frame(0, RunState::default()).traffic.into_iter();
    seen.map(|ship| ship.expect("no fog")).collect()
}

#[test]
fn traffic_follows_its_track_at_its_speed_and_is_in_every_frame() {
    let mut session = open(FAIRWAY, &[]);
    assert_eq!(session.cast().other_ships(), ["coaster"]);
    let names: Vec<&str> = session.info().traffic.iter().map(|ship| &*ship.name).collect();
    let container_ship = names.iter().position(|name| *name == "container_ship").expect("a ship");
    for _ in 0..3 {
        let t_s = session.simulation().time_s();
        // The container ship is on her first leg: straight north at 11 knots from the first waypoint.
        let [north_m, east_m, heading_rad, north_mps, east_mps, _] =
            traffic(&session)[container_ship];
        assert!((north_m - (-1500.0 + 11.0 * KNOT_MPS * t_s)).abs() < 1e-6, "{north_m}");
        assert!((east_m + 230.0).abs() < 1e-6 && heading_rad.abs() < 1e-9);
        assert!((north_mps - 11.0 * KNOT_MPS).abs() < 1e-9 && east_mps.abs() < 1e-9);
        go(&mut session, 150);
    }
    let alarms = session.alarms().messages();
    assert!(alarms.iter().all(|alarm| !alarm.key.starts_with("collision")), "{alarms:?}");
}

#[test]
fn a_ship_that_runs_into_traffic_has_an_alarm() {
    let across = "passing.ferry.waypoints=[[-850, -80], [-850, 300]]";
    let mut session = open(FAIRWAY, &[across, "passing.ferry.time=0"]);
    go(&mut session, 200);
    let alarms = session.alarms().messages();
    let hit = alarms.iter().find(|alarm| alarm.key == "collision bulker ferry");
    assert_eq!(hit.map(|alarm| &*alarm.text), Some("bulker collides with ferry"), "{alarms:?}");
}

#[test]
fn fog_hides_traffic_from_the_pilot_alone() {
    let session = open(FAIRWAY, &["environment.visibility=\"300 m\""]);
    let all = session.frame(0, RunState::default());
    let seen = session.in_fog(&all, &Role::PILOT).expect("something is hidden");
    let hidden = seen.traffic.iter().filter(|ship| ship.is_none()).count();
    assert!(hidden > 0, "{:?}", seen.traffic);
    assert_eq!(seen.visibility_m, Some(300.0));
    assert_eq!(session.in_fog(&all, &Role::Instructor), None);
}
