//! Errors of mooring lines.

use std::fmt;

use fenderline_contact::DisplayNumber;

use crate::range::OutOfRange;

/// A line that cannot be simulated.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MooringError {
    /// A number outside its range.
    OutOfRange {
        /// The line.
        line: String,
        /// The number.
        error: OutOfRange,
    },
    /// The line is shorter than the distance between its ends.
    TooShort {
        /// The line.
        line: String,
        /// Length of the line (m).
        length_m: f64,
        /// Distance between the ends of the line (m).
        span_m: f64,
    },
    /// A pretension that cannot be reached. The pretension is above the break load or above the winch's render tension,
    /// it is below the tension by the line's own weight, or it would leave less than the tail outboard.
    Pretension {
        /// The line.
        line: String,
        /// The tension (N).
        tension_n: f64,
    },
}

impl fmt::Display for MooringError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MooringError::OutOfRange { line, error } => write!(f, "line `{line}`: {error}"),
            MooringError::TooShort { line, length_m, span_m } => write!(
                f,
                "line `{line}` is {length_m} m long, but its ends are {span_m} m apart; make it longer or \
                 give a pretension instead"
            ),
            MooringError::Pretension { line, tension_n } => {
                write!(
                    f,
                    "line `{line}` cannot have a pretension of {} N",
                    DisplayNumber(*tension_n)
                )
            }
        }
    }
}

impl std::error::Error for MooringError {}

/// A rope's curve that does not start at (0, 0), does not increase, or goes beyond 10 in strain or load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RopeError {
    /// Index of the first point that is wrong or missing.
    pub point: usize,
}

impl fmt::Display for RopeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the points of a rope's curve must start at (0, 0) and increase, but point {} does not",
            self.point
        )
    }
}

impl std::error::Error for RopeError {}
