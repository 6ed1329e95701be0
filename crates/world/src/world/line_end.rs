//! Where the far end of a line may be.

use fenderline_contact::Vec2;

/// The far end of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineEnd {
    /// A bollard or an anchor: north, east and above datum (m).
    Fixed([f64; 3]),
    /// A point on another body, which may be a quay.
    OnBody {
        /// Index into [`crate::setup::Setup::bodies`].
        body: usize,
        /// Position in the body's frame (m).
        at_m: Vec2,
        /// Height above the still water (m); above datum where the body is fixed.
        above_water_m: f64,
    },
}
