//! Keys of materials and of pairs of bodies.

use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec};
use crate::units::measures as unit;

pub(super) static MATERIAL: TableSpec = TableSpec {
    what: "a material",
    doc: "Contact parameters of a pair of bodies.",
    keys: &[
        KeySpec {
            name: "stiffness",
            kind: Kind::Quantity(Quantity {
                measure: &unit::STIFFNESS_PER_AREA,
                low: 0.0,
                high: 1e15,
            }),
            absent: Refused,
            doc: "k, normal force per overlap area.",
            examples: &["\"500 kN/m^2\""],
        },
        KeySpec {
            name: "damping",
            kind: Kind::Quantity(Quantity {
                measure: &unit::DAMPING_PER_AREA,
                low: 0.0,
                high: 1e15,
            }),
            absent: Is("0"),
            doc: "c, normal force per rate of change of the overlap area.",
            examples: &["\"20 kN.s/m^2\""],
        },
        KeySpec {
            name: "shear_stiffness",
            kind: Kind::Quantity(Quantity { measure: &unit::STIFFNESS, low: 0.0, high: 1e15 }),
            absent: Is("0"),
            doc: "k_s, tangential force per shear of a contact; without it there is no friction.",
            examples: &["\"3000 kN/m\""],
        },
        KeySpec {
            name: "friction_static",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 10.0 }),
            absent: Is("0"),
            doc: "Coefficient of static friction: 0.1 to 1 in most harbours; more than 1.5 is noticed.",
            examples: &["0.5"],
        },
        KeySpec {
            name: "friction_dynamic",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 10.0 }),
            absent: Means("equal to `friction_static`"),
            doc: "Coefficient of dynamic friction, at most `friction_static`.",
            examples: &["0.4"],
        },
        KeySpec {
            name: "restitution",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1.0 }),
            absent: Is("0"),
            doc: "Speed of leaving over speed of approach, where the limiter acts.",
            examples: &["0.1"],
        },
    ],
    rules: None,
};

pub(super) static PAIR: TableSpec = TableSpec {
    what: "a pair",
    doc: "Two bodies that may touch, and how.",
    keys: &[
        KeySpec {
            name: "bodies",
            kind: Kind::TwoBodyNames,
            absent: Refused,
            doc: "Two bodies, at least one of them floating; [\"*\", \"*\"] stands for every two \
                  that no other pair names.",
            examples: &["[\"tug\", \"ship\"]", "[\"*\", \"*\"]"],
        },
        KeySpec {
            name: "material",
            kind: Kind::MaterialName,
            absent: Refused,
            doc: "The material of their contact.",
            examples: &["\"paper\""],
        },
    ],
    rules: None,
};
