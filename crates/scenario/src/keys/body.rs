//! Keys of bodies.

use serde_json::json;

use crate::spec::Absent::{Is, Means};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec};
use crate::units::measures as unit;

pub(super) static BODY: TableSpec = TableSpec {
    what: "a body",
    doc: "A ship, tug, quay or fender: fixed, or floating with a mass.",
    keys: &[
        KeySpec {
            name: "fixed",
            kind: Kind::Flag,
            absent: Is("false"),
            doc: "True for a body that never moves; it has no mass and no velocity.",
            examples: &["true"],
        },
        KeySpec {
            name: "outline",
            kind: Kind::Outline(Quantity { measure: &unit::LENGTH, low: -1e8, high: 1e8 }),
            absent: Means("the outline of the vessel"),
            doc: "Vertices, forward and to starboard of the centre of gravity, in either direction \
                  round; need not be convex.",
            examples: &["[[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]"],
        },
        KeySpec {
            name: "vessel",
            kind: Kind::Text,
            absent: Means("a plain body"),
            doc: "Kind of vessel: from this scenario, from the library (`fenderline vessels`) or from \
                  `vessel_files`: it gives mass, added mass, outline and her coefficients.",
            examples: &["\"container-ship\""],
        },
        KeySpec {
            name: "running",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -1.0, high: 1.0 }),
            absent: Means("engine stopped"),
            doc: "Shaft revolutions at the start, as a fraction of full revolutions.",
            examples: &["0.3"],
        },
        KeySpec {
            name: "mass",
            kind: Kind::Quantity(Quantity { measure: &unit::MASS, low: 1e-3, high: 1e15 }),
            absent: Means("a fixed body"),
            doc: "Displacement, without added mass.",
            examples: &["\"87800 t\""],
        },
        KeySpec {
            name: "gyradius",
            kind: Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1e-3, high: 1e5 }),
            absent: Means("`yaw_inertia` is given"),
            doc: "Radius of gyration about the vertical through the centre of gravity.",
            examples: &["\"74.5 m\""],
        },
        KeySpec {
            name: "yaw_inertia",
            kind: Kind::Quantity(Quantity {
                measure: &unit::MOMENT_OF_INERTIA,
                low: 1e-9,
                high: 1e25,
            }),
            absent: Means("`gyradius` is given"),
            doc: "Moment of inertia about the vertical through the centre of gravity.",
            examples: &["\"4.87e8 t.m^2\""],
        },
        KeySpec {
            name: "added_mass",
            kind: Kind::Table(&ADDED_MASS),
            absent: Means("no added mass"),
            doc: "Added mass as fractions of mass and of yaw inertia.",
            examples: &["{ surge = 0.031, sway = 0.506, yaw = 0.72 }"],
        },
        KeySpec {
            name: "position",
            kind: Kind::Vector(POSITION_M),
            absent: Is("[0, 0]"),
            doc: "Initial position of the centre of gravity: north, east.",
            examples: &["[0, 30]", "[\"1 km\", 0]"],
        },
        KeySpec {
            name: "heading",
            kind: Kind::Quantity(Quantity { measure: &unit::ANGLE, low: -1e6, high: 1e6 }),
            absent: Is("0"),
            doc: "Initial heading, clockwise from north.",
            examples: &["\"270 deg\""],
        },
        KeySpec {
            name: "velocity",
            kind: Kind::Table(&VELOCITY),
            absent: Means("at rest"),
            doc: "Initial velocity in the body's axes.",
            examples: &["{ surge = \"4 kn\" }"],
        },
    ],
    rules: Some(|| {
        json!({
            "if": { "properties": { "fixed": { "const": true } }, "required": ["fixed"] },
            "then": {
                "properties": {
                    "mass": false, "gyradius": false, "yaw_inertia": false,
                    "added_mass": false, "velocity": false, "vessel": false, "running": false
                },
                "required": ["outline"]
            },
            "else": {
                "if": { "required": ["vessel"] },
                "then": {
                    "properties": {
                        "mass": false, "gyradius": false, "yaw_inertia": false, "added_mass": false
                    }
                },
                "else": {
                    "properties": { "running": false },
                    "required": ["mass", "outline"],
                    "oneOf": [{ "required": ["gyradius"] }, { "required": ["yaw_inertia"] }]
                }
            }
        })
    }),
};

pub(super) const POSITION_M: Quantity = Quantity { measure: &unit::LENGTH, low: -1e8, high: 1e8 };

pub(super) static ADDED_MASS: TableSpec = TableSpec {
    what: "an added mass",
    doc: "Added mass as fractions of mass and of yaw inertia.",
    keys: &[
        KeySpec {
            name: "surge",
            kind: Kind::Quantity(ADDED_FRACTION),
            absent: Is("0"),
            doc: "Added mass in surge over mass.",
            examples: &["0.031"],
        },
        KeySpec {
            name: "sway",
            kind: Kind::Quantity(ADDED_FRACTION),
            absent: Is("0"),
            doc: "Added mass in sway over mass.",
            examples: &["0.506"],
        },
        KeySpec {
            name: "yaw",
            kind: Kind::Quantity(ADDED_FRACTION),
            absent: Is("0"),
            doc: "Added moment of inertia in yaw over yaw inertia.",
            examples: &["0.72"],
        },
    ],
    rules: None,
};

const ADDED_FRACTION: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1000.0 };

pub(super) static VELOCITY: TableSpec = TableSpec {
    what: "a velocity",
    doc: "Velocity in the body's axes.",
    keys: &[
        KeySpec {
            name: "surge",
            kind: Kind::Quantity(SPEED),
            absent: Is("0"),
            doc: "Forward.",
            examples: &["\"4 kn\""],
        },
        KeySpec {
            name: "sway",
            kind: Kind::Quantity(SPEED),
            absent: Is("0"),
            doc: "To starboard.",
            examples: &["\"-0.15 m/s\""],
        },
        KeySpec {
            name: "yaw",
            kind: Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: -1e3, high: 1e3 }),
            absent: Is("0"),
            doc: "Rate of turn, to starboard.",
            examples: &["\"3 deg/s\""],
        },
    ],
    rules: None,
};

pub(super) const SPEED: Quantity = Quantity { measure: &unit::SPEED, low: -1e4, high: 1e4 };
