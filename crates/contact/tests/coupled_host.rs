//! What hosts do to the coupled method: bad loads, absurd places, speeds and time steps.

#[allow(dead_code, reason = "each test uses its own part of the scene")]
mod scene;

use fenderline_contact::{BodyState, Memory, StepError, Vec2, Workspace, Wrench, advance, vec2};
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
fn a_load_that_is_no_number_is_refused_by_body_and_field_and_changes_nothing() {
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

    /// Thousands of metres of overlap, teleports, wild speeds, stiff fenders and steps of minutes:
    /// bounded work, finite forces and states.
    #[test]
    fn whatever_a_host_does_forces_and_states_stay_finite(
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
            // Rounding is of the contacts' own forces, which may all but cancel in the ship's wrench.
            let forces = work.contacts().iter().map(|c| c.force_on_body_1_n().length());
            let wrenches = work.wrenches().iter().map(|w| w.force_n.length());
            let largest = forces.chain(wrenches).fold(0.0, f64::max);
            prop_assert!(sum.length() <= 1e-12 * largest * 10.0, "every force has its opposite");
        }
    }
}
