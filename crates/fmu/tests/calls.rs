//! Mistakes of masters: each gives an error with a message and changes nothing.
#![allow(unsafe_code, reason = "the test acts as a master")]

use crate::support;

use std::ffi::{c_int, c_void};
use std::ptr::{null, null_mut, without_provenance_mut};

use fenderline_fmu::{Kind, fmi2, fmi3};
use support::{DISCARD, ERROR, Messages, OK, Unpacked};

#[test]
fn calls_out_of_order_are_errors() {
    let fmu = Unpacked::new(Kind::Engine, "order");
    let log = Messages::default();
    let tug = fmu.two(&log);
    let refused = |status: c_int, text: &str| {
        let message = log.last();
        assert_eq!(status, ERROR, "{text}");
        assert!(message.contains(text), "{message}");
    };
    refused(tug.step(0.0, 0.1), "was not initialized");
    refused(tug.exit(), "was not initialized");
    refused(tug.terminate(), "was not initialized");
    refused(tug.set_up(f64::NAN, None), "not a valid experiment");
    refused(tug.set_up(1.0, Some(0.5)), "not a valid experiment");
    assert_eq!(tug.set_up(0.0, Some(1.0)), OK);
    assert_eq!(tug.enter(), OK);
    refused(tug.enter(), "is in initialization mode");
    refused(tug.set_up(0.0, None), "is in initialization mode");
    refused(tug.step(0.0, 0.1), "is in initialization mode");
    assert_eq!(tug.exit(), OK);
    refused(tug.exit(), "was initialized");
    let restitution = fmu.reference("material.rubber.restitution");
    refused(tug.set(&[restitution], &[0.2]), "`material.rubber.restitution`: the instance was");
    assert_eq!(tug.step(0.0, 0.1), OK);
    refused(tug.step(0.0, 0.1), "goes back");
    refused(tug.step(0.3, 0.1), "leaves a gap");
    assert_eq!(tug.step(0.1, 0.0), OK, "a pause");
    for step_s in [-0.1, f64::NAN, f64::INFINITY] {
        refused(tug.step(0.1, step_s), "is not valid");
    }
    refused(tug.step(f64::NAN, 0.1), "is not valid");
    refused(tug.step(0.1, 1.0), "beyond the stop time");
    // Masters round time to nanoseconds, or sum up steps.
    assert_eq!(tug.step(0.1 + 4e-10, 0.1), OK);
    assert_eq!(tug.terminate(), OK);
    refused(tug.step(0.2, 0.1), "was terminated");
    assert_eq!(tug.reset(), OK);
    assert_eq!(tug.set_up(0.0, None), OK);
}

#[test]
fn bad_parameters_are_errors_at_the_end_of_initialization() {
    let fmu = Unpacked::new(Kind::Engine, "parameters");
    let log = Messages::default();
    let tug = fmu.two(&log);
    let [mass, own, added] = ["mass_kg", "yaw_inertia_kgm2", "added_yaw_kgm2"]
        .map(|field| fmu.reference(&format!("body.tug.{field}")));
    assert_eq!(tug.set(&[mass], &[-1.0]), ERROR);
    let before = tug.get(&[own, added]).expect("they are there");
    assert_eq!(tug.set(&[own, added], &[0.0, 0.0]), OK);
    assert_eq!(tug.set_up(0.0, None), OK);
    assert_eq!(tug.enter(), OK);
    assert_eq!(tug.exit(), ERROR);
    assert!(log.last().contains("tug"), "the body is named");
    assert_eq!(tug.set(&[own, added], &before), OK);
    assert_eq!(tug.exit(), OK);
}

#[test]
fn invalid_values_are_refused() {
    let fmu = Unpacked::new(Kind::Engine, "values");
    let log = Messages::default();
    let tug = fmu.two(&log).initialized();
    let [x, y] = ["body.tug.x_m", "body.tug.y_m"].map(|name| fmu.reference(name));
    let before = tug.get(&[x, y]).expect("they are there");
    assert_eq!(before, [3.0, 3.5]);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(tug.set(&[x, y], &[1.0, bad]), ERROR);
        assert!(log.last().contains("`body.tug.y_m` cannot be"));
        assert_eq!(tug.get(&[x, y]).as_deref(), Ok(&*before), "all or none");
    }
    let load = fmu.reference("body.tug.load_x_n");
    assert_eq!(tug.set(&[load], &[1e16]), ERROR);
    assert_eq!(tug.set(&[9999], &[0.0]), ERROR);
    assert!(log.last().contains("9999"));
    let force = fmu.reference("body.tug.force_x_n");
    assert_eq!(tug.set(&[force], &[0.0]), ERROR, "an output");
    assert_eq!(tug.set(&[0], &[0.0]), ERROR, "time");
    let following = fmu.reference("host.following");
    assert_eq!(tug.get(&[following]), Err(ERROR), "it is not a real");
    assert_eq!(tug.get(&[u32::MAX]), Err(ERROR));
    // An impossible state is refused by the step that uses it, and the body is named.
    assert_eq!(tug.step(0.0, 0.1), OK);
    assert_eq!(tug.set(&[x], &[1e300]), OK);
    assert_eq!(tug.step(0.1, 0.1), ERROR);
    assert!(log.last().contains("tug"));
    assert_eq!(tug.set(&[x], &[3.0]), OK);
    assert_eq!(tug.step(0.1, 0.1), OK);
}

#[test]
fn invalid_pointers_and_handles_are_refused() {
    let fmu = Unpacked::new(Kind::Engine, "pointers");
    let log = Messages::default();
    let tug = fmu.two(&log).initialized();
    let x = [fmu.reference("body.tug.x_m")];
    let mut value = [0.0];
    // SAFETY: NULL and misaligned pointers are refused before they are used.
    unsafe {
        assert_eq!(fmi2::fmi2GetReal(tug.0, null(), 1, value.as_mut_ptr()), ERROR);
        assert_eq!(fmi2::fmi2GetReal(tug.0, x.as_ptr(), 1, null_mut()), ERROR);
        assert_eq!(fmi2::fmi2GetReal(tug.0, x.as_ptr(), usize::MAX, value.as_mut_ptr()), ERROR);
        assert_eq!(fmi2::fmi2GetReal(tug.0, null(), 0, null_mut()), OK);
        assert_eq!(fmi2::fmi2SetReal(tug.0, x.as_ptr(), 1, null()), ERROR);
        assert_eq!(fmi2::fmi2SetReal(tug.0, without_provenance_mut(1), 1, value.as_ptr()), ERROR);
        assert_eq!(fmi2::fmi2GetString(tug.0, x.as_ptr(), 1, null_mut()), ERROR);
        assert_eq!(fmi2::fmi2GetFMUstate(tug.0, null_mut()), ERROR);
        assert_eq!(fmi2::fmi2SetFMUstate(tug.0, null_mut()), ERROR);
        assert_eq!(fmi2::fmi2SetFMUstate(tug.0, without_provenance_mut(0xdead_beef)), ERROR);
        assert_eq!(fmi2::fmi2DeSerializeFMUstate(tug.0, null(), 5, &mut null_mut()), ERROR);
        assert_eq!(fmi2::fmi2CancelStep(tug.0), ERROR);
        assert_eq!(fmi2::fmi2GetRealStatus(tug.0, 2, value.as_mut_ptr()), OK);
        assert_eq!(fmi2::fmi2GetRealStatus(tug.0, 2, null_mut()), ERROR);
        assert_eq!(fmi2::fmi2GetStringStatus(tug.0, 1, null_mut()), ERROR);
        assert_eq!(fmi2::fmi2GetRealStatus(tug.0, 77, value.as_mut_ptr()), DISCARD);
        // Components that do not exist, and one that was freed.
        for component in [null_mut(), without_provenance_mut::<c_void>(7), (&raw mut value).cast()]
        {
            assert_eq!(fmi2::fmi2DoStep(component, 0.0, 0.1, 0), ERROR);
            fmi2::fmi2FreeInstance(component);
        }
        let other = fmu.two(&log);
        let freed = other.0;
        drop(other);
        assert_eq!(fmi2::fmi2DoStep(freed, 0.0, 0.1, 0), ERROR);
        fmi2::fmi2FreeInstance(freed);
    }
    assert_eq!(tug.step(0.0, 0.1), OK, "the instance still works");
}

#[test]
fn invalid_arguments_make_no_instance() {
    let fmu = Unpacked::new(Kind::Engine, "instances");
    let log = Messages::default();
    let callbacks = log.callbacks();
    let (uri, token) = (fmu.uri(), fmu.token());
    let (name, none) = (c"tug".as_ptr(), null());
    // SAFETY: texts live during the calls; NULL is refused.
    unsafe {
        let make = |kind, token, uri, callbacks| {
            fmi2::fmi2Instantiate(name, kind, token, uri, callbacks, 0, 0)
        };
        assert!(make(0, token.as_ptr(), uri.as_ptr(), &callbacks).is_null());
        assert!(log.last().contains("co-simulation only"));
        assert!(make(1, c"{other}".as_ptr(), uri.as_ptr(), &callbacks).is_null());
        assert!(log.last().contains("do not belong together"));
        assert!(make(1, token.as_ptr(), c"file:///nowhere".as_ptr(), &callbacks).is_null());
        assert!(log.last().contains("scenario.json"));
        assert!(make(1, token.as_ptr(), c"nonsense".as_ptr(), &callbacks).is_null());
        assert!(make(1, none, uri.as_ptr(), &callbacks).is_null());
        assert!(make(1, token.as_ptr(), none, &callbacks).is_null());
        assert!(make(1, token.as_ptr(), uri.as_ptr(), null()).is_null());
        assert!(make(1, c"\xff".as_ptr(), uri.as_ptr(), &callbacks).is_null());
        let no_logger = fmi2::Callbacks { logger: None, ..callbacks };
        let quiet = make(1, token.as_ptr(), uri.as_ptr(), &no_logger);
        assert!(!quiet.is_null());
        assert_eq!(fmi2::fmi2DoStep(quiet, 0.0, 0.1, 0), ERROR, "there is no logger");
        fmi2::fmi2FreeInstance(quiet);
    }
}

#[test]
fn instances_in_several_threads_are_independent() {
    let fmu = Unpacked::new(Kind::Simulation, "threads");
    let y = fmu.reference("body.tug.y_m");
    let push = fmu.reference("body.tug.external_y_n");
    let play = |force_n: f64| {
        let log = Messages::default();
        let tug = fmu.two(&log).initialized();
        assert_eq!(tug.set(&[push], &[force_n]), OK);
        for step in 0..100 {
            assert_eq!(tug.step(0.1 * f64::from(step), 0.1), OK);
        }
        tug.get(&[y]).expect("it is there")[0].to_bits()
    };
    let alone: Vec<u64> = (0..8).map(|n| play(-1e4 * f64::from(n))).collect();
    let play = &play;
    let together: Vec<u64> = std::thread::scope(|scope| {
        let all: Vec<_> = (0..8).map(|n| scope.spawn(move || play(-1e4 * f64::from(n)))).collect();
        all.into_iter().map(|one| one.join().expect("no panic")).collect()
    });
    assert_eq!(alone, together);
    assert_eq!(alone.iter().collect::<std::collections::BTreeSet<_>>().len(), 8);
}

#[test]
fn fmi_3_refuses_the_same_mistakes() {
    let fmu = Unpacked::new(Kind::Simulation, "three");
    let path = std::ffi::CString::new(fmu.uri().to_str().expect("text")[7..].to_owned());
    let (path, token) = (path.expect("no NUL"), fmu.token());
    let x = [fmu.reference("body.tug.x_m")];
    let mut values = [0.0, 0.0];
    let (mut flags, mut time_s) = ([7_u8; 3], 0.0);
    // SAFETY: arrays have the given length; NULL is refused.
    unsafe {
        let make = |event_mode| {
            let (token, path) = (token.as_ptr(), path.as_ptr());
            let name = c"tug".as_ptr();
            fmi3::fmi3InstantiateCoSimulation(
                name,
                token,
                path,
                0,
                0,
                event_mode,
                0,
                null(),
                0,
                null_mut(),
                None,
                None,
            )
        };
        assert!(make(1).is_null());
        let tug = make(0);
        assert!(!tug.is_null());
        let [one, two, three] = flags.each_mut().map(std::ptr::from_mut);
        let step = |t_s, time| fmi3::fmi3DoStep(tug, t_s, 0.1, 0, one, two, three, time);
        assert_eq!(step(0.0, &mut time_s), ERROR);
        assert_eq!(fmi3::fmi3EnterInitializationMode(tug, 0, 0.0, f64::NAN, 0, 0.0), ERROR);
        assert_eq!(fmi3::fmi3EnterInitializationMode(tug, 0, 0.0, 0.0, 0, 0.0), OK);
        assert_eq!(fmi3::fmi3ExitInitializationMode(tug), OK);
        assert_eq!(step(0.0, null_mut()), ERROR, "no pointer for the time");
        assert_eq!(step(0.0, &mut time_s), OK);
        assert_eq!((flags, time_s), ([0; 3], 0.1));
        let get =
            |count, into: *mut f64, room| fmi3::fmi3GetFloat64(tug, x.as_ptr(), count, into, room);
        assert_eq!(get(1, values.as_mut_ptr(), 2), ERROR, "two values of one variable");
        assert_eq!(get(1, values.as_mut_ptr(), 1), OK);
        assert_eq!(fmi3::fmi3GetFloat32(tug, x.as_ptr(), 1, null_mut(), 1), ERROR);
        assert_eq!(fmi3::fmi3GetClock(tug, x.as_ptr(), 1, null_mut()), ERROR);
        assert_eq!(fmi3::fmi3EnterEventMode(tug), ERROR);
        assert_eq!(fmi3::fmi3SetTime(tug, 0.0), ERROR);
        fmi3::fmi3FreeInstance(tug);
        assert_eq!(fmi3::fmi3Reset(tug), ERROR, "it was freed");
    }
}
