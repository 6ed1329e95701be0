//! What a host can get wrong; each leaves the engine as it was.

use std::fmt;

use fenderline_contact::{OutlineError, RestoreError, StepError};
use fenderline_sim::SetupError;

/// A call that an engine refuses.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum EngineError {
    /// The bodies, materials, pairs and fenders make no contact problem.
    Setup(SetupError),
    /// An outline that is none.
    Outline {
        /// The body.
        body: String,
        /// What is wrong.
        error: OutlineError,
    },
    /// Settings that do not go together.
    Settings(&'static str),
    /// A name that is empty or stands twice.
    Name {
        /// `body`, `material` or `fender`.
        what: &'static str,
        /// The name.
        name: String,
        /// What is wrong with it.
        why: &'static str,
    },
    /// An index beyond the last.
    NoSuch {
        /// `body`, `material`, `fender`, `contact` or `event`.
        what: &'static str,
        /// The index given.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// A name that nothing has.
    NoSuchName {
        /// `body` or `fender`.
        what: &'static str,
        /// The name given.
        name: String,
    },
    /// A state, a load, a time step or a number of them that the engine does not take.
    Input(StepError),
    /// A step whose forces or states are not finite: far too long for the states that were shown.
    NotFinite,
    /// A step before the state of a floating body was shown.
    StateNotSet {
        /// The body.
        body: String,
    },
    /// Results before the first step.
    NoStepYet,
    /// Something that engines of these settings do not have.
    NotAvailable(&'static str),
    /// Bytes that are no saved engine, or that of another model.
    Restore(RestoreError),
    /// A saved engine of the same model with other settings.
    OtherSettings,
}

impl fmt::Display for EngineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EngineError::Setup(error) => error.fmt(f),
            EngineError::Outline { body, error } => write!(f, "outline of body `{body}`: {error}"),
            EngineError::Settings(why) | EngineError::NotAvailable(why) => f.write_str(why),
            EngineError::Name { what, name, why } => write!(f, "the {what} name `{name}` {why}"),
            EngineError::NoSuch { what, index, count } => {
                write!(f, "there is no {what} {index}: there are {count}, counted from 0")
            }
            EngineError::NoSuchName { what, name } => write!(f, "no {what} is named `{name}`"),
            EngineError::Input(error) => error.fmt(f),
            EngineError::NotFinite => f.write_str(
                "the step gives forces or states that are not finite: it is far too long for these states",
            ),
            EngineError::StateNotSet { body } => {
                write!(f, "the state of body `{body}` was never shown")
            }
            EngineError::NoStepYet => f.write_str("there are no results: no step was taken"),
            EngineError::Restore(error) => error.fmt(f),
            EngineError::OtherSettings => {
                f.write_str("the saved engine has another method, host or delay")
            }
        }
    }
}

impl std::error::Error for EngineError {}

impl From<SetupError> for EngineError {
    fn from(error: SetupError) -> EngineError {
        EngineError::Setup(error)
    }
}

impl From<StepError> for EngineError {
    fn from(error: StepError) -> EngineError {
        match error {
            StepError::NotFinite { .. } => EngineError::NotFinite,
            other => EngineError::Input(other),
        }
    }
}

impl From<RestoreError> for EngineError {
    fn from(error: RestoreError) -> EngineError {
        EngineError::Restore(error)
    }
}
