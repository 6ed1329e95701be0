//! Two floating bodies, one of them with fenders. The properties in these tests need no reference data.

use crate::small_host;

use std::f64::consts::FRAC_PI_2;

use fenderline_contact::{FenderLaw, Material, Vec2, vec2};
use proptest::prelude::*;
use small_host::scenes::{FENDER_HEIGHT_M, cone_fender, ship, tug};
use small_host::{
    BodySetup, Host, Integrator, Method, PairSetup, Scene, floating, rectangle, spring,
};

/// A pontoon of `mass_kg` with five cone fenders on its west side, and a tug with her bow at the fenders.
fn pontoon_and_tug(mass_kg: f64, facing: Material, step_s: f64) -> Scene {
    let pontoon = floating("pontoon", rectangle(60.0, 20.0), mass_kg, 18.0);
    let mut boat = floating("tug", tug().outline, 1e6, 8.0);
    boat.heading_rad = FRAC_PI_2;
    boat.position_m = vec2(0.0, -10.0 - FENDER_HEIGHT_M - 16.0 - 0.3);
    boat.velocity.surge_mps = 0.6;
    let mut scene = Scene {
        step_s,
        duration_s: 40.0,
        integrator: Integrator::SemiImplicit,
        method: Method::Coupled,
        bodies: vec![pontoon, boat],
        materials: vec![],
        pairs: vec![PairSetup { bodies: [0, 1], material: 0 }],
        fenders: vec![],
        loads: vec![],
    };
    scene.materials = vec![spring(50e6, 0.1), facing]; // steel, and the fenders' facing
    for k in 0..5 {
        let along_m = 4.0 * (f64::from(k) - 2.0);
        let mut fender = cone_fender(&format!("fender {k}"), along_m, FENDER_HEIGHT_M, 0.6e6);
        fender.position_m.y = -10.0;
        scene.fenders.push(fender);
    }
    scene
}

fn facing(friction: f64, restitution: f64) -> Material {
    Material {
        shear_stiffness_npm: 3e6,
        friction_static: friction,
        friction_dynamic: 0.8 * friction,
        damping_nspm2: 2e4,
        ..spring(400e3, restitution)
    }
}

#[test]
fn a_symmetric_impact_on_fenders_leaves_no_yaw() {
    for step_s in [0.05, 0.1, 0.5, 1.0, 2.0] {
        for law in [None, Some(FenderLaw::Area), Some(FenderLaw::linear(1e6))] {
            let mut scene = pontoon_and_tug(5e6, facing(0.3, 0.5), step_s);
            for fender in &mut scene.fenders {
                if let Some(law) = &law {
                    fender.law = law.clone();
                }
            }
            let mut host = Host::new(scene);
            while !host.is_done() {
                host.step();
                let spin_radps = [0, 1].map(|body| host.states[body].yaw_rate_radps.abs());
                assert!(
                    spin_radps.iter().all(|&r| r <= 1e-9),
                    "Δt {step_s}, {law:?}: {spin_radps:?}"
                );
            }
            assert!(host.fenders.len() >= 3);
            assert!(host.states[1].velocity_mps.y < host.states[0].velocity_mps.y);
        }
    }
}

#[test]
fn a_ship_sideways_on_eight_fenders_rebounds_without_yaw() {
    for step_s in [0.1, 1.0] {
        let mut scene = small_host::scenes::oblique_berthing(step_s);
        scene.bodies[1] = BodySetup {
            outline: rectangle(298.0, 46.0),
            position_m: vec2(0.0, -FENDER_HEIGHT_M - 23.0 - 0.3),
            ..ship()
        };
        scene.bodies[1].velocity.sway_mps = 0.15;
        let mut host = Host::new(scene);
        while !host.is_done() {
            host.step();
        }
        let state = host.states[1];
        assert!(state.yaw_rate_radps.abs() <= 1e-9 && state.velocity_mps.y < -0.01, "{state:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// With fenders, friction and damping, at any time step. The tolerance of 1e-10 is for rounding in some thousand
    /// sub-steps.
    #[test]
    fn momentum_of_a_free_pair_is_constant_to_rounding(
        log_mass in 5.5..8.0_f64,
        along_m in -9.0..9.0_f64,
        heading in -0.7..0.7_f64,
        slide_mps in -0.4..0.4_f64,
        spin in -0.03..0.03_f64,
        friction in 0.0..0.8_f64,
        restitution in 0.0..0.9_f64,
        step_s in 0.02..1.5_f64,
    ) {
        let mass_kg = libm::exp10(log_mass);
        let mut scene = pontoon_and_tug(mass_kg, facing(friction, restitution), step_s);
        let boat = &mut scene.bodies[1];
        boat.heading_rad += heading;
        boat.position_m += vec2(along_m, -3.0);
        boat.velocity.sway_mps = slide_mps;
        boat.velocity.yaw_radps = spin;
        let mut host = Host::new(scene);
        let (linear, angular) = host.momentum();
        while !host.is_done() {
            host.step();
            let sum = host.work.wrenches()[0].force_n + host.work.wrenches()[1].force_n;
            prop_assert_eq!(sum, Vec2::ZERO, "F₁ = −F₂ bit for bit");
        }
        let (linear_after, angular_after) = host.momentum();
        let scale = linear.length() + 1e5;
        prop_assert!((linear_after - linear).length() <= 1e-10 * scale);
        prop_assert!((angular_after - angular).abs() <= 1e-10 * scale * 60.0);
    }
}
