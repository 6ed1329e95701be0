//! Keys of the chart.

use serde_json::json;

use crate::choices::{Choice, Choices};
use crate::held::{Name, Number, OneOf, TableOf, Texts};
use crate::spec::Absent::{Is, Means, Refused, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static CHART: TableSpec = TableSpec {
    what: "a chart",
    doc: "A chart from GeoJSON files, which is drawn behind ships and quays. A chart exerts no \
          force, but its land and quays may be `solid`, bodies may take their outlines from the chart (`chart_outline`), and \
          `environment.bottom` takes depths from the chart. A feature of the files has the \
          property `kind`, such as \"coast\", \"depth_area\" or \"quay\"; or the feature comes from \
          an electronic chart (S-57) in the form in which GDAL writes it: the property `OBJL` or \
          the `name` of the file then says the class of the feature. `check` prints which features \
          of the files were read and which were left out.",
    keys: ChartKey::ALL,
    rules: Some(|| {
        json!({
            "allOf": [{ "properties": { "files": { "minItems": 1 }, "solid": { "minItems": 1 } } }],
            "dependentRequired": {
                "solid": ["solid_material"], "solid_material": ["solid"], "solid_width": ["solid"]
            },
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
            "GeoJSON files of the chart, named relative to the scenario file.",
            &["[\"harbour.geojson\"]"],
        ),
        COORDINATES: OneOf<Coordinates> = key(
            "coordinates",
            Kind::Choice(&COORDINATES),
            Refused,
            "Kind of coordinates in the GeoJSON files: metres, or longitude and latitude.",
            &["\"longitude_latitude\""],
        ),
        PROJECTION: OneOf<Projection> = key(
            "projection",
            Kind::Choice(&PROJECTIONS),
            Unless("`coordinates` is \"metres\""),
            "Projection that turns longitude and latitude into metres north and east.",
            &["\"transverse_mercator\""],
        ),
        ORIGIN: TableOf<ChartOriginKey> = key(
            "origin",
            Kind::Table(&PLACE),
            Unless("`coordinates` is \"metres\""),
            "Latitude and longitude of the scenario's origin.",
            &["{ latitude = \"53.52 deg\", longitude = \"9.94 deg\" }"],
        ),
        CLEARANCE_DATUM: Number = key(
            "clearance_datum",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: -50.0, high: 50.0 }),
            Unless("the chart has no bridge or cable with a clearance"),
            "Height above chart datum of the level of high water from which the chart gives the clearances \
             of bridges and cables, such as mean high water springs. Tide tables of the place have it.",
            &["\"3.2 m\""],
        ),
        SOLID: Texts = key(
            "solid",
            Kind::Texts,
            Means("the chart exerts no force"),
            "Classes of features that are solid: ships that run into them feel contact forces. The \
             classes are those of S-57 (LNDARE, COALNE, SLCONS, PONTON, FLODOC, HULKES, MORFAC, \
             BUISGL), or the kinds coast, quay, pontoon, building and mooring. All of them together \
             are one fixed body named `shore`. Areas are solid as they are, and lines as strips of \
             `solid_width`; points are not taken. `check` prints what was taken.",
            &["[\"LNDARE\", \"SLCONS\"]"],
        ),
        SOLID_MATERIAL: Name = key(
            "solid_material",
            Kind::MaterialName,
            Unless("nothing is `solid`"),
            "Material of the contacts between the shore and each floating body. A pair of bodies that \
             names `shore` may give another material.",
            &[],
        ),
        SOLID_WIDTH: Number = key(
            "solid_width",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 50.0 }),
            Is("\"4 m\""),
            "Width of the strip that a solid line becomes, half of it on either side of the line. A \
             hull that comes through half of the width is pushed out on the other side.",
            &["\"2 m\""],
        ),
    }
}

pub(super) static PLACE: TableSpec = TableSpec {
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

/// Largest latitude of a chart (rad): 84 degrees, the range of UTM. Nearer to a pole, a plane chart with north up is of
/// little use.
const LATITUDE: f64 = 84.0 * core::f64::consts::PI / 180.0;
/// Half a turn (rad).
const LONGITUDE: f64 = core::f64::consts::PI;

/// What the coordinates in a GeoJSON file are: metres or degrees.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coordinates {
    /// The coordinates are metres east and north of the scenario's origin.
    Metres,
    /// The coordinates are longitude and latitude in degrees on WGS 84.
    LongitudeLatitude,
}

static COORDINATES: Choices<Coordinates> = Choices(&[
    Choice {
        word: "metres",
        value: Coordinates::Metres,
        doc: "Each position is the distance east, then the distance north, of the scenario's \
              origin (m).",
    },
    Choice {
        word: "longitude_latitude",
        value: Coordinates::LongitudeLatitude,
        doc: "Each position is longitude, then latitude, on WGS 84 (degrees), as the standard of \
              GeoJSON says (RFC 7946).",
    },
]);

/// A kind of transverse Mercator projection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Projection {
    /// The projection's central meridian runs through the scenario's origin and has scale 1.
    ThroughOrigin,
    /// UTM: the central meridian is that of the 6-degree zone in which the scenario's origin lies, and has scale
    /// 0.9996.
    Utm,
}

static PROJECTIONS: Choices<Projection> = Choices(&[
    Choice {
        word: "transverse_mercator",
        value: Projection::ThroughOrigin,
        doc: "Transverse Mercator projection whose central meridian runs through the scenario's \
            origin, with scale 1 there: true north is up at the origin, and distances near the \
            origin are true.",
    },
    Choice {
        word: "utm",
        value: Projection::Utm,
        doc: "Universal transverse Mercator (UTM) in the 6-degree zone of the scenario's origin, \
              without the exceptions for Norway and Svalbard: grid north is up, and distances are \
              grid distances, which differ from true distances by up to 0.1 %. The differences \
              between a survey's UTM coordinates and those of the origin are coordinates of the \
              scenario.",
    },
]);
