//! Keys of tugs, lines and orders.

use fenderline_sim::hydro::actuator::Telegraph;
use fenderline_sim::mooring::RopeCurve;
use serde_json::json;

use super::POSITION_M;
use crate::choices::{Choice, Choices};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec};
use crate::units::measures as unit;

pub(crate) const LENGTH: Quantity = Quantity { measure: &unit::LENGTH, low: 0.01, high: 5000.0 };
pub(crate) const PLACE: Quantity = Quantity { measure: &unit::LENGTH, low: -5000.0, high: 5000.0 };
pub(super) const DIRECTION: Quantity = Quantity { measure: &unit::ANGLE, low: -100.0, high: 100.0 };
pub(super) const TIME: Quantity = Quantity { measure: &unit::TIME, low: 0.0, high: 1e9 };
pub(super) const FORCE: Quantity = Quantity { measure: &unit::FORCE, low: 1.0, high: 1e8 };
const SHARE: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: -1e3, high: 1e3 };

pub(crate) const fn key(
    name: &'static str,
    kind: Kind,
    absent: crate::spec::Absent,
    doc: &'static str,
    examples: &'static [&'static str],
) -> KeySpec {
    KeySpec { name, kind, absent, doc, examples }
}

pub(super) static TUG: TableSpec = TableSpec {
    what: "a tug",
    doc: "A tug that is a force at a point of a vessel: what she can give falls with speed (derived, \
          unvalidated). For one that pushes through her own bow fender use a vessel with azimuth units and the \
          orders `push_ship`, `pull_ship` and `follow_ship`.",
    keys: &[
        key(
            "vessel",
            Kind::BodyName,
            Refused,
            "The body of the vessel that she serves.",
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
            "From an order to its beginning.",
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
            "The body that has the winch or the bitts.",
            &["\"ship\""],
        ),
        key(
            "fairlead",
            Kind::Point(POSITION_M),
            Means("`chock` is given instead"),
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
            Means("`fairlead` is given instead"),
            "A chock of the vessel that `from` is, instead of `fairlead` and `fairlead_height`.",
            &["\"head\""],
        ),
        key(
            "to",
            Kind::BodyName,
            Refused,
            "The body that the other end is fast to: a quay, a ship.",
            &["\"quay\""],
        ),
        key(
            "bollard",
            Kind::Point(POSITION_M),
            Means("`bitts` is given instead"),
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
            Means("`bollard` is given instead"),
            "Bitts of the vessel that `to` is, instead of `bollard` and `bollard_height`.",
            &["\"fore\""],
        ),
        key("rope", Kind::Choice(&ROPES), Refused, "What it is made of.", &["\"hmpe\""]),
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
            Means("`pretension` is given"),
            "Unstretched length outboard, tail included.",
            &["\"45 m\""],
        ),
        key(
            "pretension",
            Kind::Quantity(FORCE),
            Means("`length` is given"),
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
        key("rope", Kind::Choice(&ROPES), Is("\"nylon\""), "What it is made of.", &["\"nylon\""]),
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

pub(crate) static ORDER: TableSpec = TableSpec {
    what: "an order",
    doc: "What is told at a time to a vessel (`vessel`), a tug (`tug`) or a line's winch (`line`): one thing an order.",
    keys: &[
        key("at", Kind::Quantity(TIME), Is("0"), "When.", &["\"90 s\""]),
        key(
            "vessel",
            Kind::BodyName,
            Means("it is for a tug or a line"),
            "The body of the vessel.",
            &["\"ship\""],
        ),
        key("tug", Kind::Text, Means("it is for a vessel or a line"), "The tug.", &["\"bow tug\""]),
        key(
            "line",
            Kind::Text,
            Means("it is for a vessel or a tug"),
            "The line.",
            &["\"head line\""],
        ),
        key(
            "rudder",
            Kind::Quantity(DIRECTION),
            Means("another order"),
            "Rudder, positive turns to starboard going ahead.",
            &["\"-20 deg\""],
        ),
        key(
            "engine",
            Kind::Quantity(SHARE),
            Means("another order"),
            "Revolutions over full ones.",
            &["0.4"],
        ),
        key(
            "telegraph",
            Kind::Choice(&TELEGRAPH),
            Means("another order"),
            "Engine telegraph.",
            &["\"slow astern\""],
        ),
        key("thruster", Kind::Table(&THRUSTER_ORDER), Means("another order"), "A thruster.", &[]),
        key(
            "azimuth",
            Kind::Table(&super::azimuth::AZIMUTH_ORDER),
            Means("another order"),
            "An azimuth unit.",
            &[],
        ),
        key(
            "push_ship",
            Kind::Table(&super::assist::PUSH_SHIP),
            Means("another order"),
            "A vessel with azimuth units comes to a ship's side and pushes.",
            &[],
        ),
        key(
            "pull_ship",
            Kind::Table(&super::assist::PULL_SHIP),
            Means("another order"),
            "A vessel with azimuth units pulls on a line between her and a ship.",
            &[],
        ),
        key(
            "follow_ship",
            Kind::Table(&super::assist::FOLLOW_SHIP),
            Means("another order"),
            "A vessel with azimuth units keeps a place beside a ship.",
            &[],
        ),
        key(
            "course",
            Kind::Quantity(DIRECTION),
            Means("another order"),
            "Keep this heading with the rudder.",
            &["\"35 deg\""],
        ),
        key(
            "speed",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: -20.0, high: 40.0 }),
            Means("another order"),
            "Keep this speed ahead through the water with the engine.",
            &["\"4 kn\""],
        ),
        key(
            "station",
            Kind::Table(&STATION),
            Means("another order"),
            "Go to a place and stay there, with engine, thrusters and the vessel's tugs.",
            &[],
        ),
        key(
            "hands",
            Kind::Flag,
            Means("another order"),
            "Pilots off; controls stay where they are.",
            &["true"],
        ),
        key(
            "push",
            Kind::Quantity(FORCE0),
            Means("another order"),
            "The tug pushes with this force.",
            &["\"300 kN\""],
        ),
        key(
            "pull",
            Kind::Quantity(FORCE0),
            Means("another order"),
            "The tug pulls on her line with this force.",
            &["\"300 kN\""],
        ),
        key(
            "direction",
            Kind::Quantity(DIRECTION),
            Means("square to the hull, away from her side or towards it"),
            "Direction of the tug's force from the vessel's bow, positive to starboard.",
            &["\"90 deg\""],
        ),
        key("stand_by", Kind::Flag, Means("another order"), "The tug stands by.", &["true"]),
        key(
            "heave",
            Kind::Quantity(RATE),
            Means("another order"),
            "The winch heaves in.",
            &["\"0.1 m/s\""],
        ),
        key(
            "pay_out",
            Kind::Quantity(RATE),
            Means("another order"),
            "The winch pays out.",
            &["\"0.1 m/s\""],
        ),
        key("hold", Kind::Flag, Means("another order"), "The winch holds.", &["true"]),
        key("let_go", Kind::Flag, Means("another order"), "The line is cast off.", &["true"]),
    ],
    rules: Some(|| {
        let one_of = |who: &str, what: &[&str]| {
            let required: Vec<_> = what.iter().map(|key| json!({ "required": [key] })).collect();
            json!({ "required": [who], "oneOf": required })
        };
        let none_of = |keys: &[&str]| {
            let refused: serde_json::Map<String, serde_json::Value> =
                keys.iter().map(|key| ((*key).to_owned(), json!(false))).collect();
            json!({ "properties": refused })
        };
        json!({
            // A flag that is false would ask for nothing.
            "allOf": [{ "properties": {
                "hands": { "const": true }, "stand_by": { "const": true },
                "hold": { "const": true }, "let_go": { "const": true }
            } }],
            "oneOf": [
                { "allOf": [
                    one_of("vessel", super::VESSEL_ORDERS),
                    none_of(&["tug", "line"]), none_of(super::TUG_ORDERS), none_of(super::LINE_ORDERS),
                    none_of(&["direction"])
                ] },
                { "allOf": [
                    one_of("tug", super::TUG_ORDERS),
                    none_of(&["vessel", "line"]), none_of(super::VESSEL_ORDERS), none_of(super::LINE_ORDERS)
                ] },
                { "allOf": [
                    one_of("line", super::LINE_ORDERS),
                    none_of(&["vessel", "tug"]), none_of(super::VESSEL_ORDERS), none_of(super::TUG_ORDERS),
                    none_of(&["direction"])
                ] }
            ]
        })
    }),
};

const FORCE0: Quantity = Quantity { measure: &unit::FORCE, low: 0.0, high: 1e8 };
const RATE: Quantity = Quantity { measure: &unit::SPEED, low: 0.0, high: 20.0 };

/// In the order of [`fenderline_sim::hydro::actuator::Telegraph::ALL`].
static TELEGRAPH: Choices<Telegraph> = Choices(&[
    Choice {
        word: "full astern",
        value: Telegraph::FullAstern,
        doc: "70 % of full revolutions astern",
    },
    Choice { word: "half astern", value: Telegraph::HalfAstern, doc: "55 % astern" },
    Choice { word: "slow astern", value: Telegraph::SlowAstern, doc: "40 % astern" },
    Choice { word: "dead slow astern", value: Telegraph::DeadSlowAstern, doc: "30 % astern" },
    Choice { word: "stop", value: Telegraph::Stop, doc: "stop" },
    Choice { word: "dead slow ahead", value: Telegraph::DeadSlowAhead, doc: "30 % ahead" },
    Choice { word: "slow ahead", value: Telegraph::SlowAhead, doc: "40 % ahead" },
    Choice { word: "half ahead", value: Telegraph::HalfAhead, doc: "55 % ahead" },
    Choice { word: "full ahead", value: Telegraph::FullAhead, doc: "70 % ahead: manoeuvring full" },
    Choice { word: "navigation full", value: Telegraph::NavigationFull, doc: "full revolutions" },
]);

static THRUSTER_ORDER: TableSpec = TableSpec {
    what: "an order to a thruster",
    doc: "Which thruster, and how much.",
    keys: &[
        key("name", Kind::Text, Refused, "The thruster.", &["\"bow\""]),
        key(
            "power",
            Kind::Quantity(SHARE),
            Refused,
            "-1 (full to port) to 1 (full to starboard).",
            &["-0.5"],
        ),
    ],
    rules: None,
};

static STATION: TableSpec = TableSpec {
    what: "a station",
    doc: "Where a vessel shall go, and how fast at most.",
    keys: &[
        key(
            "position",
            Kind::Vector(POSITION_M),
            Refused,
            "Place of her centre of gravity: north, east.",
            &["[0, 5.5]"],
        ),
        key("heading", Kind::Quantity(DIRECTION), Refused, "Heading.", &["\"0 deg\""]),
        key(
            "surge",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.01, high: 10.0 }),
            Is("0.5"),
            "The fastest along.",
            &["\"1 kn\""],
        ),
        key(
            "sway",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.01, high: 10.0 }),
            Is("0.2"),
            "The fastest across.",
            &["\"0.15 m/s\""],
        ),
    ],
    rules: None,
};
