//! Keys of external loads.

use serde_json::json;

use super::quantities::TIME;

use crate::held::{Name, Number, Vector};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

/// The key with which a load or a provider of forces names its body.
pub(super) const FLOATING_BODY: KeySpec = key(
    "body",
    Kind::BodyName,
    Refused,
    "The floating body on which the load acts.",
    &["\"ship\""],
);

pub(super) static LOAD: TableSpec = TableSpec {
    what: "a load",
    doc: "An external load at a body's centre of gravity; give a force or a moment or both.",
    keys: LoadKey::ALL,
    rules: Some(|| json!({ "anyOf": [{ "required": ["force"] }, { "required": ["moment"] }] })),
};

table_keys! {
    /// Keys of a load.
    pub LoadKey {
        BODY: Name = FLOATING_BODY,
        FORCE: Vector = key(
            "force",
            Kind::Vector(Quantity { measure: &unit::FORCE, low: -1e15, high: 1e15 }),
            Means("no force"),
            "Force: north, east.",
            &["[\"0 kN\", \"-500 kN\"]"],
        ),
        MOMENT: Number = key(
            "moment",
            Kind::Quantity(Quantity { measure: &unit::MOMENT, low: -1e20, high: 1e20 }),
            Means("no moment"),
            "Moment about the vertical, positive if it turns the bow to starboard.",
            &["\"1.2e3 kN.m\""],
        ),
        FROM: Number = key(
            "from",
            Kind::Quantity(TIME),
            Is("0"),
            "When the load starts.",
            &["\"10 s\""],
        ),
        UNTIL: Number = key(
            "until",
            Kind::Quantity(TIME),
            Means("the end of the run"),
            "When the load ends, later than `from`.",
            &["\"5 min\""],
        ),
    }
}
