//! Corrections of propeller, rudder and resistance of a ship in shallow water by Furukawa et al. (2016) and Tang et al.
//! (2020), as read in a public implementation (an early nikpau/mmgdynamics).

use super::factors::SternFactors;
use crate::hydro::particulars::Particulars;

/// With x = T/h, the factor of shallow water on the flow straightening γ_R is 1 + 0.0161x + 4.4222x² − 4.9825x³. The
/// factor of shallow water on (1 − t) is the square root of 1/(1 − 0.2x + 0.7295x²) with x = T/h. The factor of shallow
/// water on (1 − w) is the square root of cos(1.4 Cb x) with x = T/h.
///
/// The square roots in the factors on (1 − t) and (1 − w) are our own. The factors on (1 − t) and (1 − w) are each the
/// geometric mean of the published factor and 1, because published factors contradict each other. For KVLCC2 at h/T
/// 1.2, Taimuri et al. have factors of 0.80 on (1 − w) and 1.05 on (1 − t), and the formulas without the root give 0.59
/// and 0.75. The tanker of van Berlekom & Goddard has the same thrust at any depth of water.
pub(super) fn factors(ship: &Particulars, share: f64) -> SternFactors {
    SternFactors {
        driving: 1.0 / (1.0 - 0.2 * share + 0.7295 * share * share).sqrt(),
        wake: 1.0,
        inflow: libm::cos(1.4 * ship.block_coefficient() * share).sqrt(),
        straightening: 1.0 + share * (0.0161 + share * (4.4222 - 4.9825 * share)),
    }
}

/// Factor of shallow water on the resistance R₀: 1 + 0.388(T/h)².
pub(super) fn resistance(share: f64) -> f64 {
    1.0 + 0.388 * share * share
}
