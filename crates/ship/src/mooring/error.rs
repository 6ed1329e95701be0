//! Errors of mooring lines.

use std::fmt;

use fenderline_contact::DisplayNumber;

use crate::range::OutOfRange;

/// Error of a mooring line that cannot be simulated.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum MooringError {
    /// A number of the line is outside its range.
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
    /// The line has a pretension that cannot be reached. The pretension is too high (above the break load or the
    /// winch's render tension, or so high that less than the tail would be outboard) or too low (below the tension by
    /// the line's own weight).
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
                "line `{line}` is {length_m} m long, but its ends are {span_m} m apart; make the \
                 line longer or give a pretension instead"
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

/// Error of a rope's load curve that does not start at (0, 0), does not increase, or goes beyond 10 in strain or load.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RopeError {
    /// Index of the first point of the load curve that is wrong or missing.
    pub point: usize,
}

impl fmt::Display for RopeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "the points of a rope's load curve must start at (0, 0) and increase, but point {} \
             does not",
            self.point
        )
    }
}

impl std::error::Error for RopeError {}
