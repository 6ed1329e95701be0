//! Bounds of what a feature of a chart may hold.

/// Depths that a chart may have (m): heights that fall dry are negative.
pub(super) const DEPTHS_M: [f64; 2] = [-30.0, 12_000.0];

/// Longest name (bytes), the same as for a body.
pub(super) const LONGEST_NAME: usize = 200;
