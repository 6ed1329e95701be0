//! A linear mapping from metres to pixels.

use fenderline_contact::number::greater;

/// Smallest extent that is mapped (m).
const LEAST_M: f64 = 1e-3;

/// The mapping from metres to pixels along one axis of a drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    low_m: f64,
    /// Where `low_m` lies (px).
    at_px: f64,
    /// Pixels for each metre; negative if metres grow upwards.
    pub(super) px_per_m: f64,
}

impl Scale {
    /// Makes the scale that maps a range of metres onto the pixels from `from_px` to `to_px`.
    pub(super) fn new([low_m, high_m]: [f64; 2], from_px: f64, to_px: f64) -> Scale {
        let px_per_m = (to_px - from_px) / greater(high_m - low_m, LEAST_M);
        Scale { low_m, at_px: from_px, px_per_m }
    }

    pub(super) fn px(&self, at_m: f64) -> f64 {
        self.at_px + (at_m - self.low_m) * self.px_per_m
    }

    /// The length in pixels of a length in metres, never negative.
    pub(super) fn length(&self, length_m: f64) -> f64 {
        (length_m * self.px_per_m).abs()
    }
}
