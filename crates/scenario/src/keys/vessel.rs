//! Keys of vessels.

use serde_json::json;

use super::world::{FORCE, LENGTH, PLACE, WINDAGE, key};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Choices, Kind, Quantity, TableSpec};
use crate::units::measures as unit;

pub(super) static VESSEL: TableSpec = TableSpec {
    what: "a vessel",
    doc: "What makes a ship of a body: hull, propeller, rudder, thrusters, wind areas, stability. Bodies name it \
          by their key `vessel`; several may be of one kind. Without a published model everything is \
          estimated from the particulars.",
    keys: &[
        key(
            "model",
            Kind::Choice(&MODELS),
            Means("estimated from the particulars"),
            "A published manoeuvring model; it brings its own particulars, propeller and rudder.",
            &["\"kvlcc2\""],
        ),
        key(
            "length_bp",
            Kind::Quantity(LENGTH),
            Means("that of the model"),
            "Length between perpendiculars.",
            &["\"285 m\""],
        ),
        key("beam", Kind::Quantity(LENGTH), Means("that of the model"), "Beam.", &["\"46 m\""]),
        key(
            "draught",
            Kind::Quantity(LENGTH),
            Means("that of the model"),
            "Draught.",
            &["\"9 m\""],
        ),
        key(
            "block_coefficient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.1, high: 1.0 }),
            Means("that of the model"),
            "Volume over length, beam and draught.",
            &["0.71"],
        ),
        key(
            "centre_of_gravity",
            Kind::Quantity(PLACE),
            Means("amidships, or that of the model"),
            "Centre of gravity forward of midship; the body's outline is about the centre of gravity.",
            &["\"-3.4 m\""],
        ),
        key(
            "gyradius",
            Kind::Quantity(LENGTH),
            Means("a quarter of the length"),
            "Radius of gyration in yaw, without added mass.",
            &["\"72 m\""],
        ),
        key(
            "propeller",
            Kind::Table(&PROPELLER),
            Means("that of the model, or none"),
            "Propeller and shaft.",
            &[],
        ),
        key("rudder", Kind::Table(&RUDDER), Means("that of the model, or none"), "Rudder.", &[]),
        key("thruster", Kind::Named(&THRUSTER), Is("{}"), "Tunnel thrusters, by name.", &[]),
        key(
            "windage",
            Kind::Table(&WINDAGE),
            Means("the wind does not move her"),
            "Wind areas.",
            &[],
        ),
        key(
            "stability",
            Kind::Table(&STABILITY),
            Means("she neither heaves nor rolls nor pitches"),
            "What heave, roll and pitch need.",
            &[],
        ),
    ],
    rules: Some(|| {
        json!({
            "if": { "required": ["model"] },
            "then": {
                "properties": {
                    "length_bp": false, "beam": false, "draught": false, "block_coefficient": false,
                    "centre_of_gravity": false, "gyradius": false,
                    "propeller": { "properties": { "diameter": false } },
                    "rudder": { "properties": { "area": false, "span": false } }
                }
            },
            "else": {
                "required": ["length_bp", "beam", "draught", "block_coefficient"],
                "dependentRequired": { "propeller": ["rudder"], "rudder": ["propeller"] },
                "properties": {
                    "propeller": { "required": ["diameter"] },
                    "rudder": { "required": ["area", "span"] }
                }
            }
        })
    }),
};

/// In the order that [`crate::assemble`] relies on.
static MODELS: Choices = Choices {
    words: &[
        ("kvlcc2", "a tanker of 320 m, Yasukawa & Yoshimura 2015"),
        ("kcs", "a container ship of 230 m"),
    ],
};

static PROPELLER: TableSpec = TableSpec {
    what: "a propeller",
    doc: "Propeller and shaft.",
    keys: &[
        key(
            "diameter",
            Kind::Quantity(LENGTH),
            Means("that of the model"),
            "Diameter.",
            &["\"8.5 m\""],
        ),
        key(
            "full",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: 1e-3, high: 1e3 }),
            Refused,
            "Full revolutions.",
            &["\"95 rpm\""],
        ),
        key(
            "reversal",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.1, high: 3600.0 }),
            Is("40"),
            "Time from full ahead to full astern.",
            &["\"60 s\""],
        ),
        key(
            "running",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -1.0, high: 1.0 }),
            Is("0"),
            "Revolutions over full ones at the start.",
            &["0.3"],
        ),
    ],
    rules: None,
};

static RUDDER: TableSpec = TableSpec {
    what: "a rudder",
    doc: "Rudder and steering gear.",
    keys: &[
        key(
            "area",
            Kind::Quantity(Quantity { measure: &unit::AREA, low: 1e-4, high: 1e4 }),
            Means("that of the model"),
            "Movable area.",
            &["\"60 m^2\""],
        ),
        key("span", Kind::Quantity(LENGTH), Means("that of the model"), "Span.", &["\"9 m\""]),
        key(
            "rate",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: 1e-4, high: 10.0 }),
            Is("\"2.32 deg/s\""),
            "Rate of the steering gear.",
            &["\"2.5 deg/s\""],
        ),
        key(
            "stop",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: 0.01, high: 1.57 }),
            Is("\"35 deg\""),
            "Its stop to either side.",
            &["\"35 deg\""],
        ),
    ],
    rules: None,
};

static THRUSTER: TableSpec = TableSpec {
    what: "a thruster",
    doc: "A tunnel thruster.",
    keys: &[
        key(
            "along",
            Kind::Quantity(PLACE),
            Refused,
            "Its place forward of midship.",
            &["\"120 m\""],
        ),
        key(
            "force",
            Kind::Quantity(FORCE),
            Refused,
            "Thrust at rest and full power.",
            &["\"250 kN\""],
        ),
        key(
            "lag",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 600.0 }),
            Is("8"),
            "Time constant.",
            &["\"10 s\""],
        ),
    ],
    rules: None,
};

static STABILITY: TableSpec = TableSpec {
    what: "a stability",
    doc: "What heave, roll and pitch need.",
    keys: &[
        key(
            "gm",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1e-3, high: 100.0 }),
            Refused,
            "Metacentric height GM.",
            &["\"2 m\""],
        ),
        key(
            "gravity_above_keel",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 200.0 }),
            Refused,
            "Centre of gravity above the keel, KG.",
            &["\"20.8 m\""],
        ),
        key(
            "waterplane_area",
            Kind::Quantity(Quantity { measure: &unit::AREA, low: 1e-3, high: 1e6 }),
            Refused,
            "Waterplane area.",
            &["\"3000 m^2\""],
        ),
    ],
    rules: None,
};
