//! Factor for the share of a wave that a ship of finite draught reflects: 1 in short waves, 0 in long waves.

use fenderline_contact::number::greater;

use core::f64::consts::PI;

use super::hull::DriftHull;

/// Factor on the longitudinal force of reflected waves, by the SNNM method of ITTC 7.5-04-01-01.1 (Liu & Papanikolaou,
/// "Regression analysis of experimental data for added resistance in waves of arbitrary heading and development of a
/// semi-empirical formula", Ocean Engineering 206, 2020, 107357; as in two public programs): α_T = 1 − exp(−4π(T/λ −
/// T/(2.5 L))), and 0 for waves of a length λ of 2.5 L or more.
pub(super) fn along(hull: &DriftHull, number_radpm: f64) -> f64 {
    let least_radpm = 2.0 * PI / (2.5 * hull.length_m);
    let beyond_radpm = greater(number_radpm - least_radpm, 0.0);
    -libm::expm1(-2.0 * hull.draught_m * beyond_radpm)
}

/// Factor on the lateral force of reflected waves, by Fujii & Takahashi ("Experimental study on the resistance increase
/// of a ship in regular oblique waves", 14th ITTC, 1975; as in STAWAVE-2 of ISO 15016): α = π²I₁²/(π²I₁² + K₁²) with
/// the Bessel functions at 1.5 kT, from Ursell's barrier of finite depth (1947).
pub(super) fn across(draught_m: f64, number_radpm: f64) -> f64 {
    let x = 1.5 * number_radpm * draught_m;
    // The factor is 1 to rounding from here on, as K₁/πI₁ falls as e^(−2x).
    if x > 20.0 {
        return 1.0;
    }
    let ratio = bessel_k1(x) / (PI * bessel_i1(x));
    1.0 / (1.0 + ratio * ratio)
}

/// The Bessel function I₁(x) for 0 ≤ x ≤ 20, by its power series.
fn bessel_i1(x: f64) -> f64 {
    let quarter = 0.25 * x * x;
    let (mut term, mut sum, mut n) = (0.5 * x, 0.0, 1.0);
    while term > 1e-17 * sum {
        sum += term;
        term *= quarter / (n * (n + 1.0));
        n += 1.0;
    }
    sum
}

/// The Bessel function K₁(x) for x > 0, by Abramowitz & Stegun 9.8.7 and 9.8.8, to 3e-7.
fn bessel_k1(x: f64) -> f64 {
    if x <= 2.0 {
        let t = 0.25 * x * x;
        let series = polynomial(
            t,
            &[
                1.0,
                0.154_431_44,
                -0.672_785_79,
                -0.181_568_97,
                -0.019_194_02,
                -0.001_104_04,
                -0.000_046_86,
            ],
        );
        return libm::log(0.5 * x) * bessel_i1(x) + series / x;
    }
    let series = polynomial(
        2.0 / x,
        &[
            1.253_314_14,
            0.234_986_19,
            -0.036_556_20,
            0.015_042_68,
            -0.007_803_53,
            0.003_256_14,
            -0.000_682_45,
        ],
    );
    libm::exp(-x) / x.sqrt() * series
}

fn polynomial(x: f64, coefficients: &[f64]) -> f64 {
    coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The expected values are from SciPy 1.x, `scipy.special.iv` and `kv`.
    #[test]
    fn bessel_functions_agree_with_scipy() {
        for (x, i1, k1) in TABLE {
            assert!((bessel_i1(x) / i1 - 1.0).abs() < 1e-12, "I1({x})");
            assert!((bessel_k1(x) / k1 - 1.0).abs() < 1e-6, "K1({x})");
        }
    }

    const TABLE: [(f64, f64, f64); 5] = [
        (0.1, 5.006_252_604_709_27e-2, 9.853_844_780_870_606),
        (0.5, 0.257_894_305_390_896_4, 1.656_441_120_003_301),
        (1.5, 0.981_666_428_577_907_8, 0.277_387_800_456_843_8),
        (2.5, 2.516_716_245_288_701, 7.389_081_634_774_708e-2),
        (10.0, 2_670.988_303_701_254, 1.864_877_345_382_559e-5),
    ];

    #[test]
    fn k1_is_continuous_between_its_branches() {
        let (below, above) = (bessel_k1(2.0), bessel_k1(2.0 + 1e-12));
        assert!((below / above - 1.0).abs() < 1e-6, "{below}, {above}");
    }
}
