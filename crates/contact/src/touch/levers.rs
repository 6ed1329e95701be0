//! The levers of a contact force about a body.

use crate::maths::vec2::Vec2;

/// The levers of the normal n and the tangent t about a body's centre of gravity: r × n and r × t (m).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Levers {
    pub(crate) n_m: f64,
    pub(crate) t_m: f64,
}

impl Levers {
    /// The lever of t is computed without t, because r × t = r·n.
    #[inline]
    pub(crate) fn new(arm_m: Vec2, normal: Vec2) -> Levers {
        Levers { n_m: arm_m.cross(normal), t_m: arm_m.dot(normal) }
    }
}
