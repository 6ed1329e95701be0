//! Squat by three formulas for open water of PIANC (Harbour Approach Channels, report 121, 2014). The squat formulas
//! were read in public programs that agree (the first two in stebiondi/pyCoastal), and compared with independently
//! calculated numbers. Each squat formula refuses water that is not deeper than the draught.

use super::limits::draught_over_depth;
use crate::constants::{KNOTS_PER_MPS, STANDARD_GRAVITY_MPS2};
use crate::hydro::error::HydroError;
use crate::hydro::particulars::Particulars;

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
