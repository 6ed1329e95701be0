//! Two numbers, mostly north and east, as messages have them.

use fenderline_contact::Vec2;

/// A position, a vector or a range.
pub type Pair = [f64; 2];

pub(crate) fn pair(of: Vec2) -> Pair {
    [of.x, of.y]
}
