//! Mistakes of a co-simulation host: numbers that are not finite, wrong counts, another model, teleports. Errors change
//! nothing.

#[allow(dead_code, reason = "each test uses its own part of the master")]
use crate::master;

use fenderline_contact::{
    BodyState, CoSimHost, EventKind, HostIntegration, HostSettings, HostWorkspace, StepError, Vec2,
    Wrench, vec2,
};
use master::{Master, ship_on_two_fenders, tug_against_a_ship, tug_at_a_wall};

const STEP_S: f64 = 0.1;
const BAD_NUMBERS: [f64; 5] = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, 1e300];

/// A tug against a ship, some steps after the contact began. The states are one step late.
fn in_contact() -> Master {
    let scene = tug_against_a_ship(0.5);
    let mut master = Master::known(scene, HostIntegration::ForwardEuler, 1);
    while master.work.contacts().is_empty() {
        master.step(STEP_S);
    }
    master.step(STEP_S);
    master
}

#[test]
fn a_bad_number_names_body_and_field_and_changes_nothing() {
    type Field = (&'static str, fn(&mut BodyState) -> &mut f64);
    let fields: [Field; 6] = [
        ("north position", |s| &mut s.position_m.x),
        ("east position", |s| &mut s.position_m.y),
        ("heading", |s| &mut s.heading_rad),
        ("north velocity", |s| &mut s.velocity_mps.x),
        ("east velocity", |s| &mut s.velocity_mps.y),
        ("yaw rate", |s| &mut s.yaw_rate_radps),
    ];
    let mut master = in_contact();
    let before = master.host.clone();
    for body in 0..2 {
        for (field, field_of) in fields {
            for value in BAD_NUMBERS {
                let mut states = master.input_states().to_vec();
                *field_of(&mut states[body]) = value;
                let model = &master.scene.model;
                match master.host.step(model, &mut master.work, &states, None, STEP_S) {
                    Err(StepError::BadState { body: name, field: named, .. }) => {
                        assert_eq!((name, named), (model.bodies()[body].name.clone(), field));
                    }
                    other => panic!("{field} = {value}: {other:?}"),
                }
                assert_eq!(master.host, before, "{field} = {value}");
            }
        }
    }
}

#[test]
fn bad_loads_counts_steps_and_models_are_errors_and_change_nothing() {
    let mut master = in_contact();
    let before = master.host.clone();
    let states = master.input_states().to_vec();
    let (model, work) = (&master.scene.model, &mut master.work);
    for value in BAD_NUMBERS {
        let mut loads = [Wrench::default(); 2];
        loads[1].moment_nm = value;
        let error = master.host.step(model, work, &states, Some(&loads), STEP_S).unwrap_err();
        assert!(error.to_string().contains("moment of the load of body `body 1`"), "{error}");
        assert!(master.host.step(model, work, &states, None, value).is_err());
    }
    let counts = Err(StepError::WrongCount { bodies: 2, states: 1 });
    assert_eq!(master.host.step(model, work, &states[1..], None, STEP_S), counts);
    let one_load = [Wrench::default()];
    assert_eq!(master.host.step(model, work, &states, Some(&one_load), STEP_S), counts);
    let other = tug_at_a_wall(1.0, 1.0, 0.1).model;
    let wrong = Err(StepError::WrongModel);
    assert_eq!(master.host.step(&other, work, &states, None, STEP_S), wrong);
    assert_eq!(master.host, before);
}

/// Random calls from C found this fault: after a failed step, the host's estimate was the estimate of the failed step.
#[test]
fn a_failed_step_leaves_the_estimate_unchanged() {
    let scene = tug_at_a_wall(1.0, 0.0, 0.1);
    let settings = HostSettings { delay_steps: 1, integration: HostIntegration::ForwardEuler };
    let (mut host, mut work) =
        (CoSimHost::new(&scene.model, settings), HostWorkspace::new(&scene.model));
    host.step(&scene.model, &mut work, &scene.states, None, STEP_S).expect("good states");
    let (before, present, loads) =
        (host.clone(), work.estimated_states().to_vec(), work.loads().to_vec());
    // The host has not reported her motion in this step yet. It takes her out of the accepted range.
    let mut states = scene.states.clone();
    states[0].position_m = vec2(1e9, 0.0);
    states[0].velocity_mps = vec2(1e6, 0.0);
    assert!(host.step(&scene.model, &mut work, &states, None, STEP_S).is_err());
    assert_eq!((&host, work.estimated_states(), work.loads()), (&before, &present[..], &loads[..]));
}

#[test]
fn an_error_between_two_steps_changes_no_bit_of_the_run() {
    let run = |trip: bool| {
        let mut master = in_contact();
        for _ in 0..50 {
            if trip {
                let bad = vec![BodyState::default()];
                let model = &master.scene.model;
                assert!(master.host.step(model, &mut master.work, &bad, None, STEP_S).is_err());
            }
            master.step(STEP_S);
        }
        (master.past.clone(), master.host.clone())
    };
    assert_eq!(run(true), run(false));
}

#[test]
fn a_copy_and_a_reset_replay_the_same_bits() {
    let mut one = in_contact();
    let mut two = Master::known(one.scene.clone(), HostIntegration::ForwardEuler, 1);
    (two.host, two.past) = (one.host.clone(), one.past.clone());
    for _ in 0..100 {
        one.step(STEP_S);
        two.step(STEP_S);
        assert_eq!((&one.host, one.states()), (&two.host, two.states()));
    }
    one.host.reset(&one.scene.model);
    assert_eq!(one.host, CoSimHost::new(&one.scene.model, one.host.settings()));
}

#[test]
fn a_teleported_body_has_no_observed_load_and_no_force() {
    for delay_steps in 0..=2 {
        let scene = ship_on_two_fenders(0.0);
        let mut master = Master::known(scene, HostIntegration::ForwardEuler, delay_steps);
        master.run(STEP_S, 60.0);
        assert_eq!(master.work.contacts().len(), 2);
        // The host moves her 300 m away, at 1 m/s.
        let ship = &mut master.past.last_mut().expect("never empty")[0];
        ship.position_m += vec2(300.0, -300.0);
        ship.velocity_mps = vec2(1.0, 0.0);
        let mut reported = false;
        for _ in 0..=delay_steps {
            master.step(STEP_S);
            reported |= master.work.events().iter().any(|e| e.kind == EventKind::Teleported);
        }
        assert!(reported, "delay {delay_steps}");
        for _ in 0..20 {
            master.step(STEP_S);
            assert_eq!(master.work.wrenches()[0], Wrench::default(), "delay {delay_steps}");
            let load = master.work.loads()[0];
            assert!((load.force_n.length() / 1e6 - 1.0).abs() < 0.01, "{delay_steps}: {load:?}");
        }
    }
}

#[test]
fn a_sudden_velocity_is_not_a_load_beyond_plausible_size() {
    let settings = HostSettings { delay_steps: 0, integration: HostIntegration::SemiImplicit };
    let scene = tug_at_a_wall(100.0, 0.0, 0.1);
    let (mut host, mut work) =
        (CoSimHost::new(&scene.model, settings), HostWorkspace::new(&scene.model));
    let mut states = scene.states.clone();
    host.step(&scene.model, &mut work, &states, None, 1e-6).expect("good states");
    states[0].velocity_mps = vec2(0.0, 1e4);
    host.step(&scene.model, &mut work, &states, None, 1e-6).expect("good states");
    assert_eq!(work.loads()[0].force_n, Vec2::ZERO);
}

/// For any states, forces are finite or the step is refused.
#[test]
fn random_teleports_give_finite_wrenches() {
    for integration in [HostIntegration::ForwardEuler, HostIntegration::SemiImplicit] {
        let scene = ship_on_two_fenders(0.5);
        let settings = HostSettings { delay_steps: 2, integration };
        let mut host = CoSimHost::new(&scene.model, settings);
        let mut work = HostWorkspace::new(&scene.model);
        let mut states = scene.states.clone();
        for k in 0..2000_u32 {
            // Pseudo-random by a multiplicative hash.
            let dice = |salt: u32| {
                f64::from((k * 7 + salt).wrapping_mul(2_654_435_761) >> 8) / f64::from(1 << 23)
                    - 1.0
            };
            states[0] = BodyState {
                position_m: vec2(100.0 * dice(1), 60.0 * dice(2)),
                heading_rad: 4.0 * dice(3),
                velocity_mps: vec2(dice(4), dice(5)) * 20.0,
                yaw_rate_radps: 0.5 * dice(6),
            };
            let step_s = [0.01, 0.1, 2.0][k as usize % 3];
            for wrench in host.step(&scene.model, &mut work, &states, None, step_s).expect("finite")
            {
                assert!(wrench.force_n.is_finite() && wrench.moment_nm.is_finite());
            }
        }
    }
}

/// At 1e7 m from the chart's origin, a position is rounded to 2e-9 m. A mean velocity over 0.1 s is then rounded to
/// 2e-8 m/s.
#[test]
fn far_from_the_charts_origin_the_rebound_is_the_same() {
    for delay_steps in 0..=1 {
        let mut scene = tug_at_a_wall(1.7, 2.06, 0.1);
        for state in &mut scene.states {
            state.position_m += vec2(6.7e6, 1e7);
        }
        let mut master = Master::known(scene, HostIntegration::ForwardEuler, delay_steps);
        master.run(STEP_S, 60.0);
        let left = -master.states()[0].velocity_mps.x;
        assert!((left - 0.206).abs() < 1e-6, "{left} m/s");
    }
}
