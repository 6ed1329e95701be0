//! Engines.

use core::ffi::c_char;
use core::ptr;
use std::path::Path;

use fenderline_contact::{BodyState, StepError, Wrench};
use fenderline_embed::{Engine, EngineError, Results, Settings};
use fenderline_scenario::{Override, Scenario, ScenarioError};

use crate::border::{
    LONGEST_NAME, LONGEST_PATH, LONGEST_SCENARIO, bytes, check, check_size, put_bytes, put_text,
    read, read_all, read_sized, text, write, write_all,
};
use crate::failure::{FlStatus, Outcome, failure};
use crate::library::keep_last;
use crate::table::{ENGINES, EngineHeld, FlEngine, no_panic};
use crate::types::{FlContact, FlEvent, FlSettings, FlState, FlWrench};

/// Makes an engine from a scenario file and stores the engine to `*engine`; stores NULL if the file has an error. The
/// program destroys the engine with fl_engine_destroy() when it no longer needs it. Names of files in the scenario are
/// relative to the folder of the scenario file. `overrides` replaces keys of the scenario, with one KEY=VALUE per line,
/// such as "contact.method=coupled"; pass NULL and 0 to replace none. `settings` may be NULL: the engine then has the
/// default settings.
///
/// The engine takes the scenario's bodies, fenders, materials and pairs. All other forces of the scenario, such as loads
/// and wind, are left to the host: see fl_engine_notices().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_from_file(
    path: *const c_char,
    path_length: usize,
    overrides: *const c_char,
    overrides_length: usize,
    settings: *const FlSettings,
    engine: *mut *mut FlEngine,
) -> FlStatus {
    no_panic(|| {
        // SAFETY: as the caller promises.
        unsafe { write(engine, ptr::null_mut(), "engine") }?;
        // SAFETY: as the caller promises.
        let path = unsafe { text(path, path_length, LONGEST_PATH, "path") }?;
        // SAFETY: as the caller promises.
        let overrides = unsafe { text(overrides, overrides_length, LONGEST_PATH, "overrides") }?;
        // SAFETY: as the caller promises.
        let settings = unsafe { settings_of(settings) }?;
        let scenario = Scenario::load(Path::new(&path), &overrides_of(&overrides)?);
        let scenario = scenario.or_else(|error| failure(FlStatus::BadScenario, error))?;
        let made = hold(Engine::from_scenario(scenario, &settings)?)?;
        // SAFETY: as the caller promises.
        unsafe { write(engine, made, "engine") }
    })
}

/// Makes an engine as fl_engine_from_file() does, but from the text of a scenario; the scenario may name no other
/// files.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_from_text(
    scenario: *const c_char,
    scenario_length: usize,
    overrides: *const c_char,
    overrides_length: usize,
    settings: *const FlSettings,
    engine: *mut *mut FlEngine,
) -> FlStatus {
    no_panic(|| {
        // SAFETY: as the caller promises.
        unsafe { write(engine, ptr::null_mut(), "engine") }?;
        // SAFETY: as the caller promises.
        let own = unsafe { text(scenario, scenario_length, LONGEST_SCENARIO, "scenario") }?;
        // SAFETY: as the caller promises.
        let overrides = unsafe { text(overrides, overrides_length, LONGEST_PATH, "overrides") }?;
        // SAFETY: as the caller promises.
        let settings = unsafe { settings_of(settings) }?;
        let scenario = Scenario::parse_with(&own, "scenario", &overrides_of(&overrides)?);
        let scenario = scenario.or_else(bad_scenario)?;
        let made = hold(Engine::from_scenario(scenario, &settings)?)?;
        // SAFETY: as the caller promises.
        unsafe { write(engine, made, "engine") }
    })
}

/// Destroys an engine. Destroying a NULL engine is allowed and does nothing.
#[unsafe(no_mangle)]
pub extern "C" fn fl_engine_destroy(engine: *mut FlEngine) -> FlStatus {
    no_panic(|| if engine.is_null() { Ok(()) } else { ENGINES.remove(engine) })
}

/// Copies the message of the last failed call on this engine, in the way of fl_last_error().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_error(
    engine: *const FlEngine,
    buffer: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> FlStatus {
    keep_last(|_| {
        let own = ENGINES.error(engine)?;
        // SAFETY: as the caller promises.
        unsafe { put_text(&own, buffer, capacity, length) }
    })
}

/// Resets the engine to its start: it forgets its memory of contacts, the states and the loads. After the reset, the
/// next step counts as the first step.
#[unsafe(no_mangle)]
pub extern "C" fn fl_engine_reset(engine: *mut FlEngine) -> FlStatus {
    ENGINES.call(engine, |held| {
        held.engine.reset();
        Ok(())
    })
}

/// Copies the notices about the scenario and the list of the scenario's forces that are left to the host, one per line.
/// The text of the notices may be empty. `length` may be NULL. For the buffer see "Texts" in the preamble of this
/// header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_notices(
    engine: *const FlEngine,
    buffer: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        let notices = held.engine.notices().join("\n");
        // SAFETY: as the caller promises.
        unsafe { put_text(&notices, buffer, capacity, length) }
    })
}

/// Number of bodies. Indices of bodies count from 0, in the order of the scenario or of the calls that built the
/// engine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_body_count(
    engine: *const FlEngine,
    count: *mut usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        // SAFETY: as the caller promises.
        unsafe { write(count, held.engine.model().bodies().len(), "count") }
    })
}

/// Copies the name of a body. `length` may be NULL. For the buffer see "Texts" in the preamble of this header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_body_name(
    engine: *const FlEngine,
    body: u32,
    buffer: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        let body = among("body", held.engine.model().bodies(), body)?;
        // SAFETY: as the caller promises.
        unsafe { put_text(&body.name, buffer, capacity, length) }
    })
}

/// Finds the index of a body by its name.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_find_body(
    engine: *const FlEngine,
    name: *const c_char,
    name_length: usize,
    body: *mut u32,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        // SAFETY: as the caller promises.
        let name = unsafe { text(name, name_length, LONGEST_NAME, "name") }?;
        let index = held.engine.body_named(&name)?;
        // SAFETY: as the caller promises.
        unsafe { write(body, index as u32, "body") }
    })
}

/// Number of fenders. Indices of fenders count from 0, in the order of the scenario or of the calls that built the
/// engine.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_fender_count(
    engine: *const FlEngine,
    count: *mut usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        // SAFETY: as the caller promises.
        unsafe { write(count, held.engine.model().fenders().len(), "count") }
    })
}

/// Copies the name of a fender. `length` may be NULL. For the buffer see "Texts" in the preamble of this header.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_fender_name(
    engine: *const FlEngine,
    fender: u32,
    buffer: *mut c_char,
    capacity: usize,
    length: *mut usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        let fender = among("fender", held.engine.model().fenders(), fender)?;
        // SAFETY: as the caller promises.
        unsafe { put_text(&fender.name, buffer, capacity, length) }
    })
}

/// Finds the index of a fender by its name.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_find_fender(
    engine: *const FlEngine,
    name: *const c_char,
    name_length: usize,
    fender: *mut u32,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        // SAFETY: as the caller promises.
        let name = unsafe { text(name, name_length, LONGEST_NAME, "name") }?;
        let index = held.engine.fender_named(&name)?;
        // SAFETY: as the caller promises.
        unsafe { write(fender, index as u32, "fender") }
    })
}

/// Copies a body's mass matrix over surge, sway and yaw about its centre of gravity, added mass included, row by row: 9
/// numbers (kg, kg m, kg m2); zeros for a fixed body. A co-simulation host must use this mass matrix to move the body.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_mass_matrix(
    engine: *const FlEngine,
    body: u32,
    matrix: *mut f64,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        let body = among("body", held.engine.model().bodies(), body)?;
        let own = body.mobility.matrix().unwrap_or_default();
        // SAFETY: as the caller promises, for 9 numbers.
        unsafe { write_all(matrix, own.as_flattened(), "matrix", |number| number) }
    })
}

/// Copies the initial states of the scenario or the builder; `count` is the number of bodies.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_initial_states(
    engine: *const FlEngine,
    states: *mut FlState,
    count: usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        // SAFETY: as the caller promises.
        unsafe { give(held.engine.initial_states(), states, count, FlState::outward) }
    })
}

/// Sets the state of one body for the next step. Fixed bodies need no state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_set_state(
    engine: *mut FlEngine,
    body: u32,
    state: *const FlState,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        // SAFETY: as the caller promises.
        let state = unsafe { read(state, "state") }?;
        Ok(held.engine.set_state(body as usize, &state.inward())?)
    })
}

/// Sets the states of all bodies for the next step; if one state is refused, no state is set. `count` is the number of
/// bodies.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_set_states(
    engine: *mut FlEngine,
    states: *const FlState,
    count: usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        // SAFETY: as the caller promises.
        unsafe { take_states(held, states, count) }?;
        Ok(held.engine.set_states(&held.states)?)
    })
}

/// Marks the next state of a body as a teleport: the host sets the body to a new place rather than moving it there. The
/// contacts of a teleported body begin anew (FL_EVENT_TELEPORTED), and no load is inferred from its displacement. A
/// teleported body that overlaps another body is pushed out slowly, with FL_EVENT_PLACED_IN_OVERLAP if the overlap is
/// so deep that the contact would eject the body. Without this call the engine detects a teleport only if the body's
/// displacement differs from what the velocities explain by a tenth of the outline's radius. A host whose states are
/// some steps old makes this call when it first passes the new place of the body. To go back in time, restore a saved
/// engine instead of teleporting its bodies.
#[unsafe(no_mangle)]
pub extern "C" fn fl_engine_mark_teleported(engine: *mut FlEngine, body: u32) -> FlStatus {
    ENGINES.call(engine, |held| Ok(held.engine.mark_teleported(body as usize)?))
}

/// Sets the loads, all forces on each body except contact, until the next call; `count` is the number of bodies. NULL
/// with a count of 0 removes the loads, as at the start: a direct host then has no loads, and the loads of a
/// co-simulation host are inferred from its states. The paper's method does not use loads.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_set_loads(
    engine: *mut FlEngine,
    loads: *const FlWrench,
    count: usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        // SAFETY: as the caller promises.
        let has_loads = unsafe { take_loads(held, loads, count) }?;
        Ok(held.engine.set_loads(has_loads.then_some(&held.loads))?)
    })
}

/// Takes a step of `step_s` seconds from the states that were set last. Before a step, all floating bodies must have a
/// state. Consecutive steps may have different lengths. A step of 0 s is a pause: nothing moves, and the results are
/// those of the last step, but without events and without the work of the contacts.
#[unsafe(no_mangle)]
pub extern "C" fn fl_engine_step(engine: *mut FlEngine, step_s: f64) -> FlStatus {
    ENGINES.call(engine, |held| Ok(held.engine.step(step_s)?))
}

/// Does in one call what these do: fl_engine_set_states(), fl_engine_set_loads() if `loads` is not NULL,
/// fl_engine_step() and fl_engine_wrenches(). All arrays of fl_engine_advance() have `count` elements, the number of
/// bodies. If any part of fl_engine_advance() fails, nothing has changed.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_advance(
    engine: *mut FlEngine,
    states: *const FlState,
    loads: *const FlWrench,
    count: usize,
    step_s: f64,
    wrenches: *mut FlWrench,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        // SAFETY: as the caller promises.
        unsafe { take_states(held, states, count) }?;
        let has_loads = !loads.is_null();
        if has_loads {
            // SAFETY: as the caller promises.
            unsafe { take_loads(held, loads, count) }?;
        }
        if count > 0 {
            check(wrenches, "wrenches")?;
        }
        let EngineHeld { engine, states, loads } = held;
        let own = engine.advance(states, has_loads.then_some(loads), step_s)?;
        // SAFETY: as the caller promises.
        unsafe { give(own, wrenches, count, FlWrench::outward) }
    })
}

/// Copies the contact wrenches of the last step, which the host adds to its own forces. The wrenches are means over the
/// step, so that they give the bodies the right impulse; for the largest wrenches see fl_engine_peak_wrenches().
/// `count` is the number of bodies.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_wrenches(
    engine: *const FlEngine,
    wrenches: *mut FlWrench,
    count: usize,
) -> FlStatus {
    results(engine, |results| {
        // SAFETY: as the caller promises.
        unsafe { give(results.wrenches, wrenches, count, FlWrench::outward) }
    })
}

/// Copies the largest contact wrench on each body within the last step: the wrench of the sub-step with the largest
/// force. With the paper's method, which has no sub-steps, the largest wrenches are those of fl_engine_wrenches(). Use
/// the largest wrench to size fenders and structures: in a long step the mean wrench may be much smaller. Use
/// fl_engine_wrenches() to move the bodies. The largest force of each single contact is fl_contact.peak_normal_force_n.
/// `count` is the number of bodies.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_peak_wrenches(
    engine: *const FlEngine,
    peaks: *mut FlWrench,
    count: usize,
) -> FlStatus {
    results(engine, |results| {
        // SAFETY: as the caller promises.
        unsafe { give(results.peak_wrenches, peaks, count, FlWrench::outward) }
    })
}

/// Copies the engine's states at the end of the last step, for direct hosts that let the engine move the bodies by the
/// coupled method. `count` is the number of bodies. The positions of these states belong to the end of the step. The
/// velocities of these states belong to the time half a step before the end (half of the last sub-step, if there were
/// several), as in a leapfrog integrator. Pass the velocities back unchanged in the next step; when you compare or plot
/// velocities, use the time to which they belong.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_states_after(
    engine: *const FlEngine,
    states: *mut FlState,
    count: usize,
) -> FlStatus {
    results(engine, |results| {
        if results.states_after.is_empty() && !results.wrenches.is_empty() {
            let text = "the engine moves bodies only by the coupled method with a direct host";
            return failure(FlStatus::NotAvailable, text);
        }
        // SAFETY: as the caller promises.
        unsafe { give(results.states_after, states, count, FlState::outward) }
    })
}

/// Copies the engine's estimate of the present states of a co-simulation host, and the loads on the host's bodies,
/// reported by the host or observed by the engine. `count` is the number of bodies.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_host_estimate(
    engine: *const FlEngine,
    states: *mut FlState,
    loads: *mut FlWrench,
    count: usize,
) -> FlStatus {
    results(engine, |results| {
        let Some(estimate) = results.host_estimate else {
            return failure(
                FlStatus::NotAvailable,
                "only an engine for a co-simulation host has an estimate of the host's states",
            );
        };
        if count > 0 {
            check(loads, "loads")?;
        }
        // SAFETY: as the caller promises.
        unsafe { give(estimate.states, states, count, FlState::outward) }?;
        // SAFETY: as the caller promises.
        unsafe { give(estimate.loads, loads, count, FlWrench::outward) }
    })
}

/// Number of contact patches in the last step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_contact_count(
    engine: *const FlEngine,
    count: *mut usize,
) -> FlStatus {
    results(engine, |results| {
        // SAFETY: as the caller promises.
        unsafe { write(count, results.contacts.len(), "count") }
    })
}

/// Copies one contact of the last step; contacts count from 0 in a fixed order. The caller sets `contact->size`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_contact(
    engine: *const FlEngine,
    index: u32,
    contact: *mut FlContact,
) -> FlStatus {
    results(engine, |results| {
        let own = among("contact", results.contacts, index)?;
        check_size(contact, "contact")?;
        // SAFETY: as the caller promises.
        unsafe { write(contact, FlContact::outward(own), "contact") }
    })
}

/// Copies all contacts of the last step, in their fixed order. `element_size` is sizeof(fl_contact); the member `size`
/// of the elements need not be set. `*count` gets the number of contacts. A NULL array with a capacity of 0 only asks
/// for the number of contacts; if the capacity is too small, nothing is copied, and the status is
/// FL_STATUS_BUFFER_TOO_SMALL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_contacts(
    engine: *const FlEngine,
    contacts: *mut FlContact,
    element_size: usize,
    capacity: usize,
    count: *mut usize,
) -> FlStatus {
    results(engine, |results| {
        check_element_size::<FlContact>(element_size)?;
        let convert = |contact| FlContact::outward(&contact);
        // SAFETY: as the caller promises.
        unsafe { give_all(results.contacts, contacts, capacity, count, convert) }
    })
}

/// Number of events of the last step.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_event_count(
    engine: *const FlEngine,
    count: *mut usize,
) -> FlStatus {
    results(engine, |results| {
        // SAFETY: as the caller promises.
        unsafe { write(count, results.events.len(), "count") }
    })
}

/// Copies one event of the last step; events count from 0 in a fixed order. The caller sets `event->size`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_event(
    engine: *const FlEngine,
    index: u32,
    event: *mut FlEvent,
) -> FlStatus {
    results(engine, |results| {
        let own = among("event", results.events, index)?;
        check_size(event, "event")?;
        // SAFETY: as the caller promises.
        unsafe { write(event, FlEvent::outward(own), "event") }
    })
}

/// Copies all events of the last step, in their fixed order. `element_size` is sizeof(fl_event). The other arguments
/// are as in fl_engine_contacts().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_events(
    engine: *const FlEngine,
    events: *mut FlEvent,
    element_size: usize,
    capacity: usize,
    count: *mut usize,
) -> FlStatus {
    results(engine, |results| {
        check_element_size::<FlEvent>(element_size)?;
        let convert = |event| FlEvent::outward(&event);
        // SAFETY: as the caller promises.
        unsafe { give_all(results.events, events, capacity, count, convert) }
    })
}

/// Saves all of the engine that steps change, its results included, as bytes. The bytes of a saved engine have a
/// version and a checksum, and are the same on every machine. A NULL buffer with a capacity of 0 only asks for the
/// number of bytes, in `*length`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_save(
    engine: *const FlEngine,
    buffer: *mut u8,
    capacity: usize,
    length: *mut usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        // SAFETY: as the caller promises.
        unsafe { put_bytes(&held.engine.save(), buffer, capacity, length) }
    })
}

/// Restores an engine from bytes that fl_engine_save() made, of this engine or of another engine with the same model
/// and settings. The restored engine continues to the same bits as the saved engine. Any bytes may be passed: bytes
/// that are not a saved engine are refused.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_engine_restore(
    engine: *mut FlEngine,
    saved: *const u8,
    length: usize,
) -> FlStatus {
    ENGINES.call(engine, |held| {
        // SAFETY: as the caller promises.
        let saved = unsafe { bytes(saved, length, "saved") }?;
        Ok(held.engine.restore(&saved)?)
    })
}

/// Stores an engine and returns its handle.
pub(crate) fn hold(engine: Engine) -> Outcome<*mut FlEngine> {
    ENGINES.insert(EngineHeld { engine, states: Vec::new(), loads: Vec::new() })
}

/// Reads the caller's settings, or takes the defaults if the pointer is NULL.
///
/// # Safety
/// The caller's promise.
pub(crate) unsafe fn settings_of(settings: *const FlSettings) -> Outcome<Settings> {
    if settings.is_null() {
        return Ok(Settings::default());
    }
    // SAFETY: as the caller promises.
    unsafe { read_sized(settings, "settings") }?.inward()
}

fn overrides_of(text: &str) -> Outcome<Vec<Override>> {
    let lines = text.lines().map(str::trim).filter(|line| !line.is_empty());
    let read: Result<Vec<Override>, ScenarioError> = lines.map(Override::parse).collect();
    read.or_else(bad_scenario)
}

fn bad_scenario<T>(error: ScenarioError) -> Outcome<T> {
    failure(FlStatus::BadScenario, error)
}

/// Runs a call that reads the results of an engine.
fn results(engine: *const FlEngine, call: impl FnOnce(Results<'_>) -> Outcome) -> FlStatus {
    ENGINES.call(engine, |held| call(held.engine.results()?))
}

pub(crate) fn among<'a, T>(what: &'static str, all: &'a [T], index: u32) -> Outcome<&'a T> {
    let index = index as usize;
    Ok(all.get(index).ok_or(EngineError::NoSuch { what, index, count: all.len() })?)
}

/// Refuses an array whose length is not the number of bodies, before anything is read or written.
fn check_count(bodies: usize, count: usize) -> Outcome {
    if bodies == count {
        return Ok(());
    }
    Err(EngineError::Input(StepError::WrongCount { bodies, states: count }).into())
}

/// Reads the caller's states into the buffer.
///
/// # Safety
/// The caller promises that `count` states are readable.
unsafe fn take_states(held: &mut EngineHeld, states: *const FlState, count: usize) -> Outcome {
    check_count(held.engine.states().len(), count)?;
    // SAFETY: as the caller promises; `count` is the number of bodies.
    unsafe { read_all(states, count, "states", FlState::inward, &mut held.states) }
}

/// Reads the caller's loads into the buffer; returns false if the caller passed no loads.
///
/// # Safety
/// The caller promises that `count` loads are readable.
unsafe fn take_loads(held: &mut EngineHeld, loads: *const FlWrench, count: usize) -> Outcome<bool> {
    if loads.is_null() && count == 0 {
        return Ok(false);
    }
    check_count(held.engine.states().len(), count)?;
    // SAFETY: as the caller promises; `count` is the number of bodies.
    unsafe { read_all(loads, count, "loads", FlWrench::inward, &mut held.loads) }?;
    Ok(true)
}

/// Refuses an array whose elements have another size than this library's structure, as with another version of the
/// header.
fn check_element_size<T>(size: usize) -> Outcome {
    let own = size_of::<T>();
    if size == own {
        return Ok(());
    }
    let text =
        format_args!("`element_size` is {size}, but the library's structure has {own} bytes");
    failure(FlStatus::BadSize, text)
}

/// Copies all values to the caller, or none if they do not fit, and stores their number. A NULL array with a capacity
/// of 0 only asks for the number of values.
///
/// # Safety
/// The caller promises room for `capacity` values.
pub(crate) unsafe fn give_all<T: Copy, U: Copy>(
    own: &[T],
    into: *mut U,
    capacity: usize,
    count: *mut usize,
    convert: impl Fn(T) -> U,
) -> Outcome {
    let is_query = into.is_null() && capacity == 0;
    if !is_query {
        check(into, "the array")?;
    }
    // SAFETY: as the caller promises.
    unsafe { write(count, own.len(), "count") }?;
    if is_query {
        return Ok(());
    }
    if capacity < own.len() {
        let needed = own.len();
        let text =
            format_args!("the array has room for {capacity} elements, but {needed} are needed");
        return failure(FlStatus::BufferTooSmall, text);
    }
    // SAFETY: the values fit into the `capacity` that the caller promises.
    unsafe { write_all(into, own, "the array", convert) }
}

/// Copies one value per body to the caller.
///
/// # Safety
/// The caller promises room for `count` values.
unsafe fn give<T: Copy, U: Copy>(
    own: &[T],
    into: *mut U,
    count: usize,
    convert: impl Fn(T) -> U,
) -> Outcome {
    check_count(own.len(), count)?;
    // SAFETY: as the caller promises; `count` is the number of values.
    unsafe { write_all(into, own, "the array", convert) }
}

const _: fn() = || {
    // Handles are used from any thread.
    fn is_send<T: Send>() {}
    is_send::<(EngineHeld, BodyState, Wrench)>();
};
