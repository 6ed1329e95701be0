//! The hydrodynamic data of a ship, as they are read from a file.

use super::matrix::Matrix6;
use fenderline_ship::environment::waves::Complex;

/// Hydrodynamic data of a ship about a reference point, as they are read from a file. The motions and forces of the
/// data are surge, sway, heave *down*, roll to starboard, pitch bow up, yaw to starboard.
#[derive(Clone, Debug, PartialEq)]
pub struct RawHydrodynamics {
    /// Place of the reference point relative to the centre of gravity: forward, to starboard, up (m). The motions of
    /// the data are those of the reference point, the moments are about it, and phases are relative to the crest of the
    /// wave at this point.
    pub reference_m: [f64; 3],
    /// Rigid mass matrix about the centre of gravity (kg, kg·m, kg·m²).
    pub mass: Matrix6,
    /// Restoring matrix of heave, roll and pitch about the reference point, gravity included (N/m, N, N·m).
    pub restoring: [[f64; 3]; 3],
    /// Frequencies of the radiation data (rad/s).
    pub frequencies_radps: Vec<f64>,
    /// Added mass at each.
    pub added_mass: Vec<Matrix6>,
    /// Damping at each.
    pub damping: Vec<Matrix6>,
    /// Added mass of the ship at infinite frequency.
    pub infinite: Matrix6,
    /// Frequencies of the exciting forces (rad/s).
    pub wave_frequencies_radps: Vec<f64>,
    /// Headings μ of the data: directions towards which waves run, clockwise from the bow (rad); from 0 to π for a ship
    /// and water that are alike to both sides, else all round.
    pub headings_rad: Vec<f64>,
    /// Exciting force in a wave of amplitude 1 m at each frequency and heading; the index of heading varies fastest.
    pub excitation: Vec<[Complex; 6]>,
    /// Mean drift divided by the square of the amplitude: surge, sway and yaw (N/m², N/m², N/m) at the same frequencies
    /// and headings as the exciting forces.
    pub drift: Option<Vec<[f64; 3]>>,
    /// Depth of water for which the data hold (m); `None`: deep.
    pub depth_m: Option<f64>,
    /// Density of the water for which the data hold (kg/m³).
    pub water_kgpm3: f64,
}
