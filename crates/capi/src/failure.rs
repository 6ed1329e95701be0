//! The status that a call of the C interface returns, and the message of a failed call.

use core::fmt;

use fenderline_contact::{RestoreError, StepError};
use fenderline_embed::EngineError;

/// Result of a call. If the status is not FL_STATUS_OK, the object is unchanged, and fl_last_error() has a message.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FlStatus {
    /// Success.
    Ok = 0,
    /// A pointer is NULL but must not be, or is misaligned.
    BadPointer = 1,
    /// The handle is invalid, was destroyed or is of another kind.
    BadHandle = 2,
    /// The member `size` of a structure is wrong: the program was compiled with another header.
    BadSize = 3,
    /// A text is not UTF-8, contains a NUL, or is too long.
    BadText = 4,
    /// An argument is an unknown constant or a wrong count, or settings conflict.
    BadArgument = 5,
    /// A file cannot be read, or a scenario or the keys of a fender have an error: the message names file, line and key.
    BadScenario = 6,
    /// Bodies, materials, pairs or fenders are not valid: the message names the part and the field.
    BadModel = 7,
    /// A state, a load or a time step is not finite or out of range: the message names body and field. Also: the step
    /// is so long that its results are not finite.
    BadNumber = 8,
    /// No body, fender, material, contact or event has this name or index.
    NoSuch = 9,
    /// A step was asked for before the states of all floating bodies were set, or a result before the first step.
    OutOfOrder = 10,
    /// The result that the call asks for is not available with the engine's settings.
    NotAvailable = 11,
    /// The bytes are not a saved engine or not a dump: truncated, changed or of another version.
    BadBytes = 12,
    /// The saved engine belongs to another model or to other settings.
    OtherModel = 13,
    /// The buffer is too small; `*length` says how large the buffer must be.
    BufferTooSmall = 14,
    /// The call met a bug in the library. After a bug in the library the handle can only be destroyed.
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
            FlStatus::BadHandle => c"the handle is invalid or was destroyed",
            FlStatus::BadSize => c"a structure has a different size from the library's",
            FlStatus::BadText => c"a text is not UTF-8, contains a NUL or is too long",
            FlStatus::BadArgument => c"an argument of the call is not allowed",
            FlStatus::BadScenario => c"the scenario has an error or cannot be read",
            FlStatus::BadModel => c"bodies, materials, pairs and fenders do not form a valid model",
            FlStatus::BadNumber => c"a number is not finite or out of range",
            FlStatus::NoSuch => c"no part of the engine has that name or index",
            FlStatus::OutOfOrder => c"another call must come before this call",
            FlStatus::NotAvailable => c"not available with the engine's settings",
            FlStatus::BadBytes => c"the bytes are not a saved engine or a dump",
            FlStatus::OtherModel => {
                c"the saved engine belongs to another model or to other settings"
            }
            FlStatus::BufferTooSmall => c"the buffer is too small",
            FlStatus::Panicked => c"a bug in the library: the handle can only be destroyed",
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
            EngineError::Restore(_) | EngineError::Dump(_) | EngineError::DumpVersion { .. } => {
                FlStatus::BadBytes
            }
            EngineError::Keys(_) | EngineError::MissingKey { .. } => FlStatus::BadScenario,
            EngineError::NotRecorded => FlStatus::OutOfOrder,
            EngineError::Points(_) => FlStatus::BadModel,
            // `EngineError` is non-exhaustive.
            _ => FlStatus::BadArgument,
        };
        Failure { status, text: error.to_string() }
    }
}
