//! A measured ship that pages show beside the simulated ships. She takes part in nothing physical.

use std::fmt;

use serde::{Deserialize, Serialize};
#[cfg(test)]
use ts_rs::TS;

use crate::pair::Pair;

/// The track of a measured ship on the clock of the session. The recording of the session keeps the track.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(TS))]
#[serde(deny_unknown_fields)]
pub struct Ghost {
    /// Name of the ship in the log; empty if the log names none.
    pub ship: String,
    /// Name of the log, without folders.
    pub file: String,
    /// Corners of the hull in the ship's axes.
    pub outline: Vec<Pair>,
    /// The track, by time; pages go straight from point to point.
    #[cfg_attr(test, ts(type = "PathPoint[]"))]
    pub points: Vec<[f64; 4]>,
    /// Time of the first touch of a fender (s); `null` if the track has none.
    pub touch_s: Option<f64>,
}

/// Why a ghost cannot be shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GhostError {
    /// There are no points, or more than [`Ghost::MOST_POINTS`].
    Points(usize),
    /// There are fewer than three corners, or more than [`Ghost::MOST_CORNERS`].
    Corners(usize),
    /// Number of the point, from 0, whose time is not after that of the point before it.
    Order(usize),
}

impl fmt::Display for GhostError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            GhostError::Points(count) => {
                write!(
                    f,
                    "the measured track has {count} points, but must have 1 to {}",
                    Ghost::MOST_POINTS
                )
            }
            GhostError::Corners(count) => {
                write!(
                    f,
                    "the measured hull has {count} corners, but must have 3 to {}",
                    Ghost::MOST_CORNERS
                )
            }
            GhostError::Order(index) => {
                write!(
                    f,
                    "point {index} of the measured track is not later than the point before it"
                )
            }
        }
    }
}

impl std::error::Error for GhostError {}

impl Ghost {
    /// Largest number of points of a track.
    pub const MOST_POINTS: usize = 2000;
    /// Largest number of corners of a hull.
    pub const MOST_CORNERS: usize = 2000;

    /// Checks the sizes and the order of the times. Recordings may come from strangers.
    ///
    /// # Errors
    /// [`GhostError`].
    pub fn check(&self) -> Result<(), GhostError> {
        let (points, corners) = (self.points.len(), self.outline.len());
        if !(1..=Ghost::MOST_POINTS).contains(&points) {
            return Err(GhostError::Points(points));
        }
        if !(3..=Ghost::MOST_CORNERS).contains(&corners) {
            return Err(GhostError::Corners(corners));
        }
        let is_late = |two: &[[f64; 4]]| two[1][0] > two[0][0];
        match self.points.windows(2).position(|two| !is_late(two)) {
            Some(index) => Err(GhostError::Order(index + 1)),
            None => Ok(()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tracks_of_strangers_are_checked() {
        let good = Ghost {
            ship: String::new(),
            file: "log.csv".to_owned(),
            outline: vec![[1.0, 0.0], [-1.0, 1.0], [-1.0, -1.0]],
            points: vec![[0.0; 4], [1.0, 2.0, 3.0, 0.0]],
            touch_s: None,
        };
        assert_eq!(good.check(), Ok(()));
        let none = Ghost { points: vec![], ..good.clone() };
        assert_eq!(none.check(), Err(GhostError::Points(0)));
        let many = Ghost { points: vec![[0.0; 4]; 2001], ..good.clone() };
        assert_eq!(many.check(), Err(GhostError::Points(2001)));
        let thin = Ghost { outline: vec![[0.0; 2]; 2], ..good.clone() };
        assert_eq!(thin.check(), Err(GhostError::Corners(2)));
        let back = Ghost { points: vec![[1.0; 4], [1.0; 4]], ..good };
        assert_eq!(back.check(), Err(GhostError::Order(1)));
    }
}
