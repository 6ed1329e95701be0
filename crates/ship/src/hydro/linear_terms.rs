//! The linear terms of a hull.

/// The linear terms of the hull force over v' and r', without added mass. They have this one convention whether the
/// hull's polynomial is over v' and r' or over β and r'.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LinearTerms {
    /// X'₀, negative.
    pub ahead: f64,
    /// X'vr.
    pub surge_vr: f64,
    /// Y'v.
    pub sway_v: f64,
    /// Y'r.
    pub sway_r: f64,
    /// N'v.
    pub yaw_v: f64,
    /// N'r.
    pub yaw_r: f64,
}
