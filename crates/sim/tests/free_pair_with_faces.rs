//! Two floating bodies, one with fenders: what holds without any reference data.

mod support;

use std::f64::consts::FRAC_PI_2;

use fenderline_contact::{FenderLaw, Material, Vec2, vec2};
use fenderline_sim::{Integrator, Method, NamedMaterial, PairSetup, Setup, Simulation};
use proptest::prelude::*;
use support::scenes::{FENDER_HEIGHT_M, cone_fender, ship, tug};
use support::{floating, rectangle, spring};

/// A pontoon of `mass_kg` whose western side carries five cones, and a tug bow on to them.
fn pontoon_and_tug(mass_kg: f64, facing: Material, step_s: f64) -> Setup {
    let pontoon = floating("pontoon", rectangle(60.0, 20.0), mass_kg, 18.0);
    let mut boat = floating("tug", tug().outline, 1e6, 8.0);
    boat.heading_rad = FRAC_PI_2;
    boat.position_m = vec2(0.0, -10.0 - FENDER_HEIGHT_M - 16.0 - 0.3);
    boat.velocity.surge_mps = 0.6;
    let mut setup = Setup {
        step_s,
        duration_s: 40.0,
        integrator: Integrator::SemiImplicit,
        method: Method::Coupled,
        bodies: vec![pontoon, boat],
        materials: vec![],
        pairs: vec![PairSetup { bodies: [0, 1], material: 0 }],
        all_other_pairs: None,
        fenders: vec![],
        berthing: None,
        loads: vec![],
        world: fenderline_sim::WorldSetup::default(),
    };
    setup.materials = [("steel", spring(50e6, 0.1)), ("facing", facing)]
        .map(|(name, material)| NamedMaterial { name: name.into(), material })
        .to_vec();
    for k in 0..5 {
        let along_m = 4.0 * (f64::from(k) - 2.0);
        let mut fender = cone_fender(&format!("fender {k}"), along_m, FENDER_HEIGHT_M, 0.6e6);
        fender.position_m.y = -10.0;
        setup.fenders.push(fender);
    }
    setup
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

/// Linear momentum, and angular momentum about the earth's origin.
fn momentum(simulation: &Simulation) -> (Vec2, f64) {
    let (mut linear, mut angular) = (Vec2::ZERO, 0.0);
    for (body, state) in simulation.setup().bodies.iter().zip(simulation.states()) {
        let mass = body.mass.expect("free bodies");
        let own = state.velocity_mps * mass.mass_kg;
        linear += own;
        angular += state.position_m.cross(own) + mass.yaw_inertia_kgm2 * state.yaw_rate_radps;
    }
    (linear, angular)
}

#[test]
fn a_symmetric_hit_on_faces_leaves_no_spin() {
    for step_s in [0.05, 0.1, 0.5, 1.0, 2.0] {
        for law in [None, Some(FenderLaw::Area), Some(FenderLaw::linear(1e6))] {
            let mut setup = pontoon_and_tug(5e6, facing(0.3, 0.5), step_s);
            for fender in &mut setup.fenders {
                if let Some(law) = &law {
                    (fender.law, fender.rated) = (law.clone(), None);
                }
            }
            let mut simulation = Simulation::new(setup).unwrap();
            while !simulation.is_done() {
                simulation.step().unwrap();
                let spin_radps = [0, 1].map(|body| simulation.states()[body].yaw_rate_radps.abs());
                assert!(
                    spin_radps.iter().all(|&r| r <= 1e-9),
                    "Δt {step_s}, {law:?}: {spin_radps:?}"
                );
            }
            assert!(simulation.fender_summaries().count() >= 3);
            assert!(simulation.states()[1].velocity_mps.y < simulation.states()[0].velocity_mps.y);
        }
    }
}

#[test]
fn a_ship_sideways_on_eight_fenders_leaves_without_spin() {
    for step_s in [0.1, 1.0] {
        let mut setup = support::scenes::oblique_berthing(step_s);
        setup.bodies[1] = fenderline_sim::BodySetup {
            outline: rectangle(298.0, 46.0),
            position_m: vec2(0.0, -FENDER_HEIGHT_M - 23.0 - 0.3),
            ..ship()
        };
        setup.bodies[1].velocity.sway_mps = 0.15;
        let mut simulation = Simulation::new(setup).unwrap();
        while !simulation.is_done() {
            simulation.step().unwrap();
        }
        let state = simulation.states()[1];
        assert!(state.yaw_rate_radps.abs() <= 1e-9 && state.velocity_mps.y < -0.01, "{state:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// With faces, friction and damping, at any time step. As without: 1e-10 is rounding over some
    /// thousand sub-steps.
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
        let mut setup = pontoon_and_tug(mass_kg, facing(friction, restitution), step_s);
        let boat = &mut setup.bodies[1];
        boat.heading_rad += heading;
        boat.position_m += vec2(along_m, -3.0);
        boat.velocity.sway_mps = slide_mps;
        boat.velocity.yaw_radps = spin;
        let mut simulation = Simulation::new(setup).unwrap();
        let (linear, angular) = momentum(&simulation);
        while !simulation.is_done() {
            let record = simulation.step().unwrap();
            let sum = record.wrenches[0].force_n + record.wrenches[1].force_n;
            prop_assert_eq!(sum, Vec2::ZERO, "F₁ = −F₂ bit for bit");
        }
        let (linear_after, angular_after) = momentum(&simulation);
        let scale = linear.length() + 1e5;
        prop_assert!((linear_after - linear).length() <= 1e-10 * scale);
        prop_assert!((angular_after - angular).abs() <= 1e-10 * scale * 60.0);
    }
}
