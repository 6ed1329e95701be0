//! Turns vectors between a body's own axes and earth-fixed axes.

use fenderline_contact::{BodyState, Rotation, Vec2, vec2};

/// Turns a vector from a body's axes to earth-fixed axes.
pub(crate) fn earth_fixed(state: &BodyState, own: Vec2) -> Vec2 {
    Rotation::from_angle(state.heading_rad).apply(own)
}

/// Turns an earth-fixed vector to a body's axes.
pub(crate) fn body_fixed(state: &BodyState, vector: Vec2) -> Vec2 {
    let own = Rotation::from_angle(state.heading_rad).apply_inverse(vector);
    vec2(own.x, own.y)
}
