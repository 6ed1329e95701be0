//! Quantiles of a sample, with intervals from order statistics.

use super::probability::at_most;
use super::{Confidence, Sample};

/// A quantile of a sample. A number that the sample cannot give is `None`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantile {
    /// The estimate of the quantile; `None` if there are too few runs for the probability, so that the quantile lies
    /// beyond the data.
    pub value: Option<f64>,
    /// Lower end of the interval; `None` if it lies below all values.
    pub low: Option<f64>,
    /// Upper end of the interval; `None` if it lies above all values.
    pub high: Option<f64>,
}

/// The value that is not exceeded with probability `p`: [`value_exceeded`] of 1 − p.
#[must_use]
pub fn quantile(sample: &Sample, p: f64, confidence: Confidence) -> Quantile {
    value_exceeded(sample, 1.0 - p, confidence)
}

/// The value that is exceeded with probability `p`.
///
/// The estimate interpolates between the order statistics at i/(n + 1), the plotting positions of Weibull, so it exists
/// for p from 1/(n + 1) to n/(n + 1). The interval lies between two order statistics, whatever the distribution (David
/// and Nagaraja, Order Statistics, 7.1): the number of values above a quantile is binomial. For a sample with weights
/// the estimate is the smallest value above which the weighted share of values is at most p, and there is no interval.
#[must_use]
pub fn value_exceeded(sample: &Sample, p: f64, confidence: Confidence) -> Quantile {
    if let Some(weights) = sample.weights() {
        return Quantile { value: weighted(sample, weights, p), low: None, high: None };
    }
    let values = sample.values();
    let n = values.len();
    let place = (n as f64 + 1.0) * (1.0 - p);
    let value = (place >= 1.0 && place <= n as f64).then(|| {
        let whole = libm::floor(place);
        // At least 1, by the condition.
        let below = whole as usize - 1;
        match values.get(below + 1) {
            Some(above) => values[below] + (place - whole) * (above - values[below]),
            None => values[below],
        }
    });
    let tail = confidence.tail();
    // Of m values above the quantile, the one of rank m + 1 from the top is below the quantile.
    let fewest = first_count(n, |m| at_most(m, n, p) > tail);
    let most = first_count(n, |m| at_most(m, n, p) >= 1.0 - tail);
    // No more than `most` values are above: the next one is a lower bound. At least `fewest` are: the last of them is
    // an upper one.
    let low = (most < n).then(|| values[n - 1 - most]);
    let high = fewest.checked_sub(1).map(|above| values[n - 1 - above]);
    Quantile { value, low, high }
}

/// The first number from 0 to `n` for which the condition holds; the condition must hold for all greater numbers too.
fn first_count(n: usize, holds: impl Fn(usize) -> bool) -> usize {
    let (mut low, mut high) = (0, n);
    while low < high {
        let middle = low + (high - low) / 2;
        if holds(middle) { high = middle } else { low = middle + 1 }
    }
    low
}

/// The smallest value above which the weighted share of values is at most `p`; `None` if this is the largest value,
/// beyond which nothing is known.
fn weighted(sample: &Sample, weights: &[f64], p: f64) -> Option<f64> {
    let n = weights.len() as f64;
    let mut above = 0.0;
    for index in (0..weights.len()).rev() {
        let with_this = above + weights[index];
        if with_this / n > p {
            return (index + 1 < weights.len()).then(|| sample.values()[index]);
        }
        above = with_this;
    }
    Some(sample.least())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn first(n: usize) -> Sample {
        Sample::new((1..=n).map(|i| i as f64).collect()).unwrap()
    }

    /// `numpy.quantile(range(1, 101), p, method="weibull")` is 101 p.
    #[test]
    fn the_estimate_is_numpys_of_the_method_weibull() {
        for p in [0.01, 0.25, 0.5, 0.95, 0.99] {
            let got = quantile(&first(100), p, Confidence::USUAL).value.unwrap();
            assert!((got - 101.0 * p).abs() < 1e-9, "{p}: {got}");
        }
        assert_eq!(quantile(&first(100), 0.995, Confidence::USUAL).value, None);
    }

    /// David and Nagaraja: ranks 40 and 61 of 100 for the median at 95 %.
    #[test]
    fn the_interval_of_a_median_is_the_textbooks() {
        let found = quantile(&first(100), 0.5, Confidence::USUAL);
        assert_eq!((found.low, found.high), (Some(40.0), Some(61.0)));
    }

    #[test]
    fn what_the_data_do_not_reach_has_no_upper_end() {
        let found = quantile(&first(100), 0.99, Confidence::USUAL);
        assert_eq!(found.high, None);
        assert!(found.low.is_some_and(|low| (96.0..100.0).contains(&low)));
        let found = quantile(&first(100), 1.0 - 1e-6, Confidence::USUAL);
        assert_eq!((found.value, found.high), (None, None));
        assert_eq!(found.low, Some(100.0));
    }
}
