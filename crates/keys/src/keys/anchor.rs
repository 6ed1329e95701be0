//! Keys of anchors.

use fenderline_sim::ChainGrade;
use fenderline_sim::anchor::AnchorType;
use serde_json::json;

use super::quantities::{LENGTH, POSITION};
use crate::choices::{Choice, Choices};
use crate::held::{Name, Number, OneOf, Vector};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

/// The side of the bow at which an anchor hangs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BowSide {
    /// Port.
    Port,
    /// Starboard.
    Starboard,
}

pub(super) static ANCHOR: TableSpec = TableSpec {
    what: "an anchor",
    doc: "An anchor of a vessel with its chain and windlass. Orders let the anchor go, hold, veer, \
        heave and slip the chain. The holding power follows from the formula of \
        docs/design/anchors.md.",
    keys: AnchorKey::ALL,
    rules: Some(
        || json!({ "dependentRequired": { "placed": ["chain_out"], "chain_out": ["placed"] } }),
    ),
};

table_keys! {
    /// Keys of an anchor.
    pub AnchorKey {
        ON: Name = key(
            "on",
            Kind::BodyName,
            Refused,
            "The body of the vessel that carries the anchor.",
            &["\"ship\""],
        ),
        SIDE: OneOf<BowSide> = key(
            "side",
            Kind::Choice(&SIDES),
            Refused,
            "The side of the bow at which the anchor hangs.",
            &["\"port\""],
        ),
        HAWSE: Vector = key(
            "hawse",
            Kind::Point(POSITION),
            Means(
                "0.45 of the ship's length ahead of midship, and 0.1 of the beam to the side of \
                 the anchor: our assumption",
            ),
            "Place of the hawse pipe, forward and to starboard of the body's origin.",
            &["[85, -4]"],
        ),
        HAWSE_HEIGHT: Number = key(
            "hawse_height",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 100.0 }),
            Refused,
            "Height of the hawse pipe above the still water.",
            &["\"8 m\""],
        ),
        MASS: Number = key(
            "mass",
            Kind::Quantity(Quantity { measure: &unit::MASS, low: 10.0, high: 1e5 }),
            Refused,
            "Mass of the anchor.",
            &["\"8.3 t\""],
        ),
        TYPE: OneOf<AnchorType> = key(
            "type",
            Kind::Choice(&TYPES),
            Is("\"stockless\""),
            "Type of the anchor, which determines its holding power.",
            &["\"high_holding_power\""],
        ),
        CHAIN_DIAMETER: Number = key(
            "chain_diameter",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.01, high: 0.25 }),
            Refused,
            "Diameter of the bar of the chain's links. The chain's weight, break load and \
             stiffness, and the pull of the windlass, follow from this diameter.",
            &["\"76 mm\""],
        ),
        GRADE: OneOf<ChainGrade> = key(
            "grade",
            Kind::Choice(&GRADES),
            Is("\"u2\""),
            "Grade of the chain.",
            &["\"u3\""],
        ),
        CHAIN_LENGTH: Number = key(
            "chain_length",
            Kind::Quantity(LENGTH),
            Refused,
            "Length of the anchor's chain.",
            &["\"11 shackles\""],
        ),
        HOLDING_FACTOR: Number = key(
            "holding_factor",
            Kind::Quantity(FACTOR),
            Means("3 for a stockless anchor, 6 for an anchor of high holding power"),
            "Holding power divided by the anchor's weight in air, if the chain lies along the \
             bottom. Tables for stockless anchors give a holding power of 3 times the weight in \
             mud and 7 times in sand.",
            &["3.5"],
        ),
        DRAGGING_FACTOR: Number = key(
            "dragging_factor",
            Kind::Quantity(FACTOR),
            Means(
                "1.5 (an assumption without a source), or `holding_factor` if `holding_factor` is \
                 less",
            ),
            "Holding power of a dragging anchor, divided by the anchor's weight in air.",
            &["1.5"],
        ),
        CHAIN_FRICTION: Number = key(
            "chain_friction",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 5.0 }),
            Is("0.75"),
            "Friction of the chain on the bottom, divided by the weight of the chain in water.",
            &["0.6"],
        ),
        BRAKE: Number = key(
            "brake",
            Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e8 }),
            Means("45 % of the chain's break load"),
            "Tension of the chain at which the brake of the windlass slips and lets chain out.",
            &["\"2 MN\""],
        ),
        PLACED: Vector = key(
            "placed",
            Kind::Vector(POSITION),
            Means("the anchor is home in the hawse pipe"),
            "Place of the anchor on the bottom at the start.",
            &["[600, 20]"],
        ),
        CHAIN_OUT: Number = key(
            "chain_out",
            Kind::Quantity(LENGTH),
            Means("the anchor is home in the hawse pipe"),
            "Length of chain that is out at the start, for an anchor with the key `placed`.",
            &["\"5 shackles\""],
        ),
    }
}

/// Bounds of a factor that is a pull divided by a weight.
const FACTOR: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 100.0 };

static SIDES: Choices<BowSide> = Choices(&[
    Choice { word: "port", value: BowSide::Port, doc: "port" },
    Choice { word: "starboard", value: BowSide::Starboard, doc: "starboard" },
]);

static TYPES: Choices<AnchorType> = Choices(&[
    Choice {
        word: "stockless",
        value: AnchorType::Stockless,
        doc: "ordinary stockless anchor, such as a Hall or Spek anchor",
    },
    Choice {
        word: "high_holding_power",
        value: AnchorType::HighHoldingPower,
        doc: "anchor of high holding power, such as AC-14, which holds at least twice as much as a \
              stockless anchor of the same weight",
    },
]);

static GRADES: Choices<ChainGrade> = Choices(&[
    Choice { word: "u1", value: ChainGrade::U1, doc: "anchor chain of grade 1" },
    Choice { word: "u2", value: ChainGrade::U2, doc: "anchor chain of grade 2" },
    Choice { word: "u3", value: ChainGrade::U3, doc: "anchor chain of grade 3" },
]);
