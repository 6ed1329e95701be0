//! Properties of docs/contact_model.md, section 7. The contact is the same for swapped bodies, mirrored, far away and
//! at any heading. The bits are the same for any order of adding bodies.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

use crate::support;

use fenderline_contact::{BodyState, Contact, Memory, Vec2, Wrench, vec2};
use proptest::prelude::*;
use support::harbour::{PAPER, Run, body, model};
use support::shapes::{beside, hull, rectangle, stepped_ship};

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(cases) }
}

/// A power of two, so that positions stay on the grid.
const STEP_S: f64 = 0.0625;
/// Largest effective mass of two bodies of 1,000 t.
const EFFECTIVE_KG: f64 = 0.5e6;

/// Takes five steps of two bodies at the given velocities. Returns the contacts and wrenches of the last step.
fn five_steps(
    a: (&[Vec2], BodyState),
    b: (&[Vec2], BodyState),
    keys: [u64; 2],
) -> (Vec<Contact>, Vec<Wrench>) {
    let bodies = vec![body(keys[0], a.0, true), body(keys[1], b.0, true)];
    let mut run = Run::new(model(bodies, PAPER));
    let (mut one, mut two) = (a.1, b.1);
    for _ in 0..5 {
        run.step(&[one, two], STEP_S);
        one = moved(one, STEP_S);
        two = moved(two, STEP_S);
    }
    (run.work.contacts().to_vec(), run.work.wrenches().to_vec())
}

fn moved(state: BodyState, step_s: f64) -> BodyState {
    BodyState {
        position_m: state.position_m + state.velocity_mps * step_s,
        heading_rad: state.heading_rad + state.yaw_rate_radps * step_s,
        ..state
    }
}

#[track_caller]
fn close(what: &str, one: f64, two: f64, scale: f64) {
    assert!((one - two).abs() <= 1e-12 * scale.max(one.abs()), "{what}: {one:e} and {two:e}");
}

/// Compares all results of two contacts. `back` maps the vectors of `two` to those of `one`. `sign` is for values that
/// change sign in a mirror.
#[track_caller]
fn same_contact(one: &Contact, two: &Contact, back: impl Fn(Vec2) -> Vec2, sign: f64) {
    // The tolerance is relative to the rounding of ship lengths, 1e-14 m each.
    let extent = one.arm_1_m.length().max(one.arm_2_m.length());
    let of_depth = extent / one.depth_m * 0.1;
    close("area", one.area_m2, two.area_m2, one.area_m2 * of_depth);
    close("depth", one.depth_m, two.depth_m, one.depth_m * of_depth);
    // A limited force (V_n + γ V_n⁰)/(K Δt) may nearly vanish. Its accuracy is relative to the force that changes the
    // bodies' velocity by 1 m/s. The accuracy of the speeds below is of the same kind.
    let of_speeds_n = if one.limited { EFFECTIVE_KG / STEP_S } else { 0.0 };
    let of_force = (one.normal_force_n + of_speeds_n) * of_depth;
    close("normal force", one.normal_force_n, two.normal_force_n, of_force);
    close("V_n", one.v_normal_mps, two.v_normal_mps, 1.0 * of_depth);
    close("V_t", one.v_tangential_mps, sign * two.v_tangential_mps, of_depth);
    close("shear", one.shear_m, sign * two.shear_m, of_depth);
    for (what, u, v) in [
        ("arm 1", one.arm_1_m, back(two.arm_1_m)),
        ("arm 2", one.arm_2_m, back(two.arm_2_m)),
        ("normal", one.normal, back(two.normal)),
    ] {
        close(what, u.x, v.x, extent * of_depth);
        close(what, u.y, v.y, extent * of_depth);
    }
}

/// Two moving ships that touch or are about to; positions on a grid of 2⁻²⁰ m.
fn meeting() -> impl Strategy<Value = (Vec<Vec2>, BodyState, Vec<Vec2>, BodyState)> {
    let shape = || prop_oneof![Just(hull(298.0, 46.0, 24)), Just(stepped_ship())];
    let speed = || (-0.3..0.3f64, -0.3..0.3f64, -0.001..0.001f64);
    let small = prop_oneof![Just(rectangle(4.0, 1.5)), Just(hull(32.0, 13.0, 12))];
    (shape(), small, 0.0..6.3f64, 0.0..6.3f64, 0.0..6.3f64, 0.2..1.0f64, speed(), speed()).prop_map(
        |(ship, tug, ship_heading, tug_heading, bearing, depth_m, u, v)| {
            let state = |position_m: Vec2, heading_rad, (x, y, turn)| BodyState {
                position_m: vec2(grid(position_m.x), grid(position_m.y)),
                heading_rad,
                velocity_mps: vec2(grid(x), grid(y)),
                yaw_rate_radps: turn,
            };
            let one = state(vec2(3.0, 5.0), ship_heading, u);
            let place = beside(&ship, one.pose(), &tug, tug_heading, (bearing, depth_m, 0.0));
            let two = state(place.position_m, tug_heading, v);
            (ship, one, tug, two)
        },
    )
}

fn grid(value: f64) -> f64 {
    libm::round(value * 1_048_576.0) / 1_048_576.0
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn swapped_bodies_have_the_same_contact((a, one, b, two) in meeting()) {
        let (first, first_wrenches) = five_steps((&a, one), (&b, two), [1, 2]);
        // The ranks are the same, and the bodies are added in the opposite order. The bits must be the same.
        let (second, second_wrenches) = five_steps((&b, two), (&a, one), [2, 1]);
        prop_assert_eq!(&first_wrenches[..], &[second_wrenches[1], second_wrenches[0]][..]);
        prop_assert_eq!(first.len(), second.len());
        // With other ranks, the polygons of the clip are swapped.
        let (third, third_wrenches) = five_steps((&a, one), (&b, two), [2, 1]);
        prop_assert_eq!(first.len(), third.len());
        for (c, d) in first.iter().zip(&third) {
            if first.len() == 1 {
                same_contact(c, d, |v| v, 1.0);
            }
        }
        // Momentum: F₁ = −F₂ bit for bit.
        for wrenches in [first_wrenches, third_wrenches] {
            prop_assert_eq!(wrenches[0].force_n, -wrenches[1].force_n);
        }
    }

    #[test]
    fn a_mirrored_contact_is_the_mirror_image((a, one, b, two) in meeting()) {
        let flip = |v: Vec2| vec2(v.x, -v.y);
        let shape = |ring: &[Vec2]| ring.iter().rev().map(|&v| flip(v)).collect::<Vec<_>>();
        let state = |s: BodyState| BodyState {
            position_m: flip(s.position_m),
            heading_rad: -s.heading_rad,
            velocity_mps: flip(s.velocity_mps),
            yaw_rate_radps: -s.yaw_rate_radps,
        };
        let (first, _) = five_steps((&a, one), (&b, two), [1, 2]);
        let (second, _) = five_steps((&shape(&a), state(one)), (&shape(&b), state(two)), [1, 2]);
        prop_assert_eq!(first.len(), second.len());
        for (c, d) in first.iter().zip(&second) {
            if first.len() == 1 {
                same_contact(c, d, flip, -1.0);
            }
        }
    }

    /// At this distance positions are representable: 1e7 m on a grid of 2⁻²⁰ m, with steps of 2⁻⁴ s.
    #[test]
    fn ten_thousand_kilometres_away_the_contact_is_the_same((a, one, b, two) in meeting()) {
        let away = |s: BodyState| BodyState { position_m: s.position_m + vec2(1e7, -1e7), ..s };
        let still = |s: BodyState| BodyState { velocity_mps: Vec2::ZERO, ..s };
        let (first, here) = five_steps((&a, still(one)), (&b, still(two)), [1, 2]);
        let (second, there) = five_steps((&a, away(still(one))), (&b, away(still(two))), [1, 2]);
        prop_assert_eq!(here, there); // to the bit: only differences of positions count
        prop_assert_eq!(first.len(), second.len());
        for (c, d) in first.iter().zip(&second) {
            prop_assert_eq!(c.area_m2, d.area_m2);
            prop_assert_eq!(c.arm_1_m, d.arm_1_m);
            prop_assert_eq!(c.normal, d.normal);
        }
    }

    #[test]
    fn at_any_heading_the_contact_is_the_same((a, one, b, two) in meeting(), turn in 0.0..6.3f64) {
        let (sin, cos) = libm::sincos(turn);
        let rotate = |v: Vec2| vec2(cos * v.x - sin * v.y, sin * v.x + cos * v.y);
        let back = |v: Vec2| vec2(cos * v.x + sin * v.y, -sin * v.x + cos * v.y);
        let state = |s: BodyState| BodyState {
            position_m: rotate(s.position_m),
            heading_rad: s.heading_rad + turn,
            velocity_mps: rotate(s.velocity_mps),
            ..s
        };
        let (first, _) = five_steps((&a, one), (&b, two), [1, 2]);
        let (second, _) = five_steps((&a, state(one)), (&b, state(two)), [1, 2]);
        prop_assert_eq!(first.len(), second.len());
        for (c, d) in first.iter().zip(&second) {
            if first.len() == 1 {
                same_contact(c, d, back, 1.0);
            }
        }
    }
}

/// Seven overlapping bodies, 40 steps, in several orders: equal bits of wrenches and snapshots.
#[test]
fn the_order_in_which_bodies_are_added_changes_no_bit() {
    let shapes: Vec<(u64, Vec<Vec2>, BodyState)> = (0..7u64)
        .map(|i| {
            let shape = if i % 2 == 0 { stepped_ship() } else { hull(60.0, 20.0, 16) };
            let (sin, cos) = libm::sincos(0.9 * i as f64);
            let state = BodyState {
                position_m: vec2(30.0 * cos * i as f64 / 3.0, 20.0 * sin * i as f64 / 3.0),
                heading_rad: 1.3 * i as f64,
                velocity_mps: vec2(-cos, -sin),
                yaw_rate_radps: 0.01 * sin,
            };
            (100 - 7 * i, shape, state)
        })
        .collect();
    let run = |order: &[usize]| -> (Vec<Vec<Wrench>>, Vec<u8>) {
        let bodies =
            order.iter().map(|&i| body(shapes[i].0, &shapes[i].1, i != 3)).collect::<Vec<_>>();
        let mut run = Run::new(model(bodies, PAPER));
        let mut states: Vec<BodyState> = order.iter().map(|&i| shapes[i].2).collect();
        let mut wrenches = Vec::new();
        let mut contacts = 0;
        for _ in 0..40 {
            contacts += run.step(&states, 0.1).len();
            states.iter_mut().for_each(|s| *s = moved(*s, 0.1));
            let mut in_order = vec![Wrench::default(); 7];
            order.iter().zip(run.work.wrenches()).for_each(|(&i, w)| in_order[i] = *w);
            wrenches.push(in_order);
        }
        assert!(contacts > 100);
        (wrenches, snapshot(&run.memory))
    };
    let first = run(&[0, 1, 2, 3, 4, 5, 6]);
    for order in [[6, 5, 4, 3, 2, 1, 0], [3, 0, 6, 1, 5, 2, 4], [1, 0, 2, 4, 3, 6, 5]] {
        let other = run(&order);
        assert_eq!(first.0, other.0, "{order:?}");
        assert_eq!(first.1, other.1, "{order:?}");
    }
}

fn snapshot(memory: &Memory) -> Vec<u8> {
    memory.snapshot()
}
