//! Keys of external loads.

use serde_json::json;

use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec};
use crate::units::measures as unit;

pub(super) static LOAD: TableSpec = TableSpec {
    what: "a load",
    doc: "An external load at a body's centre of gravity; it needs a force or a moment.",
    keys: &[
        KeySpec {
            name: "body",
            kind: Kind::BodyName,
            absent: Refused,
            doc: "The floating body that it acts on.",
            examples: &["\"ship\""],
        },
        KeySpec {
            name: "force",
            kind: Kind::Vector(Quantity { measure: &unit::FORCE, low: -1e15, high: 1e15 }),
            absent: Means("no force"),
            doc: "Force: north, east.",
            examples: &["[\"0 kN\", \"-500 kN\"]"],
        },
        KeySpec {
            name: "moment",
            kind: Kind::Quantity(Quantity { measure: &unit::MOMENT, low: -1e20, high: 1e20 }),
            absent: Means("no moment"),
            doc: "Moment about the vertical, positive to starboard.",
            examples: &["\"1.2e3 kN.m\""],
        },
        KeySpec {
            name: "from",
            kind: Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 1e9 }),
            absent: Is("0"),
            doc: "When the load starts.",
            examples: &["\"10 s\""],
        },
        KeySpec {
            name: "until",
            kind: Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 1e9 }),
            absent: Means("the end of the run"),
            doc: "When the load ends, later than `from`.",
            examples: &["\"5 min\""],
        },
    ],
    rules: Some(|| json!({ "anyOf": [{ "required": ["force"] }, { "required": ["moment"] }] })),
};
