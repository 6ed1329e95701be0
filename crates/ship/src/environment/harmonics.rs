//! Makes a random signal with a given spectrum, as a sum of harmonics with random phases.

use core::f64::consts::TAU;

use super::error::EnvironmentError;
use crate::random::SplitMix64;
use crate::range::within;

/// Number of sub-intervals of Simpson's rule in each bin of a spectrum.
const SUB_INTERVALS: usize = 16;

/// One harmonic of a random signal, amplitude · cos(frequency · t + phase).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Harmonic {
    /// Frequency of the harmonic, in the unit of the frequency band.
    pub(super) frequency: f64,
    pub(super) amplitude: f64,
    pub(super) phase_rad: f64,
}

/// How a spectrum is divided into harmonics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Realisation {
    /// Number of harmonics, 1 to 10 000.
    pub harmonics: usize,
    /// Seed of the random phases and frequencies of the harmonics. The same seed gives the same harmonics, bit for bit.
    pub seed: u64,
}

impl Realisation {
    pub(super) fn check(&self) -> Result<(), EnvironmentError> {
        within("number of harmonics", self.harmonics as f64, 1.0, 10_000.0)?;
        Ok(())
    }

    /// Divides the frequency band from `low` to `high` into bins; the limits of the bins are in geometric progression.
    /// Each bin of the spectrum becomes one harmonic with the energy of the bin, ½a² = ∫S df. The frequency of each
    /// harmonic is random within its bin, so that the sum is not periodic.
    pub(super) fn harmonics_of(
        &self,
        density: impl Fn(f64) -> f64,
        low: f64,
        high: f64,
    ) -> Vec<Harmonic> {
        let mut random = SplitMix64::new(self.seed);
        let growth = libm::log(high / low) / self.harmonics as f64;
        let limit = |bin: usize| low * libm::exp(growth * bin as f64);
        (0..self.harmonics)
            .map(|bin| {
                let (from, to) = (limit(bin), limit(bin + 1));
                let frequency = from + random.unit() * (to - from);
                let phase_rad = TAU * random.unit();
                let energy = integral(&density, from, to, SUB_INTERVALS);
                Harmonic { frequency, amplitude: (2.0 * energy).sqrt(), phase_rad }
            })
            .collect()
    }
}

/// Computes ∫ f dx by Simpson's rule with an even number of sub-intervals.
pub(super) fn integral(f: impl Fn(f64) -> f64, from: f64, to: f64, sub_intervals: usize) -> f64 {
    let width = (to - from) / sub_intervals as f64;
    let inner: f64 = (1..sub_intervals)
        .map(|k| if k % 2 == 1 { 4.0 } else { 2.0 } * f(from + width * k as f64))
        .sum();
    (f(from) + inner + f(to)) * width / 3.0
}
