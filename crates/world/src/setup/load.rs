//! External loads of a set-up.

use fenderline_contact::Vec2;

/// An external load at a body's centre of gravity, earth-fixed. The load acts while `from_s ≤ t < until_s`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Load {
    /// Index into [`crate::setup::Setup::bodies`].
    pub body: usize,
    /// Force of the load, north and east (N).
    pub force_n: Vec2,
    /// Moment of the load about the vertical, positive to starboard (N·m).
    pub moment_nm: f64,
    /// Start of the load (s).
    pub from_s: f64,
    /// End of the load (s); infinite for a steady load.
    pub until_s: f64,
}
