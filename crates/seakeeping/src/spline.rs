//! A cubic spline of matrices.

use super::matrix::{Matrix6, ZERO};

/// A spline: cubics between the points of an axis, with continuous curvature. At both ends of the axis the slope is
/// that of the parabola through the three points there.
///
/// The error of the spline goes with the fourth power of the steps. Cubics with the slopes of parabolas through three
/// neighbours, instead of a spline, have an error of the third power, which counts at a quay, where the resonance of
/// the gap is a few steps wide.
#[derive(Clone, Debug)]
pub(super) struct Spline {
    axis: Vec<f64>,
    values: Vec<Matrix6>,
    slopes: Vec<Matrix6>,
}

impl Spline {
    /// Makes the spline through values on an axis of at least three rising numbers.
    pub(super) fn new(axis: Vec<f64>, values: Vec<Matrix6>) -> Spline {
        let last = axis.len() - 1;
        let width = |k: usize| axis[k + 1] - axis[k];
        let mut slopes = vec![ZERO; axis.len()];
        for i in 0..6 {
            for j in 0..6 {
                let rise = |k: usize| (values[k + 1][i][j] - values[k][i][j]) / width(k);
                let end = |near: f64, next: f64, width: f64, next_width: f64| {
                    near + (near - next) * width / (width + next_width)
                };
                // Of continuous curvature: s₋ h₊ + 2 s (h₋ + h₊) + s₊ h₋ = 3 (h₊ m₋ + h₋ m₊), eliminated from the first point on.
                let (mut above, mut right) = (vec![0.0; axis.len()], vec![0.0; axis.len()]);
                right[0] = end(rise(0), rise(1), width(0), width(1));
                for k in 1..last {
                    let (before, after) = (width(k - 1), width(k));
                    let pivot = 2.0 * (before + after) - after * above[k - 1];
                    above[k] = before / pivot;
                    let wanted = 3.0 * (after * rise(k - 1) + before * rise(k));
                    right[k] = (wanted - after * right[k - 1]) / pivot;
                }
                slopes[last][i][j] =
                    end(rise(last - 1), rise(last - 2), width(last - 1), width(last - 2));
                for k in (0..last).rev() {
                    slopes[k][i][j] = right[k] - above[k] * slopes[k + 1][i][j];
                }
            }
        }
        Spline { axis, values, slopes }
    }

    /// The slope of the spline at the first point.
    pub(super) fn first_slope(&self) -> &Matrix6 {
        &self.slopes[0]
    }

    /// The value of the spline at a number within the axis.
    pub(super) fn at(&self, x: f64) -> Matrix6 {
        let low = self.axis.partition_point(|start| *start <= x).clamp(1, self.axis.len() - 1) - 1;
        let width = self.axis[low + 1] - self.axis[low];
        let t = (x - self.axis[low]) / width;
        let basis = [
            (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t),
            t * (1.0 - t) * (1.0 - t) * width,
            t * t * (3.0 - 2.0 * t),
            t * t * (t - 1.0) * width,
        ];
        std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                basis[0] * self.values[low][i][j]
                    + basis[1] * self.slopes[low][i][j]
                    + basis[2] * self.values[low + 1][i][j]
                    + basis[3] * self.slopes[low + 1][i][j]
            })
        })
    }
}
