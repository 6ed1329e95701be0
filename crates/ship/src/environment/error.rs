//! Errors of an environment.

use std::fmt;

use crate::range::OutOfRange;

/// Error of an environment (wind, waves, current or tide) that cannot be simulated.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum EnvironmentError {
    /// A number of the environment is outside its range.
    OutOfRange(OutOfRange),
    /// The entries of a table's axis do not increase.
    NotIncreasing {
        /// The axis.
        axis: &'static str,
        /// Index of the first entry of the axis that is not greater than the entry before it.
        entry: usize,
    },
    /// A table has the wrong number of entries.
    Length {
        /// The table.
        table: &'static str,
        /// Number of entries that the table needs; for an axis, the least number.
        expected: usize,
        /// Number of entries given.
        found: usize,
    },
    /// The environment has both one depth for all places and a depth that differs by place.
    TwoDepths,
    /// No entry of a table has data.
    NoData {
        /// The table.
        table: &'static str,
    },
}

impl fmt::Display for EnvironmentError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EnvironmentError::OutOfRange(error) => error.fmt(f),
            EnvironmentError::NotIncreasing { axis, entry } => {
                write!(f, "{axis} must increase, but entry {entry} does not")
            }
            EnvironmentError::Length { table, expected, found } => {
                write!(f, "{table} needs {expected} entries, but has {found}")
            }
            EnvironmentError::TwoDepths => {
                write!(
                    f,
                    "the water has both one depth and a depth by place: give only one of the two"
                )
            }
            EnvironmentError::NoData { table } => write!(f, "{table} has no data"),
        }
    }
}

impl std::error::Error for EnvironmentError {}

impl From<OutOfRange> for EnvironmentError {
    fn from(error: OutOfRange) -> EnvironmentError {
        EnvironmentError::OutOfRange(error)
    }
}
