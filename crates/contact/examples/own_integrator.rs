//! Shows a simulator that integrates its bodies itself, and takes only the contact wrench from the engine.
//!
//! Run this example with `cargo run -p fenderline-contact --example own_integrator`.
//!
//! In each step the simulator passes the states of its bodies and all other forces to a [`DirectHost`], and adds the
//! contact wrench to the other forces. While bodies touch, the engine computes a motion of its own in sub-steps. The
//! contact wrench keeps the simulator's bodies on the engine's motion, so a stiff contact is stable with a long time
//! step.

use std::error::Error;

use fenderline_contact::number::greater;
use fenderline_contact::*;

const STEP_S: f64 = 0.1;
const MASS_KG: f64 = 1.0e6;
const RESTITUTION: f64 = 0.3;

fn main() -> Result<(), Box<dyn Error>> {
    let model = build_model()?;
    let mut host = DirectHost::new(&model);
    let mut work = HostWorkspace::new(&model);

    let mut barge = BodyState { velocity_mps: vec2(0.5, 0.0), ..Default::default() };
    let quay = BodyState { position_m: vec2(11.0, 0.0), ..Default::default() };
    let mut peak_n = 0.0_f64;
    for _ in 0..100 {
        // 1. The simulator's own forces: here a little quadratic drag.
        let speed_mps = barge.velocity_mps.length();
        let drag = Wrench { force_n: barge.velocity_mps * (-200.0 * speed_mps), moment_nm: 0.0 };

        // 2. The contact wrench of this step.
        let loads = [drag, Wrench::default()];
        let contact = host.step(&model, &mut work, &[barge, quay], &loads, STEP_S)?[0];
        peak_n = greater(peak_n, work.peak_wrenches()[0].force_n.length());

        // 3. The simulator's own integration, here semi-implicit Euler.
        barge.velocity_mps += (drag.force_n + contact.force_n) * (STEP_S / MASS_KG);
        barge.yaw_rate_radps += contact.moment_nm * (STEP_S / 6e7);
        barge.position_m += barge.velocity_mps * STEP_S;
        barge.heading_rad += barge.yaw_rate_radps * STEP_S;
    }
    let leaving_mps = -barge.velocity_mps.x;
    println!("peak force {:.0} kN, rebound at {leaving_mps:.3} m/s", peak_n / 1e3);
    assert!((leaving_mps / (0.5 * RESTITUTION) - 1.0).abs() < 0.02, "{leaving_mps}");
    // N = k S with S = width × depth: a spring of 40 MN/m. A hit at 0.5 m/s compresses the spring with a force of v √(m
    // k).
    let expected_n = 0.5 * (MASS_KG * 4e6 * 10.0_f64).sqrt();
    assert!((peak_n / expected_n - 1.0).abs() < 0.02, "{peak_n}, {expected_n}");
    Ok(())
}

/// Builds a model of a barge of 10 m × 10 m, and of a quay of the same shape.
fn build_model() -> Result<Model, Box<dyn Error>> {
    let square = [vec2(-5.0, -5.0), vec2(5.0, -5.0), vec2(5.0, 5.0), vec2(-5.0, 5.0)];
    let (outline, _) = Outline::new(&square)?;
    let mut builder = Model::builder();
    let barge = builder.body(Body {
        name: "barge".into(),
        key: 1,
        outline: outline.clone(),
        mobility: Mobility::Free { mass_kg: MASS_KG, yaw_inertia_kgm2: 6e7 },
    });
    let quay =
        builder.body(Body { name: "quay".into(), key: 2, outline, mobility: Mobility::Fixed });
    let steel = builder.material(Material {
        stiffness_npm2: 4e6,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 4e6,
        friction_static: 0.3,
        friction_dynamic: 0.3,
        restitution: RESTITUTION,
    });
    builder.pair(Pair { bodies: [barge, quay], material: steel });
    Ok(builder.build()?)
}

#[cfg(test)]
#[test]
fn the_example_runs() {
    main().expect("the example runs");
}
