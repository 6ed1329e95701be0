//! A parabola through the readings of a length of time, by least squares: the smoothing of measured readings.
//!
//! Readings y_i at times t_i are smoothed at the time t₀ by y = a + b (t − t₀) + c (t − t₀)². All readings within the
//! length of time have the same weight. With t₀ at the end of that time this is the local quadratic regression at a
//! boundary (Fan and Gijbels 1996, with a uniform kernel); evenly spaced readings give the end values of the filter of
//! Savitzky and Golay. The covariance of a, b, c is s² (XᵀX)⁻¹ with s² = Σr²/(n − 3), and s is never less than the
//! rounding of the readings, step/√12. Residuals that follow each other widen the covariance by (1 + ρ)/(1 − ρ), where
//! ρ is their correlation from one reading to the next, if ρ is larger than chance gives, 2/√n.

use fenderline_contact::number::greater;

/// Fewest readings of a parabola.
pub const FEWEST: usize = 6;
/// A reading farther from the parabola than this number of deviations is left out.
const OUTSIDE: f64 = 4.5;
/// Turns the median of absolute residuals into a standard deviation, for a normal distribution.
const MEDIAN_TO_SD: f64 = 1.4826;
/// Largest factor on the covariance for residuals that follow each other.
const MOST_FACTOR: f64 = 25.0;

/// A parabola with its uncertainty.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parabola {
    /// The time t₀ (s).
    pub at_s: f64,
    /// a, b and c.
    pub of: [f64; 3],
    /// Covariance of a, b and c.
    pub covariance: [[f64; 3]; 3],
    /// Number of readings that were used.
    pub count: usize,
    /// Number of readings that were left out, because they lie too far from the others.
    pub left_out: usize,
    /// Standard deviation s of the readings.
    pub deviation: f64,
    /// ρ, the correlation of a residual with the next.
    pub correlation: f64,
}

impl Parabola {
    /// Lays a parabola through readings, as pairs of time (s) and value; `step` is the step in which the readings are
    /// written. Readings far from the others are left out, in at most four rounds. `None` for fewer than [`FEWEST`]
    /// readings, or times that are all the same.
    #[must_use]
    pub fn through(readings: &[(f64, f64)], at_s: f64, step: f64) -> Option<Parabola> {
        let mut kept: Vec<(f64, f64)> = readings.to_vec();
        let rounding = if step.is_finite() { step / libm::sqrt(12.0) } else { 0.0 };
        for _ in 0..4 {
            let fit = fitted(&kept, at_s)?;
            let mut off: Vec<f64> =
                kept.iter().map(|(t, y)| (y - fit.at(t - at_s)).abs()).collect();
            off.sort_by(f64::total_cmp);
            // A parabola through few readings is drawn towards each of them.
            let few = libm::sqrt(off.len() as f64 / (off.len() - 3) as f64);
            let deviation = greater(MEDIAN_TO_SD * few * off[off.len() / 2], rounding);
            let before = kept.len();
            kept.retain(|(t, y)| (y - fit.at(t - at_s)).abs() <= OUTSIDE * deviation + 1e-12);
            if kept.len() == before {
                break;
            }
        }
        let fit = fitted(&kept, at_s)?;
        Some(fit.with_uncertainty(&kept, at_s, rounding, readings.len() - kept.len()))
    }

    /// Value at the time `t_s` (s).
    #[must_use]
    pub fn value(&self, t_s: f64) -> f64 {
        Fit { of: self.of, inverse: [[0.0; 3]; 3] }.at(t_s - self.at_s)
    }

    /// Slope at the time `t_s` (1/s).
    #[must_use]
    pub fn slope(&self, t_s: f64) -> f64 {
        self.of[1] + 2.0 * self.of[2] * (t_s - self.at_s)
    }

    /// Directions of the uncertainty: vectors whose outer products add up to the covariance (Cholesky).
    #[must_use]
    pub fn directions(&self) -> [[f64; 3]; 3] {
        let c = &self.covariance;
        let root = |value: f64| libm::sqrt(greater(value, 0.0));
        let over = |value: f64, by: f64| if by > 0.0 { value / by } else { 0.0 };
        let l00 = root(c[0][0]);
        let (l10, l20) = (over(c[1][0], l00), over(c[2][0], l00));
        let l11 = root(c[1][1] - l10 * l10);
        let l21 = over(c[2][1] - l20 * l10, l11);
        let l22 = root(c[2][2] - l20 * l20 - l21 * l21);
        [[l00, l10, l20], [0.0, l11, l21], [0.0, 0.0, l22]]
    }

    /// The parabola with its three numbers moved by `by`.
    #[must_use]
    pub fn moved(&self, by: [f64; 3]) -> Parabola {
        let of = [self.of[0] + by[0], self.of[1] + by[1], self.of[2] + by[2]];
        Parabola { of, ..*self }
    }
}

struct Fit {
    of: [f64; 3],
    /// (XᵀX)⁻¹.
    inverse: [[f64; 3]; 3],
}

impl Fit {
    fn at(&self, t_s: f64) -> f64 {
        self.of[0] + t_s * (self.of[1] + t_s * self.of[2])
    }

    fn with_uncertainty(
        self,
        kept: &[(f64, f64)],
        at_s: f64,
        rounding: f64,
        left_out: usize,
    ) -> Parabola {
        let off: Vec<f64> = kept.iter().map(|(t, y)| y - self.at(t - at_s)).collect();
        let count = off.len() as f64;
        let squares: f64 = off.iter().map(|r| r * r).sum();
        let next: f64 = off.windows(2).map(|two| two[0] * two[1]).sum();
        let correlation = if squares > 0.0 { next / squares } else { 0.0 };
        // Rounding makes steps that follow each other where the readings hardly move.
        let deviation = greater(libm::sqrt(squares / (count - 3.0)), rounding);
        let factor = match correlation > 2.0 / libm::sqrt(count) {
            true if correlation < 1.0 => fenderline_contact::number::lesser(
                (1.0 + correlation) / (1.0 - correlation),
                MOST_FACTOR,
            ),
            true => MOST_FACTOR,
            false => 1.0,
        };
        let scale = deviation * deviation * factor;
        Parabola {
            at_s,
            of: self.of,
            covariance: self.inverse.map(|row| row.map(|own| own * scale)),
            count: kept.len(),
            left_out,
            deviation,
            correlation,
        }
    }
}

/// Least squares in times scaled to about 1.
fn fitted(readings: &[(f64, f64)], at_s: f64) -> Option<Fit> {
    if readings.len() < FEWEST {
        return None;
    }
    let scale = readings.iter().map(|(t, _)| (t - at_s).abs()).fold(0.0, greater);
    if scale == 0.0 {
        return None;
    }
    // Values relative to the first, so that sums of large coordinates lose nothing.
    let base = readings[0].1;
    let mut sums = [0.0; 5];
    let mut right = [0.0; 3];
    for (t, y) in readings {
        let u = (t - at_s) / scale;
        let powers = [1.0, u, u * u];
        for (index, sum) in sums.iter_mut().enumerate() {
            *sum += powers[index / 2] * powers[index - index / 2];
        }
        for (sum, power) in right.iter_mut().zip(powers) {
            *sum += power * (y - base);
        }
    }
    let matrix =
        [[sums[0], sums[1], sums[2]], [sums[1], sums[2], sums[3]], [sums[2], sums[3], sums[4]]];
    let mut inverse = inverse(&matrix)?;
    let mut of = [0.0; 3];
    for (own, row) in of.iter_mut().zip(&inverse) {
        *own = row.iter().zip(right).map(|(a, b)| a * b).sum();
    }
    let scales = [1.0, scale, scale * scale];
    for (row, own) in of.iter_mut().enumerate() {
        *own /= scales[row];
        for (column, scale) in scales.iter().enumerate() {
            inverse[row][column] /= scales[row] * scale;
        }
    }
    of[0] += base;
    Some(Fit { of, inverse })
}

/// The inverse of a symmetric matrix; `None` if it has none.
fn inverse(m: &[[f64; 3]; 3]) -> Option<[[f64; 3]; 3]> {
    let minor = |row: usize, column: usize| {
        let (a, b) = ((row + 1) % 3, (row + 2) % 3);
        let (c, d) = ((column + 1) % 3, (column + 2) % 3);
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let determinant: f64 = (0..3).map(|column| m[0][column] * minor(0, column)).sum();
    let least = 1e-12 * m[0][0] * m[0][0] * m[0][0];
    if determinant.is_nan() || determinant.abs() <= least {
        return None;
    }
    let mut inverse = [[0.0; 3]; 3];
    for (row, own) in inverse.iter_mut().enumerate() {
        for (column, value) in own.iter_mut().enumerate() {
            *value = minor(column, row) / determinant;
        }
    }
    Some(inverse)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_parabola_is_found_exactly_and_far_readings_are_left_out() {
        let readings: Vec<(f64, f64)> = (0..20)
            .map(|index| {
                let t = 1e9 + f64::from(index);
                let y = 3.0 - 0.2 * (t - 1e9) + 0.01 * (t - 1e9) * (t - 1e9);
                (t, if index == 7 { y + 5.0 } else { y })
            })
            .collect();
        let fit = Parabola::through(&readings, 1e9 + 19.0, 0.0).expect("enough readings");
        assert_eq!((fit.count, fit.left_out), (19, 1));
        assert!((fit.value(1e9) - 3.0).abs() < 1e-9, "{fit:?}");
        assert!((fit.slope(1e9 + 19.0) - 0.18).abs() < 1e-9);
        assert!((fit.of[2] - 0.01).abs() < 1e-9);
        assert!(Parabola::through(&readings[..5], 1e9, 0.0).is_none());
        assert!(Parabola::through(&[(1.0, 2.0); 9], 1.0, 0.0).is_none());
    }

    #[test]
    fn directions_give_the_covariance_back() {
        let readings: Vec<(f64, f64)> =
            (0..30).map(|index| (f64::from(index), f64::from(index * 7 % 5))).collect();
        let fit = Parabola::through(&readings, 29.0, 0.0).expect("enough readings");
        let directions = fit.directions();
        for row in 0..3 {
            for column in 0..3 {
                let sum: f64 = directions.iter().map(|own| own[row] * own[column]).sum();
                let wanted = fit.covariance[row][column];
                assert!((sum - wanted).abs() < 1e-9 * fit.covariance[0][0], "{row} {column}");
            }
        }
    }
}
