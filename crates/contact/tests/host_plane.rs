//! Co-simulation hosts with old states and without loads, in the plane, with bodies that turn in contact. The reference
//! is the engine's own motion, which other tests compare with closed forms.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

#[allow(dead_code, reason = "each test uses its own part of the master")]
use crate::master;

use fenderline_contact::{BodyState, HostIntegration, HostSettings, Mobility};
use master::{
    Master, Scene, Service, converged, moved_by_the_engine, ship_on_a_fender, ship_on_two_fenders,
    tug_against_a_ship,
};

const INTEGRATIONS: [HostIntegration; 2] =
    [HostIntegration::ForwardEuler, HostIntegration::SemiImplicit];

/// The largest relative difference of speed and yaw rate over all floating bodies.
fn difference(scene: &Scene, ours: &[BodyState], theirs: &[BodyState]) -> f64 {
    let floats = |index: &usize| scene.model.bodies()[*index].mobility != Mobility::Fixed;
    (0..ours.len())
        .filter(floats)
        .map(|index| {
            let (one, two) = (&ours[index], &theirs[index]);
            let linear = (one.velocity_mps - two.velocity_mps).length() / two.velocity_mps.length();
            linear.max((one.yaw_rate_radps / two.yaw_rate_radps - 1.0).abs())
        })
        .fold(0.0, f64::max)
}

fn every_master(scene: &Scene, duration_s: f64, check: impl Fn(&[BodyState], f64, &str)) {
    for integration in INTEGRATIONS {
        for step_s in [0.1, 0.5] {
            for delay_steps in 0..=2 {
                let mut master = Master::known(scene.clone(), integration, delay_steps);
                master.run(step_s, duration_s);
                let who = format!("{integration:?}, Δt {step_s}, delay {delay_steps}");
                check(master.states(), step_s, &who);
            }
        }
    }
}

#[test]
fn a_ship_that_turns_on_a_fender_rebounds_like_the_converged_solution() {
    let scene = ship_on_a_fender(0.0, 5e6);
    let right = converged(&scene, 30.0);
    assert!(right[0].yaw_rate_radps.abs() > 3e-3, "she turns");
    every_master(&scene, 30.0, |states, _, who| {
        let off = difference(&scene, states, &right);
        assert!(off < 0.01, "{who}: {off}");
    });
}

#[test]
fn a_tug_that_turns_on_a_free_ship_rebounds_like_the_converged_solution() {
    let scene = tug_against_a_ship(0.0);
    let right = converged(&scene, 30.0);
    assert!(right[0].yaw_rate_radps.abs() > 0.02, "she turns");
    every_master(&scene, 30.0, |states, _, who| {
        let off = difference(&scene, states, &right);
        assert!(off < 0.01, "{who}: {off}");
    });
}

/// With friction the engine's result depends on its sub-steps. The host is therefore compared with the engine at the
/// same step. The tolerance of 1e-6 is for rounding, which alternating friction amplifies.
#[test]
fn with_friction_a_host_follows_the_engine() {
    for scene in [ship_on_a_fender(0.5, 5e6), ship_on_a_fender(0.2, 5e6), tug_against_a_ship(0.5)] {
        let right = [0.1, 0.5].map(|step_s| moved_by_the_engine(&scene, step_s, 30.0));
        every_master(&scene, 30.0, |states, step_s, who| {
            let off = difference(&scene, states, &right[usize::from(step_s == 0.5)]);
            assert!(off < 1e-6, "{who}: {off}");
        });
    }
}

#[test]
fn the_mean_wrench_alone_does_not_keep_a_forward_euler_host_with_the_engine() {
    let scene = tug_against_a_ship(0.0);
    let right = converged(&scene, 30.0);
    for step_s in [0.1, 0.5] {
        let integration = HostIntegration::ForwardEuler;
        let mut master = Master::new(scene.clone(), integration, 0, Service::Advance);
        master.run(step_s, 30.0);
        let off = difference(&scene, master.states(), &right);
        // This is five times the tolerance for `CoSimHost`.
        assert!(off > 0.05, "Δt {step_s}: {off}");
    }
}

#[test]
fn a_load_ahead_of_midships_is_shared_by_two_fenders_by_its_lever() {
    let scene = ship_on_two_fenders(0.0);
    for integration in INTEGRATIONS {
        for step_s in [0.1, 0.5] {
            for delay_steps in 0..=2 {
                let mut master = Master::known(scene.clone(), integration, delay_steps);
                master.run(step_s, 200.0);
                // The load of 1 MN and 20 MN·m on levers of 60 and −40 m gives 600 and 400 kN. On 4 m of 1 MN/m² these
                // are 0.15 and 0.10 m. The 1 % is for her turn by 5e-4 rad and her slide by 0.1 m.
                let who = format!("{integration:?}, Δt {step_s}, delay {delay_steps}");
                for (contact, mean_depth_m) in master.work.contacts().iter().zip([0.15, 0.10]) {
                    let found_m = contact.area_m2 / 4.0;
                    assert!((found_m / mean_depth_m - 1.0).abs() < 0.01, "{who}: {found_m} m");
                }
                assert_eq!(master.work.contacts().len(), 2, "{who}");
                let load = master.work.loads()[0];
                assert!((load.moment_nm / 2e7 - 1.0).abs() < 1e-6, "{who}: {load:?}");
            }
        }
    }
}

#[test]
fn two_free_bodies_get_opposite_forces_where_no_load_acts() {
    let scene = tug_against_a_ship(0.5);
    let mut master = Master::known(scene, HostIntegration::ForwardEuler, 1);
    let (mut largest_n, mut sum_n) = (0.0_f64, 0.0_f64);
    for _ in 0..300 {
        master.step(0.1);
        let [tug, ship] = [0, 1].map(|body| master.work.wrenches()[body].force_n);
        largest_n = largest_n.max(tug.length());
        sum_n = sum_n.max((tug + ship).length());
    }
    assert!(largest_n > 1e6);
    // The engine turns the ship's mass matrix within a step, by 1e-4 rad. The host turns it at the end of the step.
    assert!(sum_n < 1e-4 * largest_n, "{sum_n} of {largest_n} N");
}

/// A host whose masses are a tenth larger than the model's. The observer takes the difference for a load.
#[test]
fn a_host_with_other_masses_still_comes_to_rest() {
    let scene = ship_on_two_fenders(0.0);
    for delay_steps in 0..=2 {
        let mut master = Master::known(scene.clone(), HostIntegration::ForwardEuler, delay_steps);
        master.mass_factor = 1.1;
        master.run(0.1, 300.0);
        for (contact, mean_depth_m) in master.work.contacts().iter().zip([0.15, 0.10]) {
            let found_m = contact.area_m2 / 4.0;
            // The 2 % are for the same reasons; she also slides further.
            assert!((found_m / mean_depth_m - 1.0).abs() < 0.02, "{delay_steps}: {found_m} m");
        }
    }
}

#[test]
fn a_host_with_the_wrong_integrator_is_less_accurate_but_rebounds_no_faster() {
    let scene = tug_against_a_ship(0.0);
    let right = converged(&scene, 30.0);
    let settings = HostSettings { delay_steps: 0, integration: HostIntegration::SemiImplicit };
    let service = Service::CoSim(settings);
    let mut master = Master::new(scene.clone(), HostIntegration::ForwardEuler, 0, service);
    master.run(0.1, 30.0);
    let off = difference(&scene, master.states(), &right);
    assert!(off > 0.01, "{off}");
    assert!(master.states()[0].velocity_mps.length() < 2.06);
}
