//! Gusts of wind, made from a spectrum as a sum of harmonics with random phases from a seed.

use super::admittance::WindFront;
use super::lanes::{self, Group};
use super::mean::MeanWind;
use super::spectrum::GustSpectrum;
use crate::environment::error::EnvironmentError;
use crate::environment::harmonics::{Harmonic, Realisation};

/// Frequency band of the gusts (Hz): from one gust per hour to one in two seconds. Ships do not respond to gusts that
/// are faster than one in two seconds.
const BAND_HZ: [f64; 2] = [1.0 / 3600.0, 0.5];

/// Gusts: the fluctuation of the wind speed about its mean. The fluctuation of the wind speed is a pure function of
/// time.
#[derive(Clone, Debug, PartialEq)]
pub struct Gusts {
    harmonics: Vec<Harmonic>,
    /// The harmonics of the gusts in groups, for fast sums.
    pub(super) groups: Vec<Group>,
    /// Mean wind (m/s).
    pub(super) mean_mps: f64,
    /// The spectrum from which the gusts were made. The spectrum is kept, because gusts about another mean wind are
    /// made from it.
    spectrum: GustSpectrum,
    realisation: Realisation,
    /// Whether each gust acts on the whole ship at once, instead of being averaged over her size.
    pub(super) is_uniform: bool,
}

impl Gusts {
    /// Makes gusts about a mean wind from a spectrum, in the band from 1/3600 to 0.5 Hz. A mean wind of zero has no
    /// gusts.
    ///
    /// # Errors
    /// Fails if a number of the wind, the spectrum or the realisation is out of range.
    pub fn new(
        mean: &MeanWind,
        spectrum: &GustSpectrum,
        realisation: Realisation,
    ) -> Result<Gusts, EnvironmentError> {
        mean.check()?;
        spectrum.check()?;
        realisation.check()?;
        let density = |f_hz| spectrum.density(f_hz, mean.speed_mps);
        let harmonics = match mean.speed_mps {
            0.0 => vec![],
            _ => realisation.harmonics_of(density, BAND_HZ[0], BAND_HZ[1]),
        };
        let groups = Group::all(&harmonics);
        let (spectrum, mean_mps) = (*spectrum, mean.speed_mps);
        Ok(Gusts { harmonics, groups, mean_mps, spectrum, realisation, is_uniform: false })
    }

    /// Makes gusts of the same spectrum and seed about another mean wind.
    ///
    /// # Errors
    /// Fails as [`Gusts::new`] does.
    pub fn about(&self, mean: &MeanWind) -> Result<Gusts, EnvironmentError> {
        let gusts = Gusts::new(mean, &self.spectrum, self.realisation)?;
        Ok(Gusts { is_uniform: self.is_uniform, ..gusts })
    }

    /// The same gusts, but without averaging over the ship's size: each gust acts on the whole ship at once.
    #[must_use]
    pub fn uniform(self) -> Gusts {
        Gusts { is_uniform: true, ..self }
    }

    /// Difference of the wind speed from its mean at a time, averaged over a ship's front (m/s). For the gusts at many
    /// times [`ShipGusts`](super::ShipGusts) is faster.
    #[must_use]
    pub fn speed_over_mps(&self, front: &WindFront, t_s: f64) -> f64 {
        if self.is_uniform || *front == WindFront::POINT {
            return self.speed_mps(t_s);
        }
        lanes::sum_over(&self.groups, front.scales_s(self.mean_mps), t_s)
    }

    /// Standard deviation of the wind speed averaged over a ship's front, [`Gusts::speed_over_mps`] (m/s): √Σ½(χa)².
    #[must_use]
    pub fn deviation_over_mps(&self, front: &WindFront) -> f64 {
        let of = |h: &Harmonic| {
            let share = if self.is_uniform { 1.0 } else { front.share(h.frequency, self.mean_mps) };
            0.5 * (share * h.amplitude) * (share * h.amplitude)
        };
        self.harmonics.iter().map(of).sum::<f64>().sqrt()
    }

    /// Difference of the wind speed from its mean at a time, at a point (m/s).
    #[must_use]
    pub fn speed_mps(&self, t_s: f64) -> f64 {
        lanes::sum(&self.groups, t_s)
    }

    /// Standard deviation of the gusts' wind speed at a point (m/s): √Σ½a².
    #[must_use]
    pub fn deviation_mps(&self) -> f64 {
        self.harmonics.iter().map(|h| 0.5 * h.amplitude * h.amplitude).sum::<f64>().sqrt()
    }
}
