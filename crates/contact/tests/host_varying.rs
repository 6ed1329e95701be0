//! Hosts whose step varies, as the frames of a game do: jitter, pauses, and single frames of seconds.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

#[allow(dead_code, reason = "each test uses its own part of the master")]
mod master;

use fenderline_contact::{
    BodyState, CoSimHost, EventKind, HostIntegration, HostSettings, HostWorkspace, Memory,
    Mobility, Workspace, Wrench, advance, advance_in_place, vec2,
};
use master::{Master, Service, Story, model, rectangle, rubber, tug_at_a_wall};

const INTEGRATIONS: [HostIntegration; 2] =
    [HostIntegration::ForwardEuler, HostIntegration::SemiImplicit];
const FRAME_S: f64 = 1.0 / 60.0;

/// Frames from 1/60 s to the longest, pseudo-random and the same every time; and now and then one of 2 s.
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

/// It was 1.04, 2.44, 4.83, 9.84 and 24.1 MN: half a kick of the longer step, given back in 1/60 s.
#[test]
fn a_tug_at_rest_under_an_untold_push_feels_no_frame_that_takes_longer() {
    const PUSH_N: f64 = 305e3;
    let mut story = tug_at_a_wall(0.0, 0.0, 0.1);
    story.loads[0].force_n.x = PUSH_N;
    every_master(|integration, delay_steps| {
        let mut master = Master::known(story.clone(), integration, delay_steps);
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

/// A tug at rest at a soft wall, pushed from the first step on. The host's own steps give her half a step of the load
/// before she is at her place; the engine took her to have another half of a (sub-)step, and she went 2.8 % too deep.
#[test]
fn a_tug_pushed_from_rest_has_not_half_a_step_of_the_load_too_much() {
    const PUSH_N: f64 = 2e5;
    let stiffness_npm = 50e3 * 13.0;
    for step_s in [0.1, 0.5, 1.0, 2.0] {
        every_master(|integration, delay_steps| {
            let mut story = tug_at_a_wall(0.0, 0.0, 1.0);
            let bodies = story.model.bodies().iter();
            let bodies: Vec<_> = bodies.map(|b| (b.outline.clone(), b.mobility)).collect();
            story.model = model(&bodies, rubber(50e3, 1.0, 0.0));
            story.loads[0].force_n.x = PUSH_N;
            let settings = HostSettings { delay_steps, integration };
            let mut master = Master::new(story, integration, delay_steps, Service::Told(settings));
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

/// A ship of 80 m × 20 m that drifts sideways, 1 m off a wall of 50 kN/m².
fn berthing(mass_kg: f64, speed_mps: f64, restitution: f64) -> Story {
    let ship = Mobility::Free { mass_kg, yaw_inertia_kgm2: mass_kg * 400.0 };
    let bodies = [(rectangle(20.0, 80.0), ship), (rectangle(40.0, 300.0), Mobility::Fixed)];
    Story {
        model: model(&bodies, rubber(50e3, restitution, 0.2)),
        states: vec![
            BodyState { velocity_mps: vec2(speed_mps, 0.0), ..BodyState::default() },
            BodyState { position_m: vec2(31.0, 0.0), ..BodyState::default() },
        ],
        loads: vec![Wrench::default(); 2],
    }
}

/// Largest wrench, largest peak told of the ship and of a contact (N), and the speed at which she leaves (m/s).
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

/// Forward Euler hosts went up to 0.5 m too deep in a frame, and left seven times as fast.
#[test]
fn a_ship_berths_with_jitter_and_frames_of_2_s_as_with_fixed_ones() {
    for (mass_kg, restitution) in [(2e7, 0.1), (2e7, 0.5), (1e8, 0.1), (1e8, 0.5)] {
        for speed_mps in [0.15, 0.5] {
            every_master(|integration, delay_steps| {
                let story = berthing(mass_kg, speed_mps, restitution);
                let master = || Master::known(story.clone(), integration, delay_steps);
                let [fixed_n, _, _, fixed_mps] = berthed(master(), || FRAME_S);
                for (seed, single_every_s) in [(1, 1e9), (2, 1e9), (3, 11.0), (4, 11.0), (5, 4.0)] {
                    let mut frames = Frames::new(seed, 0.5, single_every_s);
                    let [largest_n, peak_n, of_contact_n, left_mps] =
                        berthed(master(), || frames.next_s());
                    let who = format!(
                        "{mass_kg} kg, γ {restitution}, {speed_mps} m/s, {integration:?}, delay {delay_steps}, seed {seed}"
                    );
                    // The wrench is a mean over the frame, for the impulse's sake: where the force falls off within
                    // one of 2 s, as it does of a light ship past the deepest point, it is less than the peak.
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

/// A contact of half a second within frames of 2 s: she leaves as fast as she should, and never faster.
#[test]
fn a_tug_that_hits_and_leaves_within_a_frame_leaves_as_fast_as_she_should() {
    for restitution in [0.1, 0.5] {
        every_master(|integration, delay_steps| {
            for seed in 1..=10 {
                let story = tug_at_a_wall(1.0, 0.5, restitution);
                let mut frames = Frames::new(seed, 0.5, 4.0);
                let master = Master::known(story, integration, delay_steps);
                let [.., left_mps] = berthed(master, || frames.next_s());
                let who = format!("γ {restitution}, {integration:?}, delay {delay_steps}, {seed}");
                let right_mps = restitution * 0.5;
                assert!((left_mps / right_mps - 1.0).abs() < 0.003, "{who}: {left_mps} m/s");
            }
        });
    }
}

/// It was 0.95 m along the pier. Friction's spring holds her along it, to and fro by 17 mm: means count.
#[test]
fn a_ship_under_wind_stays_where_she_is_for_an_hour_of_jitter() {
    for (longest_s, single_every_s) in [(0.2, 1e9), (0.5, 60.0)] {
        for integration in INTEGRATIONS {
            let mut story = master::ship_on_two_fenders(0.3);
            let (sin, cos) = libm::sincos(core::f64::consts::FRAC_PI_6);
            let (along, across) = (vec2(cos, sin), vec2(-sin, cos));
            story.loads[0].force_n += along * 1e5;
            let load_n = story.loads[0].force_n.length();
            let mut frames = Frames::new(7, longest_s, single_every_s);
            let mut master = Master::known(story, integration, 1);
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

/// A mass that is not the model's is told, once. Nothing is told of one that is.
#[test]
fn a_host_that_moves_a_tug_with_another_mass_is_told_so_once() {
    for (mass_factor, differs) in [(0.5, 1), (0.75, 1), (1.0, 0), (1.1, 0), (1.3, 1), (2.0, 1)] {
        for push_n in [0.0, 1e5] {
            every_master(|integration, delay_steps| {
                let mut story = tug_at_a_wall(1.0, 0.5, 0.5);
                let mut master = Master::known(story.clone(), integration, delay_steps);
                master.mass_factor = mass_factor;
                let mut frames = Frames::new(5, 0.2, 1e9);
                let (mut told, mut events) = (0, 0);
                // Against the wall, off it, and pushed to rest by a load that nobody told.
                while frames.time_s < 240.0 {
                    story.loads[0].force_n.x = if frames.time_s > 90.0 { push_n } else { 0.0 };
                    master.story.loads.clone_from(&story.loads);
                    master.step(frames.next_s());
                    let kinds = master.work.events().iter().map(|event| event.kind);
                    told += kinds.filter(|kind| *kind == EventKind::MassMismatch).count();
                    events += master.work.events().len();
                }
                let who = format!("{mass_factor}, {push_n} N, {integration:?}, {delay_steps}");
                assert_eq!(told, differs, "{who}");
                assert!(events < 40, "{who}: {events}");
                // The speeds are those of a hit that takes half a second, in frames of up to 0.2 s.
                let left_mps = -master.states()[0].velocity_mps.x;
                assert!(push_n > 0.0 || (0.1..0.5).contains(&left_mps), "{who}: {left_mps} m/s");
            });
        }
    }
}

/// Whatever the mass, where the contact takes many frames: what the engine takes for a load is then known in time.
#[test]
fn a_ship_with_half_or_twice_her_mass_rebounds_as_she_should() {
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

/// A pause was refused. Now it changes no bit for a direct host.
#[test]
fn a_pause_changes_nothing_and_is_good() {
    every_master(|integration, delay_steps| {
        let run = |pauses: bool| {
            let story = ship_and_push();
            let mut master = Master::known(story, integration, delay_steps);
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
        // What is shown late is younger after a pause: a load is known sooner.
        let apart_m = (without[0].position_m - with[0].position_m).length();
        assert!(apart_m < 1e-3, "{integration:?}, delay {delay_steps}: {apart_m} m");
    });
}

fn ship_and_push() -> Story {
    let mut story = berthing(2e7, 0.3, 0.1);
    story.loads[0].force_n = vec2(2e5, 3e4);
    story
}

#[test]
fn a_pause_of_a_direct_host_gives_the_last_wrench_and_the_input_states() {
    let mut story = ship_and_push();
    let (mut memory, mut work) = (Memory::new(&story.model), Workspace::new(&story.model));
    // Before the first step, too.
    advance(&story.model, &mut memory, &mut work, &story.states, &story.loads, 0.0).unwrap();
    assert_eq!(work.wrenches(), &[Wrench::default(); 2]);
    assert_eq!(memory, Memory::new(&story.model));
    for _ in 0..50 {
        advance(&story.model, &mut memory, &mut work, &story.states, &story.loads, 0.1).unwrap();
        story.states.copy_from_slice(work.states_after());
    }
    let (before, wrenches) = (memory.clone(), work.wrenches().to_vec());
    advance(&story.model, &mut memory, &mut work, &story.states, &story.loads, 0.0).unwrap();
    assert_eq!((&memory, work.wrenches()), (&before, wrenches.as_slice()));
    assert_eq!(work.states_after(), story.states);
    let mut states = story.states.clone();
    advance_in_place(&story.model, &mut memory, &mut work, &mut states, &story.loads, 0.0).unwrap();
    assert_eq!((&memory, &states), (&before, &story.states));
    // Bad input is bad in a pause, too.
    states[0].velocity_mps.x = f64::NAN;
    assert!(advance(&story.model, &mut memory, &mut work, &states, &story.loads, 0.0).is_err());
    assert!(
        advance(&story.model, &mut memory, &mut work, &story.states, &story.loads, -0.1).is_err()
    );
}

#[test]
fn a_run_of_frames_goes_on_from_a_snapshot_bit_for_bit() {
    every_master(|integration, delay_steps| {
        let mut one = Master::known(ship_and_push(), integration, delay_steps);
        let mut frames = Frames::new(9, 0.5, 5.0);
        for k in 0..300 {
            if k % 10 == 0 {
                let model = &one.story.model;
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
