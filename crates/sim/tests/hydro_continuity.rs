//! Forces are continuous in velocity, revolutions and rudder angle: through rest, astern, at all drift angles and in
//! all four quadrants of the propeller.
//!
//! There are two checks, which are independent of the formulas. *Halving*: along a line, the largest step of a
//! continuous, piecewise smooth function halves with the spacing; a jump does not. *Lipschitz*: forces are of degree
//! two in the velocities, so |ΔF| ≤ K · scale · V · |ΔV| with one K for all states.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use crate::ships;

use std::f64::consts::{PI, TAU};

use fenderline_scenario::VesselLibrary;
use fenderline_sim::hydro::vessels::Vessel;
use fenderline_sim::hydro::{
    Controls, Force, Mmg, Particulars, Parts, Propeller, Series, Squat, TunnelThruster, Velocity,
    Water, polynomial_weight, tunnel_effect,
};
use proptest::prelude::*;
use ships::{esso_osaka_model, kcs, kvlcc2};

const SPACING: usize = 2048;

/// Largest step of [X, Y, N/L] along a line, in units of `scale_n`.
fn largest_step(count: usize, scale_n: f64, length_m: f64, at: &dyn Fn(f64) -> Force) -> f64 {
    let forces: Vec<Force> = (0..=count).map(|i| at(i as f64 / count as f64)).collect();
    forces
        .windows(2)
        .map(|pair| difference(&pair[0], &pair[1], length_m) / scale_n)
        .fold(0.0, f64::max)
}

fn difference(a: &Force, b: &Force, length_m: f64) -> f64 {
    (a.surge_n - b.surge_n)
        .abs()
        .max((a.sway_n - b.sway_n).abs())
        .max((a.yaw_nm - b.yaw_nm).abs() / length_m)
}

#[track_caller]
fn no_jump(what: &str, scale_n: f64, length_m: f64, at: &dyn Fn(f64) -> Force) {
    no_jump_by(SPACING, what, scale_n, length_m, at);
}

#[track_caller]
fn no_jump_by(spacing: usize, what: &str, scale_n: f64, length_m: f64, at: &dyn Fn(f64) -> Force) {
    let coarse = largest_step(spacing, scale_n, length_m, at);
    let fine = largest_step(4 * spacing, scale_n, length_m, at);
    assert!(coarse.is_finite(), "{what}: not finite");
    // A smooth function gives a quarter. A line that turns sharply needs some margin. A jump gives 1.
    assert!(fine <= 0.4 * coarse + 1e-12, "{what}: a step of {coarse} only falls to {fine}");
}

fn forces(ship: &Mmg, velocity: Velocity, controls: Controls) -> Force {
    ship.forces(&velocity, &controls, Water::SEA)
}

fn scale_n(ship: &Mmg) -> f64 {
    let p = &ship.particulars;
    0.5 * Water::SEA.density_kgpm3 * p.length_m * p.draught_m
}

/// Revolutions from astern to ahead, and rudder angles, for ships that have them.
const SHAFTS_RPS: [f64; 4] = [-1.2, 0.0, 0.4, 1.7];
const RUDDERS_RAD: [f64; 3] = [-0.6, 0.0, 0.6];

fn each_control(mut check: impl FnMut(Controls)) {
    for shaft_rps in SHAFTS_RPS {
        for rudder_rad in RUDDERS_RAD {
            check(Controls { shaft_rps, rudder_rad });
        }
    }
}

#[test]
fn no_jump_from_astern_to_full_ahead() {
    for (name, ship) in
        [kvlcc2(), kcs(), esso_osaka_model()].map(|vessel| (vessel.origin.title, vessel.ship))
    {
        let length_m = ship.particulars.length_m;
        each_control(|controls| {
            for sway_mps in [0.0, 0.02, -0.7] {
                for tip_mps in [0.0, 0.05, -1.0] {
                    let yaw_radps = tip_mps / length_m;
                    let at = |t: f64| {
                        let surge_mps = -2.0 + 10.0 * t;
                        forces(&ship, Velocity { surge_mps, sway_mps, yaw_radps }, controls)
                    };
                    let what = format!("{name}, surge, {controls:?}, {sway_mps}, {tip_mps}");
                    no_jump(&what, scale_n(&ship), length_m, &at);
                }
            }
        });
    }
}

#[test]
fn no_jump_through_all_drift_angles_and_yaw_rates() {
    for (name, ship) in
        [kvlcc2(), kcs(), esso_osaka_model()].map(|vessel| (vessel.origin.title, vessel.ship))
    {
        let length_m = ship.particulars.length_m;
        each_control(|controls| {
            for tip_mps in [-3.0, 0.0, 0.4] {
                let at = |t: f64| {
                    let (sin, cos) = libm::sincos(TAU * t);
                    let yaw_radps = tip_mps / length_m;
                    forces(
                        &ship,
                        Velocity { surge_mps: 2.0 * cos, sway_mps: 2.0 * sin, yaw_radps },
                        controls,
                    )
                };
                no_jump(&format!("{name}, drift, {controls:?}"), scale_n(&ship), length_m, &at);
            }
            for (surge_mps, sway_mps) in [(0.0, 0.0), (4.0, 0.0), (-1.0, 0.3), (0.0, 1.0)] {
                let at = |t: f64| {
                    let yaw_radps = (-4.0 + 8.0 * t) / length_m;
                    forces(&ship, Velocity { surge_mps, sway_mps, yaw_radps }, controls)
                };
                no_jump(&format!("{name}, yaw, {controls:?}"), scale_n(&ship), length_m, &at);
            }
        });
    }
}

#[test]
fn no_jump_through_rest() {
    for (name, ship) in
        [kvlcc2(), kcs(), esso_osaka_model()].map(|vessel| (vessel.origin.title, vessel.ship))
    {
        let length_m = ship.particulars.length_m;
        each_control(|controls| {
            for direction in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.3, -0.8, 1.0], [-1.0, 0.1, 0.5]]
            {
                let at = |t: f64| {
                    let [surge_mps, sway_mps, tip_mps] = direction.map(|d| d * (t - 0.5));
                    forces(
                        &ship,
                        Velocity { surge_mps, sway_mps, yaw_radps: tip_mps / length_m },
                        controls,
                    )
                };
                no_jump(&format!("{name}, rest, {controls:?}"), scale_n(&ship), length_m, &at);
            }
        });
    }
}

#[test]
fn no_jump_in_revolutions_and_rudder() {
    for (name, ship) in [kvlcc2(), kcs()].map(|vessel| (vessel.origin.title, vessel.ship)) {
        let length_m = ship.particulars.length_m;
        for surge_mps in [-2.0, -0.01, 0.0, 0.3, 7.0] {
            for sway_mps in [0.0, 0.5] {
                let velocity = Velocity { surge_mps, sway_mps, yaw_radps: 0.3 / length_m };
                let shaft = |t: f64| {
                    let controls = Controls { shaft_rps: -2.0 + 4.0 * t, rudder_rad: 0.5 };
                    forces(&ship, velocity, controls)
                };
                no_jump(&format!("{name}, shaft at {surge_mps}"), scale_n(&ship), length_m, &shaft);
                let rudder = |t: f64| {
                    let controls = Controls { shaft_rps: 0.7, rudder_rad: -PI + TAU * t };
                    forces(&ship, velocity, controls)
                };
                no_jump(
                    &format!("{name}, rudder at {surge_mps}"),
                    scale_n(&ship),
                    length_m,
                    &rudder,
                );
            }
        }
    }
}

#[test]
fn no_jump_through_the_four_quadrants_of_a_propeller() {
    for (series, thrust_polynomial) in [
        (Series::B4Pitch08, Some([0.2931, -0.2753, -0.1385])),
        (Series::B4Pitch10, Some([0.5228, -0.4390, -0.0609])),
        (Series::B4Pitch08, None),
        (Series::B4Pitch10, None),
    ] {
        let propeller = Propeller { diameter_m: 8.0, thrust_polynomial, series };
        let at = |t: f64| {
            let (sin, cos) = libm::sincos(TAU * t);
            let (advance_mps, shaft_rps) = (5.0 * sin, 0.5 * cos);
            Force {
                surge_n: propeller.thrust_n(advance_mps, shaft_rps, Water::SEA),
                sway_n: propeller.torque_nm(advance_mps, shaft_rps, Water::SEA) / 8.0,
                yaw_nm: 0.0,
            }
        };
        no_jump("quadrants", 1e6, 1.0, &at);
        assert_eq!(propeller.thrust_n(0.0, 0.0, Water::SEA), 0.0);
        assert_eq!(propeller.torque_nm(0.0, 0.0, Water::SEA), 0.0);
    }
}

/// Every ship of the library, by name.
fn all_ships() -> Vec<(String, Mmg)> {
    let library = VesselLibrary::built_in();
    library.vessels().iter().map(|vessel| (vessel.name.clone(), vessel.ship)).collect()
}

/// The hull's force alone.
fn hull_force(ship: &Mmg, velocity: &Velocity) -> Force {
    ship.hull.force(velocity, &ship.particulars, &ship.added_mass, Water::SEA)
}

/// The ship drifts at 1 m/s at an angle off the bow, and turns so that rL is a number of metres per second.
fn drifting(ship: &Mmg, angle_rad: f64, tip_mps: f64) -> Velocity {
    let (sway_mps, surge_mps) = libm::sincos(angle_rad);
    Velocity { surge_mps, sway_mps, yaw_radps: tip_mps / ship.particulars.length_m }
}

/// Depths of the water over draught, from a hand's breadth under the keel to deep water.
const DEPTH_RATIOS: [f64; 8] = [1.05, 1.1, 1.15, 1.2, 1.5, 2.0, 3.0, f64::INFINITY];

/// Far outside the angles of its tests, the polynomial once pushed ships 2.5 times as hard at 50° off the bow as abeam.
#[test]
fn no_ship_is_pushed_harder_at_any_angle_than_abeam() {
    for (name, deep) in all_ships() {
        for ratio in DEPTH_RATIOS {
            let ship = deep.at_depth(ratio * deep.particulars.draught_m);
            let at = |angle_rad: f64| {
                let velocity = drifting(&ship, angle_rad, 0.0);
                (velocity, hull_force(&ship, &velocity))
            };
            let abeam_n = -at(0.5 * PI).1.sway_n;
            let mut greatest = 0.0_f64;
            for degrees in 0..=180 {
                let what = format!("{name}, {ratio} draughts, {degrees}°");
                let (velocity, force) = at(f64::from(degrees).to_radians());
                greatest = greatest.max(-force.sway_n / abeam_n);
                let against = velocity.sway_mps.abs() < 1e-9 || force.sway_n < 0.0;
                assert!(against, "{what}: {force:?} pushes across with the drift");
                let power_w = force.surge_n * velocity.surge_mps + force.sway_n * velocity.sway_mps;
                assert!(power_w < 0.0, "{what}: {force:?} drives the ship");
            }
            assert!(greatest <= 1.15, "{name}, {ratio} draughts: {greatest}");
        }
    }
}

#[test]
fn hull_forces_of_mirrored_motions_are_mirrored() {
    for (name, deep) in all_ships() {
        for ratio in DEPTH_RATIOS {
            let ship = deep.at_depth(ratio * deep.particulars.draught_m);
            for degrees in (0..=180).step_by(3) {
                for tip_mps in [-4.0, -1.7, -0.6, 0.0, 0.9, 2.2] {
                    let velocity = drifting(&ship, f64::from(degrees).to_radians(), tip_mps);
                    let Velocity { surge_mps, sway_mps, yaw_radps } = velocity;
                    let there = hull_force(&ship, &velocity);
                    let mirrored =
                        Velocity { surge_mps, sway_mps: -sway_mps, yaw_radps: -yaw_radps };
                    let here = hull_force(&ship, &mirrored);
                    let mirror =
                        Force { surge_n: here.surge_n, sway_n: -here.sway_n, yaw_nm: -here.yaw_nm };
                    let apart = difference(&there, &mirror, ship.particulars.length_m);
                    assert!(
                        apart <= 1e-12 * scale_n(&ship),
                        "{name}, {ratio} draughts, {velocity:?}: {there:?} {mirror:?}"
                    );
                }
            }
        }
    }
}

/// Each hull of the library along drift angle, yaw rate and depth. The other variables have values at which one form
/// hands over to the other.
#[test]
fn no_jump_of_any_hull_in_angle_yaw_and_depth() {
    let no_jump = |what: &str, ship: &Mmg, at: &dyn Fn(f64) -> Force| {
        no_jump_by(256, what, scale_n(ship), ship.particulars.length_m, at);
    };
    for (name, deep) in all_ships() {
        let draught_m = deep.particulars.draught_m;
        for ratio in [1.05, 1.2, 2.0, f64::INFINITY] {
            let ship = deep.at_depth(ratio * draught_m);
            for tip_mps in [0.0, 0.8, -2.0] {
                let at = |t: f64| hull_force(&ship, &drifting(&ship, TAU * t, tip_mps));
                no_jump(&format!("{name}, {ratio} draughts, angle, {tip_mps}"), &ship, &at);
            }
            for degrees in [0.0_f64, 19.0, 32.0, 150.0] {
                let at = |t: f64| {
                    let tip_mps = -5.0 + 10.0 * t;
                    hull_force(&ship, &drifting(&ship, degrees.to_radians(), tip_mps))
                };
                no_jump(&format!("{name}, {ratio} draughts, yaw, {degrees}°"), &ship, &at);
            }
        }
        for degrees in [10.0_f64, 19.0, 24.0, 32.0, 45.0, 90.0, 150.0] {
            for tip_mps in [0.0, -0.8, 2.0] {
                let at = |t: f64| {
                    let ship = deep.at_depth((4.0 - 3.5 * t) * draught_m);
                    hull_force(&ship, &drifting(&ship, degrees.to_radians(), tip_mps))
                };
                no_jump(&format!("{name}, depth, {degrees}°, {tip_mps}"), &deep, &at);
            }
        }
    }
}

/// From a depth of ten draughts to half a draught, where she is hard aground. The test covers hull, propeller and
/// rudder separately in every kind of motion, including a hard turn; added mass; and squat. Below 1.1 draughts the
/// factors are constant. At 1.1 draughts they turn sharply and do not jump.
#[test]
fn no_jump_from_deep_water_to_the_bottom() {
    let ratio = |t: f64| 10.0 - 9.5 * t;
    for (name, ship) in
        [kvlcc2(), kcs(), esso_osaka_model()].map(|vessel| (vessel.origin.title, vessel.ship))
    {
        let Particulars { length_m, draught_m, .. } = ship.particulars;
        for [surge_mps, sway_mps, tip_mps] in [
            [4.0, 0.3, 0.0],
            [3.0, -0.8, 2.0],
            [3.0, -2.5, 4.0],
            [0.0, 0.5, 0.3],
            [-1.0, -0.2, 1.0],
            [0.0, 0.0, 0.0],
        ] {
            let velocity = Velocity { surge_mps, sway_mps, yaw_radps: tip_mps / length_m };
            let controls = Controls { shaft_rps: 0.7, rudder_rad: 0.3 };
            for (index, part) in ["hull", "propeller", "rudder"].into_iter().enumerate() {
                let at = |t: f64| {
                    let there = ship.at_depth(ratio(t) * draught_m);
                    let Parts { hull, propeller, rudder } =
                        there.parts(&velocity, &controls, Water::SEA);
                    [hull, propeller, rudder][index]
                };
                no_jump(&format!("{name}, {part}, {velocity:?}"), scale_n(&ship), length_m, &at);
            }
        }
        let at = |t: f64| {
            let depth_m = ratio(t) * draught_m;
            let squats_m = [Squat::Icorels, Squat::Barrass, Squat::Eryuzlu]
                .map(|squat| squat.sinkage_m(&ship.particulars, depth_m, 4.0));
            let [surge_n, sway_n, yaw_nm] = squats_m;
            Force { surge_n, sway_n, yaw_nm }
        };
        no_jump(&format!("{name}, squat"), 1.0, 1.0, &at);
        let at = |t: f64| {
            let added = ship.at_depth(ratio(t) * draught_m).added_mass;
            Force { surge_n: added.surge_m3, sway_n: added.sway_m3, yaw_nm: added.yaw_m5 }
        };
        no_jump(&format!("{name}, added mass"), 1e6, length_m * length_m, &at);
    }
}

#[test]
fn no_jump_in_thrusters() {
    let thruster = TunnelThruster { bollard_n: 2e5, along_m: 120.0 };
    let at = |t: f64| {
        let velocity = Velocity { surge_mps: -10.0 + 20.0 * t, ..Velocity::default() };
        thruster.force(1.0, &velocity)
    };
    no_jump("tunnel", 2e5, 240.0, &at);
    for (knots, left) in [(0.0, 1.0), (4.0, 0.5), (15.0, 1.0), (20.0, 1.0), (-4.0, 0.5)] {
        assert!((tunnel_effect(knots * 1852.0 / 3600.0) - left).abs() < 1e-12, "{knots} kn");
    }
}

/// This tests the test: the same scan finds a jump of a thousandth.
#[test]
#[should_panic(expected = "only falls to")]
fn a_jump_is_found() {
    let at =
        |t: f64| Force { surge_n: t * t + if t > 0.3 { 1e-3 } else { 0.0 }, ..Force::default() };
    no_jump("a jump", 1.0, 1.0, &at);
}

#[test]
fn the_polynomial_alone_counts_in_a_hard_turn_and_not_at_all_when_crabbing() {
    let of = |surge_mps, sway_mps, tip_mps: f64, draught_over_depth| {
        let velocity = Velocity { surge_mps, sway_mps, yaw_radps: tip_mps / 100.0 };
        polynomial_weight(&velocity, 100.0, draught_over_depth)
    };
    // KVLCC2 turns with the rudder at 35°: β is 20° and r' 0.9. At 1.2 draughts she has half of the drift.
    let (sin, cos) = libm::sincos(20_f64.to_radians());
    assert_eq!(of(cos, -sin, 0.9, 0.0), 1.0);
    assert_eq!(of(1.0, -0.5 * sin, 0.6, 1.0 / 1.2), 1.0);
    for depth in [0.0, 1.0 / 1.2, 1.0 / 1.1] {
        assert_eq!(of(0.05, 0.5, 0.0, depth), 0.0);
        assert_eq!(of(0.05, 0.0, 0.5, depth), 0.0);
        assert_eq!(of(-3.0, 0.0, 0.0, depth), 0.0);
        assert_eq!(of(0.0, 0.0, 0.0, depth), 0.0);
    }
    // A ship at rest in a stream from 38° off the bow: the polynomial has some weight in deep water, and none in
    // shallow water.
    let (sin, cos) = libm::sincos(38_f64.to_radians());
    assert_eq!(of(cos, sin, 0.0, 1.0 / 1.2), 0.0);
    assert!((0.1..0.9).contains(&of(cos, sin, 0.0, 0.0)));
}

proptest! {
    /// For any two neighbours in (u, v, rL, nD), |ΔF| ≤ K · ½ρLd · V · |ΔV|, where V is the greater of the two speeds.
    /// The same K holds for ships of 320 m and 230 m.
    #[test]
    fn forces_are_lipschitz(
        state in prop::array::uniform4(-1.0_f64..1.0),
        towards in prop::array::uniform4(-1.0_f64..1.0),
        exponent in -9.0_f64..0.0,
        speed_exponent in -4.0_f64..1.0,
        rudder_rad in -0.7_f64..0.7,
        second in any::<bool>(),
    ) {
        let Vessel { ship, .. } = if second { kcs() } else { kvlcc2() };
        let length_m = ship.particulars.length_m;
        let speed_mps = libm::exp10(speed_exponent);
        let near = libm::exp10(exponent);
        let of = |s: [f64; 4]| {
            let velocity = Velocity { surge_mps: s[0], sway_mps: s[1], yaw_radps: s[2] / length_m };
            forces(&ship, velocity, Controls { shaft_rps: s[3] / 9.0, rudder_rad })
        };
        let norm = |s: [f64; 4]| s.iter().map(|x| x * x).sum::<f64>().sqrt();
        let a = state.map(|x| x * speed_mps);
        let b = std::array::from_fn(|i| a[i] + towards[i] * near * speed_mps);
        let apart = norm(towards) * near * speed_mps;
        let bound = 3.0 * scale_n(&ship) * norm(a).max(norm(b)) * apart;
        let step = difference(&of(a), &of(b), length_m);
        prop_assert!(step <= bound + 1e-9 * bound.max(1.0), "{step} > {bound}");
    }
}
