//! The mean wind and how its speed varies with height.

use fenderline_contact::number::greater;

use crate::range::{OutOfRange, within};

/// Height above the water to which given wind speeds refer (m).
pub(super) const REFERENCE_HEIGHT_M: f64 = 10.0;

/// A steady wind: speed and direction at 10 m height, and a profile.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanWind {
    /// Mean wind speed 10 m above the water (m/s).
    pub speed_mps: f64,
    /// Direction from which the wind comes, clockwise from north (rad).
    pub from_rad: f64,
    /// Profile over height.
    pub profile: WindProfile,
}

/// Profile of the mean wind over height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WindProfile {
    /// The wind speed is the same at every height.
    Uniform,
    /// The power law U(z) = U₁₀ (z/10)^exponent for the wind speed U at a height z; an exponent of 1/7 is customary on
    /// land. The exponent over open water is 0.10 in neutral air, 0.06 in unstable and 0.27 in stable air (Hellmann's
    /// exponents as the library pvlib lists them).
    Power {
        /// Exponent.
        exponent: f64,
    },
    /// The logarithmic law U(z) = U₁₀ ln(z/z₀)/ln(10/z₀) for the wind speed U at a height z.
    Logarithmic {
        /// Roughness length z₀ (m); 0.0002 m over open sea (class 1 of Davenport and Wieringa, read in the crate
        /// wind-profile).
        roughness_m: f64,
    },
}

impl MeanWind {
    /// The fastest mean wind that is accepted (m/s). The strongest gust on record has about 113 m/s (from memory).
    pub const FASTEST_MPS: f64 = 120.0;

    /// Checks every number.
    ///
    /// # Errors
    /// Fails for a wind speed above [`MeanWind::FASTEST_MPS`], or a profile parameter out of range.
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

    /// Mean wind speed at a height (m/s). The wind profiles are not valid close to the surface: below 1 m the speed is
    /// that at 1 m.
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
