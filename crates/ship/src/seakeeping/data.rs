//! The hydrodynamic data of a ship, checked.

use fenderline_contact::number::greater;
use fenderline_contact::{Vec2, vec2};

use super::check::{check_axes, check_head, check_headings, check_matrices, check_shape};
use super::error::{Part, Reason, SeakeepingError};
use super::matrix::{Matrix6, ZERO, congruent, plus, smallest_eigenvalue, transposed};
use super::passive::{check_damping, check_total_mass};
use super::retardation::{Retardation, effective_infinite};
use super::waves_check::check_forces;
use crate::environment::waves::Complex;

/// The most that added mass and damping may contradict each other, over the largest added mass.
const CONTRADICTION: f64 = 0.4;
/// From where on that is said.
const DOUBTFUL: f64 = 0.25;

/// Hydrodynamic data about a reference point, as they are read. Motions and forces are surge, sway, heave *down*, roll to
/// starboard, pitch bow up, yaw to starboard.
#[derive(Clone, Debug, PartialEq)]
pub struct RawHydrodynamics {
    /// The reference point from the centre of gravity: forward, to starboard, up (m). Motions are of this point, moments about
    /// it, and phases are to the crest at it.
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
    doubts: Vec<SeakeepingError>,
}

impl Hydrodynamics {
    /// Checks data and moves them to the centre of gravity.
    ///
    /// # Errors
    /// [`SeakeepingError`], with table, row and reason.
    pub fn new(raw: RawHydrodynamics) -> Result<Hydrodynamics, SeakeepingError> {
        check_shape(&raw)?;
        check_head(&raw)?;
        check_matrices(&raw)?;
        check_axes(&raw)?;
        let is_mirrored = check_headings(&raw.headings_rad)?;
        check_forces(&raw, is_mirrored)?;
        let doubts = check_damping(&raw.damping)?.into_iter().collect();
        let to_reference = lever(raw.reference_m);
        let moved = |matrix: &Matrix6| congruent(&symmetric(matrix), &to_reference);
        let mut restoring = ZERO;
        for (row, of_row) in raw.restoring.iter().enumerate() {
            restoring[2 + row][2..5].copy_from_slice(of_row);
        }
        let forces = transposed(&to_reference);
        let to_gravity = |at: &[Complex; 6]| -> [Complex; 6] {
            std::array::from_fn(|row| {
                let parts = forces[row].iter().zip(at).map(|(factor, part)| *part * *factor);
                parts.fold(Complex::default(), |sum, part| sum + part)
            })
        };
        let [forward_m, starboard_m, _] = raw.reference_m;
        let mut data = Hydrodynamics {
            mass: raw.mass,
            restoring: moved(&restoring),
            added_mass: raw.added_mass.iter().map(moved).collect(),
            damping: raw.damping.iter().map(moved).collect(),
            infinite: moved(&raw.infinite),
            frequencies_radps: raw.frequencies_radps,
            wave_frequencies_radps: raw.wave_frequencies_radps,
            headings_rad: raw.headings_rad,
            excitation: raw.excitation.iter().map(to_gravity).collect(),
            drift: raw.drift.map(|all| {
                let about = |[x, y, n]: [f64; 3]| [x, y, n + forward_m * y - starboard_m * x];
                all.into_iter().map(about).collect()
            }),
            depth_m: raw.depth_m,
            origin_m: vec2(forward_m, starboard_m),
            is_mirrored,
            doubts,
        };
        let retardation = data.retardation();
        let effective = effective_infinite(&data, &retardation);
        let given = core::mem::replace(&mut data.infinite, effective);
        data.check_consistency(&retardation, &given)?;
        // Of the matrix that the file gives too: an effective one of couplings without damping is a median, which hides a wrong unit.
        check_total_mass(&plus(&data.mass, 1.0, &given))?;
        check_total_mass(&data.total_mass())?;
        Ok(data)
    }

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

    /// Her retardation function.
    #[must_use]
    pub fn retardation(&self) -> Retardation {
        Retardation::new(self)
    }

    /// Ogilvie's relations: the added mass must follow from the damping, but for a constant, and the constant must be near the added
    /// mass at infinite frequency.
    fn check_consistency(
        &mut self,
        retardation: &Retardation,
        given: &Matrix6,
    ) -> Result<(), SeakeepingError> {
        for motion in 0..6 {
            let of = |matrix: &Matrix6| matrix[motion][motion];
            let largest =
                self.added_mass.iter().map(of).map(f64::abs).fold(of(given).abs(), greater);
            // What a mass of the ship's own size does not notice need not be consistent.
            let scale = greater(largest, 0.2 * self.mass[motion][motion]);
            let mut worst = (of(given) - of(&self.infinite)).abs() / scale;
            for (w, added, _) in self.radiation() {
                let by_damping =
                    of(&self.infinite) + retardation.added_mass_change(motion, motion, w);
                worst = greater(worst, (by_damping - of(added)).abs() / scale);
            }
            if worst > CONTRADICTION {
                let reason = Reason::Inconsistent { motion, share: worst };
                return Err(SeakeepingError { part: Part::Infinite, row: Some(0), reason });
            }
            if worst > DOUBTFUL {
                let reason = Reason::Inconsistent { motion, share: worst };
                self.doubts.push(SeakeepingError { part: Part::Infinite, row: Some(0), reason });
            }
        }
        Ok(())
    }
}

/// The motions in the plane, among the six.
pub(super) const PLANE: [usize; 3] = [0, 1, 5];
/// Heave, roll and pitch, among the six.
pub(super) const UPRIGHT: [usize; 3] = [2, 3, 4];

/// The motion of a point of the ship by that of her centre of gravity. The point is forward, to starboard and up of it (m).
fn lever([forward_m, starboard_m, up_m]: [f64; 3]) -> Matrix6 {
    let mut matrix: Matrix6 = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
    // θ × r with r = (forward, starboard, −up).
    (matrix[0][4], matrix[0][5]) = (-up_m, -starboard_m);
    (matrix[1][3], matrix[1][5]) = (up_m, forward_m);
    (matrix[2][3], matrix[2][4]) = (starboard_m, -forward_m);
    matrix
}

/// ½(A + Aᵀ).
fn symmetric(matrix: &Matrix6) -> Matrix6 {
    let sum = plus(matrix, 1.0, &transposed(matrix));
    sum.map(|row| row.map(|entry| 0.5 * entry))
}
