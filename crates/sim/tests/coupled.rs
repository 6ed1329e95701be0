//! The coupled method against every row of docs/contact_model.md, section 5: what the paper's method gets
//! wrong, with the right answers.

mod support;

use fenderline_contact::{EventKind, Material, vec2};
use fenderline_sim::{
    BodySetup, Integrator, Load, Method, NamedMaterial, PairSetup, Setup, Simulation,
};
use proptest::prelude::*;
use support::{fixed, floating, rectangle, spring, two};

fn run(setup: Setup) -> Simulation {
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    simulation
}

/// A ship 200 m × 32 m, sideways against `count` fenders 4 m wide spread along her side, `gap_m` off.
fn ship_and_fenders(
    count: usize,
    gap_m: f64,
    material: Material,
    step_s: f64,
    duration_s: f64,
) -> Setup {
    let mut bodies = vec![floating("ship", rectangle(200.0, 32.0), 1e8, 50.0)];
    for k in 0..count {
        let mut fender: BodySetup = fixed(&format!("fender {k:02}"), rectangle(4.0, 4.0));
        let spread = if count == 1 { 0.0 } else { -80.0 + 160.0 * k as f64 / (count - 1) as f64 };
        fender.position_m = vec2(spread, 18.0 + gap_m);
        bodies.push(fender);
    }
    let pairs = (1..=count).map(|k| PairSetup { bodies: [0, k], material: 0 }).collect();
    Setup {
        step_s,
        duration_s,
        integrator: Integrator::SemiImplicit,
        method: Method::Coupled,
        bodies,
        materials: vec![NamedMaterial { name: "rubber".into(), material }],
        pairs,
        all_other_pairs: None,
        fenders: vec![],
        berthing: None,
        loads: vec![],
        world: fenderline_sim::WorldSetup::default(),
    }
}

fn steady(body: usize, east_n: f64, north_n: f64) -> Load {
    Load {
        body,
        force_n: vec2(north_n, east_n),
        moment_nm: 0.0,
        from_s: 0.0,
        until_s: f64::INFINITY,
    }
}

#[test]
fn a_ship_pushed_on_a_fender_rests_at_force_over_stiffness() {
    for step_s in [0.1, 0.5, 1.0, 2.0] {
        let mut setup = ship_and_fenders(1, 0.0, spring(500e3, 0.1), step_s, 900.0);
        setup.loads.push(steady(0, 500e3, 0.0));
        let simulation = run(setup);
        let depth_m = simulation.states()[0].position_m.y;
        assert!((depth_m / 0.25 - 1.0).abs() < 0.005, "Δt {step_s}: {depth_m} m, not 0.25 m");
        assert!(simulation.states()[0].velocity_mps.y.abs() < 1e-6);
    }
}

#[test]
fn a_ship_on_many_fenders_rebounds_at_gamma_whatever_their_number_stiffness_and_time_step() {
    for count in [1, 2, 8, 20] {
        for stiffness in [0.5e6, 50e6] {
            for step_s in [0.1, 1.0] {
                let mut setup = ship_and_fenders(count, 0.5, spring(stiffness, 0.1), step_s, 120.0);
                setup.bodies[0].velocity.sway_mps = 0.3;
                let simulation = run(setup);
                let rebound = -simulation.states()[0].velocity_mps.y;
                assert!(
                    (rebound / 0.03 - 1.0).abs() < 0.03,
                    "{count} fenders of {stiffness} N/m², Δt {step_s}: {rebound} m/s, not 0.03"
                );
                assert!(simulation.states()[0].yaw_rate_radps.abs() < 1e-9);
            }
        }
    }
}

/// A tug 32 m × 10 m, 1000 t, bow against a wall.
fn tug_at_a_wall(gap_m: f64, speed_mps: f64, material: Material, step_s: f64) -> Setup {
    let mut setup = ship_and_fenders(0, 0.0, material, step_s, 120.0);
    let mut tug = floating("tug", rectangle(32.0, 10.0), 1e6, 8.0);
    tug.velocity.surge_mps = speed_mps;
    let mut wall = fixed("wall", rectangle(20.0, 100.0));
    wall.position_m = vec2(26.0 + gap_m, 0.0);
    setup.bodies = vec![tug, wall];
    setup.pairs = vec![PairSetup { bodies: [0, 1], material: 0 }];
    setup
}

#[test]
fn a_tug_that_pushes_on_a_wall_does_not_creep() {
    for step_s in [0.1, 0.5, 1.0, 2.0] {
        let mut setup = tug_at_a_wall(0.0, 0.0, spring(400e3, 0.1), step_s);
        setup.loads.push(steady(0, 0.0, 500e3));
        let simulation = run(setup);
        let depth_m = simulation.states()[0].position_m.x;
        assert!((depth_m / 0.125 - 1.0).abs() < 0.005, "Δt {step_s}: {depth_m} m, not 0.125 m");
    }
}

#[test]
fn a_tug_does_not_leave_faster_than_it_came() {
    for gamma in [0.0, 0.1, 0.5, 0.9] {
        for step_s in [0.01, 0.1, 0.5, 1.0, 2.0] {
            let simulation = run(tug_at_a_wall(2.0, 2.06, spring(500e3, gamma), step_s));
            let left = -simulation.states()[0].velocity_mps.x;
            assert!(
                (left - gamma * 2.06).abs() < 0.03 * 2.06,
                "γ {gamma}, Δt {step_s}: {left} m/s"
            );
            assert!(left <= 2.06);
        }
    }
}

#[test]
fn two_seconds_a_step_give_the_peak_and_depth_of_a_hundredth() {
    let result = |step_s| {
        let simulation = run(tug_at_a_wall(2.0, 2.06, spring(500e3, 0.1), step_s));
        let pair = simulation.pair_summaries()[0].clone();
        (pair.peak_normal_force_n, pair.peak_depth_m, -simulation.states()[0].velocity_mps.x)
    };
    // ω = √(5) rad/s: depth v/ω, force kw v/ω.
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
fn a_moored_ship_held_by_friction_does_not_creep_along() {
    let mut rubber = spring(500e3, 0.1);
    rubber.shear_stiffness_npm = 3e6;
    rubber.friction_static = 0.5;
    rubber.friction_dynamic = 0.4;
    for step_s in [0.1, 1.0] {
        let mut setup = ship_and_fenders(8, 0.0, rubber, step_s, 3600.0);
        setup.loads.push(steady(0, 800e3, 200e3));
        let mut simulation = Simulation::new(setup).unwrap();
        // Her swing on the shear springs, which nothing but the rebound damps, has died out then.
        let mut at_rest = None;
        while !simulation.is_done() {
            simulation.step().unwrap();
            if at_rest.is_none() && simulation.time_s() >= 1800.0 {
                at_rest = Some(simulation.states()[0].position_m);
            }
        }
        let drift_m = (simulation.states()[0].position_m - at_rest.unwrap()).length();
        assert!(drift_m < 1e-4, "Δt {step_s}: drifted {drift_m} m in half an hour");
    }
}

/// Eight fenders, friction, loads and a tug against the other side: several islands and many patches.
fn busy_berth(step_s: f64) -> Setup {
    let mut rubber = spring(500e3, 0.1);
    rubber.shear_stiffness_npm = 3e6;
    rubber.friction_static = 0.5;
    rubber.friction_dynamic = 0.4;
    rubber.damping_nspm2 = 2e4;
    let mut setup = ship_and_fenders(8, 0.3, rubber, step_s, 100.0);
    setup.bodies[0].velocity.sway_mps = 0.2;
    setup.bodies[0].velocity.surge_mps = 0.1;
    setup.bodies[0].heading_rad = 0.03;
    let ship = setup.bodies[0].mass.as_mut().expect("she floats");
    ship.added_sway_kg = 0.6 * ship.mass_kg;
    ship.added_surge_kg = 0.03 * ship.mass_kg;
    let mut tug = floating("tug", rectangle(32.0, 10.0), 1e6, 8.0);
    tug.heading_rad = std::f64::consts::FRAC_PI_2;
    tug.position_m = vec2(40.0, -34.0);
    tug.velocity.surge_mps = 0.5;
    setup.bodies.push(tug);
    setup.pairs.push(PairSetup { bodies: [0, 9], material: 0 });
    setup.loads.push(steady(9, 400e3, 0.0));
    setup
}

#[test]
fn the_order_of_bodies_changes_no_bit() {
    let setup = busy_berth(0.2);
    let mut turned = setup.clone();
    turned.bodies.reverse();
    let last = setup.bodies.len() - 1;
    turned.pairs.reverse();
    for pair in &mut turned.pairs {
        pair.bodies = pair.bodies.map(|body| last - body);
    }
    turned.loads[0].body = last - turned.loads[0].body;
    let (one, two) = (run(setup), run(turned));
    for (body, state) in one.states().iter().enumerate() {
        assert_eq!(*state, two.states()[last - body], "body {body}");
    }
    assert_eq!(one.memory().snapshot(), two.memory().snapshot());
}

#[test]
fn a_restored_snapshot_replays_the_run_bit_for_bit() {
    let mut simulation = Simulation::new(busy_berth(0.2)).unwrap();
    for _ in 0..60 {
        simulation.step().unwrap();
    }
    assert!(simulation.memory().touching_patches() > 2, "taken in mid-contact");
    let bytes = simulation.memory().snapshot();
    let mut memory = fenderline_contact::Memory::new(simulation.model());
    memory.restore(simulation.model(), &bytes).unwrap();
    assert_eq!(memory, *simulation.memory());
    let model = simulation.model().clone();
    let mut work = fenderline_contact::Workspace::new(&model);
    let mut states = simulation.states().to_vec();
    let mut loads = vec![fenderline_contact::Wrench::default(); states.len()];
    loads[9].force_n = vec2(0.0, 400e3);
    // The engine alone, from the restored memory and from the old one, each in its own workspace.
    let mut other_memory = simulation.memory().clone();
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
fn contact_gives_no_energy_in_a_busy_berth() {
    for step_s in [0.1, 0.5, 2.0] {
        let energy = run(busy_berth(step_s)).energy();
        assert!(energy.normal_work_j + energy.tangential_work_j < 0.0, "Δt {step_s}: {energy:?}");
        assert!(energy.kinetic_j.is_finite());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    /// Oblique hits with friction, at any time step: with chord normals too, nobody left with more
    /// energy than it came with, and the solve settled within its bounded work. (1e-9: rounding.)
    #[test]
    fn a_hit_makes_no_energy_and_the_solve_settles(
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
        let mut setup =
            two(tug, ship, rubber, Integrator::SemiImplicit, step_s, 60.0);
        setup.method = Method::Coupled;
        let mut simulation = Simulation::new(setup).unwrap();
        let before_j = simulation.energy().kinetic_j;
        while !simulation.is_done() {
            let record = simulation.step().unwrap();
            prop_assert!(record.events.iter().all(|e| e.kind != EventKind::NotConverged));
        }
        prop_assert!(simulation.energy().kinetic_j <= before_j * (1.0 + 1e-9));
    }
}
