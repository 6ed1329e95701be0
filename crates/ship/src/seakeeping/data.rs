//! The hydrodynamic data of a ship about her centre of gravity.

use fenderline_contact::Vec2;

use super::error::SeakeepingError;
use super::matrix::{Matrix6, plus, smallest_eigenvalue};
use crate::environment::waves::Complex;

/// Hydrodynamic data about the centre of gravity.
#[derive(Clone, Debug, PartialEq)]
pub struct Hydrodynamics {
    pub(super) mass: Matrix6,
    pub(super) restoring: Matrix6,
    pub(super) frequencies_radps: Vec<f64>,
    pub(super) added_mass: Vec<Matrix6>,
    pub(super) damping: Vec<Matrix6>,
    pub(super) infinite: Matrix6,
    pub(super) wave_frequencies_radps: Vec<f64>,
    pub(super) headings_rad: Vec<f64>,
    pub(super) excitation: Vec<[Complex; 6]>,
    pub(super) drift: Option<Vec<[f64; 3]>>,
    pub(super) depth_m: Option<f64>,
    /// Where phases are counted from, forward and to starboard of the centre of gravity (m).
    pub(super) origin_m: Vec2,
    /// Headings from 0 to π: waves from starboard are the mirror image.
    pub(super) is_mirrored: bool,
    pub(super) doubts: Vec<SeakeepingError>,
}

impl Hydrodynamics {
    /// Mass with [`Hydrodynamics::infinite`] about the centre of gravity.
    #[must_use]
    pub fn total_mass(&self) -> Matrix6 {
        plus(&self.mass, 1.0, &self.infinite)
    }

    /// What is odd about the data, and does no harm: a small negative damping, or added mass and damping that contradict each other by
    /// half of what is refused.
    #[must_use]
    pub fn doubts(&self) -> &[SeakeepingError] {
        &self.doubts
    }

    /// True if a step of this length (s) can follow her own motions in heave, roll and pitch: h²C < 6M, the bound of
    /// [`super::Motion`]. Beyond it every motion would grow without bound.
    #[must_use]
    pub fn is_resolved_by(&self, step_s: f64) -> bool {
        let mass = self.total_mass();
        let margin: Matrix6 = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let left = 6.0 * mass[i][j] - step_s * step_s * self.restoring[i][j];
                left / (mass[i][i] * mass[j][j]).sqrt()
            })
        });
        smallest_eigenvalue(&margin).0 > 0.0
    }

    /// The highest frequency of the data (rad/s).
    #[must_use]
    pub fn last_frequency_radps(&self) -> f64 {
        self.frequencies_radps.last().copied().unwrap_or(0.0)
    }

    /// Rigid mass about the centre of gravity.
    #[must_use]
    pub fn rigid_mass(&self) -> &Matrix6 {
        &self.mass
    }

    /// Whether two motions are coupled by radiation.
    pub(super) fn is_coupled(&self, i: usize, j: usize) -> bool {
        self.damping.iter().any(|matrix| matrix[i][j] != 0.0)
    }

    /// The added mass about the centre of gravity of what the water answers at once: faster than the frequencies of the data.
    #[must_use]
    pub fn infinite(&self) -> &Matrix6 {
        &self.infinite
    }

    /// Rigid mass (kg).
    #[must_use]
    pub fn mass_kg(&self) -> f64 {
        self.mass[0][0]
    }

    /// Restoring about the centre of gravity.
    #[must_use]
    pub fn restoring(&self) -> &Matrix6 {
        &self.restoring
    }

    /// Depth for which the data are (m); `None`: deep.
    #[must_use]
    pub fn depth_m(&self) -> Option<f64> {
        self.depth_m
    }

    /// True if the data have mean drift forces.
    #[must_use]
    pub fn has_drift(&self) -> bool {
        self.drift.is_some()
    }

    /// The first and the last frequency of the exciting forces (rad/s), which are held there beyond them.
    #[must_use]
    pub fn wave_range_radps(&self) -> [f64; 2] {
        let axis = &self.wave_frequencies_radps;
        [axis[0], axis[axis.len() - 1]]
    }

    /// The frequencies of the radiation (rad/s), with added mass and damping at each.
    pub fn radiation(&self) -> impl Iterator<Item = (f64, &Matrix6, &Matrix6)> {
        let matrices = self.added_mass.iter().zip(&self.damping);
        self.frequencies_radps.iter().copied().zip(matrices).map(|(w, (a, b))| (w, a, b))
    }
}
