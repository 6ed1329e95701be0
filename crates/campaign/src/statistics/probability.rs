//! The probability of an event that was counted in many runs.

use fenderline_contact::number::{greater, lesser};
use statrs::function::beta::beta_reg;

use super::normal;
use super::{Confidence, Estimate, Interval, Sample};

/// The probability of an event that happened in `hits` of `runs`, with the interval of Clopper and Pearson (Biometrika
/// 26, 1934): the level is never less than stated.
///
/// # Panics
/// Panics if there is no run, or if there are more hits than runs.
#[must_use]
pub fn binomial(hits: usize, runs: usize, confidence: Confidence) -> Estimate {
    assert!(runs > 0 && hits <= runs, "{hits} hits are not possible in {runs} runs");
    let (k, n) = (hits as f64, runs as f64);
    let tail = confidence.tail();
    let low = if hits == 0 { 0.0 } else { inverse_beta(k, n - k + 1.0, tail) };
    let high = if hits == runs { 1.0 } else { inverse_beta(k + 1.0, n - k, 1.0 - tail) };
    Estimate { value: k / n, interval: Interval { low, high } }
}

/// The probability of an event that happened in `hits` of `runs`, with Wilson's interval (Journal of the American
/// Statistical Association 22, 1927). The interval holds each probability p for which the observed share of hits lies
/// within z standard deviations, √(p(1 − p)/runs), of p. Here z is the quantile of the normal distribution for the
/// confidence level. The level holds on the average over all p. The level of [`binomial`] holds for every p.
///
/// # Panics
/// Panics if there is no run, or if there are more hits than runs.
#[must_use]
pub fn wilson(hits: usize, runs: usize, confidence: Confidence) -> Estimate {
    assert!(runs > 0 && hits <= runs, "{hits} hits are not possible in {runs} runs");
    let (n, p) = (runs as f64, hits as f64 / runs as f64);
    let z = confidence.normal_quantile();
    let shrink = 1.0 + z * z / n;
    let middle = (p + 0.5 * z * z / n) / shrink;
    let half = z / shrink * libm::sqrt(p * (1.0 - p) / n + 0.25 * z * z / (n * n));
    // At the ends the formula gives them but for rounding.
    let low = if hits == 0 { 0.0 } else { middle - half };
    let high = if hits == runs { 1.0 } else { middle + half };
    Estimate { value: p, interval: Interval { low, high } }
}

/// The probability to exceed `value`.
///
/// For a sample without weights the probability is the share of the values above `value`, with the interval of
/// [`binomial`]. For a sample with weights the probability is Σw/n over the values above `value`, which is unbiased,
/// with a log-normal interval from its standard error. The log-normal interval is approximate, and too narrow if few
/// values are above. If no value of the sample is above `value`, the interval reaches from 0 to the bound of
/// [`binomial`] for the effective size.
#[must_use]
pub fn share_above(sample: &Sample, value: f64, confidence: Confidence) -> Estimate {
    let to = sample.count_to(value);
    let runs = sample.count();
    let Some(weights) = sample.weights() else {
        return binomial(runs - to, runs, confidence);
    };
    let above = &weights[to..];
    let n = runs as f64;
    let sum: f64 = above.iter().sum();
    let squares: f64 = above.iter().map(|w| w * w).sum();
    let p = sum / n;
    if p <= 0.0 {
        let size = greater(libm::floor(sample.effective_size()), 1.0) as usize;
        return Estimate { value: 0.0, interval: binomial(0, size, confidence).interval };
    }
    let variance = greater(squares / n - p * p, 0.0) / n;
    let factor = libm::exp(confidence.normal_quantile() * libm::sqrt(variance) / p);
    Estimate { value: p, interval: Interval { low: p / factor, high: lesser(p * factor, 1.0) } }
}

/// The probability of at most `k` hits in `n` runs of probability `p`.
pub(super) fn at_most(k: usize, n: usize, p: f64) -> f64 {
    if k >= n { 1.0 } else { beta_below((n - k) as f64, k as f64 + 1.0, 1.0 - p) }
}

/// Size of the two parameters above which the beta distribution is computed by a normal approximation: the library's
/// continued fraction ends after 140 terms, which are too few if both parameters are large.
const LARGE: f64 = 500.0;

/// The regularised incomplete beta function.
fn beta_below(a: f64, b: f64, x: f64) -> f64 {
    if x <= 0.0 || x >= 1.0 {
        return if x <= 0.0 { 0.0 } else { 1.0 };
    }
    if a < LARGE || b < LARGE { beta_reg(a, b, x) } else { peizer_pratt(a, b, x) }
}

/// The normal approximation of Peizer and Pratt (JASA 63, 1968, 1416-1456) to the incomplete beta function, which
/// equals the binomial probability of at least a hits in n = a + b − 1 runs.
fn peizer_pratt(a: f64, b: f64, x: f64) -> f64 {
    let (n, k, p, q) = (a + b - 1.0, a - 1.0, x, 1.0 - x);
    let small = q / (k + 1.0) - p / (n - k) + (q - 0.5) / (n + 1.0);
    let d = k + 2.0 / 3.0 - (n + 1.0 / 3.0) * p + 0.02 * small;
    let skew = 1.0 + q * g((k + 0.5) / (n * p)) + p * g((n - k - 0.5) / (n * q));
    normal::above(d * libm::sqrt(skew / ((n + 1.0 / 6.0) * p * q)))
}

/// The function (1 − x² + 2x ln x)/(1 − x)², near x = 1 by its series.
fn g(x: f64) -> f64 {
    let u = 1.0 - x;
    if u.abs() > 0.1 {
        return (1.0 - x * x + 2.0 * x * libm::log(x)) / (u * u);
    }
    let (mut power, mut sum) = (u, 0.0);
    for k in 3..20 {
        let k = f64::from(k);
        sum += 2.0 * power / (k * (k - 1.0));
        power *= u;
    }
    sum
}

/// The value that a beta variable does not exceed with probability `p`, by bisection of the incomplete beta function:
/// the library's Newton method starts at 10⁻⁴ or above, and fails for rare values.
fn inverse_beta(a: f64, b: f64, p: f64) -> f64 {
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    for _ in 0..200 {
        // Halves the exponent first where the ends are of different size.
        let middle =
            if low > 0.0 && high > 4.0 * low { libm::sqrt(low * high) } else { 0.5 * (low + high) };
        if middle <= low || middle >= high || high - low < 1e-14 * high {
            break;
        }
        if beta_below(a, b, middle) < p { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ends of Wilson's interval are those probabilities whose deviation is so many times as far from the share.
    #[test]
    fn wilsons_interval_by_its_definition() {
        let z = Confidence::USUAL.normal_quantile();
        for (hits, runs) in [(1, 29), (15, 148), (81, 263), (59, 60)] {
            let found = wilson(hits, runs, Confidence::USUAL);
            let share = hits as f64 / runs as f64;
            for end in [found.interval.low, found.interval.high] {
                let deviation = libm::sqrt(end * (1.0 - end) / runs as f64);
                assert!(((share - end).abs() / deviation - z).abs() < 1e-9, "{hits} of {runs}");
            }
            assert!(found.interval.holds(share));
        }
        let none = wilson(0, 20, Confidence::USUAL).interval;
        assert_eq!(none.low, 0.0);
        assert!((none.high - z * z / (20.0 + z * z)).abs() < 1e-12);
    }
}
