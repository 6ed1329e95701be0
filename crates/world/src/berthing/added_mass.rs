//! Formulas for Cm, the added mass factor in sway: displacement plus added mass, divided by displacement.

use fenderline_contact::number::bounded;

use core::f64::consts::PI;

use super::check::{BEAM, BLOCK_COEFFICIENT, DRAUGHT, LENGTH, Range, UNDER_KEEL_CLEARANCE};
use super::error::BerthingError;

/// Cm by PIANC 2002: 1.8 if the under-keel clearance KC is at most 0.1 of the draught D, 1.5 if it is at least 0.5 of
/// the draught, and 1.875 − 0.75·KC/D between.
///
/// Source of the formula: found (public fender design manuals that cite PIANC 2002).
///
/// # Errors
/// Fails if the clearance is below 0 (the ship is aground) or the draught is out of range.
pub fn pianc_2002_added_mass(
    under_keel_clearance_m: f64,
    draught_m: f64,
) -> Result<f64, BerthingError> {
    let ratio = UNDER_KEEL_CLEARANCE.check(under_keel_clearance_m)? / DRAUGHT.check(draught_m)?;
    Ok(bounded(1.875 - 0.75 * ratio, 1.5, 1.8))
}

/// Cm by Shigeru Ueda: 1 + πD/(2·Cb·B).
///
/// The formula was read in public fender design manuals.
///
/// # Errors
/// Fails if a particular of the ship is out of range.
pub fn ueda_added_mass(
    draught_m: f64,
    beam_m: f64,
    block_coefficient: f64,
) -> Result<f64, BerthingError> {
    let (draught_m, beam_m) = (DRAUGHT.check(draught_m)?, BEAM.check(beam_m)?);
    let block = BLOCK_COEFFICIENT.check(block_coefficient)?;
    Ok(1.0 + PI * draught_m / (2.0 * block * beam_m))
}

/// Cm by Vasco Costa: 1 + 2D/B. The formula is meant for an under-keel clearance of at least 0.1 of the draught and a
/// speed of at least 0.08 m/s (this condition is from memory).
///
/// Source of the formula: found (public fender design manuals).
///
/// # Errors
/// Fails if a particular of the ship is out of range.
pub fn vasco_costa_added_mass(draught_m: f64, beam_m: f64) -> Result<f64, BerthingError> {
    Ok(1.0 + 2.0 * DRAUGHT.check(draught_m)? / BEAM.check(beam_m)?)
}

/// Cm by UFC 4-152-01: Cm₀ + (Cm₁ − Cm₀)(D/d)^3.5 with the depth of water d, Cm₀ = 1.3 + 1.5 D/B and Cm₁ = F (12.4
/// (D/B)^0.3 − 50 D/L). The factor F is 1.5 Cb for block coefficients below 0.6, and 0.9 from 0.6 on. With little water
/// under the keel this formula gives a far larger Cm than the other formulas: 5.0 against 1.5 to 1.8.
///
/// Source of the formula: found (mooringberthing, a public calculator in Python: `berth_coeff.py`); we did not read the
/// text of the UFC. In F the public calculator uses the product of the other berthing factors instead of the block
/// coefficient. We take the block coefficient in F from memory, because added mass depends on the hull, not on the
/// point of contact. Block coefficient and product of factors both give F = 0.9 for a full ship that berths broadside.
///
/// # Errors
/// Fails if a particular of the ship is out of range, or if the formula gives less than 1 for the ship.
pub fn ufc_added_mass(
    under_keel_clearance_m: f64,
    draught_m: f64,
    beam_m: f64,
    length_bp_m: f64,
    block_coefficient: f64,
) -> Result<f64, BerthingError> {
    let clearance_m = UNDER_KEEL_CLEARANCE.check(under_keel_clearance_m)?;
    let (draught_m, beam_m) = (DRAUGHT.check(draught_m)?, BEAM.check(beam_m)?);
    let length_m = LENGTH.check(length_bp_m)?;
    let fullness = ufc_fullness(BLOCK_COEFFICIENT.check(block_coefficient)?);
    UFC.check(ufc_by_fullness(clearance_m, draught_m, beam_m, length_m, fullness))
}

static UFC: Range = Range::new("added mass factor Cm by UFC 4-152-01", 1.0, 10.0);

/// The factor F.
fn ufc_fullness(block_coefficient: f64) -> f64 {
    if block_coefficient < 0.6 { 1.5 * block_coefficient } else { 0.9 }
}

fn ufc_by_fullness(
    clearance_m: f64,
    draught_m: f64,
    beam_m: f64,
    length_m: f64,
    fullness: f64,
) -> f64 {
    let over_beam = draught_m / beam_m;
    let deep = 1.3 + 1.5 * over_beam;
    let shallow = fullness * (12.4 * libm::pow(over_beam, 0.3) - 50.0 * draught_m / length_m);
    deep + (shallow - deep) * libm::pow(draught_m / (draught_m + clearance_m), 3.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The supply ship T-AKE in the test of the public calculator, in feet: 689 by 106, draught 31.8, 33.49 of water.
    /// The calculator takes F = 0.9 broadside, and at the quarter point 1.5 times the product of its other factors,
    /// 0.4803 · 0.95. The results are Cm 5.045 and 3.907.
    #[test]
    fn the_ufc_s_formula_gives_what_the_public_calculator_has() {
        let [length_m, beam_m, draught_m, depth_m] =
            [689.0, 106.0, 31.8, 33.49].map(|ft| 0.3048 * ft);
        let clearance_m = depth_m - draught_m;
        let broadside = ufc_added_mass(clearance_m, draught_m, beam_m, length_m, 0.686).unwrap();
        assert!((broadside - 5.045).abs() < 5e-4, "{broadside}");
        let fullness = 1.5 * 0.4803 * 0.95;
        let quarter = ufc_by_fullness(clearance_m, draught_m, beam_m, length_m, fullness);
        assert!((quarter - 3.907).abs() < 1e-3, "{quarter}");
        // F has no jump, and in deep water Cm is 1.3 + 1.5 D/B.
        assert!((ufc_fullness(0.6 - 1e-12) - ufc_fullness(0.6)).abs() < 1e-9);
        let deep = ufc_added_mass(2e4, draught_m, beam_m, length_m, 0.686).unwrap();
        assert!((deep - (1.3 + 1.5 * 31.8 / 106.0)).abs() < 1e-6, "{deep}");
    }

    /// By hand from the three formulas: KC 6.28 m, D 13.72 m, B 51 m, Cb 0.831. The results are given to three
    /// decimals.
    #[allow(clippy::approx_constant, reason = "6.28 m is a clearance, not 2π")]
    #[test]
    fn the_three_formulas_give_the_published_example() {
        let close = |ours: f64, published: f64| assert!((ours - published).abs() < 5e-4, "{ours}");
        close(pianc_2002_added_mass(6.28, 13.72).unwrap(), 1.532);
        close(ueda_added_mass(13.72, 51.0, 0.831).unwrap(), 1.509);
        close(vasco_costa_added_mass(13.72, 51.0).unwrap(), 1.538);
    }

    /// The example in a public calculator's tests: KC 3 m, D 10.9 m, B 26.4 m, Cb 0.77. The results are given to two
    /// decimals.
    #[test]
    fn and_a_second_one() {
        let close = |ours: f64, published: f64| assert!((ours - published).abs() < 6e-3, "{ours}");
        close(pianc_2002_added_mass(3.0, 10.9).unwrap(), 1.67);
        close(ueda_added_mass(10.9, 26.4, 0.77).unwrap(), 1.84);
        close(vasco_costa_added_mass(10.9, 26.4).unwrap(), 1.83);
    }

    /// The branches as printed meet: 1.875 − 0.75·0.1 = 1.8 and 1.875 − 0.75·0.5 = 1.5.
    #[test]
    fn pianc_has_no_jump_at_its_ends() {
        assert_eq!(pianc_2002_added_mass(0.0, 10.0), Ok(1.8));
        assert_eq!(pianc_2002_added_mass(1.0, 10.0), Ok(1.8));
        assert!((pianc_2002_added_mass(1.0 + 1e-9, 10.0).unwrap() - 1.8).abs() < 1e-9);
        assert!((pianc_2002_added_mass(5.0 - 1e-9, 10.0).unwrap() - 1.5).abs() < 1e-9);
        assert_eq!(pianc_2002_added_mass(500.0, 10.0), Ok(1.5));
    }

    #[test]
    fn impossible_ships_are_refused_by_name() {
        let error = pianc_2002_added_mass(-0.1, 10.0).unwrap_err().to_string();
        assert!(error.starts_with("under-keel clearance [m] must be between 0 and"), "{error}");
        assert!(ueda_added_mass(10.0, 30.0, 0.0).unwrap_err().to_string().contains("block"));
        assert!(vasco_costa_added_mass(10.0, 0.0).unwrap_err().to_string().contains("beam"));
        assert!(vasco_costa_added_mass(f64::NAN, 30.0).is_err());
    }
}
