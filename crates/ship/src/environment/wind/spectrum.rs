//! Spectra of gusts at a height of 10 m.

use super::mean::REFERENCE_HEIGHT_M;
use crate::range::{OutOfRange, within};

/// Spectrum of the gusts about a mean wind, 10 m above the water: one-sided, in (m/s)²/Hz over the frequency f in Hz.
/// In the spectra, U is the mean wind speed at 10 m: the hourly mean, but for Davenport and Harris the mean over 10
/// minutes (from memory).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GustSpectrum {
    /// Davenport's spectrum of 1961: 4κLU χ/(1+χ²)^{4/3}, χ = fL/U, L = 1200 m. Davenport's spectrum is made for gusts
    /// over land. The variance of Davenport's spectrum is 6κU². Davenport's spectrum was found in a public library of
    /// wind spectra.
    Davenport {
        /// Drag coefficient κ of the surface, 0.001 to 0.05.
        surface_drag: f64,
    },
    /// Harris' spectrum: 4κLU/(2+χ²)^{5/6}, χ = fL/U, L = 1800 m; not for f below 0.01 Hz. Harris' spectrum was found
    /// in the same public library as Davenport's.
    Harris {
        /// Drag coefficient κ of the surface, 0.001 to 0.05.
        surface_drag: f64,
    },
    /// Spectrum of Ochi & Shin, 1988, over the sea: f S/u*² = 583f*, 420f*^0.70/(1+f*^0.35)^11.5 or
    /// 838f*/(1+f*^0.35)^11.5, for f* up to 0.003, up to 0.1 and beyond; u*² = C₁₀U². The three branches of Ochi &
    /// Shin's spectrum, which are continuous, were found in the same public library as Davenport's. The definition f* =
    /// 10 m·f/U is from a second public code; the library omits the 10 m. The limits of the three branches agree with
    /// f* = 10 m·f/U.
    OchiShin {
        /// Drag coefficient C₁₀ of the sea's surface, 0.0005 to 0.05, such as [`surface_drag`] gives.
        surface_drag: f64,
    },
    /// Spectrum of NPD (ISO 19901-1): 320 (U/10)²/(1+f̃ⁿ)^{5/(3n)}, f̃ = 172 f (U/10)^{−3/4}, n = 0.468, with the
    /// hourly mean U. The spectrum of NPD was found in two public codes.
    Npd,
    /// Spectrum of API RP 2A: (σ²/f_p)/(1 + 1.5 f/f_p)^{5/3}, f_p = C·U/10 m, σ = 0.15 U (10/20)^{−0.125}. The formulas
    /// for σ and f_p of the API spectrum were found in a public code. The public code has 1 + 1.5 (f/f_p)^{5/3} in the
    /// denominator of the API spectrum; the variance of that form is not σ². The form of the API spectrum that we use
    /// is from memory, and its variance is σ².
    Api {
        /// Factor C of the peak frequency, 0.01 to 0.1; 0.025 is customary.
        peak: f64,
    },
}

/// Drag coefficient C₁₀ of the sea's surface, (0.75 + 0.067 U₁₀)·10⁻³, for wind speeds U₁₀ of 4 to 21 m/s (Garratt,
/// Monthly Weather Review 105, 1977; its abstract was read).
#[must_use]
pub fn surface_drag(speed_mps: f64) -> f64 {
    (0.75 + 0.067 * speed_mps) * 1e-3
}

impl GustSpectrum {
    /// Checks the parameter.
    ///
    /// # Errors
    /// Fails if the spectrum's parameter is out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        match *self {
            GustSpectrum::Davenport { surface_drag }
            | GustSpectrum::Harris { surface_drag }
            | GustSpectrum::OchiShin { surface_drag } => {
                within("drag coefficient of the surface", surface_drag, 1e-4, 0.1)?;
            }
            GustSpectrum::Npd => {}
            GustSpectrum::Api { peak } => {
                within("C of the API spectrum", peak, 0.01, 0.1)?;
            }
        }
        Ok(())
    }

    /// Spectral density S(f) of the gusts ((m/s)²/Hz) for a frequency f > 0 (Hz) and a mean wind above 0 (m/s).
    #[must_use]
    pub fn density(&self, f_hz: f64, mean_mps: f64) -> f64 {
        let pow = libm::pow;
        match *self {
            GustSpectrum::Davenport { surface_drag } => {
                let chi = f_hz * 1200.0 / mean_mps;
                4.0 * surface_drag * 1200.0 * mean_mps * chi / pow(1.0 + chi * chi, 4.0 / 3.0)
            }
            GustSpectrum::Harris { surface_drag } => {
                let chi = f_hz * 1800.0 / mean_mps;
                4.0 * surface_drag * 1800.0 * mean_mps / pow(2.0 + chi * chi, 5.0 / 6.0)
            }
            GustSpectrum::OchiShin { surface_drag } => {
                let f = f_hz * REFERENCE_HEIGHT_M / mean_mps;
                let fall = pow(1.0 + pow(f, 0.35), 11.5);
                let shape = if f <= 0.003 {
                    583.0 * f
                } else if f <= 0.1 {
                    420.0 * pow(f, 0.70) / fall
                } else {
                    838.0 * f / fall
                };
                shape * surface_drag * mean_mps * mean_mps / f_hz
            }
            GustSpectrum::Npd => {
                let tenths = mean_mps / 10.0;
                let f = 172.0 * f_hz * pow(tenths, -0.75);
                320.0 * tenths * tenths / pow(1.0 + pow(f, 0.468), 5.0 / (3.0 * 0.468))
            }
            GustSpectrum::Api { peak } => {
                let deviation_mps = 0.15 * mean_mps * pow(0.5, -0.125);
                let peak_hz = peak * mean_mps / REFERENCE_HEIGHT_M;
                deviation_mps * deviation_mps / peak_hz / pow(1.0 + 1.5 * f_hz / peak_hz, 5.0 / 3.0)
            }
        }
    }
}
