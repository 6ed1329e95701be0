//! The water a ship lies in: charted depth, density and the level over time.

use core::f64::consts::TAU;

use super::error::EnvironmentError;
use super::table::{check_axis, place};
use crate::range::within;

/// Depth, density and tide of one place.
#[derive(Clone, Debug, PartialEq)]
pub struct Water {
    /// Depth below chart datum [m].
    pub charted_depth_m: f64,
    /// Density [kg/m³]: 1025 for sea water, 1000 for fresh water.
    pub density_kgpm3: f64,
    /// Level above chart datum.
    pub tide: Tide,
}

/// The level of the water above chart datum over time.
#[derive(Clone, Debug, PartialEq)]
pub enum Tide {
    /// Always the same [m].
    Level(f64),
    /// Points (t [s], level [m]), with straight lines between them; held before the first and beyond the
    /// last.
    Curve(Vec<[f64; 2]>),
    /// A mean level [m] and constituents about it.
    Harmonic {
        /// Mean level [m].
        mean_m: f64,
        /// Summed in the order given.
        constituents: Vec<TideConstituent>,
    },
}

/// One constituent of a tide: amplitude · cos(2πt/period − lag).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TideConstituent {
    /// Amplitude [m].
    pub amplitude_m: f64,
    /// Period [s]; 44 714 s for M2 (12.4206 h, recalled).
    pub period_s: f64,
    /// Phase lag at t = 0 [rad].
    pub lag_rad: f64,
}

impl Water {
    /// Checks every number.
    ///
    /// # Errors
    /// The first that no water has, by its name.
    pub fn check(&self) -> Result<(), EnvironmentError> {
        within("charted depth [m]", self.charted_depth_m, -100.0, 12_000.0)?;
        within("density of the water [kg/m³]", self.density_kgpm3, 900.0, 1300.0)?;
        match &self.tide {
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

    /// Level above chart datum [m].
    #[must_use]
    pub fn level_m(&self, t_s: f64) -> f64 {
        match &self.tide {
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

    /// Depth of the water [m]: charted depth and level; 0 where the bottom falls dry.
    #[must_use]
    pub fn depth_m(&self, t_s: f64) -> f64 {
        (self.charted_depth_m + self.level_m(t_s)).max(0.0)
    }
}
