//! Where the far end of a line may be.

use fenderline_contact::Vec2;

/// The far end of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineEnd {
    /// A bollard or an anchor, with its position north, east and above datum (m).
    Fixed([f64; 3]),
    /// A point on another body, for example on a quay.
    OnBody {
        /// Index into [`crate::setup::Setup::bodies`].
        body: usize,
        /// Position of the point in the body's frame (m).
        at_m: Vec2,
        /// Height of the point above the still water (m), or above datum if the body is fixed.
        above_water_m: f64,
    },
}
