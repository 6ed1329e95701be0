//! Errors of a track.

use std::fmt;

use crate::range::OutOfRange;

/// Reasons why no ship can follow a track.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum TrackError {
    /// A number of the track is outside its range.
    OutOfRange(OutOfRange),
    /// Fewer than two waypoints.
    TooFew,
    /// A waypoint is less than a metre from the waypoint before it.
    Near {
        /// Index of the waypoint.
        waypoint: usize,
    },
    /// The legs at a waypoint are too short for a bend of the given radius, or the ship would turn round on the spot.
    Bend {
        /// Index of the waypoint.
        waypoint: usize,
        /// The largest radius of a bend that fits (m); 0 if the track turns back.
        most_m: f64,
    },
    /// The times at which speeds are given do not increase.
    NotLater {
        /// Index of the first time of a speed that is not later than the time before it.
        entry: usize,
    },
}

impl fmt::Display for TrackError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            TrackError::OutOfRange(error) => error.fmt(f),
            TrackError::TooFew => f.write_str("a track needs two waypoints or more"),
            TrackError::Near { waypoint } => {
                write!(f, "waypoint {waypoint} is less than a metre from the waypoint before it")
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
                write!(f, "the time of speed {entry} is not later than that of the speed before it")
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
