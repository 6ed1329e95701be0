//! Mean, standard deviation and skewness with their standard errors.

use super::Sample;

/// A number with its standard error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured {
    /// The estimate.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
}

/// Moments of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// Mean. The standard error of the mean is s/√n; for weighted values it is that of the ratio Σwx/Σw, by
    /// linearisation.
    pub mean: Measured,
    /// Standard deviation, with divisor n − 1. The standard error of the deviation s is that of the variance, √((m₄ −
    /// s⁴(n−3)/(n−1))/n), divided by 2s; for weighted values n is the effective size.
    pub deviation: Measured,
    /// Skewness m₃/m₂^1.5, without correction of its bias.
    pub skewness: f64,
}

impl Moments {
    /// The moments of a sample.
    #[must_use]
    pub fn of(sample: &Sample) -> Moments {
        let sum = sample.weight_sum();
        let size = sample.effective_size();
        let each = |power: &dyn Fn(f64) -> f64| weighted_sum(sample, power) / sum;
        let mean = each(&|x| x);
        let variance = each(&|x| (x - mean) * (x - mean));
        let third = each(&|x| libm::pow(x - mean, 3.0));
        let fourth = each(&|x| libm::pow(x - mean, 4.0));
        let corrected = variance * size / (size - 1.0);
        let deviation = libm::sqrt(corrected);
        let mean_error = match sample.weights() {
            None => deviation / libm::sqrt(size),
            Some(weights) => {
                let squares = sample.values().iter().zip(weights);
                let squares: f64 = squares.map(|(x, w)| w * w * (x - mean) * (x - mean)).sum();
                libm::sqrt(squares) / sum
            }
        };
        let of_variance = (fourth - corrected * corrected * (size - 3.0) / (size - 1.0)) / size;
        let is_flat = deviation <= 0.0;
        Moments {
            mean: Measured { value: mean, error: mean_error },
            deviation: Measured {
                value: deviation,
                error: if is_flat || of_variance <= 0.0 {
                    0.0
                } else {
                    libm::sqrt(of_variance) / (2.0 * deviation)
                },
            },
            skewness: if is_flat { 0.0 } else { third / libm::pow(variance, 1.5) },
        }
    }
}

fn weighted_sum(sample: &Sample, of: &dyn Fn(f64) -> f64) -> f64 {
    match sample.weights() {
        None => sample.values().iter().map(|x| of(*x)).sum(),
        Some(weights) => sample.values().iter().zip(weights).map(|(x, w)| w * of(*x)).sum(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_weights_change_nothing() {
        let values = [1.0, 2.0, 4.0, 8.0, 16.0, 5.0];
        let plain = Moments::of(&Sample::new(values.to_vec()).unwrap());
        let weighted = Moments::of(&Sample::weighted(&values, &[1.0; 6]).unwrap());
        assert!((plain.mean.value - weighted.mean.value).abs() < 1e-14);
        assert!((plain.deviation.value - weighted.deviation.value).abs() < 1e-13);
        // Σ(x−m)²/n² in place of Σ(x−m)²/(n(n−1)).
        assert!((weighted.mean.error / plain.mean.error - libm::sqrt(5.0 / 6.0)).abs() < 1e-12);
    }

    /// `scipy.stats`: `x = [1,2,4,8,16,5]; np.mean(x), np.std(x, ddof=1), skew(x), sem(x)`.
    #[test]
    fn moments_agree_with_scipy() {
        let moments = Moments::of(&Sample::new(vec![1.0, 2.0, 4.0, 8.0, 16.0, 5.0]).unwrap());
        let close = |got: f64, want: f64| assert!((got / want - 1.0).abs() < 1e-12, "{got} {want}");
        close(moments.mean.value, 6.0);
        close(moments.deviation.value, 5.477_225_575_051_661);
        close(moments.skewness, 1.08);
        close(moments.mean.error, 2.236_067_977_499_79);
    }
}
