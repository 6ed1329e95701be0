//! Linear terms by the effective aspect ratio of the hull as a wing: Hirano, Takashina, Moriya & Nakamura (1985), and
//! Kijima & Nakiri after them.
//!
//! The effective aspect ratio is k_e = k/{½(T/h)k + [(πT/2h) cot(πT/2h)]^λ} with k = 2T/L, and a different λ for each
//! derivative. One public program (an early nikpau/mmgdynamics, which calls itself "not working") lacks the k in the
//! first term of the denominator of k_e. Without the k in the denominator, the limit of k_e would be 2k, and not 2, the
//! value for a wing between walls. The k is recalled. With the k in the denominator, Y_v and N_v of KVLCC2 agree with
//! the other sets of corrections within 10 % at h/T 1.5 and 1.2; without the k, they are a third of the values by those
//! sets.

use fenderline_contact::number::lesser;

use std::f64::consts::{FRAC_PI_2, PI};

use super::limits::DEEPEST_HULL;
use crate::hydro::particulars::Particulars;

/// Exponent λ of the effective aspect ratio for Y_v, for Y_r and N_r, and for N_v.
const EXPONENTS: [f64; 3] = [2.3, 0.7, 1.7];
/// Effective aspect ratio k_e at which the damping 0.54 k_e − k_e² is greatest. For a greater k_e the damping at this
/// k_e is used, because damping does not decrease in shallower water.
const TURNING_POINT: f64 = 0.27;

/// Factors on Y_v, Y_r, N_v and N_r at the ratio T/h, from Y_v = −(½π k_e + 1.4 Cb B/L), Y_r = ¼π k_e, N_v = −k_e and
/// N_r = −(0.54 k_e − k_e²), each divided by its value in deep water.
pub(super) fn linear(ship: &Particulars, share: f64) -> [f64; 4] {
    let ratio = 2.0 * ship.draught_m / ship.length_m;
    let viscous = 1.4 * ship.block_coefficient() * ship.beam_m / ship.length_m;
    let [sway, turning, yaw] = EXPONENTS.map(|exponent| growth(ratio, share, exponent));
    let y_v = (0.5 * PI * ratio * sway + viscous) / (0.5 * PI * ratio + viscous);
    let damped = lesser(ratio, 2.0 * DEEPEST_HULL);
    let damping = |k: f64| 0.54 * k - k * k;
    let effective = lesser(damped * growth(damped, share, EXPONENTS[1]), TURNING_POINT);
    [y_v, turning, yaw, damping(effective) / damping(damped)]
}

/// Ratio k_e/k of the effective aspect ratio to the aspect ratio k in deep water; in deep water the ratio is 1.
fn growth(ratio: f64, share: f64, exponent: f64) -> f64 {
    let angle = FRAC_PI_2 * share;
    // x cot x tends to 1 as x tends to 0.
    let open = if angle == 0.0 { 1.0 } else { angle / libm::tan(angle) };
    1.0 / (0.5 * share * ratio + libm::pow(open, exponent))
}

#[cfg(test)]
mod tests {
    use super::growth;

    /// KVLCC2's 2T/L of 0.13 at h/T 1.2: 1.30900·cot 1.30900 = 0.35074; calculated independently.
    #[test]
    fn effective_aspect_ratio_agrees_with_a_calculation_by_hand() {
        for (exponent, theirs) in [(2.3, 6.944), (0.7, 1.871), (1.7, 4.492)] {
            let ours = growth(0.13, 1.0 / 1.2, exponent);
            assert!((ours / theirs - 1.0).abs() < 1e-3, "{ours} {theirs}");
        }
        assert_eq!(growth(0.13, 0.0, 2.3), 1.0);
    }
}
