//! Wind coefficients from a table that the user gives.

use std::sync::Arc;

use crate::environment::LoadTable;
use crate::environment::wind::above_water::AboveWater;
use crate::environment::wind::coefficients::WindCoefficients;

/// A table of wind coefficients that the user gives: from a wind tunnel, from a computation, or read off a guideline's
/// curves.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnWindTable {
    /// The table.
    pub loads: Arc<LoadTable>,
    /// The height above the water to which the wind speed of the coefficients refers (m).
    pub reference_height_m: f64,
    /// The source of the table, in the user's words.
    pub source: Arc<str>,
}

impl OwnWindTable {
    /// Wind coefficients of the user's table at an angle from −π to π.
    pub(super) fn coefficients(&self, ship: &AboveWater, angle_rad: f64) -> WindCoefficients {
        let [surge_m2, sway_m2, yaw_m3] = self.loads.at(angle_rad, None);
        WindCoefficients {
            surge: surge_m2 / ship.frontal_m2,
            sway: sway_m2 / ship.lateral_m2,
            yaw: yaw_m3 / (ship.lateral_m2 * ship.length_m),
        }
    }
}
