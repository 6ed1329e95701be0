//! The part of a ship above the water, on which the wind acts.

/// Length, beam and areas of a ship above the water, from which the wind methods find her wind coefficients. Length,
/// beam and areas are defined as in [`ShipWindage`](super::ShipWindage).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct AboveWater {
    /// Length overall (m).
    pub(super) length_m: f64,
    /// Beam (m).
    pub(super) beam_m: f64,
    /// Frontal projected area (m²).
    pub(super) frontal_m2: f64,
    /// Lateral projected area (m²).
    pub(super) lateral_m2: f64,
    /// Distance of the lateral area's centroid forward of midship (m).
    pub(super) centroid_forward_m: f64,
    /// Height of the lateral area's centroid above the waterline (m).
    pub(super) centroid_height_m: f64,
}
