//! Checks that the hydrodynamic data give energy to no combination of motions. The entries on the diagonals of the
//! damping may be right while the couplings are wrong.

use fenderline_contact::number::greater;

use super::error::{Part, Reason, SeakeepingError, error};
use super::matrix::{Matrix6, Six, smallest_eigenvalue};

/// How far below zero the damping of a combination of motions may be, divided by the maxima of the single motions. A
/// negative damping below the first value is numerical noise; the data of this repository have up to 0.4 %. A negative
/// damping above the second value is refused.
const NOISE: [f64; 2] = [0.01, 0.05];

/// The identity matrix. The identity matrix, over which a part of a matrix that is scaled to ones on its diagonal may
/// be written.
pub(super) fn scaled_to_one() -> Matrix6 {
    std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)))
}

/// The two motions with the largest part in the eigenvector of the smallest eigenvalue, if this eigenvalue is not
/// positive. The matrix must have ones on its diagonal.
pub(super) fn negative_together(matrix: &Matrix6) -> Option<[usize; 2]> {
    let (value, vector) = smallest_eigenvalue(matrix);
    (value <= 0.0).then(|| largest_two(&vector))
}

/// Checks mass plus added mass at infinite frequency, for all motions together.
///
/// # Errors
/// [`Reason::NoMass`], [`Reason::CouplesTooMuch`].
pub(super) fn check_total_mass(total: &Matrix6) -> Result<(), SeakeepingError> {
    let of_table = |reason| Err(error(Part::Infinite, Some(0), reason));
    if let Some(motion) = (0..6).find(|&k| total[k][k] <= 0.0) {
        return of_table(Reason::NoMass { motion });
    }
    let scaled = std::array::from_fn(|i| {
        std::array::from_fn(|j| total[i][j] / (total[i][i] * total[j][j]).sqrt())
    });
    match negative_together(&scaled) {
        Some(motions) => of_table(Reason::CouplesTooMuch { what: "mass", motions }),
        None => Ok(()),
    }
}

/// Checks the damping of all motions together at each frequency. A negative damping a little above noise is reported as
/// a doubt only, because the memory of the water is made passive.
///
/// # Errors
/// [`Reason::NegativeTogether`].
pub(super) fn check_damping(
    damping: &[Matrix6],
) -> Result<Option<SeakeepingError>, SeakeepingError> {
    let most: Six =
        std::array::from_fn(|k| damping.iter().map(|matrix| matrix[k][k]).fold(0.0, greater));
    let scale = most.map(|most| if most > 0.0 { 1.0 / most.sqrt() } else { 0.0 });
    let mut worst: Option<(f64, SeakeepingError)> = None;
    for (row, matrix) in damping.iter().enumerate() {
        let scaled: Matrix6 =
            std::array::from_fn(|i| std::array::from_fn(|j| matrix[i][j] * scale[i] * scale[j]));
        let (share, vector) = smallest_eigenvalue(&scaled);
        if share < -NOISE[0] && worst.as_ref().is_none_or(|(least, _)| share < *least) {
            let reason = Reason::NegativeTogether { motions: largest_two(&vector), share };
            worst = Some((share, error(Part::Radiation, Some(row), reason)));
        }
    }
    match worst {
        Some((share, error)) if share < -NOISE[1] => Err(error),
        worst => Ok(worst.map(|(_, error)| error)),
    }
}

/// Indices of the two largest entries of a vector, the lower index first.
fn largest_two(vector: &Six) -> [usize; 2] {
    let mut order = [0, 1, 2, 3, 4, 5];
    order.sort_by(|a, b| vector[*b].abs().total_cmp(&vector[*a].abs()));
    [order[0].min(order[1]), order[0].max(order[1])]
}
