//! Keys of the chart.

use serde_json::json;

use crate::choices::{Choice, Choices};
use crate::held::{Number, OneOf, TableOf, Texts};
use crate::spec::Absent::{Refused, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static CHART: TableSpec = TableSpec {
    what: "a chart",
    doc: "A chart from GeoJSON files: drawn behind ships and quays. A chart exerts no force, but \
          bodies may take their outlines from it (`chart_outline`), and `environment.bottom` its \
          depths. A feature has the property `kind`, such as \"coast\", \"depth_area\" or \
          \"quay\"; or it is one of an electronic chart (S-57), as GDAL writes it: its property \
          `OBJL` or the `name` of the file says the class. `check` prints what was read and what \
          was left out.",
    keys: ChartKey::ALL,
    rules: Some(|| {
        json!({
            "allOf": [{ "properties": { "files": { "minItems": 1 } } }],
            "if": { "properties": { "coordinates": { "const": "metres" } } },
            "then": { "properties": { "projection": false, "origin": false } },
            "else": { "required": ["projection", "origin"] }
        })
    }),
};

table_keys! {
    /// Keys of a chart.
    pub ChartKey {
        FILES: Texts = key(
            "files",
            Kind::FileNames,
            Refused,
            "GeoJSON files, relative to the scenario file.",
            &["[\"harbour.geojson\"]"],
        ),
        COORDINATES: OneOf<Coordinates> = key(
            "coordinates",
            Kind::Choice(&COORDINATES),
            Refused,
            "Kind of coordinates in the files.",
            &["\"longitude_latitude\""],
        ),
        PROJECTION: OneOf<Projection> = key(
            "projection",
            Kind::Choice(&PROJECTIONS),
            Unless("`coordinates` is \"metres\""),
            "Projection of longitude and latitude to metres.",
            &["\"transverse_mercator\""],
        ),
        ORIGIN: TableOf<ChartOriginKey> = key(
            "origin",
            Kind::Table(&PLACE),
            Unless("`coordinates` is \"metres\""),
            "Latitude and longitude of the scenario's origin.",
            &["{ latitude = \"53.52 deg\", longitude = \"9.94 deg\" }"],
        ),
    }
}

static PLACE: TableSpec = TableSpec {
    what: "a place on the earth",
    doc: "A place on the WGS 84 ellipsoid.",
    keys: ChartOriginKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a place on the earth.
    pub ChartOriginKey {
        LATITUDE: Number = key(
            "latitude",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: -LATITUDE, high: LATITUDE }),
            Refused,
            "Latitude, north positive: at most 84 degrees.",
            &["\"53.52 deg\""],
        ),
        LONGITUDE: Number = key(
            "longitude",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: -LONGITUDE, high: LONGITUDE }),
            Refused,
            "Longitude, east positive.",
            &["\"9.94 deg\""],
        ),
    }
}

/// The range of UTM, beyond which a plane with north up is of little use (rad): 84 degrees.
const LATITUDE: f64 = 84.0 * core::f64::consts::PI / 180.0;
/// Half a turn (rad).
const LONGITUDE: f64 = core::f64::consts::PI;

/// What the coordinates of a GeoJSON file are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinates {
    /// Metres east and north of the scenario's origin.
    Metres,
    /// Degrees on WGS 84.
    LongitudeLatitude,
}

static COORDINATES: Choices<Coordinates> = Choices(&[
    Choice {
        word: "metres",
        value: Coordinates::Metres,
        doc: "East and north of the scenario's origin (m), in this order, as in every GeoJSON file.",
    },
    Choice {
        word: "longitude_latitude",
        value: Coordinates::LongitudeLatitude,
        doc: "Longitude and latitude on WGS 84 (degrees), as the standard of GeoJSON says (RFC 7946).",
    },
]);

/// A kind of transverse Mercator projection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// Central meridian through the origin, scale 1.
    ThroughOrigin,
    /// Central meridian of the origin's zone of 6 degrees, scale 0.9996.
    Utm,
}

static PROJECTIONS: Choices<Projection> = Choices(&[
    Choice {
        word: "transverse_mercator",
        value: Projection::ThroughOrigin,
        doc: "Transverse Mercator with its central meridian through the origin and scale 1 there: \
            true north is up at the origin, and distances near the origin are true.",
    },
    Choice {
        word: "utm",
        value: Projection::Utm,
        doc: "Universal transverse Mercator in the origin's zone of 6 degrees (without the \
              exceptions for Norway and Svalbard): grid north is up, and distances are grid \
              distances, up to 0.1 % off. Differences of UTM coordinates of a survey are \
              coordinates of the scenario.",
    },
]);
