//! Gusts: a spectrum as a seeded sum of harmonics.

use core::f64::consts::TAU;

use super::mean::MeanWind;
use super::spectrum::GustSpectrum;
use crate::environment::error::EnvironmentError;
use crate::environment::harmonics::{Harmonic, Realisation};

/// Frequency band of the gusts (Hz): from one per hour to one in two seconds. Ships do not respond to faster ones.
const BAND_HZ: [f64; 2] = [1.0 / 3600.0, 0.5];

/// The fluctuation of the wind speed about its mean, a pure function of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Gusts {
    harmonics: Vec<Harmonic>,
}

impl Gusts {
    /// Gusts about a mean wind from a spectrum, in the band from 1/3600 to 0.5 Hz. A mean wind of zero has no gusts.
    ///
    /// # Errors
    /// A number of the wind, the spectrum or the realisation is out of range.
    pub fn new(
        mean: &MeanWind,
        spectrum: &GustSpectrum,
        realisation: Realisation,
    ) -> Result<Gusts, EnvironmentError> {
        mean.check()?;
        spectrum.check()?;
        realisation.check()?;
        if mean.speed_mps == 0.0 {
            return Ok(Gusts { harmonics: vec![] });
        }
        let density = |f_hz| spectrum.density(f_hz, mean.speed_mps);
        Ok(Gusts { harmonics: realisation.harmonics_of(density, BAND_HZ[0], BAND_HZ[1]) })
    }

    /// Difference from the mean speed at a time (m/s).
    #[must_use]
    pub fn speed_mps(&self, t_s: f64) -> f64 {
        let speeds = self
            .harmonics
            .iter()
            .map(|h| h.amplitude * libm::cos(TAU * h.frequency * t_s + h.phase_rad));
        speeds.sum()
    }

    /// Standard deviation of the speed (m/s): √Σ½a².
    #[must_use]
    pub fn deviation_mps(&self) -> f64 {
        self.harmonics.iter().map(|h| 0.5 * h.amplitude * h.amplitude).sum::<f64>().sqrt()
    }
}
