//! A ship berths at an angle on two fenders, and the engine moves her.
//!
//! Run this example with `cargo run -p fenderline-contact --example berthing`.
//!
//! [`advance_in_place`] takes a step by the coupled method and updates the states of the bodies. The time step may be
//! long, because the engine divides each step into as many sub-steps as the contact needs. Because of the sub-steps,
//! the peak reactions do not depend on the time step.

use std::error::Error;
use std::f64::consts::FRAC_PI_2;

use fenderline_contact::number::greater;
use fenderline_contact::*;

/// Mass of the ship of 20,000 t and 180 m × 30 m, added mass included.
const MASS_KG: [f64; 2] = [2.1e7, 3.6e7];
const YAW_INERTIA_KGM2: f64 = 6.0e10;
/// Distance of each fender from amidships (m).
const FENDER_AT_M: f64 = 40.0;

fn main() -> Result<(), Box<dyn Error>> {
    println!("time step    peak reaction, forward fender    aft fender");
    let reference_n = berth(0.01)?;
    for step_s in [0.05, 0.5, 2.0] {
        let peaks_n = berth(step_s)?;
        println!("{step_s:7} s {:24.0} kN {:18.0} kN", peaks_n[0] / 1e3, peaks_n[1] / 1e3);
        for (peak_n, expected_n) in peaks_n.iter().zip(reference_n) {
            assert!((peak_n / expected_n - 1.0).abs() < 0.01, "{peaks_n:?}, {reference_n:?}");
        }
    }
    Ok(())
}

/// Peak reactions of the forward and the aft fender in one berthing (N).
fn berth(step_s: f64) -> Result<[f64; 2], Box<dyn Error>> {
    let (model, fenders) = build_model()?;
    let mut memory = Memory::new(&model);
    let mut work = Workspace::new(&model);

    // The ship heads north, her bow 0.5° towards the quay, and approaches it sideways at 0.1 m/s.
    let heading_rad = 0.5_f64.to_radians();
    let ship = BodyState { heading_rad, velocity_mps: vec2(0.0, 0.10), ..Default::default() };
    let quay = BodyState { position_m: vec2(0.0, 22.8), ..Default::default() };
    let mut states = vec![ship, quay];
    // All other forces on the bodies: hull, wind, tugs. Here: a tug pushes with 50 kN.
    let loads = [Wrench { force_n: vec2(0.0, 50e3), moment_nm: 0.0 }, Wrench::default()];

    let mut peaks_n = [0.0_f64; 2];
    for _ in 0..(120.0 / step_s) as usize {
        advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, step_s)?;
        for contact in work.contacts() {
            if let Some(index) = fenders.iter().position(|&id| contact.fender == Some(id)) {
                peaks_n[index] = greater(peaks_n[index], contact.peak_normal_force_n);
            }
        }
    }
    Ok(peaks_n)
}

/// Builds a model of the ship, a quay to the east of her, and two cone fenders on the quay.
fn build_model() -> Result<(Model, [FenderId; 2]), Box<dyn Error>> {
    // Outlines are in the body's frame: x forward, y to starboard, origin at the centre of gravity.
    let (hull, _) = Outline::new(&[
        vec2(-90.0, -15.0),
        vec2(70.0, -15.0),
        vec2(90.0, 0.0),
        vec2(70.0, 15.0),
        vec2(-90.0, 15.0),
    ])?;
    let (wall, _) = Outline::new(&[
        vec2(-150.0, -5.0),
        vec2(150.0, -5.0),
        vec2(150.0, 5.0),
        vec2(-150.0, 5.0),
    ])?;
    let mut builder = Model::builder();
    let ship = builder.body(Body {
        name: "ship".into(),
        key: 1,
        outline: hull,
        mobility: Mobility::SurgeSway {
            surge_kg: MASS_KG[0],
            sway_kg: MASS_KG[1],
            yaw_inertia_kgm2: YAW_INERTIA_KGM2,
        },
    });
    let quay = builder.body(Body {
        name: "quay".into(),
        key: 2,
        outline: wall,
        mobility: Mobility::Fixed,
    });
    // Material of the pair: the hull against the quay's wall, if the ship compresses the fenders fully.
    let concrete = builder.material(Material {
        stiffness_npm2: 20e6,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 20e6,
        friction_static: 0.5,
        friction_dynamic: 0.4,
        restitution: 0.3,
    });
    let panel = builder.material(Material {
        stiffness_npm2: 0.0, // the fender's curve is its stiffness
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e6,
        friction_static: 0.2,
        friction_dynamic: 0.2,
        restitution: 0.5,
    });
    let mut add_fender = |name: &str, along_m: f64, key: u64| {
        builder.fender(Fender {
            name: name.into(),
            key,
            body: quay,
            position_m: vec2(along_m, -5.0),
            facing_rad: -FRAC_PI_2, // to port of the quay, which heads north: west
            width_m: 2.0,
            projection_m: 1.0,
            // Deflection (m) and reaction (N), as a catalogue lists them.
            law: FenderLaw::Curve(vec![[0.0, 0.0], [0.35, 700e3], [0.55, 640e3], [0.72, 800e3]]),
            unloading: None,
            material: panel,
            rated_deflection_m: 0.72,
            stop: None,
            factors: ReactionFactors::default(),
            panel: None,
        })
    };
    let fenders = [add_fender("forward", FENDER_AT_M, 1), add_fender("aft", -FENDER_AT_M, 2)];
    builder.pair(Pair { bodies: [ship, quay], material: concrete });
    Ok((builder.build()?, fenders))
}

#[cfg(test)]
#[test]
fn the_example_runs() {
    main().expect("the example runs");
}
