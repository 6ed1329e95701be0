//! Keys of materials and of pairs of bodies.

use serde_json::json;

use crate::held::{Name, Number, TwoNames};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static MATERIAL: TableSpec = TableSpec {
    what: "a material",
    doc: "A material: the contact parameters of a pair of bodies.",
    keys: MaterialKey::ALL,
    // A schema cannot evaluate a text such as "0 %".
    rules: Some(|| {
        json!({
            "if": { "required": ["friction_static"], "properties": { "friction_static": { "not": { "const": 0 } } } },
            "then": {
                "required": ["shear_stiffness"], "properties": { "shear_stiffness": { "not": { "const": 0 } } }
            }
        })
    }),
};

table_keys! {
    /// Keys of a material.
    pub MaterialKey {
        STIFFNESS: Number = key(
            "stiffness",
            Kind::Quantity(Quantity { measure: &unit::STIFFNESS_PER_AREA, low: 0.0, high: 1e15 }),
            Refused,
            "Stiffness k: normal force per overlap area.",
            &["\"500 kN/m^2\""],
        ),
        DAMPING: Number = key(
            "damping",
            Kind::Quantity(Quantity { measure: &unit::DAMPING_PER_AREA, low: 0.0, high: 1e15 }),
            Is("0"),
            "Damping c: normal force per rate of change of the overlap area.",
            &["\"20 kN.s/m^2\""],
        ),
        SHEAR_STIFFNESS: Number = key(
            "shear_stiffness",
            Kind::Quantity(Quantity { measure: &unit::STIFFNESS, low: 0.0, high: 1e15 }),
            Is("0"),
            "Shear stiffness k_s: tangential force per shear of a contact. A material with \
             friction needs a shear stiffness.",
            &["\"3000 kN/m\""],
        ),
        FRICTION_STATIC: Number = key(
            "friction_static",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 10.0 }),
            Is("0"),
            "Coefficient of static friction; mostly 0.1 to 1. Friction needs `shear_stiffness`. A \
             coefficient of friction of more than 1.5 gives a warning.",
            &["0.5"],
        ),
        FRICTION_DYNAMIC: Number = key(
            "friction_dynamic",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 10.0 }),
            Means("equal to `friction_static`"),
            "Coefficient of dynamic friction, at most `friction_static`.",
            &["0.4"],
        ),
        RESTITUTION: Number = key(
            "restitution",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1.0 }),
            Is("0"),
            "Coefficient of restitution between outlines: speed of separation divided by speed of \
             approach. Fenders have an unloading law instead (`returned_energy`, `unloading`), and \
             do not use restitution with the coupled method.",
            &["0.1"],
        ),
    }
}

pub(super) static PAIR: TableSpec = TableSpec {
    what: "a pair",
    doc: "Two bodies that may touch, and the material of their contact.",
    keys: PairKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a pair.
    pub PairKey {
        BODIES: TwoNames = key(
            "bodies",
            Kind::TwoBodyNames,
            Refused,
            "Two bodies, at least one of them floating; [\"*\", \"*\"] stands for every two bodies \
             that no other pair names.",
            &["[\"tug\", \"ship\"]", "[\"*\", \"*\"]"],
        ),
        MATERIAL: Name = key(
            "material",
            Kind::MaterialName,
            Refused,
            "The material of the contact between the two bodies.",
            &["\"paper\""],
        ),
    }
}
