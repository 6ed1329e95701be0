//! Reasons why a change cannot be carried out.

use std::fmt;

use fenderline_ship::environment::EnvironmentError;
use fenderline_ship::range::OutOfRange;

/// The reason why a change cannot be carried out.
#[derive(Clone, Debug, PartialEq)]
pub enum ChangeError {
    /// A number is out of its limits.
    OutOfRange(OutOfRange),
    /// The wind or the current is out of its limits.
    Environment(EnvironmentError),
    /// The set-up has no vessel, thruster, line or tug with the index that the change gives.
    NotThere(&'static str),
    /// The line is not fast, so the line cannot part.
    NotFast {
        /// Name of the line.
        line: String,
    },
}

impl fmt::Display for ChangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ChangeError::OutOfRange(error) => error.fmt(f),
            ChangeError::Environment(error) => error.fmt(f),
            ChangeError::NotThere(what) => write!(f, "the set-up has no {what} of this index"),
            ChangeError::NotFast { line } => {
                write!(f, "line {line} is not fast, so it cannot part")
            }
        }
    }
}

impl std::error::Error for ChangeError {}

impl From<OutOfRange> for ChangeError {
    fn from(error: OutOfRange) -> ChangeError {
        ChangeError::OutOfRange(error)
    }
}

impl From<EnvironmentError> for ChangeError {
    fn from(error: EnvironmentError) -> ChangeError {
        ChangeError::Environment(error)
    }
}
