//! The part of the mean longitudinal force that is due to heave and pitch.

use fenderline_contact::number::bounded;

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use super::hull::DriftHull;

/// Range of the ratio of beam to draught for which the regression was made, as far as we know. Ratios of beam to
/// draught outside the regression's range are set to its limit.
const BEAM_OVER_DRAUGHT: [f64; 2] = [2.0, 9.0];

/// Radius of gyration in pitch divided by the length: the default of the SNNM method.
const PITCH_GYRATION: f64 = 0.25;

/// The drift force due to heave and pitch by the SNNM method (ITTC 7.5-04-01-01.1; Liu & Papanikolaou 2020, see
/// [`super::depth`]), divided by ρga² (m), positive forward. The formula holds for a ship at rest on an even keel. The
/// angle α of the SNNM method is 0 for waves from ahead.
///
/// The drift force due to motions, divided by ρga², is 4 B²/L · 241.2 C_B^1.34 k_yy² a₁ a₂ ω̄^b₁ exp(b₁/d₁ (1 −
/// ω̄^d₁)), where ω̄ is the frequency divided by the frequency at which the force is largest.
pub(super) fn surge_m(hull: &DriftHull, number_radpm: f64, direction_rad: f64) -> f64 {
    let block = hull.block_coefficient;
    let [least, most] = BEAM_OVER_DRAUGHT;
    let flatness = libm::log(bounded(hull.beam_m / hull.draught_m, least, most));
    let off_head_rad = PI - libm::remainder(direction_rad, TAU).abs();
    let (cos, slenderness) = (libm::cos(off_head_rad), hull.length_m / hull.beam_m);
    // (13 + cos 2α)/14, cos 2α = 2cos²α − 1.
    let heading = 0.618 * (12.0 + 2.0 * cos * cos) / 14.0;
    let ratio = 2.142
        * libm::cbrt(PITCH_GYRATION)
        * (hull.length_m * number_radpm / TAU).sqrt()
        * libm::pow(block / 0.65, 0.17)
        * (1.0 - 0.111 / block * (flatness - libm::log(2.75)))
        * heading;
    let (exponent, width) = if ratio < 1.0 {
        (11.0, 566.0 * libm::pow(slenderness * block, -2.66))
    } else {
        (-8.5, -4.0 * 566.0 * libm::pow(slenderness, -2.66))
    };
    let shape =
        libm::pow(ratio, exponent) * libm::exp(exponent / width * (1.0 - libm::pow(ratio, width)));
    let size = 4.0 * hull.beam_m / slenderness
        * 241.2
        * libm::pow(block, 1.34)
        * PITCH_GYRATION
        * PITCH_GYRATION;
    -size * amplitude(block, flatness, off_head_rad, cos) * shape
}

/// The factor a₁a₂ of the drift force: by formula for waves from ahead to abeam, and from there linear to waves from
/// astern, for which the force is forward.
fn amplitude(block: f64, flatness: f64, off_head_rad: f64, cos: f64) -> f64 {
    let fullness = 0.87 / block;
    if off_head_rad <= FRAC_PI_2 {
        return 0.0072 * libm::pow(fullness, cos) * (1.0 + 2.0 * cos) / (3.0 * flatness);
    }
    let share = off_head_rad / FRAC_PI_2 - 1.0;
    let [abeam, astern] = [1.0 / (3.0 * flatness), fullness / flatness];
    (abeam + share * (astern - abeam)) * 0.0072 * (1.0 - 2.0 * share)
}
