//! Bad input to the coupled method: impossible loads, positions, speeds and time steps.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

#[allow(dead_code, reason = "each test uses its own part of the scene")]
use crate::scene;

use std::f64::consts::FRAC_PI_2;

use fenderline_contact::{
    Body, BodyState, Fender, FenderLaw, Material, Memory, Mobility, Model, Outline,
    ReactionFactors, StepError, Vec2, Workspace, Wrench, advance, advance_in_place, vec2,
};
use proptest::prelude::*;

fn no_loads() -> Vec<Wrench> {
    vec![Wrench::default(); scene::FENDERS + 1]
}

fn alongside() -> BodyState {
    BodyState {
        position_m: vec2(0.0, scene::TOUCH_EAST_M + 0.2),
        velocity_mps: vec2(0.1, 0.2),
        ..BodyState::default()
    }
}

#[test]
fn a_non_finite_load_names_body_and_field_and_changes_nothing() {
    let model = scene::berth(500e3);
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let states = scene::states(alongside());
    advance(&model, &mut memory, &mut work, &states, &no_loads(), 0.1).unwrap();
    let before = memory.snapshot();
    for bad in [f64::NAN, f64::INFINITY, -1e16] {
        for (place, field) in [(0, "north load"), (1, "east load"), (2, "moment of the load")] {
            let mut loads = no_loads();
            let load = &mut loads[scene::SHIP];
            *[&mut load.force_n.x, &mut load.force_n.y, &mut load.moment_nm][place] = bad;
            match advance(&model, &mut memory, &mut work, &states, &loads, 0.1) {
                Err(StepError::BadState { body, field: named, .. }) => {
                    assert_eq!(
                        (body.as_str(), named),
                        (model.bodies()[scene::SHIP].name.as_str(), field)
                    );
                }
                other => panic!("{field} {bad}: {other:?}"),
            }
            assert_eq!(memory.snapshot(), before);
        }
    }
    let short = &no_loads()[1..];
    assert!(advance(&model, &mut memory, &mut work, &states, short, 0.1).is_err());
    assert_eq!(memory.snapshot(), before);
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(300) })]

    /// Overlaps of thousands of metres, teleports, absurd speeds, stiff fenders and steps of minutes. Forces and states
    /// are finite, and the time for a step is bounded.
    #[test]
    fn forces_and_states_are_finite_for_any_input(
        log_stiffness in 3.0..12.0_f64,
        log_step in -3.0..2.0_f64,
        moves in prop::collection::vec(
            (-300.0..300.0_f64, -300.0..300.0_f64, -7.0..7.0_f64, -50.0..50.0_f64, -1e9..1e9_f64), 4..12),
    ) {
        let model = scene::berth(libm::exp10(log_stiffness));
        let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
        for (x, y, heading_rad, speed, load) in moves {
            let ship = BodyState {
                position_m: vec2(x, y),
                heading_rad,
                velocity_mps: vec2(speed, -speed),
                yaw_rate_radps: 0.01 * speed,
            };
            let states = scene::states(ship);
            let mut loads = no_loads();
            loads[scene::SHIP].force_n = vec2(load, -load);
            advance(&model, &mut memory, &mut work, &states, &loads, libm::exp10(log_step)).unwrap();
            let after = work.states_after()[scene::SHIP];
            prop_assert!(after.position_m.is_finite() && after.velocity_mps.is_finite());
            prop_assert!(after.heading_rad.is_finite() && after.yaw_rate_radps.is_finite());
            let mut sum = Vec2::ZERO;
            for wrench in work.wrenches() {
                prop_assert!(wrench.force_n.is_finite() && wrench.moment_nm.is_finite());
                sum += wrench.force_n;
            }
            // The tolerance is relative to the contacts' forces, because these may nearly cancel in the ship's wrench.
            let forces = work.contacts().iter().map(|c| c.force_on_body_1_n().length());
            let wrenches = work.wrenches().iter().map(|w| w.force_n.length());
            let largest = forces.chain(wrenches).fold(0.0, f64::max);
            prop_assert!(sum.length() <= 1e-12 * largest * 10.0, "every force has its opposite");
        }
    }
}

/// A ship of 87,800 t off a quay with two linear fenders of 5 MN/m, 80 m apart and 1 m deep.
fn ship_off_two_fenders() -> (Model, Vec<BodyState>) {
    let outline = |length_m: f64, width_m: f64| {
        let (x, y) = (0.5 * length_m, 0.5 * width_m);
        Outline::new(&[vec2(-x, -y), vec2(x, -y), vec2(x, y), vec2(-x, y)]).expect("a rectangle").0
    };
    let mut builder = Model::builder();
    let afloat = Mobility::SurgeSway { surge_kg: 9.2e7, sway_kg: 1.5e8, yaw_inertia_kgm2: 8e11 };
    let mut body = |name: &str, key: u64, outline: Outline, mobility: Mobility| {
        builder.body(Body { name: name.into(), key, outline, mobility })
    };
    let quay = body("quay", 1, outline(400.0, 20.0), Mobility::Fixed);
    body("ship", 2, outline(298.0, 46.0), afloat);
    let rubber = builder.material(Material {
        stiffness_npm2: 500e3,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e6,
        friction_static: 0.2,
        friction_dynamic: 0.2,
        restitution: 0.1,
    });
    for (key, along_m) in [(1, -40.0), (2, 40.0)] {
        builder.fender(Fender {
            name: format!("fender {key}"),
            key,
            body: quay,
            position_m: vec2(along_m, 10.0),
            facing_rad: FRAC_PI_2,
            width_m: 2.0,
            projection_m: 1.0,
            rated_deflection_m: 0.9,
            law: FenderLaw::linear(5e6),
            unloading: None,
            stop: None,
            factors: ReactionFactors::default(),
            panel: None,
            material: rubber,
        });
    }
    builder.all_other_pairs(rubber);
    // The ship's side is 1 m off the faces of the fenders.
    let ship = BodyState { position_m: vec2(0.0, 11.0 + 23.0 + 1.0), ..BodyState::default() };
    (builder.build().expect("a good model"), vec![BodyState::default(), ship])
}

/// A ship was placed in her fenders by less than a tenth of her half-length. She stayed there for ever, with or without
/// load: fenders return absorbed energy, and these fenders had absorbed none.
#[test]
fn a_ship_placed_in_her_fenders_is_pressed_out_to_her_static_depth() {
    // Depth and heading at which the ship is placed, her depth before, and the load.
    for (put_m, turned_rad, before_m, load_n) in [
        (0.4, 0.0, None, 0.0),
        (0.9, 0.0, None, 1e6),
        (0.5, 0.0, Some(0.1), 1e6),
        (0.1, 0.008, Some(0.1), 1e6),
    ] {
        let (model, mut states) = ship_off_two_fenders();
        let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
        let loads = [Wrench::default(), Wrench { force_n: vec2(0.0, -load_n), moment_nm: 0.0 }];
        let mut go = |states: &mut Vec<BodyState>, seconds: u32| {
            for _ in 0..10 * seconds {
                advance_in_place(&model, &mut memory, &mut work, states, &loads, 0.1).unwrap();
            }
        };
        if let Some(depth_m) = before_m {
            states[1].position_m.y = 34.0 - depth_m;
        }
        go(&mut states, 1);
        states[1] = BodyState {
            position_m: vec2(0.0, 34.0 - put_m),
            heading_rad: turned_rad,
            ..BodyState::default()
        };
        go(&mut states, 3_600);
        let (ship, case) = (&states[1], (put_m, turned_rad, before_m, load_n));
        let depth_m = 34.0 - ship.position_m.y;
        let right_m = 0.5 * load_n / 5e6;
        if load_n > 0.0 {
            assert!((depth_m - right_m).abs() < 1e-3 * right_m, "{case:?}: {depth_m} m");
            assert!(ship.heading_rad.abs() < 1e-4, "{case:?}: {} rad", ship.heading_rad);
        } else {
            assert!(depth_m < 0.0 && ship.velocity_mps.y > 0.0, "{case:?}: {ship:?}");
        }
    }
}
