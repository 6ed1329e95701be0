//! The hydrodynamic data of a ship, as they are read.

use super::matrix::Matrix6;
use crate::environment::waves::Complex;

/// Hydrodynamic data about a reference point, as they are read. Motions and forces are surge, sway, heave *down*, roll to
/// starboard, pitch bow up, yaw to starboard.
#[derive(Clone, Debug, PartialEq)]
pub struct RawHydrodynamics {
    /// The reference point from the centre of gravity: forward, to starboard, up (m). The motions are those of
    /// the reference point, the moments are about the reference point, and phases are relative to the crest of the wave there.
    pub reference_m: [f64; 3],
    /// Rigid mass about the centre of gravity (kg, kg·m, kg·m²).
    pub mass: Matrix6,
    /// Restoring about the reference point, gravity included: heave, roll and pitch (N/m, N, N·m).
    pub restoring: [[f64; 3]; 3],
    /// Frequencies of the radiation (rad/s).
    pub frequencies_radps: Vec<f64>,
    /// Added mass at each.
    pub added_mass: Vec<Matrix6>,
    /// Damping at each.
    pub damping: Vec<Matrix6>,
    /// Added mass at infinite frequency.
    pub infinite: Matrix6,
    /// Frequencies of the excitation (rad/s).
    pub wave_frequencies_radps: Vec<f64>,
    /// Headings μ: the direction towards which a wave runs, clockwise from the bow (rad); from 0 to π for a ship and water that
    /// are alike to both sides, else all round.
    pub headings_rad: Vec<f64>,
    /// Exciting force in a wave of amplitude 1 m at each frequency and heading, the heading fastest.
    pub excitation: Vec<[Complex; 6]>,
    /// Mean drift over the square of the amplitude: surge, sway and yaw (N/m², N/m², N/m) on the same grid.
    pub drift: Option<Vec<[f64; 3]>>,
    /// Depth for which the data are (m); `None`: deep.
    pub depth_m: Option<f64>,
    /// Density of the water (kg/m³).
    pub water_kgpm3: f64,
}
