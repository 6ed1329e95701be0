//! The model of three degrees of freedom, compared with laws of mechanics. Actuators, compared with closed forms.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use crate::ships;

use fenderline_sim::hydro::actuator::{Lag, Order, RateLimited, Slewing, Telegraph};
use fenderline_sim::hydro::manoeuvres::{bollard_pull_n, crabbing};
use fenderline_sim::hydro::{
    AzimuthThruster, Controls, Force, Mmg, Model3, Motion, Propeller, Series, TunnelThruster,
    Velocity, Water,
};
use proptest::prelude::*;
use ships::{esso_osaka_model, kcs, kvlcc2};

/// The ship with equal coefficients for both sides.
fn symmetric(mut ship: Mmg) -> Mmg {
    let propulsion = ship.propulsion.as_mut().expect("a propeller");
    let [negative, positive] = propulsion.rudder.straightening;
    propulsion.rudder.straightening = [0.5 * (negative + positive); 2];
    let [negative, positive] = propulsion.wake.limits;
    propulsion.wake.limits = [0.5 * (negative + positive); 2];
    ship
}

fn mirrored(motion: &Motion) -> Motion {
    Motion {
        north_m: motion.north_m,
        east_m: -motion.east_m,
        heading_rad: -motion.heading_rad,
        velocity: Velocity {
            surge_mps: motion.velocity.surge_mps,
            sway_mps: -motion.velocity.sway_mps,
            yaw_radps: -motion.velocity.yaw_radps,
        },
    }
}

/// The tracks are mirrored bit for bit. Only γ_R and C₂ differ between the sides, and they are made symmetric here.
#[test]
fn mirrored_controls_give_the_mirrored_track() {
    for ship in [symmetric(kvlcc2().ship), symmetric(kcs().ship)] {
        let model = Model3::new(ship, Water::SEA);
        let start = Motion {
            velocity: Velocity { surge_mps: 3.0, sway_mps: 0.4, yaw_radps: 0.004 },
            ..Motion::default()
        };
        let (mut here, mut there) = (start, mirrored(&start));
        for step in 0..4000 {
            // Ahead, stop and astern, with changes of the rudder.
            let shaft_rps = [1.5, 0.0, -1.2, 0.4][step / 1000];
            let rudder_rad = if step % 700 < 350 { 0.6 } else { -0.3 };
            let push = Force { surge_n: 0.0, sway_n: 1e5, yaw_nm: -3e6 };
            let other = Force { sway_n: -push.sway_n, yaw_nm: -push.yaw_nm, ..push };
            let controls = Controls { shaft_rps, rudder_rad };
            let opposite = Controls { rudder_rad: -rudder_rad, ..controls };
            here = model.runge_kutta(&here, &controls, push, 0.5);
            there = model.runge_kutta(&there, &opposite, other, 0.5);
            assert_eq!(there, mirrored(&here), "step {step}");
        }
        assert!(here.velocity.surge_mps.is_finite());
    }
}

/// A hull without forces and added mass is a rigid body. Its momentum and energy are constant.
#[test]
fn a_body_without_water_forces_keeps_momentum_and_energy() {
    let mut ship = Mmg { propulsion: None, ..esso_osaka_model().ship };
    ship.added_mass = Default::default();
    let low = &mut ship.hull.low_speed;
    (low.ahead, low.astern, low.surge_vr) = (0.0, 0.0, 0.0);
    (low.sway_v, low.sway_r, low.yaw_v, low.yaw_r) = (0.0, 0.0, 0.0, 0.0);
    low.cross_flow.drag_coefficient = 0.0;
    let model = Model3::new(ship, Water::FRESH);
    let start = Motion {
        velocity: Velocity { surge_mps: 0.5, sway_mps: -0.2, yaw_radps: 0.7 },
        ..Motion::default()
    };
    // The velocity of the centre of gravity over ground is constant.
    let centre = |m: &Motion| {
        let (sin, cos) = libm::sincos(m.heading_rad);
        let v = m.velocity;
        let across = v.sway_mps + ship.particulars.centre_of_gravity_m * v.yaw_radps;
        [v.surge_mps * cos - across * sin, v.surge_mps * sin + across * cos]
    };
    let mut motion = start;
    for _ in 0..1000 {
        motion = model.runge_kutta(&motion, &Controls::default(), Force::default(), 0.01);
    }
    // The method is of fourth order, with r Δt = 0.007 over 1000 steps. The error is 1e-9 or less.
    for (now, then) in centre(&motion).into_iter().zip(centre(&start)) {
        assert!((now - then).abs() < 1e-9, "{now} {then}");
    }
    assert!((motion.velocity.yaw_radps - 0.7).abs() < 1e-9);
    let energy = |m: &Motion| model.kinetic_j(&m.velocity);
    assert!((energy(&motion) / energy(&start) - 1.0).abs() < 1e-9);
}

/// Both integrators converge to the same motion, one in first order and one in fourth order.
#[test]
fn the_integrators_converge_to_one_motion() {
    let model = Model3::new(kvlcc2().ship, Water::SEA);
    let controls = Controls { shaft_rps: 1.7, rudder_rad: 0.3 };
    let start = Motion {
        velocity: Velocity { surge_mps: 7.0, ..Velocity::default() },
        ..Motion::default()
    };
    let run = |steps: usize, rk4: bool| {
        let step_s = 200.0 / steps as f64;
        (0..steps).fold(start, |motion, _| {
            if rk4 {
                model.runge_kutta(&motion, &controls, Force::default(), step_s)
            } else {
                model.semi_implicit(&motion, &controls, Force::default(), step_s)
            }
        })
    };
    let exact = run(20_000, true);
    let off = |m: Motion| libm::hypot(m.north_m - exact.north_m, m.east_m - exact.east_m);
    let (coarse, fine) = (off(run(400, false)), off(run(800, false)));
    assert!((1.8..2.2).contains(&(coarse / fine)), "{coarse} {fine}");
    assert!(fine < 2.0, "{fine} m after 200 s");
    assert!(off(run(400, true)) < 1e-4);
}

proptest! {
    // Each case has 20 000 steps.
    #![proptest_config(ProptestConfig::with_cases(48))]
    /// With the engine stopped and the rudder amidships, the water only dissipates a ship's energy.
    #[test]
    fn a_ship_without_propulsion_comes_to_rest(
        surge_mps in -2.0_f64..8.0,
        sway_mps in -2.0_f64..2.0,
        tip_mps in -4.0_f64..4.0,
        which in 0_usize..3,
    ) {
        let vessel = [kvlcc2, kcs, esso_osaka_model][which]();
        let length_m = vessel.ship.particulars.length_m;
        let model = Model3::new(vessel.ship, Water::SEA);
        let velocity = Velocity { surge_mps, sway_mps, yaw_radps: tip_mps / length_m };
        let mut motion = Motion { velocity, ..Motion::default() };
        let start_j = model.kinetic_j(&velocity);
        let step_s = 0.005 * length_m;
        let mut greatest_j = start_j;
        for _ in 0..20_000 {
            motion = model.runge_kutta(&motion, &Controls::default(), Force::default(), step_s);
            greatest_j = greatest_j.max(model.kinetic_j(&motion.velocity));
        }
        let end_j = model.kinetic_j(&motion.velocity);
        // Quadratic resistance gives 1/u ≥ t R0'/(2 B Cb) for any initial speed. After this time each of the three
        // ships is below 0.2 m/s, or below 2 % of a smaller initial speed.
        let slow_j = model.kinetic_j(&Velocity { surge_mps: 0.2, ..Velocity::default() });
        prop_assert!(end_j < (0.02 * start_j).max(slow_j), "{end_j} J left of {start_j} J");
        prop_assert!(greatest_j < 1.02 * start_j.max(1e-12), "{greatest_j} J from {start_j} J");
    }
}

/// A steady lateral push is balanced by the cross-flow drag, by Y'v v|u| at the small remaining speed ahead, and by the
/// rudder across the flow: ½ρLT(C_D v² + 0.315 v|u|) + 1.312 · ½ρ A_R f_α (0.395 v)². The speed ahead gives the rudder
/// some lift, and the remaining rate of turn some drag: together 0.1 %.
#[test]
fn crabbing_reaches_the_speed_of_the_cross_flow_balance() {
    let model = Model3::new(kvlcc2().ship, Water::SEA);
    let p = kvlcc2().ship.particulars;
    let side_n = 0.5 * 1025.0 * p.length_m * p.draught_m;
    let drag = kvlcc2().ship.hull.low_speed.cross_flow.drag_coefficient;
    let push_n = side_n * drag * 0.25;
    let push = Force { sway_n: push_n, ..Force::default() };
    let crab = crabbing(&model, push, 4000.0, 0.5).expect("she settles");
    println!("{crab:?}");
    let v = crab.sway_mps;
    let rudder_n = 1.312 * 0.5 * 1025.0 * 112.5 * 2.747 * (0.395 * v) * (0.395 * v);
    let balance_n = side_n * (drag * v * v + 0.315 * v * crab.surge_mps.abs()) + rudder_n;
    assert!((balance_n / push_n - 1.0).abs() < 1e-3, "{balance_n} is not {push_n}");
    assert!((v / 0.5 - 1.0).abs() < 0.02);
    assert!(crab.surge_mps.abs() < 0.02 && crab.yaw_radps.abs() < 1e-4);
}

#[test]
fn bollard_pull_is_kt_at_rest_less_deduction() {
    let model = Model3::new(kvlcc2().ship, Water::SEA);
    let ahead_n = bollard_pull_n(&model, 1.0).expect("a propeller");
    let expected_n = 0.78 * 1025.0 * 9.86_f64.powi(4) * 0.2931;
    assert!((ahead_n / expected_n - 1.0).abs() < 1e-12);
    assert!(bollard_pull_n(&model, -1.0).expect("a propeller") < 0.0);
    let bare = Mmg { propulsion: None, ..esso_osaka_model().ship };
    assert!(bollard_pull_n(&Model3::new(bare, Water::FRESH), 1.0).is_err());
}

#[test]
fn the_rudder_acts_at_bollard_pull_and_is_reversed_astern() {
    let ship = kvlcc2().ship;
    let yaw_nm = |surge_mps: f64, shaft_rps: f64| {
        let velocity = Velocity { surge_mps, ..Velocity::default() };
        let controls = Controls { shaft_rps, rudder_rad: 0.5 };
        ship.parts(&velocity, &controls, Water::SEA).rudder.yaw_nm
    };
    assert!(yaw_nm(0.0, 1.0) > 1e6, "kick ahead: {}", yaw_nm(0.0, 1.0));
    assert_eq!(yaw_nm(0.0, 0.0), 0.0);
    assert!(yaw_nm(4.0, 0.0) > 0.0, "behind a stopped propeller");
    assert!(yaw_nm(4.0, 0.0) < yaw_nm(4.0, 1.0));
    assert!(yaw_nm(-2.0, 0.0) < 0.0, "astern it works the other way");
    assert!(yaw_nm(-2.0, -1.0) < 0.0);
    // At a speed ahead, a propeller that turns astern takes the flow away from the rudder.
    assert!(yaw_nm(4.0, -1.0) < yaw_nm(4.0, 0.0));
}

#[test]
fn thrusters_act_at_their_positions() {
    let tunnel = TunnelThruster { bollard_n: 3e5, along_m: 130.0 };
    let push = tunnel.force(-1.0, &Velocity::default());
    assert_eq!([push.surge_n, push.sway_n, push.yaw_nm], [0.0, -3e5, -3e5 * 130.0]);
    let azimuth = AzimuthThruster {
        propeller: Propeller {
            diameter_m: 3.0,
            thrust_polynomial: None,
            series: Series::B4Pitch10,
        },
        along_m: -10.0,
        across_m: 4.0,
        wake: 0.0,
        thrust_deduction: 0.05,
    };
    let at = |azimuth_rad, velocity| azimuth.force(3.0, azimuth_rad, &velocity, Water::SEA);
    let ahead = at(0.0, Velocity::default());
    let open_n = azimuth.propeller.thrust_n(0.0, 3.0, Water::SEA);
    assert!((ahead.surge_n / (0.95 * open_n) - 1.0).abs() < 1e-12);
    assert!((ahead.yaw_nm + 4.0 * ahead.surge_n).abs() < 1e-6);
    let starboard = at(std::f64::consts::FRAC_PI_2, Velocity::default());
    assert!((starboard.sway_n / ahead.surge_n - 1.0).abs() < 1e-12);
    assert!((starboard.yaw_nm / (-10.0 * starboard.sway_n) - 1.0).abs() < 1e-9);
    let with_way = at(0.0, Velocity { surge_mps: 5.0, ..Velocity::default() });
    assert!(with_way.surge_n < 0.8 * ahead.surge_n, "thrust falls with inflow");
    let sideways =
        at(std::f64::consts::FRAC_PI_2, Velocity { surge_mps: 5.0, ..Velocity::default() });
    assert!((sideways.sway_n / starboard.sway_n - 1.0).abs() < 1e-9, "no inflow along the axis");
}

#[test]
fn a_rudder_turns_at_its_rate_up_to_its_stop() {
    let mut rudder = RateLimited::rudder(2.5, 35.0);
    assert_eq!(rudder.step(20_f64.to_radians(), 4.0), Order::Taken);
    assert!((rudder.value.to_degrees() - 10.0).abs() < 1e-12);
    assert_eq!(rudder.step(50_f64.to_radians(), 100.0), Order::Clamped);
    assert!((rudder.value.to_degrees() - 35.0).abs() < 1e-12);
    let before = rudder;
    assert_eq!(rudder.step(f64::NAN, 1.0), Order::Clamped);
    assert_eq!(rudder, before);
    assert_eq!(rudder.step(f64::NEG_INFINITY, 1000.0), Order::Clamped);
    assert!((rudder.value.to_degrees() + 35.0).abs() < 1e-12);
}

#[test]
fn an_azimuth_unit_turns_the_shorter_way() {
    let mut unit = Slewing {
        angle_rad: 170_f64.to_radians(),
        rate_radps: 12_f64.to_radians(),
        stop_rad: None,
    };
    unit.step((-150_f64).to_radians(), 1.0);
    assert!((unit.angle_rad.to_degrees() + 178.0).abs() < 1e-9, "{}", unit.angle_rad.to_degrees());
    unit.step((-150_f64).to_radians(), 10.0);
    assert!((unit.angle_rad.to_degrees() + 150.0).abs() < 1e-9);
    // An angle of 720° more gives the same direction.
    unit.step((-150_f64 + 720.0).to_radians(), 1.0);
    assert!((unit.angle_rad.to_degrees() + 150.0).abs() < 1e-9);
    let before = unit;
    assert_eq!(unit.step(f64::INFINITY, 1.0), Order::Clamped);
    assert_eq!(unit, before);
}

#[test]
fn the_telegraph_goes_up_in_steps() {
    let ratios = Telegraph::ALL.map(Telegraph::revolutions_ratio);
    assert!(ratios.windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!(Telegraph::Stop.revolutions_ratio(), 0.0);
    assert_eq!(Telegraph::NavigationFull.revolutions_ratio(), 1.0);
}

proptest! {
    /// Actuators are exact for any Δt: two steps end where one step with the sum of their times ends.
    #[test]
    fn actuators_are_exact_for_any_time_step(
        start in -1.0_f64..1.0,
        order in -2.0_f64..2.0,
        one_s in 0.0_f64..20.0,
        two_s in 0.0_f64..20.0,
    ) {
        let mut once = RateLimited { value: start, rate_per_s: 0.1, stop: 1.0 };
        let mut twice = once;
        once.step(order, one_s + two_s);
        twice.step(order, one_s);
        twice.step(order, two_s);
        prop_assert!((once.value - twice.value).abs() < 1e-12);

        let mut once = Lag { value: start, time_constant_s: 5.0 };
        let mut twice = once;
        once.step(order, one_s + two_s);
        twice.step(order, one_s);
        twice.step(order, two_s);
        prop_assert!((once.value - twice.value).abs() < 1e-12);
        // A turn by exactly half a circle may go either way, because of rounding.
        prop_assume!((order - start).abs() < 3.0);
        let mut once = Slewing { angle_rad: start, rate_radps: 0.1, stop_rad: None };
        let mut twice = once;
        once.step(order, one_s + two_s);
        twice.step(order, one_s);
        twice.step(order, two_s);
        prop_assert!((once.angle_rad - twice.angle_rad).abs() < 1e-12);

        let mut once = Lag { value: start, time_constant_s: 5.0 };
        once.step(order, one_s + two_s);
        let closed_form = order + (start - order) * libm::exp(-(one_s + two_s) / 5.0);
        prop_assert!((once.value - closed_form).abs() < 1e-12);
    }
}
