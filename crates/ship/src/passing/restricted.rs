//! Factors for shallow water and quays on the forces of passing ships in deep, open water.

use crate::range::{OutOfRange, within};

/// The berth of the ship at rest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Berth {
    /// The berth is a jetty through which water flows.
    Open,
    /// The berth is a quay wall on the ship's far side. The factors 1.4, 0.4 and 0.5 of a quay are an estimate from the
    /// figures of Swiegers (2011).
    Quay,
}

/// Factors on surge, sway and yaw of [`super::force`] at a depth: by Kriebel's model tests (Mooring loads due to
/// parallel passing ships, 2005), as our design notes quote them; the paper was not read.
///
/// Each factor is 1 + a e^(bT/d) e^(−0.08 (G/B − g)²), where T/d is the draught of the ship at rest divided by the
/// depth, G/B the clear gap between the hulls divided by the mean of the beams, and (a, b, g) = (1.70, 2.92, 3), (0.52,
/// 4.33, 2), (0.48, 3.87, 2) for surge, sway and yaw.
///
/// # Errors
/// Fails for a draught that is not between 0 and 1 times the depth, or a gap below 0 or above 100 beams.
pub fn factors(
    draught_over_depth: f64,
    gap_over_beam: f64,
    berth: Berth,
) -> Result<[f64; 3], OutOfRange> {
    within("draught over depth", draught_over_depth, 0.0, 1.0)?;
    within("gap over mean beam", gap_over_beam, 0.0, 100.0)?;
    let of_depth = |[a, b, g]: [f64; 3]| {
        let off = gap_over_beam - g;
        1.0 + a * libm::exp(b * draught_over_depth) * libm::exp(-0.08 * off * off)
    };
    let [surge, sway, yaw] =
        [[1.70, 2.92, 3.0], [0.52, 4.33, 2.0], [0.48, 3.87, 2.0]].map(of_depth);
    let [of_surge, of_sway, of_yaw] = berth.factors();
    Ok([of_surge * surge, of_sway * sway, of_yaw * yaw])
}

impl Berth {
    /// Factors of the berth on a passing ship's surge and sway force and yaw moment, relative to an open berth.
    #[must_use]
    pub fn factors(self) -> [f64; 3] {
        match self {
            Berth::Open => [1.0; 3],
            Berth::Quay => [1.4, 0.4, 0.5],
        }
    }
}
