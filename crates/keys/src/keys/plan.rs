//! Keys of passage plans.

use serde_json::json;

use super::quantities::{LENGTH, POSITION};
use crate::held::{ListOf, Name, Number, Text, Vector};
use crate::spec::Absent::{Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static PLAN: TableSpec = TableSpec {
    what: "a passage plan",
    doc: "A passage plan of a vessel. The plan moves nothing: pages and reports draw the plan, with the wheel-over \
          points, and compare the vessel's way with the plan. A wheel-over point lies R tan(A/2) + F before its waypoint, \
          with the turning radius R, the change of course A and the reach F. The cross-track distance is that of midship. \
          A vessel has at most one plan.",
    keys: PlanKey::ALL,
    rules: Some(|| json!({ "allOf": [{ "properties": { "waypoint": { "minItems": 2 } } }] })),
};

table_keys! {
    /// Keys of a passage plan.
    pub PlanKey {
        VESSEL: Name = key(
            "vessel",
            Kind::BodyName,
            Refused,
            "The ship that follows the plan: a body with a vessel.",
            &["\"ship\""],
        ),
        REACH: Number = key(
            "reach",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e5 }),
            Means("one length of the vessel"),
            "Distance that the vessel goes on straight ahead after the wheel is put over.",
            &["\"200 m\""],
        ),
        WAYPOINT: ListOf<WaypointKey> = key(
            "waypoint",
            Kind::List(&WAYPOINT),
            Refused,
            "The waypoints, from the first to the last: two or more.",
            &[],
        ),
    }
}

pub(super) static WAYPOINT: TableSpec = TableSpec {
    what: "a waypoint",
    doc: "A waypoint of a passage plan. Speed and half width are those of the leg that leads to the waypoint; at the \
          first waypoint they have no effect.",
    keys: WaypointKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a waypoint.
    pub WaypointKey {
        NAME: Text = key(
            "name",
            Kind::Text,
            Means("no name: pages and reports number the waypoints"),
            "Name of the waypoint.",
            &["\"Sea buoy\""],
        ),
        POSITION: Vector = key(
            "position",
            Kind::Vector(POSITION),
            Refused,
            "Place of the waypoint: north and east.",
            &["[-300, -200]"],
        ),
        TURNING_RADIUS: Number = key(
            "turning_radius",
            Kind::Quantity(Quantity { measure: LENGTH.measure, low: 1.0, high: 1e5 }),
            Means("three lengths of the vessel"),
            "Radius of the turn at the waypoint. At the first and the last waypoint there is no turn.",
            &["\"600 m\""],
        ),
        SPEED: Number = key(
            "speed",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.0, high: 50.0 }),
            Means("no planned speed"),
            "Planned speed over the ground on the leg that leads to the waypoint.",
            &["\"6 kn\""],
        ),
        HALF_WIDTH: Number = key(
            "half_width",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 1e5 }),
            Means("no corridor"),
            "Half of the width of the corridor on the leg that leads to the waypoint: the greatest cross-track distance. \
             Outside the corridor an alarm sounds in a live session, and the verdict says so.",
            &["\"60 m\""],
        ),
    }
}
