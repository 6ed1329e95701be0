//! Fuzzes the restoring of the engine's memory with any bytes as a snapshot: either an error that changes nothing, or a
//! memory whose steps give finite forces.
#![no_main]

use std::sync::LazyLock;

use fenderline_contact::hash::Fnv1a;
use fenderline_contact::{
    Body, BodyState, Material, Memory, Mobility, Model, Outline, Pair, Workspace, step, vec2,
};
use fenderline_fuzz::input::Input;
use libfuzzer_sys::fuzz_target;

const STEP_S: f64 = 0.1;

static SCENE: LazyLock<Scene> = LazyLock::new(Scene::new);

/// The scene of the snapshots: a tug in the corner of an L-shaped quay, and a ship beside her.
struct Scene {
    model: Model,
    /// Snapshots of the memory along a run, each with the states of the bodies for the next step.
    saved: Vec<(Vec<u8>, [BodyState; 3])>,
}

fuzz_target!(|bytes: &[u8]| {
    let scene = &*SCENE;
    let mut input = Input::new(bytes);
    let (mode, which) = (input.byte() % 4, usize::from(input.byte()) % scene.saved.len());
    let (real, states) = &scene.saved[which];
    let claimed = match mode {
        0 => input.rest().to_vec(),
        1 => mutated(real, input),
        2 => with_check_sum(mutated(real, input)),
        _ => with_check_sum([&real[..20], input.rest(), &[0; 8]].concat()),
    };

    let mut memory = Memory::new(&scene.model);
    let (other, _) = &scene.saved[scene.saved.len() - 1 - which];
    memory.restore(&scene.model, other).expect("a real snapshot");
    let before = memory.clone();
    if memory.restore(&scene.model, &claimed).is_err() {
        assert_eq!(memory, before, "a restore that failed left the memory unchanged");
        return;
    }
    assert_eq!(memory.snapshot(), claimed, "the restored memory gives the same snapshot");
    let mut work = Workspace::new(&scene.model);
    for _ in 0..4 {
        step(&scene.model, &mut memory, &mut work, states, STEP_S).expect("good states");
        for wrench in work.wrenches() {
            assert!(wrench.force_n.is_finite() && wrench.moment_nm.is_finite(), "{wrench:?}");
        }
        let mut again = Memory::new(&scene.model);
        again.restore(&scene.model, &memory.snapshot()).expect("own snapshot");
    }
});

/// Overwrites bytes. Each overwritten byte takes three bytes of the input: two for its place and one for its value.
fn mutated(real: &[u8], mut input: Input<'_>) -> Vec<u8> {
    let mut bytes = real.to_vec();
    while !input.is_empty() {
        let place = usize::from(input.word()) % bytes.len();
        bytes[place] = input.byte();
    }
    bytes
}

/// Overwrites the last eight bytes with a valid check sum (FNV-1a, 64 bit).
fn with_check_sum(mut bytes: Vec<u8>) -> Vec<u8> {
    let end = bytes.len() - 8;
    let sum = Fnv1a::of(&bytes[..end]);
    bytes[end..].copy_from_slice(&sum.to_le_bytes());
    bytes
}

impl Scene {
    fn new() -> Scene {
        let outline = |vertices: &[(f64, f64)]| {
            let vertices: Vec<_> = vertices.iter().map(|&(x, y)| vec2(x, y)).collect();
            Outline::new(&vertices).expect("a good outline").0
        };
        let tug = outline(&[
            (-16.0, -6.5),
            (10.0, -6.5),
            (16.0, -3.0),
            (16.0, 3.0),
            (10.0, 6.5),
            (-16.0, 6.5),
        ]);
        let ship =
            outline(&[(-80.0, -12.0), (70.0, -12.0), (80.0, 0.0), (70.0, 12.0), (-80.0, 12.0)]);
        let quay = outline(&[
            (0.0, -60.0),
            (40.0, -60.0),
            (40.0, 30.0),
            (-60.0, 30.0),
            (-60.0, 0.0),
            (0.0, 0.0),
        ]);
        let mut builder = Model::builder();
        let mut add = |key, name: &str, outline, mass_kg: Option<f64>| {
            let mobility = mass_kg.map_or(Mobility::Fixed, |mass_kg| Mobility::Free {
                mass_kg,
                yaw_inertia_kgm2: mass_kg * 100.0,
            });
            builder.body(Body { name: name.into(), key, outline, mobility })
        };
        let bodies = [
            add(3, "tug", tug, Some(1e6)),
            add(1, "ship", ship, Some(4e7)),
            add(2, "quay", quay, None),
        ];
        let material = builder.material(Material {
            stiffness_npm2: 5e5,
            damping_nspm2: 2e4,
            shear_stiffness_npm: 3e6,
            friction_static: 0.5,
            friction_dynamic: 0.4,
            restitution: 0.1,
        });
        builder.pair(Pair { bodies: [bodies[0], bodies[2]], material });
        builder.all_other_pairs(material);
        let model = builder.build().expect("a good model");

        let mut states = [
            BodyState {
                position_m: vec2(-17.0, -7.5),
                velocity_mps: vec2(0.6, 0.5),
                ..BodyState::default()
            },
            BodyState {
                position_m: vec2(-70.0, -27.5),
                velocity_mps: vec2(0.1, 0.6),
                ..BodyState::default()
            },
            BodyState::default(),
        ];
        let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
        let mut saved = Vec::new();
        for index in 0..40 {
            if index % 5 == 0 {
                saved.push((memory.snapshot(), states));
            }
            step(&model, &mut memory, &mut work, &states, STEP_S).expect("good states");
            for state in &mut states {
                state.position_m += state.velocity_mps * STEP_S;
            }
        }
        assert!(memory.touching_patches() >= 3, "the scene has contacts");
        Scene { model, saved }
    }
}
