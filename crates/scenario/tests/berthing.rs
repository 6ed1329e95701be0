//! The berthing of `scenarios/berth/alongside_with_two_tugs.toml` runs as its comments describe.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::collections::BTreeSet;

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

const KNOT_MPS: f64 = 1852.0 / 3600.0;

/// She approaches at 4 knots and stops. Both tugs push. She touches all eight cones, none beyond its rating. Six lines
/// are made fast and hold. After the tugs stop pushing, the wind keeps her on the fenders.
#[test]
fn the_container_ship_comes_alongside_with_two_tugs_and_stays_there() {
    let text = include_str!("../../../scenarios/berth/alongside_with_two_tugs.toml");
    let scenario =
        Scenario::parse(text, "alongside.toml").unwrap_or_else(|error| panic!("{error}"));
    let fenders = scenario.setup.fenders.len();
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let (mut touched, mut pushed_n) = (BTreeSet::new(), [0.0_f64; 2]);
    let (mut at_end_n, mut fastest_at_touch_mps) = (f64::INFINITY, 0.0_f64);
    while !simulation.is_done() {
        let record = simulation.step().expect("a good step");
        let ship = &record.states[0];
        match record.t_s {
            t_s if t_s < 60.0 => {
                let knots = ship.velocity_mps.length() / KNOT_MPS;
                assert!((knots - 4.0).abs() < 0.3, "{knots} kn at {t_s} s");
            }
            t_s if t_s > 44.0 * 60.0 => {
                let press_n: f64 = record.contacts.iter().map(|c| c.normal_force_n).sum();
                at_end_n = at_end_n.min(press_n);
                assert!(ship.velocity_mps.length() < 0.02, "{ship:?}");
                assert!(ship.heading_rad.abs() < 0.5_f64.to_radians(), "{ship:?}");
                assert!(record.tugs.iter().all(|tug| tug.force.sway_n.abs() < 10e3));
                for line in record.lines {
                    let state = line.line.as_ref().map(|(_, state)| state.parted);
                    assert_eq!(state, Some(false), "made fast and not parted");
                }
            }
            _ => {}
        }
        if touched.is_empty() && !record.contacts.is_empty() {
            fastest_at_touch_mps = ship.velocity_mps.length();
        }
        touched.extend(record.contacts.iter().filter_map(|c| c.fender).map(|fender| fender.0));
        for (most_n, tug) in pushed_n.iter_mut().zip(record.tugs) {
            *most_n = most_n.max(tug.force.sway_n.abs());
        }
    }
    assert_eq!((fenders, touched.len()), (8, 8));
    assert!(fastest_at_touch_mps < 0.05, "{fastest_at_touch_mps} m/s");
    assert!(pushed_n.iter().all(|&most_n| most_n > 300e3), "{pushed_n:?}");
    assert!(at_end_n > 100e3, "{at_end_n} N on the fenders in the last minute");
    let over =
        simulation.fender_summaries().filter(|fender| fender.peak_reaction_n > 1500e3).count();
    assert_eq!(over, 0);
}
