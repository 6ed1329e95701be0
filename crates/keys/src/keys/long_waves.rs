//! Keys of long waves at a berth.

use serde_json::json;

use super::quantities::{DIRECTION, SEED};
use crate::spec::Absent::{Is, Means, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::units::measures as unit;

/// A period of long waves.
const PERIOD: Quantity = Quantity { measure: &unit::TIME, low: 25.0, high: 86_400.0 };

pub(super) static LONG_WAVES: TableSpec = TableSpec {
    what: "long waves",
    doc: "Long waves at a berth, infragravity waves or a seiche, as level and velocity of the water there: a spectrum, a regular wave, or a \
          `file`. The level is added to the tide, so it lifts ships beside quay, fenders and bollards; the velocity is added to the current, \
          and its acceleration pushes her mass and added mass. Both are the same all over the berth and over the depth. A spectrum and a \
          regular wave have the velocities of linear waves in the depth of the start, so they need `environment.depth`. A vessel's hull \
          forces and added mass stay those of the tide's depth.",
    keys: &[
        key(
            "height",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 20.0 }),
            Unless("`file` is given"),
            "Significant height, or that of the regular wave from trough to crest; with `wall_distance` that at the wall. Waves break at \
             0.78 of the depth and are refused there.",
            &["\"0.15 m\""],
        ),
        key(
            "period",
            Kind::Quantity(PERIOD),
            Unless("`file` is given"),
            "Peak period, or that of the regular wave. The shortest wave must be ten depths long, or its velocity is not that of long \
             waves.",
            &["\"100 s\""],
        ),
        key(
            "towards",
            Kind::Quantity(DIRECTION),
            Unless("`file` is given"),
            "Where they run to, clockwise from north. With `wall_distance`: where the wall is.",
            &["\"0 deg\""],
        ),
        key(
            "wall_distance",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e5 }),
            Means("the waves run on"),
            "Distance from the berth to a wall that reflects them wholly, so that they stand, as a seiche does in a basin: level without \
             velocity at the wall, velocity without level a quarter of a wave length from it.",
            &["\"350 m\""],
        ),
        key(
            "regular",
            Kind::Flag,
            Is("false"),
            "One regular wave instead of a spectrum; its crest is at the start.",
            &["true"],
        ),
        key(
            "shortest_period",
            Kind::Quantity(PERIOD),
            Means("half of `period`, 25 s at least"),
            "Shortest period of the spectrum. It must be longer than the longest wave of `waves`, or energy there is in both.",
            &["\"50 s\""],
        ),
        key(
            "longest_period",
            Kind::Quantity(PERIOD),
            Means("twice `period`"),
            "Longest period of the spectrum.",
            &["\"200 s\""],
        ),
        key(
            "peakedness",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 10.0 }),
            Means("3.3"),
            "Peak enhancement of the spectrum, which has the shape of JONSWAP: our assumption, as no standard shape is known to us.",
            &["1"],
        ),
        key(
            "seed",
            Kind::Quantity(SEED),
            Means("1"),
            "Seed of the phases: the same seed gives the same waves.",
            &["7"],
        ),
        key(
            "file",
            Kind::FileName,
            Unless("`height`, `period` and `towards` are given"),
            "Level and velocity in time: a CSV file beside this one with the columns t_s, level_m, north_mps and east_mps, in the order of \
             time, from the start of the run to its end, without gaps. Straight lines between the rows: a twentieth of the \
             shortest period or less between them.",
            &["\"long_waves.csv\""],
        ),
    ],
    rules: Some(|| {
        json!({ "oneOf": [
            { "required": ["height", "period", "towards"], "properties": { "file": false } },
            { "required": ["file"], "properties": {
                "height": false, "period": false, "towards": false, "wall_distance": false, "regular": { "const": false },
                "shortest_period": false, "longest_period": false, "peakedness": false, "seed": false
            } }
        ],
        "if": { "required": ["regular"], "properties": { "regular": { "const": true } } },
        "then": { "properties": {
            "shortest_period": false, "longest_period": false, "peakedness": false, "seed": false
        } } })
    }),
};
