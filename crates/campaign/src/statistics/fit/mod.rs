//! Fits distributions to a sample by maximum likelihood, and measures how good the fits are.
//!
//! All laws are fitted by Newton's method, from a start by moments or probability-weighted moments. The standard errors
//! come from the observed information. The bands of a quantile come from the delta method, on the quantile's logarithm
//! if the quantile is positive (Coles, An Introduction to Statistical Modeling of Extreme Values, 2001, 2.6 and 3.3). A
//! fit that fails is an error with its reason.

mod distribution;
mod error;
mod failed;
mod goodness;
mod laws;
mod newton;
mod start;

use super::{Confidence, Estimate, Interval, Sample};

pub use distribution::Distribution;
pub use error::FitFault;
pub use failed::FitError;
pub use laws::Law;
use newton::Maximum;

/// A parameter of a fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    /// Name of the parameter, such as `shape`.
    pub name: &'static str,
    /// The estimate, in the unit of the values if it has a unit.
    pub value: f64,
    /// Standard error of the parameter.
    pub error: f64,
}

/// A distribution fitted to a sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Fit {
    /// The law.
    pub law: Law,
    /// The fitted distribution.
    pub distribution: Distribution,
    /// Parameters of the fit.
    pub parameters: Vec<Parameter>,
    /// Number of values to which the law was fitted; for [`Law::Pareto`], the values above the threshold.
    pub count: usize,
    /// Logarithm of the likelihood.
    pub log_likelihood: f64,
    /// Akaike's criterion, 2k − 2 ln L. The criterion of [`Law::Pareto`] is for the values above its threshold alone,
    /// and cannot be compared with other laws.
    pub aic: f64,
    /// Kolmogorov and Smirnov's distance: the largest difference between the distribution functions of the sample and
    /// of the law.
    pub kolmogorov: f64,
    /// Anderson and Darling's A², which weights the tails.
    pub anderson_darling: f64,
    /// Number of Newton steps with all values, until the likelihood could rise by no more than 10⁻⁹ √n.
    pub steps: usize,
    /// Covariance of the free parameters, in the form that the optimiser uses.
    covariance: Vec<Vec<f64>>,
    /// The free parameters.
    free: Vec<f64>,
    /// Variance of the share of values above the threshold; 0 if there is no threshold.
    share_variance: f64,
}

/// Fits a law to a sample; `threshold` is the threshold of [`Law::Pareto`], which takes the values above the threshold.
///
/// # Errors
/// Fails if the sample has weights or too few values, if the law does not have the values, if the threshold is missing,
/// or if the likelihood has no regular maximum.
pub fn fit(law: Law, sample: &Sample, threshold: Option<f64>) -> Result<Fit, FitError> {
    let fail = |fault: FitFault| FitError { law, fault };
    if sample.is_weighted() {
        return Err(fail(FitFault::Weighted));
    }
    let threshold = match (law, threshold) {
        (Law::Pareto, None) => return Err(fail(FitFault::NoThreshold)),
        (Law::Pareto, Some(threshold)) => Some(threshold),
        _ => None,
    };
    let values = match threshold {
        Some(threshold) => &sample.values()[sample.count_to(threshold)..],
        None => sample.values(),
    };
    law.admit(values).map_err(fail)?;
    // Values above the threshold; the library of laws has the threshold at 0.
    let shifted: Vec<f64> = values.iter().map(|x| x - threshold.unwrap_or(0.0)).collect();
    let share = values.len() as f64 / sample.count() as f64;
    let place = threshold.map(|threshold| (threshold, share));
    let log_likelihood = |free: &[f64]| law.log_likelihood(free, &shifted);
    let Maximum { at, value, covariance, steps } =
        match maximum_from_few(law, &shifted, &log_likelihood) {
            Some(found) => found,
            None => {
                let start = start::of(law, &shifted).map_err(fail)?;
                newton::maximise(&start.free, &start.scale, values.len(), &log_likelihood)
                    .map_err(fail)?
            }
        };
    let distribution = law.distribution(&at, place);
    if let Some(shape) = distribution.tail_shape().filter(|shape| *shape <= -0.5) {
        return Err(fail(FitFault::Irregular { shape }));
    }
    let (kolmogorov, anderson_darling) = goodness::distances(values, &distribution);
    Ok(Fit {
        law,
        parameters: law.parameters(&at, &covariance, place),
        count: values.len(),
        log_likelihood: value,
        aic: 2.0 * at.len() as f64 - 2.0 * value,
        kolmogorov,
        anderson_darling,
        steps,
        share_variance: threshold.map_or(0.0, |_| share * (1.0 - share) / sample.count() as f64),
        distribution,
        covariance,
        free: at,
    })
}

/// Number of values with which the fit of a long sample begins: these values are picked evenly from the sample.
const FEW: usize = 10_000;

/// Finds the maximum for a long sample, starting from the fit of few of its sorted values: most Newton steps are then
/// made with few values. `None` for a sample that is not long, or if the fit of few values is no good start, as when
/// its law cannot reach the sample's largest value.
fn maximum_from_few(
    law: Law,
    values: &[f64],
    log_likelihood: &dyn Fn(&[f64]) -> f64,
) -> Option<Maximum> {
    let stride = values.len() / FEW;
    if stride < 2 {
        return None;
    }
    // The middle values, which are near the means of their groups.
    let few: Vec<f64> = values.iter().copied().skip(stride / 2).step_by(stride).collect();
    let start = start::of(law, &few).ok()?;
    let of_few = |free: &[f64]| law.log_likelihood(free, &few);
    let near = newton::maximise(&start.free, &start.scale, few.len(), &of_few).ok()?;
    newton::maximise(&near.at, &start.scale, values.len(), log_likelihood).ok()
}

/// Kolmogorov's limit: for a sample of n values from a known law, √n times the distance of the sample from this law
/// exceeds this limit with a chance of 1 %.
const KOLMOGOROV_1_PER_CENT: f64 = 1.628;

impl Fit {
    /// Whether the data contradict the law: Kolmogorov's test at 1 %, with the limit of a law that is known beforehand.
    /// The true limit for a fitted law is lower. A law that is rejected here would therefore be rejected by stricter
    /// tests too, and a law that is not rejected here may still be wrong (Stephens, EDF statistics for goodness of fit,
    /// Journal of the American Statistical Association 69, 1974; we wrote the limit from memory).
    #[must_use]
    pub fn is_rejected(&self) -> bool {
        self.kolmogorov * libm::sqrt(self.count as f64) > KOLMOGOROV_1_PER_CENT
    }

    /// The value that is exceeded with probability `p`, with its band by the delta method. `None` if this value lies
    /// below the threshold of the fit, or is not finite.
    #[must_use]
    pub fn value_exceeded(&self, p: f64, confidence: Confidence) -> Option<Estimate> {
        let value = self.distribution.value_exceeded(p)?;
        let place = self.distribution.threshold();
        let at = |free: &[f64], share_change: f64| {
            let place = place.map(|(threshold, share)| (threshold, share + share_change));
            self.law.distribution(free, place).value_exceeded(p)
        };
        let slope = |index: usize| {
            let step = 1e-3 * libm::sqrt(self.covariance[index][index]);
            let moved = |by: f64| {
                let mut free = self.free.clone();
                free[index] += by;
                at(&free, 0.0)
            };
            Some((moved(step)? - moved(-step)?) / (2.0 * step))
        };
        let slopes: Vec<f64> = (0..self.free.len()).map(slope).collect::<Option<_>>()?;
        let mut variance = 0.0;
        for (row, a) in self.covariance.iter().zip(&slopes) {
            for (covariance, b) in row.iter().zip(&slopes) {
                variance += a * covariance * b;
            }
        }
        if self.share_variance > 0.0 {
            let step = 1e-3 * libm::sqrt(self.share_variance);
            let slope = (at(&self.free, step)? - value) / step;
            variance += slope * slope * self.share_variance;
        }
        if !(value.is_finite() && variance.is_finite()) {
            return None;
        }
        let half = confidence.normal_quantile() * libm::sqrt(variance);
        let interval = if value > 0.0 {
            let factor = libm::exp(half / value);
            Interval { low: value / factor, high: value * factor }
        } else {
            Interval { low: value - half, high: value + half }
        };
        interval.high.is_finite().then_some(Estimate { value, interval })
    }
}
