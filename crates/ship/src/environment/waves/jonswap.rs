//! The JONSWAP spectrum.

use core::f64::consts::TAU;

use crate::range::{OutOfRange, within};

/// A JONSWAP spectrum: S(ω) = A·(5/16) Hs² ω_p⁴ ω⁻⁵ exp(−1.25 (ω_p/ω)⁴)·γ^b,
/// b = exp(−(ω−ω_p)²/(2σ²ω_p²)), σ = 0.07 up to ω_p and 0.09 beyond, A = 1 − 0.287 ln γ (the form of
/// DNV-RP-C205, read in the MSS toolbox's waveSpectrum.m, and integrated in validation/independent/ship_formulas.py).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Jonswap {
    /// Significant wave height Hs of the sea (m).
    pub height_m: f64,
    /// Tp, peak period (s).
    pub peak_period_s: f64,
    /// Peak enhancement γ: 1 gives the Pierson–Moskowitz spectrum, 3.3 is the mean of JONSWAP.
    pub peak_enhancement: f64,
}

impl Jonswap {
    /// Checks every number.
    ///
    /// # Errors
    /// Fails if a number of the spectrum is out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        within("significant wave height [m]", self.height_m, 0.0, 30.0)?;
        within("peak period [s]", self.peak_period_s, 0.5, 40.0)?;
        within("peak enhancement of JONSWAP", self.peak_enhancement, 1.0, 10.0)?;
        Ok(())
    }

    /// ω_p (rad/s).
    #[must_use]
    pub fn peak_radps(&self) -> f64 {
        TAU / self.peak_period_s
    }

    /// Spectral density S(ω) (m²·s/rad) for a frequency ω > 0 (rad/s).
    #[must_use]
    pub fn density(&self, frequency_radps: f64) -> f64 {
        let ratio = self.peak_radps() / frequency_radps;
        let width = if ratio >= 1.0 { 0.07 } else { 0.09 };
        let off = (1.0 / ratio - 1.0) / width;
        let peak = libm::pow(self.peak_enhancement, libm::exp(-0.5 * off * off));
        let norm = 1.0 - 0.287 * libm::log(self.peak_enhancement);
        let fourth = ratio * ratio * ratio * ratio;
        let shape = fourth / frequency_radps * libm::exp(-1.25 * fourth);
        norm * 0.3125 * self.height_m * self.height_m * shape * peak
    }
}
