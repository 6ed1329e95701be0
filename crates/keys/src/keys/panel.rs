//! Keys of a fender panel that stands on several cones.

use fenderline_sim::{ChainGrade, ChainKind, ChainLink};
use serde_json::json;

use super::quantities::{FENDER_SIZE, FORCE, PLACE_ON_FACE};
use crate::choices::{Choice, Choices};
use crate::held::{Number, OneOf};
use crate::spec::Absent::{Means, Refused, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static CONE: TableSpec = TableSpec {
    what: "a cone behind a panel",
    doc: "One of several equal fenders behind one panel. The panel moves inwards and turns about \
        the vertical axis, so each cone has its own deflection. The keys `type`, `stiffness`, \
        `curve`, `stop` and `rated_deflection` of the fender hold for each cone.",
    keys: ConeKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a cone behind a panel.
    pub ConeKey {
        AT: Number = key(
            "at",
            Kind::Quantity(PLACE_ON_FACE),
            Refused,
            "Place of the cone along the panel, measured from the middle of the panel, positive to \
             the right as you look at the face.",
            &["\"-1.2 m\""],
        ),
        HEIGHT: Number = key(
            "height",
            Kind::Quantity(PLACE_ON_FACE),
            Means("at the middle of the panel"),
            "Height of the cone above the middle of the panel. The mean height of all cones is the \
             height of the reaction above the middle of the panel.",
            &["\"0.6 m\""],
        ),
    }
}

pub(super) static CHAIN: TableSpec = TableSpec {
    what: "a chain of a fender",
    doc: "A chain between the structure and the panel of a fender. The chain is slack up to some \
        motion of the panel, then acts as a linear spring, and parts at its break load. Slack, \
        stiffness and break load of the chain are measured along the direction in which the chain \
        holds the panel. For a chain at an angle to the direction in which it holds the panel, \
        give the stiffness times the squared cosine of the angle, and the break load times the \
        cosine.",
    keys: ChainKey::ALL,
    rules: Some(|| {
        let weight = json!({ "kind": { "const": "weight" } });
        let tension = json!({ "kind": { "const": "tension" } });
        json!({
            "allOf": [
                {
                    "if": { "properties": tension },
                    "then": { "required": ["at"] },
                    "else": { "properties": { "at": false } }
                },
                {
                    "if": { "properties": weight },
                    "then": { "properties": { "slack": false, "length": false, "span": false, "stiffness": false } },
                    "else": {
                        "if": { "required": ["diameter"] },
                        "then": { "required": ["length"] },
                        "else": { "required": ["stiffness"] },
                        "oneOf": [
                            { "required": ["slack"], "properties": { "length": false, "span": false } },
                            { "required": ["length", "span"], "properties": { "slack": false } }
                        ]
                    }
                },
                {
                    "if": { "required": ["diameter"] },
                    "then": {
                        "required": ["grade"],
                        "properties": { "break_load": false, "stiffness": false }
                    },
                    "else": {
                        "required": ["break_load"],
                        "properties": { "grade": false, "link": false }
                    }
                }
            ]
        })
    }),
};

table_keys! {
    /// Keys of a chain of a fender.
    pub ChainKey {
        KIND: OneOf<ChainKind> = key(
            "kind",
            Kind::Choice(&KINDS),
            Refused,
            "What the chain limits or carries: a tension, shear or weight chain.",
            &["\"tension\""],
        ),
        AT: Number = key(
            "at",
            Kind::Quantity(PLACE_ON_FACE),
            Unless("the chain's `kind` is shear or weight"),
            "Place of a tension chain along the panel, measured from the middle of the panel, \
             positive to the right as you look at the face.",
            &["\"-1.2 m\""],
        ),
        SLACK: Number = key(
            "slack",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 100.0 }),
            Unless("`length` and `span` of the chain are given, or its `kind` is weight"),
            "How far the panel moves before the chain holds.",
            &["\"20 mm\""],
        ),
        LENGTH: Number = key(
            "length",
            Kind::Quantity(FENDER_SIZE),
            Unless("`slack` of the chain is given, or its `kind` is weight"),
            "Length of the chain with its shackles; the slack is this length less the `span`.",
            &["\"1.25 m\""],
        ),
        SPAN: Number = key(
            "span",
            Kind::Quantity(FENDER_SIZE),
            Unless("`slack` of the chain is given, or its `kind` is weight"),
            "Distance between the fastenings of the chain on the undeflected fender.",
            &["\"1.2 m\""],
        ),
        STIFFNESS: Number = key(
            "stiffness",
            Kind::Quantity(Quantity { measure: &unit::STIFFNESS, low: 1.0, high: 1e12 }),
            Unless("`diameter` of the chain is given, or its `kind` is weight"),
            "Stiffness of the chain: tension divided by stretch.",
            &["\"40 MN/m\""],
        ),
        BREAK_LOAD: Number = key(
            "break_load",
            Kind::Quantity(FORCE),
            Unless("`diameter` is given"),
            "Tension at which the chain parts.",
            &["\"500 kN\""],
        ),
        DIAMETER: Number = key(
            "diameter",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 6e-3, high: 0.162 }),
            Unless("`break_load` is given"),
            "Diameter of the bar of the chain's links. The diameter gives the break load together \
             with `grade`, and the stiffness together with `link` and `length`.",
            &["\"28 mm\""],
        ),
        GRADE: OneOf<ChainGrade> = key(
            "grade",
            Kind::Choice(&GRADES),
            Unless("`diameter` is not given"),
            "Grade of the chain.",
            &["\"u2\""],
        ),
        LINK: OneOf<ChainLink> = key(
            "link",
            Kind::Choice(&LINKS),
            Means("open"),
            "Form of the chain's links, on which the stiffness depends.",
            &["\"stud\""],
        ),
    }
}

static GRADES: Choices<ChainGrade> = Choices(&[
    Choice {
        word: "u1",
        value: ChainGrade::U1,
        doc: "anchor chain of grade 1, with or without studs",
    },
    Choice { word: "u2", value: ChainGrade::U2, doc: "anchor chain of grade 2" },
    Choice { word: "u3", value: ChainGrade::U3, doc: "anchor chain of grade 3" },
    Choice {
        word: "g30",
        value: ChainGrade::G30,
        doc: "short-link chain of grade 30: 300 N/mm² at the break load",
    },
    Choice { word: "g40", value: ChainGrade::G40, doc: "short-link chain of grade 40" },
    Choice { word: "g80", value: ChainGrade::G80, doc: "short-link chain of grade 80" },
]);

static LINKS: Choices<ChainLink> = Choices(&[
    Choice { word: "open", value: ChainLink::Open, doc: "links without studs" },
    Choice {
        word: "stud",
        value: ChainLink::Stud,
        doc: "links with studs; short-link chains have no such links",
    },
]);

static KINDS: Choices<ChainKind> = Choices(&[
    Choice {
        word: "tension",
        value: ChainKind::Tension,
        doc: "a tension chain limits the outward motion of the panel at the place of the chain \
              when the panel turns; the fender needs `cones`",
    },
    Choice {
        word: "shear",
        value: ChainKind::Shear,
        doc: "a shear chain limits the motion of the panel along the berth in both directions, in \
              addition to the fender's shear stiffness",
    },
    Choice {
        word: "weight",
        value: ChainKind::Weight,
        doc: "a weight chain carries the panel's weight (`panel_mass`), and the friction of a hull \
              that sinks along the panel",
    },
]);
