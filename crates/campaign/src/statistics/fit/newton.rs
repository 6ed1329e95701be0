//! Finds the maximum of a smooth function by Newton's method with numerical differences, and the covariance that the
//! curvature gives.

use super::error::FitFault;

/// A maximum.
pub(super) struct Maximum {
    pub(super) at: Vec<f64>,
    pub(super) value: f64,
    /// Covariance of the parameters: the inverse of the observed information.
    pub(super) covariance: Vec<Vec<f64>>,
    pub(super) steps: usize,
}

const MOST_STEPS: usize = 200;
/// Rise of the likelihood's logarithm below which no further step is made.
const SETTLED: f64 = 1e-9;
/// Step of a parameter in the numerical differences, divided by s/√n: s is the size of a change of this parameter that
/// matters, and n the number of values. The step is far below a standard error, so that there is no bias, and far above
/// the rounding of a sum over 10⁶ values.
const DIFFERENCE: f64 = 0.005;
/// Damping of the Newton step above which no step raises the function any more.
const MOST_DAMPING: f64 = 1e12;

/// Maximises the function `of`, the logarithm of the likelihood of `n` values, which is −∞ outside its range. `scale`
/// has for each parameter the size of a change that matters.
pub(super) fn maximise(
    start: &[f64],
    scale: &[f64],
    n: usize,
    of: &dyn Fn(&[f64]) -> f64,
) -> Result<Maximum, FitFault> {
    let step: Vec<f64> =
        scale.iter().map(|scale| DIFFERENCE * scale / libm::sqrt(n as f64)).collect();
    let (mut at, mut value) = (start.to_vec(), of(start));
    if !value.is_finite() {
        return Err(FitFault::Flat);
    }
    let mut damping = 0.0;
    for steps in 0..MOST_STEPS {
        let Some((slope, curve)) = derivatives(&at, value, &step, of) else {
            return Err(FitFault::Flat);
        };
        if let Some(covariance) = inverse(&curve) {
            let rise = 0.5 * quadratic(&covariance, &slope);
            if rise < SETTLED * libm::sqrt(n as f64) {
                // The last step squares the error, but rises by less than the function's rounding.
                let last = stepped(&at, &covariance, &slope);
                let there = of(&last);
                let (at, value) = if there.is_finite() { (last, there) } else { (at, value) };
                return Ok(Maximum { at, value, covariance, steps });
            }
        }
        // Levenberg and Marquardt: damp until the function rises.
        loop {
            let damped = |i: usize, j: usize| {
                let own = if i == j { damping * n as f64 / (scale[i] * scale[i]) } else { 0.0 };
                curve[i][j] + own
            };
            let size = at.len();
            let matrix: Vec<Vec<f64>> =
                (0..size).map(|i| (0..size).map(|j| damped(i, j)).collect()).collect();
            let moved = inverse(&matrix).map(|inverse| stepped(&at, &inverse, &slope));
            let next = moved.map(|moved| (of(&moved), moved)).filter(|(next, _)| *next > value);
            if let Some((next, moved)) = next {
                (at, value) = (moved, next);
                damping *= 0.1;
                break;
            }
            damping = if damping < 1e-6 { 1e-6 } else { 10.0 * damping };
            if damping > MOST_DAMPING {
                return Err(FitFault::NotConverged { steps });
            }
        }
    }
    Err(FitFault::NotConverged { steps: MOST_STEPS })
}

/// The parameters after a Newton step: the inverse curvature times the slope.
fn stepped(at: &[f64], inverse: &[Vec<f64>], slope: &[f64]) -> Vec<f64> {
    let change = |row: &[f64]| row.iter().zip(slope).map(|(a, b)| a * b).sum::<f64>();
    at.iter().zip(inverse).map(|(at, row)| at + change(row)).collect()
}

/// Slope and negative curvature of the function by central differences; `None` at the border of its range.
fn derivatives(
    at: &[f64],
    value: f64,
    step: &[f64],
    of: &dyn Fn(&[f64]) -> f64,
) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
    let size = at.len();
    let moved = |changes: &[(usize, f64)]| {
        let mut there = at.to_vec();
        for (index, by) in changes {
            there[*index] += by * step[*index];
        }
        Some(of(&there)).filter(|value| value.is_finite())
    };
    let mut slope = vec![0.0; size];
    let mut curve = vec![vec![0.0; size]; size];
    for i in 0..size {
        let (up, down) = (moved(&[(i, 1.0)])?, moved(&[(i, -1.0)])?);
        slope[i] = (up - down) / (2.0 * step[i]);
        curve[i][i] = (2.0 * value - up - down) / (step[i] * step[i]);
        for j in 0..i {
            let both = moved(&[(i, 1.0), (j, 1.0)])? + moved(&[(i, -1.0), (j, -1.0)])?;
            let opposed = moved(&[(i, 1.0), (j, -1.0)])? + moved(&[(i, -1.0), (j, 1.0)])?;
            curve[i][j] = (opposed - both) / (4.0 * step[i] * step[j]);
            curve[j][i] = curve[i][j];
        }
    }
    Some((slope, curve))
}

/// The inverse of a positive definite matrix, by Cholesky's factors; `None` for any other matrix.
fn inverse(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let size = matrix.len();
    let mut factor = vec![vec![0.0; size]; size];
    for i in 0..size {
        for j in 0..=i {
            let done: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
            let rest = matrix[i][j] - done;
            if i == j {
                if !(rest > 0.0 && rest.is_finite()) {
                    return None;
                }
                factor[i][i] = libm::sqrt(rest);
            } else {
                factor[i][j] = rest / factor[j][j];
            }
        }
    }
    let mut inverse = vec![vec![0.0; size]; size];
    for column in 0..size {
        let mut x = vec![0.0; size];
        for i in 0..size {
            let done: f64 = (0..i).map(|k| factor[i][k] * x[k]).sum();
            x[i] = (f64::from(u8::from(i == column)) - done) / factor[i][i];
        }
        for i in (0..size).rev() {
            let done: f64 = (i + 1..size).map(|k| factor[k][i] * x[k]).sum();
            x[i] = (x[i] - done) / factor[i][i];
        }
        for (row, x) in inverse.iter_mut().zip(x) {
            row[column] = x;
        }
    }
    Some(inverse)
}

fn quadratic(matrix: &[Vec<f64>], vector: &[f64]) -> f64 {
    let row = |row: &Vec<f64>| row.iter().zip(vector).map(|(a, b)| a * b).sum::<f64>();
    matrix.iter().zip(vector).map(|(own, x)| x * row(own)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quadratic_gives_its_own_curvature() {
        let of = |x: &[f64]| -(2.0 * x[0] * x[0] + 2.0 * x[0] * x[1] + 3.0 * x[1] * x[1]);
        let found = maximise(&[1.0, -2.0], &[1.0, 1.0], 1, &of).ok().unwrap();
        assert!(found.at.iter().all(|x| x.abs() < 1e-4), "{:?}", found.at);
        // The information is [[4, 2], [2, 6]], its inverse [[0.3, −0.1], [−0.1, 0.2]].
        let want = [[0.3, -0.1], [-0.1, 0.2]];
        for (row, want) in found.covariance.iter().zip(want) {
            for (got, want) in row.iter().zip(want) {
                assert!((got - want).abs() < 1e-6, "{:?}", found.covariance);
            }
        }
    }

    #[test]
    fn a_function_without_a_maximum_is_refused() {
        assert!(maximise(&[1.0], &[1.0], 10, &|x| x[0]).is_err());
        assert!(maximise(&[1.0], &[1.0], 10, &|_| 0.0).is_err());
        assert!(maximise(&[1.0], &[1.0], 10, &|_| f64::NEG_INFINITY).is_err());
    }
}
