//! The hydrodynamic data of a ship about her centre of gravity.

use fenderline_contact::Vec2;

use super::error::SeakeepingError;
use super::matrix::{Matrix6, plus, smallest_eigenvalue};
use fenderline_ship::environment::waves::Complex;

/// Hydrodynamic data of a ship about her centre of gravity.
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
    /// Point from which the phases of wave forces are counted, forward and to starboard of the centre of gravity (m).
    pub(super) origin_m: Vec2,
    /// True if the headings go from 0 to π only, so that waves from starboard are the mirror image.
    pub(super) is_mirrored: bool,
    pub(super) doubts: Vec<SeakeepingError>,
}

impl Hydrodynamics {
    /// Rigid mass plus the added mass [`Hydrodynamics::infinite`], about the centre of gravity.
    #[must_use]
    pub fn total_mass(&self) -> Matrix6 {
        plus(&self.mass, 1.0, &self.infinite)
    }

    /// What is odd about the data but does no harm: a small negative damping, or added mass and damping that contradict
    /// each other by 25 to 40 % of the largest added mass. Data with a larger contradiction are refused.
    #[must_use]
    pub fn doubts(&self) -> &[SeakeepingError] {
        &self.doubts
    }

    /// True if steps of the given length (s) can follow the ship's own motions in heave, roll and pitch: h²C < 6M, the
    /// limit of [`super::Motion`]. With longer steps every motion would grow without limit.
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

    /// Rigid mass of the ship about her centre of gravity.
    #[must_use]
    pub fn rigid_mass(&self) -> &Matrix6 {
        &self.mass
    }

    /// Whether two motions of the ship are coupled by the radiation of waves.
    pub(super) fn is_coupled(&self, i: usize, j: usize) -> bool {
        self.damping.iter().any(|matrix| matrix[i][j] != 0.0)
    }

    /// Added mass about the centre of gravity at infinite frequency: what the water answers at once, faster than the
    /// frequencies of the data.
    #[must_use]
    pub fn infinite(&self) -> &Matrix6 {
        &self.infinite
    }

    /// Rigid mass (kg).
    #[must_use]
    pub fn mass_kg(&self) -> f64 {
        self.mass[0][0]
    }

    /// Hydrostatic restoring matrix about the centre of gravity.
    #[must_use]
    pub fn restoring(&self) -> &Matrix6 {
        &self.restoring
    }

    /// Depth of water for which the data hold (m); `None`: deep.
    #[must_use]
    pub fn depth_m(&self) -> Option<f64> {
        self.depth_m
    }

    /// True if the data have mean drift forces.
    #[must_use]
    pub fn has_drift(&self) -> bool {
        self.drift.is_some()
    }

    /// The first and the last frequency of the exciting forces (rad/s); beyond them the forces are held constant.
    #[must_use]
    pub fn wave_range_radps(&self) -> [f64; 2] {
        let axis = &self.wave_frequencies_radps;
        [axis[0], axis[axis.len() - 1]]
    }

    /// The frequencies at which the data have radiation (rad/s), with added mass and damping at each.
    pub fn radiation(&self) -> impl Iterator<Item = (f64, &Matrix6, &Matrix6)> {
        let matrices = self.added_mass.iter().zip(&self.damping);
        self.frequencies_radps.iter().copied().zip(matrices).map(|(w, (a, b))| (w, a, b))
    }
}
