//! How shallow water and how deep hulls the factors are for.

use crate::hydro::error::HydroError;
use crate::hydro::particulars::Particulars;

/// Depth over draught at which published tests end. Below it the factors are our extrapolation.
pub const PUBLISHED_RATIO: f64 = 1.2;

/// Depth over draught below which every factor is constant.
pub const SHALLOWEST_RATIO: f64 = 1.1;

/// Largest T/L for factors of N_r, much greater than those that were tested. Hulls with a greater T/L have the factors of this one,
/// because the formulas would become negative.
pub(super) const DEEPEST_HULL: f64 = 0.08;

/// T/h, below 1.
pub(super) fn draught_over_depth(ship: &Particulars, depth_m: f64) -> Result<f64, HydroError> {
    let draught_m = ship.draught_m;
    if depth_m > draught_m {
        return Ok(draught_m / depth_m);
    }
    Err(HydroError::Aground { depth_m, draught_m })
}
