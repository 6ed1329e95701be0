//! States that a master saves, restores, serialises or forges; and calls in any order.
#![allow(unsafe_code, reason = "the test acts as a master")]

use crate::support;

use std::ffi::c_void;
use std::ptr::without_provenance_mut;

use fenderline_contact::hash::Fnv1a;
use fenderline_fmu::{Kind, fmi2};
use support::{ERROR, Messages, OK, Two, Unpacked};

const KINDS: [(Kind, &str, &str); 2] = [
    (Kind::Engine, "body.tug.y_m", "engine"),
    (Kind::Simulation, "body.tug.external_y_n", "simulation"),
];

fn value(kind: Kind, step: u32) -> f64 {
    match kind {
        Kind::Engine => 3.5 + 0.1 * f64::from(step),
        Kind::Simulation => 1e4 * f64::from(step % 7),
    }
}

/// Takes some steps and returns the forces.
fn play(
    fmu: &Unpacked,
    tug: &Two,
    (kind, input): (Kind, &str),
    steps: std::ops::Range<u32>,
) -> Vec<u64> {
    let input = fmu.reference(input);
    let force = fmu.reference("body.tug.force_y_n");
    let mut seen = Vec::new();
    for step in steps {
        assert_eq!(tug.set(&[input], &[value(kind, step)]), OK);
        assert_eq!(tug.step(0.1 * f64::from(step), 0.1), OK);
        seen.push(tug.get(&[force]).expect("it is there")[0].to_bits());
    }
    seen
}

#[test]
fn a_saved_state_continues_with_the_same_bits_in_any_instance() {
    for (kind, input, name) in KINDS {
        let fmu = Unpacked::new(kind, &format!("saved-{name}"));
        let log = Messages::default();
        let (one, two) = (fmu.two(&log).initialized(), fmu.two(&log));
        play(&fmu, &one, (kind, input), 0..8);
        let state = one.save();
        let bytes = one.bytes(state);
        let straight = play(&fmu, &one, (kind, input), 8..40);
        assert!(straight.iter().any(|force| f64::from_bits(*force) != 0.0));
        assert_eq!(one.restore(state), OK);
        assert_eq!(play(&fmu, &one, (kind, input), 8..40), straight, "{name}: restored");
        // Not initialized: the bytes hold that too.
        let other = two.of_bytes(&bytes).expect("good bytes");
        assert_eq!(two.restore(state), ERROR, "a state of another instance");
        assert_eq!(two.restore(other), OK);
        assert_eq!(play(&fmu, &two, (kind, input), 8..40), straight, "{name}: from bytes");
        // SAFETY: one pointer.
        unsafe {
            let mut state = state;
            assert_eq!(fmi2::fmi2FreeFMUstate(one.0, &mut state), OK);
            assert!(state.is_null());
            assert_eq!(fmi2::fmi2FreeFMUstate(one.0, &mut state), OK, "NULL is freed already");
        }
        assert_eq!(one.restore(state), ERROR, "it was freed");
    }
}

/// At a time of 1.6e308 s, a step of the same length was taken and gave an infinite time.
#[test]
fn a_step_to_an_infinite_time_is_refused() {
    for (kind, _, name) in KINDS {
        let fmu = Unpacked::new(kind, &format!("nowhere-{name}"));
        let log = Messages::default();
        let tug = fmu.two(&log);
        assert_eq!(tug.set_up(1.6e308, None), OK);
        assert_eq!((tug.enter(), tug.exit()), (OK, OK));
        assert_eq!(tug.step(1.6e308, 1.6e308), ERROR, "{name}");
        assert!(log.last().contains("is not valid"), "{name}");
    }
}

#[test]
fn invalid_bytes_are_refused() {
    for (kind, input, name) in KINDS {
        let fmu = Unpacked::new(kind, &format!("bytes-{name}"));
        let log = Messages::default();
        let tug = fmu.two(&log).initialized();
        play(&fmu, &tug, (kind, input), 0..20);
        let bytes = tug.bytes(tug.save());
        for cut in 0..bytes.len() {
            assert_eq!(tug.of_bytes(&bytes[..cut]), Err(ERROR), "{cut} bytes");
        }
        for at in 0..bytes.len() {
            let mut broken = bytes.clone();
            broken[at] ^= 0x10;
            assert_eq!(tug.of_bytes(&broken), Err(ERROR), "byte {at}");
        }
        // With a valid check sum, bytes that are accepted give a state whose steps succeed or are refused.
        for at in 0..bytes.len() - 8 {
            let mut broken = bytes.clone();
            broken[at] = broken[at].wrapping_add(1);
            let end = broken.len() - 8;
            let sum = Fnv1a::of(&broken[..end]).to_le_bytes();
            broken[end..].copy_from_slice(&sum);
            if let Ok(state) = tug.of_bytes(&broken) {
                assert_eq!(tug.restore(state), OK);
                tug.step(2.0, 0.1);
                // SAFETY: one pointer.
                let mut state = state;
                unsafe { fmi2::fmi2FreeFMUstate(tug.0, &mut state) };
            }
        }
    }
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

    fn below(&mut self, count: u64) -> u64 {
        self.next() % count
    }

    fn number(&mut self) -> f64 {
        match self.below(8) {
            0 => f64::NAN,
            1 => f64::INFINITY,
            2 => f64::from_bits(self.next()),
            3 => 0.0,
            4 => -1e12,
            _ => 20.0 * (self.next() as f64 / u64::MAX as f64) - 5.0,
        }
    }
}

/// Random calls in random order, among them states from random bytes: nothing crashes or hangs. By default 400
/// sequences; the project requires `FENDERLINE_FMU_SEQUENCES=100000`.
#[test]
fn any_calls_in_any_order() {
    let sequences = std::env::var("FENDERLINE_FMU_SEQUENCES")
        .map_or(400, |text| text.parse().expect("a number of sequences"));
    let fmus = KINDS.map(|(kind, _, name)| Unpacked::new(kind, &format!("any-{name}")));
    let mut random = Random(20_261_121);
    let log = Messages::default();
    for _ in 0..sequences {
        let fmu = &fmus[random.below(2) as usize];
        let tug = fmu.two(&log);
        let count = fmu.plan.table.variables.len() as u64 + 2;
        let (mut t_s, mut states) = (0.0, Vec::<*mut c_void>::new());
        // Half of the sequences reach the stepping phase.
        if random.below(2) == 0 {
            tug.set_up(0.0, None);
            tug.enter();
            tug.exit();
        }
        for _ in 0..random.below(40) {
            call(&mut random, &tug, count, &mut t_s, &mut states);
        }
        log.last();
    }
}

fn call(random: &mut Random, tug: &Two, count: u64, t_s: &mut f64, states: &mut Vec<*mut c_void>) {
    let reference = random.below(count) as u32;
    let state = match random.below(4) {
        0 => without_provenance_mut(random.next() as usize),
        _ => states.last().copied().unwrap_or_default(),
    };
    match random.below(16) {
        0 => drop(tug.set_up(random.number(), None)),
        1 => drop(tug.enter()),
        2 => drop(tug.exit()),
        3 if random.below(8) == 0 => drop(tug.terminate()),
        4 if random.below(8) == 0 => drop(tug.reset()),
        5 | 6 => drop(tug.set(&[reference], &[random.number()])),
        7 => drop(tug.set_boolean(reference, random.next() as i32)),
        8 => drop(tug.get(&[reference])),
        9 => states.push(tug.save()),
        10 => drop(tug.restore(state)),
        11 => {
            let bytes: Vec<u8> = (0..random.below(200)).map(|_| random.next() as u8).collect();
            assert_eq!(tug.of_bytes(&bytes), Err(ERROR));
        }
        12 if !states.is_empty() => {
            let state = states[random.below(states.len() as u64) as usize];
            // A simulation that failed within a step is not serialised.
            let Some(mut bytes) = tug.try_bytes(state) else { return };
            if random.below(2) == 0 {
                let at = random.below(bytes.len() as u64) as usize;
                bytes[at] ^= random.next() as u8;
            }
            states.extend(tug.of_bytes(&bytes));
        }
        13 => drop(tug.step(random.number(), random.number())),
        _ => {
            if tug.step(*t_s, 0.1) == OK {
                *t_s += 0.1;
            }
        }
    }
}
