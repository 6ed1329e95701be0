//! Computes a berthing on a fender with a catalogue curve: deflection, reaction and absorbed energy.
//!
//! Run this example with `cargo run -p fenderline-contact --example fender_curve`.
//!
//! The reaction curve of a fender is a list of points. The fender's force is the value of the reaction curve at the
//! deflection. The fender has to absorb the ship's kinetic energy. With `Unloading::ReturnedEnergy` the fender returns
//! a share of the absorbed energy, and the ship leaves with the square root of that share of her speed.

use std::error::Error;
use std::f64::consts::FRAC_PI_2;

use fenderline_contact::number::greater;
use fenderline_contact::*;

const MASS_KG: f64 = 3.6e7;
const SPEED_MPS: f64 = 0.12;
const RETURNED_SHARE: f64 = 0.4;

fn main() -> Result<(), Box<dyn Error>> {
    // Deflection (m) and reaction (N). A cone fender buckles: its reaction falls beyond a first peak.
    let law = FenderLaw::Curve(vec![
        [0.0, 0.0],
        [0.15, 400e3],
        [0.35, 700e3],
        [0.55, 640e3],
        [0.72, 800e3],
    ]);
    println!("deflection   reaction   energy");
    for deflection_m in [0.15, 0.35, 0.55, 0.72] {
        let (reaction_n, energy_j) = (law.reaction_n(deflection_m), law.energy_j(deflection_m));
        println!("{deflection_m:8} m {:7.0} kN {:5.0} kJ", reaction_n / 1e3, energy_j / 1e3);
    }

    let model = build_model(law.clone())?;
    let mut memory = Memory::new(&model);
    let mut work = Workspace::new(&model);
    let ship = BodyState { velocity_mps: vec2(0.0, SPEED_MPS), ..Default::default() };
    let quay = BodyState { position_m: vec2(0.0, 21.3), ..Default::default() };
    let mut states = vec![ship, quay];
    let loads = [Wrench::default(); 2];

    let (mut deflection_m, mut reaction_n, mut absorbed_j) = (0.0_f64, 0.0_f64, 0.0_f64);
    for _ in 0..600 {
        advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, 0.05)?;
        for contact in work.contacts() {
            deflection_m = greater(deflection_m, contact.peak_depth_m);
            reaction_n = greater(reaction_n, contact.peak_normal_force_n);
            absorbed_j = greater(absorbed_j, contact.energy.peak_absorbed_j);
        }
    }
    let kinetic_j = 0.5 * MASS_KG * SPEED_MPS * SPEED_MPS;
    let leaving_mps = -states[0].velocity_mps.y;
    println!("berthing energy {:.0} kJ: deflection {deflection_m:.3} m,", kinetic_j / 1e3);
    println!("reaction {:.0} kN, absorbed {:.0} kJ,", reaction_n / 1e3, absorbed_j / 1e3);
    println!("rebound at {leaving_mps:.4} m/s");

    assert!((absorbed_j / kinetic_j - 1.0).abs() < 0.01, "{absorbed_j}");
    assert!(
        (reaction_n / 700e3 - 1.0).abs() < 0.01,
        "the reaction peak before the fender buckles: {reaction_n}"
    );
    let expected_mps = SPEED_MPS * RETURNED_SHARE.sqrt();
    assert!((leaving_mps / expected_mps - 1.0).abs() < 0.01, "{leaving_mps}");
    Ok(())
}

/// Builds a model of a ship, and of a quay to the east of her with one fender amidships.
fn build_model(law: FenderLaw) -> Result<Model, Box<dyn Error>> {
    let rectangle = |half_length_m: f64, half_width_m: f64| {
        Outline::new(&[
            vec2(-half_length_m, -half_width_m),
            vec2(half_length_m, -half_width_m),
            vec2(half_length_m, half_width_m),
            vec2(-half_length_m, half_width_m),
        ])
    };
    let mut builder = Model::builder();
    let ship = builder.body(Body {
        name: "ship".into(),
        key: 1,
        outline: rectangle(90.0, 15.0)?.0,
        mobility: Mobility::Free { mass_kg: MASS_KG, yaw_inertia_kgm2: 6e10 },
    });
    let quay = builder.body(Body {
        name: "quay".into(),
        key: 2,
        outline: rectangle(150.0, 5.0)?.0,
        mobility: Mobility::Fixed,
    });
    let rubber = builder.material(Material {
        stiffness_npm2: 20e6, // of the wall; the fender has its curve
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e6,
        friction_static: 0.2,
        friction_dynamic: 0.2,
        restitution: 1.0,
    });
    builder.fender(Fender {
        name: "cone".into(),
        key: 1,
        body: quay,
        position_m: vec2(0.0, -5.0),
        facing_rad: -FRAC_PI_2,
        width_m: 2.0,
        projection_m: 1.0,
        law,
        unloading: Some(Unloading::ReturnedEnergy(RETURNED_SHARE)),
        material: rubber,
        rated_deflection_m: 0.72,
        stop: None,
        // For a steel-hard winter night one would set `constant` above 1.
        factors: ReactionFactors::default(),
        panel: None,
    });
    builder.pair(Pair { bodies: [ship, quay], material: rubber });
    Ok(builder.build()?)
}

#[cfg(test)]
#[test]
fn the_example_runs() {
    main().expect("the example runs");
}
