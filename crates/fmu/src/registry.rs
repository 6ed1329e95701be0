//! The registry of all FMU instances of the process. The handle of an instance is looked up here and never
//! dereferenced, so that a freed or invalid handle is rejected.

use std::collections::BTreeMap;
use std::ffi::c_void;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use crate::border::Log;
use crate::instance::{Instance, Outcome};
use crate::status::Status;

/// An instance of an FMU, and the receiver of its messages.
struct Held {
    instance: Mutex<Instance>,
    log: Log,
}

static ALL: Mutex<BTreeMap<usize, Arc<Held>>> = Mutex::new(BTreeMap::new());
static NEXT: AtomicUsize = AtomicUsize::new(1);

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    // Panics are caught while the lock is held, so the lock is never poisoned; the value would be valid even then.
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A new handle for an instance or for a saved state.
pub(crate) fn next_number() -> usize {
    // Multiples of 16 look like aligned pointers to masters that check.
    NEXT.fetch_add(1, Ordering::Relaxed).wrapping_mul(16)
}

pub(crate) fn as_pointer(number: usize) -> *mut c_void {
    std::ptr::without_provenance_mut(number)
}

/// Creates an instance. If the instance cannot be made, logs the reason and returns NULL.
pub(crate) fn make(log: Log, make: impl FnOnce() -> Outcome<Instance>) -> *mut c_void {
    match catch_unwind(AssertUnwindSafe(make)) {
        Ok(Ok(instance)) => {
            let number = next_number();
            let held = Held { instance: Mutex::new(instance), log };
            lock(&ALL).insert(number, Arc::new(held));
            as_pointer(number)
        }
        Ok(Err(why)) => {
            log.write(Status::Error, &why);
            std::ptr::null_mut()
        }
        Err(_) => {
            log.write(Status::Fatal, "a mistake of fenderline's: please report it");
            std::ptr::null_mut()
        }
    }
}

/// Frees an instance of the FMU; a handle that is not known is ignored.
pub(crate) fn free(component: *mut c_void) {
    lock(&ALL).remove(&component.addr());
}

/// Calls `body` with the instance that belongs to a handle, and logs an error of the call.
pub(crate) fn with(
    component: *mut c_void,
    name: &str,
    body: impl FnOnce(&mut Instance) -> Outcome,
) -> Status {
    let Some(held) = lock(&ALL).get(&component.addr()).cloned() else {
        // Nowhere to log: the logger belonged to the instance.
        return Status::Error;
    };
    let outcome = {
        let mut instance = lock(&held.instance);
        if instance.broken {
            Err("an earlier call found a mistake of fenderline's: free the instance".to_owned())
        } else {
            match catch_unwind(AssertUnwindSafe(|| body(&mut instance))) {
                Ok(outcome) => outcome,
                Err(_) => {
                    instance.broken = true;
                    drop(instance);
                    let text = format!("{name}: a mistake of fenderline's: please report it");
                    held.log.write(Status::Fatal, &text);
                    return Status::Fatal;
                }
            }
        }
    };
    // The lock is released: a logger may call the FMU.
    match outcome {
        Ok(()) => Status::Ok,
        Err(why) => {
            held.log.write(Status::Error, &format!("{name}: {why}"));
            Status::Error
        }
    }
}
