//! One outline of a hull by height.

use fenderline_contact::Vec2;

/// An outline at a height.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Height (m): above the keel of a floating body, above datum of a fixed one.
    pub height_m: f64,
    /// Vertices in the body's frame, forward and to starboard of the centre of gravity (m).
    pub vertices_m: Vec<Vec2>,
}
