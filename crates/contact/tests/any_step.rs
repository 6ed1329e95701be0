//! The coupled method at long time steps, compared with its own converged solution: peak force, peak depth and final
//! speeds.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

use crate::small_host;

use fenderline_contact::BodyState;
use small_host::scenes::{oblique_berthing, oblique_tug_impact, tug_impact, tug_push};
use small_host::{Host, Method, Scene};

/// Time step of the converged solution (s).
const CONVERGED_S: f64 = 1e-3;

/// Allowed relative deviation.
const TOLERANCE: f64 = 0.02;

/// The compared results of a run.
#[derive(Debug)]
struct Outcome {
    /// Peak normal force and peak depth of every contact, in a fixed order.
    peaks: Vec<(String, f64, f64)>,
    after: Vec<BodyState>,
    /// For each body, the scales for final velocities: its largest speed in the run, and the larger of two rates of
    /// turn. One is its largest rate; the other is the rate with the same energy in yaw.
    fastest: Vec<(f64, f64)>,
}

fn outcome(scene: Scene) -> Outcome {
    let mut host = Host::new(scene);
    let mut fastest = vec![(0.0_f64, 0.0_f64); host.states.len()];
    while !host.is_done() {
        host.step();
        for (most, state) in fastest.iter_mut().zip(&host.states) {
            most.0 = most.0.max(state.velocity_mps.length());
            most.1 = most.1.max(state.yaw_rate_radps.abs());
        }
    }
    for (most, body) in fastest.iter_mut().zip(&host.scene.bodies) {
        let Some(mass) = body.mass else { continue };
        let gyradius_m = (mass.yaw_inertia_kgm2 / mass.mass_kg).sqrt();
        most.1 = most.1.max(most.0 / gyradius_m);
    }
    // Contacts with the quay are compared by fender. In a long step, a sum over the pair would add peaks of different
    // times.
    let has_fenders = !host.scene.fenders.is_empty();
    let is_quay = |bodies: [usize; 2]| has_fenders && bodies[0] == 0;
    let pairs = host.pairs.iter().filter(|(bodies, _)| !is_quay(*bodies));
    let mut peaks: Vec<_> = pairs
        .map(|(bodies, peaks)| (format!("pair {bodies:?}"), peaks.force_n, peaks.depth_m))
        .collect();
    let fenders = host.fenders.iter();
    peaks.extend(
        fenders.map(|(fender, peaks)| (format!("fender {fender}"), peaks.force_n, peaks.depth_m)),
    );
    Outcome { peaks, after: host.states.clone(), fastest }
}

/// A final velocity below this share of the largest velocity in the run counts as zero.
const NEXT_TO_ZERO: f64 = 0.05;

/// The scale of a deviation from `right`: `right` itself, or the largest value in the run if `right` counts as zero.
/// After ten minutes, the rest of a swing on undamped springs may have any phase.
fn scale(right: f64, largest: f64) -> f64 {
    if right < NEXT_TO_ZERO * largest { largest } else { right }
}

/// Compares peaks relative to the largest peak of the same kind in the scene, because the eighth fender of a row is
/// barely touched.
fn assert_close(what: &str, ours: &Outcome, converged: &Outcome) {
    let largest =
        |of: fn(&(String, f64, f64)) -> f64| converged.peaks.iter().map(of).fold(0.0, f64::max);
    let (force_n, depth_m) = (largest(|p| p.1), largest(|p| p.2));
    assert_eq!(ours.peaks.len(), converged.peaks.len(), "{what}: {ours:?}");
    for (one, right) in ours.peaks.iter().zip(&converged.peaks) {
        assert_eq!(one.0, right.0, "{what}");
        assert!((one.1 - right.1).abs() <= TOLERANCE * force_n, "{what}: {one:?} {right:?}");
        assert!((one.2 - right.2).abs() <= TOLERANCE * depth_m, "{what}: {one:?} {right:?}");
    }
    for body in 0..ours.after.len() {
        let (one, right) = (ours.after[body], converged.after[body]);
        let (speed_mps, turn_radps) = converged.fastest[body];
        let off_mps = (one.velocity_mps - right.velocity_mps).length();
        let scale_mps = scale(right.velocity_mps.length(), speed_mps);
        assert!(
            off_mps <= TOLERANCE * scale_mps,
            "{what}, body {body}: {one:?} {right:?} of {scale_mps} m/s"
        );
        let off_radps = (one.yaw_rate_radps - right.yaw_rate_radps).abs();
        let scale_radps = scale(right.yaw_rate_radps.abs(), turn_radps);
        assert!(
            off_radps <= TOLERANCE * scale_radps,
            "{what}, body {body}: {one:?} {right:?} of {scale_radps} rad/s"
        );
    }
}

fn assert_any_step(what: &str, scene: impl Fn(f64) -> Scene, steps_s: &[f64]) {
    let converged = outcome(scene(CONVERGED_S));
    for &step_s in steps_s {
        assert_close(&format!("{what}, Δt {step_s}"), &outcome(scene(step_s)), &converged);
    }
}

const STEPS_S: [f64; 4] = [0.1, 0.5, 1.0, 2.0];

#[test]
fn tug_impact_converges_at_any_time_step() {
    assert_any_step("amidships", |step_s| tug_impact(2.06, 0.0, step_s), &STEPS_S);
    assert_any_step("60 m forward", |step_s| tug_impact(2.06, 60.0, step_s), &STEPS_S);
}

#[test]
fn oblique_berthing_converges_at_any_time_step() {
    assert_any_step("berthing", oblique_berthing, &STEPS_S);
}

#[test]
fn oblique_tug_impact_converges_at_any_time_step() {
    // The steps leave out 2 s. The Coriolis terms of her added mass are loads, constant over a step. At 2 s these terms
    // alone change her speed by 3.6 %.
    assert_any_step("20° off square", |step_s| oblique_tug_impact(2.06, step_s), &STEPS_S[..3]);
}

#[test]
fn tug_push_converges_at_any_time_step() {
    assert_any_step("push", tug_push, &STEPS_S);
}

/// The sum of mean force times Δt was wrong by up to 0.8 % where the length of the sub-steps changed within a contact.
#[test]
fn the_impulse_of_a_pair_equals_the_change_of_momentum() {
    for (method, damping_nspm2) in
        [(Method::Coupled, 0.0), (Method::Coupled, 1e5), (Method::Paper, 0.0), (Method::Paper, 1e5)]
    {
        for step_s in [0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 1.0, 2.0] {
            let mut scene = tug_impact(2.06, 0.0, step_s);
            scene.method = method;
            scene.materials[0].damping_nspm2 = damping_nspm2;
            let ship = scene.bodies[0].mass.expect("a ship that floats");
            let mass_kg = ship.mass_kg
                + match method {
                    Method::Coupled => ship.added_sway_kg,
                    // In the paper's method a body has one mass for all directions.
                    Method::Paper => ship.added_surge_kg,
                };
            let mut host = Host::new(scene);
            while !host.is_done() {
                host.step();
            }
            let [(_, pair)] = *host.pairs else { panic!("one pair") };
            // In a head-on impact the ship, which was at rest, gets the whole impulse.
            let right_ns = mass_kg * host.states[0].velocity_mps.length();
            let off = pair.impulse_ns / right_ns - 1.0;
            let case = format!("{method:?}, {damping_nspm2} N·s/m², Δt {step_s}");
            assert!(off.abs() < 1e-9, "{case}: {} of {right_ns} N·s", pair.impulse_ns);
        }
    }
}
