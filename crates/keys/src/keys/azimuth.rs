//! Keys of azimuth units.

use super::quantities::PLACE;
use crate::held::Number;
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

/// An azimuth unit.
pub static AZIMUTH: TableSpec = TableSpec {
    what: "an azimuth unit",
    doc: "An azimuth unit: a propeller that turns about the vertical. The thrust falls with the \
          speed through the water like the thrust of an open propeller of the Wageningen series \
          B4-70 with pitch ratio 1.0; the thrust of a ducted propeller would fall more.",
    keys: AzimuthKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of an azimuth unit.
    pub AzimuthKey {
        ALONG: Number = key(
            "along",
            Kind::Quantity(PLACE),
            Refused,
            "Distance of the azimuth unit forward of midship.",
            &["\"-12 m\""],
        ),
        ACROSS: Number = key(
            "across",
            Kind::Quantity(PLACE),
            Is("0"),
            "Distance of the azimuth unit to starboard of the centre line.",
            &["\"2.6 m\""],
        ),
        FORCE: Number = key(
            "force",
            Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e8 }),
            Refused,
            "Thrust of the azimuth unit at zero speed and full power, which is the unit's part of \
             the bollard pull.",
            &["\"30 tf\""],
        ),
        DIAMETER: Number = key(
            "diameter",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.01, high: 50.0 }),
            Refused,
            "Diameter of the propeller; a smaller propeller loses less thrust with speed.",
            &["\"2.4 m\""],
        ),
        RATE: Number = key(
            "rate",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: 1e-4, high: 10.0 }),
            Is("\"12 deg/s\""),
            "Rate at which the azimuth unit turns about the vertical.",
            &["\"18 deg/s\""],
        ),
        LAG: Number = key(
            "lag",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 600.0 }),
            Is("3"),
            "Time constant with which the thrust follows the ordered power.",
            &["\"4 s\""],
        ),
        STOP: Number = key(
            "stop",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: 0.01, high: 3.1 }),
            Means("the unit turns all the way round"),
            "Largest angle of the azimuth unit to either side of the direction ahead.",
            &["\"120 deg\""],
        ),
    }
}
