//! Empirical exceedance: the probability that a value is exceeded, with pointwise bands.

use super::{Confidence, Estimate, Sample, share_above};

/// A point of an exceedance curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Value.
    pub value: f64,
    /// Probability that a run exceeds the value, with a pointwise interval: each point by itself holds the true
    /// probability at the confidence level, not the whole curve at once.
    pub probability: Estimate,
    /// Share of the runs that reach the value: above 0 even at the largest value.
    pub reached: f64,
}

/// The exceedance curve of a sample, with at most about `most` points: one for each of the largest values, and points
/// at growing distances for the other values. For a sample without weights the band is that of Clopper and Pearson, see
/// [`share_above`].
#[must_use]
pub fn curve(sample: &Sample, most: usize, confidence: Confidence) -> Vec<Point> {
    let values = sample.values();
    let mut points: Vec<Point> = Vec::new();
    let mut ranks = ranks(values.len(), most);
    ranks.reverse();
    for rank in ranks {
        // The value of this rank from the top: `rank − 1` values are above it.
        let value = values[values.len() - rank];
        if points.last().is_none_or(|last| last.value < value) {
            let below = values.partition_point(|other| *other < value);
            let reached = match below.checked_sub(1) {
                Some(next) => share_above(sample, values[next], confidence).value,
                None => 1.0,
            };
            let probability = share_above(sample, value, confidence);
            points.push(Point { value, probability, reached });
        }
    }
    points
}

/// Ranks of the values to draw, counted from the largest value: first every rank, then ranks that grow by a constant
/// factor up to `n`.
fn ranks(n: usize, most: usize) -> Vec<usize> {
    if n <= most {
        return (1..=n).collect();
    }
    let factor = libm::pow(n as f64, 1.0 / most as f64);
    let mut ranks = vec![1];
    let mut rank = 1.0;
    while ranks.last().is_some_and(|last| *last < n) {
        let next = rank * factor;
        // At least the next whole number.
        let last = ranks[ranks.len() - 1] as f64;
        rank = if next < last + 1.0 { last + 1.0 } else { next };
        ranks.push((libm::round(rank) as usize).min(n));
    }
    ranks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_falls_and_ends_where_no_value_is_above() {
        let sample = Sample::new((0..100_000).map(|i| f64::from(i) * 0.5).collect()).unwrap();
        let points = curve(&sample, 200, Confidence::USUAL);
        assert!(points.len() < 400, "{}", points.len());
        assert!(points.windows(2).all(|w| w[0].value < w[1].value));
        assert!(points.windows(2).all(|w| w[0].probability.value > w[1].probability.value));
        assert_eq!(points[points.len() - 1].probability.value, 0.0);
        for point in points {
            let exact = 1.0 - (2.0 * point.value + 1.0) / 100_000.0;
            assert!((point.probability.value - exact).abs() < 1e-12);
            assert!(point.probability.interval.holds(exact));
            assert!((point.reached - exact - 1.0 / 100_000.0).abs() < 1e-12);
        }
    }
}
