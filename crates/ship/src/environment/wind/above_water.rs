//! What the wind meets of a ship.

/// Length, beam and areas of a ship above the water, from which the methods find her wind coefficients. Each is as in
/// [`ShipWindage`](super::ShipWindage).
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
    /// Centroid of the lateral area forward of midship (m).
    pub(super) centroid_forward_m: f64,
    /// Centroid of the lateral area above the waterline (m).
    pub(super) centroid_height_m: f64,
}
