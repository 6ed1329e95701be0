//! Estimated resistance of a ship without model tests.

use crate::constants::STANDARD_GRAVITY_MPS2;
use fenderline_contact::number::bounded;

use crate::hydro::friction::{SEA_M2PS, ittc_1957};
use crate::hydro::particulars::Particulars;

/// Total resistance coefficient on the wetted surface, of a ship under way.
const TOTAL_RESISTANCE: f64 = 0.004;
/// Coefficient of the midship section's form drag along the hull, UFC 4-159-03 (2005), eq. 16.
const FORM_DRAG: f64 = 0.1;
/// Froude number V/√(gL) at which the friction of a drifting ship is computed.
const ADRIFT_FROUDE: f64 = 0.03;
/// Range of [`ittc_1957`]. Vessels shorter than a quarter of a metre have Reynolds numbers below this range.
const REYNOLDS: [f64; 2] = [1e4, 1e11];

/// Resistance X'₀ of a ship under way ahead.
pub(super) fn ahead(ship: &Particulars) -> f64 {
    -TOTAL_RESISTANCE * wetted_over_side(ship)
}

/// Resistance X'₀ of a ship astern, adrift or in a current, by UFC 4-159-03 (2005), "Design: Moorings", 4-5.2, eqs. 16
/// to 20. The resistance coefficient astern is 0.1 on the midship section, plus the friction of ITTC 1957 on Mumford's
/// wetted surface. The third component of the manual UFC 4-159-03, the drag of a locked propeller, is part of the
/// propeller model.
///
/// The manual UFC 4-159-03 gives this resistance for any ship-shaped vessel, with bow or stern into the current. The
/// manual UFC 4-159-03 computes friction at the actual speed. We compute friction at one Froude number, so that the
/// coefficient is constant. At half the speed of this Froude number, friction is 10 % higher.
pub(super) fn astern(ship: &Particulars) -> f64 {
    let speed_mps = ADRIFT_FROUDE * (STANDARD_GRAVITY_MPS2 * ship.length_m).sqrt();
    let [least, most] = REYNOLDS;
    let reynolds = bounded(speed_mps * ship.length_m / SEA_M2PS, least, most);
    let friction = ittc_1957(reynolds).unwrap_or_else(|error| {
        unreachable!("the Reynolds number is limited to the range of the friction line: {error}")
    });
    -FORM_DRAG * ship.beam_m / ship.length_m - friction * wetted_over_side(ship)
}

/// Wetted surface by Mumford, 1.7 L d + ∇/d, divided by L d.
fn wetted_over_side(ship: &Particulars) -> f64 {
    let side_m2 = ship.length_m * ship.draught_m;
    (1.7 * side_m2 + ship.volume_m3 / ship.draught_m) / side_m2
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The only ship with known data: Esso Osaka's model of 3 m has −0.0319 astern (Miyauchi et al. 2022). The
    /// tolerance of a fifth allows for the different speed and for a form drag that is not specific to this ship.
    #[test]
    fn resistance_astern_agrees_with_esso_osaka_within_a_fifth() {
        let model = Particulars {
            length_m: 3.0,
            beam_m: 0.489,
            draught_m: 0.201,
            volume_m3: 0.2449,
            centre_of_gravity_m: 0.094,
            yaw_gyradius_ratio: 0.25,
        };
        let ratio = astern(&model) / -0.0319;
        assert!((0.8..=1.2).contains(&ratio), "{ratio}");
    }
}
