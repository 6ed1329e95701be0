//! Turning circles and zig-zags of published ships, compared with an independent calculation and with the experiment.
//!
//! AD and TD are in lengths, overshoots in degrees. The *independent* calculation is
//! validation/independent/mmg_standard.py with the same coefficients, here to two decimals (AD, TD) and one
//! (overshoots). The tolerance is 1 %, or half a unit of the last place if that is more. The *experiment* is the
//! free-running model of 7 m of Yasukawa & Yoshimura (2015). A model from captive tests is accepted within 12 % (AD,
//! TD), 4° (first overshoot) and 8° (second overshoot). The authors' own calculation misses the second overshoot by 6°.
//! overshoot) and 8° (second, which the authors' own calculation misses by 6°).

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use crate::ships;

use fenderline_sim::hydro::manoeuvres::{
    Approach, ManoeuvreError, TurningCircle, ZigZag, bollard_pull_n, crash_stop,
    self_propulsion_rps, turning_circle, zig_zag,
};
use fenderline_sim::hydro::vessels::Vessel;
use fenderline_sim::hydro::{Model3, Water};
use ships::{esso_osaka_model, kcs, kvlcc2, kvlcc2_model};

fn ready(vessel: &Vessel) -> (Model3, Approach) {
    let model = Model3::new(vessel.ship, Water::SEA);
    // The step is 0.08 s at full scale; see `half_the_time_step_moves_no_measure_by_a_thousandth`.
    let step_s = 0.002 * vessel.ship.particulars.length_m / vessel.approach_mps.unwrap();
    let approach = Approach::at(&model, vessel.approach_mps.unwrap(), vessel.steering, step_s);
    (model, approach.expect("the propeller holds the speed of approach"))
}

fn turn(vessel: &Vessel, rudder_deg: f64) -> TurningCircle {
    let (model, approach) = ready(vessel);
    turning_circle(&model, &approach, rudder_deg.to_radians()).expect("she turns")
}

/// Advance and tactical diameter in lengths.
fn diameters(vessel: &Vessel, rudder_deg: f64) -> [f64; 2] {
    let circle = turn(vessel, rudder_deg);
    let length_m = vessel.ship.particulars.length_m;
    [circle.advance_m / length_m, circle.tactical_diameter_m / length_m]
}

/// First and second overshoot in degrees.
fn overshoots(vessel: &Vessel, rudder_deg: f64) -> [f64; 2] {
    let (model, approach) = ready(vessel);
    let ZigZag { first_overshoot_rad, second_overshoot_rad, .. } =
        zig_zag(&model, &approach, rudder_deg.to_radians(), rudder_deg.to_radians().abs())
            .expect("she answers her rudder");
    [first_overshoot_rad.to_degrees(), second_overshoot_rad.to_degrees()]
}

#[track_caller]
fn independent(ours: f64, theirs: f64, last_place: f64) {
    let allowed = f64::max(0.01 * theirs, 0.5 * last_place + 1e-9);
    println!("{ours:8.3} independent {theirs} (±{allowed:.3})");
    assert!((ours - theirs).abs() <= allowed, "{ours} is not {theirs} ± {allowed}");
}

#[track_caller]
fn experiment(ours: f64, theirs: f64, allowed: f64) {
    println!("{ours:8.3} experiment {theirs} (±{allowed:.3})");
    assert!((ours - theirs).abs() <= allowed, "{ours} is not {theirs} ± {allowed}");
}

#[test]
fn kvlcc2_turns_as_in_the_independent_calculation() {
    let [advance, diameter] = diameters(&kvlcc2(), 35.0);
    independent(advance, 3.03, 0.01);
    independent(diameter, 3.01, 0.01);
    let [advance, diameter] = diameters(&kvlcc2(), -35.0);
    independent(advance, 3.05, 0.01);
    independent(diameter, 3.02, 0.01);
}

#[test]
fn kvlcc2_overshoots_as_in_the_independent_calculation() {
    let [first, second] = overshoots(&kvlcc2(), 10.0);
    independent(first, 5.4, 0.1);
    independent(second, 14.0, 0.1);
    let [first, second] = overshoots(&kvlcc2(), -10.0);
    independent(first, 7.5, 0.1);
    independent(second, 9.1, 0.1);
    independent(overshoots(&kvlcc2(), 20.0)[0], 11.9, 0.1);
    independent(overshoots(&kvlcc2(), -20.0)[0], 15.3, 0.1);
}

#[test]
fn kvlcc2_turns_and_overshoots_near_the_experiment() {
    for (rudder_deg, advance, diameter) in [(35.0, 3.25, 3.34), (-35.0, 3.11, 3.08)] {
        let ours = diameters(&kvlcc2(), rudder_deg);
        experiment(ours[0], advance, 0.12 * advance);
        experiment(ours[1], diameter, 0.12 * diameter);
    }
    for (rudder_deg, first, second) in [(10.0, 8.2, 21.9), (-10.0, 9.5, 15.0)] {
        let ours = overshoots(&kvlcc2(), rudder_deg);
        experiment(ours[0], first, 4.0);
        experiment(ours[1], second, 8.0);
    }
    experiment(overshoots(&kvlcc2(), 20.0)[0], 13.7, 4.0);
    experiment(overshoots(&kvlcc2(), -20.0)[0], 15.1, 4.0);
}

/// The paper's own calculation is for the model of 7 m. At that scale the tolerance is 8 %. (R'₀ = 0.022 allows no
/// better agreement; the ship of 320 m, with her smaller wake fraction, differs by 6 to 11 %.) Overshoots agree within
/// 2°.
#[test]
fn kvlcc2_model_turns_and_overshoots_near_the_published_calculation() {
    let vessel = kvlcc2_model();
    for (rudder_deg, published) in [(35.0, [3.31, 3.36]), (-35.0, [3.26, 3.26])] {
        let ours = diameters(&vessel, rudder_deg);
        for (ours, theirs) in ours.into_iter().zip(published) {
            experiment(ours, theirs, 0.08 * theirs);
        }
    }
    for (rudder_deg, published) in [(10.0, [5.2, 15.8]), (-10.0, [7.6, 10.2])] {
        for (ours, theirs) in overshoots(&vessel, rudder_deg).into_iter().zip(published) {
            experiment(ours, theirs, 2.0);
        }
    }
    experiment(overshoots(&vessel, 20.0)[0], 10.9, 2.0);
    experiment(overshoots(&vessel, -20.0)[0], 14.5, 2.0);
}

/// The measured steady turn at 35° has U/U₀ 0.37 and 0.36, r' 0.80 and 0.84, and drift 19.4° and 20.9° (starboard,
/// port). The tolerances are 0.03 for the speed ratio, 0.12 for r' (12 %, as for AD and TD), and 2° for the drift.
#[test]
fn kvlcc2_model_turns_steadily_near_the_measurements() {
    for (rudder_deg, ratio, yaw, drift_deg) in [(35.0, 0.37, 0.80, 19.4), (-35.0, 0.36, 0.84, 20.9)]
    {
        let steady = turn(&kvlcc2_model(), rudder_deg).steady;
        experiment(steady.speed_ratio, ratio, 0.03);
        experiment(steady.yaw_rate.abs(), yaw, 0.12 * yaw);
        experiment(steady.drift_rad.abs().to_degrees(), drift_deg, 2.0);
    }
}

#[test]
fn kvlcc2_is_self_propelled_at_the_published_revolutions() {
    let vessel = kvlcc2();
    let model = Model3::new(vessel.ship, Water::SEA);
    let rps = self_propulsion_rps(&model, vessel.approach_mps.unwrap()).expect("a balance");
    // The value is printed to four decimals, for 15.5 knots.
    assert!((rps - 1.7785).abs() < 1e-3, "{rps}");
}

#[test]
fn kcs_turns_and_overshoots_as_in_the_independent_calculation() {
    let [advance, diameter] = diameters(&kcs(), 35.0);
    independent(advance, 3.37, 0.01);
    independent(diameter, 3.59, 0.01);
    let [advance, diameter] = diameters(&kcs(), -35.0);
    independent(advance, 3.25, 0.01);
    independent(diameter, 3.36, 0.01);
    independent(overshoots(&kcs(), 10.0)[0], 6.2, 0.1);
    independent(overshoots(&kcs(), -10.0)[0], 7.8, 0.1);
    independent(overshoots(&kcs(), 20.0)[0], 13.9, 0.1);
    independent(overshoots(&kcs(), -20.0)[0], 16.3, 0.1);
}

#[test]
fn half_the_time_step_moves_no_measure_by_a_thousandth() {
    let vessel = kvlcc2();
    let (model, approach) = ready(&vessel);
    let fine = Approach { step_s: 0.5 * approach.step_s, ..approach };
    let rudder_rad = 35_f64.to_radians();
    let coarse = turning_circle(&model, &approach, rudder_rad).expect("she turns");
    let fine = turning_circle(&model, &fine, rudder_rad).expect("she turns");
    assert!((coarse.advance_m / fine.advance_m - 1.0).abs() < 1e-3);
    assert!((coarse.tactical_diameter_m / fine.tactical_diameter_m - 1.0).abs() < 1e-3);
    // An execute can be late by a step, which is 0.08 s at 0.5°/s.
    let (ten_rad, fine) =
        (10_f64.to_radians(), Approach { step_s: 0.5 * approach.step_s, ..approach });
    let coarse = zig_zag(&model, &approach, ten_rad, ten_rad).expect("she answers");
    let fine = zig_zag(&model, &fine, ten_rad, ten_rad).expect("she answers");
    let moved_rad = coarse.second_overshoot_rad - fine.second_overshoot_rad;
    assert!(moved_rad.abs().to_degrees() < 0.04, "{}", moved_rad.to_degrees());
}

#[test]
fn a_crash_stop_ends_within_imo_limits_and_in_a_straight_line() {
    let vessel = kvlcc2();
    let (model, approach) = ready(&vessel);
    // The shaft turns astern at 70 % of the revolutions, and is reversed within half a minute.
    let stop =
        crash_stop(&model, &approach, -0.7 * approach.shaft_rps, 1.7 * approach.shaft_rps / 30.0)
            .expect("she stops");
    println!("{stop:?}: {:.1} lengths", stop.track_reach_m / 320.0);
    // MSC.137(76) requires a track reach of at most 15 lengths, or up to 20 for large ships. A ship of 320 kt does not
    // stop within 5 lengths either.
    assert!((5.0..20.0).contains(&(stop.track_reach_m / 320.0)));
    // The rudder is amidships. The model is symmetric, except for the signs of γ_R and C₂.
    assert!(stop.lateral_m.abs() < 1e-6 && stop.heading_rad.abs() < 1e-9);
}

#[test]
fn a_ships_friction_is_less_than_her_models() {
    let tested = kvlcc2();
    let speed_mps = tested.approach_mps.expect("a speed");
    let ship = tested.ship.with_ships_friction(7.0, speed_mps).expect("a ship");
    let (before, after) = (tested.ship.hull.low_speed.ahead, ship.hull.low_speed.ahead);
    // By hand: C_F is 3.18·10⁻³ and 1.40·10⁻³, on 26 300 m² over 6 656 m². The difference is 0.0070 of 0.022.
    assert!((after - before - 0.0070).abs() < 1e-4, "{before} {after}");
    assert!(tested.ship.with_ships_friction(700.0, 8.0).is_err());
    assert_eq!(ship.check(), Ok(ship));
}

/// The closed form of MSC/Circ.1053, appendix 3, is for a straight track, with resistance as the square of the speed
/// and a constant thrust astern, equal to that at rest. The ship stops in S = A ln(1 + B) + C lengths. A follows from
/// mass over resistance. B is her resistance before the stop over the thrust. C follows from the time to reverse. By
/// integration A = M/(2kL) and B = ku₀²/T. By the propeller series, our thrust astern is smaller at speed than at rest.
/// Our distance must therefore be longer, but by less than a tenth.
#[test]
fn crash_stops_agree_with_the_closed_form_for_constant_thrust() {
    let tested = kvlcc2();
    let own = tested
        .ship
        .with_ships_friction(7.0, tested.approach_mps.expect("a speed"))
        .expect("a ship");
    for vessel in [tested.clone(), Vessel { ship: own, ..tested.clone() }, kcs()] {
        let (model, approach) = ready(&vessel);
        let reversal_s = 0.1 * vessel.ship.particulars.length_m / approach.speed_mps;
        let astern_rps = -0.7 * approach.shaft_rps;
        let rate_rps2 = 1.7 * approach.shaft_rps / reversal_s;
        let stop = crash_stop(&model, &approach, astern_rps, rate_rps2).expect("she stops");
        let density = model.water().density_kgpm3;
        let ship = &vessel.ship;
        let mass_kg = density * (ship.particulars.volume_m3 + ship.added_mass.surge_m3);
        let side_m2 = ship.particulars.length_m * ship.particulars.draught_m;
        let drag_npm2s2 = -0.5 * density * side_m2 * ship.hull.low_speed.ahead;
        let astern_n = -bollard_pull_n(&model, astern_rps).expect("a propeller");
        let b = drag_npm2s2 * approach.speed_mps * approach.speed_mps / astern_n;
        // C is half of the time to reverse, at the first speed.
        let theirs_m =
            mass_kg / (2.0 * drag_npm2s2) * libm::log1p(b) + 0.5 * reversal_s * approach.speed_mps;
        let ratio = stop.track_reach_m / theirs_m;
        println!(
            "{:.2} L, closed form {:.2} L",
            stop.track_reach_m / ship.particulars.length_m,
            theirs_m / ship.particulars.length_m
        );
        assert!((1.0..1.1).contains(&ratio), "{}: {ratio}", vessel.origin.title);
    }
}

/// A turn at low speed (Fn 0.07), compared with `validation/independent/esso_osaka_turning.py`.
#[test]
fn esso_osaka_turns_as_in_the_independent_calculation() {
    for (rudder_deg, theirs) in
        [(35.0, [3.444, 3.988]), (-35.0, [3.343, 3.765]), (20.0, [4.782, 6.349])]
    {
        let ours = diameters(&esso_osaka_model(), rudder_deg);
        independent(ours[0], theirs[0], 0.001);
        independent(ours[1], theirs[1], 0.001);
    }
}

#[test]
fn a_rudder_amidships_does_not_turn_a_ship() {
    let (model, approach) = ready(&kvlcc2());
    let error = turning_circle(&model, &approach, 0.0).expect_err("no turn");
    assert!(matches!(error, ManoeuvreError::NotReached { .. }), "{error}");
}
