//! The functions of FMI 2.0 for co-simulation, with the signatures of the standard's `fmi2FunctionTypes.h`.
//!
//! Every function relies on the master's promise that its pointers are valid, as module `border` says. FMI's components
//! and states are handles in this library, which are never dereferenced.
#![allow(non_snake_case, reason = "the standard's names")]
#![allow(missing_docs, reason = "the standard documents them")]
#![allow(clippy::missing_safety_doc, reason = "the module's head says what the master promises")]

use std::ffi::{CString, c_char, c_int, c_void};

use crate::border::{
    Address, Log, check_room, folder_of_uri, instance, none, read, read_bytes, text, write,
};
use crate::instance::{Instance, Outcome};
pub use crate::logger::Logger2;
use crate::registry::{as_pointer, free, make, next_number, with};
use crate::status::Status;
use crate::table::Class;

/// `fmi2CallbackFunctions`. The library uses only the logger of the callbacks: it has its own memory, and no step is
/// asynchronous.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct Callbacks {
    pub logger: Option<Logger2>,
    pub allocate_memory: Option<unsafe extern "C" fn(usize, usize) -> *mut c_void>,
    pub free_memory: Option<unsafe extern "C" fn(*mut c_void)>,
    pub step_finished: Option<unsafe extern "C" fn(*mut c_void, c_int)>,
    pub environment: *mut c_void,
}

/// `fmi2CoSimulation`.
const CO_SIMULATION: c_int = 1;
/// `fmi2LastSuccessfulTime`, `fmi2Terminated`.
const LAST_SUCCESSFUL_TIME: c_int = 2;
const TERMINATED: c_int = 3;

fn code(status: Status) -> c_int {
    status as c_int
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetDebugLogging(
    component: *mut c_void,
    _logging_on: c_int,
    count: usize,
    categories: *const *const c_char,
) -> c_int {
    // Only errors are logged, and always.
    code(with(component, "fmi2SetDebugLogging", |_| check_room(categories, count, "categories")))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    instance_name: *const c_char,
    kind: c_int,
    guid: *const c_char,
    resource_location: *const c_char,
    functions: *const Callbacks,
    _visible: c_int,
    _logging_on: c_int,
) -> *mut c_void {
    // SAFETY: the master's promise.
    let name = unsafe { text(instance_name, "the instance's name") };
    // SAFETY: the master's promise for one structure.
    let callbacks = unsafe { read(functions, 1, "functions") };
    let log = match &callbacks {
        Ok(callbacks) => match callbacks[0].logger {
            Some(logger) => Log::Two {
                logger,
                environment: Address(callbacks[0].environment),
                name: CString::new(name.clone().unwrap_or_default()).unwrap_or_default(),
            },
            None => Log::Nowhere,
        },
        Err(_) => Log::Nowhere,
    };
    make(log, || {
        callbacks?;
        name?;
        if kind != CO_SIMULATION {
            return Err("fmi2Instantiate: the FMU is for co-simulation only".to_owned());
        }
        // SAFETY: the master's promise.
        let guid = unsafe { text(guid, "the GUID") }?;
        // SAFETY: the master's promise.
        let location = unsafe { text(resource_location, "the resource location") }?;
        instance(&guid, &folder_of_uri(&location)?)
    })
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(component: *mut c_void) {
    free(component);
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetupExperiment(
    component: *mut c_void,
    _tolerance_defined: c_int,
    _tolerance: f64,
    start_time: f64,
    stop_time_defined: c_int,
    stop_time: f64,
) -> c_int {
    let stop_s = (stop_time_defined != 0).then_some(stop_time);
    code(with(component, "fmi2SetupExperiment", |i| i.set_up(start_time, stop_s)))
}

macro_rules! phase {
    ($($function:ident $method:ident),*) => { $(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $function(component: *mut c_void) -> c_int {
            code(with(component, stringify!($function), Instance::$method))
        }
    )* };
}

phase!(
    fmi2EnterInitializationMode enter_initialization,
    fmi2ExitInitializationMode exit_initialization,
    fmi2Terminate terminate,
    fmi2Reset reset
);

macro_rules! values {
    ($($get:ident $set:ident $type:ty, $class:ident, $out:expr, $in:expr);*) => { $(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $get(
            component: *mut c_void,
            references: *const u32,
            count: usize,
            values: *mut $type,
        ) -> c_int {
            code(with(component, stringify!($get), |i| {
                // SAFETY: the master's promise.
                let references = unsafe { read(references, count, "value references") }?;
                check_room(values, count, "values")?;
                let out: fn(f64) -> $type = $out;
                let found: Vec<$type> =
                    i.get(&references, Class::$class)?.into_iter().map(out).collect();
                // SAFETY: the master's promise for room for `count` values.
                unsafe { write(values, &found, "values") }
            }))
        }

        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $set(
            component: *mut c_void,
            references: *const u32,
            count: usize,
            values: *const $type,
        ) -> c_int {
            code(with(component, stringify!($set), |i| {
                // SAFETY: the master's promise.
                let references = unsafe { read(references, count, "value references") }?;
                // SAFETY: the master's promise.
                let values = unsafe { read(values, count, "values") }?;
                let convert: fn($type) -> f64 = $in;
                let values: Vec<f64> = values.into_iter().map(convert).collect();
                i.set(&references, &values, Class::$class)
            }))
        }
    )* };
}

values!(
    fmi2GetReal fmi2SetReal f64, Real, |v| v, |v| v;
    fmi2GetInteger fmi2SetInteger c_int, Integer, |v| v as c_int, f64::from;
    fmi2GetBoolean fmi2SetBoolean c_int, Boolean, |v| c_int::from(v != 0.0),
        |v| f64::from(u8::from(v != 0))
);

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetString(
    component: *mut c_void,
    _references: *const u32,
    count: usize,
    _values: *mut *const c_char,
) -> c_int {
    code(with(component, "fmi2GetString", |_| none(count, "texts")))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetString(
    component: *mut c_void,
    _references: *const u32,
    count: usize,
    _values: *const *const c_char,
) -> c_int {
    code(with(component, "fmi2SetString", |_| none(count, "texts")))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(component: *mut c_void, state: *mut *mut c_void) -> c_int {
    code(with(component, "fmi2GetFMUstate", |i| {
        // SAFETY: the master's promise.
        let number = unsafe { number_for(i, state) }?;
        i.save(number);
        Ok(())
    }))
}

/// Number under which a state is saved: that of the state to overwrite, or a new number, which is written to the
/// master's pointer.
///
/// # Safety
/// `state` must be valid for one pointer during the call, as the master promises.
pub(crate) unsafe fn number_for(instance: &Instance, state: *mut *mut c_void) -> Outcome<usize> {
    // SAFETY: the master's promise.
    let old = unsafe { read(state, 1, "the FMU state") }?[0].addr();
    let number = if instance.saved.contains_key(&old) { old } else { next_number() };
    // SAFETY: the master's promise.
    unsafe { write(state, &[as_pointer(number)], "the FMU state") }?;
    Ok(number)
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetFMUstate(component: *mut c_void, state: *mut c_void) -> c_int {
    code(with(component, "fmi2SetFMUstate", |i| i.restore(state.addr())))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(
    component: *mut c_void,
    state: *mut *mut c_void,
) -> c_int {
    // SAFETY: the master's promise.
    code(with(component, "fmi2FreeFMUstate", |i| unsafe { free_state(i, state) }))
}

/// Frees a saved state and sets the master's pointer to NULL. Freeing NULL does nothing.
///
/// # Safety
/// `state` must be valid for one pointer during the call, as the master promises.
pub(crate) unsafe fn free_state(instance: &mut Instance, state: *mut *mut c_void) -> Outcome {
    // SAFETY: the master's promise.
    let number = unsafe { read(state, 1, "the FMU state") }?[0].addr();
    if number != 0 {
        instance.forget(number)?;
    }
    // SAFETY: the master's promise.
    unsafe { write(state, &[std::ptr::null_mut()], "the FMU state") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializedFMUstateSize(
    component: *mut c_void,
    state: *mut c_void,
    size: *mut usize,
) -> c_int {
    code(with(component, "fmi2SerializedFMUstateSize", |i| {
        check_room(size, 1, "size")?;
        // SAFETY: the master's promise.
        unsafe { write(size, &[i.to_bytes(state.addr())?.len()], "size") }
    }))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SerializeFMUstate(
    component: *mut c_void,
    state: *mut c_void,
    bytes: *mut u8,
    size: usize,
) -> c_int {
    // SAFETY: the master's promise.
    code(with(component, "fmi2SerializeFMUstate", |i| unsafe {
        serialize(i, state.addr(), bytes, size)
    }))
}

/// Writes the bytes of a saved state; the master's room may be larger than needed.
///
/// # Safety
/// `bytes` must have room for `size` bytes during the call, as the master promises.
pub(crate) unsafe fn serialize(
    instance: &Instance,
    number: usize,
    bytes: *mut u8,
    size: usize,
) -> Outcome {
    let own = instance.to_bytes(number)?;
    if size < own.len() {
        return Err(format!(
            "the saved state has {} bytes, but there is room for only {size}",
            own.len()
        ));
    }
    // SAFETY: the master's promise for `size` bytes, and these are not more.
    unsafe { write(bytes, &own, "the bytes") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DeSerializeFMUstate(
    component: *mut c_void,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> c_int {
    // SAFETY: the master's promise.
    code(with(component, "fmi2DeSerializeFMUstate", |i| unsafe {
        deserialize(i, bytes, size, state)
    }))
}

/// Makes a saved state from the bytes of another.
///
/// # Safety
/// `bytes` must be valid for `size` bytes and `state` for one pointer during the call, as the master promises.
pub(crate) unsafe fn deserialize(
    instance: &mut Instance,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> Outcome {
    check_room(state, 1, "the FMU state")?;
    // SAFETY: the master's promise.
    let bytes = unsafe { read_bytes(bytes, size) }?;
    let number = next_number();
    instance.of_bytes(&bytes, number)?;
    // SAFETY: the master's promise.
    unsafe { write(state, &[as_pointer(number)], "the FMU state") }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDirectionalDerivative(
    component: *mut c_void,
    _unknowns: *const u32,
    _unknown_count: usize,
    _knowns: *const u32,
    _known_count: usize,
    _known_changes: *const f64,
    _unknown_changes: *mut f64,
) -> c_int {
    code(with(component, "fmi2GetDirectionalDerivative", |_| none(1, "derivatives")))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetRealInputDerivatives(
    component: *mut c_void,
    _references: *const u32,
    count: usize,
    _orders: *const c_int,
    _values: *const f64,
) -> c_int {
    code(with(component, "fmi2SetRealInputDerivatives", |_| none(count, "input derivatives")))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealOutputDerivatives(
    component: *mut c_void,
    _references: *const u32,
    count: usize,
    _orders: *const c_int,
    _values: *mut f64,
) -> c_int {
    code(with(component, "fmi2GetRealOutputDerivatives", |_| none(count, "output derivatives")))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2DoStep(
    component: *mut c_void,
    current_communication_point: f64,
    communication_step_size: f64,
    _no_set_fmu_state_prior_to_current_point: c_int,
) -> c_int {
    code(with(component, "fmi2DoStep", |i| {
        i.step(current_communication_point, communication_step_size)
    }))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2CancelStep(component: *mut c_void) -> c_int {
    code(with(component, "fmi2CancelStep", |_| {
        Err("no step can be cancelled, because steps are not asynchronous".to_owned())
    }))
}

/// Writes a status value to the master; the result is Discard if the FMU has no such value, as the standard requires.
fn status_value<T: Copy>(
    component: *mut c_void,
    name: &str,
    value: *mut T,
    found: impl FnOnce(&Instance) -> Option<T>,
) -> c_int {
    let mut known = true;
    let status = with(component, name, |i| {
        check_room(value, 1, "value")?;
        let Some(found) = found(i) else {
            known = false;
            return Ok(());
        };
        // SAFETY: the master's promise for one value.
        unsafe { write(value, &[found], "value") }
    });
    code(if known { status } else { Status::Discard })
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStatus(
    component: *mut c_void,
    _kind: c_int,
    value: *mut c_int,
) -> c_int {
    status_value(component, "fmi2GetStatus", value, |_| None)
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetRealStatus(
    component: *mut c_void,
    kind: c_int,
    value: *mut f64,
) -> c_int {
    status_value(component, "fmi2GetRealStatus", value, |i| {
        (kind == LAST_SUCCESSFUL_TIME).then_some(i.state.time_s)
    })
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetIntegerStatus(
    component: *mut c_void,
    _kind: c_int,
    value: *mut c_int,
) -> c_int {
    status_value(component, "fmi2GetIntegerStatus", value, |_| None)
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBooleanStatus(
    component: *mut c_void,
    kind: c_int,
    value: *mut c_int,
) -> c_int {
    status_value(component, "fmi2GetBooleanStatus", value, |_| (kind == TERMINATED).then_some(0))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetStringStatus(
    component: *mut c_void,
    _kind: c_int,
    value: *mut *const c_char,
) -> c_int {
    status_value(component, "fmi2GetStringStatus", value, |_| None)
}
