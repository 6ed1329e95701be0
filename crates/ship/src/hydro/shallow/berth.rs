//! Cross-flow drag of a ship in shallow water at low speed: at her berth, crabbing, adrift.

use fenderline_contact::number::greater;

use super::limits::draught_over_depth;
use crate::hydro::error::{HydroError, within};
use crate::hydro::particulars::Particulars;
use crate::hydro::quantities::Water;

/// Drag coefficient of a hull abeam to the flow, without water under the keel, by UFC 4-159-03 (from memory).
const BLOCKED_DRAG: f64 = 3.2;

/// Force (N) of a current abeam on a ship at rest in water of a given depth, in the direction of the current, by UFC
/// 4-159-03: ½ρ V² L T C_y with C_y = C₀ + (3.2 − C₀)(T/h)² and C₀ = 0.22 √(L² A_m/(B∇)).
///
/// `midship_coefficient` is A_m/(B T).
///
/// # Errors
/// Fails with [`HydroError::Aground`], or with [`HydroError::OutOfRange`] for a midship coefficient outside 0.3 to 1.
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

/// Cross-flow drag coefficient in water of a given depth, from the coefficient C in deep water: C + (3.2 − C)(T/h)².
/// The dependence on depth is that of UFC 4-159-03, but with the ship's own coefficient C in place of the manual's C₀
/// (our choice). For the container ship in deep water C and C₀ are close: 0.60 by Hoerner and 0.67 by UFC.
///
/// # Errors
/// [`HydroError::Aground`].
pub fn shallow_cross_flow_drag(
    ship: &Particulars,
    deep: f64,
    depth_m: f64,
) -> Result<f64, HydroError> {
    Ok(grown(deep, draught_over_depth(ship, depth_m)?))
}

/// Gives the drag coefficient as [`shallow_cross_flow_drag`] does, but for any depth. For a ship aground the drag
/// coefficient is 3.2, as for a ship that just touches the bottom.
pub(super) fn drag_to_the_bottom(ship: &Particulars, deep: f64, depth_m: f64) -> f64 {
    grown(deep, ship.draught_m / greater(depth_m, ship.draught_m))
}

fn grown(deep: f64, draught_over_depth: f64) -> f64 {
    deep + (BLOCKED_DRAG - deep) * draught_over_depth * draught_over_depth
}
