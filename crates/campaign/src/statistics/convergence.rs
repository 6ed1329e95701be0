//! Computes how estimates settle as the number of runs grows.

use super::{Confidence, Moments, Quantile, Sample, value_exceeded};

/// The estimates that the first `runs` runs of a campaign give.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Number of runs.
    pub runs: usize,
    /// Mean of the first values, and its standard error.
    pub mean: super::Measured,
    /// The value that is exceeded with the probability asked for.
    pub quantile: Quantile,
}

/// Smallest number of runs for which estimates are made.
const FIRST: usize = 10;

/// The mean and the value that is exceeded with probability `p`, for the first 10 runs, for all runs, and for at most
/// `most` numbers of runs between, which grow by a constant factor. `values` are in the order of the runs.
///
/// The bands are those of independent runs; the first values of a plan with strata, such as a Latin hypercube, are no
/// random sample before the plan's end.
#[must_use]
pub fn steps(values: &[f64], p: f64, most: usize, confidence: Confidence) -> Vec<Step> {
    let last = values.len();
    if last < FIRST {
        return Vec::new();
    }
    let factor = libm::pow(last as f64 / FIRST as f64, 1.0 / most.max(1) as f64);
    let mut counts: Vec<usize> = (0..=most)
        .map(|step| libm::round(FIRST as f64 * libm::pow(factor, step as f64)) as usize)
        .map(|count| count.min(last))
        .collect();
    counts.push(last);
    counts.dedup();
    let step = |runs: usize| {
        let sample = Sample::new(values[..runs].to_vec()).ok()?;
        let mean = Moments::of(&sample).mean;
        Some(Step { runs, mean, quantile: value_exceeded(&sample, p, confidence) })
    };
    counts.into_iter().filter_map(step).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_last_step_is_of_all_runs() {
        let values: Vec<f64> = (0..1234).map(|i| f64::from(i * 7919 % 1234)).collect();
        let steps = steps(&values, 0.1, 12, Confidence::USUAL);
        assert!(steps.windows(2).all(|two| two[0].runs < two[1].runs));
        let last = steps[steps.len() - 1];
        assert_eq!(last.runs, 1234);
        assert!((last.mean.value - 616.5).abs() < 1e-9);
        assert!((last.quantile.value.unwrap() - 1110.5).abs() < 1.0);
        assert!(super::steps(&values[..9], 0.1, 12, Confidence::USUAL).is_empty());
    }
}
