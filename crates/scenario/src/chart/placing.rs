//! From the coordinates of a chart to those of the scenario, and the limits of a chart.

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::chart::GeographicPlace;

use super::projection::Projected;

/// Most features, and most points, of a chart: a cell of an electronic chart in full (US4MD81M: 5,000 features of the
/// classes that are read, 360,000 points).
pub(super) const MOST_FEATURES: usize = 50_000;
pub(super) const MOST_POINTS: usize = 500_000;
/// Largest file (bytes), as of every file that a scenario names.
pub(super) const LARGEST_FILE: usize = 16 << 20;
/// Farthest point from the scenario's origin (m). One that is farther has swapped coordinates, or belongs to another place.
const FARTHEST_M: f64 = 200e3;

/// From the coordinates of the files to those of the scenario.
#[derive(Clone, Debug)]
pub(crate) enum Placing {
    /// They are metres east and north.
    Metres,
    /// They are degrees of longitude and latitude.
    Degrees(Projected),
}

impl Placing {
    /// A position of a file in metres north and east.
    ///
    /// # Errors
    /// Why it is not one.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> Result<Vec2, String> {
        let at_m = match self {
            Placing::Metres => vec2(y, x),
            Placing::Degrees(projected) => {
                if !(x.abs() <= 180.0 && y.abs() <= 90.0) {
                    return Err(format!("[{x}, {y}] is not a longitude and a latitude in degrees"));
                }
                projected.to_m(GeographicPlace {
                    latitude_rad: y.to_radians(),
                    longitude_rad: x.to_radians(),
                })
            }
        };
        if at_m.length() <= FARTHEST_M {
            return Ok(at_m);
        }
        let help = match self {
            Placing::Metres => "GeoJSON has east before north",
            Placing::Degrees(_) => "GeoJSON has longitude before latitude",
        };
        Err(format!(
            "[{x}, {y}] is more than {} km from the scenario's origin; {help}",
            FARTHEST_M / 1e3
        ))
    }
}

/// What is left of the limits while a chart is read.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget {
    pub(super) features: usize,
    pub(super) points: usize,
}

impl Budget {
    /// The limits of a chart.
    pub(crate) const OF_CHART: Budget = Budget { features: MOST_FEATURES, points: MOST_POINTS };
}
