//! Distributions with their parameters.

use crate::statistics::normal;

/// A distribution.
///
/// The shape ξ of [`Distribution::Gev`] and [`Distribution::Pareto`] is positive for a heavy tail (Coles 2001); SciPy's
/// `genextreme` has the opposite sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Distribution {
    /// Mean and standard deviation.
    Normal {
        /// Mean.
        mean: f64,
        /// Standard deviation.
        deviation: f64,
    },
    /// Lognormal distribution, by mean and standard deviation of the logarithm.
    LogNormal {
        /// Mean of ln x.
        mu: f64,
        /// Standard deviation of ln x.
        sigma: f64,
    },
    /// Weibull distribution with two parameters: the probability to exceed x is exp(−(x/scale)^shape).
    Weibull {
        /// Shape.
        shape: f64,
        /// Scale.
        scale: f64,
    },
    /// Gumbel distribution of maxima: the probability to be below x is exp(−exp(−(x − location)/scale)).
    Gumbel {
        /// Location.
        location: f64,
        /// Scale.
        scale: f64,
    },
    /// Generalised extreme value distribution: the probability to be below x is exp(−(1 + ξ(x −
    /// location)/scale)^(−1/ξ)).
    Gev {
        /// Location.
        location: f64,
        /// Scale.
        scale: f64,
        /// Shape ξ.
        shape: f64,
    },
    /// Generalised Pareto distribution over a threshold: the probability to exceed x is share × (1 + ξ(x −
    /// threshold)/scale)^(−1/ξ).
    Pareto {
        /// Threshold.
        threshold: f64,
        /// Probability that a value lies above the threshold.
        share: f64,
        /// Scale.
        scale: f64,
        /// Shape ξ.
        shape: f64,
    },
}

/// For shapes ξ nearer to 0 than this number, the limiting law for ξ = 0 is used (Gumbel, exponential).
const NO_SHAPE: f64 = 1e-7;

impl Distribution {
    /// Probability to exceed `x`. The probability to exceed `x`. Below the threshold of [`Distribution::Pareto`], where
    /// the law has no values, the result is the probability to exceed the threshold.
    #[must_use]
    pub fn above(&self, x: f64) -> f64 {
        match *self {
            Distribution::Normal { mean, deviation } => normal::above((x - mean) / deviation),
            Distribution::LogNormal { mu, sigma } => match x > 0.0 {
                true => normal::above((libm::log(x) - mu) / sigma),
                false => 1.0,
            },
            Distribution::Weibull { shape, scale } => match x > 0.0 {
                true => libm::exp(-libm::pow(x / scale, shape)),
                false => 1.0,
            },
            Distribution::Gumbel { location, scale } => {
                -libm::expm1(-libm::exp(-(x - location) / scale))
            }
            Distribution::Gev { location, scale, shape } => {
                -libm::expm1(-tail((x - location) / scale, shape))
            }
            Distribution::Pareto { threshold, share, scale, shape } => match x > threshold {
                true => share * tail((x - threshold) / scale, shape),
                false => share,
            },
        }
    }

    /// Probability to be at most `x`; for [`Distribution::Pareto`], among values above the threshold.
    pub(super) fn below_of_fitted(&self, x: f64) -> f64 {
        match *self {
            Distribution::Normal { mean, deviation } => normal::below((x - mean) / deviation),
            Distribution::LogNormal { mu, sigma } => match x > 0.0 {
                true => normal::below((libm::log(x) - mu) / sigma),
                false => 0.0,
            },
            Distribution::Weibull { shape, scale } => match x > 0.0 {
                true => -libm::expm1(-libm::pow(x / scale, shape)),
                false => 0.0,
            },
            Distribution::Gumbel { location, scale } => {
                libm::exp(-libm::exp(-(x - location) / scale))
            }
            Distribution::Gev { location, scale, shape } => {
                libm::exp(-tail((x - location) / scale, shape))
            }
            Distribution::Pareto { share, .. } => 1.0 - self.above(x) / share,
        }
    }

    /// Probability to exceed `x`; for [`Distribution::Pareto`], among values above the threshold.
    pub(super) fn above_of_fitted(&self, x: f64) -> f64 {
        match self {
            Distribution::Pareto { share, .. } => self.above(x) / share,
            _ => self.above(x),
        }
    }

    /// The value that is exceeded with probability `p` between 0 and 1; `None` if this value lies below the threshold.
    #[must_use]
    pub fn value_exceeded(&self, p: f64) -> Option<f64> {
        Some(match *self {
            Distribution::Normal { mean, deviation } => {
                mean + deviation * normal::value_exceeded(p)
            }
            Distribution::LogNormal { mu, sigma } => {
                libm::exp(mu + sigma * normal::value_exceeded(p))
            }
            Distribution::Weibull { shape, scale } => scale * libm::pow(-libm::log(p), 1.0 / shape),
            Distribution::Gumbel { location, scale } => {
                location - scale * libm::log(-libm::log1p(-p))
            }
            Distribution::Gev { location, scale, shape } => {
                location + scale * of_tail(-libm::log1p(-p), shape)
            }
            Distribution::Pareto { threshold, share, scale, shape } if p < share => {
                threshold + scale * of_tail(p / share, shape)
            }
            Distribution::Pareto { .. } => return None,
        })
    }

    /// The threshold of the distribution, and the probability to exceed the threshold.
    #[must_use]
    pub fn threshold(&self) -> Option<(f64, f64)> {
        match *self {
            Distribution::Pareto { threshold, share, .. } => Some((threshold, share)),
            _ => None,
        }
    }

    /// Shape ξ of the tail, if the distribution has this parameter.
    pub(super) fn tail_shape(&self) -> Option<f64> {
        match *self {
            Distribution::Gev { shape, .. } | Distribution::Pareto { shape, .. } => Some(shape),
            _ => None,
        }
    }
}

/// The function (1 + ξz)^(−1/ξ), which is exp(−z) for ξ = 0; it is 0 beyond the upper end of the distribution, and
/// infinite below the lower end.
fn tail(z: f64, shape: f64) -> f64 {
    if shape.abs() < NO_SHAPE {
        return libm::exp(-z);
    }
    let inner = shape * z;
    if inner <= -1.0 {
        return if shape < 0.0 { 0.0 } else { f64::INFINITY };
    }
    libm::exp(-libm::log1p(inner) / shape)
}

/// The inverse of `tail`: the z for which `tail` gives t.
fn of_tail(t: f64, shape: f64) -> f64 {
    let log = -libm::log(t);
    if shape.abs() < NO_SHAPE { log } else { libm::expm1(shape * log) / shape }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Distribution; 7] = [
        Distribution::Normal { mean: 3.0, deviation: 2.0 },
        Distribution::LogNormal { mu: 1.0, sigma: 0.5 },
        Distribution::Weibull { shape: 1.6, scale: 8.0 },
        Distribution::Gumbel { location: 5.0, scale: 2.0 },
        Distribution::Gev { location: 5.0, scale: 2.0, shape: 0.2 },
        Distribution::Gev { location: 5.0, scale: 2.0, shape: -0.2 },
        Distribution::Pareto { threshold: 4.0, share: 0.2, scale: 2.0, shape: 0.1 },
    ];

    #[test]
    fn the_value_of_a_probability_is_exceeded_with_it() {
        for distribution in ALL {
            for p in [0.15, 0.01, 1e-4, 1e-9] {
                let x = distribution.value_exceeded(p).unwrap();
                assert!((distribution.above(x) / p - 1.0).abs() < 1e-6, "{distribution:?} {p}");
            }
        }
    }
}
