//! Keys of fenders and of the berthing study.

use serde_json::json;

use super::POSITION_M;
use crate::library::RETURNED_ENERGY;
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{CurveSpec, KeySpec, Kind, Quantity, TableSpec};
use crate::units::measures as unit;

pub(super) const SIZE: Quantity = Quantity { measure: &unit::LENGTH, low: 1e-3, high: 1e3 };
const STIFFNESS: Quantity = Quantity { measure: &unit::STIFFNESS, low: 0.0, high: 1e15 };

pub(super) static FENDER: TableSpec = TableSpec {
    what: "a fender",
    doc: "A fender on a quay, on a tug's bow or along a ship's belting. It touches the outlines of all \
          bodies that its own body makes a pair with; the pair's material is the solid structure \
          behind it. Its law is that of a `type` of the fender data, a `stiffness`, a `curve` or, with \
          none of the three, the paper's: reaction by overlap area with the material's stiffness.",
    keys: &[
        KeySpec {
            name: "on",
            kind: Kind::BodyName,
            absent: Refused,
            doc: "The body that carries it.",
            examples: &["\"quay\""],
        },
        KeySpec {
            name: "position",
            kind: Kind::Point(POSITION_M),
            absent: Means("`belting` is given instead"),
            doc: "Middle of the line where it is mounted: forward, starboard of its body's origin.",
            examples: &["[-60, 0]"],
        },
        KeySpec {
            name: "facing",
            kind: Kind::Quantity(Quantity { measure: &unit::ANGLE, low: -100.0, high: 100.0 }),
            absent: Means("`belting` is given instead"),
            doc: "Direction in which it faces, clockwise from its body's forward direction.",
            examples: &["\"-90 deg\""],
        },
        KeySpec {
            name: "belting",
            kind: Kind::Text,
            absent: Means("`position`, `facing` and `width` say it"),
            doc: "A belting of the vessel that carries it, by name: it gives position, facing, width, height and \
                  place above the water.",
            examples: &["\"bow\""],
        },
        KeySpec {
            name: "width",
            kind: Kind::Quantity(SIZE),
            absent: Means("`belting` is given instead"),
            doc: "Width of its face (of the panel, where there is one).",
            examples: &["\"2.4 m\""],
        },
        KeySpec {
            name: "face_height",
            kind: Kind::Quantity(SIZE),
            absent: Means("the width"),
            doc: "Height of its face; with the width the area that presses on the hull.",
            examples: &["\"3 m\""],
        },
        KeySpec {
            name: "above_water",
            kind: Kind::Quantity(Quantity { measure: &unit::LENGTH, low: -100.0, high: 100.0 }),
            absent: Means("at the waterline; on a fixed body at datum"),
            doc: "Middle of its face above the still waterline, on a fixed body above datum: where its force heels a \
                  vessel. It is taken to meet her side wherever that is.",
            examples: &["\"2 m\""],
        },
        KeySpec {
            name: "projection",
            kind: Kind::Quantity(SIZE),
            absent: Means("the height of its type"),
            doc: "From the mounting to the face, uncompressed.",
            examples: &["\"1.5 m\""],
        },
        KeySpec {
            name: "material",
            kind: Kind::MaterialName,
            absent: Refused,
            doc: "Friction, damping, restitution where it has no unloading law; and stiffness where it has no other law.",
            examples: &["\"facing\""],
        },
        KeySpec {
            name: "type",
            kind: Kind::Text,
            absent: Means("no type"),
            doc: "A family of the fender data: cone, cone SPC, unit element, V leg, pneumatic, or one \
                  of `fender_files`.",
            examples: &["\"cone\""],
        },
        KeySpec {
            name: "size",
            kind: Kind::Text,
            absent: Means("`height` is given"),
            doc: "Size of the type, by its designation.",
            examples: &["\"3300x6500 50kPa\""],
        },
        KeySpec {
            name: "height",
            kind: Kind::Quantity(SIZE),
            absent: Means("`size` is given"),
            doc: "Height of a fender of this type, uncompressed, where no size of the data is meant.",
            examples: &["\"1.2 m\""],
        },
        KeySpec {
            name: "rated_reaction",
            kind: Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e9 }),
            absent: Means("scaled from the type's reference size, R ~ height squared"),
            doc: "Rated reaction of one fender of this type and height.",
            examples: &["\"900 kN\""],
        },
        KeySpec {
            name: "count",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 1000.0 }),
            absent: Means("one"),
            doc: "How many fenders of this type stand behind the one face.",
            examples: &["2"],
        },
        KeySpec {
            name: "stiffness",
            kind: Kind::Quantity(STIFFNESS),
            absent: Means("no linear law"),
            doc: "Reaction over deflection.",
            examples: &["\"2 MN/m\""],
        },
        KeySpec {
            name: "curve",
            kind: Kind::Curve(&CURVE),
            absent: Means("no curve of its own"),
            doc: "Rows of deflection and reaction, the first [0, 0], with straight lines between.",
            examples: &["[[0, 0], [\"0.3 m\", \"600 kN\"], [\"0.8 m\", \"650 kN\"]]"],
        },
        KeySpec {
            name: "returned_energy",
            kind: Kind::Quantity(RETURNED_ENERGY),
            absent: Means("that of the type, else the material's restitution"),
            doc: "Share of the energy taken that its rubber gives back: the reaction falls to a lower curve when the \
                  hull retreats, and restitution does nothing. By the coupled method.",
            examples: &["\"55 %\""],
        },
        KeySpec {
            name: "unloading",
            kind: Kind::Curve(&CURVE),
            absent: Means("`returned_energy` is given instead"),
            doc: "Rows of deflection and reaction, the first [0, 0], that a retreat comes down to, with straight \
                  lines between; nowhere above its `curve` or `stiffness`. By the coupled method.",
            examples: &["[[0, 0], [\"0.3 m\", \"250 kN\"], [\"0.8 m\", \"600 kN\"]]"],
        },
        KeySpec {
            name: "unloading_law",
            kind: Kind::Flag,
            absent: Means("true"),
            doc: "Use the unloading law of the type, if it has one; otherwise the restitution of the material.",
            examples: &["false"],
        },
        KeySpec {
            name: "rated_deflection",
            kind: Kind::Quantity(SIZE),
            absent: Means("that of the type, or the end of the curve"),
            doc: "The deflection that a linear or tabulated fender is made for.",
            examples: &["\"0.8 m\""],
        },
        KeySpec {
            name: "stop",
            kind: Kind::Table(&STOP),
            absent: Means(
                "from the end of the curve or of the projection on, 50 times the mean stiffness \
                 up to there",
            ),
            doc: "Where it stiffens to a stop.",
            examples: &[],
        },
        KeySpec {
            name: "temperature",
            kind: Kind::Quantity(Quantity { measure: &unit::CELSIUS, low: -60.0, high: 80.0 }),
            absent: Means("no correction"),
            doc: "Temperature in degrees Celsius, a plain number; for types with a table of factors.",
            examples: &["10"],
        },
        KeySpec {
            name: "tolerance",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.5, high: 0.5 }),
            absent: Is("0"),
            doc: "Departure of this fender's reaction from its rated one.",
            examples: &["\"-10 %\""],
        },
        KeySpec {
            name: "velocity_factor",
            kind: Kind::Flag,
            absent: Means("true"),
            doc: "Use the factor of the type by speed of approach, if it has one.",
            examples: &["false"],
        },
        KeySpec {
            name: "angle_factor",
            kind: Kind::Flag,
            absent: Means("true"),
            doc: "Use the factors of the type by angle, if it has them.",
            examples: &["false"],
        },
        KeySpec {
            name: "hull_pressure_limit",
            kind: Kind::Quantity(Quantity {
                measure: &unit::STIFFNESS_PER_AREA,
                low: 1.0,
                high: 1e9,
            }),
            absent: Means("`hull` is given instead, or there is no limit"),
            doc: "The pressure that the ship's side bears.",
            examples: &["\"200 kN/m^2\""],
        },
        KeySpec {
            name: "hull",
            kind: Kind::Text,
            absent: Means("`hull_pressure_limit` is given instead, or there is no limit"),
            doc: "Type of ship, for the pressure that her side bears by the fender data.",
            examples: &["\"container ship\""],
        },
    ],
    rules: Some(|| {
        let both = |one: &str, two: &str| json!({ "not": { "required": [one, two] } });
        json!({
            "allOf": [
                both("type", "stiffness"), both("type", "curve"), both("stiffness", "curve"),
                both("size", "height"), both("size", "rated_reaction"),
                both("type", "rated_deflection"), both("hull", "hull_pressure_limit"),
                both("type", "unloading"), both("returned_energy", "unloading"),
                both("returned_energy", "unloading_law"),
                {
                    "if": { "required": ["unloading"] },
                    "then": { "anyOf": [{ "required": ["stiffness"] }, { "required": ["curve"] }] }
                },
                {
                    "if": { "required": ["belting"] },
                    "then": { "properties": {
                        "position": false, "facing": false, "width": false, "face_height": false,
                        "above_water": false
                    } },
                    "else": { "required": ["position", "facing", "width"] }
                },
                {
                    "if": { "required": ["rated_deflection"] },
                    "then": { "anyOf": [{ "required": ["stiffness"] }, { "required": ["curve"] }] }
                },
            ],
            "if": { "required": ["type"] },
            "then": { "anyOf": [{ "required": ["size"] }, { "required": ["height"] }] },
            "else": {
                "required": ["projection"],
                "properties": {
                    "size": false, "height": false, "rated_reaction": false, "temperature": false,
                    "count": false, "velocity_factor": false, "angle_factor": false,
                    "unloading_law": false
                }
            }
        })
    }),
};

static CURVE: CurveSpec = CurveSpec {
    from: ("deflection", Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e3 }),
    to: ("reaction", Quantity { measure: &unit::FORCE, low: 0.0, high: 1e12 }),
    fewest: 2,
};

static STOP: TableSpec = TableSpec {
    what: "a stop",
    doc: "The end of a fender's travel: a further spring.",
    keys: &[
        KeySpec {
            name: "from",
            kind: Kind::Quantity(SIZE),
            absent: Refused,
            doc: "Deflection at which it begins.",
            examples: &["\"0.9 m\""],
        },
        KeySpec {
            name: "stiffness",
            kind: Kind::Quantity(STIFFNESS),
            absent: Refused,
            doc: "Its stiffness.",
            examples: &["\"50 MN/m\""],
        },
    ],
    rules: None,
};
