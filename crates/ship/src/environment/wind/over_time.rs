//! The wind as a function of time and height.

use fenderline_contact::{Vec2, vec2};

use super::admittance::WindFront;
use super::gust::Gusts;
use super::mean::{MeanWind, WindProfile};
use super::series::WindSeries;
use crate::environment::error::EnvironmentError;

/// Direction that a wind blows towards, north and east.
fn towards(from_rad: f64) -> Vec2 {
    vec2(-libm::cos(from_rad), -libm::sin(from_rad))
}

/// A wind: a steady mean wind, with or without gusts, or a time series.
#[derive(Clone, Debug, PartialEq)]
pub struct Wind(Kind);

#[derive(Clone, Debug, PartialEq)]
enum Kind {
    Mean(MeanWind, Option<Gusts>),
    Series(WindSeries),
}

impl Wind {
    /// A steady wind.
    ///
    /// # Errors
    /// See [`MeanWind::check`].
    pub fn steady(mean: MeanWind) -> Result<Wind, EnvironmentError> {
        mean.check()?;
        Ok(Wind(Kind::Mean(mean, None)))
    }

    /// A wind with gusts. In a wind with gusts, the gusts change the speed but not the direction. The force of gusts on
    /// a ship follows from the mean of the gusts over her front ([`Wind::velocity_over`]), unless the gusts are
    /// [`Gusts::uniform`].
    ///
    /// # Errors
    /// See [`MeanWind::check`].
    pub fn with_gusts(mean: MeanWind, gusts: Gusts) -> Result<Wind, EnvironmentError> {
        mean.check()?;
        Ok(Wind(Kind::Mean(mean, Some(gusts))))
    }

    /// This wind, but with another mean speed 10 m above the water (m/s), and another direction from which it comes
    /// (rad). The profile stays. The gusts of the wind stay, scaled to the new mean speed as their spectrum says. A
    /// wind that is a time series becomes a steady wind.
    ///
    /// # Errors
    /// See [`MeanWind::check`].
    pub fn changed_to(&self, speed_mps: f64, from_rad: f64) -> Result<Wind, EnvironmentError> {
        match &self.0 {
            Kind::Mean(mean, gusts) => {
                let mean = MeanWind { speed_mps, from_rad, ..*mean };
                mean.check()?;
                let gusts = gusts.as_ref().map(|gusts| gusts.about(&mean)).transpose()?;
                Ok(Wind(Kind::Mean(mean, gusts)))
            }
            Kind::Series(_) => {
                Wind::steady(MeanWind { speed_mps, from_rad, profile: WindProfile::Uniform })
            }
        }
    }

    /// Whether a time (s) is before the first or after the last point of a time series of wind; the wind of that point
    /// is then used.
    #[must_use]
    pub fn is_held(&self, t_s: f64) -> bool {
        match &self.0 {
            Kind::Mean(..) => false,
            Kind::Series(series) => series.is_held(t_s),
        }
    }

    /// Makes a wind from a time series, the same at every height.
    #[must_use]
    pub fn series(series: WindSeries) -> Wind {
        Wind(Kind::Series(series))
    }

    /// Wind speed without gusts 10 m above the water (m/s), and direction from which the wind comes, clockwise from
    /// north (rad), at a time.
    #[must_use]
    pub fn mean_at(&self, t_s: f64) -> (f64, f64) {
        match &self.0 {
            Kind::Mean(mean, _) => (mean.speed_mps, mean.from_rad),
            Kind::Series(series) => series.at(t_s),
        }
    }

    /// True if the wind is a time series.
    #[must_use]
    pub fn is_series(&self) -> bool {
        matches!(self.0, Kind::Series(_))
    }

    /// Velocity of the air at a height above the water and a time, north and east (m/s).
    #[must_use]
    pub fn velocity(&self, height_m: f64, t_s: f64) -> Vec2 {
        self.velocity_over(&WindFront::POINT, height_m, t_s)
    }

    /// Velocity of the air, with the gusts averaged over a ship's front (m/s).
    #[must_use]
    pub fn velocity_over(&self, front: &WindFront, height_m: f64, t_s: f64) -> Vec2 {
        let gust = |gusts: &Gusts| gusts.speed_over_mps(front, t_s);
        self.velocity_in(self.gusts().map_or(0.0, gust), height_m, t_s)
    }

    /// The gusts of the wind; `None` for a wind without gusts.
    #[must_use]
    pub fn gusts(&self) -> Option<&Gusts> {
        match &self.0 {
            Kind::Mean(_, gusts) => gusts.as_ref(),
            Kind::Series(_) => None,
        }
    }

    /// Velocity of the air in a gust that changes the wind speed by the given amount (m/s). A wind that is a time
    /// series has no gusts of its own.
    pub fn velocity_in(&self, gust_mps: f64, height_m: f64, t_s: f64) -> Vec2 {
        match &self.0 {
            Kind::Mean(mean, _) => towards(mean.from_rad) * (mean.speed_at(height_m) + gust_mps),
            Kind::Series(series) => {
                let (speed_mps, from_rad) = series.at(t_s);
                towards(from_rad) * speed_mps
            }
        }
    }
}
