//! The level of the water above datum over time.

use fenderline_contact::number::{greater, lesser};

use core::f64::consts::TAU;

use super::error::EnvironmentError;
use super::table::{check_axis, place};
use crate::range::within;

/// The level of the water above datum over time. Datum is what charted depths count down from and heights of
/// what is ashore count up from.
#[derive(Clone, Debug, PartialEq)]
pub enum Tide {
    /// Always the same (m).
    Level(f64),
    /// Points (t (s), level (m)), with straight lines between them; held before the first and beyond the
    /// last.
    Curve(Vec<[f64; 2]>),
    /// A mean level (m) and constituents about it.
    Harmonic {
        /// Mean level (m).
        mean_m: f64,
        /// Summed in the order given.
        constituents: Vec<TideConstituent>,
    },
}

/// One constituent of a tide: amplitude · cos(2πt/period − lag).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TideConstituent {
    /// Amplitude (m).
    pub amplitude_m: f64,
    /// Period (s); 44 714 s for M2 (12.4206012 h, as programs for tides list it).
    pub period_s: f64,
    /// Phase lag at t = 0 (rad).
    pub lag_rad: f64,
}

impl Default for Tide {
    /// The water stands at datum.
    fn default() -> Tide {
        Tide::Level(0.0)
    }
}

impl Tide {
    /// Checks every number.
    ///
    /// # Errors
    /// The first that no water has, by its name.
    pub fn check(&self) -> Result<(), EnvironmentError> {
        match self {
            Tide::Level(level_m) => {
                within("level of the tide [m]", *level_m, -30.0, 30.0)?;
            }
            Tide::Curve(points) => {
                check_axis("times of the tide [s]", points.iter().map(|p| p[0]), 1)?;
                for point in points {
                    within("level of the tide [m]", point[1], -30.0, 30.0)?;
                }
            }
            Tide::Harmonic { mean_m, constituents } => {
                within("mean level of the tide [m]", *mean_m, -30.0, 30.0)?;
                for c in constituents {
                    within("amplitude of a constituent [m]", c.amplitude_m, 0.0, 30.0)?;
                    within("period of a constituent [s]", c.period_s, 60.0, 1e9)?;
                    within("lag of a constituent [rad]", c.lag_rad, -100.0, 100.0)?;
                }
            }
        }
        Ok(())
    }

    /// Level above datum (m).
    #[must_use]
    pub fn level_m(&self, t_s: f64) -> f64 {
        match self {
            Tide::Level(level_m) => *level_m,
            Tide::Curve(points) => {
                let at = place(points.len(), |i| points[i][0], t_s);
                let (low, high) = (points[at.low][1], points[at.high][1]);
                low + at.share * (high - low)
            }
            Tide::Harmonic { mean_m, constituents } => {
                constituents.iter().fold(*mean_m, |level_m, c| {
                    level_m + c.amplitude_m * libm::cos(TAU * t_s / c.period_s - c.lag_rad)
                })
            }
        }
    }

    /// The lowest and the highest level that it may come to from the start on (m); of a sum of constituents, if
    /// ever all are at their ends together.
    #[must_use]
    pub fn range_m(&self) -> [f64; 2] {
        match self {
            Tide::Level(level_m) => [*level_m; 2],
            Tide::Curve(points) => {
                let start_m = self.level_m(0.0);
                let later = points.iter().filter(|point| point[0] > 0.0);
                later.fold([start_m; 2], |[low, high], p| [lesser(low, p[1]), greater(high, p[1])])
            }
            Tide::Harmonic { mean_m, constituents } => {
                let reach_m: f64 = constituents.iter().map(|c| c.amplitude_m).sum();
                [mean_m - reach_m, mean_m + reach_m]
            }
        }
    }
}
