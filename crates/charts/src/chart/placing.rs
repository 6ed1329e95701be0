//! Converts the coordinates of a chart into coordinates of the scenario, and sets the limits of a chart's size.

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::chart::GeographicPlace;

use super::projection::Projected;

/// Largest numbers of features and of points of a chart: enough for a whole cell of an electronic chart (US4MD81M has
/// 5,000 features of the classes that are read, and 360,000 points).
pub(super) const MOST_FEATURES: usize = 50_000;
pub(super) const MOST_POINTS: usize = 500_000;
/// Size of the largest chart file that is read (bytes), the same as for every file that a scenario names.
pub(super) const LARGEST_FILE: usize = 16 << 20;
/// Largest distance of a chart's point from the scenario's origin (m). A point that is farther has swapped coordinates,
/// or belongs to another place.
const FARTHEST_M: f64 = 200e3;

/// How the coordinates in the chart files become coordinates of the scenario.
#[derive(Clone, Debug)]
pub enum Placing {
    /// The coordinates in the files are metres east and north.
    Metres,
    /// The coordinates in the files are degrees of longitude and latitude.
    Degrees(Projected),
}

impl Placing {
    /// Converts a position in a file into metres north and east of the scenario's origin.
    ///
    /// # Errors
    /// Says why the numbers are not a position in the chart.
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
            Placing::Metres => "in GeoJSON, east stands before north",
            Placing::Degrees(_) => "in GeoJSON, longitude stands before latitude",
        };
        Err(format!(
            "[{x}, {y}] is more than {} km from the scenario's origin; {help}",
            FARTHEST_M / 1e3
        ))
    }
}

/// How many more features and points a chart may have while it is read.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    pub(super) features: usize,
    pub(super) points: usize,
}

impl Budget {
    /// The largest numbers of features and points of a whole chart.
    pub const OF_CHART: Budget = Budget { features: MOST_FEATURES, points: MOST_POINTS };
}
