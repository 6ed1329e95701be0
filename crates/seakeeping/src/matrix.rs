//! Matrices of six by six over the motions surge, sway, heave, roll, pitch and yaw.

/// A motion or a force in six components: surge, sway, heave (down), roll to starboard, pitch bow up, yaw to starboard.
pub type Six = [f64; 6];
/// A matrix over the six motions of a ship.
pub type Matrix6 = [[f64; 6]; 6];

/// Indices of the three motions in the horizontal plane (surge, sway, yaw), among the six.
pub(super) const PLANE: [usize; 3] = [0, 1, 5];
/// Indices of heave, roll and pitch, among the six motions.
pub(super) const UPRIGHT: [usize; 3] = [2, 3, 4];

/// The zero matrix.
pub const ZERO: Matrix6 = [[0.0; 6]; 6];

/// The product A · v of a matrix and a vector.
#[must_use]
pub fn times(matrix: &Matrix6, vector: &Six) -> Six {
    std::array::from_fn(|row| dot(&matrix[row], vector))
}

/// The scalar product Σ aᵢ bᵢ.
#[must_use]
pub fn dot(one: &Six, other: &Six) -> f64 {
    one.iter().zip(other).map(|(a, b)| a * b).sum()
}

/// The sum A + s · B of two matrices.
#[must_use]
pub fn plus(one: &Matrix6, factor: f64, other: &Matrix6) -> Matrix6 {
    std::array::from_fn(|i| std::array::from_fn(|j| one[i][j] + factor * other[i][j]))
}

/// The product Tᵀ A T of matrices.
#[must_use]
pub fn congruent(matrix: &Matrix6, by: &Matrix6) -> Matrix6 {
    let product = |a: &Matrix6, b: &Matrix6| -> Matrix6 {
        std::array::from_fn(|i| std::array::from_fn(|j| (0..6).map(|k| a[i][k] * b[k][j]).sum()))
    };
    product(&transposed(by), &product(matrix, by))
}

/// The transposed matrix Aᵀ.
#[must_use]
pub fn transposed(matrix: &Matrix6) -> Matrix6 {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[j][i]))
}

/// Solves A x = b for `N` unknowns, by elimination with pivots; `None` if A is singular.
#[must_use]
pub fn solve<const N: usize>(matrix: &[[f64; N]; N], right: &[f64; N]) -> Option<[f64; N]> {
    let (mut a, mut b) = (*matrix, *right);
    for column in 0..N {
        let pivot = (column..N).fold(column, |best, row| {
            if a[row][column].abs() > a[best][column].abs() { row } else { best }
        });
        if a[pivot][column] == 0.0 || !a[pivot][column].is_finite() {
            return None;
        }
        a.swap(column, pivot);
        b.swap(column, pivot);
        for row in column + 1..N {
            let factor = a[row][column] / a[column][column];
            let (upper, lower) = a.split_at_mut(row);
            for (own, of_pivot) in lower[0][column..].iter_mut().zip(&upper[column][column..]) {
                *own -= factor * of_pivot;
            }
            b[row] -= factor * b[column];
        }
    }
    for row in (0..N).rev() {
        let known: f64 = (row + 1..N).map(|k| a[row][k] * b[k]).sum();
        b[row] = (b[row] - known) / a[row][row];
    }
    Some(b)
}

/// The smallest eigenvalue of a symmetric matrix and its unit vector, by Jacobi's rotations.
#[must_use]
pub fn smallest_eigenvalue(matrix: &Matrix6) -> (f64, Six) {
    let mut a = *matrix;
    let mut vectors: Matrix6 = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
    for _ in 0..30 {
        let off: f64 =
            (0..6).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| a[i][j] * a[i][j]).sum();
        let on: f64 = (0..6).map(|i| a[i][i] * a[i][i]).sum();
        if off <= 1e-30 * on || off == 0.0 {
            break;
        }
        for p in 0..5 {
            for q in p + 1..6 {
                rotate(&mut a, &mut vectors, p, q);
            }
        }
    }
    let least = (1..6).fold(0, |best, i| if a[i][i] < a[best][best] { i } else { best });
    (a[least][least], std::array::from_fn(|i| vectors[i][least]))
}

/// Makes one rotation of Jacobi, which turns the entry (p, q) of the matrix to zero.
fn rotate(a: &mut Matrix6, vectors: &mut Matrix6, p: usize, q: usize) {
    if a[p][q] == 0.0 {
        return;
    }
    let theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
    let tangent = theta.signum() / (theta.abs() + libm::hypot(theta, 1.0));
    let cos = 1.0 / libm::hypot(tangent, 1.0);
    let sin = tangent * cos;
    for row in a.iter_mut() {
        let (one, two) = (row[p], row[q]);
        (row[p], row[q]) = (cos * one - sin * two, sin * one + cos * two);
    }
    let (one, two) = (a[p], a[q]);
    a[p] = std::array::from_fn(|k| cos * one[k] - sin * two[k]);
    a[q] = std::array::from_fn(|k| sin * one[k] + cos * two[k]);
    for row in vectors.iter_mut() {
        let (one, two) = (row[p], row[q]);
        (row[p], row[q]) = (cos * one - sin * two, sin * one + cos * two);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smallest_eigenvalue_and_the_solution_satisfy_their_equations() {
        let mut seed = 3_u64;
        let mut random = || {
            seed = seed
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (seed >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let root: Matrix6 = std::array::from_fn(|_| std::array::from_fn(|_| random()));
        let identity: Matrix6 = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
        let matrix = congruent(&identity, &root);
        let (value, vector) = smallest_eigenvalue(&matrix);
        let image = times(&matrix, &vector);
        for (image, own) in image.iter().zip(vector) {
            assert!((image - value * own).abs() < 1e-12);
        }
        assert!(value > 0.0 && (dot(&vector, &vector) - 1.0).abs() < 1e-12);
        let right = [1.0, -2.0, 0.5, 3.0, 0.0, 1.0];
        let solution = solve(&matrix, &right).expect("not singular");
        for (image, right) in times(&matrix, &solution).iter().zip(right) {
            assert!((image - right).abs() < 1e-9);
        }
        assert_eq!(solve(&ZERO, &right), None);
    }
}
