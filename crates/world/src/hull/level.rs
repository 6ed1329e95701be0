//! One of the outlines of a hull that is given at several heights.

use fenderline_contact::Vec2;

/// An outline of a hull at one height.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Height of the outline (m): above the keel of a floating body, above datum for a fixed body.
    pub height_m: f64,
    /// Vertices of the outline in the body's frame, forward and to starboard of the centre of gravity (m).
    pub vertices_m: Vec<Vec2>,
}
