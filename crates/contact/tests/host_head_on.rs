//! Co-simulation hosts with old states and without loads, in one dimension, compared with closed forms. A tug of 1000 t
//! hits a wall with k·width = 6.5 MN/m (docs/contact_model.md, section 6, item 7).

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

#[allow(dead_code, reason = "each test uses its own part of the master")]
use crate::master;

use fenderline_contact::{
    BodyState, HostIntegration, HostSettings, Memory, Mobility, Workspace, Wrench, advance, vec2,
};
use master::{Master, Scene, Service, model, rectangle, rubber, tug_at_a_wall};

const SPEED_MPS: f64 = 2.06;
const PUSH_N: f64 = 500e3;
const STIFFNESS_NPM: f64 = 6.5e6;
/// This gap is longer than the tug's way in a step of 2 s. A forward Euler host moves with its old velocity in the
/// first step. From a smaller gap the tug would be in the wall before any force can act.
const GAP_M: f64 = 5.0;
const INTEGRATIONS: [HostIntegration; 2] =
    [HostIntegration::ForwardEuler, HostIntegration::SemiImplicit];

/// The speed at which the tug leaves the wall, after a run.
fn rebound_mps(mut master: Master, step_s: f64) -> f64 {
    master.run(step_s, 60.0);
    -master.states()[0].velocity_mps.x
}

/// The tug at rest at the wall, with a steady push.
fn pushed(restitution: f64) -> Scene {
    let mut scene = tug_at_a_wall(0.0, 0.0, restitution);
    scene.loads[0].force_n.x = PUSH_N;
    scene
}

#[test]
fn a_tug_rebounds_at_gamma_for_any_delay_integrator_and_step() {
    for integration in INTEGRATIONS {
        for gamma in [0.0, 0.1, 0.5, 0.9] {
            for step_s in [0.1, 0.5, 2.0] {
                for delay_steps in 0..=3 {
                    let scene = tug_at_a_wall(GAP_M, SPEED_MPS, gamma);
                    let left = rebound_mps(Master::known(scene, integration, delay_steps), step_s);
                    // The limit is exact except for rounding.
                    assert!(
                        (left - gamma * SPEED_MPS).abs() < 1e-9,
                        "{integration:?}, γ {gamma}, Δt {step_s}, delay {delay_steps}: {left} m/s"
                    );
                }
            }
        }
    }
}

/// With forward Euler and no limit of the force (γ = 1), the paper's method lets her leave at 3.0 m/s
/// (`crates/contact/tests/paper_method_against_coupled.rs`).
#[test]
fn a_forward_euler_tug_does_not_rebound_faster_than_she_hits() {
    for integration in INTEGRATIONS {
        for step_s in [0.1, 0.5, 1.0, 2.0] {
            for delay_steps in 0..=2 {
                let scene = tug_at_a_wall(GAP_M, SPEED_MPS, 1.0);
                let left = rebound_mps(Master::known(scene, integration, delay_steps), step_s);
                assert!(left <= SPEED_MPS + 1e-9, "Δt {step_s}, delay {delay_steps}: {left} m/s");
                // No energy is lost either. The 1 % is for the sub-step in which the contact begins.
                assert!(left > 0.99 * SPEED_MPS, "Δt {step_s}, delay {delay_steps}: {left} m/s");
            }
        }
    }
}

#[test]
fn the_hosts_position_reaches_the_right_depth() {
    // The depth v/ω of a half sine.
    let depth_m = SPEED_MPS / (STIFFNESS_NPM / 1e6_f64).sqrt();
    for integration in INTEGRATIONS {
        for delay_steps in 0..=2 {
            let scene = tug_at_a_wall(1.7, SPEED_MPS, 0.1);
            let mut master = Master::known(scene, integration, delay_steps);
            master.run(0.1, 20.0);
            let furthest_m = master.past.iter().map(|s| s[0].position_m.x).fold(0.0, f64::max);
            let deepest_m = furthest_m - 1.7;
            // The 1.5 % are for the engine's sub-steps, and for the time of 0.1 s between samples.
            assert!(
                (deepest_m / depth_m - 1.0).abs() < 0.015,
                "{integration:?}, delay {delay_steps}: {deepest_m} m, not {depth_m} m"
            );
        }
    }
}

#[test]
fn a_tug_pushed_by_an_unreported_load_rests_at_force_over_stiffness() {
    for integration in INTEGRATIONS {
        // γ = 0.9 with 2 s is left out. The load is unknown for up to 6 s, in which she moves 12 m into the wall. She
        // is then thrown off and turned.
        for (gamma, steps_s) in [(0.1, [0.1, 0.5, 2.0].as_slice()), (0.9, &[0.1, 0.5])] {
            for &step_s in steps_s {
                for delay_steps in 0..=2 {
                    let mut master = Master::known(pushed(gamma), integration, delay_steps);
                    master.run(step_s, 600.0);
                    let state = master.states()[0];
                    let depth_m = state.position_m.x;
                    // At rest only the law matters. The difference is a motion that still decays.
                    assert!(
                        (depth_m / (PUSH_N / STIFFNESS_NPM) - 1.0).abs() < 1e-6,
                        "{integration:?}, γ {gamma}, Δt {step_s}, delay {delay_steps}: {depth_m} m"
                    );
                    assert!(state.velocity_mps.x.abs() < 1e-7);
                    let observed_n = master.work.loads()[0].force_n.x;
                    assert!((observed_n / PUSH_N - 1.0).abs() < 1e-6, "{observed_n} N");
                    let given_n = master.work.wrenches()[0].force_n.x;
                    assert!((given_n / PUSH_N + 1.0).abs() < 1e-6, "{given_n} N");
                }
            }
        }
    }
}

#[test]
fn reported_loads_work_as_well_as_observed_ones() {
    for delay_steps in 0..=2 {
        let integration = HostIntegration::ForwardEuler;
        let settings = HostSettings { delay_steps, integration };
        let service = Service::CoSimWithLoads(settings);
        let mut master = Master::new(pushed(0.1), integration, delay_steps, service);
        master.run(0.5, 600.0);
        let depth_m = master.states()[0].position_m.x;
        assert!((depth_m / (PUSH_N / STIFFNESS_NPM) - 1.0).abs() < 1e-6, "{depth_m} m");
    }
}

/// This test shows the purpose of the predictor. A prototype without it left at 0.89 and 2.47 m/s. The tolerance at 0.1
/// s is 2 %: the prototype's gap is unknown, and the result depends on when the first step touches (here the gap is
/// that of the paper's Fig. 8). At 0.5 s the tug leaves faster than she came. The engine's release of stored energy
/// adds more speed; the prototype did not have this release.
#[test]
fn without_the_predictor_a_delay_accelerates_the_tug() {
    let left = |step_s| {
        let scene = tug_at_a_wall(1.7, SPEED_MPS, 0.1);
        rebound_mps(
            Master::new(scene, HostIntegration::ForwardEuler, 1, Service::AdvanceWithoutLoads),
            step_s,
        )
    };
    assert!((left(0.1) / 0.89 - 1.0).abs() < 0.02, "{} m/s", left(0.1));
    assert!(left(0.5) > SPEED_MPS, "{} m/s", left(0.5));
    // The other measures do not help a host whose delay is unknown to the engine.
    for integration in INTEGRATIONS {
        let service = Service::CoSim(HostSettings { delay_steps: 0, integration });
        let scene = tug_at_a_wall(1.7, SPEED_MPS, 0.1);
        let left = rebound_mps(Master::new(scene, integration, 1, service), 0.1);
        assert!(left > 0.8, "{integration:?}: {left} m/s");
    }
}

/// This test shows the purpose of the observer: without it the limiter does not resist the load.
#[test]
fn without_the_observer_a_steady_load_pushes_the_tug_too_deep() {
    // She is long enough to stay in one dimension: she can neither get inside the wall nor turn.
    let still = Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 1e25 };
    let bodies = [(rectangle(200.0, 13.0), still), (rectangle(200.0, 100.0), Mobility::Fixed)];
    let wall = BodyState { position_m: vec2(200.0, 0.0), ..BodyState::default() };
    let push = Wrench { force_n: vec2(PUSH_N, 0.0), moment_nm: 0.0 };
    let scene = Scene {
        model: model(&bodies, rubber(500e3, 0.1, 0.0)),
        states: vec![BodyState::default(), wall],
        loads: vec![push, Wrench::default()],
    };
    let depth_m = |delay_steps, service| {
        let integration = HostIntegration::ForwardEuler;
        let mut master = Master::new(scene.clone(), integration, delay_steps, service);
        master.run(0.1, 600.0);
        master.states()[0].position_m.x
    };
    for delay_steps in [0, 1] {
        let integration = HostIntegration::ForwardEuler;
        let settings = HostSettings { delay_steps, integration };
        let with_m = depth_m(delay_steps, Service::CoSim(settings));
        assert!((with_m / (PUSH_N / STIFFNESS_NPM) - 1.0).abs() < 1e-6, "{with_m} m");
        // With a delay, the prototype went into the wall by 15.7 and 24.6 m. In this engine the stored energy is
        // released without a known load against it, and the depth is wrong by a factor.
        for without in [Service::AdvanceWithoutLoads, Service::CoSimWithoutObserver(settings)] {
            let creep_m = depth_m(delay_steps, without);
            assert!(creep_m > 3.0 * with_m, "delay {delay_steps}: {creep_m} m");
        }
    }
}

/// A load varies between 250 and 750 kN in 60 s. The host does not report it. The host's contact follows the load about
/// as closely as the engine's own motion with the load reported.
#[test]
fn a_slow_unreported_load_is_followed_as_by_the_engine() {
    let (step_s, omega) = (0.1, core::f64::consts::TAU / 60.0);
    let load_n = |step: u32| PUSH_N * (1.0 + 0.5 * libm::sin(omega * f64::from(step) * step_s));
    let worst = |carried_n: &mut dyn FnMut(f64) -> f64| {
        (0..3000)
            .map(|step| (step, (carried_n(load_n(step)) - load_n(step)).abs()))
            .filter(|(step, _)| *step > 600)
            .map(|(_, off_n)| off_n)
            .fold(0.0, f64::max)
    };
    let mut scene = pushed(0.1);
    let (mut memory, mut work) = (Memory::new(&scene.model), Workspace::new(&scene.model));
    let engine_n = worst(&mut |now_n| {
        scene.loads[0].force_n.x = now_n;
        let (states, loads) = (&scene.states, &scene.loads);
        advance(&scene.model, &mut memory, &mut work, states, loads, step_s).expect("good states");
        scene.states.copy_from_slice(work.states_after());
        -work.wrenches()[0].force_n.x
    });
    for integration in INTEGRATIONS {
        for delay_steps in 0..=2_u32 {
            let mut master = Master::known(pushed(0.1), integration, delay_steps);
            let host_n = worst(&mut |now_n| {
                master.scene.loads[0].force_n.x = now_n;
                master.step(step_s);
                -master.work.wrenches()[0].force_n.x
            });
            // The change of the load until the engine knows it: the delay, the observer's step, and one more step in
            // which the velocity gained meanwhile is removed.
            let late_n = 0.5 * PUSH_N * omega * step_s * f64::from(delay_steps + 2);
            assert!(
                host_n < engine_n + late_n,
                "{integration:?}, {delay_steps}: {host_n} N, {engine_n} + {late_n} N"
            );
        }
    }
}
