//! Keys of what a tug that is a vessel does at a ship.

use super::POSITION_M;
use super::world::key;
use crate::spec::Absent::{Is, Refused};
use crate::spec::{Kind, Quantity, TableSpec};
use crate::units::measures as unit;

const FORCE: Quantity = Quantity { measure: &unit::FORCE, low: 1.0, high: 1e8 };
const DIRECTION: Quantity = Quantity { measure: &unit::ANGLE, low: -100.0, high: 100.0 };
const SPEED: Quantity = Quantity { measure: &unit::SPEED, low: 0.01, high: 10.0 };

pub(super) static PUSH_SHIP: TableSpec = TableSpec {
    what: "a push",
    doc: "She comes bow first to a point of a ship's side, touches at 0.1 m/s beside the ship's own speed, and \
          pushes. She does not find her way round the ship: be on the right side first.",
    keys: &[
        key("ship", Kind::BodyName, Refused, "The body to push.", &["\"ship\""]),
        key(
            "at",
            Kind::Point(POSITION_M),
            Refused,
            "Where, at the ship's side: forward and starboard of her body's origin.",
            &["[90, -23]"],
        ),
        key("force", Kind::Quantity(FORCE), Refused, "With what force.", &["\"300 kN\""]),
        key(
            "speed",
            Kind::Quantity(SPEED),
            Is("\"2 kn\""),
            "Her fastest, beside the ship's own.",
            &["\"1 kn\""],
        ),
    ],
    rules: None,
};

pub(super) static PULL_SHIP: TableSpec = TableSpec {
    what: "a pull",
    doc: "She pulls on a line between her and a ship, in a direction: astern with a line over her bow, ahead \
          with one over her stern.",
    keys: &[
        key("line", Kind::Text, Refused, "The line.", &["\"tow\""]),
        key("force", Kind::Quantity(FORCE), Refused, "With what thrust.", &["\"300 kN\""]),
        key(
            "direction",
            Kind::Quantity(DIRECTION),
            Refused,
            "Direction of the pull from the ship's bow, positive to starboard.",
            &["\"-90 deg\""],
        ),
        key(
            "speed",
            Kind::Quantity(SPEED),
            Is("\"2 kn\""),
            "Her fastest, beside the ship's own.",
            &["\"1 kn\""],
        ),
    ],
    rules: None,
};

pub(super) static FOLLOW_SHIP: TableSpec = TableSpec {
    what: "a place beside a ship",
    doc: "She keeps a place and a heading beside a ship, wherever the ship goes.",
    keys: &[
        key("ship", Kind::BodyName, Refused, "The body to follow.", &["\"ship\""]),
        key(
            "at",
            Kind::Point(POSITION_M),
            Refused,
            "Where her own centre of gravity shall be: forward and starboard of the ship's origin.",
            &["[90, -60]"],
        ),
        key(
            "heading",
            Kind::Quantity(DIRECTION),
            Is("0"),
            "Her heading, from that of the ship.",
            &["\"90 deg\""],
        ),
        key(
            "speed",
            Kind::Quantity(SPEED),
            Is("\"4 kn\""),
            "Her fastest, beside the ship's own.",
            &["\"3 kn\""],
        ),
    ],
    rules: None,
};
