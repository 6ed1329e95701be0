//! Finds geographic positions from positions in metres.

use core::fmt;

/// A geographic position in the reference system WGS 84.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GeoPoint {
    /// North positive (°).
    pub latitude_deg: f64,
    /// Longitude, east positive, from −180 up to 180 (°).
    pub longitude_deg: f64,
}

/// The geographic position of a scenario's origin. The scenario's axes point north and east.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChartOrigin {
    at: GeoPoint,
    /// Length of a degree of latitude and of longitude at the scenario's origin (m).
    metres_per_deg: [f64; 2],
}

/// A geographic position that cannot be a chart's origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OutOfChart(pub GeoPoint);

impl fmt::Display for OutOfChart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let GeoPoint { latitude_deg, longitude_deg } = self.0;
        // Absurd values are printed in powers of ten.
        let text = |deg: f64| match deg.abs() < 1e6 {
            true => format!("{deg}"),
            false => format!("{deg:e}"),
        };
        let [latitude_deg, longitude_deg] = [latitude_deg, longitude_deg].map(text);
        write!(
            f,
            "{latitude_deg}, {longitude_deg} cannot be a chart's origin: latitude must be within 85 degrees, longitude within 180"
        )
    }
}

impl std::error::Error for OutOfChart {}

/// Semi-major axis (m) and flattening of the ellipsoid of WGS 84.
const AXIS_M: f64 = 6_378_137.0;
const FLATTENING: f64 = 1.0 / 298.257_223_563;

impl Default for ChartOrigin {
    /// 0° N 0° E.
    fn default() -> ChartOrigin {
        ChartOrigin::at(GeoPoint { latitude_deg: 0.0, longitude_deg: 0.0 })
    }
}

impl ChartOrigin {
    /// Puts the origin of a scenario at the geographic position `at`.
    ///
    /// # Errors
    /// Fails for a latitude beyond 85°, where a plane chart is of little use, for a longitude beyond 180°, and for NaN.
    pub fn new(at: GeoPoint) -> Result<ChartOrigin, OutOfChart> {
        let good = at.latitude_deg.abs() <= 85.0 && at.longitude_deg.abs() <= 180.0;
        if !good {
            return Err(OutOfChart(at));
        }
        Ok(ChartOrigin::at(at))
    }

    /// Puts the origin at a geographic position without a check.
    fn at(at: GeoPoint) -> ChartOrigin {
        let latitude = at.latitude_deg.to_radians();
        let (sin, cos) = (libm::sin(latitude), libm::cos(latitude));
        let eccentricity_2 = FLATTENING * (2.0 - FLATTENING);
        let below = 1.0 - eccentricity_2 * sin * sin;
        // Radii of curvature along the meridian and across it.
        let along_m = AXIS_M * (1.0 - eccentricity_2) / (below * libm::sqrt(below));
        let across_m = AXIS_M / libm::sqrt(below);
        let per_deg = 1.0_f64.to_radians();
        ChartOrigin { at, metres_per_deg: [along_m * per_deg, across_m * cos * per_deg] }
    }

    /// The geographic position of a point north and east of the origin, on the plane that touches the ellipsoid at the
    /// origin. At middle latitudes, the position of a point 5 km away has an error below 1 m.
    #[must_use]
    pub fn place(&self, north_m: f64, east_m: f64) -> GeoPoint {
        let latitude_deg = self.at.latitude_deg + north_m / self.metres_per_deg[0];
        let longitude_deg = self.at.longitude_deg + east_m / self.metres_per_deg[1];
        GeoPoint {
            latitude_deg: libm::fmax(libm::fmin(latitude_deg, 90.0), -90.0),
            longitude_deg: longitude_deg - 360.0 * libm::round(longitude_deg / 360.0),
        }
    }

    /// How far a geographic position lies north and east of the origin (m), on the plane of [`ChartOrigin::place`].
    #[must_use]
    pub fn metres(&self, place: GeoPoint) -> [f64; 2] {
        let east_deg = place.longitude_deg - self.at.longitude_deg;
        let east_deg = east_deg - 360.0 * libm::round(east_deg / 360.0);
        let north_deg = place.latitude_deg - self.at.latitude_deg;
        [north_deg * self.metres_per_deg[0], east_deg * self.metres_per_deg[1]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Published lengths of a degree on WGS 84 (Wikipedia, "Latitude" and "Longitude"; recalled to the metre): 110,574 and 111,320 m at the equator, 111,132 and 78,847 m at 45°, 111,412 and 55,800 m at 60°.
    #[test]
    fn lengths_of_a_degree_match_published_ones() {
        for (latitude_deg, north_m, east_m) in
            [(0.0, 110_574.0, 111_320.0), (45.0, 111_132.0, 78_847.0), (60.0, 111_412.0, 55_800.0)]
        {
            let at = GeoPoint { latitude_deg, longitude_deg: 10.0 };
            let origin = ChartOrigin::new(at).expect("a place");
            assert!((origin.metres_per_deg[0] - north_m).abs() < 1.0, "{origin:?}");
            assert!((origin.metres_per_deg[1] - east_m).abs() < 1.0, "{origin:?}");
            let place = origin.place(0.01 * north_m, -0.02 * east_m);
            assert!((place.latitude_deg - latitude_deg - 0.01).abs() < 1e-6);
            assert!((place.longitude_deg - 9.98).abs() < 1e-6);
        }
        assert!(ChartOrigin::new(GeoPoint { latitude_deg: 86.0, longitude_deg: 0.0 }).is_err());
        assert!(ChartOrigin::new(GeoPoint { latitude_deg: f64::NAN, longitude_deg: 0.0 }).is_err());
    }

    #[test]
    fn longitudes_wrap_at_the_date_line() {
        let at = GeoPoint { latitude_deg: 0.0, longitude_deg: 179.999 };
        let origin = ChartOrigin::new(at).expect("a place");
        let place = origin.place(0.0, 1000.0);
        assert!(place.longitude_deg < -179.99, "{place:?}");
        let [north_m, east_m] = origin.metres(place);
        assert!(north_m.abs() < 1e-6 && (east_m - 1000.0).abs() < 1e-6);
    }
}
