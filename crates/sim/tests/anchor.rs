//! Anchors: chain, holding power, dragging and windlass. Chain and bottom only take energy.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::ChainGrade;
use fenderline_sim::anchor::*;
use proptest::prelude::*;

const WATER: f64 = 1025.0;

/// The anchor of a ship of 200 m: 9 t, a chain of 78 mm and grade 2, 11 shackles.
fn gear() -> AnchorGear {
    let mut gear = AnchorGear {
        name: "port".into(),
        mass_kg: 9000.0,
        chain_diameter_m: 0.078,
        chain_grade: ChainGrade::U2,
        chain_length_m: 11.0 * SHACKLE_M,
        holding_factor: 3.0,
        dragging_factor: 1.5,
        chain_friction: 0.75,
        windlass: Windlass { brake_n: 1.0, pull_n: 1.0, heave_mps: 0.15, let_go_mps: 5.0 },
    };
    gear.windlass = Windlass::of_rules(&gear.chain());
    gear
}

fn hawse(at_m: Vec2, above_bottom_m: f64) -> Hawse {
    Hawse { at_m, above_bottom_m: Some(above_bottom_m) }
}

/// Takes a step of 0.5 s and returns its events.
fn step(
    gear: &AnchorGear,
    state: &mut AnchorState,
    hawse: &Hawse,
    last_n: f64,
) -> (AnchorLoad, Vec<AnchorEvent>) {
    let mut events = Vec::new();
    let given = AnchorStep { last_n, water_kgpm3: WATER, step_s: 0.5 };
    let load = gear.step(state, hawse, given, &mut |event| events.push(event));
    (load, events)
}

/// A chain has 21.9 t/m·d², here 133.24 kg/m. In sea water its weight is 0.8694 times that, times 9.80665: 1136.0 N/m.
#[test]
fn a_chain_weighs_what_its_size_says() {
    let gear = gear();
    let weight_npm = 21.9e3 * 0.078 * 0.078 * 9.80665 * (1.0 - 1025.0 / 7850.0);
    assert!((gear.chain_weight_npm(WATER) / weight_npm - 1.0).abs() < 1e-12);
    assert!((weight_npm - 1136.0).abs() < 0.1, "{weight_npm}");
    // UR A3 gives 42.5 N per mm².
    assert!((gear.windlass.pull_n - 42.5 * 78.0 * 78.0).abs() < 1e-6);
    assert!((gear.windlass.brake_n / gear.chain().break_load_n() - 0.45).abs() < 1e-12);
}

/// The closed form without stretch: s = √(h² + 2ha), span = L − s + a·asinh(s/a), T = H + wh. The chain stretches by
/// H/EA, 150 kN over 614 MN. This is 2.4e-4 of its length and changes H by less than 3 %.
#[test]
fn the_pull_is_that_of_the_catenary() {
    let gear = gear();
    let (h_n, rise_m, chain_m): (f64, f64, f64) = (150e3, 28.0, 5.0 * SHACKLE_M);
    let weight_npm = gear.chain_weight_npm(WATER);
    let a_m = h_n / weight_npm;
    let s_m = (rise_m * rise_m + 2.0 * rise_m * a_m).sqrt();
    assert!(s_m < chain_m);
    let span_m = chain_m - s_m + a_m * (s_m / a_m).asinh();
    let mut state = AnchorState::on_bottom(Vec2::ZERO, chain_m);
    let (load, events) = step(&gear, &mut state, &hawse(vec2(span_m, 0.0), rise_m), 0.0);
    assert_eq!(events, []);
    let horizontal_n = -load.on_ship_n[0];
    println!("H {horizontal_n}, T {}", load.tension_n);
    assert!((horizontal_n / h_n - 1.0).abs() < 0.03, "{horizontal_n}");
    assert!((load.tension_n / (horizontal_n + weight_npm * rise_m) - 1.0).abs() < 1e-3);
    assert!((load.on_bottom_m / (chain_m - s_m) - 1.0).abs() < 0.03, "{}", load.on_bottom_m);
    // The holding power is 3 times the anchor's weight in air, plus 0.75 of the weight of the chain on the bottom.
    let holding_n = 3.0 * 9000.0 * 9.80665 + 0.75 * weight_npm * load.on_bottom_m;
    assert!((load.holding_n / holding_n - 1.0).abs() < 1e-12);
    assert_eq!(load.moved_m, 0.0);
}

/// A ship goes away at 0.5 m/s. The pull rises to the holding power, falls to the dragging resistance and stays there.
#[test]
fn an_anchor_drags_beyond_its_holding_power_with_a_steady_resistance() {
    let gear = gear();
    let (rise_m, chain_m) = (28.0, 5.0 * SHACKLE_M);
    let mut state = AnchorState::on_bottom(Vec2::ZERO, chain_m);
    let (mut most_n, mut all) = (0.0_f64, Vec::new());
    let mut last = AnchorLoad::default();
    for index in 0..600 {
        let at_m = vec2(100.0 + 0.25 * f64::from(index), 0.0);
        let (load, events) = step(&gear, &mut state, &hawse(at_m, rise_m), last.tension_n);
        all.extend(events);
        if !state.dragging {
            most_n = most_n.max(-load.on_ship_n[0]);
        }
        last = load;
    }
    assert_eq!(all, [AnchorEvent::Drags]);
    let weight_n = 9000.0 * 9.80665;
    assert!(most_n > 2.7 * weight_n, "{most_n}");
    // Just before the anchor drags, it is held with some chain on the bottom.
    assert!(most_n < 3.0 * weight_n + 0.75 * gear.chain_weight_npm(WATER) * chain_m);
    let steady_n = 1.5 * weight_n + 0.75 * gear.chain_weight_npm(WATER) * last.on_bottom_m;
    assert!((-last.on_ship_n[0] / steady_n - 1.0).abs() < 1e-6);
    assert!((last.holding_n / steady_n - 1.0).abs() < 1e-6);
    // The anchor follows the ship: the distance stays the same.
    assert!((last.moved_m - 0.25).abs() < 1e-6, "{}", last.moved_m);
    // The anchor took the work of the pull along its way. An anchor that stops holds again.
    assert!((state.dragged_j / state.dragged_m / steady_n - 1.0).abs() < 0.02);
    let AnchorPosition::OnBottom(place_m) = state.position else { panic!("on the bottom") };
    let (_, events) = step(&gear, &mut state, &hawse(place_m, rise_m), 0.0);
    assert_eq!(events, [AnchorEvent::Holds]);
}

/// At short scope (1.2 of the depth) the shank is lifted. The anchor is dredged with less than half its weight.
#[test]
fn a_dredged_anchor_at_short_scope_resists_less() {
    let gear = gear();
    let (rise_m, chain_m) = (24.0, 29.0);
    let mut state = AnchorState::on_bottom(Vec2::ZERO, chain_m);
    let mut last = AnchorLoad::default();
    for index in 0..200 {
        let at_m = vec2(0.25 * f64::from(index), 0.0);
        last = step(&gear, &mut state, &hawse(at_m, rise_m), last.tension_n).0;
    }
    let pull_n = -last.on_ship_n[0];
    println!("dredged with {pull_n} N, {:?}", last.stay());
    assert!(state.dragging && last.on_bottom_m == 0.0);
    assert!(pull_n > 0.1 * 9000.0 * 9.80665 && pull_n < 0.75 * 9000.0 * 9.80665, "{pull_n}");
    assert!((pull_n / last.holding_n - 1.0).abs() < 1e-6);
}

#[test]
fn an_anchor_is_let_go_held_hove_in_and_comes_home() {
    let gear = gear();
    let place = hawse(vec2(10.0, 5.0), 28.0);
    let mut state = AnchorState::housed();
    assert_eq!(step(&gear, &mut state, &place, 0.0), (AnchorLoad::default(), vec![]));
    state.order = WindlassOrder::LetGo(3.0 * SHACKLE_M);
    let mut events = Vec::new();
    let mut last_n = 0.0;
    let mut run = |state: &mut AnchorState, steps: usize, last_n: &mut f64| {
        for _ in 0..steps {
            let (load, now) = step(&gear, state, &place, *last_n);
            *last_n = load.tension_n;
            events.extend(now);
        }
    };
    // At 5 m/s, 82.5 m take 16.5 s.
    run(&mut state, 33, &mut last_n);
    assert_eq!((state.chain_m, state.order), (82.5, WindlassOrder::Hold));
    assert_eq!(state.position, AnchorPosition::OnBottom(vec2(10.0, 5.0)));
    // The chain hangs straight down, with its weight over 28 m.
    assert!((last_n / (28.0 * gear.chain_weight_npm(WATER)) - 1.0).abs() < 1e-3, "{last_n}");
    // At 0.15 m/s, 82.5 m take 550 s. At 28 m the anchor comes off the bottom.
    state.order = WindlassOrder::Heave(0.0);
    run(&mut state, 740, &mut last_n);
    assert_eq!(state.position, AnchorPosition::Hanging);
    let hangs_n =
        gear.anchor_weight_in_water_n(WATER) + gear.chain_weight_npm(WATER) * state.chain_m;
    assert!((last_n / hangs_n - 1.0).abs() < 1e-12);
    run(&mut state, 370, &mut last_n);
    assert_eq!(state, AnchorState::housed());
    assert_eq!(events, [AnchorEvent::OnBottom, AnchorEvent::Aweigh, AnchorEvent::Home]);
}

/// A windlass without power neither veers nor heaves, but the anchor can be let go.
#[test]
fn a_windlass_without_power_only_lets_go() {
    let gear = gear();
    let place = hawse(Vec2::ZERO, 28.0);
    let faults = AnchorFaults { windlass_failed: true, ..AnchorFaults::default() };
    let mut state = AnchorState { faults, ..AnchorState::on_bottom(Vec2::ZERO, 50.0) };
    for order in [WindlassOrder::Heave(0.0), WindlassOrder::Veer(80.0)] {
        state.order = order;
        step(&gear, &mut state, &place, 0.0);
        assert_eq!((state.chain_m, state.order), (50.0, order));
    }
    state.order = WindlassOrder::LetGo(80.0);
    step(&gear, &mut state, &place, 0.0);
    assert_eq!(state.chain_m, 52.5);
}

/// An anchor that does not bite holds as little as a dragging anchor.
#[test]
fn an_anchor_that_does_not_bite_drags_under_less() {
    let gear = gear();
    let faults = AnchorFaults { does_not_bite: true, ..AnchorFaults::default() };
    let mut state = AnchorState { faults, ..AnchorState::on_bottom(Vec2::ZERO, 5.0 * SHACKLE_M) };
    let mut most_n = 0.0_f64;
    for index in 0..400 {
        let at_m = vec2(100.0 + 0.25 * f64::from(index), 0.0);
        most_n = most_n.max(-step(&gear, &mut state, &hawse(at_m, 28.0), 0.0).0.on_ship_n[0]);
    }
    assert!(state.dragging && most_n < 2.0 * 9000.0 * 9.80665, "{most_n}");
}

/// The anchor is so heavy that it holds more than the chain. The brake renders at 45 % of the break load, and all chain
/// runs out. The bitter end holds 30 % and gives way. With a brake that holds, the chain parts.
#[test]
fn the_brake_renders_until_the_bitter_end_gives_way_and_a_chain_that_is_held_parts() {
    let mut gear =
        AnchorGear { mass_kg: 9e4, holding_factor: 100.0, dragging_factor: 100.0, ..gear() };
    let away = |gear: &AnchorGear| {
        let mut state = AnchorState::on_bottom(Vec2::ZERO, 5.0 * SHACKLE_M);
        let (mut events, mut most_n, mut lost_at_n) = (Vec::new(), 0.0_f64, None);
        for index in 0..2000 {
            let at_m = vec2(30.0 + 0.25 * f64::from(index), 0.0);
            let (load, now) = step(gear, &mut state, &hawse(at_m, 28.0), 0.0);
            events.extend(now);
            most_n = most_n.max(load.tension_n);
            lost_at_n = lost_at_n.or(load.lost_at_n);
        }
        (state, events, most_n, lost_at_n.expect("lost"))
    };
    let (state, events, most_n, lost_at_n) = away(&gear);
    assert_eq!(events, [AnchorEvent::Renders, AnchorEvent::RanOut]);
    assert_eq!(state.position, AnchorPosition::Lost(LostBy::RanOut));
    let brake_n = gear.windlass.brake_n;
    assert!(most_n <= brake_n * (1.0 + 1e-9) && lost_at_n > brake_n, "{most_n} {lost_at_n}");
    gear.windlass.brake_n = 1e9;
    let (state, events, most_n, lost_at_n) = away(&gear);
    assert_eq!(events, [AnchorEvent::Parted]);
    assert_eq!(state.position, AnchorPosition::Lost(LostBy::Parted));
    let break_load_n = gear.chain().break_load_n();
    assert!(most_n <= break_load_n && lost_at_n > break_load_n, "{most_n} {lost_at_n}");
}

/// The setup is mirrored at the north axis. The results are mirrored bit for bit.
#[test]
fn port_and_starboard_are_mirrored() {
    let gear = gear();
    let [mut port, mut starboard] = [-1.0, 1.0].map(|_| AnchorState::on_bottom(Vec2::ZERO, 80.0));
    for index in 0..300 {
        let t = f64::from(index);
        let at_m = |side: f64| vec2(60.0 + 0.3 * t, side * 20.0 * (0.05 * t).sin());
        let (one, _) = step(&gear, &mut port, &hawse(at_m(-1.0), 28.0), 0.0);
        let (other, _) = step(&gear, &mut starboard, &hawse(at_m(1.0), 28.0), 0.0);
        assert_eq!(one.on_ship_n[0], other.on_ship_n[0]);
        assert_eq!(one.on_ship_n[1], -other.on_ship_n[1]);
    }
    assert!(port.dragging && starboard.dragging);
}

proptest! {
    /// The hawse pipe moves round any closed course, with the chain held. Chain and bottom take energy and give none.
    /// The course begins where the chain stores nothing. The work is computed with the mean of the forces of two steps.
    /// For a force with a potential this is exact, except for the curvature over 0.25 m: less than 0.1 % of the energy
    /// that goes to and fro.
    #[test]
    fn chain_and_bottom_only_take_energy(
        radius_m in 5.0..120.0_f64,
        away_m in 0.0..60.0_f64,
        flat in 0.1..1.0_f64,
        chain_m in 35.0..200.0_f64,
    ) {
        let gear = gear();
        let rise_m = 28.0;
        let mut state = AnchorState::on_bottom(Vec2::ZERO, chain_m);
        let steps = (radius_m * std::f64::consts::TAU / 0.25).ceil();
        let at_m = |k: f64| {
            let angle = std::f64::consts::TAU * k / steps;
            vec2(away_m + radius_m * angle.sin(), flat * radius_m * (1.0 - angle.cos()))
        };
        // At this distance the chain hangs straight down, and the rest of it lies slack.
        let start_m = at_m(0.0);
        let slack = away_m + rise_m <= chain_m;
        prop_assume!(slack);
        let (mut work_j, mut taken_j, mut before_n) = (0.0, 0.0, Vec2::ZERO);
        let mut here_m = start_m;
        for k in 0..=steps as usize {
            let next_m = at_m(k as f64);
            let (load, _) = step(&gear, &mut state, &hawse(next_m, rise_m), 0.0);
            let force_n = vec2(load.on_ship_n[0], load.on_ship_n[1]);
            let moved = (next_m - here_m).dot((force_n + before_n) * 0.5);
            work_j += moved;
            taken_j += moved.abs();
            (before_n, here_m) = (force_n, next_m);
        }
        prop_assert!(work_j <= 1e-3 * taken_j + 1.0, "{work_j} of {taken_j}");
    }
}
