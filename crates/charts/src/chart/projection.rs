//! Converts longitude and latitude into metres: the transverse Mercator projection of the WGS 84 ellipsoid, by Krüger's
//! series.
//!
//! The equations of the projection are from Karney, "Transverse Mercator with an accuracy of a few nanometers", Journal
//! of Geodesy 85 (2011) 475–485: conformal latitude by eq. 7 to 9, the sphere's projection by eq. 10, the series by eq.
//! 11 with the coefficients of eq. 35 to sixth order, the meridian's length by eq. 14. We wrote the coefficients of the
//! series from memory; `tests/chart_projection.rs` compares the projection with PROJ. The projection is our own code
//! because libraries use the sine and cosine of the operating system, whose last bits differ from machine to machine. A
//! quay may be taken from a chart, so the results of a run would differ in their last bits.

use fenderline_contact::{Vec2, vec2};

use fenderline_keys::keys::chart::Projection;
use fenderline_sim::chart::GeographicPlace;

/// Equatorial radius of the WGS 84 ellipsoid (m), and the ellipsoid's flattening.
const EQUATOR_M: f64 = 6_378_137.0;
const FLATTENING: f64 = 1.0 / 298.257_223_563;
/// Scale of UTM at its central meridian, and half the width of a zone (rad).
const UTM_SCALE: f64 = 0.9996;
const HALF_ZONE_RAD: f64 = core::f64::consts::PI / 60.0;

/// A projection of places on WGS 84 to metres north and east of an origin.
#[derive(Clone, Debug)]
pub struct Projected {
    central_meridian_rad: f64,
    scale: f64,
    series: Series,
    origin_m: Vec2,
}

impl Projected {
    /// Makes the projection about an origin.
    pub fn about(origin: GeographicPlace, projection: Projection) -> Projected {
        let (central_meridian_rad, scale) = match projection {
            Projection::ThroughOrigin => (origin.longitude_rad, 1.0),
            Projection::Utm => (zone_meridian_rad(origin.longitude_rad), UTM_SCALE),
        };
        let series = Series::of(FLATTENING / (2.0 - FLATTENING));
        let mut projected = Projected { central_meridian_rad, scale, series, origin_m: Vec2::ZERO };
        projected.origin_m = projected.to_m(origin);
        projected
    }

    /// Makes the UTM projection, in the UTM zone of an origin.
    pub fn utm(origin: GeographicPlace) -> Projected {
        Projected::about(origin, Projection::Utm)
    }

    /// The projected coordinates of the origin: metres north of the equator and east of the central meridian.
    pub fn origin_m(&self) -> Vec2 {
        self.origin_m
    }

    /// Converts a point, given in metres north and east of the projection's `origin`, into latitude and longitude: the
    /// inverse of [`Projected::to_m`].
    ///
    /// The function projects a trial place, and moves the trial place by the remaining error as on a sphere, in several
    /// rounds. Grid north differs from true north by a few degrees at most, so each round makes the error at least ten
    /// times smaller; the number of rounds is fixed, so that the bits are the same everywhere.
    pub fn to_place(&self, at_m: Vec2, origin: GeographicPlace) -> GeographicPlace {
        const ROUNDS: usize = 12;
        let mut place = origin;
        for _ in 0..ROUNDS {
            let missing_m = at_m - self.to_m(place);
            place.latitude_rad += missing_m.x / EQUATOR_M;
            place.longitude_rad += missing_m.y / (EQUATOR_M * libm::cos(place.latitude_rad));
        }
        place
    }

    /// Converts latitude and longitude into metres north and east of the origin.
    pub fn to_m(&self, place: GeographicPlace) -> Vec2 {
        let east_rad = wrapped(place.longitude_rad - self.central_meridian_rad);
        let conformal = tan_of_conformal_latitude(place.latitude_rad);
        let (sin, cos) = libm::sincos(east_rad);
        // Eq. 10: the sphere of conformal latitudes, projected.
        let xi = libm::atan2(conformal, cos);
        let eta = libm::asinh(sin / libm::hypot(conformal, cos));
        let (xi, eta) = self.series.to_ellipsoid(xi, eta);
        let radius_m = self.scale * self.series.rectifying_radius_m;
        vec2(radius_m * xi, radius_m * eta) - self.origin_m
    }
}

/// The tangent of the conformal latitude, by eq. 7 to 9 of Karney.
fn tan_of_conformal_latitude(latitude_rad: f64) -> f64 {
    let eccentricity = libm::sqrt(FLATTENING * (2.0 - FLATTENING));
    let tan = libm::tan(latitude_rad);
    let secant = libm::hypot(1.0, tan);
    let sigma = libm::sinh(eccentricity * libm::atanh(eccentricity * tan / secant));
    tan * libm::hypot(1.0, sigma) - sigma * secant
}

/// The coefficients of Karney's eq. 35 for an ellipsoid with the third flattening n, and the radius of a circle whose
/// circumference is the length of the ellipsoid's meridian.
#[derive(Clone, Debug)]
struct Series {
    alpha: [f64; 6],
    rectifying_radius_m: f64,
}

impl Series {
    fn of(n: f64) -> Series {
        let (n2, n3) = (n * n, n * n * n);
        let (n4, n5, n6) = (n2 * n2, n2 * n3, n3 * n3);
        let alpha = [
            n / 2.0 - 2.0 / 3.0 * n2 + 5.0 / 16.0 * n3 + 41.0 / 180.0 * n4 - 127.0 / 288.0 * n5
                + 7891.0 / 37_800.0 * n6,
            13.0 / 48.0 * n2 - 3.0 / 5.0 * n3 + 557.0 / 1440.0 * n4 + 281.0 / 630.0 * n5
                - 1_983_433.0 / 1_935_360.0 * n6,
            61.0 / 240.0 * n3 - 103.0 / 140.0 * n4
                + 15_061.0 / 26_880.0 * n5
                + 167_603.0 / 181_440.0 * n6,
            49_561.0 / 161_280.0 * n4 - 179.0 / 168.0 * n5 + 6_601_661.0 / 7_257_600.0 * n6,
            34_729.0 / 80_640.0 * n5 - 3_418_889.0 / 1_995_840.0 * n6,
            212_378_941.0 / 319_334_400.0 * n6,
        ];
        let rectifying_radius_m = EQUATOR_M / (1.0 + n) * (1.0 + n2 / 4.0 + n4 / 64.0 + n6 / 256.0);
        Series { alpha, rectifying_radius_m }
    }

    /// Converts the projection of the sphere into the projection of the ellipsoid, by eq. 11 of Karney.
    fn to_ellipsoid(&self, xi: f64, eta: f64) -> (f64, f64) {
        let (mut north, mut east) = (xi, eta);
        let mut double = 0.0;
        for alpha in self.alpha {
            double += 2.0;
            let (sin, cos) = libm::sincos(double * xi);
            north += alpha * sin * libm::cosh(double * eta);
            east += alpha * cos * libm::sinh(double * eta);
        }
        (north, east)
    }
}

/// The central meridian of the zone of 6 degrees in which a longitude lies.
fn zone_meridian_rad(longitude_rad: f64) -> f64 {
    let zone = libm::floor(longitude_rad / (2.0 * HALF_ZONE_RAD));
    (2.0 * zone + 1.0) * HALF_ZONE_RAD
}

/// The same direction as an angle between half a turn to the west and half a turn to the east.
fn wrapped(angle_rad: f64) -> f64 {
    let turn = 2.0 * core::f64::consts::PI;
    angle_rad - turn * libm::rint(angle_rad / turn)
}
