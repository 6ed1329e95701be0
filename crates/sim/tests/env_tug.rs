//! Vector tugs: the envelope compared with its formula by hand, the lag compared with its exponential, and orders with
//! their limits.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use std::f64::consts::{FRAC_PI_2, PI};

use fenderline_contact::{Vec2, vec2};
use fenderline_ship::step_time::StepTime;
use fenderline_sim::constants::{KNOT_MPS, STANDARD_GRAVITY_MPS2 as G};
use fenderline_sim::tug::*;
use proptest::prelude::*;

const BP_N: f64 = 60e3 * G;

/// 60 t bollard pull, 32 × 4.5 m, Cd 0.73.
const SIXTY: TugEnvelope = TugEnvelope {
    bollard_pull_n: BP_N,
    length_m: 32.0,
    beam_m: 13.0,
    draught_m: 4.5,
    drag_coefficient: 0.73,
};

fn tug() -> VectorTug {
    VectorTug {
        name: "fore tug".into(),
        envelope: SIXTY,
        push_at_m: vec2(100.0, -23.0),
        pull_at_m: vec2(140.0, -5.0),
        delay_s: 5.0,
        force_lag_s: 10.0,
        direction_lag_s: 20.0,
    }
}

fn push(force_n: f64) -> TugOrder {
    TugOrder::Push { force_n, direction_rad: FRAC_PI_2 }
}

/// At 5 kn the share is 80 %, at 6 kn 49 %, and at 6.4 kn there is none, as printed. At 6.42 kn the drag D equals the
/// bollard pull.
#[test]
fn the_envelope_beam_on() {
    let share = |knots: f64| SIXTY.available_n(FRAC_PI_2, knots * KNOT_MPS, 1025.0) / BP_N;
    println!("5 kn {:.4}, 6 kn {:.4}, 6.42 kn {:.4}", share(5.0), share(6.0), share(6.42));
    assert_eq!(share(0.0), 1.0);
    assert!((share(5.0) - 0.80).abs() < 0.005);
    assert!((share(6.0) - 0.49).abs() < 0.005);
    assert_eq!(share(6.45), 0.0);
    // D grows with V². So the share is √(1 − (V/V₀)⁴), where V₀ is the speed at which D equals the bollard pull.
    let zero_mps = (BP_N / (0.5 * 1025.0 * 0.73 * 32.0 * 4.5)).sqrt();
    for knots in [1.0, 3.0, 6.35] {
        let exact = (1.0 - (knots * KNOT_MPS / zero_mps).powi(4)).sqrt();
        assert!((share(knots) - exact).abs() < 1e-12);
    }
}

/// All directions and speeds up to 8 kn. The force is between 0 and the bollard pull and the same on both sides. It
/// never grows with the speed, and has no jump.
#[test]
fn the_envelope_is_continuous() {
    for tenth_knots in 0..80 {
        let speed_mps = 0.1 * f64::from(tenth_knots) * KNOT_MPS;
        for degree in 0..360 {
            let angle_rad = f64::from(degree).to_radians();
            let here = SIXTY.available_n(angle_rad, speed_mps, 1025.0);
            assert!((0.0..=BP_N).contains(&here));
            let mirrored = SIXTY.available_n(-angle_rad, speed_mps, 1025.0);
            assert!((here - mirrored).abs() < 1e-6);
            let faster = SIXTY.available_n(angle_rad, speed_mps + 0.05, 1025.0);
            assert!(faster <= here + 1e-6);
            // Where the force ends, its slope is that of a square root: √(2·1e-6·10) of the bollard pull.
            let near = SIXTY.available_n(angle_rad + 1e-6, speed_mps, 1025.0);
            assert!((near - here).abs() < 5e-3 * BP_N, "{degree}° {speed_mps} m/s");
        }
    }
}

fn run(tug: &VectorTug, state: &mut TugState, from_s: f64, seconds: u32, step_s: f64) -> TugForce {
    let steps = (f64::from(seconds) / step_s).round() as u32;
    let mut last = None;
    for k in 0..steps {
        let t_s = from_s + f64::from(k) * step_s;
        last = Some(tug.step(state, StepTime { t_s, step_s }, Vec2::ZERO, 1025.0));
    }
    last.expect("a step at least")
}

/// After the delay the force follows 1 − e^(−t/τ) to rounding, for any step. The moment is that of the point of action.
#[test]
fn force_follows_its_lag_exactly() {
    for step_s in [0.1, 0.5, 5.0] {
        let (tug, mut state) = (tug(), TugState::default());
        tug.order(&mut state, 0.0, push(200e3)).unwrap();
        let before = run(&tug, &mut state, 0.0, 5, step_s);
        assert_eq!(before.force, [0.0; 3]);
        let after = run(&tug, &mut state, 5.0, 20, step_s);
        let expected_n = 200e3 * (1.0 - (-2.0_f64).exp());
        assert!((after.force[1] / expected_n - 1.0).abs() < 1e-9, "{:?}", after.force);
        assert!((after.force[2] - 100.0 * after.force[1]).abs() < 1e-6 * after.force[1] * 100.0);
    }
}

/// From push to pull the force first falls to zero, and then grows at the other point. It never jumps by more than the
/// lag allows, Δt/τ of the bollard pull, plus a hundredth of the bollard pull where she changes over.
#[test]
fn from_push_to_pull_she_lets_go_first() {
    let (tug, mut state) = (tug(), TugState::default());
    tug.order(&mut state, 0.0, push(400e3)).unwrap();
    run(&tug, &mut state, 0.0, 200, 0.5);
    let pull = TugOrder::Pull { force_n: 300e3, direction_rad: -FRAC_PI_2 };
    tug.order(&mut state, 200.0, pull).unwrap();
    let mut last = 400e3;
    for k in 0..400 {
        let t_s = 200.0 + 0.5 * f64::from(k);
        let force = tug.step(&mut state, StepTime { t_s, step_s: 0.5 }, Vec2::ZERO, 1025.0);
        assert!((force.force[1] - last).abs() < 0.07 * BP_N);
        assert_eq!(force.at_m, if state.on_line { tug.pull_at_m } else { tug.push_at_m });
        last = force.force[1];
    }
    assert!(state.on_line && (last + 300e3).abs() < 1.0, "{last}");
}

/// The direction turns the short way round, across the stern.
#[test]
fn direction_takes_the_short_way() {
    let (mut tug, mut state) = (tug(), TugState::default());
    tug.delay_s = 0.0;
    let at = |degrees: f64| TugOrder::Pull { force_n: 300e3, direction_rad: degrees.to_radians() };
    tug.order(&mut state, 0.0, at(170.0)).unwrap();
    run(&tug, &mut state, 0.0, 200, 1.0);
    tug.order(&mut state, 200.0, at(-170.0)).unwrap();
    for k in 0..200 {
        let force = tug.step(
            &mut state,
            StepTime { t_s: 200.0 + f64::from(k), step_s: 1.0 },
            Vec2::ZERO,
            1025.0,
        );
        assert!(force.force[0] < -290e3, "always astern: {:?}", force.force);
    }
    assert!((state.direction_rad - 190.0_f64.to_radians()).abs() < 1e-3);
}

#[test]
fn an_order_beyond_the_envelope_is_limited_and_reported() {
    let (tug, mut state) = (tug(), TugState::default());
    tug.order(&mut state, 0.0, push(1e7)).unwrap();
    let at_rest = run(&tug, &mut state, 0.0, 300, 1.0);
    assert!(at_rest.limited);
    assert!((at_rest.force[1] / BP_N - 1.0).abs() < 1e-6);
    let moving = vec2(6.0 * KNOT_MPS, 0.0);
    let under_way = tug.step(&mut state, StepTime { t_s: 300.0, step_s: 1.0 }, moving, 1025.0);
    assert!(under_way.limited && (under_way.force[1] / BP_N - 0.49).abs() < 0.005);
    // The drag does not reduce a push from ahead against the motion: it assists the push.
    assert_eq!(SIXTY.available_n(PI, 3.0, 1025.0), BP_N);
}

#[test]
fn absurd_orders_and_tugs_are_refused_and_change_nothing() {
    let (tug, mut state) = (tug(), TugState::default());
    assert!(tug.check().is_ok());
    let error = tug.order(&mut state, 0.0, push(f64::NAN)).unwrap_err().to_string();
    assert!(error.starts_with("force ordered of a tug [N]"), "{error}");
    assert!(tug.order(&mut state, 0.0, push(-1.0)).is_err());
    let sideways = TugOrder::Pull { force_n: 1.0, direction_rad: f64::INFINITY };
    assert!(tug.order(&mut state, 0.0, sideways).is_err());
    assert_eq!(state, TugState::default());
    let weak = TugEnvelope { bollard_pull_n: 0.0, ..SIXTY };
    assert!(weak.check().unwrap_err().to_string().contains("bollard pull"));
}

proptest! {
    /// For any speed and any orders the force is finite and never above the bollard pull. The same state replays to the
    /// same bits.
    #[test]
    fn forces_stay_within_the_bollard_pull(
        orders in prop::collection::vec((0.0..1e6_f64, -4.0..4.0_f64, any::<bool>()), 1..8),
        u_mps in -8.0..8.0_f64,
        v_mps in -3.0..3.0_f64,
    ) {
        let tug = tug();
        let mut state = TugState::default();
        for (k, (force_n, direction_rad, pull)) in (0_u32..).zip(orders) {
            let order = if pull {
                TugOrder::Pull { force_n, direction_rad }
            } else {
                TugOrder::Push { force_n, direction_rad }
            };
            tug.order(&mut state, 30.0 * f64::from(k), order).unwrap();
        }
        let mut replay = state.clone();
        for k in 0..300 {
            let now = StepTime { t_s: f64::from(k), step_s: 1.0 };
            let force = tug.step(&mut state, now, vec2(u_mps, v_mps), 1025.0);
            prop_assert!(force.force[0].hypot(force.force[1]) <= BP_N * (1.0 + 1e-12));
            let again = tug.step(&mut replay, now, vec2(u_mps, v_mps), 1025.0);
            prop_assert_eq!(force.force.map(f64::to_bits), again.force.map(f64::to_bits));
        }
    }
}
