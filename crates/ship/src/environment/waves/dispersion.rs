//! Dispersion relation of linear waves.

use fenderline_contact::number::greater;

use crate::constants::STANDARD_GRAVITY_MPS2;

/// Wave number k (rad/m) of a wave of frequency ω > 0 (rad/s) in water of a depth h > 0 (m), from ω² = g k tanh(kh)
/// (linear theory). Newton's method finds k from above the root, where the method converges monotonically.
#[must_use]
pub fn wave_number(frequency_radps: f64, depth_m: f64) -> f64 {
    let deep = frequency_radps * frequency_radps / STANDARD_GRAVITY_MPS2;
    // In x = kh: x tanh x = deep·h = d. max(d, √d) ≤ x; there Newton's method converges monotonically.
    let d = deep * depth_m;
    let mut x = greater(d, d.sqrt());
    for _ in 0..50 {
        let tanh = libm::tanh(x);
        let slope = tanh + x * (1.0 - tanh * tanh);
        let next = x - (x * tanh - d) / slope;
        if (next - x).abs() <= 2.0 * f64::EPSILON * x {
            return next / depth_m;
        }
        x = next;
    }
    x / depth_m
}
