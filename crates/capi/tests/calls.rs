//! The interface as a C program uses it: statuses and texts, several engines at once, destroyed handles.
#![allow(unsafe_code, reason = "the calls are those of a C program")]

use std::ptr;
use std::thread;

use fenderline::*;

const TUG: &str =
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/paper/experiment_2_4kn.toml");
const STEP_S: f64 = 0.1;

/// A handle that may be used from any thread, as the header states.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
struct Engine(*mut FlEngine);

// SAFETY: a handle is a number; the library locks its object.
unsafe impl Send for Engine {}

impl Engine {
    fn new(overrides: &str, settings: Option<&FlSettings>) -> Engine {
        let mut engine = ptr::null_mut();
        let settings = settings.map_or(ptr::null(), ptr::from_ref);
        let (path, more) = (TUG.as_ptr().cast(), overrides.as_ptr().cast());
        // SAFETY: texts with their lengths, settings or NULL, room for a handle.
        let status = unsafe {
            fl_engine_from_file(path, TUG.len(), more, overrides.len(), settings, &mut engine)
        };
        assert_eq!(status, FlStatus::Ok, "{}", last_error());
        Engine(engine)
    }

    fn begin(self) -> [FlState; 2] {
        let mut states = [FlState::default(); 2];
        // SAFETY: room for two.
        let status = unsafe { fl_engine_initial_states(self.0, states.as_mut_ptr(), 2) };
        assert_eq!(status, FlStatus::Ok);
        states
    }

    fn set(self, states: &[FlState]) -> FlStatus {
        // SAFETY: the array has this length.
        unsafe { fl_engine_set_states(self.0, states.as_ptr(), states.len()) }
    }

    fn wrenches(self) -> (FlStatus, [FlWrench; 2]) {
        let mut wrenches = [FlWrench::default(); 2];
        // SAFETY: room for two.
        let status = unsafe { fl_engine_wrenches(self.0, wrenches.as_mut_ptr(), 2) };
        (status, wrenches)
    }

    /// The kinds of the last step's events.
    fn events(self) -> Vec<u32> {
        let mut count = 0;
        // SAFETY: room for a count.
        assert_eq!(unsafe { fl_engine_event_count(self.0, &mut count) }, FlStatus::Ok);
        let kind = |index| {
            let mut event = FlEvent { size: size_of::<FlEvent>(), ..FlEvent::default() };
            // SAFETY: room for an event.
            assert_eq!(unsafe { fl_engine_event(self.0, index, &mut event) }, FlStatus::Ok);
            event.kind
        };
        (0..count as u32).map(kind).collect()
    }

    fn error(self) -> String {
        // SAFETY: the buffer has the given capacity.
        text(|buffer, capacity| unsafe {
            fl_engine_error(self.0, buffer, capacity, ptr::null_mut())
        })
    }

    /// The forces on the tug while the engine moves the bodies, as bits.
    fn run(self, steps: usize) -> Vec<u64> {
        let mut states = self.begin();
        let mut forces = Vec::new();
        for _ in 0..steps {
            assert_eq!(self.set(&states), FlStatus::Ok);
            assert_eq!(fl_engine_step(self.0, STEP_S), FlStatus::Ok);
            // SAFETY: room for two.
            let moved = unsafe { fl_engine_states_after(self.0, states.as_mut_ptr(), 2) };
            assert_eq!(moved, FlStatus::Ok);
            forces.push(self.wrenches().1[1].east_n.to_bits());
        }
        assert!(forces.iter().any(|bits| f64::from_bits(*bits) < -1e6));
        forces
    }

    fn destroy(self) -> FlStatus {
        fl_engine_destroy(self.0)
    }
}

fn text(copy: impl FnOnce(*mut core::ffi::c_char, usize) -> FlStatus) -> String {
    let mut buffer = [0_u8; 1000];
    assert_eq!(copy(buffer.as_mut_ptr().cast(), buffer.len()), FlStatus::Ok);
    let text = core::ffi::CStr::from_bytes_until_nul(&buffer).expect("a NUL");
    text.to_str().expect("UTF-8").to_owned()
}

fn last_error() -> String {
    // SAFETY: the buffer has the given capacity.
    text(|buffer, capacity| unsafe { fl_last_error(buffer, capacity, ptr::null_mut()) })
}

const COUPLED: &str = "contact.method=coupled\ntime.integrator=semi_implicit";

#[test]
fn engines_in_several_threads_give_the_bits_of_one_alone() {
    let alone = Engine::new(COUPLED, None);
    let forces = alone.run(40);
    assert_eq!(fl_engine_reset(alone.0), FlStatus::Ok);
    let others: Vec<_> = (0..4)
        .map(|_| {
            thread::spawn(|| {
                let engine = Engine::new(COUPLED, None);
                let forces = engine.run(40);
                assert_eq!(engine.destroy(), FlStatus::Ok);
                forces
            })
        })
        .collect();
    assert_eq!(alone.run(40), forces);
    for other in others {
        assert_eq!(other.join().expect("no panic"), forces);
    }
    assert_eq!(alone.destroy(), FlStatus::Ok);
}

#[test]
fn an_engine_may_be_destroyed_while_another_thread_steps_it() {
    let engine = Engine::new(COUPLED, None);
    let states = engine.begin();
    assert_eq!(engine.set(&states), FlStatus::Ok);
    let stepping = thread::spawn(move || {
        let engine = engine;
        let mut steps = 0_u64;
        loop {
            match fl_engine_step(engine.0, 1e-3) {
                FlStatus::Ok => steps += 1,
                FlStatus::BadHandle => return steps,
                other => panic!("{other:?}"),
            }
        }
    });
    thread::sleep(std::time::Duration::from_millis(20));
    assert_eq!(engine.destroy(), FlStatus::Ok);
    assert!(stepping.join().expect("no panic") > 0);
    assert_eq!(engine.destroy(), FlStatus::BadHandle);
}

#[test]
fn calls_out_of_order_have_their_status() {
    let engine = Engine::new(COUPLED, None);
    assert_eq!(engine.wrenches().0, FlStatus::OutOfOrder);
    assert_eq!(fl_engine_step(engine.0, STEP_S), FlStatus::OutOfOrder);
    assert_eq!(engine.error(), "the host has not set the state of body `ship`, which floats");
    let states = engine.begin();
    assert_eq!(engine.set(&states[1..]), FlStatus::BadArgument);
    assert_eq!(engine.set(&states), FlStatus::Ok);
    assert_eq!(fl_engine_step(engine.0, -0.1), FlStatus::BadNumber);
    assert_eq!(engine.wrenches().0, FlStatus::OutOfOrder);
    assert_eq!(fl_engine_step(engine.0, STEP_S), FlStatus::Ok);
    assert_eq!(engine.wrenches().0, FlStatus::Ok);
    assert_eq!(engine.destroy(), FlStatus::Ok);
}

/// A pause was refused; and there was no call to mark a teleport.
#[test]
fn a_pause_is_allowed_and_a_body_can_be_marked_as_teleported() {
    let engine = Engine::new(COUPLED, None);
    let mut states = engine.begin();
    assert_eq!(fl_engine_mark_teleported(engine.0, 2), FlStatus::NoSuch);
    // 1 m is less than a tenth of the tug's radius of 16 m: a teleport only if it is marked.
    for (moved_m, marked, teleported) in [(0.0, false, 0), (1.0, false, 0), (1.0, true, 1)] {
        states[1].east_m += moved_m;
        if marked {
            assert_eq!(fl_engine_mark_teleported(engine.0, 1), FlStatus::Ok);
        }
        assert_eq!(engine.set(&states), FlStatus::Ok);
        assert_eq!(fl_engine_step(engine.0, 0.0), FlStatus::Ok, "a pause");
        assert_eq!(engine.events().len(), 0);
        assert_eq!(fl_engine_step(engine.0, STEP_S), FlStatus::Ok);
        let kinds = engine.events();
        let count = kinds.iter().filter(|kind| **kind == FL_EVENT_TELEPORTED).count();
        assert_eq!(count, teleported, "{moved_m} m, {marked}");
    }
    assert_eq!(engine.destroy(), FlStatus::Ok);
}

#[test]
fn a_non_finite_number_names_body_and_field_and_each_engine_keeps_its_own_message() {
    let (one, two) = (Engine::new(COUPLED, None), Engine::new("", None));
    let mut states = one.begin();
    states[1].north_mps = f64::NAN;
    assert_eq!(one.set(&states), FlStatus::BadNumber);
    assert_eq!(one.error(), "north velocity of body `tug` is NaN");
    assert_eq!(last_error(), one.error());
    assert_eq!(two.error(), "");
    let none = [FlWrench::default(); 2];
    // SAFETY: two of them.
    let status = unsafe { fl_engine_set_loads(two.0, none.as_ptr(), 2) };
    assert_eq!(status, FlStatus::NotAvailable);
    assert_eq!(two.error(), "the paper's method has no loads");
    assert_eq!(one.error(), "north velocity of body `tug` is NaN");
    assert_eq!((one.destroy(), two.destroy()), (FlStatus::Ok, FlStatus::Ok));
}

#[test]
fn a_mistake_in_a_scenario_gives_its_place_and_no_handle() {
    let mut engine = ptr::without_provenance_mut(1);
    let text = "[body.tug]\nmas = 3\n";
    // SAFETY: a text with its length, room for a handle.
    let status = unsafe {
        fl_engine_from_text(
            text.as_ptr().cast(),
            text.len(),
            ptr::null(),
            0,
            ptr::null(),
            &mut engine,
        )
    };
    assert_eq!((status, engine), (FlStatus::BadScenario, ptr::null_mut()));
    assert!(last_error().contains("--> scenario:2:1"), "{}", last_error());
}

#[test]
fn settings_of_another_size_and_settings_without_effect_are_refused() {
    let mut engine = ptr::null_mut();
    let mut refused = |settings: FlSettings| {
        let path = TUG.as_ptr().cast();
        // SAFETY: a text with its length, settings, room for a handle.
        unsafe { fl_engine_from_file(path, TUG.len(), ptr::null(), 0, &settings, &mut engine) }
    };
    let good = FlSettings { size: size_of::<FlSettings>(), ..FlSettings::default() };
    assert_eq!(refused(FlSettings { size: 8, ..good }), FlStatus::BadSize);
    assert_eq!(refused(FlSettings { delay_steps: 1, ..good }), FlStatus::BadArgument);
    assert_eq!(refused(FlSettings { method: 9, ..good }), FlStatus::BadArgument);
    let co_simulation = FlSettings { host: FL_HOST_COSIMULATION, ..good };
    // The scenario's method is the paper's.
    assert_eq!(refused(co_simulation), FlStatus::BadArgument);
    let coupled = FlSettings { method: FL_METHOD_COUPLED, ..co_simulation };
    assert_eq!(refused(coupled), FlStatus::Ok);
    assert_eq!(fl_engine_destroy(engine), FlStatus::Ok);
}

/// An impact within one step of 4 s: the wrench is the mean, and the peak is reported beside it.
#[test]
fn peak_wrenches_are_reported_beside_the_means() {
    let engine = Engine::new(COUPLED, None);
    let mut peaks = [FlWrench::default(); 2];
    // SAFETY: room for two.
    let read_peaks = |peaks: &mut [FlWrench]| unsafe {
        fl_engine_peak_wrenches(engine.0, peaks.as_mut_ptr(), peaks.len())
    };
    assert_eq!(read_peaks(&mut peaks), FlStatus::OutOfOrder);
    let mut states = engine.begin();
    states[1].east_m += 1.0;
    assert_eq!(engine.set(&states), FlStatus::Ok);
    assert_eq!(fl_engine_step(engine.0, 4.0), FlStatus::Ok);
    assert_eq!(read_peaks(&mut peaks), FlStatus::Ok);
    let (_, wrenches) = engine.wrenches();
    assert!(peaks[1].east_n < 3.0 * wrenches[1].east_n, "{peaks:?}, {wrenches:?}");
    assert!((peaks[0].east_n / -peaks[1].east_n - 1.0).abs() < 1e-9, "{peaks:?}");
    assert_eq!(read_peaks(&mut peaks[..1]), FlStatus::BadArgument);
    assert_eq!(engine.destroy(), FlStatus::Ok);
}

fn add_parts(builder: *mut FlBuilder) -> (u32, u32) {
    let (mut rubber, mut quay, mut ship) = (9, 9, 9);
    let material = FlMaterial {
        size: size_of::<FlMaterial>(),
        stiffness_npm2: 5e6,
        shear_stiffness_npm: 3e6,
        friction_static: 0.2,
        friction_dynamic: 0.2,
        ..FlMaterial::default()
    };
    let fixed = FlBody { size: size_of::<FlBody>(), ..FlBody::default() };
    let floating = FlBody { mass_kg: 2e7, yaw_inertia_kgm2: 2e10, east_m: 11.0, ..fixed };
    let wall = [-60.0, -5.0, 60.0, -5.0, 60.0, 0.0, -60.0, 0.0];
    let hull = [-60.0, -10.0, 60.0, -10.0, 60.0, 10.0, -60.0, 10.0];
    let name = |name: &'static core::ffi::CStr| name.as_ptr();
    // SAFETY: NUL-terminated names, structures, arrays of four pairs, room for indices.
    let added = unsafe {
        [
            fl_builder_add_material(builder, name(c"rubber"), FL_NUL, &material, &mut rubber),
            fl_builder_add_body(
                builder,
                name(c"quay"),
                FL_NUL,
                &fixed,
                wall.as_ptr(),
                4,
                &mut quay,
            ),
            fl_builder_add_body(
                builder,
                name(c"ship"),
                FL_NUL,
                &floating,
                hull.as_ptr(),
                4,
                &mut ship,
            ),
            fl_builder_add_pair(builder, quay, ship, rubber),
        ]
    };
    assert_eq!(added, [FlStatus::Ok; 4]);
    (quay, ship)
}

const KEYS: &str =
    "on=quay\nmaterial=rubber\ntype=cone\nsize=1050 F1.1\nposition=[0, 0]\nwidth=2 m";

/// A fender of the catalogue, names in place of indices, and all that is drawn in one call each.
#[test]
fn a_catalogue_fender_is_added_by_keys_and_drawn() {
    let (mut builder, mut engine) = (ptr::null_mut(), ptr::null_mut());
    // SAFETY: room for a handle.
    assert_eq!(unsafe { fl_builder_new(&mut builder) }, FlStatus::Ok);
    let (quay, ship) = add_parts(builder);
    let mut index = 9;
    // SAFETY: texts with their lengths, room for an index.
    let add = |keys: &str, index: &mut u32| unsafe {
        fl_builder_add_fender_by_keys(
            builder,
            c"f1".as_ptr(),
            FL_NUL,
            keys.as_ptr().cast(),
            keys.len(),
            index,
        )
    };
    assert_eq!(add("type=cone", &mut index), FlStatus::BadScenario);
    assert_eq!(add(KEYS.replace("cone", "conne").as_str(), &mut index), FlStatus::BadScenario);
    assert!(last_error().contains("--> type=conne"), "{}", last_error());
    assert_eq!((add(KEYS, &mut index), index), (FlStatus::Ok, 0));
    // SAFETY: NUL-terminated names, room for indices and a handle.
    unsafe {
        assert_eq!(
            fl_builder_find_body(builder, c"ship".as_ptr(), FL_NUL, &mut index),
            FlStatus::Ok
        );
        assert_eq!(index, ship);
        let missing = fl_builder_find_fender(builder, c"ship".as_ptr(), FL_NUL, &mut index);
        assert_eq!(missing, FlStatus::NoSuch);
        assert_eq!(fl_builder_build(builder, ptr::null(), &mut engine), FlStatus::Ok);
    }
    let (mut outline, mut count) = ([0.0; 8], 0);
    let mut views = [FlFenderView::default()];
    let mut contacts = [FlContact::default(); 4];
    let state = FlState { east_m: 11.0, east_mps: -0.1, ..FlState::default() };
    // SAFETY: arrays of the given capacities.
    unsafe {
        let read = fl_engine_outline(engine, ship, outline.as_mut_ptr(), 3, &mut count);
        assert_eq!((read, count, outline), (FlStatus::BufferTooSmall, 4, [0.0; 8]));
        let read = fl_engine_outline(engine, ship, outline.as_mut_ptr(), 4, &mut count);
        assert_eq!((read, outline[..2].to_vec()), (FlStatus::Ok, vec![-60.0, -10.0]));
        assert_eq!(fl_engine_fender_views(engine, views.as_mut_ptr(), 1), FlStatus::Ok);
        assert_eq!((views[0].body, views[0].hull), (quay, FL_NONE));
        assert!((views[0].face_1_starboard_m - 1.05).abs() < 1e-12);
        assert_eq!(fl_engine_fender_views(engine, views.as_mut_ptr(), 2), FlStatus::BadArgument);
        assert_eq!(fl_engine_set_state(engine, ship, &state), FlStatus::Ok);
        assert_eq!(fl_engine_step(engine, 0.1), FlStatus::Ok);
        assert_eq!(fl_engine_fender_views(engine, views.as_mut_ptr(), 1), FlStatus::Ok);
        let size = size_of::<FlContact>();
        let all = fl_engine_contacts(engine, contacts.as_mut_ptr(), size, 4, &mut count);
        assert_eq!((all, count), (FlStatus::Ok, 1));
        assert_eq!(contacts[0].depth_m, views[0].deflection_m);
        assert_eq!(views[0].hull, ship);
        let other = fl_engine_contacts(engine, contacts.as_mut_ptr(), size - 8, 4, &mut count);
        assert_eq!(other, FlStatus::BadSize);
        let none = fl_engine_contacts(engine, contacts.as_mut_ptr(), size, 0, &mut count);
        assert_eq!((none, count), (FlStatus::BufferTooSmall, 1));
        let (size, none) = (size_of::<FlEvent>(), ptr::null_mut());
        assert_eq!(fl_engine_events(engine, none, size, 0, &mut count), FlStatus::Ok);
        assert_eq!(count, 1, "the contact began");
    }
    assert_eq!(fl_engine_destroy(engine), FlStatus::Ok);
    assert_eq!(fl_builder_destroy(builder), FlStatus::Ok);
}

#[test]
fn a_dump_is_replayed_to_the_same_bits() {
    let engine = Engine::new(COUPLED, None);
    let (mut length, mut steps, mut different, mut again) = (0, 0, 9, ptr::null_mut());
    // SAFETY: room for a length.
    let query = |length| unsafe { fl_engine_dump(engine.0, ptr::null_mut(), 0, length) };
    assert_eq!(query(&mut length), FlStatus::OutOfOrder);
    assert_eq!(fl_engine_record(engine.0, 100), FlStatus::Ok);
    engine.run(60);
    assert_eq!(query(&mut length), FlStatus::Ok);
    let mut dump = vec![0; length];
    // SAFETY: room for the dump; the dump with its length, room for counts and a handle.
    unsafe {
        assert_eq!(fl_engine_dump(engine.0, dump.as_mut_ptr(), length, &mut length), FlStatus::Ok);
        let replayed =
            fl_replay_dump(dump.as_ptr(), length, &mut steps, &mut different, &mut again);
        assert_eq!((replayed, steps, different), (FlStatus::Ok, 60, 0));
        assert_eq!(Engine(again).wrenches(), engine.wrenches());
        dump[length / 2] ^= 1;
        let (none, nobody) = (ptr::null_mut(), ptr::null_mut());
        let changed = fl_replay_dump(dump.as_ptr(), length, none, ptr::null_mut(), nobody);
        assert_eq!(changed, FlStatus::BadBytes);
    }
    assert_eq!((engine.destroy(), Engine(again).destroy()), (FlStatus::Ok, FlStatus::Ok));
}

#[test]
fn outlines_are_made_from_points() {
    // A square of 2 m with its centre, and the starboard half of a kite.
    let square = [0.0, 0.0, -1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0];
    let half = [3.0, 0.0, 0.0, 1.0, -1.0, 0.0];
    let (mut outline, mut count) = ([0.0; 8], 0);
    let into = outline.as_mut_ptr();
    // SAFETY: arrays of the given lengths and capacities.
    unsafe {
        assert_eq!(fl_outline_hull(square.as_ptr(), 5, into, 4, &mut count), FlStatus::Ok);
        assert_eq!(count, 4);
        assert_eq!(fl_outline_mirror(half.as_ptr(), 3, 0.0, into, 4, &mut count), FlStatus::Ok);
        assert_eq!((count, outline), (4, [3.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, -1.0]));
        let simplify = fl_outline_simplify(square.as_ptr(), 2, 0.1, into, 4, &mut count);
        assert_eq!(simplify, FlStatus::BadModel);
        assert_eq!(fl_outline_hull(square.as_ptr(), 1, into, 4, &mut count), FlStatus::BadModel);
    }
}
