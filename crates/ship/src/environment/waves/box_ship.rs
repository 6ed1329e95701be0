//! A closed-form estimate of a ship's motion in waves that treats the ship as a box.

use super::complex::Complex;
use crate::constants::STANDARD_GRAVITY_MPS2;
use crate::range::{OutOfRange, within};

/// Main particulars of a ship for an *estimate* of heave, pitch and roll in waves. The estimate for a box-shaped ship
/// gives zero surge, sway and yaw.
///
/// The formulas for heave and pitch are of Jensen, Mansour & Olsen, "Estimation of ship motions using closed-form
/// expressions", Ocean Engineering 31 (2004), for a box with the ship's displacement and the waterline's length. The
/// formulas were found in a public package of the authors' university; the paper itself was not read.
///
/// The formula for roll is derived here, because Jensen's roll needs a fitted damping that jumps at B/T = 3. The box's
/// roll has one degree of freedom, with the given period and damping. Roll is driven by the wave slope, averaged over
/// length and beam of the box; the factor e^(−kT/2) averages the slope over the draught. In long waves the roll of the
/// ship follows the wave slope.
///
/// The phases of Jensen's amplitudes are those of his equations of motion: the excitation is in phase with the crest
/// (heave) and with the slope (pitch) amidships. Jensen's formulas and the roll of this box are for deep water.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BoxShip {
    /// Length of the ship on the waterline (m).
    pub length_m: f64,
    /// Beam (m).
    pub beam_m: f64,
    /// Draught (m).
    pub draught_m: f64,
    /// Block coefficient, which is the beam of the box divided by the beam of the ship.
    pub block_coefficient: f64,
    /// Natural period of the ship's roll (s).
    pub roll_period_s: f64,
    /// Damping ratio of the ship's roll; use 0.15 if it is not known.
    pub roll_damping: f64,
}

impl BoxShip {
    /// Checks every number.
    ///
    /// # Errors
    /// Fails at the first particular that is out of range.
    pub fn check(&self) -> Result<(), OutOfRange> {
        within("length on the waterline [m]", self.length_m, 0.1, 2000.0)?;
        within("beam [m]", self.beam_m, 0.05, 500.0)?;
        within("draught [m]", self.draught_m, 0.01, 100.0)?;
        within("block coefficient", self.block_coefficient, 0.1, 1.0)?;
        // At a ratio of 4π the formula's heave damping is zero at resonance.
        let flat = self.beam_m * self.block_coefficient / self.draught_m;
        within("block coefficient times beam over draught", flat, 0.1, 10.0)?;
        within("roll period [s]", self.roll_period_s, 0.1, 200.0)?;
        within("damping of roll", self.roll_damping, 0.01, 2.0)?;
        Ok(())
    }

    /// Response amplitude operators of the box for a wave of frequency ω > 0 (rad/s) and direction μ from the bow
    /// (rad), at a forward speed (m/s).
    #[must_use]
    pub fn at(&self, frequency_radps: f64, direction_rad: f64, speed_mps: f64) -> [Complex; 6] {
        let (cos, sin) = (libm::cos(direction_rad), libm::sin(direction_rad));
        let k = frequency_radps * frequency_radps / STANDARD_GRAVITY_MPS2;
        let encounter_radps = frequency_radps - k * speed_mps * cos;
        let (heave_up, pitch) = self.heave_and_pitch(k, cos, encounter_radps / frequency_radps);
        let zero = Complex::default();
        [zero, zero, heave_up * -1.0, self.roll(k, cos, sin, encounter_radps), pitch, zero]
    }

    /// Jensen's F and G (the excitation of heave and pitch) divided by the factor of the equation of motion, (1 −
    /// 2kTα²) + i A²/(kBα²) with α = ω_e/ω. The damping term of the equation of motion has the sign of the frequency of
    /// encounter ω_e. The damping term is negative if the ship overtakes a following sea.
    fn heave_and_pitch(&self, k: f64, cos: f64, alpha: f64) -> (Complex, Complex) {
        let (l, t) = (self.length_m, self.draught_m);
        let b = self.beam_m * self.block_coefficient;
        let alpha_squared = alpha * alpha;
        let half = 0.5 * k * b * alpha_squared;
        // A/α² = kB·sinc(½kBα²)·e^(−kTα²): this form has no division by α.
        let radiated = k * b * sinc(half) * libm::exp(-k * t * alpha_squared);
        let damping = radiated * radiated * alpha_squared / (k * b);
        let smith = (1.0 - k * t) * (1.0 - k * t);
        let excitation = radiated * radiated * alpha.abs() / (k * b);
        let f = (smith + excitation * excitation).sqrt() * libm::exp(-k * t);
        let arm = 0.5 * k * cos.abs() * l;
        let motion = Complex::new(1.0 - 2.0 * k * t * alpha_squared, damping * alpha.signum());
        let inverse = motion.inverse();
        // 24/((k_e L)² L)·(sin arm − arm·cos arm) = k_e·3(sin arm − arm·cos arm)/arm³.
        let slope = k * cos * f * bessel_like(arm);
        (inverse * (f * sinc(arm)), Complex::new(0.0, -slope) * inverse)
    }

    fn roll(&self, k: f64, cos: f64, sin: f64, encounter_radps: f64) -> Complex {
        let ratio = encounter_radps * self.roll_period_s / core::f64::consts::TAU;
        let motion = Complex::new(1.0 - ratio * ratio, 2.0 * self.roll_damping * ratio);
        let mean = sinc(0.5 * k * cos * self.length_m) * sinc(0.5 * k * sin * self.beam_m);
        let slope = k * sin * mean * libm::exp(-0.5 * k * self.draught_m);
        // Roll to starboard is positive if the surface falls to starboard, so the sign of roll is opposite to the sign
        // of the slope.
        Complex::new(0.0, slope) * motion.inverse()
    }
}

/// sin x / x.
fn sinc(x: f64) -> f64 {
    if x.abs() < 1e-4 { 1.0 - x * x / 6.0 } else { libm::sin(x) / x }
}

/// Computes 3(sin x − x cos x)/x³, which is 1 at x = 0.
fn bessel_like(x: f64) -> f64 {
    if x.abs() < 1e-2 {
        return 1.0 - x * x / 10.0;
    }
    3.0 * (libm::sin(x) - x * libm::cos(x)) / (x * x * x)
}
