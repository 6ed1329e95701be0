//! Ogilvie's relation between damping B and added mass A: A(ω) − A∞ = (2/π)∫(B(w) − B(ω))/(w² − ω²)dw.

use core::f64::consts::FRAC_2_PI;

use fenderline_contact::number::lesser;

/// The added mass at a frequency (rad/s), less the added mass at infinite frequency, that follows from a damping on a grid of frequencies (rad/s).
pub(super) fn change(grid_radps: &[f64], of: impl Fn(usize) -> f64, frequency_radps: f64) -> f64 {
    let (axis, w0) = (grid_radps, frequency_radps);
    let place = axis.partition_point(|w| *w < w0).clamp(1, axis.len() - 1);
    let share = lesser((w0 - axis[place - 1]) / (axis[place] - axis[place - 1]), 1.0);
    let own = of(place - 1) + share * (of(place) - of(place - 1));
    let slope = (of(place) - of(place - 1)) / (axis[place] - axis[place - 1]);
    let inner = integral(axis, |k| {
        let square = axis[k] * axis[k] - w0 * w0;
        if square.abs() < 1e-9 * w0 * w0 { 0.5 * slope / w0 } else { (of(k) - own) / square }
    });
    // Beyond the grid, where the damping has faded, ∫ dw/(w² − ω²) is ln((W + ω)/(W − ω))/2ω.
    let end = axis[axis.len() - 1];
    let beyond = match own == 0.0 {
        true => 0.0,
        false => -own * libm::log((end + w0) / (end - w0).abs()) / (2.0 * w0),
    };
    FRAC_2_PI * (inner + beyond)
}

/// Computes an integral over a grid by the trapezoidal rule.
pub(super) fn integral(axis: &[f64], of: impl Fn(usize) -> f64) -> f64 {
    let (mut sum, mut before) = (0.0, of(0));
    for k in 1..axis.len() {
        let now = of(k);
        sum += 0.5 * (before + now) * (axis[k] - axis[k - 1]);
        before = now;
    }
    sum
}
