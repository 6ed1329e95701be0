//! Keys of the approach of a ship to a berth, with which a run may start.

use fenderline_sim::Side;
use serde_json::json;

use super::quantities::PLACE;
use crate::choices::{Choice, Choices};
use crate::held::{Name, NameOr, Number, OneOf, TableOf, Text};
use crate::spec::Absent::{Is, Means, Refused, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static APPROACH: TableSpec = TableSpec {
    what: "an approach",
    doc: "The start of a berthing in the terms of berth design: a point of the ship's side meets a \
        fender of the berth at a given speed and angle. The ship's position, heading and velocity \
        at the start follow from the keys of the approach; after the start the forces move the \
        ship.",
    keys: ApproachKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of an approach.
    pub ApproachKey {
        TO: Name = key(
            "to",
            Kind::BodyName,
            Refused,
            "The body with the fenders that the ship meets: a quay, a dolphin, a row of dolphins.",
            &["\"quay\""],
        ),
        SPEED_NORMAL: Number = key(
            "speed_normal",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 1e-3, high: 10.0 }),
            Refused,
            "Speed of the contact point towards the berth, at right angles to the berth.",
            &["\"0.12 m/s\""],
        ),
        ALONG: Number = key(
            "along",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: -10.0, high: 10.0 }),
            Is("0"),
            "Speed of the ship along the berth, positive forward.",
            &["\"0.2 kn\""],
        ),
        ANGLE: Number = key(
            "angle",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: -0.79, high: 0.79 }),
            Is("0"),
            "Angle between the ship's centreline and the berth, up to 45 degrees; positive with \
             the bow towards the berth.",
            &["\"5 deg\""],
        ),
        SIDE: OneOf<Side> = key(
            "side",
            Kind::Choice(&SIDES),
            Is("\"starboard\""),
            "The side of the ship that meets the berth.",
            &["\"port\""],
        ),
        CONTACT: NameOr = key(
            "contact",
            Kind::NameOr(PLACE),
            Refused,
            "The point of the ship's side that meets the fender: \"quarter point\", \"third \
             point\" (a quarter, a third of the ship's length from the end that is nearer to the \
             berth), \"midship\", or a distance forward of midship. Instead, the name of a fender \
             may stand here: the ship then meets this fender with the part of her side that comes \
             first.",
            &["\"quarter point\"", "\"-20 m\"", "\"midship\""],
        ),
        FENDER: Text = key(
            "fender",
            Kind::Text,
            Means("the fender nearest to the middle of the berth's fenders"),
            "The fender that the contact point meets.",
            &[],
        ),
        DISTANCE: Number = key(
            "distance",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e4 }),
            Is("1"),
            "Distance from the contact point to the fender's face at the start, at right angles to \
             the berth.",
            &["\"2 m\""],
        ),
        ABNORMAL: TableOf<AbnormalKey> = key(
            "abnormal",
            Kind::Table(&ABNORMAL),
            Means("a normal berthing"),
            "Makes the run an abnormal berthing: `speed_normal` is multiplied by a factor.",
            &["{ energy_factor = 1.5 }"],
        ),
    }
}

static ABNORMAL: TableSpec = TableSpec {
    what: "an abnormal berthing",
    doc: "How much an abnormal berthing exceeds the normal berthing. The berthing energy is \
          proportional to the square of the speed.",
    keys: AbnormalKey::ALL,
    rules: Some(
        || json!({ "oneOf": [{ "required": ["energy_factor"] }, { "required": ["speed_factor"] }] }),
    ),
};

table_keys! {
    /// Keys of an abnormal berthing.
    pub AbnormalKey {
        ENERGY_FACTOR: Number = key(
            "energy_factor",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 4.0 }),
            Unless("`speed_factor` is given"),
            "Energy of the abnormal berthing divided by the energy of the normal berthing: \
             `speed_normal` is multiplied by the square root of this factor.",
            &["1.5"],
        ),
        SPEED_FACTOR: Number = key(
            "speed_factor",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 2.0 }),
            Unless("`energy_factor` is given"),
            "Speed of the abnormal berthing divided by the speed of the normal berthing.",
            &["1.25"],
        ),
    }
}

static SIDES: Choices<Side> = Choices(&[
    Choice { word: "port", value: Side::Port, doc: "port side to the berth" },
    Choice { word: "starboard", value: Side::Starboard, doc: "starboard side to the berth" },
]);
