//! Measures how far a sample lies from a distribution.

use fenderline_contact::number::greater;

use super::Distribution;

/// The distance of Kolmogorov and Smirnov and the A² of Anderson and Darling between sorted values and a distribution;
/// if the distribution has a threshold, all values lie above it.
pub(super) fn distances(values: &[f64], distribution: &Distribution) -> (f64, f64) {
    let n = values.len() as f64;
    let (mut largest, mut sum) = (0.0, 0.0);
    for (index, x) in values.iter().enumerate() {
        let i = index as f64;
        let below = distribution.below_of_fitted(*x);
        largest = greater(largest, greater(below - i / n, (i + 1.0) / n - below));
        let opposite = distribution.above_of_fitted(values[values.len() - 1 - index]);
        sum += (2.0 * i + 1.0) * (log(below) + log(opposite));
    }
    (largest, -n - sum / n)
}

/// The logarithm of a probability that may have underflowed to 0.
fn log(p: f64) -> f64 {
    libm::log(greater(p, f64::MIN_POSITIVE))
}
