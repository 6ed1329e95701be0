//! The Weibull distribution by its moments.

/// Range in which the shape of a Weibull law is searched.
const SHAPES: [f64; 2] = [0.1, 100.0];

/// The mean of a Weibull law of scale 1.
pub(super) fn mean(shape: f64) -> f64 {
    libm::tgamma(1.0 + 1.0 / shape)
}

/// Standard deviation over mean.
fn variation(shape: f64) -> f64 {
    let mean = mean(shape);
    libm::sqrt(libm::tgamma(1.0 + 2.0 / shape) / (mean * mean) - 1.0)
}

/// The shape of the Weibull law that has the given ratio of standard deviation to mean, found by bisection: the ratio
/// falls as the shape rises.
pub(super) fn shape_of(wanted: f64) -> Option<f64> {
    let [mut low, mut high] = SHAPES;
    if !(variation(high) <= wanted && wanted <= variation(low)) {
        return None;
    }
    // Each halving gains a bit; a number has 53 of them.
    for _ in 0..64 {
        let middle = 0.5 * (low + high);
        if variation(middle) > wanted {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(0.5 * (low + high))
}
