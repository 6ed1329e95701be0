//! Finds the root of a function within a bracket.

/// Finds the root of an increasing function in [low, high] with f(low) ≤ 0 ≤ f(high), by Newton's method safeguarded by
/// bisection, with at most 200 evaluations. The function `f` returns its value and its slope.
pub(super) fn root(f: impl Fn(f64) -> (f64, f64), mut low: f64, mut high: f64) -> f64 {
    let mut x = low.midpoint(high);
    for _ in 0..200 {
        let (value, slope) = f(x);
        if value == 0.0 {
            return x;
        }
        if value < 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = x - value / slope;
        // The comparison is also false for NaN and infinity, which occur at zero slope.
        let next = if newton > low && newton < high { newton } else { low.midpoint(high) };
        if (next - x).abs() <= 4.0 * f64::EPSILON * x.abs() {
            return next;
        }
        x = next;
    }
    x
}
