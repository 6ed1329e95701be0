//! Keys of flexible dolphins.

use serde_json::json;

use super::quantities::FORCE;
use crate::held::Number;
use crate::spec::Absent::{Is, Means, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static DOLPHIN: TableSpec = TableSpec {
    what: "a flexible dolphin",
    doc: "Piles that hold a body at its place and bend under a ship. The piles act as a \
          spring with a mass, equally stiff in all horizontal directions, in series with the \
          fenders of the body. A dolphin does not turn. Stiffness and mass are given, or follow from upright \
          steel tubes that are fixed in the ground at the point of fixity, with the stiffness K = \
          3EI/L³. A dolphin needs the coupled method and the semi-implicit integrator.",
    keys: DolphinKey::ALL,
    rules: Some(|| {
        json!({
            "if": { "required": ["stiffness"] },
            "then": {
                "required": ["mass"],
                "properties": {
                    "diameter": false, "wall": false, "length": false, "piles": false, "modulus": false,
                    "yield_stress": false, "head_mass": false
                }
            },
            "else": {
                "required": ["diameter", "wall", "length"],
                "properties": { "mass": false, "yield_load": false }
            }
        })
    }),
};

table_keys! {
    /// Keys of a flexible dolphin.
    pub DolphinKey {
        STIFFNESS: Number = key(
            "stiffness",
            Kind::Quantity(Quantity { measure: &unit::STIFFNESS, low: 1e3, high: 1e12 }),
            Unless("`diameter`, `wall` and `length` of the piles are given"),
            "Stiffness of the dolphin: horizontal load divided by deflection, both at the height \
             of the fender.",
            &["\"5 MN/m\""],
        ),
        MASS: Number = key(
            "mass",
            Kind::Quantity(MASS),
            Unless("`diameter`, `wall` and `length` of the piles are given"),
            "Mass that moves with the head of the dolphin: the head itself, about a quarter of the \
             piles down to the point of fixity, and the water that head and piles move.",
            &["\"60 t\""],
        ),
        YIELD_LOAD: Number = key(
            "yield_load",
            Kind::Quantity(FORCE),
            Means("it does not yield"),
            "Horizontal load at the height of the fender at which the piles yield. Deflection \
             under a load beyond the yield load is permanent.",
            &["\"1500 kN\""],
        ),
        DAMPING: Number = key(
            "damping",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 0.99 }),
            Is("0.02"),
            "Damping of the dolphin divided by its critical damping, for the dolphin without ship \
             and fender. The default damping is an assumption.",
            &["0.02"],
        ),
        DIAMETER: Number = key(
            "diameter",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.05, high: 20.0 }),
            Unless("`stiffness` is given"),
            "Outer diameter of each pile.",
            &["\"2.5 m\""],
        ),
        WALL: Number = key(
            "wall",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1e-3, high: 10.0 }),
            Unless("`stiffness` is given"),
            "Wall thickness of each pile; if it varies, the equivalent thickness in bending.",
            &["\"40 mm\""],
        ),
        LENGTH: Number = key(
            "length",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.5, high: 500.0 }),
            Unless("`stiffness` is given"),
            "Length from the point of fixity, which lies below the seabed, to the height of the \
             fender.",
            &["\"25 m\""],
        ),
        PILES: Number = key(
            "piles",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 100.0 }),
            Means("one"),
            "Number of piles. The piles bend equally, because the dolphin's head does not turn.",
            &["1"],
        ),
        MODULUS: Number = key(
            "modulus",
            Kind::Quantity(Quantity { measure: &unit::STIFFNESS_PER_AREA, low: 1e9, high: 1e12 }),
            Means("210 GPa"),
            "Young's modulus.",
            &["\"210 GPa\""],
        ),
        YIELD_STRESS: Number = key(
            "yield_stress",
            Kind::Quantity(Quantity { measure: &unit::STIFFNESS_PER_AREA, low: 1e7, high: 1e10 }),
            Means("it does not yield"),
            "Yield stress: the piles yield when the bending stress at the point of fixity reaches \
             this stress.",
            &["\"420 MPa\""],
        ),
        HEAD_MASS: Number = key(
            "head_mass",
            Kind::Quantity(MASS),
            Means("nothing but the piles"),
            "Mass of the dolphin's head with fender and panel. The program adds to the mass of the \
             head 0.243 of the mass of the piles. The program does not count the water in and \
             around the piles: add the mass of the water that moves to the mass of the head.",
            &["\"40 t\""],
        ),
    }
}

const MASS: Quantity = Quantity { measure: &unit::MASS, low: 1.0, high: 1e9 };
