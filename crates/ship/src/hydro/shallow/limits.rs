//! Limits on the depth of water and the draught of hulls for which the factors of shallow water are used.

use crate::hydro::error::HydroError;
use crate::hydro::particulars::Particulars;

/// Ratio of depth to draught at which published tests end. In shallower water than this ratio, the factors are our
/// extrapolation.
pub const PUBLISHED_RATIO: f64 = 1.2;

/// Ratio of depth to draught below which every factor of shallow water is constant.
pub const SHALLOWEST_RATIO: f64 = 1.1;

/// Largest ratio T/L for the factors on N_r, much greater than the ratios that were tested. Hulls with a greater T/L
/// have the factors of the largest T/L, because the formulas would become negative.
pub(super) const DEEPEST_HULL: f64 = 0.08;

/// T/h, below 1.
pub(super) fn draught_over_depth(ship: &Particulars, depth_m: f64) -> Result<f64, HydroError> {
    let draught_m = ship.draught_m;
    if depth_m > draught_m {
        return Ok(draught_m / depth_m);
    }
    Err(HydroError::Aground { depth_m, draught_m })
}
