//! Mean drift force.

use super::GRAVITY_MPS2;
use super::sea::Sea;
use crate::range::{OutOfRange, within};

/// A hull that waves drift away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DriftHull {
    /// Length on the waterline [m].
    pub length_m: f64,
    /// Beam [m].
    pub beam_m: f64,
    /// Length of the bow on the waterline, from its stem to 95 % of the beam [m].
    pub bow_length_m: f64,
}

impl DriftHull {
    /// Checks every number.
    ///
    /// # Errors
    /// The first that no ship has, by its name.
    pub fn check(&self) -> Result<(), OutOfRange> {
        within("length on the waterline [m]", self.length_m, 0.1, 2000.0)?;
        within("beam [m]", self.beam_m, 0.05, 500.0)?;
        within("length of the bow on the waterline [m]", self.bow_length_m, 0.01, 1000.0)?;
        Ok(())
    }
}

/// Mean force of a sea on a hull at rest, [X, Y, N] in [N, N, N·m], unvalidated: Y = ρgHs²L/16·sin μ|sin μ|,
/// a wall that turns all waves back (design sheet §4, recalled), and X = ρgHs²B√(B/L_bow)/16·cos μ|cos μ|,
/// STAWAVE-1 (ISO 15016; a public page says what it needs, the formula is recalled; made for head seas, the
/// spread over the angle is ours). Both are for waves much shorter than the ship; in long waves the ship
/// moves with them and drifts less. N is not estimated: zero.
#[must_use]
pub fn mean_drift(
    sea: &Sea,
    hull: &DriftHull,
    heading_rad: f64,
    water_density_kgpm3: f64,
) -> [f64; 3] {
    let direction_rad = sea.towards_rad() - heading_rad;
    let (sin, cos) = (libm::sin(direction_rad), libm::cos(direction_rad));
    // ρgHs²/16 = ρg·m₀, Hs = 4√m₀.
    let pressure_npm = water_density_kgpm3 * GRAVITY_MPS2 * sea.variance_m2();
    let bow = hull.beam_m * (hull.beam_m / hull.bow_length_m).sqrt();
    [pressure_npm * bow * cos * cos.abs(), pressure_npm * hull.length_m * sin * sin.abs(), 0.0]
}
