//! Bodies that a host puts into others: pressed out slowly, whatever the host and however deep.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

#[allow(dead_code, reason = "each test uses its own part of the master")]
mod master;

use fenderline_contact::{
    BodyId, BodyState, Event, EventKind, HostIntegration, Memory, Mobility, PRESSED_OUT_MPS,
    Workspace, Wrench, advance_in_place, vec2,
};
use master::{Master, Story, model, rectangle, rubber};

const MASS_KG: f64 = 1.5e8;
const BEAM_M: f64 = 36.0;

/// A ship of 200 m whose side is that deep in a quay.
fn put(depth_m: f64, stiffness_npm2: f64, restitution: f64) -> Story {
    let ship = Mobility::Free { mass_kg: MASS_KG, yaw_inertia_kgm2: MASS_KG * 2500.0 };
    let bodies = [(rectangle(BEAM_M, 200.0), ship), (rectangle(60.0, 400.0), Mobility::Fixed)];
    let quay_m = 0.5 * BEAM_M + 30.0;
    Story {
        model: model(&bodies, rubber(stiffness_npm2, restitution, 0.3)),
        states: vec![
            BodyState { position_m: vec2(depth_m, 0.0), ..BodyState::default() },
            BodyState { position_m: vec2(quay_m, 0.0), ..BodyState::default() },
        ],
        loads: vec![Wrench::default(); 2],
    }
}

fn was_told(events: &[Event], kind: EventKind) -> bool {
    events.iter().any(|event| event.kind == kind)
}

/// What a contact may press with, beyond the loads: a of 0.02 m/s².
const LARGEST_N: f64 = 0.021 * MASS_KG;

/// It was 1.15 GN and 1.5 m/s from 3 m, 6.5 GN and 8.5 m/s from 9 m, and no event.
#[test]
fn a_ship_put_up_to_half_her_beam_into_a_quay_is_pressed_out_slowly() {
    for depth_m in [1.0, 3.0, 9.0, 0.5 * BEAM_M] {
        for (stiffness_npm2, restitution) in [(1e6, 0.0), (1e6, 0.1), (1e6, 0.9), (1e8, 0.1)] {
            for step_s in [1.0 / 60.0, 0.5] {
                let Story { model, mut states, loads } = put(depth_m, stiffness_npm2, restitution);
                let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
                let who =
                    format!("{depth_m} m, {stiffness_npm2} N/m², γ {restitution}, Δt {step_s}");
                let (mut told, mut out_s) = (0, 0.0);
                while states[0].position_m.x > 0.0 {
                    advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, step_s)
                        .expect("good states");
                    told += usize::from(was_told(work.events(), EventKind::PutInto));
                    let wrench_n = work.wrenches()[0].force_n.length();
                    assert!(wrench_n < LARGEST_N, "{who}: {wrench_n} N");
                    let speed_mps = states[0].velocity_mps.length();
                    assert!(speed_mps <= PRESSED_OUT_MPS + 1e-9, "{who}: {speed_mps} m/s");
                    out_s += step_s;
                    assert!(out_s < 5.0 + depth_m / PRESSED_OUT_MPS, "{who}: {:?}", states[0]);
                }
                assert_eq!(told, 1, "{who}");
            }
        }
    }
}

/// Of hosts that move her by themselves, too: whether they say that they put her there or not, by less than a tenth of
/// her radius and by more.
#[test]
fn whatever_the_host_she_leaves_slowly() {
    for integration in [HostIntegration::ForwardEuler, HostIntegration::SemiImplicit] {
        for delay_steps in 0..=2 {
            for (depth_m, says_so) in [(3.0, false), (3.0, true), (15.0, false), (15.0, true)] {
                for step_s in [1.0 / 60.0, 0.2, 1.0] {
                    let mut master = Master::known(put(-5.0, 1e6, 0.1), integration, delay_steps);
                    master.run(step_s, 20.0);
                    master.past.last_mut().expect("never empty")[0].position_m.x = depth_m;
                    let who =
                        format!("{integration:?}, delay {delay_steps}, {depth_m} m, Δt {step_s}");
                    let (mut told, mut time_s) = (false, 0.0);
                    for k in 0.. {
                        if says_so && k == delay_steps {
                            master.host.place(&master.story.model, BodyId(0));
                        }
                        master.step(step_s);
                        told |= was_told(master.work.events(), EventKind::PutInto);
                        let wrench_n = master.work.wrenches()[0].force_n.length();
                        assert!(wrench_n < LARGEST_N, "{who}: {wrench_n} N");
                        let speed_mps = master.states()[0].velocity_mps.length();
                        assert!(speed_mps <= PRESSED_OUT_MPS + 1e-6, "{who}: {speed_mps} m/s");
                        time_s += step_s;
                        if time_s > 20.0 + depth_m / PRESSED_OUT_MPS {
                            break;
                        }
                    }
                    assert!(told, "{who}");
                    let place_m = master.states()[0].position_m.x;
                    assert!(place_m < 0.0, "{who}: {place_m} m");
                }
            }
        }
    }
}

/// Pressed out against a load, she rests where it is held; put there at 1 m/s, she is stopped without a blow.
#[test]
fn against_a_load_and_with_way_on_she_comes_to_rest_at_her_static_depth() {
    for (load_n, speed_mps) in [(2e6, 0.0), (2e6, 1.0), (2e7, 0.3)] {
        let Story { model, mut states, mut loads } = put(6.0, 1e6, 0.1);
        loads[0].force_n.x = load_n;
        states[0].velocity_mps.x = speed_mps;
        let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
        for _ in 0..20_000 {
            advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, 0.1).unwrap();
            let wrench_n = work.wrenches()[0].force_n.length();
            // She may leave, and come back as fast: v √(k m).
            let back_n = PRESSED_OUT_MPS * (200e6 * MASS_KG).sqrt();
            let largest_n = load_n + LARGEST_N.max(back_n) + 0.51 * MASS_KG * speed_mps;
            assert!(wrench_n < largest_n, "{load_n} N, {speed_mps} m/s: {wrench_n} N");
        }
        let depth_m = states[0].position_m.x;
        // The quay takes 200 MN/m along her side.
        let right_m = load_n / 200e6;
        assert!((depth_m / right_m - 1.0).abs() < 0.01, "{load_n} N, {speed_mps} m/s: {depth_m} m");
    }
}

/// A hit that goes as deep by itself is one as before: all of the energy that γ leaves comes back.
#[test]
fn a_deep_hit_is_no_putting() {
    let Story { model, mut states, loads } = put(-1.0, 50e3, 0.9);
    states[0].velocity_mps.x = 1.0;
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let mut deepest_m = 0.0_f64;
    for _ in 0..400 {
        advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, 0.1).unwrap();
        deepest_m = deepest_m.max(states[0].position_m.x);
        assert!(!was_told(work.events(), EventKind::PutInto));
    }
    assert!(deepest_m > 3.0, "{deepest_m} m");
    let left_mps = -states[0].velocity_mps.x;
    assert!((left_mps - 0.9).abs() < 0.01, "{left_mps} m/s");
}

/// A word of the host counts once, and survives saving.
#[test]
fn a_body_that_is_said_to_be_placed_starts_its_contacts_afresh_once() {
    let Story { model, mut states, loads } = put(0.1, 1e6, 0.1);
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let mut teleported = |memory: &mut Memory, states: &mut Vec<BodyState>| {
        advance_in_place(&model, memory, &mut work, states, &loads, 0.1).unwrap();
        was_told(work.events(), EventKind::Teleported)
    };
    assert!(!teleported(&mut memory, &mut states));
    memory.place(&model, BodyId(0));
    let mut other = Memory::new(&model);
    other.restore(&model, &memory.snapshot()).expect("its own bytes");
    assert_eq!(other, memory);
    assert!(teleported(&mut other, &mut states));
    assert!(!teleported(&mut other, &mut states));
}
