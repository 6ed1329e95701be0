//! Gusts: a spectrum as a seeded sum of harmonics.

use core::f64::consts::TAU;

use super::mean::MeanWind;
use super::spectrum::GustSpectrum;
use crate::environment::error::EnvironmentError;
use crate::environment::harmonics::{Harmonic, Realisation};

/// The band of a gust record (Hz): from one gust an hour to one in two seconds; no ship follows faster ones.
const BAND_HZ: [f64; 2] = [1.0 / 3600.0, 0.5];

/// The part of the wind's speed that changes; a pure function of time.
#[derive(Clone, Debug, PartialEq)]
pub struct Gusts {
    harmonics: Vec<Harmonic>,
}

impl Gusts {
    /// Gusts about a mean wind by a spectrum, in the band from 1/3600 to 0.5 Hz. No wind has no gusts.
    ///
    /// # Errors
    /// A wind, a spectrum or a number of harmonics that is none.
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

    /// Speed above the mean at a time (m/s).
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
