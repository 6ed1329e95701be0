//! Keys of tugs.

use super::quantities::{FORCE, LENGTH, PLACE};
use crate::held::{Name, Number, Vector};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static TUG: TableSpec = TableSpec {
    what: "a tug",
    doc: "A tug as a force at a point of a vessel. The largest force of the tug falls with speed \
          (derived, unvalidated). For a tug that pushes through her bow fender, use a vessel with \
          azimuth units and the orders `push_ship`, `pull_ship` and `follow_ship`.",
    keys: TugKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a tug.
    pub TugKey {
        VESSEL: Name = key(
            "vessel",
            Kind::BodyName,
            Refused,
            "The body of the vessel that the tug serves.",
            &["\"ship\""],
        ),
        BOLLARD_PULL: Number = key(
            "bollard_pull",
            Kind::Quantity(FORCE),
            Refused,
            "Bollard pull.",
            &["\"60 tf\""],
        ),
        PUSH_AT: Vector = key(
            "push_at",
            Kind::Point(PLACE),
            Refused,
            "Point at which the tug pushes, from midship: forward, starboard.",
            &["[90, -23]"],
        ),
        PULL_AT: Vector = key(
            "pull_at",
            Kind::Point(PLACE),
            Means("where she pushes"),
            "Fairlead of the tug's line, from midship: forward, starboard.",
            &["[140, 0]"],
        ),
        ABOVE_WATER: Number = key(
            "above_water",
            Kind::Quantity(PLACE),
            Is("2"),
            "Height above the still water at which the tug pushes, and height of the fairlead of \
             the tug's line. At this height the force heels and trims a vessel with \
             `hydrodynamics`, and the point moves with the vessel. 2 m is assumed.",
            &["\"4 m\""],
        ),
        LENGTH: Number = key(
            "length",
            Kind::Quantity(LENGTH),
            Is("32"),
            "Her length.",
            &["\"32 m\""],
        ),
        BEAM: Number = key("beam", Kind::Quantity(LENGTH), Is("13"), "Her beam.", &["\"13 m\""]),
        DRAUGHT: Number = key(
            "draught",
            Kind::Quantity(LENGTH),
            Is("4.5"),
            "Her draught.",
            &["\"4.5 m\""],
        ),
        DELAY: Number = key(
            "delay",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 3600.0 }),
            Is("5"),
            "Time from an order to its start.",
            &["\"5 s\""],
        ),
        LAG: Number = key(
            "lag",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 3600.0 }),
            Is("10"),
            "Time constant of the tug's force and of its direction.",
            &["\"12 s\""],
        ),
    }
}
