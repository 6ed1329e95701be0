//! Errors of a track.

use std::fmt;

use crate::range::OutOfRange;

/// A track that no ship can follow.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TrackError {
    /// A number outside its range.
    OutOfRange(OutOfRange),
    /// Fewer than two waypoints.
    TooFew,
    /// A waypoint is less than a metre from the one before it, by its index.
    Near {
        /// Its index.
        waypoint: usize,
    },
    /// The legs at a waypoint are too short for a bend of this radius, or she would turn round on the spot.
    Bend {
        /// Its index.
        waypoint: usize,
        /// The largest radius that fits (m); 0 where she turns back.
        most_m: f64,
    },
    /// The times of speeds do not increase.
    NotLater {
        /// Index of the first that is not later than the one before it.
        entry: usize,
    },
}

impl fmt::Display for TrackError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TrackError::OutOfRange(error) => error.fmt(f),
            TrackError::TooFew => f.write_str("a track needs two waypoints or more"),
            TrackError::Near { waypoint } => {
                write!(f, "waypoint {waypoint} is less than a metre from the one before it")
            }
            TrackError::Bend { waypoint, most_m } if *most_m < 1.0 => {
                write!(f, "the track turns back at waypoint {waypoint}")
            }
            TrackError::Bend { waypoint, most_m } => {
                let most_m = libm::floor(*most_m);
                write!(
                    f,
                    "the legs at waypoint {waypoint} have room for a turning radius of {most_m} m at most"
                )
            }
            TrackError::NotLater { entry } => {
                write!(f, "speed {entry} is not later than the one before it")
            }
        }
    }
}

impl std::error::Error for TrackError {}

impl From<OutOfRange> for TrackError {
    fn from(error: OutOfRange) -> TrackError {
        TrackError::OutOfRange(error)
    }
}
