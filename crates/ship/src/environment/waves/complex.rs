//! Complex numbers, with the operations that response operators need.

use core::ops::{Add, Mul};

/// A complex number.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Complex {
    /// Real part: the part of a motion in phase with the wave's crest.
    pub re: f64,
    /// Imaginary part: the part of a motion that leads the wave's crest by a quarter of a period.
    pub im: f64,
}

impl Complex {
    /// The complex number with the given real and imaginary part.
    #[must_use]
    pub const fn new(re: f64, im: f64) -> Complex {
        Complex { re, im }
    }

    /// The complex number with the given modulus and phase (rad).
    #[must_use]
    pub fn polar(modulus: f64, phase_rad: f64) -> Complex {
        Complex::new(modulus * libm::cos(phase_rad), modulus * libm::sin(phase_rad))
    }

    /// Modulus.
    #[must_use]
    pub fn modulus(self) -> f64 {
        libm::hypot(self.re, self.im)
    }

    /// Inverse, 1/z.
    #[must_use]
    pub(super) fn inverse(self) -> Complex {
        let squared = self.re * self.re + self.im * self.im;
        Complex::new(self.re / squared, -self.im / squared)
    }
}

impl Add for Complex {
    type Output = Complex;
    fn add(self, other: Complex) -> Complex {
        Complex::new(self.re + other.re, self.im + other.im)
    }
}

impl Mul for Complex {
    type Output = Complex;
    fn mul(self, other: Complex) -> Complex {
        Complex::new(
            self.re * other.re - self.im * other.im,
            self.re * other.im + self.im * other.re,
        )
    }
}

impl Mul<f64> for Complex {
    type Output = Complex;
    fn mul(self, factor: f64) -> Complex {
        Complex::new(self.re * factor, self.im * factor)
    }
}
