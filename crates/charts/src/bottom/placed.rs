//! Converts the coordinates of a survey into coordinates of the scenario.

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::chart::GeographicPlace;

use crate::chart::projection::Projected;

/// Largest distance of a survey's place from the scenario's origin (m), the same as for a chart.
const FARTHEST_M: f64 = 200e3;
/// The false easting of UTM, and the false northing of UTM in the southern hemisphere (m).
const FALSE_EASTING_M: f64 = 500e3;
const FALSE_NORTHING_M: f64 = 10_000e3;

/// The kind of coordinates that a survey has, with the data that convert them.
pub(super) enum Place {
    /// Distances east and north of the scenario's origin (m).
    Metres,
    /// Longitude and latitude (degrees).
    Degrees(Projected),
    /// Easting and northing of UTM, in the UTM zone of the scenario's origin (m).
    Utm {
        /// The UTM projection, shifted so that the scenario's origin is at 0, 0.
        utm: Projected,
        /// The scenario's own projection; `None` if the scenario uses UTM.
        own: Option<Projected>,
        /// The scenario's origin.
        origin: GeographicPlace,
    },
}

impl Place {
    /// The shift (north, east) that is added to the survey's coordinates to get the scenario's; `None` if a shift is
    /// not enough for the conversion.
    pub(super) fn shift_m(&self) -> Option<Vec2> {
        match self {
            Place::Metres => Some(Vec2::ZERO),
            Place::Utm { utm, own: None, origin } => Some(-utm_origin_m(utm, *origin)),
            Place::Degrees(_) | Place::Utm { .. } => None,
        }
    }

    /// Converts a place of the survey (x, y) into metres north and east of the scenario's origin.
    pub(super) fn to_m(&self, [x, y]: [f64; 2]) -> Vec2 {
        match self {
            Place::Metres => vec2(y, x),
            Place::Degrees(projected) => projected.to_m(geographic([x, y])),
            Place::Utm { utm, own, origin } => {
                let of_utm_m = vec2(y, x) - utm_origin_m(utm, *origin);
                match own {
                    None => of_utm_m,
                    Some(own) => own.to_m(utm.to_place(of_utm_m, *origin)),
                }
            }
        }
    }

    /// Checks that a place of the survey is near the scenario's origin.
    ///
    /// # Errors
    /// Returns the reason why the place is refused, and advice for the user.
    pub(super) fn check(&self, at: [f64; 2]) -> Result<(), (String, &'static str)> {
        let [x, y] = at;
        let is_degrees = |x: f64, y: f64| x.abs() <= 180.0 && y.abs() <= 90.0;
        if matches!(self, Place::Degrees(_)) && !is_degrees(x, y) {
            let help = match is_degrees(y, x) {
                true => {
                    "the columns seem to have latitude before longitude: longitude must come first"
                }
                false => "coordinates in metres need survey_coordinates = \"metres\" or \"utm\"",
            };
            return Err((format!("[{x}, {y}] is not a longitude and a latitude in degrees"), help));
        }
        // Far from the origin, the conversion does not end.
        let is_near = |at: [f64; 2]| {
            let is_sane = at.iter().all(|value| value.abs() <= 2e7);
            is_sane && self.to_m(at).length() <= FARTHEST_M
        };
        let is_far_in_utm = matches!(self, Place::Utm { utm, origin, .. }
            if (vec2(y, x) - utm_origin_m(utm, *origin)).length() > FARTHEST_M);
        if !is_far_in_utm && is_near(at) {
            return Ok(());
        }
        let swapped = [y, x];
        let help = match self {
            Place::Degrees(_) if is_degrees(y, x) && is_near(swapped) => {
                "the columns have latitude before longitude: longitude must come first"
            }
            Place::Metres if x.abs() >= 1e5 || y.abs() >= 2e5 => {
                "eastings and northings of UTM need survey_coordinates = \"utm\""
            }
            _ => {
                "the survey is of another place, or its coordinates are not those that `survey_coordinates` says"
            }
        };
        let far_km = FARTHEST_M / 1e3;
        Err((format!("[{x}, {y}] is more than {far_km} km from the scenario's origin"), help))
    }
}

fn geographic([longitude, latitude]: [f64; 2]) -> GeographicPlace {
    GeographicPlace { latitude_rad: latitude.to_radians(), longitude_rad: longitude.to_radians() }
}

/// Northing and easting of the scenario's origin in UTM (m).
fn utm_origin_m(utm: &Projected, origin: GeographicPlace) -> Vec2 {
    let false_northing_m = if origin.latitude_rad < 0.0 { FALSE_NORTHING_M } else { 0.0 };
    utm.origin_m() + vec2(false_northing_m, FALSE_EASTING_M)
}
