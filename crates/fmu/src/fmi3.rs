//! The functions of FMI 3.0, with the signatures of the standard's `fmi3FunctionTypes.h`. All functions of FMI 3.0
//! exist; the functions for model exchange, scheduled execution, clocks and unused types return an error.
//!
//! Every function relies on the master's promise that its pointers are valid, as module `border` says. FMI's instances
//! and states are handles in this library, which are never dereferenced. `fmi3Boolean`, a `bool` of C, is read as a
//! byte, so that any byte is valid.
#![allow(non_snake_case, reason = "the standard's names")]
#![allow(missing_docs, reason = "the standard documents them")]
#![allow(clippy::missing_safety_doc, reason = "the module's head says what the master promises")]
#![allow(clippy::too_many_arguments, reason = "the standard's signatures")]

use std::ffi::{c_char, c_int, c_void};
use std::path::Path;

use crate::border::{Address, Log, check_room, instance, none, read, text, write};
use crate::fmi2::{deserialize, free_state, number_for, serialize};
use crate::instance::{Instance, Outcome};
pub use crate::logger::Logger3;
use crate::registry::{free, make, with};
use crate::status::Status;
use crate::table::Class;

type Bool = u8;

fn code(status: Status) -> c_int {
    status as c_int
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi3GetVersion() -> *const c_char {
    c"3.0".as_ptr()
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetDebugLogging(
    fmu: *mut c_void,
    _logging_on: Bool,
    count: usize,
    categories: *const *const c_char,
) -> c_int {
    // Only errors are logged, and always.
    code(with(fmu, "fmi3SetDebugLogging", |_| check_room(categories, count, "categories")))
}

fn log_of(logger: Option<Logger3>, environment: *mut c_void) -> Log {
    match logger {
        Some(logger) => Log::Three { logger, environment: Address(environment) },
        None => Log::Nowhere,
    }
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateCoSimulation(
    instance_name: *const c_char,
    token: *const c_char,
    resource_path: *const c_char,
    _visible: Bool,
    _logging_on: Bool,
    event_mode_used: Bool,
    _early_return_allowed: Bool,
    _required_intermediate_variables: *const u32,
    required_intermediate_variable_count: usize,
    environment: *mut c_void,
    logger: Option<Logger3>,
    _intermediate_update: Option<unsafe extern "C" fn()>,
) -> *mut c_void {
    make(log_of(logger, environment), || {
        // SAFETY: the master's promise, here and below.
        unsafe { text(instance_name, "the instance's name") }?;
        let token = unsafe { text(token, "the instantiation token") }?;
        let path = unsafe { text(resource_path, "the resource path") }?;
        if event_mode_used != 0 {
            return Err("fmi3InstantiateCoSimulation: the FMU has no event mode".to_owned());
        }
        none(required_intermediate_variable_count, "intermediate updates")?;
        instance(&token, Path::new(&path))
    })
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateModelExchange(
    _instance_name: *const c_char,
    _token: *const c_char,
    _resource_path: *const c_char,
    _visible: Bool,
    _logging_on: Bool,
    environment: *mut c_void,
    logger: Option<Logger3>,
) -> *mut c_void {
    make(log_of(logger, environment), || {
        Err("fmi3InstantiateModelExchange: the FMU is for co-simulation only".to_owned())
    })
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3InstantiateScheduledExecution(
    _instance_name: *const c_char,
    _token: *const c_char,
    _resource_path: *const c_char,
    _visible: Bool,
    _logging_on: Bool,
    environment: *mut c_void,
    logger: Option<Logger3>,
    _clock_update: Option<unsafe extern "C" fn()>,
    _lock_preemption: Option<unsafe extern "C" fn()>,
    _unlock_preemption: Option<unsafe extern "C" fn()>,
) -> *mut c_void {
    make(log_of(logger, environment), || {
        Err("fmi3InstantiateScheduledExecution: the FMU is for co-simulation only".to_owned())
    })
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeInstance(fmu: *mut c_void) {
    free(fmu);
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3EnterInitializationMode(
    fmu: *mut c_void,
    _tolerance_defined: Bool,
    _tolerance: f64,
    start_time: f64,
    stop_time_defined: Bool,
    stop_time: f64,
) -> c_int {
    let stop_s = (stop_time_defined != 0).then_some(stop_time);
    code(with(fmu, "fmi3EnterInitializationMode", |i| {
        i.set_up(start_time, stop_s)?;
        i.enter_initialization()
    }))
}

macro_rules! phase {
    ($($function:ident $method:ident),*) => { $(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $function(fmu: *mut c_void) -> c_int {
            code(with(fmu, stringify!($function), Instance::$method))
        }
    )* };
}

phase!(
    fmi3ExitInitializationMode exit_initialization,
    fmi3Terminate terminate,
    fmi3Reset reset
);

/// Checks that there are as many values as value references, because no variable is an array.
fn check_counts(references: usize, values: usize) -> Outcome {
    if references == values {
        return Ok(());
    }
    Err(format!(
        "a call gives {references} value references but {values} values, although no variable is an array"
    ))
}

macro_rules! values {
    ($($get:ident $set:ident $type:ty, $class:ident, $out:expr, $in:expr);*) => { $(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $get(
            fmu: *mut c_void,
            references: *const u32,
            count: usize,
            values: *mut $type,
            value_count: usize,
        ) -> c_int {
            code(with(fmu, stringify!($get), |i| {
                check_counts(count, value_count)?;
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
            fmu: *mut c_void,
            references: *const u32,
            count: usize,
            values: *const $type,
            value_count: usize,
        ) -> c_int {
            code(with(fmu, stringify!($set), |i| {
                check_counts(count, value_count)?;
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
    fmi3GetFloat64 fmi3SetFloat64 f64, Real, |v| v, |v| v;
    fmi3GetInt32 fmi3SetInt32 i32, Integer, |v| v as i32, f64::from;
    fmi3GetInt64 fmi3SetInt64 i64, Enumeration, |v| v as i64, |v| v as f64;
    fmi3GetBoolean fmi3SetBoolean Bool, Boolean, |v| Bool::from(v != 0.0),
        |v| f64::from(u8::from(v != 0))
);

/// Functions for the types of FMI 3.0 that no variable of the FMU has.
macro_rules! no_values {
    ($($function:ident),*) => { $(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $function(
            fmu: *mut c_void,
            _references: *const u32,
            count: usize,
            _values: *mut c_void,
            _value_count: usize,
        ) -> c_int {
            code(with(fmu, stringify!($function), |_| none(count, "variables of this type")))
        }
    )* };
}

no_values!(
    fmi3GetFloat32,
    fmi3SetFloat32,
    fmi3GetInt8,
    fmi3SetInt8,
    fmi3GetUInt8,
    fmi3SetUInt8,
    fmi3GetInt16,
    fmi3SetInt16,
    fmi3GetUInt16,
    fmi3SetUInt16,
    fmi3GetUInt32,
    fmi3SetUInt32,
    fmi3GetUInt64,
    fmi3SetUInt64,
    fmi3GetString,
    fmi3SetString
);

macro_rules! no_binaries {
    ($($function:ident),*) => { $(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $function(
            fmu: *mut c_void,
            _references: *const u32,
            count: usize,
            _sizes: *mut usize,
            _values: *mut c_void,
            _value_count: usize,
        ) -> c_int {
            code(with(fmu, stringify!($function), |_| none(count, "variables of this type")))
        }
    )* };
}

no_binaries!(fmi3GetBinary, fmi3SetBinary);

/// Functions for clocks, of which the FMU has none.
macro_rules! no_clocks {
    ($($function:ident($($argument:ident),*));*) => { $(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $function(
            fmu: *mut c_void,
            _references: *const u32,
            count: usize,
            $($argument: *mut c_void,)*
        ) -> c_int {
            $(let _ = $argument;)*
            code(with(fmu, stringify!($function), |_| none(count, "clocks")))
        }
    )* };
}

no_clocks!(
    fmi3GetClock(values);
    fmi3SetClock(values);
    fmi3GetIntervalDecimal(intervals, qualifiers);
    fmi3GetIntervalFraction(counters, resolutions, qualifiers);
    fmi3GetShiftDecimal(shifts);
    fmi3GetShiftFraction(counters, resolutions);
    fmi3SetIntervalDecimal(intervals);
    fmi3SetIntervalFraction(counters, resolutions);
    fmi3SetShiftDecimal(shifts);
    fmi3SetShiftFraction(counters, resolutions)
);

/// Functions for the modes that the FMU does not have.
macro_rules! no_mode {
    ($($function:ident),*) => { $(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $function(fmu: *mut c_void) -> c_int {
            code(with(fmu, stringify!($function), |_| Err("the FMU does not have the mode that was asked \
                                                           for".to_owned())))
        }
    )* };
}

no_mode!(
    fmi3EnterEventMode,
    fmi3EnterConfigurationMode,
    fmi3ExitConfigurationMode,
    fmi3EvaluateDiscreteStates,
    fmi3EnterContinuousTimeMode,
    fmi3EnterStepMode
);

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetNumberOfVariableDependencies(
    fmu: *mut c_void,
    _reference: u32,
    _count: *mut usize,
) -> c_int {
    code(with(fmu, "fmi3GetNumberOfVariableDependencies", |_| none(1, "list of dependencies")))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetVariableDependencies(
    fmu: *mut c_void,
    _dependent: u32,
    _element_indices_of_dependent: *mut usize,
    _independents: *mut u32,
    _element_indices_of_independents: *mut usize,
    _dependency_kinds: *mut c_int,
    _count: usize,
) -> c_int {
    code(with(fmu, "fmi3GetVariableDependencies", |_| none(1, "list of dependencies")))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetFMUState(fmu: *mut c_void, state: *mut *mut c_void) -> c_int {
    code(with(fmu, "fmi3GetFMUState", |i| {
        // SAFETY: the master's promise.
        let number = unsafe { number_for(i, state) }?;
        i.save(number);
        Ok(())
    }))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SetFMUState(fmu: *mut c_void, state: *mut c_void) -> c_int {
    code(with(fmu, "fmi3SetFMUState", |i| i.restore(state.addr())))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3FreeFMUState(fmu: *mut c_void, state: *mut *mut c_void) -> c_int {
    // SAFETY: the master's promise.
    code(with(fmu, "fmi3FreeFMUState", |i| unsafe { free_state(i, state) }))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializedFMUStateSize(
    fmu: *mut c_void,
    state: *mut c_void,
    size: *mut usize,
) -> c_int {
    code(with(fmu, "fmi3SerializedFMUStateSize", |i| {
        check_room(size, 1, "size")?;
        // SAFETY: the master's promise.
        unsafe { write(size, &[i.to_bytes(state.addr())?.len()], "size") }
    }))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3SerializeFMUState(
    fmu: *mut c_void,
    state: *mut c_void,
    bytes: *mut u8,
    size: usize,
) -> c_int {
    // SAFETY: the master's promise.
    code(with(fmu, "fmi3SerializeFMUState", |i| unsafe { serialize(i, state.addr(), bytes, size) }))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DeserializeFMUState(
    fmu: *mut c_void,
    bytes: *const u8,
    size: usize,
    state: *mut *mut c_void,
) -> c_int {
    // SAFETY: the master's promise.
    code(with(fmu, "fmi3DeserializeFMUState", |i| unsafe { deserialize(i, bytes, size, state) }))
}

/// Functions for derivatives, which the FMU does not provide.
macro_rules! no_derivatives {
    ($($function:ident),*) => { $(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $function(
            fmu: *mut c_void,
            _unknowns: *const u32,
            _unknown_count: usize,
            _knowns: *const u32,
            _known_count: usize,
            _seed: *const f64,
            _seed_count: usize,
            _sensitivity: *mut f64,
            _sensitivity_count: usize,
        ) -> c_int {
            code(with(fmu, stringify!($function), |_| none(1, "derivatives")))
        }
    )* };
}

no_derivatives!(fmi3GetDirectionalDerivative, fmi3GetAdjointDerivative);

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3GetOutputDerivatives(
    fmu: *mut c_void,
    _references: *const u32,
    count: usize,
    _orders: *const i32,
    _values: *mut f64,
    _value_count: usize,
) -> c_int {
    code(with(fmu, "fmi3GetOutputDerivatives", |_| none(count, "output derivatives")))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3UpdateDiscreteStates(
    fmu: *mut c_void,
    _discrete_states_need_update: *mut Bool,
    _terminate_simulation: *mut Bool,
    _nominals_of_continuous_states_changed: *mut Bool,
    _values_of_continuous_states_changed: *mut Bool,
    _next_event_time_defined: *mut Bool,
    _next_event_time: *mut f64,
) -> c_int {
    code(with(fmu, "fmi3UpdateDiscreteStates", |_| none(1, "event mode")))
}

#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi3DoStep(
    fmu: *mut c_void,
    current_communication_point: f64,
    communication_step_size: f64,
    _no_set_fmu_state_prior_to_current_point: Bool,
    event_handling_needed: *mut Bool,
    terminate_simulation: *mut Bool,
    early_return: *mut Bool,
    last_successful_time: *mut f64,
) -> c_int {
    code(with(fmu, "fmi3DoStep", |i| {
        let flags = [
            (event_handling_needed, "eventHandlingNeeded"),
            (terminate_simulation, "terminateSimulation"),
            (early_return, "earlyReturn"),
        ];
        flags.iter().try_for_each(|(flag, name)| check_room(*flag, 1, name))?;
        check_room(last_successful_time, 1, "lastSuccessfulTime")?;
        let done = i.step(current_communication_point, communication_step_size);
        for (flag, name) in flags {
            // SAFETY: the master's promise for one flag.
            unsafe { write(flag, &[0], name) }?;
        }
        // SAFETY: the master's promise for one number.
        unsafe { write(last_successful_time, &[i.state.time_s], "lastSuccessfulTime") }?;
        done
    }))
}

/// Functions for model exchange and scheduled execution, which the FMU does not offer.
macro_rules! unsupported {
    ($($function:ident($($argument:ident: $type:ty),*));*) => { $(
        #[unsafe(no_mangle)]
        pub unsafe extern "C" fn $function(fmu: *mut c_void, $($argument: $type),*) -> c_int {
            $(let _ = $argument;)*
            code(with(fmu, stringify!($function), |_| {
                Err("the FMU is for co-simulation only".to_owned())
            }))
        }
    )* };
}

unsupported!(
    fmi3CompletedIntegratorStep(no_set: Bool, enter_event_mode: *mut Bool, terminate: *mut Bool);
    fmi3SetTime(time: f64);
    fmi3SetContinuousStates(states: *const f64, count: usize);
    fmi3GetContinuousStateDerivatives(derivatives: *mut f64, count: usize);
    fmi3GetEventIndicators(indicators: *mut f64, count: usize);
    fmi3GetContinuousStates(states: *mut f64, count: usize);
    fmi3GetNominalsOfContinuousStates(nominals: *mut f64, count: usize);
    fmi3GetNumberOfEventIndicators(count: *mut usize);
    fmi3GetNumberOfContinuousStates(count: *mut usize);
    fmi3ActivateModelPartition(clock: u32, time: f64)
);
