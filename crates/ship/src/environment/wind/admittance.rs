//! Gusts averaged over the front of a ship: the aerodynamic admittance.

/// Decay factor C of Davenport's coherence between two points of the wind, exp(−C f Δ/U), for distances Δ across the
/// wind, horizontal or vertical. The decay factor of 9.2 is twice the 4.6 of ASCE 7-22, section 26.11, and of EN
/// 1991-1-4, annex B, as printed in public programs.
const DECAY: f64 = 9.2;

/// The front that a ship turns to the wind.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WindFront {
    /// Width of the ship's front across the wind (m).
    pub width_m: f64,
    /// Height (m).
    pub height_m: f64,
}

impl WindFront {
    /// A front as small as a point, on which every gust acts in full.
    pub const POINT: WindFront = WindFront { width_m: 0.0, height_m: 0.0 };

    /// The share of a gust's amplitude that remains in the mean over the ship's front, for a frequency (Hz) and a mean
    /// wind (m/s). The share that remains is the root of the aerodynamic admittance χ² = R(C f b/U) R(C f h/U).
    ///
    /// R(a) = 2 (a − 1 + e⁻ᵃ)/a² is the closed integral of the coherence over all pairs of points of a line: (1/b²) ∬
    /// exp(−C f |y₁ − y₂|/U) dy₁ dy₂ with a = C f b/U. The function R is the same as R_h and R_b of EN 1991-1-4 (B.7,
    /// B.8) and R_ℓ of ASCE 7-22 (26.11-15), with η = a/2.
    #[must_use]
    pub fn share(&self, frequency_hz: f64, mean_mps: f64) -> f64 {
        let [width_s, height_s] = self.scales_s(mean_mps);
        (correlated(frequency_hz * width_s) * correlated(frequency_hz * height_s)).sqrt()
    }

    /// The times C b/U and C h/U for width b and height h of the front (s). Multiplied by a frequency, these two times
    /// are the arguments of the function R.
    pub(super) fn scales_s(&self, mean_mps: f64) -> [f64; 2] {
        [self.width_m, self.height_m].map(|length_m| DECAY * length_m / mean_mps)
    }
}

/// R(a).
fn correlated(a: f64) -> f64 {
    if a < 1e-3 {
        // Here the series is used, because the closed form loses digits.
        return 1.0 - a / 3.0 + a * a / 12.0;
    }
    2.0 * (a + libm::expm1(-a)) / (a * a)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The double integral of the coherence by the midpoint rule.
    #[test]
    fn the_admittance_of_a_line_is_the_integral_of_the_coherence() {
        for a in [1e-4, 0.5e-3, 2e-3, 0.1, 1.0, 7.0, 40.0] {
            const POINTS: u32 = 1500;
            let at = |k: u32| (f64::from(k) + 0.5) / f64::from(POINTS);
            let mut sum = 0.0;
            for i in 0..POINTS {
                for j in 0..POINTS {
                    sum += libm::exp(-a * (at(i) - at(j)).abs());
                }
            }
            let integral = sum / f64::from(POINTS * POINTS);
            // The kink on the diagonal gives the midpoint rule an error of a/6 over the square of the number of points.
            assert!((correlated(a) - integral).abs() < 1e-4, "{a}: {} {integral}", correlated(a));
        }
    }

    #[test]
    fn a_point_feels_every_gust_in_full_and_a_long_ship_little_of_the_short_ones() {
        assert_eq!(WindFront::POINT.share(0.5, 15.0), 1.0);
        let ship = WindFront { width_m: 300.0, height_m: 25.0 };
        assert!(ship.share(1e-3, 15.0) > 0.95);
        // By hand: a = 18.4 and 1.533, R = 0.1028 and 0.637.
        assert!((ship.share(0.1, 15.0) - 0.2559).abs() < 5e-4, "{}", ship.share(0.1, 15.0));
    }
}
