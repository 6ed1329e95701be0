//! Attack on FMI 3.0: altered states, inputs of any size, steps from 1e-9 to 1e6 s, calls in any order. There must be
//! no panic, no NaN in an output, no hang, and no growth of memory.
//!
//! `FENDERLINE_ATTACK_SECONDS` is the duration (2 s by default), `FENDERLINE_ATTACK_SEED` the first seed.
#![allow(unsafe_code, reason = "the test acts as a master")]
#![allow(clippy::disallowed_methods, reason = "they give random input, not results")]

use crate::support;

use std::ffi::{CString, c_char, c_int, c_void};
use std::ptr::{null, null_mut, without_provenance_mut};
use std::time::{Duration, Instant};

use fenderline_contact::hash::Fnv1a;
use fenderline_fmu::{Kind, fmi3};
use support::{OK, Unpacked};

/// A call that takes longer counts as hung: seconds of computing, and more for each simulated second.
const LONGEST_CALL_S: [f64; 2] = [20.0, 1e-3];

#[derive(Default)]
struct Tally {
    instances: u64,
    calls: u64,
    steps: u64,
    refused: u64,
    altered: u64,
    altered_taken: u64,
    slowest_s: f64,
}

#[test]
fn altered_states_of_fmi_3() {
    let seconds = setting("FENDERLINE_ATTACK_SECONDS", 2);
    let mut seed = setting("FENDERLINE_ATTACK_SEED", 1);
    let begun = Instant::now();
    let fmus = [
        Unpacked::new(Kind::Engine, "attack-engine"),
        Unpacked::new(Kind::Simulation, "attack-sim"),
    ];
    let mut tally = Tally::default();
    let mut settled_kib = None;
    while begun.elapsed() < Duration::from_secs(seconds) {
        attack(&fmus[seed as usize % 2], seed, &mut tally);
        seed += 1;
        // Buffers reach their size in the first quarter; later growth is a leak.
        if settled_kib.is_none() && begun.elapsed() > Duration::from_secs(seconds) / 4 {
            settled_kib = resident_kib();
        }
    }
    let end_kib = resident_kib();
    let Tally { instances, calls, steps, refused, altered, altered_taken, slowest_s } = tally;
    println!(
        "states of FMI 3: {instances} instances, {calls} calls, {steps} steps, {refused} refused; {altered} altered \
         states, {altered_taken} taken; slowest call {slowest_s:.3} s; memory {settled_kib:?} to {end_kib:?} KiB; \
         next seed {seed}"
    );
    assert!(steps > 20, "hardly anything was tried");
    if let (Some(settled), Some(end)) = (settled_kib, end_kib) {
        assert!(end < settled + settled / 4 + 16 * 1024, "memory grew from {settled} to {end} KiB");
    }
}

// SAFETY of all below: arrays have the given length and live during the call.
fn attack(fmu: &Unpacked, seed: u64, tally: &mut Tally) {
    let mut random = Random(seed);
    let (token, path) = (fmu.token(), fmu.uri().into_string().expect("UTF-8"));
    let path = CString::new(format!("{}/", path.trim_start_matches("file://"))).expect("no NUL");
    let instance = unsafe {
        fmi3::fmi3InstantiateCoSimulation(
            c"tug".as_ptr(),
            token.as_ptr(),
            path.as_ptr(),
            0,
            0,
            0,
            0,
            null(),
            0,
            null_mut(),
            Some(log),
            None,
        )
    };
    assert!(!instance.is_null(), "seed {seed}");
    tally.instances += 1;
    let enter = || unsafe {
        fmi3::fmi3EnterInitializationMode(instance, 0, 0.0, 0.0, 0, 0.0);
        fmi3::fmi3ExitInitializationMode(instance)
    };
    assert_eq!(enter(), OK);
    let count = fmu.plan.table.variables.len();
    let mut time_s = 0.0;
    let mut step_s = 0.1;
    let mut state: *mut c_void = null_mut();
    let mut bytes: Vec<u8> = Vec::new();
    for _ in 0..150 {
        let (now, before_s) = (Instant::now(), busy_s(Instant::now()));
        let status = match random.below(16) {
            0 | 1 => {
                let (reference, value) = (random.below(count + 2) as u32, random.number());
                unsafe { fmi3::fmi3SetFloat64(instance, &reference, 1, &value, 1) }
            }
            2 => {
                let (reference, value) = (random.below(count + 2) as u32, random.below(2) == 0);
                unsafe { fmi3::fmi3SetBoolean(instance, &reference, 1, &value.into(), 1) }
            }
            3 => {
                step_s = 10_f64.powf(random.between(-9.0, 6.0));
                OK
            }
            4 => {
                (time_s, step_s) = (random.number(), random.number());
                OK
            }
            5 => unsafe { fmi3::fmi3GetFMUState(instance, &mut state) },
            6 => {
                let mut size = 0;
                let status =
                    unsafe { fmi3::fmi3SerializedFMUStateSize(instance, state, &mut size) };
                if status == OK {
                    bytes.resize(size, 0);
                    unsafe {
                        fmi3::fmi3SerializeFMUState(instance, state, bytes.as_mut_ptr(), size)
                    }
                } else {
                    status
                }
            }
            7 | 8 if !bytes.is_empty() => {
                let mut other = bytes.clone();
                alter(&mut other, &mut random);
                let mut altered = null_mut();
                tally.altered += 1;
                let status = unsafe {
                    let (from, size) = (other.as_ptr(), other.len());
                    fmi3::fmi3DeserializeFMUState(instance, from, size, &mut altered)
                };
                if status == OK {
                    tally.altered_taken += 1;
                    unsafe {
                        fmi3::fmi3SetFMUState(instance, altered);
                        fmi3::fmi3FreeFMUState(instance, &mut altered)
                    }
                } else {
                    status
                }
            }
            // A state that does not exist.
            9 => unsafe {
                let made_up = without_provenance_mut(random.below(1000));
                fmi3::fmi3SetFMUState(instance, made_up)
            },
            10 => unsafe { fmi3::fmi3SetFMUState(instance, state) },
            11 if random.below(8) == 0 => unsafe {
                fmi3::fmi3Reset(instance);
                time_s = 0.0;
                step_s = 0.1;
                enter()
            },
            12 => unsafe { fmi3::fmi3FreeFMUState(instance, &mut state) },
            _ => {
                let (mut event, mut ends, mut early, mut reached_s) = (0, 0, 0, 0.0);
                let status = unsafe {
                    fmi3::fmi3DoStep(
                        instance,
                        time_s,
                        step_s,
                        0,
                        (&raw mut event).cast(),
                        (&raw mut ends).cast(),
                        (&raw mut early).cast(),
                        &mut reached_s,
                    )
                };
                if status == OK {
                    tally.steps += 1;
                    assert!(reached_s.is_finite(), "seed {seed}: {reached_s}");
                    time_s = reached_s;
                }
                status
            }
        };
        tally.calls += 1;
        tally.refused += u64::from(status != OK);
        let took_s = busy_s(now) - before_s;
        tally.slowest_s = tally.slowest_s.max(took_s);
        let may_take_s = LONGEST_CALL_S[0] + LONGEST_CALL_S[1] * step_s.clamp(0.0, 1e6);
        assert!(may_take_s.is_nan() || took_s < may_take_s, "seed {seed}: {took_s} s");
        for reference in 0..count as u32 {
            let mut value = 0.0;
            if unsafe { fmi3::fmi3GetFloat64(instance, &reference, 1, &mut value, 1) } == OK {
                let name = &fmu.plan.table.variables[reference as usize].name;
                assert!(!value.is_nan(), "seed {seed}: {name} is {value}");
            }
        }
    }
    unsafe { fmi3::fmi3FreeInstance(instance) };
}

/// A panic in the library is reported as a message.
unsafe extern "C" fn log(
    _environment: *mut c_void,
    status: c_int,
    _category: *const c_char,
    message: *const c_char,
) {
    // SAFETY: the message is a text.
    let text = unsafe { std::ffi::CStr::from_ptr(message) }.to_string_lossy();
    if text.contains("a mistake of fenderline's") {
        eprintln!("status {status}: {text}");
        std::process::abort();
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
