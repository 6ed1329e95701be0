//! A sample: the values of many runs in order.

use core::fmt;

/// The values of a column, sorted, with weights where runs were drawn by importance sampling.
///
/// A weight is the ratio of the density that a run is to stand for to the density from which the run was drawn; its
/// mean over many runs is 1. In a sample without weights, all weights count as 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    values: Vec<f64>,
    weights: Option<Weights>,
}

/// Weights in the order of the values, and their sums.
#[derive(Clone, Debug, PartialEq)]
struct Weights {
    each: Vec<f64>,
    sum: f64,
    sum_of_squares: f64,
}

/// The reason why values make no sample.
#[derive(Clone, Debug, PartialEq)]
pub enum SampleError {
    /// There are fewer values than a sample needs.
    TooFew {
        /// How many there are.
        count: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A value or weight is not finite.
    NotFinite {
        /// Place of the value in the column, counted from 0.
        place: usize,
    },
    /// A weight is negative, or all weights are zero.
    BadWeights {
        /// Place of the negative weight in the column, counted from 0; the first place if all weights are zero.
        place: usize,
    },
    /// The numbers of values and weights differ.
    Unequal {
        /// Number of values.
        values: usize,
        /// Number of weights.
        weights: usize,
    },
}

impl fmt::Display for SampleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SampleError::TooFew { count, needed } => {
                write!(f, "at least {needed} values are needed, but there are {count}")
            }
            SampleError::NotFinite { place } => write!(f, "value {} is not finite", place + 1),
            SampleError::BadWeights { place } => {
                write!(f, "weight {} is negative, or all are zero", place + 1)
            }
            SampleError::Unequal { values, weights } => {
                write!(f, "{values} values have {weights} weights")
            }
        }
    }
}

impl std::error::Error for SampleError {}

/// Smallest number of values of a sample.
const FEWEST: usize = 2;

impl Sample {
    /// Makes a sample of values with equal weights.
    ///
    /// # Errors
    /// Fails if there are fewer than two values, or if a value is not finite.
    pub fn new(mut values: Vec<f64>) -> Result<Sample, SampleError> {
        check(&values)?;
        values.sort_unstable_by(f64::total_cmp);
        Ok(Sample { values, weights: None })
    }

    /// Makes a sample of values from importance sampling, with a weight for each value.
    ///
    /// # Errors
    /// Fails like [`Sample::new`], and if the number of weights differs, a weight is negative, or all weights are zero.
    pub fn weighted(values: &[f64], weights: &[f64]) -> Result<Sample, SampleError> {
        check(values)?;
        if values.len() != weights.len() {
            let (values, weights) = (values.len(), weights.len());
            return Err(SampleError::Unequal { values, weights });
        }
        check(weights)?;
        if let Some(place) = weights.iter().position(|weight| *weight < 0.0) {
            return Err(SampleError::BadWeights { place });
        }
        let mut pairs: Vec<(f64, f64)> =
            values.iter().copied().zip(weights.iter().copied()).collect();
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (values, each): (Vec<f64>, Vec<f64>) = pairs.into_iter().unzip();
        let sum: f64 = each.iter().sum();
        if sum <= 0.0 {
            return Err(SampleError::BadWeights { place: 0 });
        }
        let sum_of_squares = each.iter().map(|weight| weight * weight).sum();
        Ok(Sample { values, weights: Some(Weights { each, sum, sum_of_squares }) })
    }

    /// Number of values.
    #[must_use]
    pub fn count(&self) -> usize {
        self.values.len()
    }

    /// The values, ascending.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Smallest value.
    #[must_use]
    pub fn least(&self) -> f64 {
        self.values[0]
    }

    /// Largest value.
    #[must_use]
    pub fn largest(&self) -> f64 {
        self.values[self.values.len() - 1]
    }

    /// Whether runs have weights.
    #[must_use]
    pub fn is_weighted(&self) -> bool {
        self.weights.is_some()
    }

    /// The weights in the order of the values; `None` if all are 1.
    pub(super) fn weights(&self) -> Option<&[f64]> {
        self.weights.as_ref().map(|weights| weights.each.as_slice())
    }

    /// The sum of the weights; for a sample without weights, the number of its values.
    pub(super) fn weight_sum(&self) -> f64 {
        self.weights.as_ref().map_or(self.count() as f64, |weights| weights.sum)
    }

    /// Effective size: the number of runs of equal weight that would give the same variance of a mean (Kish 1965),
    /// (Σw)²/Σw².
    #[must_use]
    pub fn effective_size(&self) -> f64 {
        match &self.weights {
            None => self.count() as f64,
            Some(weights) => weights.sum * weights.sum / weights.sum_of_squares,
        }
    }

    /// Number of values at or below `value`.
    pub(crate) fn count_to(&self, value: f64) -> usize {
        self.values.partition_point(|own| *own <= value)
    }
}

fn check(values: &[f64]) -> Result<(), SampleError> {
    if values.len() < FEWEST {
        return Err(SampleError::TooFew { count: values.len(), needed: FEWEST });
    }
    match values.iter().position(|value| !value.is_finite()) {
        Some(place) => Err(SampleError::NotFinite { place }),
        None => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_effective_size_of_equal_weights_is_the_number_of_runs() {
        let values = [3.0, 1.0, 2.0];
        let size = |weights: &[f64]| Sample::weighted(&values, weights).unwrap().effective_size();
        assert!((size(&[2.0, 2.0, 2.0]) - 3.0).abs() < 1e-12);
        assert!((size(&[1.0, 0.0, 0.0]) - 1.0).abs() < 1e-12);
    }

    #[test]
    fn values_that_make_no_sample_are_refused() {
        assert!(matches!(Sample::new(vec![1.0]), Err(SampleError::TooFew { count: 1, .. })));
        assert_eq!(Sample::new(vec![1.0, f64::NAN]), Err(SampleError::NotFinite { place: 1 }));
        let weighted = |weights: &[f64]| Sample::weighted(&[1.0, 2.0], weights);
        assert_eq!(weighted(&[1.0, -1.0]), Err(SampleError::BadWeights { place: 1 }));
        assert_eq!(weighted(&[0.0, 0.0]), Err(SampleError::BadWeights { place: 0 }));
        assert!(matches!(weighted(&[1.0]), Err(SampleError::Unequal { .. })));
    }
}
