//! Errors of anchors.

use std::fmt;

use crate::range::OutOfRange;

/// Error of an anchor that cannot be simulated.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum AnchorError {
    /// A number of the anchor is outside its range.
    OutOfRange {
        /// The anchor.
        anchor: String,
        /// The number.
        error: OutOfRange,
    },
    /// At the start the anchor is on the bottom, but the environment gives no depth.
    NoBottom {
        /// The anchor.
        anchor: String,
    },
    /// At the start the anchor is on the bottom, but farther away than its chain reaches.
    ChainTooShort {
        /// The anchor.
        anchor: String,
        /// Chain out (m).
        chain_m: f64,
        /// Distance from the hawse pipe to the anchor (m).
        reach_m: f64,
    },
}

impl fmt::Display for AnchorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            AnchorError::OutOfRange { anchor, error } => write!(f, "anchor `{anchor}`: {error}"),
            AnchorError::NoBottom { anchor } => write!(
                f,
                "anchor `{anchor}` is on the bottom at the start, but the water is deep: give the environment a depth"
            ),
            AnchorError::ChainTooShort { anchor, chain_m, reach_m } => write!(
                f,
                "anchor `{anchor}` has {chain_m:.1} m of chain out at the start, but is {reach_m:.1} m from the hawse pipe"
            ),
        }
    }
}

impl std::error::Error for AnchorError {}
