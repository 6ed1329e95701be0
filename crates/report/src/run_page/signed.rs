//! Heights with their sign.

use crate::plot::fixed;

/// The text of a height with its sign.
pub(super) fn signed(height_m: f64) -> String {
    if height_m > 0.0 { format!("+{}", fixed(height_m, 2)) } else { fixed(height_m, 2) }
}
