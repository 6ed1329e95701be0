//! Limits for the depths and the names that the features of a chart may have.

/// Smallest and largest depth that a chart may contain (m). Ground that falls dry has a negative depth.
pub(super) const DEPTHS_M: [f64; 2] = [-30.0, 12_000.0];

/// Longest name of a feature of a chart (bytes), as long as the longest name of a body.
pub(super) const LONGEST_NAME: usize = 200;
