//! Errors in the input of a host or a user. When the engine returns an error, it has changed nothing.

use alloc::string::String;
use core::fmt;

/// The reason why a model cannot be built.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ModelError {
    /// A number of a body, a fender or a material is out of range.
    OutOfRange {
        /// The body or material.
        owner: String,
        /// The field.
        field: &'static str,
        /// Its value.
        value: f64,
        /// The values that are allowed for the field, in words.
        must: &'static str,
    },
    /// A mass matrix is not symmetric or not positive definite.
    BadMatrix {
        /// The body.
        body: String,
    },
    /// Two bodies have the same key.
    DuplicateKey {
        /// The body added later.
        body: String,
        /// The key.
        key: u64,
    },
    /// A pair or fender names a body or material that does not exist.
    UnknownId {
        /// The kind of part that does not exist: body or material.
        what: &'static str,
        /// Its index.
        index: u32,
    },
    /// A pair has the same body twice, has two fixed bodies, or occurs twice.
    BadPair {
        /// The two bodies.
        bodies: [String; 2],
        /// What is wrong.
        why: &'static str,
    },
}

impl fmt::Display for ModelError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ModelError::OutOfRange { owner, field, value, must } => {
                write!(f, "{field} of `{owner}` is {}: it must be {must}", DisplayNumber(*value))
            }
            ModelError::BadMatrix { body } => {
                write!(f, "the mass matrix of `{body}` is not symmetric and positive definite")
            }
            ModelError::DuplicateKey { body, key } => {
                write!(f, "body `{body}` has key {key}, which another body also has")
            }
            ModelError::UnknownId { what, index } => {
                write!(f, "there is no {what} with the index {index}")
            }
            ModelError::BadPair { bodies: [a, b], why } => write!(f, "pair `{a}`, `{b}`: {why}"),
        }
    }
}

impl core::error::Error for ModelError {}

/// A step that failed. The memory is unchanged after a failed step.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum StepError {
    /// The host gave states for a wrong number of bodies.
    WrongCount {
        /// Bodies in the model.
        bodies: usize,
        /// States given.
        states: usize,
    },
    /// The time step Δt is out of range: it must be 1e-9 s to 1e6 s, or 0 for a pause.
    BadTimeStep {
        /// The value given (s).
        step_s: f64,
    },
    /// A number of a state or load is infinite, NaN or out of range.
    BadState {
        /// Name of the body.
        body: String,
        /// The field of the body's state that is wrong.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// The step overflows: a load is far too large for the mass of its body, or the step is far too long for a stiff
    /// contact.
    NotFinite {
        /// Name of a body with a non-finite result.
        body: String,
    },
    /// The memory belongs to another model.
    WrongModel,
    /// A body stands on a pile, and this step cannot move it. The paper's method cannot move a body on a pile, and
    /// neither can a host that moves its bodies itself. [`crate::advance_from_engine_states`] and
    /// [`crate::advance_in_place`] can.
    OnPile {
        /// Name of the body.
        body: String,
    },
}

impl fmt::Display for StepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StepError::WrongCount { bodies, states } => {
                write!(f, "the model has {bodies} bodies, but {states} states were given")
            }
            StepError::BadTimeStep { step_s } => {
                write!(
                    f,
                    "the time step is {} s: it must be 1e-9 s to 1e6 s, or 0 for a pause",
                    DisplayNumber(*step_s)
                )
            }
            StepError::BadState { body, field, value } => {
                write!(f, "{field} of body `{body}` is {}", DisplayNumber(*value))
            }
            StepError::NotFinite { body } => {
                write!(
                    f,
                    "the step overflows: it is far too long for body `{body}`, or the body is far too light for \
                     its load"
                )
            }
            StepError::OnPile { body } => write!(
                f,
                "body `{body}` stands on a pile: only the coupled method moves such bodies, and only where the engine \
                 moves all bodies"
            ),
            StepError::WrongModel => {
                write!(f, "the memory was made for another model than the model of this step")
            }
        }
    }
}

impl core::error::Error for StepError {}

/// The reason why a snapshot cannot be restored. The memory is unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RestoreError {
    /// The bytes do not begin with the mark of a snapshot.
    NotASnapshot,
    /// The snapshot has a version that this library does not read.
    Version {
        /// The version found.
        found: u32,
    },
    /// The snapshot was made from another model.
    OtherModel,
    /// Missing or surplus bytes.
    Length,
    /// The checksum does not match: the bytes of the snapshot were changed.
    Checksum,
    /// The snapshot has a value that is impossible in a memory.
    Content,
}

impl fmt::Display for RestoreError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RestoreError::NotASnapshot => write!(f, "the bytes are not a snapshot of this library"),
            RestoreError::Version { found } => {
                write!(f, "snapshot version {found} is not supported")
            }
            RestoreError::OtherModel => write!(f, "the snapshot belongs to another model"),
            RestoreError::Length => write!(f, "the snapshot is truncated or has surplus bytes"),
            RestoreError::Checksum => write!(f, "the snapshot's checksum does not match"),
            RestoreError::Content => write!(f, "the snapshot contains an impossible value"),
        }
    }
}

impl core::error::Error for RestoreError {}

/// A number for messages: the shortest decimal text that a parser reads as the same number. Very large and very small
/// numbers are written with an exponent.
///
/// ```
/// use fenderline_contact::DisplayNumber;
/// assert_eq!([0.1, 1852.0, 1e308].map(|number| DisplayNumber(number).to_string()), ["0.1", "1852", "1e308"]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplayNumber(pub f64);

impl fmt::Display for DisplayNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let DisplayNumber(value) = self;
        let is_plain = *value == 0.0 || !value.is_finite() || (1e-6..1e12).contains(&value.abs());
        if is_plain { fmt::Display::fmt(value, f) } else { fmt::LowerExp::fmt(value, f) }
    }
}
