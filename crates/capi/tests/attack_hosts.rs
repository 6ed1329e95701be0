//! Attack by inconsistent hosts through the C functions: random positions, velocities that contradict them, time steps
//! from 1e-9 to 1e6 s, altered saved states. There must be no panic, no non-finite result, no hang, and no growth of
//! memory.
//!
//! `FENDERLINE_ATTACK_SECONDS` is the duration (2 s by default), `FENDERLINE_ATTACK_SEED` the first seed.
#![allow(unsafe_code, reason = "the calls are those of a C program")]
#![allow(clippy::disallowed_methods, reason = "they give random input, not results")]

use std::ptr;
use std::time::{Duration, Instant};

use fenderline::*;
use fenderline_contact::hash::Fnv1a;

const SCENARIOS: [&str; 5] = [
    "paper/experiment_2_4kn.toml",
    "berth/eight_cones_at_5_deg.toml",
    "berth/bulb_and_stern_step_at_a_corner.toml",
    "berth/two_ships_on_pneumatic_fenders.toml",
    "closed_form/concrete_behind_fender.toml",
];
/// A call that takes longer has hung (seconds of computing).
const LONGEST_CALL_S: f64 = 10.0;

#[derive(Default)]
struct Tally {
    engines: u64,
    calls: u64,
    steps: u64,
    refused: u64,
    events: u64,
    altered: u64,
    altered_taken: u64,
    slowest_s: f64,
}

#[test]
fn inconsistent_hosts() {
    let seconds = setting("FENDERLINE_ATTACK_SECONDS", 2);
    let mut seed = setting("FENDERLINE_ATTACK_SEED", 1);
    let begun = Instant::now();
    let mut tally = Tally::default();
    let mut settled_kib = None;
    while begun.elapsed() < Duration::from_secs(seconds) {
        attack(seed, &mut tally);
        seed += 1;
        // Buffers reach their size in the first quarter; later growth is a leak.
        if settled_kib.is_none() && begun.elapsed() > Duration::from_secs(seconds) / 4 {
            settled_kib = resident_kib();
        }
    }
    let end_kib = resident_kib();
    let Tally { engines, calls, steps, refused, events, altered, altered_taken, slowest_s } = tally;
    println!(
        "inconsistent hosts through C: {engines} engines, {calls} calls, {steps} steps, {refused} refused, {events} events; \
         {altered} altered states, {altered_taken} taken; slowest call {slowest_s:.3} s; memory {settled_kib:?} to \
         {end_kib:?} KiB; next seed {seed}"
    );
    assert!(steps > 100, "hardly anything was tried");
    if let (Some(settled), Some(end)) = (settled_kib, end_kib) {
        assert!(end < settled + settled / 4 + 16 * 1024, "memory grew from {settled} to {end} KiB");
    }
}

fn attack(seed: u64, tally: &mut Tally) {
    let mut random = Random(seed);
    let scenario = SCENARIOS[random.below(SCENARIOS.len())];
    let path = format!("{}/../../scenarios/{scenario}", env!("CARGO_MANIFEST_DIR"));
    let settings = FlSettings {
        size: size_of::<FlSettings>(),
        method: random.below(3) as u32,
        host: random.below(2) as u32,
        integration: random.below(2) as u32,
        delay_steps: random.below(4) as u32,
        ..FlSettings::default()
    };
    let mut engine = ptr::null_mut();
    // SAFETY: a text with its length, settings, room for a handle; below: arrays of the given length.
    let made = unsafe {
        fl_engine_from_file(
            path.as_ptr().cast(),
            path.len(),
            ptr::null(),
            0,
            &settings,
            &mut engine,
        )
    };
    if made != FlStatus::Ok {
        tally.refused += 1;
        return;
    }
    tally.engines += 1;
    let mut count = 0;
    assert_eq!(unsafe { fl_engine_body_count(engine, &mut count) }, FlStatus::Ok);
    let mut states = vec![FlState::default(); count];
    assert_eq!(
        unsafe { fl_engine_initial_states(engine, states.as_mut_ptr(), count) },
        FlStatus::Ok
    );
    let at_start = states.clone();
    let mut wrenches = vec![FlWrench::default(); count];
    let mut saved: Vec<u8> = Vec::new();
    let mut step_s = 0.1;
    for _ in 0..300 {
        let what = random.below(20);
        let body = random.below(count);
        match what {
            0 => states[body].north_m = random.length(),
            1 => states[body].east_m = random.length(),
            2 => states[body].heading_rad = random.length(),
            // Onto another body.
            3 => states[body] = states[random.below(count)],
            4 => states[body].north_mps = random.length(),
            5 => states[body].yaw_rate_radps = random.length(),
            6 => states.copy_from_slice(&at_start),
            7 => step_s = 10_f64.powf(random.between(-9.0, 6.0)),
            8 => step_s = random.number(),
            9 => states[body].east_mps = random.number(),
            10 => {
                assert_eq!(fl_engine_mark_teleported(engine, body as u32), FlStatus::Ok);
            }
            11 => {
                let load = FlWrench {
                    north_n: random.length() * 1e3,
                    east_n: random.number(),
                    moment_nm: random.length(),
                };
                let loads = vec![load; count];
                let set = unsafe { fl_engine_set_loads(engine, loads.as_ptr(), count) };
                tally.refused += u64::from(set != FlStatus::Ok);
            }
            12 => save(engine, &mut saved),
            13 if !saved.is_empty() => {
                let mut bytes = saved.clone();
                alter(&mut bytes, &mut random);
                tally.altered += 1;
                let taken = unsafe { fl_engine_restore(engine, bytes.as_ptr(), bytes.len()) };
                tally.altered_taken += u64::from(taken == FlStatus::Ok);
            }
            14 if !saved.is_empty() => {
                let back = unsafe { fl_engine_restore(engine, saved.as_ptr(), saved.len()) };
                assert_eq!(back, FlStatus::Ok, "seed {seed}: its own state");
            }
            // Motion by the velocities, mostly right.
            _ => {
                let share = [1.0, 1.0, 1.0, 0.0, -1.0, 2.0][random.below(6)];
                let time_s = if step_s.is_finite() { share * step_s } else { 0.0 };
                for state in &mut states {
                    state.north_m += state.north_mps * time_s;
                    state.east_m += state.east_mps * time_s;
                    state.heading_rad += state.yaw_rate_radps * time_s;
                }
            }
        }
        let (now, before_s) = (Instant::now(), busy_s(Instant::now()));
        let set = unsafe { fl_engine_set_states(engine, states.as_ptr(), count) };
        let stepped = if set == FlStatus::Ok { fl_engine_step(engine, step_s) } else { set };
        tally.slowest_s = tally.slowest_s.max(busy_s(now) - before_s);
        assert!(tally.slowest_s < LONGEST_CALL_S, "seed {seed}: {} s", tally.slowest_s);
        tally.calls += 2;
        assert_ne!(stepped, FlStatus::Panicked, "seed {seed}");
        if stepped != FlStatus::Ok {
            tally.refused += 1;
            states.copy_from_slice(&at_start);
            step_s = 0.1;
            continue;
        }
        tally.steps += 1;
        let got = unsafe { fl_engine_wrenches(engine, wrenches.as_mut_ptr(), count) };
        if got == FlStatus::Ok {
            for FlWrench { north_n, east_n, moment_nm } in &wrenches {
                let finite = north_n.is_finite() && east_n.is_finite() && moment_nm.is_finite();
                assert!(finite, "seed {seed}: {wrenches:?}");
            }
        }
        let mut events = 0;
        assert_eq!(unsafe { fl_engine_event_count(engine, &mut events) }, FlStatus::Ok);
        tally.events += events as u64;
        let after = unsafe { fl_engine_states_after(engine, states.as_mut_ptr(), count) };
        if after == FlStatus::Ok {
            for state in &states {
                let FlState { north_m, east_m, heading_rad, north_mps, east_mps, yaw_rate_radps } =
                    *state;
                let all = [north_m, east_m, heading_rad, north_mps, east_mps, yaw_rate_radps];
                assert!(all.iter().all(|v| v.is_finite()), "seed {seed}: {state:?}");
            }
        }
    }
    assert_eq!(fl_engine_destroy(engine), FlStatus::Ok);
}

fn save(engine: *mut FlEngine, into: &mut Vec<u8>) {
    let mut size = 0;
    // SAFETY: a query of the size, then room for it.
    unsafe {
        fl_engine_save(engine, ptr::null_mut(), 0, &mut size);
        into.resize(size, 0);
        let saved = fl_engine_save(engine, into.as_mut_ptr(), into.len(), &mut size);
        if saved != FlStatus::Ok {
            into.clear();
        }
    }
}

/// Changes bits, numbers and length; half of the results get a valid check sum.
fn alter(bytes: &mut Vec<u8>, random: &mut Random) {
    for _ in 0..=random.below(3) {
        let at = random.below(bytes.len());
        match random.below(4) {
            0 => bytes[at] ^= 1 << random.below(8),
            1 => bytes[at] = random.next() as u8,
            2 => {
                let at = at / 8 * 8;
                if at + 8 <= bytes.len() {
                    bytes[at..at + 8].copy_from_slice(&random.number().to_le_bytes());
                }
            }
            _ => bytes.truncate(at.max(1)),
        }
    }
    if bytes.len() > 8 && random.below(2) == 0 {
        let end = bytes.len() - 8;
        let sum = Fnv1a::of(&bytes[..end]);
        bytes[end..].copy_from_slice(&sum.to_le_bytes());
    }
}

fn setting(name: &str, otherwise: u64) -> u64 {
    std::env::var(name).map_or(otherwise, |text| text.parse().expect("a whole number"))
}

/// CPU time of this thread (s), or clock time where the system does not report it. On a busy machine a call takes longer
/// without having hung.
fn busy_s(since: Instant) -> f64 {
    let stat = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = stat.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| since.elapsed().as_secs_f64(), |ns| 1e-9 * ns)
}

/// Resident memory of the process, where the system reports it.
fn resident_kib() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    line.split_whitespace().next()?.parse().ok()
}

/// SplitMix64.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count as u64) as usize
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Of any size, either sign.
    fn length(&mut self) -> f64 {
        let size = 10_f64.powf(self.between(-6.0, 4.0));
        if self.below(2) == 0 { size } else { -size }
    }

    /// Any bits, special values, or a usual number.
    fn number(&mut self) -> f64 {
        const SPECIAL: [f64; 12] = [
            0.0,
            -0.0,
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::MAX,
            f64::MIN_POSITIVE,
            5e-324,
            1e-9,
            1e6,
            1e300,
            -1.0,
        ];
        match self.below(3) {
            0 => f64::from_bits(self.next()),
            1 => SPECIAL[self.below(SPECIAL.len())],
            _ => self.length(),
        }
    }
}
