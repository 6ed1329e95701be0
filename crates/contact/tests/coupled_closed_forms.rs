//! The coupled method in every case of docs/contact_model.md, section 5. The paper's method fails in these cases.

use crate::small_host;

use fenderline_contact::{EventKind, Material, vec2};
use proptest::prelude::*;
use small_host::{
    BodySetup, Host, Integrator, Load, Method, PairSetup, Scene, fixed, floating, rectangle,
    spring, two,
};

/// A ship of 200 m × 32 m, `gap_m` sideways from `count` fenders along her side. Each fender is 4 m wide.
fn ship_and_fenders(
    count: usize,
    gap_m: f64,
    material: Material,
    step_s: f64,
    duration_s: f64,
) -> Scene {
    let mut bodies = vec![floating("ship", rectangle(200.0, 32.0), 1e8, 50.0)];
    for k in 0..count {
        let mut fender: BodySetup = fixed(&format!("fender {k:02}"), rectangle(4.0, 4.0));
        let spread = if count == 1 { 0.0 } else { -80.0 + 160.0 * k as f64 / (count - 1) as f64 };
        fender.position_m = vec2(spread, 18.0 + gap_m);
        bodies.push(fender);
    }
    let pairs = (1..=count).map(|k| PairSetup { bodies: [0, k], material: 0 }).collect();
    Scene {
        step_s,
        duration_s,
        integrator: Integrator::SemiImplicit,
        method: Method::Coupled,
        bodies,
        materials: vec![material],
        pairs,
        fenders: vec![],
        loads: vec![],
    }
}

fn steady(body: usize, east_n: f64, north_n: f64) -> Load {
    Load { body, force_n: vec2(north_n, east_n) }
}

#[test]
fn a_ship_pushed_on_a_fender_rests_at_force_over_stiffness() {
    for step_s in [0.1, 0.5, 1.0, 2.0] {
        let mut scene = ship_and_fenders(1, 0.0, spring(500e3, 0.1), step_s, 900.0);
        scene.loads.push(steady(0, 500e3, 0.0));
        let host = Host::run(scene);
        let depth_m = host.states[0].position_m.y;
        assert!((depth_m / 0.25 - 1.0).abs() < 0.005, "Δt {step_s}: {depth_m} m, not 0.25 m");
        assert!(host.states[0].velocity_mps.y.abs() < 1e-6);
    }
}

#[test]
fn a_ship_rebounds_at_gamma_from_any_number_of_fenders() {
    for count in [1, 2, 8, 20] {
        for stiffness in [0.5e6, 50e6] {
            for step_s in [0.1, 1.0] {
                let mut scene = ship_and_fenders(count, 0.5, spring(stiffness, 0.1), step_s, 120.0);
                scene.bodies[0].velocity.sway_mps = 0.3;
                let host = Host::run(scene);
                let rebound = -host.states[0].velocity_mps.y;
                assert!(
                    (rebound / 0.03 - 1.0).abs() < 0.03,
                    "{count} fenders of {stiffness} N/m², Δt {step_s}: {rebound} m/s, not 0.03"
                );
                assert!(host.states[0].yaw_rate_radps.abs() < 1e-9);
            }
        }
    }
}

/// A tug 32 m × 10 m, 1000 t, bow against a wall.
fn tug_at_a_wall(gap_m: f64, speed_mps: f64, material: Material, step_s: f64) -> Scene {
    let mut scene = ship_and_fenders(0, 0.0, material, step_s, 120.0);
    let mut tug = floating("tug", rectangle(32.0, 10.0), 1e6, 8.0);
    tug.velocity.surge_mps = speed_mps;
    let mut wall = fixed("wall", rectangle(20.0, 100.0));
    wall.position_m = vec2(26.0 + gap_m, 0.0);
    scene.bodies = vec![tug, wall];
    scene.pairs = vec![PairSetup { bodies: [0, 1], material: 0 }];
    scene
}

#[test]
fn a_tug_that_pushes_on_a_wall_does_not_creep() {
    for step_s in [0.1, 0.5, 1.0, 2.0] {
        let mut scene = tug_at_a_wall(0.0, 0.0, spring(400e3, 0.1), step_s);
        scene.loads.push(steady(0, 0.0, 500e3));
        let host = Host::run(scene);
        let depth_m = host.states[0].position_m.x;
        assert!((depth_m / 0.125 - 1.0).abs() < 0.005, "Δt {step_s}: {depth_m} m, not 0.125 m");
    }
}

#[test]
fn a_tug_does_not_rebound_faster_than_it_hits() {
    for gamma in [0.0, 0.1, 0.5, 0.9] {
        for step_s in [0.01, 0.1, 0.5, 1.0, 2.0] {
            let host = Host::run(tug_at_a_wall(2.0, 2.06, spring(500e3, gamma), step_s));
            let left = -host.states[0].velocity_mps.x;
            assert!(
                (left - gamma * 2.06).abs() < 0.03 * 2.06,
                "γ {gamma}, Δt {step_s}: {left} m/s"
            );
            assert!(left <= 2.06);
        }
    }
}

#[test]
fn a_step_of_2_s_gives_the_peak_and_depth_of_0_01_s() {
    let result = |step_s| {
        let host = Host::run(tug_at_a_wall(2.0, 2.06, spring(500e3, 0.1), step_s));
        let (_, peaks) = host.pairs[0];
        (peaks.force_n, peaks.depth_m, -host.states[0].velocity_mps.x)
    };
    // With ω = √5 rad/s the depth is v/ω and the force is kw v/ω.
    let omega = 5.0_f64.sqrt();
    let (depth_m, force_n) = (2.06 / omega, 5e6 * 2.06 / omega);
    for step_s in [0.01, 0.1, 0.5, 1.0, 2.0] {
        let (force, depth, left) = result(step_s);
        assert!((force / force_n - 1.0).abs() < 0.02, "Δt {step_s}: {force} N, not {force_n}");
        assert!((depth / depth_m - 1.0).abs() < 0.02, "Δt {step_s}: {depth} m, not {depth_m}");
        assert!((left / 0.206 - 1.0).abs() < 0.02, "Δt {step_s}: {left} m/s");
    }
}

#[test]
fn a_moored_ship_held_by_friction_does_not_creep() {
    let mut rubber = spring(500e3, 0.1);
    rubber.shear_stiffness_npm = 3e6;
    rubber.friction_static = 0.5;
    rubber.friction_dynamic = 0.4;
    for step_s in [0.1, 1.0] {
        let mut scene = ship_and_fenders(8, 0.0, rubber, step_s, 3600.0);
        scene.loads.push(steady(0, 800e3, 200e3));
        let mut host = Host::new(scene);
        // By this time her swing on the shear springs has decayed. Only the rebound damps it.
        let mut at_rest = None;
        while !host.is_done() {
            host.step();
            if at_rest.is_none() && host.time_s() >= 1800.0 {
                at_rest = Some(host.states[0].position_m);
            }
        }
        let drift_m = (host.states[0].position_m - at_rest.unwrap()).length();
        assert!(drift_m < 1e-4, "Δt {step_s}: drifted {drift_m} m in half an hour");
    }
}

/// Eight fenders, friction, loads and a tug against the other side: several islands and many patches.
fn busy_berth(step_s: f64) -> Scene {
    let mut rubber = spring(500e3, 0.1);
    rubber.shear_stiffness_npm = 3e6;
    rubber.friction_static = 0.5;
    rubber.friction_dynamic = 0.4;
    rubber.damping_nspm2 = 2e4;
    let mut scene = ship_and_fenders(8, 0.3, rubber, step_s, 100.0);
    scene.bodies[0].velocity.sway_mps = 0.2;
    scene.bodies[0].velocity.surge_mps = 0.1;
    scene.bodies[0].heading_rad = 0.03;
    let ship = scene.bodies[0].mass.as_mut().expect("she floats");
    ship.added_sway_kg = 0.6 * ship.mass_kg;
    ship.added_surge_kg = 0.03 * ship.mass_kg;
    let mut tug = floating("tug", rectangle(32.0, 10.0), 1e6, 8.0);
    tug.heading_rad = std::f64::consts::FRAC_PI_2;
    tug.position_m = vec2(40.0, -34.0);
    tug.velocity.surge_mps = 0.5;
    scene.bodies.push(tug);
    scene.pairs.push(PairSetup { bodies: [0, 9], material: 0 });
    scene.loads.push(steady(9, 400e3, 0.0));
    scene
}

#[test]
fn the_order_of_bodies_changes_no_bit() {
    let scene = busy_berth(0.2);
    let mut turned = scene.clone();
    turned.bodies.reverse();
    let last = scene.bodies.len() - 1;
    turned.pairs.reverse();
    for pair in &mut turned.pairs {
        pair.bodies = pair.bodies.map(|body| last - body);
    }
    turned.loads[0].body = last - turned.loads[0].body;
    let (one, two) = (Host::run(scene), Host::run(turned));
    for (body, state) in one.states.iter().enumerate() {
        assert_eq!(*state, two.states[last - body], "body {body}");
    }
    assert_eq!(one.memory.snapshot(), two.memory.snapshot());
}

#[test]
fn a_restored_snapshot_replays_the_run_bit_for_bit() {
    let mut host = Host::new(busy_berth(0.2));
    for _ in 0..60 {
        host.step();
    }
    assert!(host.memory.touching_patches() > 2, "taken in mid-contact");
    let bytes = host.memory.snapshot();
    let mut memory = fenderline_contact::Memory::new(&host.model);
    memory.restore(&host.model, &bytes).unwrap();
    assert_eq!(memory, host.memory);
    let model = host.model.clone();
    let mut work = fenderline_contact::Workspace::new(&model);
    let mut states = host.states.to_vec();
    let mut loads = vec![fenderline_contact::Wrench::default(); states.len()];
    loads[9].force_n = vec2(0.0, 400e3);
    // Runs the engine alone, from the restored memory and from the original memory. Each run has its own workspace.
    let mut other_memory = host.memory.clone();
    let mut other_work = fenderline_contact::Workspace::new(&model);
    let mut other_states = states.clone();
    for _ in 0..1000 {
        fenderline_contact::advance(&model, &mut memory, &mut work, &states, &loads, 0.2).unwrap();
        fenderline_contact::advance(
            &model,
            &mut other_memory,
            &mut other_work,
            &other_states,
            &loads,
            0.2,
        )
        .unwrap();
        states.copy_from_slice(work.states_after());
        other_states.copy_from_slice(other_work.states_after());
        assert_eq!(states, other_states);
    }
    assert_eq!(memory.snapshot(), other_memory.snapshot());
}

#[test]
fn contacts_make_no_energy_at_a_busy_berth() {
    for step_s in [0.1, 0.5, 2.0] {
        let host = Host::run(busy_berth(step_s));
        assert!(host.contact_work_j < 0.0, "Δt {step_s}: {} J", host.contact_work_j);
        assert!(host.kinetic_j().is_finite());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// Oblique impacts with friction at any time step, including those with chord normals. No energy is created, and
    /// the solve converges within its iteration limit. The tolerance of 1e-9 is for rounding.
    #[test]
    fn an_impact_makes_no_energy_and_the_solve_converges(
        y in -40.0..40.0_f64,
        heading in -0.6..0.6_f64,
        surge in 0.2..3.2_f64,
        sway in -0.5..0.5_f64,
        spin in -0.05..0.05_f64,
        log_stiffness in 5.7..8.3_f64,
        log_shear in 6.5..8.2_f64,
        restitution in 0.0..0.9_f64,
        friction in 0.0..1.0_f64,
        sliding_share in 0.0..=1.0_f64,
        anisotropic in any::<bool>(),
        step_s in prop_oneof![Just(0.05), Just(0.1), Just(0.5), Just(1.0), Just(2.0)],
    ) {
        let mut tug = floating("tug", rectangle(32.0, 13.0), 1.01e6, 8.0);
        tug.velocity.surge_mps = surge;
        tug.velocity.sway_mps = sway;
        tug.velocity.yaw_radps = spin;
        tug.heading_rad = heading;
        tug.position_m = vec2(-45.0, y);
        let mut ship = floating("ship", rectangle(46.0, 120.0), 9e7, 30.0);
        if anisotropic {
            ship.mass.as_mut().expect("she floats").added_sway_kg = 4e7;
        }
        let mut rubber = spring(libm::exp10(log_stiffness), restitution);
        rubber.shear_stiffness_npm = libm::exp10(log_shear);
        rubber.friction_static = friction;
        rubber.friction_dynamic = friction * sliding_share;
        let mut scene =
            two(tug, ship, rubber, Integrator::SemiImplicit, step_s, 60.0);
        scene.method = Method::Coupled;
        let mut host = Host::new(scene);
        let before_j = host.kinetic_j();
        while !host.is_done() {
            host.step();
            prop_assert!(host.work.events().iter().all(|e| e.kind != EventKind::NotConverged));
        }
        prop_assert!(host.kinetic_j() <= before_j * (1.0 + 1e-9));
    }
}
