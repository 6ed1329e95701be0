//! How a call ends.

use core::fmt;

use fenderline_contact::{RestoreError, StepError};
use fenderline_embed::EngineError;

/// How a call ended. Anything but FL_STATUS_OK leaves the object as it was, and a text for people that
/// fl_last_error() gives.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlStatus {
    /// Done.
    Ok = 0,
    /// A pointer is NULL that may not be, or is not aligned for what it points to.
    BadPointer = 1,
    /// The handle stands for nothing: it was destroyed, is one of another kind, or never was one.
    BadHandle = 2,
    /// The member `size` of a structure is not its size: the program was compiled with another header.
    BadSize = 3,
    /// A text that is not UTF-8, holds a NUL, or is too long.
    BadText = 4,
    /// A constant, a count or settings that are none or do not go together.
    BadArgument = 5,
    /// A file that cannot be read, or a mistake in a scenario: the text says file, line and key.
    BadScenario = 6,
    /// Bodies, materials, pairs and fenders that make no model: the text names which and what.
    BadModel = 7,
    /// A state, a load or a time step that is not finite or out of range: the text names body and field; or a
    /// step so long that its results are not finite.
    BadNumber = 8,
    /// No body, fender, material, contact or event of that name or index.
    NoSuch = 9,
    /// A step before all floating bodies were shown, or a result before the first step.
    OutOfOrder = 10,
    /// Something that an engine of these settings does not have.
    NotAvailable = 11,
    /// Bytes that are no saved engine: cut, changed or of another version.
    BadBytes = 12,
    /// The saved engine is that of another model, or of other settings.
    OtherModel = 13,
    /// The buffer is too small; `*length` says how large it must be.
    BufferTooSmall = 14,
    /// A fault of the library itself. The handle can only be destroyed.
    Panicked = 15,
}

impl FlStatus {
    pub(crate) const ALL: [FlStatus; 16] = [
        FlStatus::Ok,
        FlStatus::BadPointer,
        FlStatus::BadHandle,
        FlStatus::BadSize,
        FlStatus::BadText,
        FlStatus::BadArgument,
        FlStatus::BadScenario,
        FlStatus::BadModel,
        FlStatus::BadNumber,
        FlStatus::NoSuch,
        FlStatus::OutOfOrder,
        FlStatus::NotAvailable,
        FlStatus::BadBytes,
        FlStatus::OtherModel,
        FlStatus::BufferTooSmall,
        FlStatus::Panicked,
    ];

    pub(crate) fn text(self) -> &'static core::ffi::CStr {
        match self {
            FlStatus::Ok => c"done",
            FlStatus::BadPointer => c"a pointer is NULL or not aligned",
            FlStatus::BadHandle => c"the handle stands for nothing",
            FlStatus::BadSize => c"a structure has another size than the library's",
            FlStatus::BadText => c"a text is not UTF-8, holds a NUL or is too long",
            FlStatus::BadArgument => c"an argument is none that the function takes",
            FlStatus::BadScenario => c"the scenario has a mistake or cannot be read",
            FlStatus::BadModel => c"the parts make no model",
            FlStatus::BadNumber => c"a number is not finite or out of range",
            FlStatus::NoSuch => c"there is nothing of that name or index",
            FlStatus::OutOfOrder => c"the call came before another that it needs",
            FlStatus::NotAvailable => c"an engine of these settings has no such thing",
            FlStatus::BadBytes => c"the bytes are no saved engine",
            FlStatus::OtherModel => c"the saved engine is that of another model or other settings",
            FlStatus::BufferTooSmall => c"the buffer is too small",
            FlStatus::Panicked => c"a fault of the library: the handle can only be destroyed",
        }
    }
}

/// Why a call failed.
#[derive(Clone, Debug)]
pub(crate) struct Failure {
    pub(crate) status: FlStatus,
    pub(crate) text: String,
}

pub(crate) type Outcome<T = ()> = Result<T, Failure>;

pub(crate) fn failure<T>(status: FlStatus, text: impl fmt::Display) -> Outcome<T> {
    Err(Failure { status, text: text.to_string() })
}

impl From<EngineError> for Failure {
    #[cold]
    fn from(error: EngineError) -> Failure {
        let status = match &error {
            EngineError::Setup(_) | EngineError::Outline { .. } | EngineError::Name { .. } => {
                FlStatus::BadModel
            }
            EngineError::Settings(_) => FlStatus::BadArgument,
            EngineError::NoSuch { .. } | EngineError::NoSuchName { .. } => FlStatus::NoSuch,
            EngineError::Input(StepError::WrongCount { .. }) => FlStatus::BadArgument,
            EngineError::Input(_) | EngineError::NotFinite => FlStatus::BadNumber,
            EngineError::StateNotSet { .. } | EngineError::NoStepYet => FlStatus::OutOfOrder,
            EngineError::NotAvailable(_) => FlStatus::NotAvailable,
            EngineError::Restore(RestoreError::OtherModel) | EngineError::OtherSettings => {
                FlStatus::OtherModel
            }
            EngineError::Restore(_) => FlStatus::BadBytes,
            // A kind of mistake that this crate has not learnt of.
            _ => FlStatus::BadArgument,
        };
        Failure { status, text: error.to_string() }
    }
}
