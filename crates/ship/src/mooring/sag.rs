//! The sag of a rope under its weight: a flat parabola.

/// The tension along the chord (N) of a rope with this weight (N). The ends are `distance_m` apart, `horizontal_m` of
/// it horizontally. `reach_m` gives the stretched length of the rope at a tension; it never falls as the tension rises.
/// `least_n` is the tension of the same rope without weight.
///
/// Solves S = c (1 + (W h/S)²/(24 T²)), where both sides are monotonic in T, so that bisection finds the only solution.
/// The weight per length of the chord is that of the stretched rope, W/S. With W/c instead, the tension of a rope with
/// 0.5 % of slack would be 0.5 % too large.
pub(super) fn sagging_tension_n(
    reach_m: impl Fn(f64) -> f64,
    weight_n: f64,
    [distance_m, horizontal_m]: [f64; 2],
    least_n: f64,
) -> f64 {
    let across_n = weight_n * horizontal_m / distance_m;
    if distance_m <= 0.0 || across_n <= 0.0 {
        return least_n;
    }
    // True if the rope at this tension is too short for its sag.
    let is_short = |tension_n: f64| {
        let stretched_m = reach_m(tension_n);
        let share = across_n * distance_m / (stretched_m * tension_n);
        stretched_m < distance_m * (1.0 + share * share / 24.0)
    };
    // The search starts at the tension without weight: a rope with weight has at least this tension.
    let (mut low_n, mut high_n) = (least_n, least_n + 0.25 * across_n);
    while is_short(high_n) {
        low_n = high_n;
        high_n *= 2.0;
    }
    for _ in 0..60 {
        let middle_n = low_n.midpoint(high_n);
        if middle_n > 0.0 && is_short(middle_n) {
            low_n = middle_n;
        } else {
            high_n = middle_n;
        }
    }
    high_n
}
