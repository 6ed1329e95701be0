//! Solves linear least squares with several right sides, by Householder's reflections.

/// Finds the solutions x of min |A x − b|² + ridge² |x|², one for each right side b. `rows` are the rows of A; `rights`
/// has, for each row, one number per right side.
///
/// # Panics
/// Panics if there are fewer rows than columns and no ridge, or if lists have different lengths.
pub(super) fn least_squares(rows: &[Vec<f64>], rights: &[Vec<f64>], ridge: f64) -> Vec<Vec<f64>> {
    let (columns, sides) = (rows[0].len(), rights[0].len());
    assert_eq!(rows.len(), rights.len(), "each row has one number per right side");
    let mut a: Vec<Vec<f64>> = rows.to_vec();
    let mut b: Vec<Vec<f64>> = rights.to_vec();
    for column in 0..columns {
        let mut row = vec![0.0; columns];
        row[column] = ridge;
        a.push(row);
        b.push(vec![0.0; sides]);
    }
    for column in 0..columns {
        let norm = a[column..].iter().map(|row| row[column] * row[column]).sum::<f64>().sqrt();
        if norm == 0.0 {
            continue;
        }
        let head = a[column][column];
        let mirrored = if head > 0.0 { -norm } else { norm };
        // The reflection's vector v = (head − mirrored, rest), with vᵀv = 2 norm (norm + |head|).
        let mut vector: Vec<f64> = a[column..].iter().map(|row| row[column]).collect();
        vector[0] = head - mirrored;
        let scale = 1.0 / (norm * (norm + head.abs()));
        let reflect = |matrix: &mut [Vec<f64>], from: usize, to: usize| {
            for k in from..to {
                let product: f64 =
                    matrix[column..].iter().zip(&vector).map(|(row, v)| row[k] * v).sum();
                for (row, v) in matrix[column..].iter_mut().zip(&vector) {
                    row[k] -= scale * product * v;
                }
            }
        };
        reflect(&mut a, column, columns);
        reflect(&mut b, 0, sides);
    }
    let mut solutions = vec![vec![0.0; columns]; sides];
    for (side, solution) in solutions.iter_mut().enumerate() {
        for row in (0..columns).rev() {
            let known: f64 = (row + 1..columns).map(|k| a[row][k] * solution[k]).sum();
            solution[row] =
                if a[row][row] == 0.0 { 0.0 } else { (b[row][side] - known) / a[row][row] };
        }
    }
    solutions
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_through_noisy_points_has_the_coefficients_of_the_normal_equations() {
        let xs = [0.0, 1.0, 2.0, 3.0, 4.0];
        let rows: Vec<Vec<f64>> = xs.iter().map(|x| vec![1.0, *x, x * x]).collect();
        let rights: Vec<Vec<f64>> =
            [1.0, 0.5, 3.5, 7.9, 16.2].iter().map(|y| vec![*y, 2.0 - *y]).collect();
        let [one, two] = &least_squares(&rows, &rights, 0.0)[..] else { panic!("two solutions") };
        for column in 0..3 {
            let residual = |solution: &[f64], side: usize| -> f64 {
                rows.iter()
                    .zip(&rights)
                    .map(|(row, right)| {
                        let value: f64 = row.iter().zip(solution).map(|(a, x)| a * x).sum();
                        (value - right[side]) * row[column]
                    })
                    .sum()
            };
            assert!(residual(one, 0).abs() < 1e-12 && residual(two, 1).abs() < 1e-12);
        }
    }
}
