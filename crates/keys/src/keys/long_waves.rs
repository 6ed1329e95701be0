//! Keys of long waves at a berth.

use serde_json::json;

use super::quantities::{DIRECTION, SEED};
use crate::held::{Flag, Number, Text};
use crate::spec::Absent::{Is, Means, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

/// Bounds of a period of long waves.
const PERIOD: Quantity = Quantity { measure: &unit::TIME, low: 25.0, high: 86_400.0 };

pub(super) static LONG_WAVES: TableSpec = TableSpec {
    what: "long waves",
    doc: "Long waves at a berth (infragravity waves or a seiche) as level and velocity of the \
          water at the berth. Long waves are given as a spectrum, as a regular wave, or by a `file`. The \
          level of the long waves is added to the tide, so that long waves lift ships beside quay, \
          fenders and bollards. The velocity of the long waves is added to the current, and the \
          acceleration of this flow pushes a vessel in proportion to her mass and added mass. \
          Level and velocity of the long waves are the same all over the berth, and the velocity \
          is the same over the depth. The velocities of a spectrum and of a regular wave follow \
          from linear wave theory with the depth at the start, so both need `environment.depth`. \
          Hull forces and added mass follow the depth of the tide, without the level of long \
          waves.",
    keys: LongWavesKey::ALL,
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

table_keys! {
    /// Keys of long waves.
    pub LongWavesKey {
        HEIGHT: Number = key(
            "height",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 20.0 }),
            Unless("`file` is given"),
            "Significant height of the long waves, or height of the regular wave from trough to \
             crest; with `wall_distance`, the height at the wall. Waves break at a height of 0.78 \
             of the depth, so the program refuses a greater height.",
            &["\"0.15 m\""],
        ),
        PERIOD: Number = key(
            "period",
            Kind::Quantity(PERIOD),
            Unless("`file` is given"),
            "Peak period of the long waves, or period of the regular wave. The shortest wave must \
             be at least ten water depths long, because the velocity of shorter waves varies over \
             the depth.",
            &["\"100 s\""],
        ),
        TOWARDS: Number = key(
            "towards",
            Kind::Quantity(DIRECTION),
            Unless("`file` is given"),
            "Direction in which the waves run, clockwise from north. With `wall_distance`, the \
             wall lies in this direction.",
            &["\"0 deg\""],
        ),
        WALL_DISTANCE: Number = key(
            "wall_distance",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e5 }),
            Means("the waves run on"),
            "Distance from the berth to a wall that reflects the waves completely, so that the \
             waves stand, like a seiche in a basin. At the wall the level moves without velocity; \
             a quarter of a wave length from the wall the water moves without a change of level.",
            &["\"350 m\""],
        ),
        REGULAR: Flag = key(
            "regular",
            Kind::Flag,
            Is("false"),
            "If true, the long waves are one regular wave instead of a spectrum; its crest is at \
             the berth at the start.",
            &["true"],
        ),
        SHORTEST_PERIOD: Number = key(
            "shortest_period",
            Kind::Quantity(PERIOD),
            Means("half of `period`, but at least 25 s"),
            "Shortest period of the spectrum of long waves. The shortest period must be longer \
             than the longest period of `waves`; otherwise energy would be counted twice.",
            &["\"50 s\""],
        ),
        LONGEST_PERIOD: Number = key(
            "longest_period",
            Kind::Quantity(PERIOD),
            Means("twice `period`"),
            "Longest period of the spectrum of long waves.",
            &["\"200 s\""],
        ),
        PEAKEDNESS: Number = key(
            "peakedness",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 10.0 }),
            Means("3.3"),
            "Peak enhancement of the spectrum of long waves. The spectrum has the shape of \
             JONSWAP, which is our assumption, because we know of no standard shape.",
            &["1"],
        ),
        SEED: Number = key(
            "seed",
            Kind::Quantity(SEED),
            Means("1"),
            "Seed of the phases: the same seed gives the same waves.",
            &["7"],
        ),
        FILE: Text = key(
            "file",
            Kind::FileName,
            Unless("`height`, `period` and `towards` of the waves are given"),
            "Level and velocity of the water in time: a CSV file beside the scenario with the \
             columns t_s, level_m, north_mps and east_mps. The rows of the file are in the order of time and \
             cover the run from start to end without gaps. Level and velocity are linear between \
             the rows: choose time steps of a twentieth of the shortest period or less.",
            &["\"long_waves.csv\""],
        ),
    }
}
