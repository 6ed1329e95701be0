//! The status that a call of an FMU returns.

/// The status that a call of an FMU returns; its numbers are those of `fmi2Status` and `fmi3Status`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub(crate) enum Status {
    Ok = 0,
    Discard = 2,
    Error = 3,
    Fatal = 4,
}
