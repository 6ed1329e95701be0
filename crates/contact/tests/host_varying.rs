//! Hosts with a varying step, like the frames of a game: jitter, pauses, and single frames of seconds.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

#[allow(dead_code, reason = "each test uses its own part of the master")]
use crate::master;

use fenderline_contact::{
    BodyState, CoSimHost, EventKind, HostIntegration, HostSettings, HostWorkspace, Memory,
    Mobility, Workspace, Wrench, advance, advance_in_place, vec2,
};
use master::{Master, Scene, Service, model, rectangle, rubber, tug_at_a_wall};

const INTEGRATIONS: [HostIntegration; 2] =
    [HostIntegration::ForwardEuler, HostIntegration::SemiImplicit];
const FRAME_S: f64 = 1.0 / 60.0;

/// Pseudo-random frames from 1/60 s to the longest, and sometimes one of 2 s.
#[derive(Clone)]
struct Frames {
    dice: u64,
    longest_s: f64,
    single_every_s: f64,
    time_s: f64,
    next_single_s: f64,
}

impl Frames {
    fn new(seed: u64, longest_s: f64, single_every_s: f64) -> Frames {
        let next_single_s = 0.37 * single_every_s;
        Frames { dice: seed, longest_s, single_every_s, time_s: 0.0, next_single_s }
    }

    fn next_s(&mut self) -> f64 {
        // Knuth's linear congruential generator.
        self.dice = self
            .dice
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let share = (self.dice >> 11) as f64 / (1_u64 << 53) as f64;
        let mut step_s = FRAME_S + (self.longest_s - FRAME_S) * share;
        if self.time_s >= self.next_single_s {
            self.next_single_s += self.single_every_s;
            step_s = 2.0;
        }
        self.time_s += step_s;
        step_s
    }
}

fn every_master(check: impl Fn(HostIntegration, u32)) {
    for integration in INTEGRATIONS {
        for delay_steps in 0..=2 {
            check(integration, delay_steps);
        }
    }
}

/// The force was 1.04, 2.44, 4.83, 9.84 and 24.1 MN. Half an impulse of the longer step was returned in 1/60 s.
#[test]
fn a_longer_frame_gives_no_jolt_to_a_tug_under_an_unreported_push() {
    const PUSH_N: f64 = 305e3;
    let mut scene = tug_at_a_wall(0.0, 0.0, 0.1);
    scene.loads[0].force_n.x = PUSH_N;
    every_master(|integration, delay_steps| {
        let mut master = Master::known(scene.clone(), integration, delay_steps);
        master.run(FRAME_S, 60.0);
        let place_m = master.states()[0].position_m.x;
        for long_s in [0.1, 0.25, 0.5, 1.0, 2.0] {
            master.step(long_s);
            for _ in 0..600 {
                let who = format!("{integration:?}, delay {delay_steps}, {long_s} s");
                let wrench_n = master.work.wrenches()[0].force_n.length();
                assert!((wrench_n / PUSH_N - 1.0).abs() < 1e-6, "{who}: {wrench_n} N");
                let off_m = master.states()[0].position_m.x - place_m;
                assert!(off_m.abs() < 1e-6, "{who}: {off_m} m");
                master.step(FRAME_S);
            }
        }
    });
}

/// A tug at rest at a soft wall is pushed from the first step on. In the host's steps her position lags the load by
/// half a step. The engine added another half (sub-)step, and she went 2.8 % too deep.
#[test]
fn a_tug_pushed_from_rest_reaches_the_right_depth() {
    const PUSH_N: f64 = 2e5;
    let stiffness_npm = 50e3 * 13.0;
    for step_s in [0.1, 0.5, 1.0, 2.0] {
        every_master(|integration, delay_steps| {
            let mut scene = tug_at_a_wall(0.0, 0.0, 1.0);
            let bodies = scene.model.bodies().iter();
            let bodies: Vec<_> = bodies.map(|b| (b.outline.clone(), b.mobility)).collect();
            scene.model = model(&bodies, rubber(50e3, 1.0, 0.0));
            scene.loads[0].force_n.x = PUSH_N;
            let settings = HostSettings { delay_steps, integration };
            let mut master =
                Master::new(scene, integration, delay_steps, Service::CoSimWithLoads(settings));
            let (mut deepest_m, mut time_s) = (0.0_f64, 0.0);
            while time_s < 12.0 {
                master.step(step_s);
                time_s += step_s;
                let depths = master.work.contacts().iter().map(|contact| contact.peak_depth_m);
                deepest_m = depths.fold(deepest_m, f64::max);
            }
            let half_turn_rad = 0.5 * step_s * (stiffness_npm / 1e6_f64).sqrt();
            let right_m = PUSH_N / stiffness_npm * (1.0 + libm::hypot(half_turn_rad, 1.0));
            let who = format!("{integration:?}, delay {delay_steps}, {step_s} s");
            assert!((deepest_m / right_m - 1.0).abs() < 0.005, "{who}: {deepest_m}, not {right_m}");
        });
    }
}

/// A ship of 80 m × 20 m that drifts sideways, 1 m from a wall of 50 kN/m².
fn berthing(mass_kg: f64, speed_mps: f64, restitution: f64) -> Scene {
    let ship = Mobility::Free { mass_kg, yaw_inertia_kgm2: mass_kg * 400.0 };
    let bodies = [(rectangle(20.0, 80.0), ship), (rectangle(40.0, 300.0), Mobility::Fixed)];
    Scene {
        model: model(&bodies, rubber(50e3, restitution, 0.2)),
        states: vec![
            BodyState { velocity_mps: vec2(speed_mps, 0.0), ..BodyState::default() },
            BodyState { position_m: vec2(31.0, 0.0), ..BodyState::default() },
        ],
        loads: vec![Wrench::default(); 2],
    }
}

/// Largest wrench, largest reported peaks of the ship and of a contact (N), and the rebound speed (m/s).
fn berthed(mut master: Master, mut next_s: impl FnMut() -> f64) -> [f64; 4] {
    let (mut largest_n, mut peak_n, mut of_contact_n, mut time_s) = (0.0_f64, 0.0_f64, 0.0, 0.0);
    while time_s < 90.0 {
        let step_s = next_s();
        master.step(step_s);
        time_s += step_s;
        largest_n = largest_n.max(master.work.wrenches()[0].force_n.length());
        let peaks = master.work.contacts().iter().map(|contact| contact.peak_normal_force_n);
        of_contact_n = peaks.fold(of_contact_n, f64::max);
        let of_bodies = master.work.peak_wrenches();
        peak_n = peak_n.max(of_bodies[0].force_n.length());
        let sum_n = (of_bodies[0].force_n + of_bodies[1].force_n).length();
        assert!(sum_n <= 1e-9 * peak_n, "as much on the wall: {of_bodies:?}");
    }
    [largest_n, peak_n, of_contact_n, -master.states()[0].velocity_mps.x]
}

/// Forward Euler hosts went up to 0.5 m too deep in a frame. They rebounded seven times too fast.
#[test]
fn a_berthing_with_jitter_and_frames_of_2_s_equals_one_with_fixed_steps() {
    for (mass_kg, restitution) in [(2e7, 0.1), (2e7, 0.5), (1e8, 0.1), (1e8, 0.5)] {
        for speed_mps in [0.15, 0.5] {
            every_master(|integration, delay_steps| {
                let scene = berthing(mass_kg, speed_mps, restitution);
                let master = || Master::known(scene.clone(), integration, delay_steps);
                let [fixed_n, _, _, fixed_mps] = berthed(master(), || FRAME_S);
                for (seed, single_every_s) in [(1, 1e9), (2, 1e9), (3, 11.0), (4, 11.0), (5, 4.0)] {
                    let mut frames = Frames::new(seed, 0.5, single_every_s);
                    let [largest_n, peak_n, of_contact_n, left_mps] =
                        berthed(master(), || frames.next_s());
                    let who = format!(
                        "{mass_kg} kg, γ {restitution}, {speed_mps} m/s, {integration:?}, delay {delay_steps}, seed {seed}"
                    );
                    // The wrench is a mean over the frame, so that the impulse is right. If the force falls within a
                    // frame of 2 s, the mean is less than the peak. A light ship past her deepest point is such a case.
                    let wrench = largest_n / fixed_n;
                    assert!(wrench < 1.1, "{who}: wrench {wrench}");
                    let falls_off = single_every_s < 1e9 && mass_kg < 1e8;
                    assert!(falls_off || wrench > 0.9, "{who}: wrench {wrench}");
                    assert!((peak_n / fixed_n - 1.0).abs() < 0.01, "{who}: peak {peak_n} N");
                    assert!((of_contact_n / peak_n - 1.0).abs() < 0.001, "{who}: {of_contact_n} N");
                    assert!((left_mps / fixed_mps - 1.0).abs() < 0.003, "{who}: {left_mps} m/s");
                }
            });
        }
    }
}

/// A contact of half a second within frames of 2 s. The rebound speed is right, and never too high.
#[test]
fn a_tug_that_rebounds_within_a_frame_has_the_right_speed() {
    for restitution in [0.1, 0.5] {
        every_master(|integration, delay_steps| {
            for seed in 1..=10 {
                let scene = tug_at_a_wall(1.0, 0.5, restitution);
                let mut frames = Frames::new(seed, 0.5, 4.0);
                let master = Master::known(scene, integration, delay_steps);
                let [.., left_mps] = berthed(master, || frames.next_s());
                let who = format!("γ {restitution}, {integration:?}, delay {delay_steps}, {seed}");
                let right_mps = restitution * 0.5;
                assert!((left_mps / right_mps - 1.0).abs() < 0.003, "{who}: {left_mps} m/s");
            }
        });
    }
}

/// She drifted 0.95 m along the pier. The shear spring now holds her while she swings by 17 mm, so the test compares
/// means.
#[test]
fn a_ship_under_wind_does_not_drift_in_an_hour_of_jitter() {
    for (longest_s, single_every_s) in [(0.2, 1e9), (0.5, 60.0)] {
        for integration in INTEGRATIONS {
            let mut scene = master::ship_on_two_fenders(0.3);
            let (sin, cos) = libm::sincos(core::f64::consts::FRAC_PI_6);
            let (along, across) = (vec2(cos, sin), vec2(-sin, cos));
            scene.loads[0].force_n += along * 1e5;
            let load_n = scene.loads[0].force_n.length();
            let mut frames = Frames::new(7, longest_s, single_every_s);
            let mut master = Master::known(scene, integration, 1);
            let mut sums = [(vec2(0.0, 0.0), 0.0); 2];
            while frames.time_s < 3900.0 {
                master.step(frames.next_s());
                if frames.time_s < 300.0 {
                    continue;
                }
                let now = master.states()[0].position_m;
                let wrench = master.work.wrenches()[0].force_n.length() / load_n;
                assert!((wrench - 1.0).abs() < 0.02, "{integration:?}: {wrench}");
                let place = if frames.time_s < 600.0 {
                    &mut sums[0]
                } else if frames.time_s > 3600.0 {
                    &mut sums[1]
                } else {
                    continue;
                };
                *place = (place.0 + now, place.1 + 1.0);
            }
            let [first, last] = sums.map(|(sum, count)| sum * (1.0 / count));
            let moved = last - first;
            let drift_m = (moved.dot(across), moved.dot(along));
            assert!(moved.length() < 0.01, "{integration:?}, {longest_s} s: {drift_m:?} m");
        }
    }
}

/// A mass that differs from the model's is reported once. An equal mass is never reported.
#[test]
fn a_host_with_another_mass_is_reported_once() {
    for (mass_factor, differs) in [(0.5, 1), (0.75, 1), (1.0, 0), (1.1, 0), (1.3, 1), (2.0, 1)] {
        for push_n in [0.0, 1e5] {
            every_master(|integration, delay_steps| {
                let mut scene = tug_at_a_wall(1.0, 0.5, 0.5);
                let mut master = Master::known(scene.clone(), integration, delay_steps);
                master.mass_factor = mass_factor;
                let mut frames = Frames::new(5, 0.2, 1e9);
                let (mut reported, mut events) = (0, 0);
                // The tug moves against the wall, then away from it, and an unreported load pushes her to rest.
                while frames.time_s < 240.0 {
                    scene.loads[0].force_n.x = if frames.time_s > 90.0 { push_n } else { 0.0 };
                    master.scene.loads.clone_from(&scene.loads);
                    master.step(frames.next_s());
                    let kinds = master.work.events().iter().map(|event| event.kind);
                    reported += kinds.filter(|kind| *kind == EventKind::MassMismatch).count();
                    events += master.work.events().len();
                }
                let who = format!("{mass_factor}, {push_n} N, {integration:?}, {delay_steps}");
                assert_eq!(reported, differs, "{who}");
                assert!(events < 40, "{who}: {events}");
                // These are the speeds of an impact that lasts half a second, in frames of up to 0.2 s.
                let left_mps = -master.states()[0].velocity_mps.x;
                assert!(push_n > 0.0 || (0.1..0.5).contains(&left_mps), "{who}: {left_mps} m/s");
            });
        }
    }
}

/// This holds for any mass if the contact lasts many frames: the engine then learns in time which part of the motion it
/// takes for a load.
#[test]
fn a_ship_with_half_or_twice_her_mass_rebounds_at_the_right_speed() {
    for mass_factor in [0.5, 2.0] {
        every_master(|integration, delay_steps| {
            let mut master = Master::known(berthing(2e7, 0.3, 0.5), integration, delay_steps);
            master.mass_factor = mass_factor;
            let mut frames = Frames::new(5, 0.1, 1e9);
            let [.., left_mps] = berthed(master, || frames.next_s());
            let who = format!("{mass_factor}, {integration:?}, delay {delay_steps}");
            assert!((left_mps / 0.15 - 1.0).abs() < 0.1, "{who}: {left_mps} m/s");
        });
    }
}

/// A pause was refused. For a host without delay it now changes no bit.
#[test]
fn a_pause_changes_nothing() {
    every_master(|integration, delay_steps| {
        let run = |pauses: bool| {
            let scene = ship_and_push();
            let mut master = Master::known(scene, integration, delay_steps);
            let mut frames = Frames::new(3, 0.5, 11.0);
            for k in 0..400 {
                if pauses && k % 7 == 3 {
                    for _ in 0..1 + k % 3 {
                        master.step(0.0);
                        assert!(master.work.events().is_empty());
                    }
                }
                master.step(frames.next_s());
            }
            (master.states().to_vec(), master.work.wrenches().to_vec())
        };
        let ((without, _), (with, _)) = (run(false), run(true));
        if delay_steps == 0 {
            assert_eq!(run(false), run(true), "{integration:?}");
        }
        // After a pause delayed states are newer, so the engine knows a load sooner.
        let apart_m = (without[0].position_m - with[0].position_m).length();
        assert!(apart_m < 1e-3, "{integration:?}, delay {delay_steps}: {apart_m} m");
    });
}

fn ship_and_push() -> Scene {
    let mut scene = berthing(2e7, 0.3, 0.1);
    scene.loads[0].force_n = vec2(2e5, 3e4);
    scene
}

#[test]
fn a_pause_of_a_direct_host_gives_the_last_wrench_and_the_input_states() {
    let mut scene = ship_and_push();
    let (mut memory, mut work) = (Memory::new(&scene.model), Workspace::new(&scene.model));
    // Before the first step too.
    advance(&scene.model, &mut memory, &mut work, &scene.states, &scene.loads, 0.0).unwrap();
    assert_eq!(work.wrenches(), &[Wrench::default(); 2]);
    assert_eq!(memory, Memory::new(&scene.model));
    for _ in 0..50 {
        advance(&scene.model, &mut memory, &mut work, &scene.states, &scene.loads, 0.1).unwrap();
        scene.states.copy_from_slice(work.states_after());
    }
    let (before, wrenches) = (memory.clone(), work.wrenches().to_vec());
    advance(&scene.model, &mut memory, &mut work, &scene.states, &scene.loads, 0.0).unwrap();
    assert_eq!((&memory, work.wrenches()), (&before, wrenches.as_slice()));
    assert_eq!(work.states_after(), scene.states);
    let mut states = scene.states.clone();
    advance_in_place(&scene.model, &mut memory, &mut work, &mut states, &scene.loads, 0.0).unwrap();
    assert_eq!((&memory, &states), (&before, &scene.states));
    // Bad input is refused in a pause too.
    states[0].velocity_mps.x = f64::NAN;
    assert!(advance(&scene.model, &mut memory, &mut work, &states, &scene.loads, 0.0).is_err());
    assert!(
        advance(&scene.model, &mut memory, &mut work, &scene.states, &scene.loads, -0.1).is_err()
    );
}

#[test]
fn a_run_of_frames_continues_from_a_snapshot_bit_for_bit() {
    every_master(|integration, delay_steps| {
        let mut one = Master::known(ship_and_push(), integration, delay_steps);
        let mut frames = Frames::new(9, 0.5, 5.0);
        for k in 0..300 {
            if k % 10 == 0 {
                let model = &one.scene.model;
                let settings = HostSettings { delay_steps, integration };
                let mut two = CoSimHost::new(model, settings);
                two.restore(model, &one.host.snapshot(model)).expect("its own bytes");
                assert_eq!(one.host, two);
                one.host = two;
                one.work = HostWorkspace::new(model);
            }
            one.step(if k % 13 == 0 { 0.0 } else { frames.next_s() });
        }
        let mut other = Master::known(ship_and_push(), integration, delay_steps);
        let mut frames = Frames::new(9, 0.5, 5.0);
        for k in 0..300 {
            other.step(if k % 13 == 0 { 0.0 } else { frames.next_s() });
        }
        assert_eq!(one.states(), other.states());
    });
}
