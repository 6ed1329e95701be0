//! Keys of bodies.

use serde_json::json;

use super::approach::{APPROACH, ApproachKey};
use super::dolphin::{DOLPHIN, DolphinKey};
use super::hull::{OUTLINE_AT_HEIGHT, OutlineAtHeightKey};
use super::quantities::{DIRECTION, POSITION, SPEED};
use crate::held::{Flag, ListOf, Number, Points, TableOf, Text, Vector};
use crate::spec::Absent::{Is, Means, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

/// A body.
pub static BODY: TableSpec = TableSpec {
    what: "a body",
    doc: "A ship, tug, quay or dolphin: fixed, on piles, or floating with a mass.",
    keys: BodyKey::ALL,
    rules: Some(|| {
        json!({
            "dependentSchemas": { "approach": {
                "properties": { "position": false, "heading": false, "velocity": false }
            } },
            "allOf": [{ "properties": { "outlines": { "minItems": 2 } } }],
            "not": { "anyOf": [
                { "required": ["outline", "outlines"] },
                { "required": ["chart_outline", "outline"] },
                { "required": ["chart_outline", "outlines"] }
            ] },
            "dependentRequired": { "draught": ["outlines"] },
            "if": { "anyOf": [
                { "properties": { "fixed": { "const": true } }, "required": ["fixed"] },
                { "required": ["dolphin"] }
            ] },
            "then": {
                "properties": {
                    "mass": false, "gyradius": false, "yaw_inertia": false,
                    "added_mass": false, "velocity": false, "vessel": false, "running": false,
                    "air_draught": false,
                    "approach": false, "draught": false
                },
                "not": {
                    "properties": { "fixed": { "const": true } }, "required": ["fixed", "dolphin"]
                },
                "anyOf": [
                    { "required": ["outline"] }, { "required": ["outlines"] }, { "required": ["chart_outline"] }
                ],
                "if": { "required": ["dolphin"] },
                "then": { "properties": { "chart_outline": false } }
            },
            "else": {
                "properties": { "chart_outline": false },
                "if": { "required": ["vessel"] },
                "then": {
                    "properties": {
                        "mass": false, "gyradius": false, "yaw_inertia": false, "added_mass": false,
                        "draught": false
                    }
                },
                "else": {
                    "properties": { "running": false, "air_draught": false },
                    "required": ["mass"],
                    "anyOf": [{ "required": ["outline"] }, { "required": ["outlines", "draught"] }],
                    "oneOf": [{ "required": ["gyradius"] }, { "required": ["yaw_inertia"] }]
                }
            }
        })
    }),
};

table_keys! {
    /// Keys of a body.
    pub BodyKey {
        FIXED: Flag = key(
            "fixed",
            Kind::Flag,
            Is("false"),
            "True for a body that never moves and has no mass and no velocity.",
            &["true"],
        ),
        DOLPHIN: TableOf<DolphinKey> = key(
            "dolphin",
            Kind::Table(&DOLPHIN),
            Means("the body floats or is `fixed`"),
            "Makes the body a flexible dolphin: a head on piles that bend, with the mass of head \
             and piles.",
            &["{ stiffness = \"5 MN/m\", mass = \"60 t\", yield_load = \"1500 kN\" }"],
        ),
        OUTLINE: Points = key(
            "outline",
            Kind::Outline(POSITION),
            Means("the outline of the vessel"),
            "Vertices of the body's outline, forward and to starboard of the centre of gravity, in \
             either direction round the hull. The outline need not be convex.",
            &["[[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]"],
        ),
        CHART_OUTLINE: Text = key(
            "chart_outline",
            Kind::Text,
            Means("`outline` gives the shape"),
            "For a fixed body: the name of an area of the chart that is the body's outline, \
             instead of `outline`. The body has the shape and the place of the area of the chart. \
             `position` and `heading` place the axes of the body, in which fenders and bollards \
             are given.",
            &["\"quay 3\""],
        ),
        OUTLINES: ListOf<OutlineAtHeightKey> = key(
            "outlines",
            Kind::List(&OUTLINE_AT_HEIGHT),
            Means("one outline: vertical sides"),
            "Outlines of the body at two or more heights, instead of `outline`. Each fender meets \
             the body's outline at the height of the fender; tide, heave, heel and trim are taken \
             into account. Other bodies meet the body's outline at the waterline. Coupled method \
             only.",
            &["[{ height = 0, outline = [[-16, -6], [16, -6], [16, 6], [-16, 6]] }, \
               { height = \"12 m\", outline = [[-16, -7], [17, -7], [17, 7], [-16, 7]] }]"],
        ),
        DRAUGHT: Number = key(
            "draught",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1e-3, high: 100.0 }),
            Unless("the body has no `outlines`, or is fixed or a vessel"),
            "Draught of a plain body with `outlines`: the height of its waterline above the keel.",
            &["\"9 m\""],
        ),
        VESSEL: Text = key(
            "vessel",
            Kind::Text,
            Means("a plain body"),
            "Kind of vessel: from this scenario, from the library (`fenderline vessels`) or from \
             `vessel_files`. Mass, added mass, outline and coefficients follow from the kind.",
            &["\"container-ship\""],
        ),
        RUNNING: Number = key(
            "running",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -1.0, high: 1.0 }),
            Means("engine stopped"),
            "Shaft revolutions at the start, as a fraction of full revolutions.",
            &["0.3"],
        ),
        AIR_DRAUGHT: Number = key(
            "air_draught",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 500.0 }),
            Means("the clearance under bridges and cables is not checked"),
            "Height of the vessel's highest point above her waterline at rest, in the draught that she has. \
             Bridges and cables of the chart with a clearance are compared with this height, which needs \
             `chart.clearance_datum`.",
            &["\"38 m\""],
        ),
        MASS: Number = key(
            "mass",
            Kind::Quantity(Quantity { measure: &unit::MASS, low: 1e-3, high: 1e15 }),
            Unless("the body is fixed, a dolphin or a vessel"),
            "Displacement, without added mass.",
            &["\"87800 t\""],
        ),
        GYRADIUS: Number = key(
            "gyradius",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1e-3, high: 1e5 }),
            Unless("`yaw_inertia` is given, or the body is fixed, a dolphin or a vessel"),
            "Radius of gyration about the vertical through the centre of gravity.",
            &["\"74.5 m\""],
        ),
        YAW_INERTIA: Number = key(
            "yaw_inertia",
            Kind::Quantity(Quantity { measure: &unit::MOMENT_OF_INERTIA, low: 1e-9, high: 1e25 }),
            Unless("`gyradius` is given, or the body is fixed, a dolphin or a vessel"),
            "Moment of inertia about the vertical through the centre of gravity.",
            &["\"4.87e8 t.m^2\""],
        ),
        ADDED_MASS: TableOf<AddedMassKey> = key(
            "added_mass",
            Kind::Table(&ADDED_MASS),
            Means("no added mass"),
            "Added mass of the body, as fractions of its mass and of its yaw inertia.",
            &["{ surge = 0.031, sway = 0.506, yaw = 0.72 }"],
        ),
        POSITION: Vector = key(
            "position",
            Kind::Vector(POSITION),
            Is("[0, 0]"),
            "Initial position of the body's centre of gravity: north, east.",
            &["[0, 30]", "[\"1 km\", 0]"],
        ),
        HEADING: Number = key(
            "heading",
            Kind::Quantity(DIRECTION),
            Is("0"),
            "Initial heading of the body, clockwise from north.",
            &["\"270 deg\""],
        ),
        VELOCITY: TableOf<VelocityKey> = key(
            "velocity",
            Kind::Table(&VELOCITY),
            Means("at rest"),
            "Initial velocity of the body, along and about the body's own axes.",
            &["{ surge = \"4 kn\" }"],
        ),
        APPROACH: TableOf<ApproachKey> = key(
            "approach",
            Kind::Table(&APPROACH),
            Means("`position`, `heading` and `velocity` give the start of the body"),
            "The start of a berthing by speed and angle at a fender, instead of `position`, \
             `heading` and `velocity`.",
            &[],
        ),
    }
}

pub(super) static ADDED_MASS: TableSpec = TableSpec {
    what: "an added mass",
    doc: "Added mass of a body, as fractions of its mass and of its yaw inertia.",
    keys: AddedMassKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of an added mass.
    pub AddedMassKey {
        SURGE: Number = key(
            "surge",
            Kind::Quantity(ADDED_FRACTION),
            Is("0"),
            "Added mass in surge divided by the mass of the body.",
            &["0.031"],
        ),
        SWAY: Number = key(
            "sway",
            Kind::Quantity(ADDED_FRACTION),
            Is("0"),
            "Added mass in sway divided by the mass of the body.",
            &["0.506"],
        ),
        YAW: Number = key(
            "yaw",
            Kind::Quantity(ADDED_FRACTION),
            Is("0"),
            "Added moment of inertia in yaw divided by the body's yaw inertia.",
            &["0.72"],
        ),
    }
}

const ADDED_FRACTION: Quantity = Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1000.0 };

pub(super) static VELOCITY: TableSpec = TableSpec {
    what: "a velocity",
    doc: "Velocity of a body, along and about the body's own axes.",
    keys: VelocityKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a velocity.
    pub VelocityKey {
        SURGE: Number = key(
            "surge",
            Kind::Quantity(SPEED),
            Is("0"),
            "Velocity forward.",
            &["\"4 kn\""],
        ),
        SWAY: Number = key(
            "sway",
            Kind::Quantity(SPEED),
            Is("0"),
            "Velocity to starboard.",
            &["\"-0.15 m/s\""],
        ),
        YAW: Number = key(
            "yaw",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: -1e3, high: 1e3 }),
            Is("0"),
            "Rate of turn, to starboard.",
            &["\"3 deg/s\""],
        ),
    }
}
