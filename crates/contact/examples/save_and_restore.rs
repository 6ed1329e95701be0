//! Saves a run in the middle of a contact and continues it from the saved bytes, bit for bit.
//!
//! Run this example with `cargo run -p fenderline-contact --example save_and_restore`.
//!
//! [`Memory`] holds all that a contact remembers: shear springs, initial velocities, factors of fenders. A simulator
//! has to store only the memory and the states of the bodies: [`Workspace`] is only buffers.

use std::error::Error;

use fenderline_contact::*;

fn main() -> Result<(), Box<dyn Error>> {
    let model = build_model()?;
    let mut memory = Memory::new(&model);
    let mut work = Workspace::new(&model);
    let mut states = vec![
        BodyState { velocity_mps: vec2(0.4, 0.2), ..Default::default() },
        BodyState { position_m: vec2(10.02, 3.0), ..Default::default() },
    ];
    run(&model, &mut memory, &mut work, &mut states, 5)?;
    assert_eq!(memory.touching_patches(), 1);

    // Save: the memory as bytes (versioned, with a checksum), and the states.
    let saved = memory.snapshot();
    let saved_states = states.clone();
    println!("{} bytes for {} contact", saved.len(), memory.touching_patches());

    run(&model, &mut memory, &mut work, &mut states, 100)?;

    // Restore into a new memory with a new workspace, as another process would do.
    let mut restored = Memory::new(&model);
    restored.restore(&model, &saved)?;
    let mut restored_states = saved_states;
    let mut new_work = Workspace::new(&model);
    run(&model, &mut restored, &mut new_work, &mut restored_states, 100)?;

    assert_eq!(restored_states, states, "the same bits");
    println!("both runs end at {:?}", states[0].position_m);

    // Changed bytes are refused, and the memory stays as it was.
    let mut damaged = saved.clone();
    *damaged.last_mut().expect("not empty") ^= 1;
    let refused = restored.restore(&model, &damaged);
    println!("a damaged copy: {}", refused.expect_err("the checksum differs"));
    Ok(())
}

fn run(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    states: &mut Vec<BodyState>,
    steps: usize,
) -> Result<(), StepError> {
    let loads = vec![Wrench::default(); states.len()];
    for _ in 0..steps {
        advance_in_place(model, memory, work, states, &loads, 0.02)?;
    }
    Ok(())
}

/// Builds a model of two barges of 10 m × 10 m that may touch.
fn build_model() -> Result<Model, Box<dyn Error>> {
    let square = [vec2(-5.0, -5.0), vec2(5.0, -5.0), vec2(5.0, 5.0), vec2(-5.0, 5.0)];
    let (outline, _) = Outline::new(&square)?;
    let mut builder = Model::builder();
    let mut add_barge = |name: &str, key| {
        builder.body(Body {
            name: name.into(),
            key,
            outline: outline.clone(),
            mobility: Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 6e7 },
        })
    };
    let bodies = [add_barge("first", 1), add_barge("second", 2)];
    let rubber = builder.material(Material {
        stiffness_npm2: 500e3,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e6,
        friction_static: 0.5,
        friction_dynamic: 0.4,
        restitution: 0.5,
    });
    builder.pair(Pair { bodies, material: rubber });
    Ok(builder.build()?)
}

#[cfg(test)]
#[test]
fn the_example_runs() {
    main().expect("the example runs");
}
