//! Tide: the water level above datum as a function of time.

use fenderline_contact::number::{greater, lesser};

use core::f64::consts::TAU;

use super::error::EnvironmentError;
use super::table::{check_axis, is_off, place};
use crate::range::within;

/// The water level above datum as a function of time. Charted depths are measured downwards from datum, and heights
/// ashore upwards from it.
#[derive(Clone, Debug, PartialEq)]
pub enum Tide {
    /// Constant (m).
    Level(f64),
    /// Points of the tide curve (time (s), level (m)): linear between them, and constant before the first point and
    /// after the last.
    Curve(Vec<[f64; 2]>),
    /// The tide is a mean level and harmonic constituents.
    Harmonic {
        /// Mean level (m).
        mean_m: f64,
        /// Constituents of the tide, which are summed in the order of this list.
        constituents: Vec<TideConstituent>,
    },
}

/// One constituent of a tide: amplitude · cos(2πt/period − lag).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TideConstituent {
    /// Amplitude (m).
    pub amplitude_m: f64,
    /// Period of the constituent (s), such as 44 714 s for M2 (12.4206012 h, as tide programs list it).
    pub period_s: f64,
    /// Phase lag of the constituent at t = 0 (rad).
    pub lag_rad: f64,
}

impl Default for Tide {
    /// Water at datum.
    fn default() -> Tide {
        Tide::Level(0.0)
    }
}

impl Tide {
    /// Checks every number.
    ///
    /// # Errors
    /// Fails at the first number of the tide that is out of range.
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

    /// Whether a time (s) is before the first or after the last point of a tide curve; the level of that point is then
    /// used. A tide curve with a single point is a constant level.
    #[must_use]
    pub fn is_held(&self, t_s: f64) -> bool {
        match self {
            Tide::Level(_) | Tide::Harmonic { .. } => false,
            Tide::Curve(points) => is_off(points.len(), |i| points[i][0], t_s),
        }
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

    /// Lowest and highest level of the tide from the start of the run (m). For harmonic constituents the lowest and the
    /// highest level assume that all constituents reach their extremes at the same time.
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
