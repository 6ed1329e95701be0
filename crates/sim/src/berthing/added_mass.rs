//! Cm, the added mass factor in sway: displacement plus added mass, over displacement.

use fenderline_contact::number::bounded;

use core::f64::consts::PI;

use super::check::{BEAM, BLOCK_COEFFICIENT, DRAUGHT, UNDER_KEEL_CLEARANCE};
use super::error::BerthingError;

/// Cm by PIANC 2002: 1.8 where the under-keel clearance is at most 0.1 of the draught, 1.5 where it
/// is at least 0.5 of it, and 1.875 − 0.75·KC/D between.
///
/// Source: found (public fender design manuals that cite PIANC 2002).
///
/// # Errors
/// A clearance below 0 (a ship aground) or a draught out of range.
pub fn pianc_2002_added_mass(
    under_keel_clearance_m: f64,
    draught_m: f64,
) -> Result<f64, BerthingError> {
    let ratio = UNDER_KEEL_CLEARANCE.check(under_keel_clearance_m)? / DRAUGHT.check(draught_m)?;
    Ok(bounded(1.875 - 0.75 * ratio, 1.5, 1.8))
}

/// Cm by Shigeru Ueda, 1 + πD/(2·Cb·B).
///
/// Source: found (public fender design manuals).
///
/// # Errors
/// A particular out of range.
pub fn ueda_added_mass(
    draught_m: f64,
    beam_m: f64,
    block_coefficient: f64,
) -> Result<f64, BerthingError> {
    let (draught_m, beam_m) = (DRAUGHT.check(draught_m)?, BEAM.check(beam_m)?);
    let block = BLOCK_COEFFICIENT.check(block_coefficient)?;
    Ok(1.0 + PI * draught_m / (2.0 * block * beam_m))
}

/// Cm by Vasco Costa, 1 + 2D/B. Meant for an under-keel clearance of at least 0.1 of the
/// draught and a speed of at least 0.08 m/s (recalled).
///
/// Source: found (public fender design manuals).
///
/// # Errors
/// A particular out of range.
pub fn vasco_costa_added_mass(draught_m: f64, beam_m: f64) -> Result<f64, BerthingError> {
    Ok(1.0 + 2.0 * DRAUGHT.check(draught_m)? / BEAM.check(beam_m)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand from the three formulas: KC 6.28 m, D 13.72 m, B 51 m, Cb 0.831. They are given
    /// to three decimals.
    #[allow(clippy::approx_constant, reason = "6.28 m is a clearance, not 2π")]
    #[test]
    fn the_three_formulas_give_the_published_example() {
        let close = |ours: f64, published: f64| assert!((ours - published).abs() < 5e-4, "{ours}");
        close(pianc_2002_added_mass(6.28, 13.72).unwrap(), 1.532);
        close(ueda_added_mass(13.72, 51.0, 0.831).unwrap(), 1.509);
        close(vasco_costa_added_mass(13.72, 51.0).unwrap(), 1.538);
    }

    /// The example of a public calculator's tests: KC 3 m, D 10.9 m, B 26.4 m, Cb 0.77, given to two
    /// decimals.
    #[test]
    fn and_a_second_one() {
        let close = |ours: f64, published: f64| assert!((ours - published).abs() < 6e-3, "{ours}");
        close(pianc_2002_added_mass(3.0, 10.9).unwrap(), 1.67);
        close(ueda_added_mass(10.9, 26.4, 0.77).unwrap(), 1.84);
        close(vasco_costa_added_mass(10.9, 26.4).unwrap(), 1.83);
    }

    /// The printed branches meet: 1.875 − 0.75·0.1 = 1.8 and 1.875 − 0.75·0.5 = 1.5.
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
