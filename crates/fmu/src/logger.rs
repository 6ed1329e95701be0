//! The types of a master's functions that take messages from an FMU.

use std::ffi::{c_char, c_int, c_void};

/// `fmi2CallbackLogger`.
pub type Logger2 = unsafe extern "C" fn(
    environment: *mut c_void,
    instance_name: *const c_char,
    status: c_int,
    category: *const c_char,
    message: *const c_char,
    ...
);

/// `fmi3LogMessageCallback`.
pub type Logger3 = unsafe extern "C" fn(
    environment: *mut c_void,
    status: c_int,
    category: *const c_char,
    message: *const c_char,
);
