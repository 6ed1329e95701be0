//! Errors in a host's input. After an error in the host's input the engine is unchanged.

use std::fmt;

use fenderline_contact::{OutlineError, RestoreError, StepError};
use fenderline_scenario::ScenarioError;
use fenderline_sim::SetupError;

/// Error of a call that an engine refuses.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum EngineError {
    /// The bodies, materials, pairs and fenders do not form a valid contact problem.
    Setup(SetupError),
    /// An invalid outline.
    Outline {
        /// The body.
        body: String,
        /// What is wrong.
        error: OutlineError,
    },
    /// Settings that conflict.
    Settings(&'static str),
    /// A name of a body, material or fender is empty or already used.
    Name {
        /// `body`, `material` or `fender`.
        what: &'static str,
        /// The name.
        name: String,
        /// What is wrong with the name.
        why: &'static str,
    },
    /// An index is larger than the last index.
    NoSuch {
        /// Kind of the part that the index should name: `body`, `material`, `fender`, `contact` or `event`.
        what: &'static str,
        /// The index given.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// An unknown name.
    NoSuchName {
        /// `body` or `fender`.
        what: &'static str,
        /// The name given.
        name: String,
    },
    /// A state, a load or a time step is out of range, or their number is wrong.
    Input(StepError),
    /// A step gave forces or states that are not finite: the step is far too long for the bodies' states.
    NotFinite,
    /// A step was asked for before the state of a floating body was set.
    StateNotSet {
        /// The body.
        body: String,
    },
    /// Results were asked for before the first step.
    NoStepYet,
    /// The call asks for something that is not available with the engine's settings.
    NotAvailable(&'static str),
    /// The bytes to restore are not a saved engine, or belong to another model.
    Restore(RestoreError),
    /// The saved engine has the same model, but other settings.
    OtherSettings,
    /// The keys of a fender have a mistake for which a scenario would be refused, or a line has no `=`.
    Keys(Box<ScenarioError>),
    /// `on` or `material` is missing among the keys of a fender.
    MissingKey {
        /// The fender.
        fender: String,
        /// The key.
        key: &'static str,
    },
    /// A dump was asked for of an engine that is not recorded.
    NotRecorded,
    /// The bytes are not a complete, unchanged dump.
    Dump(RestoreError),
    /// The dump was written by another version of the library, in a format that this version does not read.
    DumpVersion {
        /// The version of the library that wrote the dump.
        library: String,
    },
    /// The given points make no outline.
    Points(&'static str),
}

impl fmt::Display for EngineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EngineError::Setup(error) => error.fmt(f),
            EngineError::Outline { body, error } => {
                write!(f, "the outline of body `{body}` is not valid: {error}")
            }
            EngineError::Settings(why) | EngineError::NotAvailable(why) => f.write_str(why),
            EngineError::Name { what, name, why } => {
                write!(f, "the name `{name}` of a {what} {why}")
            }
            EngineError::NoSuch { what, index, count } => {
                write!(
                    f,
                    "there is no {what} with index {index}: there are {count}, counted from 0"
                )
            }
            EngineError::NoSuchName { what, name } => write!(f, "no {what} is named `{name}`"),
            EngineError::Input(error) => error.fmt(f),
            EngineError::NotFinite => f.write_str(
                "the step gives forces or states that are not finite: the step is far too long \
                 for these states",
            ),
            EngineError::StateNotSet { body } => {
                write!(f, "the host has not set the state of body `{body}`, which floats")
            }
            EngineError::NoStepYet => {
                f.write_str("there are no results: the engine has not taken a step")
            }
            EngineError::Restore(error) => error.fmt(f),
            EngineError::Keys(error) => error.fmt(f),
            EngineError::MissingKey { fender, key } => {
                write!(
                    f,
                    "the keys of fender `{fender}` lack `{key}=`, the name of its {}",
                    match *key {
                        "on" => "body",
                        other => other,
                    }
                )
            }
            EngineError::NotRecorded => {
                f.write_str("the engine records no steps: start the recording before the steps")
            }
            EngineError::Dump(RestoreError::NotASnapshot) => {
                f.write_str("these bytes are not a dump of an engine")
            }
            EngineError::Dump(RestoreError::OtherModel) => {
                f.write_str("the dump's model and its saved engine do not belong together")
            }
            EngineError::Dump(RestoreError::Version { found }) => {
                write!(f, "dumps of version {found} are not supported")
            }
            EngineError::Dump(RestoreError::Checksum) => {
                f.write_str("the dump's checksum does not match: the dump was changed or cut")
            }
            EngineError::Dump(_) => f.write_str("the dump is truncated or has impossible content"),
            EngineError::DumpVersion { library } => {
                write!(f, "the dump was written by version {library}: replay it with that version")
            }
            EngineError::Points(why) => f.write_str(why),
            EngineError::OtherSettings => f.write_str(
                "the saved engine has another contact method, another kind of host or another \
                 delay of the host's states",
            ),
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
