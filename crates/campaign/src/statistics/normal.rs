//! The standard normal distribution.

use core::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

use statrs::function::erf::erfc_inv;

/// Probability that a standard normal variable is at most `z`.
pub(super) fn below(z: f64) -> f64 {
    0.5 * libm::erfc(-z * FRAC_1_SQRT_2)
}

/// Probability to exceed `z`.
pub(super) fn above(z: f64) -> f64 {
    0.5 * libm::erfc(z * FRAC_1_SQRT_2)
}

/// The value that a standard normal variable exceeds with probability `p`.
pub(super) fn value_exceeded(p: f64) -> f64 {
    SQRT_2 * erfc_inv(2.0 * p)
}
