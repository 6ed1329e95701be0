//! Keys of quay lines of the chart.

use serde_json::json;

use super::quantities::POSITION;
use crate::choices::{Choice, Choices};
use crate::held::{OneOf, Text, Vector};
use crate::spec::Absent::{Means, Unless};
use crate::spec::{Kind, TableSpec, key};
use crate::table_keys;

/// Farthest distance of `from` and `to` from the line of the chart (m).
pub const NEAR_LINE_M: f64 = 25.0;

pub(super) static QUAY_LINE: TableSpec = TableSpec {
    what: "a quay line",
    doc: "A quay line of the chart: a line of the chart, or the border of an area. With `from` and `to` \
          it is the part between the points of the line that are nearest to the two places; both places \
          must lie within 25 m of the same line. Without them it is the whole line with the name `name`.",
    keys: QuayLineKey::ALL,
    rules: Some(|| {
        json!({
            "dependentRequired": { "from": ["to"], "to": ["from"] },
            "anyOf": [{ "required": ["name"] }, { "required": ["from"] }]
        })
    }),
};

table_keys! {
    /// Keys of a quay line of the chart.
    pub QuayLineKey {
        CLASS: Text = key(
            "class",
            Kind::Text,
            Means("every class that can be `solid`"),
            "Class of the line's feature, as in `chart.solid`.",
            &["\"SLCONS\""],
        ),
        NAME: Text = key(
            "name",
            Kind::Text,
            Unless("`from` and `to` are given"),
            "Name of the line's feature in the chart.",
            &["\"Long Quay\""],
        ),
        FROM: Vector = key(
            "from",
            Kind::Vector(POSITION),
            Means("the whole line"),
            "Where the berth begins: north and east of the scenario's origin.",
            &["[500, 1300]"],
        ),
        TO: Vector = key(
            "to",
            Kind::Vector(POSITION),
            Means("the whole line"),
            "Where the berth ends: north and east of the scenario's origin.",
            &["[500, 1700]"],
        ),
        WATER: OneOf<WaterSide> = key(
            "water",
            Kind::Choice(&WATER_SIDES),
            Means("the side away from the body; at a strip, the side with charted depths"),
            "Side of the line on which the water lies, seen from `from` to `to`.",
            &["\"left\""],
        ),
    }
}

/// Sides of a line, seen along the line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WaterSide {
    /// To the left.
    Left,
    /// To the right.
    Right,
}

static WATER_SIDES: Choices<WaterSide> = Choices(&[
    Choice { word: "left", value: WaterSide::Left, doc: "The water lies to the left of the line." },
    Choice {
        word: "right",
        value: WaterSide::Right,
        doc: "The water lies to the right of the line.",
    },
]);
