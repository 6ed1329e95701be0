//! The sag of a mooring rope under its weight, as a flat parabola.

/// Finds the tension (N) along the chord of a rope of the given weight (N). The ends of the rope are `distance_m`
/// apart, and `horizontal_m` of this distance is horizontal. `reach_m` gives the stretched length of the rope at a
/// tension; this length never falls as the tension rises. `least_n` is the tension of the same rope without weight.
///
/// Solves S = c (1 + (W h/S)²/(24 T²)) for the tension T, where both sides are monotonic in T, so that bisection finds
/// the only solution (S stretched length, c distance of the ends, h its horizontal part, W weight). The weight per
/// length along the chord is taken as that of the stretched rope, W/S. With W/c (weight divided by the distance of the
/// ends) instead of W/S, the tension of a rope with 0.5 % of slack would be 0.5 % too large.
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
