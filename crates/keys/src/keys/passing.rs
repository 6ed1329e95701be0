//! Keys of passing ships, and of the flow between vessels.

use fenderline_sim::passing::{Berth, DepthFactors};
use serde_json::json;

use super::quantities::{DIRECTION, LENGTH, POSITION};
use crate::choices::{Choice, Choices};
use crate::held::{Curve, Flag, Number, OneOf, Points, Text, Vector};
use crate::spec::Absent::{Is, Means, Refused, Unless};
use crate::spec::{CurveSpec, Kind, Quantity, TableSpec, key};
use crate::units::measures as unit;
use crate::{shared_keys, table_keys};

pub(super) static PASSING: TableSpec = TableSpec {
    what: "a passing ship",
    doc: "A ship that passes on a given track; no force acts on the passing ship. The flow about \
        the passing ship pushes the vessels of the scenario, by Wang's (1975) method for slender \
        ships. The passing ship touches nothing.",
    keys: PassingKey::ALL,
    rules: Some(|| {
        json!({ "allOf": [
            { "oneOf": [
                { "required": ["vessel"], "properties": { "length": false, "beam": false, "draught": false } },
                { "required": ["length", "beam", "draught"], "properties": { "vessel": false } }
            ] },
            { "oneOf": [
                {
                    "required": ["position", "heading"],
                    "properties": { "waypoints": false, "turning_radius": false }
                },
                { "required": ["waypoints"], "properties": { "position": false, "heading": false } }
            ] },
            { "oneOf": [
                { "required": ["speed"], "properties": { "speeds": false } },
                { "required": ["speeds"], "properties": { "speed": false } }
            ] }
        ] })
    }),
};

table_keys! {
    /// Keys of a passing ship.
    pub PassingKey {
        VESSEL: Text = key(
            "vessel",
            Kind::Text,
            Unless("`length`, `beam` and `draught` of the passing ship are given"),
            "The kind of vessel of the passing ship: from the library, from `vessel_files` or from \
             this scenario.",
            &["\"kcs\""],
        ),
        LENGTH: Number = key(
            "length",
            Kind::Quantity(SHIP),
            Unless("`vessel` is given"),
            "Length of the passing ship.",
            &["\"185 m\""],
        ),
        BEAM: Number = key(
            "beam",
            Kind::Quantity(SHIP),
            Unless("`vessel` is given"),
            "Beam of the passing ship.",
            &["\"26 m\""],
        ),
        DRAUGHT: Number = key(
            "draught",
            Kind::Quantity(SHIP),
            Unless("`vessel` is given"),
            "Draught of the passing ship.",
            &["7"],
        ),
        MIDSHIP_COEFFICIENT: Number = key(
            "midship_coefficient",
            Kind::Quantity(COEFFICIENT),
            Is("0.98"),
            MIDSHIP,
            &["0.95"],
        ),
        SECTIONS: OneOf<SectionsBy> = key(
            "sections",
            Kind::Choice(&SECTIONS),
            Is("\"parabola\""),
            AREAS,
            &["\"outline\""],
        ),
        OUTLINE: Points = key(
            "outline",
            Kind::Outline(POSITION),
            Means("the outline of the vessel in `vessel`, or a rectangle"),
            "Waterline of the passing ship, with vertices relative to midship; it gives the \
             sectional areas with `sections = \"outline\"`, and the ship is drawn with it in \
             plans.",
            &["[[-92, -13], [70, -13], [92, 0], [70, 13], [-92, 13]]"],
        ),
        POSITION: Vector = key(
            "position",
            Kind::Vector(POSITION),
            Unless("`waypoints` are given"),
            "A point on the passing ship's straight track: north, east.",
            &["[0, 9000]"],
        ),
        HEADING: Number = key(
            "heading",
            Kind::Quantity(DIRECTION),
            Unless("`waypoints` are given"),
            "Direction of the passing ship's straight track.",
            &["\"90 deg\""],
        ),
        WAYPOINTS: Points = key(
            "waypoints",
            Kind::Points(POSITION, 2, 1000),
            Means("the track is straight, through `position`"),
            "The track of the passing ship: north and east coordinate of each waypoint. Before the \
             first and after the last waypoint the track is straight.",
            &["[[-2000, 9000], [0, 9000], [2000, 9900]]"],
        ),
        TURNING_RADIUS: Number = key(
            "turning_radius",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1.0, high: 1e5 }),
            Means("three lengths of the passing ship"),
            "Radius of the bends of the track at the waypoints.",
            &["\"600 m\""],
        ),
        SPEED: Number = key(
            "speed",
            Kind::Quantity(PACE),
            Unless("`speeds` are given"),
            "Speed of the passing ship over the ground.",
            &["\"8 kn\""],
        ),
        SPEEDS: Curve = key(
            "speeds",
            Kind::Curve(&PACES),
            Means("`speed` throughout"),
            "Speed of the passing ship by time: rows of time and speed. The speed is linear \
             between the rows, and constant before the first and after the last row.",
            &["[[0, \"8 kn\"], [\"5 min\", \"5 kn\"]]"],
        ),
        TIME: Number = key(
            "time",
            Kind::Quantity(MOMENT),
            Is("0"),
            "Time at which the passing ship is at `position`, or at the first of `waypoints`.",
            &["\"5 min\""],
        ),
        DEPTH_FACTORS: OneOf<DepthFactors> = key(
            "depth_factors",
            Kind::Choice(&DEPTHS),
            Refused,
            "How the forces, which are computed for deep water, are corrected for the depth of the \
             water.",
            &["\"kriebel\""],
        ),
        BERTH: OneOf<Berth> = key(
            "berth",
            Kind::Choice(&BERTHS),
            Is("\"open\""),
            "What lies behind the vessels that the ship passes: a jetty or a quay wall.",
            &["\"quay\""],
        ),
    }
}

pub(super) static INTERACTION: TableSpec = TableSpec {
    what: "an interaction",
    doc: "How the flow of water about vessels and passing ships pushes other vessels.",
    keys: InteractionKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of an interaction.
    pub InteractionKey {
        BETWEEN_VESSELS: Flag = key(
            "between_vessels",
            Kind::Flag,
            Is("false"),
            "Whether the flow about each vessel pushes the other vessels, when they meet, \
             overtake, or lie beside each other. The flow between vessels is computed for deep \
             water and without lift. The force between vessels is left out for vessels shorter \
             than 3.5 beams, such as tugs, and for vessels nearer to each other than a quarter of \
             their mean beam.",
            &["true"],
        ),
        MIDSHIP_COEFFICIENT: Number = key(
            "midship_coefficient",
            Kind::Quantity(COEFFICIENT),
            Is("0.98"),
            MIDSHIP,
            &["0.95"],
        ),
        SECTIONS: OneOf<SectionsBy> = key(
            "sections",
            Kind::Choice(&SECTIONS),
            Is("\"parabola\""),
            AREAS,
            &["\"outline\""],
        ),
    }
}

shared_keys! {
    /// Keys that say how the sectional areas of a ship are found.
    pub SectionsKey of PassingKey and InteractionKey {
        MIDSHIP_COEFFICIENT: Number,
        SECTIONS: OneOf<SectionsBy>,
    }
}

const MIDSHIP: &str = "Area of the midship section divided by the product of beam and draught. The \
                       default of 0.98 is an assumption.";
const AREAS: &str = "How the areas of the ship's sections along her length are found.";
const SHIP: Quantity = Quantity { measure: LENGTH.measure, low: 0.1, high: 1000.0 };
const COEFFICIENT: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.3, high: 1.0 };
const PACE: Quantity = Quantity { measure: &unit::SPEED, low: 0.0, high: 50.0 };
const MOMENT: Quantity = Quantity { measure: &unit::TIME, low: -1e8, high: 1e8 };

static PACES: CurveSpec = CurveSpec { from: ("time", MOMENT), to: ("speed", PACE), fewest: 1 };

/// How the sectional areas of a ship are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SectionsBy {
    /// The sectional areas are a parabola over the ship's length.
    Parabola,
    /// The sectional areas follow from the beam of the ship's outline.
    Outline,
}

static SECTIONS: Choices<SectionsBy> = Choices(&[
    Choice {
        word: "parabola",
        value: SectionsBy::Parabola,
        doc: "the sectional areas are a parabola over the length, from the midship section to \
              nothing at both ends, as in Wang's paper",
    },
    Choice {
        word: "outline",
        value: SectionsBy::Outline,
        doc: "each sectional area is the beam of the outline at the section, times draught and \
              midship coefficient",
    },
]);

static DEPTHS: Choices<DepthFactors> = Choices(&[
    Choice {
        word: "none",
        value: DepthFactors::DeepWater,
        doc: "no correction for the depth; in model tests in shallow water the forces were several \
              times as large",
    },
    Choice {
        word: "kriebel",
        value: DepthFactors::Kriebel,
        doc: "correction by factors from Kriebel's (2005) model tests of parallel passing; the \
              factors are from memory, because we could not read the paper",
    },
]);

static BERTHS: Choices<Berth> = Choices(&[
    Choice { word: "open", value: Berth::Open, doc: "a jetty through which the water flows" },
    Choice {
        word: "quay",
        value: Berth::Quay,
        doc: "a quay wall: the surge force is multiplied by 1.4, the sway force by 0.4 and the yaw \
              moment by 0.5, an estimate from figures of Swiegers (2011)",
    },
]);
