//! The laws that can be fitted: their names, the values that they admit, their likelihoods and their free parameters.

use core::f64::consts::TAU;
use core::str::FromStr;

use super::Parameter;
use super::distribution::Distribution;
use super::error::FitFault;

/// A law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Law {
    /// Normal.
    Normal,
    /// Log-normal.
    LogNormal,
    /// Weibull with two parameters.
    Weibull,
    /// Gumbel of maxima.
    Gumbel,
    /// Generalised extreme values.
    Gev,
    /// Generalised Pareto over a threshold.
    Pareto,
}

/// Smallest number of values for fitting a law with two and with three parameters.
const FEWEST: [usize; 2] = [10, 20];

impl Law {
    /// All laws.
    pub const ALL: [Law; 6] =
        [Law::Normal, Law::LogNormal, Law::Weibull, Law::Gumbel, Law::Gev, Law::Pareto];

    /// The name of the law on the command line.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            Law::Normal => "normal",
            Law::LogNormal => "lognormal",
            Law::Weibull => "weibull",
            Law::Gumbel => "gumbel",
            Law::Gev => "gev",
            Law::Pareto => "gpd",
        }
    }

    /// The name for readers.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Law::Normal => "normal",
            Law::LogNormal => "log-normal",
            Law::Weibull => "Weibull",
            Law::Gumbel => "Gumbel",
            Law::Gev => "GEV",
            Law::Pareto => "GPD over threshold",
        }
    }

    /// Checks that the law can be fitted to the values.
    pub(super) fn admit(self, values: &[f64]) -> Result<(), FitFault> {
        let needed = FEWEST[usize::from(matches!(self, Law::Gev | Law::Pareto))];
        if values.len() < needed {
            return Err(FitFault::TooFew { count: values.len(), needed });
        }
        let (least, largest) = (values[0], values[values.len() - 1]);
        if matches!(self, Law::LogNormal | Law::Weibull) && least <= 0.0 {
            let count = values.partition_point(|value| *value <= 0.0);
            return Err(FitFault::NotPositive { least, count });
        }
        if least == largest { Err(FitFault::Constant) } else { Ok(()) }
    }

    /// Logarithm of the likelihood of values above the threshold; −∞ if the law does not allow a value. Free parameters
    /// are those of the law, with scales as their logarithms.
    pub(super) fn log_likelihood(self, free: &[f64], values: &[f64]) -> f64 {
        let n = values.len() as f64;
        match self {
            Law::Normal | Law::LogNormal => {
                let scale = libm::exp(-free[1]);
                let sum = |of: fn(f64) -> f64| {
                    values.iter().map(|x| square((of(*x) - free[0]) * scale)).sum::<f64>()
                };
                let logs = if self == Law::Normal { 0.0 } else { log_sum(values) };
                let squares = if self == Law::Normal { sum(|x| x) } else { sum(libm::log) };
                -n * (free[1] + 0.5 * libm::log(TAU)) - logs - 0.5 * squares
            }
            Law::Weibull => {
                let shape = libm::exp(free[0]);
                let each = |x: &f64| {
                    let power = shape * (libm::log(*x) - free[1]);
                    power - libm::log(*x) - libm::exp(power)
                };
                n * free[0] + values.iter().map(each).sum::<f64>()
            }
            Law::Gumbel => extreme(free[0], free[1], 0.0, values),
            Law::Gev => extreme(free[0], free[1], free[2], values),
            Law::Pareto => pareto(free[0], free[1], values),
        }
    }

    /// The distribution that has the given free parameters.
    pub(super) fn distribution(self, free: &[f64], place: Option<(f64, f64)>) -> Distribution {
        let scale = |index: usize| libm::exp(free[index]);
        match self {
            Law::Normal => Distribution::Normal { mean: free[0], deviation: scale(1) },
            Law::LogNormal => Distribution::LogNormal { mu: free[0], sigma: scale(1) },
            Law::Weibull => Distribution::Weibull { shape: scale(0), scale: scale(1) },
            Law::Gumbel => Distribution::Gumbel { location: free[0], scale: scale(1) },
            Law::Gev => Distribution::Gev { location: free[0], scale: scale(1), shape: free[2] },
            Law::Pareto => {
                let (threshold, share) = place.expect("a fit over a threshold has a threshold");
                Distribution::Pareto { threshold, share, scale: scale(0), shape: free[1] }
            }
        }
    }

    /// The parameters of the law with their standard errors.
    pub(super) fn parameters(
        self,
        free: &[f64],
        covariance: &[Vec<f64>],
        place: Option<(f64, f64)>,
    ) -> Vec<Parameter> {
        let error = |index: usize| libm::sqrt(covariance[index][index]);
        let plain =
            |name, index: usize| Parameter { name, value: free[index], error: error(index) };
        let scale = |name, index: usize| {
            let value = libm::exp(free[index]);
            Parameter { name, value, error: value * error(index) }
        };
        match self {
            Law::Normal => vec![plain("mean", 0), scale("deviation", 1)],
            Law::LogNormal => vec![plain("mu", 0), scale("sigma", 1)],
            Law::Weibull => vec![scale("shape", 0), scale("scale", 1)],
            Law::Gumbel => vec![plain("location", 0), scale("scale", 1)],
            Law::Gev => vec![plain("location", 0), scale("scale", 1), plain("shape", 2)],
            Law::Pareto => {
                let (value, _) = place.expect("a fit over a threshold has a threshold");
                let threshold = Parameter { name: "threshold", value, error: 0.0 };
                vec![threshold, scale("scale", 0), plain("shape", 1)]
            }
        }
    }
}

impl FromStr for Law {
    type Err = String;

    fn from_str(text: &str) -> Result<Law, String> {
        Law::ALL.into_iter().find(|law| law.key() == text).ok_or_else(|| {
            let keys = Law::ALL.map(Law::key);
            format!("`{text}` is no law; the laws are {}", keys.join(", "))
        })
    }
}

fn square(x: f64) -> f64 {
    x * x
}

fn log_sum(values: &[f64]) -> f64 {
    values.iter().map(|x| libm::log(*x)).sum()
}

/// Of generalised extreme values.
fn extreme(location: f64, log_scale: f64, shape: f64, values: &[f64]) -> f64 {
    let scale = libm::exp(-log_scale);
    let mut sum = -(values.len() as f64) * log_scale;
    for x in values {
        let z = (x - location) * scale;
        let log = match log_tail(z, shape) {
            Some(log) => log,
            None => return f64::NEG_INFINITY,
        };
        sum += (1.0 + shape) * log - libm::exp(log);
    }
    sum
}

/// Logarithm of the likelihood of the generalised Pareto distribution over 0.
fn pareto(log_scale: f64, shape: f64, values: &[f64]) -> f64 {
    let scale = libm::exp(-log_scale);
    let mut sum = -(values.len() as f64) * log_scale;
    for y in values {
        match log_tail(y * scale, shape) {
            Some(log) => sum += (1.0 + shape) * log,
            None => return f64::NEG_INFINITY,
        }
    }
    sum
}

/// The function −ln(1 + ξz)/ξ, which is −z for ξ = 0; `None` outside the range of the law.
fn log_tail(z: f64, shape: f64) -> Option<f64> {
    let inner = shape * z;
    if inner.abs() < 1e-8 {
        return Some(-z * (1.0 - 0.5 * inner));
    }
    (inner > -1.0).then(|| -libm::log1p(inner) / shape)
}
