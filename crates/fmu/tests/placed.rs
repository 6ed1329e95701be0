//! A master that repositions a ship and says so by increasing the counter.
#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]
#![allow(unsafe_code, reason = "the test acts as a master")]

use crate::support;

use std::ffi::{CString, c_int, c_void};
use std::ptr::{null, null_mut};

use fenderline_fmu::{Kind, fmi2, fmi3};
use support::{ERROR, Messages, OK, Two, Unpacked};

const STEP_S: f64 = 0.1;
/// Her mass in surge, towards the quay, with added mass (kg).
const SURGE_KG: f64 = 930e3 * 1.08;
/// East position where her bow touches the quay (m).
const TOUCH_M: f64 = 4.0;

/// An engine of either version of the standard.
trait Engine {
    fn set(&self, reference: u32, value: f64);
    fn set_integer(&self, reference: u32, value: i32) -> c_int;
    fn get(&self, reference: u32) -> f64;
    fn step(&self, t_s: f64) -> c_int;
}

impl Engine for Two {
    fn set(&self, reference: u32, value: f64) {
        assert_eq!(Two::set(self, &[reference], &[value]), OK);
    }

    fn set_integer(&self, reference: u32, value: i32) -> c_int {
        // SAFETY: one reference and one value.
        unsafe { fmi2::fmi2SetInteger(self.0, &reference, 1, &value) }
    }

    fn get(&self, reference: u32) -> f64 {
        Two::get(self, &[reference]).expect("it is there")[0]
    }

    fn step(&self, t_s: f64) -> c_int {
        Two::step(self, t_s, STEP_S)
    }
}

/// An instance of FMI 3.0.
struct Three(*mut c_void);

impl Three {
    fn new(fmu: &Unpacked) -> Three {
        let path = CString::new(fmu.uri().to_str().expect("text")[7..].to_owned());
        let (path, token) = (path.expect("no NUL"), fmu.token());
        let (token, path, name) = (token.as_ptr(), path.as_ptr(), c"tug".as_ptr());
        let none = null_mut();
        // SAFETY: texts live during the call.
        Three(unsafe {
            fmi3::fmi3InstantiateCoSimulation(
                name,
                token,
                path,
                0,
                0,
                0,
                0,
                null(),
                0,
                none,
                None,
                None,
            )
        })
    }

    fn initialized(self) -> Three {
        // SAFETY: a valid instance.
        unsafe {
            assert_eq!(fmi3::fmi3EnterInitializationMode(self.0, 0, 0.0, 0.0, 0, 0.0), OK);
            assert_eq!(fmi3::fmi3ExitInitializationMode(self.0), OK);
        }
        self
    }
}

// SAFETY of all below: one reference and one value.
impl Engine for Three {
    fn set(&self, reference: u32, value: f64) {
        assert_eq!(unsafe { fmi3::fmi3SetFloat64(self.0, &reference, 1, &value, 1) }, OK);
    }

    fn set_integer(&self, reference: u32, value: i32) -> c_int {
        unsafe { fmi3::fmi3SetInt32(self.0, &reference, 1, &value, 1) }
    }

    fn get(&self, reference: u32) -> f64 {
        let mut value = 0.0;
        assert_eq!(unsafe { fmi3::fmi3GetFloat64(self.0, &reference, 1, &mut value, 1) }, OK);
        value
    }

    fn step(&self, t_s: f64) -> c_int {
        let [mut one, mut two, mut three] = [0; 3];
        let mut time_s = 0.0;
        unsafe {
            fmi3::fmi3DoStep(self.0, t_s, STEP_S, 0, &mut one, &mut two, &mut three, &mut time_s)
        }
    }
}

impl Drop for Three {
    fn drop(&mut self) {
        unsafe { fmi3::fmi3FreeInstance(self.0) };
    }
}

/// A master that moves its tug by forward Euler and passes her state one step late.
struct Master<'e, E> {
    engine: &'e E,
    references: [u32; 4],
    east_m: f64,
    east_mps: f64,
    input: [f64; 2],
    steps: u32,
}

impl<'e, E: Engine> Master<'e, E> {
    fn new(fmu: &Unpacked, engine: &'e E, east_m: f64, east_mps: f64) -> Master<'e, E> {
        let references = ["y_m", "velocity_y_mps", "force_y_n", "reposition_count"]
            .map(|field| reference(fmu, field));
        let input = [east_m, east_mps];
        Master { engine, references, east_m, east_mps, input, steps: 0 }
    }

    /// Takes a step and returns the force on her.
    fn step(&mut self) -> f64 {
        let [y, v, force, _] = self.references;
        self.engine.set(y, self.input[0]);
        self.engine.set(v, self.input[1]);
        assert_eq!(self.engine.step(STEP_S * f64::from(self.steps)), OK);
        self.steps += 1;
        // The force is for the step after that of the states.
        self.input = [self.east_m, self.east_mps];
        let force_n = self.engine.get(force);
        self.east_m += self.east_mps * STEP_S;
        self.east_mps += force_n / SURGE_KG * STEP_S;
        force_n
    }

    /// Moves her ahead, then repositions her in the quay, at rest: the largest force and the highest speed from then on.
    fn reposition(&mut self, count: Option<i32>) -> [f64; 2] {
        for _ in 0..20 {
            self.step();
        }
        (self.east_m, self.east_mps) = (TOUCH_M + 1.0, 0.0);
        let (mut largest_n, mut fastest_mps) = (0.0_f64, 0.0_f64);
        for k in 0..300 {
            // From this step on the input states are those of the new position.
            if let (1, Some(count)) = (k, count) {
                assert_eq!(self.engine.set_integer(self.references[3], count), OK);
            }
            largest_n = largest_n.max(self.step().abs());
            fastest_mps = fastest_mps.max(self.east_mps.abs());
        }
        [largest_n, fastest_mps]
    }
}

fn reference(fmu: &Unpacked, field: &str) -> u32 {
    fmu.reference(&format!("body.tug.{field}"))
}

const BEGIN_M: f64 = TOUCH_M - 1.5;

#[test]
fn a_repositioned_ship_is_pressed_out_slowly_in_both_versions() {
    let fmu = Unpacked::new(Kind::Engine, "placed");
    let log = Messages::default();
    let two = fmu.two(&log).initialized();
    let [largest_n, fastest_mps] = Master::new(&fmu, &two, BEGIN_M, 0.5).reposition(Some(1));
    assert!(largest_n < 0.021 * SURGE_KG, "{largest_n} N");
    assert!(fastest_mps < 0.081, "{fastest_mps} m/s");
    let three = Three::new(&fmu).initialized();
    let of_three = Master::new(&fmu, &three, BEGIN_M, 0.5).reposition(Some(1));
    assert_eq!(of_three, [largest_n, fastest_mps]);
    // If the counter stays, a move this short could be her own motion: her loss of speed is taken for a load.
    let unmarked = fmu.two(&log).initialized();
    let [unmarked_n, _] = Master::new(&fmu, &unmarked, BEGIN_M, 0.5).reposition(None);
    assert!(unmarked_n > 10.0 * largest_n, "{unmarked_n} N");
}

/// A restored state applies a counter that was set before the save but not stepped, and does not apply one twice.
#[test]
fn a_saved_state_includes_the_repositioning_counter() {
    let fmu = Unpacked::new(Kind::Engine, "counted");
    let log = Messages::default();
    let two = fmu.two(&log).initialized();
    let [y, v, force, placed] = ["y_m", "velocity_y_mps", "force_y_n", "reposition_count"]
        .map(|field| reference(&fmu, field));
    let play = |tug: &Two, from: u32| -> Vec<u64> {
        (from..from + 12)
            .map(|step| {
                Engine::set(tug, y, TOUCH_M + 0.02 * f64::from(step));
                assert_eq!(Engine::step(tug, STEP_S * f64::from(step)), OK);
                Engine::get(tug, force).to_bits()
            })
            .collect()
    };
    Engine::set(&two, v, 0.2);
    play(&two, 0);
    let without = two.save();
    let not_placed = play(&two, 12);
    // Set, and not stepped yet.
    assert_eq!(two.restore(without), OK);
    assert_eq!(two.set_integer(placed, 7), OK);
    let set = two.save();
    let bytes = two.bytes(set);
    let after_move = play(&two, 12);
    assert_ne!(after_move, not_placed);
    let taken = two.save();
    let after = play(&two, 24);
    for (state, from, right) in
        [(set, 12, &after_move), (taken, 24, &after), (without, 12, &not_placed)]
    {
        assert_eq!(two.restore(state), OK);
        assert_eq!(&play(&two, from), right);
    }
    let other = fmu.two(&log);
    let state = other.of_bytes(&bytes).expect("good bytes");
    assert_eq!(other.restore(state), OK);
    assert_eq!(play(&other, 12), after_move);
    // A refused step changes nothing.
    assert_eq!(two.restore(set), OK);
    assert_eq!(two.set(&[y], &[1e300]), OK);
    assert_eq!(Engine::step(&two, STEP_S * 12.0), ERROR);
    assert_eq!(play(&two, 12), after_move);
    // A negative counter is refused.
    assert_eq!(two.set_integer(placed, -1), ERROR);
    assert!(log.last().contains("body.tug.reposition_count"));
}

/// The peak of an impact within one step, beside the mean that moves her.
#[test]
fn the_peak_within_a_step_is_reported_beside_the_mean() {
    let fmu = Unpacked::new(Kind::Engine, "peaks");
    let log = Messages::default();
    let tug = fmu.two(&log);
    assert_eq!(tug.set_boolean(fmu.reference("host.following"), 0), OK);
    let tug = tug.initialized();
    let [mean, peak] = ["force_y_n", "peak_force_y_n"].map(|field| reference(&fmu, field));
    let of_pair = fmu.reference("pair.quay-tug.peak_normal_force_n");
    // 0.5 m off at 1 m/s, for 4 s.
    assert_eq!(tug.step(0.0, 4.0), OK);
    let [mean_n, peak_n, of_pair_n] = [mean, peak, of_pair].map(|n| Engine::get(&tug, n));
    assert!((-3.2e5..-2.2e5).contains(&mean_n), "{mean_n} N");
    assert!((-3.0e6..-2.0e6).contains(&peak_n), "{peak_n} N");
    assert!((of_pair_n / -peak_n - 1.0).abs() < 1e-6, "{of_pair_n} N");
}
