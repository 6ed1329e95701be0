//! Hydrodynamic data, checked and moved to the centre of gravity.

use fenderline_contact::number::greater;
use fenderline_contact::vec2;

use super::check::{check_axes, check_head, check_headings, check_matrices, check_shape};
use super::data::Hydrodynamics;
use super::error::{Part, Reason, SeakeepingError};
use super::matrix::{Matrix6, ZERO, congruent, plus, transposed};
use super::passive::{check_damping, check_total_mass};
use super::raw::RawHydrodynamics;
use super::retardation::{Retardation, effective_infinite};
use super::waves_check::check_forces;
use fenderline_ship::environment::waves::Complex;

/// Largest contradiction allowed between added mass and damping, divided by the largest added mass.
const CONTRADICTION: f64 = 0.4;
/// Smallest contradiction between added mass and damping that is reported, divided by the largest added mass.
const DOUBTFUL: f64 = 0.25;

impl Hydrodynamics {
    /// Checks hydrodynamic data and moves them to the centre of gravity.
    ///
    /// # Errors
    /// Fails with a [`SeakeepingError`] that has table, row and reason.
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
        // The matrix in the file is checked too. The effective matrix takes a median for couplings without damping, which hides a wrong unit.
        check_total_mass(&plus(&data.mass, 1.0, &given))?;
        check_total_mass(&data.total_mass())?;
        Ok(data)
    }

    /// The ship's retardation function.
    #[must_use]
    pub fn retardation(&self) -> Retardation {
        Retardation::new(self)
    }

    /// Checks Ogilvie's relations. By Ogilvie's relations, the added mass must follow from the damping, apart from a
    /// constant. The constant in Ogilvie's relation must be near the added mass at infinite frequency.
    fn check_consistency(
        &mut self,
        retardation: &Retardation,
        given: &Matrix6,
    ) -> Result<(), SeakeepingError> {
        for motion in 0..6 {
            let of = |matrix: &Matrix6| matrix[motion][motion];
            let largest =
                self.added_mass.iter().map(of).map(f64::abs).fold(of(given).abs(), greater);
            // Values that are small beside the ship's own mass need not be consistent.
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

/// The matrix that gives the motion of a point of the ship from the motion of her centre of gravity. The given
/// distances say how far the point lies forward of, to starboard of and above the centre of gravity (m).
fn lever([forward_m, starboard_m, up_m]: [f64; 3]) -> Matrix6 {
    let mut matrix: Matrix6 = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
    // θ × r with r = (forward, starboard, −up).
    (matrix[0][4], matrix[0][5]) = (-up_m, -starboard_m);
    (matrix[1][3], matrix[1][5]) = (up_m, forward_m);
    (matrix[2][3], matrix[2][4]) = (starboard_m, -forward_m);
    matrix
}

/// The symmetric part ½(A + Aᵀ) of a matrix A.
fn symmetric(matrix: &Matrix6) -> Matrix6 {
    let sum = plus(matrix, 1.0, &transposed(matrix));
    sum.map(|row| row.map(|entry| 0.5 * entry))
}
