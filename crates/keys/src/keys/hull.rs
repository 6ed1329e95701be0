//! Keys of a hull whose outline is given at several heights.

use super::quantities::POSITION;
use crate::held::{Number, Points};
use crate::spec::Absent::Refused;
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static OUTLINE_AT_HEIGHT: TableSpec = TableSpec {
    what: "an outline at a height",
    doc: "A body's outline at one height, such as a waterline of a lines plan. Between two \
        outlines the hull's side is straight, from each vertex of one outline to the same vertex \
        of the next outline. If the outlines of a hull have different numbers of vertices, the \
        program resamples the outlines at common stations from stern to bow.",
    keys: OutlineAtHeightKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of an outline at a height.
    pub OutlineAtHeightKey {
        HEIGHT: Number = key(
            "height",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: -200.0, high: 200.0 }),
            Refused,
            "Height of the outline above the keel of a floating body, or above datum on a fixed \
             body. The outlines of a hull must be listed with rising heights.",
            &["\"4 m\""],
        ),
        OUTLINE: Points = key(
            "outline",
            Kind::Outline(POSITION),
            Refused,
            "Vertices of the outline, forward and to starboard of the centre of gravity; each \
             outline of the hull must begin with the same vertex.",
            &["[[-16, -6.5], [16, -6.5], [16, 6.5], [-16, 6.5]]"],
        ),
    }
}
