//! Wind as a time series, measured or forecast.

use core::f64::consts::TAU;

use super::mean::MeanWind;
use crate::environment::error::EnvironmentError;
use crate::environment::table::{check_axis, is_off, place};
use crate::range::within;

/// Wind speed and direction 10 m above the water at given times: linear between them, and constant before the first and
/// after the last. Between two points of the series the wind direction turns the shorter way.
#[derive(Clone, Debug, PartialEq)]
pub struct WindSeries {
    /// Points of the series: time (s), wind speed (m/s), direction from which the wind comes (rad), unwrapped.
    points: Vec<[f64; 3]>,
}

impl WindSeries {
    /// Makes a time series of wind from points: time (s), speed (m/s), direction from which the wind comes, clockwise
    /// from north (rad).
    ///
    /// # Errors
    /// Fails if there is no point, if times do not increase, or if a wind is out of the range of
    /// [`super::MeanWind::check`].
    pub fn new(points: Vec<[f64; 3]>) -> Result<WindSeries, EnvironmentError> {
        check_axis("times of the wind [s]", points.iter().map(|p| p[0]), 1)?;
        let mut points = points;
        for index in 0..points.len() {
            let [_, speed_mps, from_rad] = points[index];
            within("wind speed [m/s]", speed_mps, 0.0, MeanWind::FASTEST_MPS)?;
            within("wind direction [rad]", from_rad, -100.0, 100.0)?;
            if index > 0 {
                let before_rad = points[index - 1][2];
                points[index][2] = before_rad + libm::remainder(from_rad - before_rad, TAU);
            }
        }
        Ok(WindSeries { points })
    }

    /// Whether a time (s) is before the first or after the last point of the series; the wind of that point is then
    /// used. A series of a single point is a steady wind.
    #[must_use]
    pub fn is_held(&self, t_s: f64) -> bool {
        is_off(self.points.len(), |i| self.points[i][0], t_s)
    }

    /// Wind speed (m/s) and direction from which the wind comes (rad) at a time.
    #[must_use]
    pub fn at(&self, t_s: f64) -> (f64, f64) {
        let at = place(self.points.len(), |i| self.points[i][0], t_s);
        let (low, high) = (self.points[at.low], self.points[at.high]);
        let mix = |k: usize| low[k] + at.share * (high[k] - low[k]);
        (mix(1), mix(2))
    }
}
