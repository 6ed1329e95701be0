//! Keys of tugs.

use super::quantities::{FORCE, LENGTH, PLACE};
use crate::held::{Name, Number, Vector};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static TUG: TableSpec = TableSpec {
    what: "a tug",
    doc: "A tug that is only a force at a point of a vessel, without a hull of her own. The \
          largest force of the tug falls with her speed through the water, by a law that we \
          derived and that is not validated. For a tug that pushes through her bow fender, use a \
          vessel with azimuth units and the orders `push_ship`, `pull_ship` and `follow_ship`.",
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
            "Point of the vessel at which the tug pushes: distances forward and to starboard of \
             midship.",
            &["[90, -23]"],
        ),
        PULL_AT: Vector = key(
            "pull_at",
            Kind::Point(PLACE),
            Means("the point at which the tug pushes"),
            "Place of the vessel's fairlead for the tug's line: distances forward and to starboard \
             of midship.",
            &["[140, 0]"],
        ),
        ABOVE_WATER: Number = key(
            "above_water",
            Kind::Quantity(PLACE),
            Is("2"),
            "Height above the still water at which the tug pushes, and height of the fairlead of \
             the tug's line. A vessel with `hydrodynamics` heels and trims under the force at this \
             height, and the point moves with the vessel. The default of 2 m is assumed.",
            &["\"4 m\""],
        ),
        LENGTH: Number = key(
            "length",
            Kind::Quantity(LENGTH),
            Is("32"),
            "Length of the tug.",
            &["\"32 m\""],
        ),
        BEAM: Number = key(
            "beam",
            Kind::Quantity(LENGTH),
            Is("13"),
            "Beam of the tug.",
            &["\"13 m\""],
        ),
        DRAUGHT: Number = key(
            "draught",
            Kind::Quantity(LENGTH),
            Is("4.5"),
            "Draught of the tug.",
            &["\"4.5 m\""],
        ),
        DELAY: Number = key(
            "delay",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 3600.0 }),
            Is("5"),
            "Time from an order to the tug until she begins to carry out the order.",
            &["\"5 s\""],
        ),
        LAG: Number = key(
            "lag",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 3600.0 }),
            Is("10"),
            "Time constant with which the tug's force and its direction follow an order.",
            &["\"12 s\""],
        ),
    }
}
