//! Chooses the parameters at which the search for the likelihood's maximum begins.

use core::f64::consts::LN_2;

use super::{FitFault, Law};

/// Free parameters at which the search begins, and for each parameter the size of a change that matters.
pub(super) struct Start {
    pub(super) free: Vec<f64>,
    pub(super) scale: Vec<f64>,
}

/// Euler's constant.
const EULER: f64 = 0.577_215_664_901_532_9;

/// The start of the search for a law, from sorted values above the threshold.
pub(super) fn of(law: Law, values: &[f64]) -> Result<Start, FitFault> {
    let start = |free: Vec<f64>, scale: Vec<f64>| Start { free, scale };
    Ok(match law {
        Law::Normal => {
            let (mean, deviation) = moments(values.iter().copied());
            start(vec![mean, libm::log(deviation)], vec![deviation, 1.0])
        }
        Law::LogNormal => {
            let (mean, deviation) = moments(values.iter().map(|x| libm::log(*x)));
            start(vec![mean, libm::log(deviation)], vec![deviation, 1.0])
        }
        Law::Weibull => {
            // The logarithm of a Weibull variable is a Gumbel variable of minima.
            let (mean, deviation) = moments(values.iter().map(|x| libm::log(*x)));
            let shape = core::f64::consts::PI / (libm::sqrt(6.0) * deviation);
            start(vec![libm::log(shape), mean + EULER / shape], vec![1.0, 1.0 / shape])
        }
        Law::Gumbel => {
            let (mean, deviation) = moments(values.iter().copied());
            let scale = libm::sqrt(6.0) / core::f64::consts::PI * deviation;
            start(vec![mean - EULER * scale, libm::log(scale)], vec![scale, 1.0])
        }
        Law::Gev => gev(values),
        Law::Pareto => pareto(values),
    })
    .and_then(|start| match start.free.iter().all(|free| free.is_finite()) {
        true => Ok(start),
        false => Err(FitFault::Constant),
    })
}

/// Mean and standard deviation (with divisor n), which maximise the likelihood of a normal variable.
fn moments(values: impl Iterator<Item = f64> + Clone) -> (f64, f64) {
    let n = values.clone().count() as f64;
    let mean = values.clone().sum::<f64>() / n;
    let squares: f64 = values.map(|x| (x - mean) * (x - mean)).sum();
    (mean, libm::sqrt(squares / n))
}

/// The first three probability-weighted moments β of sorted values (Hosking, Wallis and Wood, Technometrics 27, 1985).
fn weighted_moments(values: &[f64]) -> [f64; 3] {
    let n = values.len() as f64;
    let mut sums = [0.0; 3];
    for (index, x) in values.iter().enumerate() {
        let i = index as f64;
        sums[0] += x;
        sums[1] += x * i / (n - 1.0);
        sums[2] += x * i * (i - 1.0) / ((n - 1.0) * (n - 2.0));
    }
    sums.map(|sum| sum / n)
}

fn gev(values: &[f64]) -> Start {
    let [b0, b1, b2] = weighted_moments(values);
    let c = (2.0 * b1 - b0) / (3.0 * b2 - b0) - LN_2 / libm::log(3.0);
    // Their k is −ξ.
    let k = 7.859 * c + 2.9554 * c * c;
    let k = if k.abs() < 1e-6 { 1e-6 } else { fenderline_contact::number::bounded(k, -0.45, 0.45) };
    let gamma = libm::tgamma(1.0 + k);
    let scale = (2.0 * b1 - b0) * k / (gamma * -libm::expm1(-k * LN_2));
    let location = b0 + scale * (gamma - 1.0) / k;
    feasible_gev(location, scale, -k, values)
}

/// Widens the law with which the search starts, until all values are possible under this law.
fn feasible_gev(location: f64, scale: f64, shape: f64, values: &[f64]) -> Start {
    let mut shape = shape;
    let possible = |shape: f64| {
        Law::Gev.log_likelihood(&[location, libm::log(scale), shape], values).is_finite()
    };
    while shape.abs() > 1e-3 && !possible(shape) {
        shape *= 0.7;
    }
    let shape = if possible(shape) { shape } else { 0.0 };
    Start { free: vec![location, libm::log(scale), shape], scale: vec![scale, 1.0, 1.0] }
}

fn pareto(values: &[f64]) -> Start {
    // Hosking and Wallis (Technometrics 29, 1987), with α₁ = β₀ − β₁.
    let [b0, b1, _] = weighted_moments(values);
    let a1 = b0 - b1;
    let mut shape = fenderline_contact::number::bounded(2.0 - b0 / (b0 - 2.0 * a1), -0.45, 0.45);
    let scale = b0 * (1.0 - shape);
    while shape < -1e-3
        && !Law::Pareto.log_likelihood(&[libm::log(scale), shape], values).is_finite()
    {
        shape *= 0.7;
    }
    let shape = if shape.is_finite() { shape } else { 0.0 };
    Start { free: vec![libm::log(scale), shape], scale: vec![1.0, 1.0] }
}

#[cfg(test)]
mod tests {
    use super::super::Distribution;
    use super::*;

    /// At its exact quantiles a sample gives back the distribution, to the coarseness of 2,000 values.
    #[test]
    fn the_start_is_near_the_law_of_the_values() {
        let law = Distribution::Gev { location: 5.0, scale: 2.0, shape: 0.15 };
        let values: Vec<f64> = (0..2000)
            .map(|i| law.value_exceeded(1.0 - (f64::from(i) + 0.5) / 2000.0).unwrap())
            .collect();
        let start = of(Law::Gev, &values).ok().unwrap();
        let want = [5.0, LN_2, 0.15];
        for (got, want) in start.free.iter().zip(want) {
            assert!((got - want).abs() < 0.05, "{:?}", start.free);
        }
    }
}
