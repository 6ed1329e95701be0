//! Squat by three formulas for open water, and two with the blockage of a channel. The three formulas for open water
//! are as PIANC gives them (Harbour Approach Channels, report 121, 2014). The formulas were read in public programs,
//! which agree (Barrass' and ICORELS' in stebiondi/pyCoastal), and the results were compared with independently
//! calculated numbers. The functions for open water fail if the water is not deeper than the ship's draught.

use super::limits::draught_over_depth;
use crate::constants::{KNOTS_PER_MPS, STANDARD_GRAVITY_MPS2};
use crate::hydro::error::HydroError;
use crate::hydro::particulars::Particulars;
use fenderline_contact::number::{greater, lesser};

/// Largest squat of a ship in open shallow water by Barrass: Cb V²/100 (m), V in knots. Barrass' formula is for h/T of
/// 1.1 to 1.4.
///
/// # Errors
/// [`HydroError::Aground`].
pub fn barrass_squat_m(
    ship: &Particulars,
    depth_m: f64,
    speed_mps: f64,
) -> Result<f64, HydroError> {
    draught_over_depth(ship, depth_m)?;
    let knots = speed_mps * KNOTS_PER_MPS;
    Ok(ship.block_coefficient() * knots * knots / 100.0)
}

/// Squat at the bow by ICORELS (1980), with the coefficient 2.4 for open water; some authorities use 2.0 for container
/// ships and 1.7 for fine ships. The squat by ICORELS is 2.4 ∇/L² Fh²/√(1 − Fh²) (m), with the depth Froude number Fh =
/// V/√(gh).
///
/// # Errors
/// Fails with [`HydroError::Aground`], or with [`HydroError::Supercritical`] from Fh = 1 on.
pub fn icorels_squat_m(
    ship: &Particulars,
    depth_m: f64,
    speed_mps: f64,
) -> Result<f64, HydroError> {
    draught_over_depth(ship, depth_m)?;
    let square = speed_mps * speed_mps / (STANDARD_GRAVITY_MPS2 * depth_m);
    if square.is_nan() || square >= 1.0 {
        return Err(HydroError::Supercritical { froude: square.sqrt() });
    }
    let slender_m = ship.volume_m3 / (ship.length_m * ship.length_m);
    Ok(2.4 * slender_m * square / (1.0 - square).sqrt())
}

/// Squat at the bow in unrestricted shallow water by Eryuzlu et al. (1994):
/// 0.298 h²/T (V/√(gT))^2.289 (h/T)^−2.972 (m).
///
/// # Errors
/// [`HydroError::Aground`].
pub fn eryuzlu_squat_m(
    ship: &Particulars,
    depth_m: f64,
    speed_mps: f64,
) -> Result<f64, HydroError> {
    let ratio = 1.0 / draught_over_depth(ship, depth_m)?;
    let draught_m = ship.draught_m;
    let froude = speed_mps.abs() / (STANDARD_GRAVITY_MPS2 * draught_m).sqrt();
    Ok(0.298 * depth_m * depth_m / draught_m * libm::pow(froude, 2.289) * libm::pow(ratio, -2.972))
}

/// The largest blockage of [`barrass_channel_squat_m`]; in a narrower channel the squat for this blockage is used.
const MOST_BLOCKAGE: f64 = 0.266;

/// Width of the water that a ship moves, by Barrass: (7.7 + 20 (1 − Cw)²) B (m). The waterplane coefficient Cw is taken
/// as (1 + 2 Cb)/3 (recalled). A channel that is wider than this counts as open water.
#[must_use]
pub fn width_of_influence_m(ship: &Particulars) -> f64 {
    let fine = 1.0 - (1.0 + 2.0 * ship.block_coefficient()) / 3.0;
    (7.7 + 20.0 * fine * fine) * ship.beam_m
}

/// Largest squat by Barrass with blockage: Cb S₂^(2/3) V^2.08/30 (m), V in knots, S₂ = S/(1 − S), S = B T/A with the
/// cross-section A of the water. The area A is at most the width of influence ([`width_of_influence_m`]) times the
/// depth, which is the value for open water.
///
/// The formula was read in two public programs, which agree (MIT Design Laboratory, "Ship squatting problem"; a squat
/// calculator of confined water). The formula is valid for blockages S of 0.1 to 0.266 (recalled).
///
/// # Panics
/// Panics if a number is NaN.
#[must_use]
pub fn barrass_channel_squat_m(
    ship: &Particulars,
    depth_m: f64,
    section_m2: f64,
    speed_mps: f64,
) -> f64 {
    assert!(!section_m2.is_nan(), "the section is a number");
    let open_m2 = width_of_influence_m(ship) * depth_m;
    let own_m2 = ship.beam_m * ship.draught_m;
    let least_m2 = own_m2 / MOST_BLOCKAGE;
    let section_m2 = greater(lesser(section_m2, open_m2), least_m2);
    let knots = speed_mps.abs() * KNOTS_PER_MPS;
    let returns = own_m2 / (section_m2 - own_m2);
    ship.block_coefficient() * libm::pow(returns, 2.0 / 3.0) * libm::pow(knots, 2.08) / 30.0
}

/// Coefficients of Huuska's factor: 7.45 s + 0.76.
const HUUSKA: [f64; 2] = [7.45, 0.76];
/// Section of the ship amidships over beam times draught, in the blockage of [`icorels_channel_squat_m`].
const MIDSHIP: f64 = 0.98;

/// Width of the water from which on [`icorels_channel_squat_m`] is [`icorels_squat_m`] at every depth (m): 30.4 beams, where
/// Huuska's factor is 1 for a ship that touches the bottom.
#[must_use]
pub fn width_of_blockage_m(ship: &Particulars) -> f64 {
    let [slope, open] = HUUSKA;
    MIDSHIP * slope / (1.0 - open) * ship.beam_m
}

/// Squat at the bow by ICORELS with blockage: [`icorels_squat_m`] times the factor 7.45 s + 0.76 (Huuska 1976), at least 1,
/// with the blockage s = 0.98 B T/A in the cross-section A of the water. A is at least the ship's own section.
///
/// Read in the squat calculator of the Finnish transport agency (a public program, with the formulas of its predecessor in
/// comments), and in an older Dutch program that has the same factor. The Finnish program applies the factor above a
/// blockage of 0.03; we take the greater of factor and 1, which is continuous, and differs from 0.03 to 0.032 by 2 %. The
/// correction of Guliev for dredged trenches, whose flanks are under water, is left out: a section over submerged flanks
/// has their water in A.
///
/// # Errors
/// As [`icorels_squat_m`].
///
/// # Panics
/// If the section is NaN.
pub fn icorels_channel_squat_m(
    ship: &Particulars,
    depth_m: f64,
    section_m2: f64,
    speed_mps: f64,
) -> Result<f64, HydroError> {
    assert!(!section_m2.is_nan(), "the section is a number");
    let own_m2 = MIDSHIP * ship.beam_m * ship.draught_m;
    let blockage = own_m2 / greater(section_m2, own_m2);
    let [slope, open] = HUUSKA;
    let factor = greater(slope * blockage + open, 1.0);
    Ok(factor * icorels_squat_m(ship, depth_m, speed_mps)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: s = 0.98 · 32.26 · 11.9/(200 · 14) = 0.13436, the factor 1.7610; ICORELS with Fh² = 4.6300²/(9.80665 · 14)
    /// = 0.15614: 2.4 · 0.78 · 32.26 · 11.9/190 · 0.15614/√0.84386 = 0.64288 m.
    #[test]
    fn icorels_in_a_canal_of_200_m_has_the_squat_by_hand() {
        let ship = Particulars::from_block(190.0, 32.26, 11.9, 0.78).unwrap();
        let squat_m = |section_m2: f64| {
            icorels_channel_squat_m(&ship, 14.0, section_m2, 9.0 / KNOTS_PER_MPS).unwrap()
        };
        let open_m = icorels_squat_m(&ship, 14.0, 9.0 / KNOTS_PER_MPS).unwrap();
        assert_eq!(squat_m(f64::INFINITY), open_m);
        assert!((open_m - 0.642_88).abs() < 5e-4, "{open_m}");
        assert!((squat_m(200.0 * 14.0) / open_m - 1.7610).abs() < 1e-4);
        assert_eq!(squat_m(14.0 * width_of_blockage_m(&ship)), open_m);
        let widths_m = [1e9, 1000.0, 900.0, 400.0, 200.0, 100.0, 40.0, 27.0, 0.0];
        let all = widths_m.map(|width_m| squat_m(width_m * 14.0));
        assert!(all.windows(2).all(|pair| pair[0] <= pair[1]) && all[8].is_finite(), "{all:?}");
    }

    /// The worked case of a public sheet: 0.60 m in open water, 0.74 m in a channel 200 m wide.
    #[test]
    fn a_channel_of_200_m_makes_the_ship_of_the_worked_case_squat_by_074_m() {
        let ship = Particulars::from_block(190.0, 32.26, 11.9, 0.78).unwrap();
        let squat_m =
            |section_m2: f64| barrass_channel_squat_m(&ship, 14.0, section_m2, 9.0 / KNOTS_PER_MPS);
        assert!((squat_m(f64::INFINITY) - 0.60).abs() < 0.005, "{}", squat_m(f64::INFINITY));
        assert!((squat_m(200.0 * 14.0) - 0.74).abs() < 0.005, "{}", squat_m(200.0 * 14.0));
        // Never less in a narrower channel, and finite in one that she fills.
        let widths_m = [1e9, 400.0, 300.0, 250.0, 200.0, 150.0, 100.0, 40.0, 0.0];
        let all = widths_m.map(|width_m| squat_m(width_m * 14.0));
        assert!(all.windows(2).all(|pair| pair[0] <= pair[1]) && all[8].is_finite(), "{all:?}");
        assert_eq!(squat_m(0.0), squat_m(40.0 * 14.0));
    }
}
