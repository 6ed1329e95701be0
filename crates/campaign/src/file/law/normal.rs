//! The standard normal distribution, computed by `libm`, so that draws have the same bits on every platform. Tests
//! compare it with the values of a library.

/// The distribution function Φ(x).
pub(super) fn cdf(x: f64) -> f64 {
    0.5 * libm::erfc(-x * core::f64::consts::FRAC_1_SQRT_2)
}

/// The standard normal quantile of a probability between 0 and 1, both excluded: a starting value by a rational
/// approximation with an error below 4.5e-4 (Abramowitz and Stegun, Handbook of Mathematical Functions, 26.2.23), made
/// exact by Halley's iteration on Φ. For probabilities above 1/2 the lower half of the distribution is mirrored, so
/// that the tail keeps its digits.
pub(super) fn quantile(p: f64) -> f64 {
    if p > 0.5 { -lower(1.0 - p) } else { lower(p) }
}

/// The standard normal quantile of a probability of at most 1/2.
fn lower(p: f64) -> f64 {
    let t = libm::sqrt(-2.0 * libm::log(p));
    let above = 2.515_517 + t * (0.802_853 + t * 0.010_328);
    let below = 1.0 + t * (1.432_788 + t * (0.189_269 + t * 0.001_308));
    let mut x = above / below - t;
    // The error after a step is the cube of the error before: two steps reach the last digits from 4.5e-4, the third
    // step is for the far tail.
    for _ in 0..3 {
        let density = libm::exp(-0.5 * x * x) / libm::sqrt(core::f64::consts::TAU);
        let newton = (cdf(x) - p) / density;
        x -= newton / (1.0 + 0.5 * x * newton);
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of `scipy.stats.norm.ppf`, SciPy 1.17.1.
    #[test]
    fn quantiles_of_scipy() {
        let known = [
            (0.5, 0.0),
            (0.975, 1.959_963_984_540_054),
            (0.841_344_746_068_542_9, 1.0),
            (0.999, 3.090_232_306_167_813),
            (1e-5, -4.264_890_793_922_825),
            (1e-12, -7.034_483_825_301_131),
            (1e-300, -37.047_096_299_361_2),
        ];
        for (p, x) in known {
            let own = quantile(p);
            assert!((own - x).abs() <= 4e-15 * (1.0 + x.abs()), "{p}: {own} for {x}");
        }
    }

    #[test]
    fn the_quantile_is_the_inverse_of_the_distribution_function() {
        for number in 1..1000 {
            let p = f64::from(number) / 1000.0;
            assert!((cdf(quantile(p)) - p).abs() < 1e-15, "{p}");
            assert!((quantile(p) + quantile(1.0 - p)).abs() < 1e-14, "{p}");
        }
    }
}
