//! Stiff contacts of hosts that move their bodies themselves.

#[allow(dead_code, reason = "each test uses its own part of the master")]
use crate::master;

use fenderline_contact::{
    Body, BodyId, BodyState, DirectHost, HostIntegration, HostSettings, HostWorkspace, Material,
    Memory, Mobility, Model, Pair, Workspace, Wrench, advance, advance_from_engine_states, vec2,
};
use master::{Master, Scene, Service, rectangle};

fn two_ships_and_a_tug(load_n: f64, stiffness_npm2: f64) -> Scene {
    let free = |mass_kg: f64| Mobility::Free { mass_kg, yaw_inertia_kgm2: mass_kg * 2000.0 };
    let bodies = [
        ("inner ship", rectangle(20.0, 150.0), free(1.5e7)),
        ("outer ship", rectangle(20.0, 150.0), free(2e7)),
        ("tug", rectangle(30.0, 10.0), free(8e5)),
        ("quay", rectangle(40.0, 400.0), Mobility::Fixed),
    ];
    let mut builder = Model::builder();
    for (key, (name, outline, mobility)) in (0..).zip(bodies) {
        builder.body(Body { name: name.into(), key, outline, mobility });
    }
    let material = builder.material(Material {
        stiffness_npm2,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e7,
        friction_static: 0.3,
        friction_dynamic: 0.3,
        restitution: 0.1,
    });
    for [a, b] in [[0, 1], [1, 2], [0, 3]] {
        builder.pair(Pair { bodies: [BodyId(a), BodyId(b)], material });
    }
    let at = |x: f64, y: f64| BodyState { position_m: vec2(x, y), ..BodyState::default() };
    let mut loads = vec![Wrench::default(); 4];
    loads[2].force_n = vec2(load_n, 0.0);
    Scene {
        model: builder.build().expect("a good model"),
        states: vec![at(-0.3, 0.0), at(-20.5, 5.0), at(-46.0, 20.0), at(30.0, 0.0)],
        loads,
    }
}

/// Frames from 1/60 s to 0.5 s, pseudo-random by Knuth's generator; without `jitter` all frames are 0.2 s.
fn frames(jitter: bool) -> impl FnMut() -> f64 {
    let mut dice = 7_u64;
    move || {
        dice = dice.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        let share = (dice >> 11) as f64 / (1_u64 << 53) as f64;
        if jitter { 1.0 / 60.0 + 0.48 * share } else { 0.2 }
    }
}

/// With `advance` and a host's own integration, the tug's force alternated between 0 and 1.7 MN, with 1,400 events of
/// beginning and end. The host's position after a frame differed from the engine's.
#[test]
fn two_stiff_ships_and_a_pushing_tug_do_not_chatter() {
    for stiffness_npm2 in [1e6, 1e7] {
        for integration in [HostIntegration::ForwardEuler, HostIntegration::SemiImplicit] {
            let settings = HostSettings { delay_steps: 0, integration };
            for service in [Service::Direct, Service::CoSim(settings)] {
                for jitter in [false, true] {
                    let scene = two_ships_and_a_tug(500e3, stiffness_npm2);
                    let mut master = Master::new(scene, integration, 0, service);
                    let mut next_s = frames(jitter);
                    let who =
                        format!("{stiffness_npm2} N/m², {service:?}, {integration:?}, {jitter}");
                    let (mut events, mut time_s) = (0, 0.0);
                    while time_s < 240.0 {
                        let step_s = next_s();
                        time_s += step_s;
                        master.step(step_s);
                        events += master.events().len();
                        let push = master.wrenches()[2].force_n.length() / 500e3;
                        assert!(time_s < 120.0 || (push - 1.0).abs() < 0.05, "{who}: {push}");
                    }
                    assert!(events < 30, "{who}: {events} events");
                    let tug_m = master.states()[2].position_m;
                    // Each contact yields by at most 500 kN over its stiffness.
                    let right_m = -45.0 + 500e3 / stiffness_npm2 * (0.1 + 2.0 / 150.0);
                    assert!((tug_m.x - right_m).abs() < 0.01, "{who}: {tug_m:?}, not {right_m}");
                }
            }
        }
    }
}

/// If a host passes the engine's states back, its results have the engine's bits.
#[test]
fn a_host_that_lets_the_engine_move_its_bodies_gets_the_bits_of_advance() {
    let Scene { model, mut states, loads } = two_ships_and_a_tug(500e3, 1e7);
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let (mut host, mut host_work) = (DirectHost::new(&model), HostWorkspace::new(&model));
    let mut next_s = frames(true);
    for _ in 0..300 {
        let step_s = next_s();
        advance_from_engine_states(&model, &mut memory, &mut work, &states, &loads, step_s)
            .unwrap();
        host.step(&model, &mut host_work, &states, &loads, step_s).unwrap();
        assert_eq!(work.wrenches(), host_work.wrenches());
        assert_eq!(work.states_after(), host_work.states_after());
        assert_eq!(&memory, host.memory());
        states.copy_from_slice(work.states_after());
    }
}

/// A tug is dragged into a ship without regard to forces. The forces are those of the input states.
#[test]
fn a_body_that_ignores_wrenches_gets_the_forces_of_its_input_states() {
    let Scene { model, mut states, loads } = two_ships_and_a_tug(0.0, 1e6);
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let (mut host, mut host_work) = (DirectHost::new(&model), HostWorkspace::new(&model));
    for state in &mut states[1..] {
        state.velocity_mps.x = 0.0;
    }
    states[2].velocity_mps.x = 0.1;
    states[3].velocity_mps.x = 0.0;
    for _ in 0..300 {
        advance(&model, &mut memory, &mut work, &states, &loads, 0.1).unwrap();
        host.step(&model, &mut host_work, &states, &loads, 0.1).unwrap();
        assert_eq!(work.wrenches(), host_work.wrenches());
        let translation_m = states[2].velocity_mps * 0.1;
        states[2].position_m += translation_m;
    }
    assert!(work.wrenches()[2].force_n.length() > 1e5);
}

#[test]
fn a_direct_host_continues_from_a_snapshot_bit_for_bit_and_refuses_other_bytes() {
    let scene = two_ships_and_a_tug(500e3, 1e7);
    let run = |saves: bool| {
        let integration = HostIntegration::ForwardEuler;
        let mut master = Master::new(scene.clone(), integration, 0, Service::Direct);
        let mut next_s = frames(true);
        for k in 0..300 {
            if saves && k % 10 == 0 {
                let model = &master.scene.model;
                let bytes = master.direct.snapshot(model);
                let mut other = DirectHost::new(model);
                other.restore(model, &bytes).expect("its own bytes");
                assert_eq!(other, master.direct);
                for cut in [0, 7, 30, bytes.len() - 1] {
                    assert!(other.restore(model, &bytes[..cut]).is_err());
                }
                let mut changed = bytes.clone();
                changed[bytes.len() / 2] ^= 1;
                assert!(other.restore(model, &changed).is_err());
                assert_eq!(other, master.direct);
                master.direct = other;
            }
            master.step(if k % 17 == 0 { 0.0 } else { next_s() });
        }
        master.states().to_vec()
    };
    assert_eq!(run(false), run(true));
}
