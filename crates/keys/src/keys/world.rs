//! Keys of tugs.

use super::quantities::{FORCE, LENGTH, PLACE};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::units::measures as unit;

pub(super) static TUG: TableSpec = TableSpec {
    what: "a tug",
    doc: "A tug as a force at a point of a vessel. The largest force of the tug falls with speed \
          (derived, unvalidated). For a tug that pushes through her bow fender, use a vessel with \
          azimuth units and the orders `push_ship`, `pull_ship` and `follow_ship`.",
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
            "Point at which the tug pushes, from midship: forward, starboard.",
            &["[90, -23]"],
        ),
        key(
            "pull_at",
            Kind::Point(PLACE),
            Means("where she pushes"),
            "Fairlead of the tug's line, from midship: forward, starboard.",
            &["[140, 0]"],
        ),
        key(
            "above_water",
            Kind::Quantity(PLACE),
            Is("2"),
            "Height above the still water at which the tug pushes, and height of the fairlead of \
             the tug's line. At this height the force heels and trims a vessel with \
             `hydrodynamics`, and the point moves with the vessel. 2 m is assumed.",
            &["\"4 m\""],
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
            "Time constant of the tug's force and of its direction.",
            &["\"12 s\""],
        ),
    ],
    rules: None,
};
