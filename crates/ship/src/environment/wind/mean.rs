//! The mean wind, its profile over height, and the wind as a function of time.

use fenderline_contact::number::greater;
use fenderline_contact::{Vec2, vec2};

use super::admittance::WindFront;
use super::gust::Gusts;
use super::series::WindSeries;
use crate::environment::error::EnvironmentError;
use crate::range::{OutOfRange, within};

/// Reference height of wind speeds (m).
pub(super) const REFERENCE_HEIGHT_M: f64 = 10.0;

/// A steady wind: speed and direction at 10 m height, and a profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanWind {
    /// Mean speed 10 m above the water (m/s).
    pub speed_mps: f64,
    /// Direction from which it comes, clockwise from north (rad).
    pub from_rad: f64,
    /// Profile over height.
    pub profile: WindProfile,
}

/// Profile of the mean wind over height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WindProfile {
    /// The same at every height.
    Uniform,
    /// U(z) = U₁₀ (z/10)^exponent; 1/7 is customary on land. Over open water 0.10 in neutral air, 0.06 where it is unstable,
    /// 0.27 where it is stable (Hellmann's exponents as the library pvlib lists them).
    Power {
        /// Exponent.
        exponent: f64,
    },
    /// U(z) = U₁₀ ln(z/z₀)/ln(10/z₀), the logarithmic law.
    Logarithmic {
        /// z₀ (m); 0.0002 m over open sea (class 1 of Davenport and Wieringa, read in the crate wind-profile).
        roughness_m: f64,
    },
}

impl MeanWind {
    /// The fastest mean wind that is accepted (m/s). The strongest gust on record is about 113 m/s (recalled).
    pub const FASTEST_MPS: f64 = 120.0;

    /// Checks every number.
    ///
    /// # Errors
    /// A wind speed above [`MeanWind::FASTEST_MPS`], or a profile parameter out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        within("wind speed [m/s]", self.speed_mps, 0.0, Self::FASTEST_MPS)?;
        within("wind direction [rad]", self.from_rad, -100.0, 100.0)?;
        match self.profile {
            WindProfile::Uniform => {}
            WindProfile::Power { exponent } => {
                within("exponent of the wind profile", exponent, 0.0, 1.0)?;
            }
            WindProfile::Logarithmic { roughness_m } => {
                within("roughness length [m]", roughness_m, 1e-6, 0.5)?;
            }
        }
        Ok(())
    }

    /// Mean speed at a height (m/s). The profiles are not valid close to the surface: below 1 m the speed is that at 1 m.
    #[must_use]
    pub fn speed_at(&self, height_m: f64) -> f64 {
        let z_m = greater(height_m, 1.0);
        let factor = match self.profile {
            WindProfile::Uniform => 1.0,
            WindProfile::Power { exponent } => libm::pow(z_m / REFERENCE_HEIGHT_M, exponent),
            WindProfile::Logarithmic { roughness_m } => {
                libm::log(z_m / roughness_m) / libm::log(REFERENCE_HEIGHT_M / roughness_m)
            }
        };
        self.speed_mps * factor
    }
}

/// Direction that a wind blows towards, north and east.
fn towards(from_rad: f64) -> Vec2 {
    vec2(-libm::cos(from_rad), -libm::sin(from_rad))
}

/// A wind: a steady mean with or without gusts, or a time series.
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

    /// A wind with gusts. Gusts change the speed but not the direction. A ship feels their mean over her front
    /// ([`Wind::velocity_over`]), unless they are [`Gusts::uniform`].
    ///
    /// # Errors
    /// See [`MeanWind::check`].
    pub fn with_gusts(mean: MeanWind, gusts: Gusts) -> Result<Wind, EnvironmentError> {
        mean.check()?;
        Ok(Wind(Kind::Mean(mean, Some(gusts))))
    }

    /// This wind with another mean speed 10 m above the water (m/s) and direction from which it comes (rad): its profile and its gusts
    /// stay, in proportion to the new mean as their spectrum says. A time series becomes a steady wind.
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

    /// Whether a time (s) is before the first or after the last point of a time series, whose wind is then held.
    #[must_use]
    pub fn is_held(&self, t_s: f64) -> bool {
        match &self.0 {
            Kind::Mean(..) => false,
            Kind::Series(series) => series.is_held(t_s),
        }
    }

    /// A wind from a time series, the same at every height.
    #[must_use]
    pub fn series(series: WindSeries) -> Wind {
        Wind(Kind::Series(series))
    }

    /// Speed without gusts 10 m above the water (m/s), and direction from which it comes, clockwise from north (rad), at a
    /// time.
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

    /// The same, with the gusts averaged over a front.
    #[must_use]
    pub fn velocity_over(&self, front: &WindFront, height_m: f64, t_s: f64) -> Vec2 {
        let gust = |gusts: &Gusts| gusts.speed_over_mps(front, t_s);
        self.velocity_in(self.gusts().map_or(0.0, gust), height_m, t_s)
    }

    /// The gusts; `None` for a wind without.
    #[must_use]
    pub fn gusts(&self) -> Option<&Gusts> {
        match &self.0 {
            Kind::Mean(_, gusts) => gusts.as_ref(),
            Kind::Series(_) => None,
        }
    }

    /// Velocity of the air in a gust (m/s), which a time series does not have.
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
