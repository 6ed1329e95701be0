//! Rows of bollards: by two places, along a wall, or along a quay line of the chart.

use serde_json::{Value as Json, json};

use super::fender_row::{FenderRowKey, MOST_IN_ROW};
use super::mooring::BollardKey;
use super::quantities::{FENDER_SIZE, POSITION};
use super::quay_line::QuayLineKey;
use crate::held::{Name, Number, Points, TableOf, Vector};
use crate::spec::Absent::{Is, Refused, Unless};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec, key};
use crate::units::measures as unit;
use crate::{shared_keys, table_keys};

pub(super) static BOLLARD_ROW: TableSpec = TableSpec {
    what: "a row of bollards",
    doc: "A row of equal bollards, which are named NAME_1, NAME_2 and so on. The row runs from `first` \
          to `last` with one of the keys `spacing` and `number`, or stands along a `wall` or a \
          `quay_line`.",
    keys: BollardRowKey::ALL,
    rules: Some(bollard_row_rules),
};

/// The declaration of a key of a row of fenders, with another documentation.
const fn of_bollards(key: KeySpec, doc: &'static str) -> KeySpec {
    KeySpec { doc, ..key }
}

table_keys! {
    /// Keys of a row of bollards.
    pub BollardRowKey {
        ON: Name = key(
            "on",
            Kind::BodyName,
            Refused,
            "The body that carries the row.",
            &["\"quay\""],
        ),
        FIRST: Vector = key(
            "first",
            Kind::Point(POSITION),
            Unless("`wall` or `quay_line` of the row is given"),
            "Place of the first bollard: distances forward and to starboard of the body's origin.",
            &["[-75, 1.5]"],
        ),
        LAST: Vector = key(
            "last",
            Kind::Point(POSITION),
            Unless("`wall` or `quay_line` of the row is given"),
            "Place of the last bollard.",
            &["[75, 1.5]"],
        ),
        SPACING: Number = key(
            "spacing",
            Kind::Quantity(FENDER_SIZE),
            Unless("`last` and `number` of the row are given"),
            "Distance from one bollard to the next.",
            &["\"25 m\""],
        ),
        NUMBER: Number = key(
            "number",
            Kind::Quantity(Quantity {
                measure: &unit::PLAIN_NUMBER,
                low: 1.0,
                high: MOST_IN_ROW as f64,
            }),
            Unless("`last` and `spacing`, or `quay_line`, of the row are given"),
            "Number of bollards. A row along a `quay_line` has as many as the line has room for, \
             unless the number is given.",
            &["7"],
        ),
        WALL: Points = of_bollards(
            FenderRowKey::ALL[WALL],
            "Two corners of the body between which the row stands along an edge of the outline, \
             from the first corner to the second.",
        ),
        QUAY_LINE: TableOf<QuayLineKey> = of_bollards(
            FenderRowKey::ALL[LINE],
            "A line of the chart along which the row stands.",
        ),
        FROM_CORNER: Number = of_bollards(
            FenderRowKey::ALL[FROM_CORNER],
            "Distance from the first corner of the `wall`, or from the start of the `quay_line`, to \
             the first bollard.",
        ),
        BEHIND: Number = key(
            "behind",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 100.0 }),
            Is("\"1 m\""),
            "Distance of the bollards behind the face of the `wall` or `quay_line`.",
            &["\"1.5 m\""],
        ),
        HEIGHT: Number = BOLLARD[2],
        LINES: Number = BOLLARD[3],
    }
}

/// The keys of a bollard.
const BOLLARD: &[KeySpec] = BollardKey::ALL;
/// Places of keys in the list of the keys of a row of fenders.
const WALL: usize = 5;
const LINE: usize = 6;
const FROM_CORNER: usize = 7;

shared_keys! {
    /// Keys of a row of fenders or bollards on a line.
    pub RowKey of FenderRowKey and BollardRowKey {
        ON: Name,
        FIRST: Vector,
        LAST: Vector,
        SPACING: Number,
        NUMBER: Number,
        WALL: Points,
        QUAY_LINE: TableOf<QuayLineKey>,
        FROM_CORNER: Number,
    }
}

/// The rules for the place of a row of bollards.
fn bollard_row_rules() -> Json {
    let refused = |names: &[&str]| -> Json {
        names.iter().map(|name| ((*name).to_owned(), json!(false))).collect()
    };
    json!({ "oneOf": [
        {
            "required": ["quay_line", "spacing"],
            "properties": refused(&["wall", "first", "last"])
        },
        {
            "required": ["wall", "spacing", "number"],
            "properties": refused(&["quay_line", "first", "last"])
        },
        {
            "required": ["first", "last"],
            "properties": refused(&["wall", "quay_line", "from_corner", "behind"]),
            "oneOf": [
                { "required": ["spacing"], "properties": refused(&["number"]) },
                { "required": ["number"], "properties": refused(&["spacing"]) }
            ]
        }
    ] })
}
