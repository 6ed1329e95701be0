//! Keys of tugs and lines.

use fenderline_sim::mooring::RopeCurve;
use serde_json::json;

use super::quantities::{FORCE, LENGTH, PLACE, POSITION, TIME};
use crate::choices::{Choice, Choices};
use crate::spec::Absent::{Is, Means, Refused, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::units::measures as unit;

pub(super) static TUG: TableSpec = TableSpec {
    what: "a tug",
    doc: "A tug as a force at a point of a vessel. Her largest force falls with speed (derived, \
          unvalidated). For a tug that pushes through her own bow fender, use a vessel with azimuth units and the \
          orders `push_ship`, `pull_ship` and `follow_ship`.",
    keys: &[
        key(
            "vessel",
            Kind::BodyName,
            Refused,
            "The body of the vessel that the tug serves.",
            &["\"ship\""],
        ),
        key("bollard_pull", Kind::Quantity(FORCE), Refused, "Bollard pull.", &["\"60 tf\""]),
        key(
            "push_at",
            Kind::Point(PLACE),
            Refused,
            "Where she pushes, from midship: forward, starboard.",
            &["[90, -23]"],
        ),
        key(
            "pull_at",
            Kind::Point(PLACE),
            Means("where she pushes"),
            "The fairlead of her line, from midship.",
            &["[140, 0]"],
        ),
        key("length", Kind::Quantity(LENGTH), Is("32"), "Her length.", &["\"32 m\""]),
        key("beam", Kind::Quantity(LENGTH), Is("13"), "Her beam.", &["\"13 m\""]),
        key("draught", Kind::Quantity(LENGTH), Is("4.5"), "Her draught.", &["\"4.5 m\""]),
        key(
            "delay",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 3600.0 }),
            Is("5"),
            "Time from an order to its start.",
            &["\"5 s\""],
        ),
        key(
            "lag",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 3600.0 }),
            Is("10"),
            "Time constant of her force and of its direction.",
            &["\"12 s\""],
        ),
    ],
    rules: None,
};

pub(super) static LINE: TableSpec = TableSpec {
    what: "a line",
    doc: "A mooring line from a body to a bollard or to another body. Its weight is neglected.",
    keys: &[
        key(
            "from",
            Kind::BodyName,
            Refused,
            "The body that holds the line, with a winch or bitts.",
            &["\"ship\""],
        ),
        key(
            "fairlead",
            Kind::Point(POSITION),
            Unless("`chock` is given"),
            "Fairlead, forward and starboard of the body's origin.",
            &["[140, 5]"],
        ),
        key(
            "fairlead_height",
            Kind::Quantity(PLACE),
            Is("0"),
            "Fairlead above the still water; on a fixed body above datum.",
            &["\"12 m\""],
        ),
        key(
            "chock",
            Kind::Text,
            Unless("`fairlead` is given"),
            "A chock of the vessel that `from` is, instead of `fairlead` and `fairlead_height`.",
            &["\"head\""],
        ),
        key(
            "to",
            Kind::BodyName,
            Refused,
            "The body at the other end: a quay, a ship.",
            &["\"quay\""],
        ),
        key(
            "bollard",
            Kind::Point(POSITION),
            Unless("`bitts` is given"),
            "Bollard, forward and starboard of that body's origin.",
            &["[170, 4]"],
        ),
        key(
            "bollard_height",
            Kind::Quantity(PLACE),
            Is("0"),
            "Bollard above the still water; on a fixed body above datum.",
            &["\"4 m\""],
        ),
        key(
            "bitts",
            Kind::Text,
            Unless("`bollard` is given"),
            "Bitts of the vessel that `to` is, instead of `bollard` and `bollard_height`.",
            &["\"fore\""],
        ),
        key("rope", Kind::Choice(&ROPES), Refused, "Material of the rope.", &["\"hmpe\""]),
        key(
            "break_load",
            Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e9 }),
            Refused,
            "Line design break force.",
            &["\"1200 kN\""],
        ),
        key(
            "tail",
            Kind::Table(&TAIL),
            Means("no tail"),
            "A softer tail in series at the far end.",
            &[],
        ),
        key(
            "length",
            Kind::Quantity(LENGTH),
            Unless("`pretension` is given"),
            "Unstretched length outboard, tail included.",
            &["\"45 m\""],
        ),
        key(
            "pretension",
            Kind::Quantity(FORCE),
            Unless("`length` is given"),
            "Tension with which it is made fast.",
            &["\"100 kN\""],
        ),
        key(
            "winch",
            Kind::Flag,
            Is("false"),
            "On a winch whose brake renders at 60 % of the break load, rather than on bitts.",
            &["true"],
        ),
        key("made_fast", Kind::Quantity(TIME), Is("0"), "When it is made fast.", &["\"25 min\""]),
    ],
    rules: Some(|| {
        let either = |place: &str, height: &str, name: &str| {
            let refused: serde_json::Map<String, serde_json::Value> =
                [(height.to_owned(), json!(false))].into_iter().collect();
            json!({ "oneOf": [
                { "required": [place] }, { "required": [name], "properties": refused }
            ] })
        };
        json!({
            "oneOf": [{ "required": ["length"] }, { "required": ["pretension"] }],
            "allOf": [
                either("fairlead", "fairlead_height", "chock"),
                either("bollard", "bollard_height", "bitts")
            ]
        })
    }),
};

static TAIL: TableSpec = TableSpec {
    what: "a tail",
    doc: "A softer tail in series.",
    keys: &[
        key("rope", Kind::Choice(&ROPES), Is("\"nylon\""), "Material of the rope.", &["\"nylon\""]),
        key(
            "break_load",
            Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e9 }),
            Refused,
            "Its break force.",
            &["\"1500 kN\""],
        ),
        key("length", Kind::Quantity(LENGTH), Is("11"), "Its length.", &["\"11 m\""]),
    ],
    rules: None,
};

static ROPES: Choices<fn() -> RopeCurve> = Choices(&[
    Choice { word: "wire", value: RopeCurve::wire, doc: "steel wire with a steel core" },
    Choice { word: "hmpe", value: RopeCurve::hmpe, doc: "high-modulus polyethylene" },
    Choice { word: "polyester", value: RopeCurve::polyester, doc: "polyester" },
    Choice { word: "nylon", value: RopeCurve::nylon, doc: "nylon, as tails are made of" },
]);
