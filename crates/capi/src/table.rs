//! Tables of objects by handle. A handle is a number in the form of a pointer, which is looked up in a table and never
//! dereferenced. A handle contains a mark that no valid address has, the kind of the object, and a serial number that
//! is never used again.

use core::ptr;
use std::any::Any;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, RwLock};

use fenderline_contact::{BodyState, Wrench};
use fenderline_embed::{Engine, EngineBuilder};

use crate::failure::{Failure, FlStatus, Outcome, failure};
use crate::last_error::remember;

/// A contact engine. Engines share nothing but the table of handles.
pub struct FlEngine {
    _opaque: [u8; 0],
}

/// A builder object: the parts from which engines are made.
pub struct FlBuilder {
    _opaque: [u8; 0],
}

/// An engine with buffers for its arguments.
pub(crate) struct EngineHeld {
    pub(crate) engine: Engine,
    pub(crate) states: Vec<BodyState>,
    pub(crate) loads: Vec<Wrench>,
}

/// Table of all objects of one kind, such as all engines.
pub(crate) struct Table<T> {
    /// The low four bits of the handles of this kind of object. The low four bits of a handle make an odd number,
    /// unlike those of an aligned pointer.
    kind: usize,
    held: RwLock<Held<T>>,
}

struct Held<T> {
    serial: usize,
    objects: BTreeMap<usize, Arc<Mutex<Object<T>>>>,
}

/// One object.
pub(crate) struct Object<T> {
    pub(crate) content: T,
    /// Message of the last failed call on this object.
    pub(crate) error: String,
    /// Whether a call on this object panicked, so that the object may be inconsistent.
    panicked: bool,
}

pub(crate) static ENGINES: Table<EngineHeld> = Table::new(0b0101);
pub(crate) static BUILDERS: Table<EngineBuilder> = Table::new(0b1011);

/// High bits that mark a handle, as no valid address has them; 0 if pointers have no room for them.
const MARK: usize = if usize::BITS == 64 { 0xfede_usize.rotate_right(16) } else { 0 };
const SERIALS: usize = if usize::BITS == 64 { 1 << 40 } else { usize::MAX >> 4 };

impl<T> Table<T> {
    const fn new(kind: usize) -> Table<T> {
        Table { kind, held: RwLock::new(Held { serial: 0, objects: BTreeMap::new() }) }
    }

    /// Stores an object and returns its handle.
    pub(crate) fn insert<H>(&self, content: T) -> Outcome<*mut H> {
        let mut held = self.held.write().unwrap_or_else(PoisonError::into_inner);
        if held.serial + 1 >= SERIALS {
            return failure(FlStatus::NotAvailable, "no handles are left");
        }
        held.serial += 1;
        let serial = held.serial;
        let object = Object { content, error: String::new(), panicked: false };
        held.objects.insert(serial, Arc::new(Mutex::new(object)));
        Ok(ptr::without_provenance_mut(MARK | (serial << 4) | self.kind))
    }

    /// Removes an object. Removes an object from the table; the object lives until a running call on it has ended.
    pub(crate) fn remove<H>(&self, handle: *const H) -> Outcome {
        let serial = self.serial_of(handle)?;
        let mut held = self.held.write().unwrap_or_else(PoisonError::into_inner);
        let Some(object) = held.objects.remove(&serial) else { return self.unknown(handle) };
        // Drop it after the lock is released.
        drop(held);
        drop(object);
        Ok(())
    }

    /// Finds the object of a handle.
    fn find<H>(&self, handle: *const H) -> Outcome<Arc<Mutex<Object<T>>>> {
        let serial = self.serial_of(handle)?;
        let held = self.held.read().unwrap_or_else(PoisonError::into_inner);
        match held.objects.get(&serial) {
            Some(object) => Ok(Arc::clone(object)),
            None => self.unknown(handle),
        }
    }

    fn serial_of<H>(&self, handle: *const H) -> Outcome<usize> {
        let value = handle.addr();
        let serial = (value & !MARK) >> 4;
        if value == MARK | (serial << 4) | self.kind { Ok(serial) } else { self.unknown(handle) }
    }

    #[cold]
    fn unknown<H, R>(&self, handle: *const H) -> Outcome<R> {
        if handle.is_null() {
            return failure(FlStatus::BadPointer, "the handle is NULL");
        }
        failure(FlStatus::BadHandle, "the handle was destroyed, or is not a handle of this kind")
    }

    /// Runs a call on the object of a handle; calls on the same object wait for each other.
    pub(crate) fn call<H>(
        &self,
        handle: *const H,
        call: impl FnOnce(&mut T) -> Outcome,
    ) -> FlStatus {
        no_panic(|| {
            let object = self.find(handle)?;
            let mut object = lock(&object);
            if object.panicked {
                return failure(FlStatus::Panicked, &object.error);
            }
            let content = &mut object.content;
            let outcome = match catch_unwind(AssertUnwindSafe(|| call(content))) {
                Ok(outcome) => outcome,
                Err(payload) => {
                    object.panicked = true;
                    Err(panicked(payload.as_ref()))
                }
            };
            if let Err(failure) = &outcome {
                object.error.clone_from(&failure.text);
            }
            outcome
        })
    }

    /// Runs a call as [`Table::call`] does, even on an object on which a call panicked: for calls that only read what a
    /// panic cannot have left half-changed.
    pub(crate) fn call_even_panicked<H>(
        &self,
        handle: *const H,
        call: impl FnOnce(&T) -> Outcome,
    ) -> FlStatus {
        no_panic(|| {
            let object = self.find(handle)?;
            let object = lock(&object);
            call(&object.content)
        })
    }

    /// Returns the message of the last failed call on a handle.
    pub(crate) fn error<H>(&self, handle: *const H) -> Outcome<String> {
        let object = self.find(handle)?;
        let text = lock(&object).error.clone();
        Ok(text)
    }
}

fn lock<T>(object: &Mutex<Object<T>>) -> MutexGuard<'_, Object<T>> {
    // A panic is recorded in `panicked`.
    object.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Runs a call. Runs a call and turns a failure or a panic into a status, with a message for [`crate::fl_last_error`].
pub(crate) fn no_panic(call: impl FnOnce() -> Outcome) -> FlStatus {
    let outcome = catch_unwind(AssertUnwindSafe(call));
    match outcome.unwrap_or_else(|payload| Err(panicked(payload.as_ref()))) {
        Ok(()) => FlStatus::Ok,
        Err(Failure { status, text }) => {
            remember(text);
            status
        }
    }
}

#[cold]
fn panicked(payload: &(dyn Any + Send)) -> Failure {
    let own = payload.downcast_ref::<&str>().copied();
    let message = own.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    let message = message.unwrap_or("no message");
    let text = format!("a bug in the library: {message}");
    Failure { status: FlStatus::Panicked, text }
}
