//! Errors in a host's input. After an error the engine is unchanged.

use std::fmt;

use fenderline_contact::{OutlineError, RestoreError, StepError};
use fenderline_scenario::ScenarioError;
use fenderline_sim::SetupError;

/// A call that an engine refuses.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum EngineError {
    /// The bodies, materials, pairs and fenders are not a valid contact problem.
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
    /// A name that is empty or already used.
    Name {
        /// `body`, `material` or `fender`.
        what: &'static str,
        /// The name.
        name: String,
        /// What is wrong with the name.
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
    /// An unknown name.
    NoSuchName {
        /// `body` or `fender`.
        what: &'static str,
        /// The name given.
        name: String,
    },
    /// A state, a load or a time step out of range, or a wrong number of them.
    Input(StepError),
    /// A step with non-finite forces or states: the step is far too long for these states.
    NotFinite,
    /// A step before the state of a floating body was set.
    StateNotSet {
        /// The body.
        body: String,
    },
    /// Results before the first step.
    NoStepYet,
    /// Not available with the engine's settings.
    NotAvailable(&'static str),
    /// Bytes that are not a saved engine, or that belong to another model.
    Restore(RestoreError),
    /// A saved engine of the same model with other settings.
    OtherSettings,
    /// Keys of a fender that a scenario would refuse; or a line without `=`.
    Keys(Box<ScenarioError>),
    /// `on` or `material` is missing among the keys of a fender.
    MissingKey {
        /// The fender.
        fender: String,
        /// The key.
        key: &'static str,
    },
    /// A dump of an engine that is not recorded.
    NotRecorded,
    /// Bytes that are not a complete, unchanged dump.
    Dump(RestoreError),
    /// A dump by another version of the library, with a format that this version does not read.
    DumpVersion {
        /// The version of the library that wrote the dump.
        library: String,
    },
    /// Points from which no outline can be made.
    Points(&'static str),
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
                write!(f, "the state of body `{body}` was never set")
            }
            EngineError::NoStepYet => f.write_str("there are no results: no step was taken"),
            EngineError::Restore(error) => error.fmt(f),
            EngineError::Keys(error) => error.fmt(f),
            EngineError::MissingKey { fender, key } => {
                write!(f, "the keys of fender `{fender}` lack `{key}=`, the name of its {}", match *key {
                    "on" => "body",
                    other => other,
                })
            }
            EngineError::NotRecorded => {
                f.write_str("the engine is not recorded: start the recording before the steps")
            }
            EngineError::Dump(RestoreError::NotASnapshot) => {
                f.write_str("these bytes are not a dump of an engine")
            }
            EngineError::Dump(RestoreError::OtherModel) => {
                f.write_str("the dump's model and its saved state do not belong together")
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
