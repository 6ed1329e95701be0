//! Wind coefficients of the user's own: from a table.

use std::sync::Arc;

use crate::environment::LoadTable;
use crate::environment::wind::{ShipWindage, WindCoefficients};

/// Wind coefficients by a table of the user's: of a wind tunnel, of a computation, or read off a guideline's curves.
#[derive(Clone, Debug, PartialEq)]
pub struct OwnWindTable {
    /// The table.
    pub loads: Arc<LoadTable>,
    /// Height above the water of the wind speed to which the coefficients refer (m).
    pub reference_height_m: f64,
    /// Where the table comes from, in the user's words.
    pub source: Arc<str>,
}

impl OwnWindTable {
    /// Coefficients at an angle from −π to π.
    pub(super) fn coefficients(&self, ship: &ShipWindage, angle_rad: f64) -> WindCoefficients {
        let [surge_m2, sway_m2, yaw_m3] = self.loads.at(angle_rad, None);
        WindCoefficients {
            surge: surge_m2 / ship.frontal_m2,
            sway: sway_m2 / ship.lateral_m2,
            yaw: yaw_m3 / (ship.lateral_m2 * ship.length_m),
        }
    }
}
