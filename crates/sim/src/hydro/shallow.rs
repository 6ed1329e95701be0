//! What shallow water does to the hull: derivatives, squat, drag in a current.
//!
//! Squat formulas are recalled and cross-checked by the design sheet's numbers only; so is the drag of
//! UFC 4-159-03. Each refuses water that is no deeper than the draught.

use super::error::{HydroError, within};
use super::particulars::Particulars;
use super::quantities::Water;

/// Depth over draught from which on, downwards, every factor of shallow water is held: below it Ankudinov's
/// polynomial is not to be used, and Taimuri's powers grow without end.
pub const SHALLOWEST_RATIO: f64 = 1.1;

/// Drag coefficient of a hull abeam where no water passes under her keel, UFC 4-159-03.
const BLOCKED_DRAG: f64 = 3.2;

/// Acceleration of gravity [m/s²].
const GRAVITY_MPS2: f64 = 9.806_65;
/// Knots in a metre a second.
const KNOTS: f64 = 3600.0 / 1852.0;

/// Factor on Y_v by Taimuri et al. (2020): −T/h + (1 − T/h)^(−0.4 Cb B/T). 1 in deep water.
///
/// # Errors
/// [`HydroError::Aground`].
pub fn shallow_sway_derivative(ship: &Particulars, depth_m: f64) -> Result<f64, HydroError> {
    let ratio = draught_over_depth(ship, depth_m)?;
    let power = -0.4 * ship.block_coefficient() * ship.beam_m / ship.draught_m;
    Ok(-ratio + libm::pow(1.0 - ratio, power))
}

/// Factor on N_r by Taimuri et al. (2020): −T/h + (1 − T/h)^(14.28 T/L − 1.5). 1 in deep water.
///
/// # Errors
/// [`HydroError::Aground`].
pub fn shallow_yaw_derivative(ship: &Particulars, depth_m: f64) -> Result<f64, HydroError> {
    let ratio = draught_over_depth(ship, depth_m)?;
    let power = 14.28 * ship.draught_m / ship.length_m - 1.5;
    Ok(-ratio + libm::pow(1.0 - ratio, power))
}

/// Largest squat in open shallow water by Barrass: Cb V²/100 [m], V in knots. For h/T 1.1 to 1.4.
///
/// # Errors
/// [`HydroError::Aground`].
pub fn barrass_squat_m(
    ship: &Particulars,
    depth_m: f64,
    speed_mps: f64,
) -> Result<f64, HydroError> {
    draught_over_depth(ship, depth_m)?;
    let knots = speed_mps * KNOTS;
    Ok(ship.block_coefficient() * knots * knots / 100.0)
}

/// Squat at the bow by ICORELS: 2.4 ∇/L² Fh²/√(1 − Fh²) [m], Fh = V/√(gh).
///
/// # Errors
/// [`HydroError::Aground`]; [`HydroError::Supercritical`] from Fh = 1.
pub fn icorels_squat_m(
    ship: &Particulars,
    depth_m: f64,
    speed_mps: f64,
) -> Result<f64, HydroError> {
    draught_over_depth(ship, depth_m)?;
    let square = speed_mps * speed_mps / (GRAVITY_MPS2 * depth_m);
    if square.is_nan() || square >= 1.0 {
        return Err(HydroError::Supercritical { froude: square.sqrt() });
    }
    let slender_m = ship.volume_m3 / (ship.length_m * ship.length_m);
    Ok(2.4 * slender_m * square / (1.0 - square).sqrt())
}

/// Squat at the bow in unrestricted shallow water by Eryuzlu et al. (1994):
/// 0.298 h²/T (V/√(gT))^2.289 (h/T)^−2.972 [m].
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
    let froude = speed_mps.abs() / (GRAVITY_MPS2 * draught_m).sqrt();
    Ok(0.298 * depth_m * depth_m / draught_m * libm::pow(froude, 2.289) * libm::pow(ratio, -2.972))
}

/// Force [N] of a current abeam on a ship that lies in water of a depth, UFC 4-159-03:
/// ½ρ V² L T C_y, C_y = C₀ + (3.2 − C₀)(T/h)², C₀ = 0.22 √(L² A_m/(B∇)), of the current's sign.
///
/// `midship_coefficient` is A_m/(B T).
///
/// # Errors
/// [`HydroError::Aground`]; [`HydroError::OutOfRange`] for a midship coefficient outside 0.3 to 1.
pub fn current_abeam_n(
    ship: &Particulars,
    midship_coefficient: f64,
    depth_m: f64,
    current_mps: f64,
    water: Water,
) -> Result<f64, HydroError> {
    let ratio = draught_over_depth(ship, depth_m)?;
    within("midship coefficient", midship_coefficient, 0.3, 1.0)?;
    let section_m2 = midship_coefficient * ship.beam_m * ship.draught_m;
    let slender = ship.length_m * ship.length_m * section_m2 / (ship.beam_m * ship.volume_m3);
    let deep = 0.22 * slender.sqrt();
    let coefficient = deep + (BLOCKED_DRAG - deep) * ratio * ratio;
    let side_m2 = ship.length_m * ship.draught_m;
    Ok(0.5 * water.density_kgpm3 * side_m2 * coefficient * current_mps * current_mps.abs())
}

/// Drag coefficient across a ship in water of a depth from that in deep water, C + (3.2 − C)(T/h)²: the form of
/// UFC 4-159-03 with the ship's own coefficient for C₀ (ours). The two coefficients of the container ship in deep
/// water, Hoerner's 0.60 and UFC's 0.67, are near each other.
///
/// # Errors
/// [`HydroError::Aground`].
pub fn shallow_cross_flow_drag(
    ship: &Particulars,
    deep: f64,
    depth_m: f64,
) -> Result<f64, HydroError> {
    let ratio = draught_over_depth(ship, depth_m)?;
    Ok(deep + (BLOCKED_DRAG - deep) * ratio * ratio)
}

/// T/h, below 1.
fn draught_over_depth(ship: &Particulars, depth_m: f64) -> Result<f64, HydroError> {
    let draught_m = ship.draught_m;
    if depth_m > draught_m {
        return Ok(draught_m / depth_m);
    }
    Err(HydroError::Aground { depth_m, draught_m })
}
