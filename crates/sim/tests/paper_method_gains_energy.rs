//! The paper's method created up to 179 % of the energy of an impact, and no output reported it.

#![allow(clippy::disallowed_methods, reason = "what is drawn, not what is computed")]

use crate::support;

use fenderline_sim::{Integrator, Method, Setup, Simulation};
use support::{fixed, floating, rectangle, spring, two};

/// A tug of 1,000 t that turns while she hits a wall. `draw` gives a number between two bounds.
fn hit(draw: &mut dyn FnMut(f64, f64) -> f64, step_s: f64, method: Method) -> Simulation {
    let mut tug = floating("tug", rectangle(32.0, 10.0), 1e6, draw(5.0, 15.0));
    (tug.velocity.surge_mps, tug.velocity.sway_mps) = (draw(0.3, 2.0), draw(-1.0, 1.0));
    tug.velocity.yaw_radps = draw(-0.05, 0.05);
    tug.heading_rad = draw(-1.3, 1.3);
    let mut wall = fixed("wall", rectangle(20.0, 200.0));
    wall.position_m.x = 26.0 + draw(1.5, 4.0);
    let material = spring(10_f64.powf(draw(4.5, 8.0)), draw(0.0, 1.0));
    let integrator = match method {
        Method::Paper => Integrator::Euler,
        Method::Coupled => Integrator::SemiImplicit,
    };
    let setup = two(tug, wall, material, integrator, step_s, 60.0);
    let mut run = Simulation::new(Setup { method, ..setup }).expect("a sound set-up");
    while !run.is_done() {
        run.step().expect("a step");
    }
    run
}

/// Random numbers between bounds from a seed.
fn drawn(seed: u64) -> impl FnMut(f64, f64) -> f64 {
    let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
    move |low, high| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        low + (high - low) * (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

#[test]
fn energy_generated_by_the_papers_method_is_reported() {
    let mut told = 0;
    for seed in 0..2000 {
        let run = hit(&mut drawn(seed), 2.0, Method::Paper);
        let energy = run.energy();
        // Only the wall does work on the tug. Its work is the change of her energy.
        let start_j = energy.kinetic_j - energy.normal_work_j - energy.tangential_work_j;
        let made_j = energy.kinetic_j - start_j;
        if made_j > 0.01 * energy.contact_taken_j {
            let gain = run
                .energy_gain()
                .unwrap_or_else(|| panic!("{made_j} J of {start_j} J, seed {seed}"));
            assert!(gain.gained_j >= made_j * (1.0 - 1e-9), "{gain:?} beside {made_j} J");
            let text = gain.to_string();
            assert!(text.contains("shorter `step`") && text.contains("coupled"), "{text}");
            told += 1;
        }
    }
    assert!(told > 10, "the cases no longer show it: {told}");
}

#[test]
fn a_run_without_a_gain_of_energy_reports_none() {
    for seed in 0..40 {
        assert_eq!(hit(&mut drawn(seed), 2.0, Method::Coupled).energy_gain(), None, "seed {seed}");
    }
}
