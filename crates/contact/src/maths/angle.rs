//! Computes the sine and the cosine of a heading.
//!
//! Every moving body needs the sine and the cosine of its heading in every step. The functions of `libm` would cost as
//! much as a whole stage of the step: they keep the relative accuracy of a sine near zero, which a rotation does not
//! need, and the compiler cannot inline them. The result has the same bits on every machine, because only sums,
//! products and a table are used. The compiler computes the table of sines and cosines from sums and products.

use core::f64::consts::{FRAC_1_SQRT_2, PI};

/// Largest angle for which the subtraction of table steps is exact (rad); beyond this angle `libm` is used.
const FARTHEST_RAD: f64 = 2e4;

/// Number of entries of the sine table in a full turn.
const STEPS: usize = 256;

/// The angle of one table step, as the sum of two numbers (rad). The first part of the angle has 33 bits, so that its
/// product with an integer of up to 20 bits is exact. The second part of the angle is the rest of the table step.
const STEP_RAD: f64 = 0.024_543_692_605_220_713;
const STEP_REST_RAD: f64 = 9.495_469_541_415_925e-13;

/// 1.5 · 2⁵². Adding 1.5 · 2⁵² to a number and subtracting it again rounds the number to the nearest integer. The
/// lowest bits of the sum also hold the rounded integer.
const TO_INTEGER: f64 = 6_755_399_441_055_744.0;

/// Sine and cosine of each table step. Mirrored entries of the table differ only in sign.
static TABLE: [(f64, f64); STEPS] = {
    const QUARTER: usize = STEPS / 4;
    const EIGHTH: usize = STEPS / 8;
    let mut table = [(0.0, 1.0); STEPS];
    let mut k = 0;
    while k < STEPS {
        let (sine, cosine) = match k % QUARTER {
            EIGHTH => (FRAC_1_SQRT_2, FRAC_1_SQRT_2),
            steps if steps < EIGHTH => by_series(steps as f64 * (PI / (STEPS / 2) as f64)),
            steps => {
                let (cosine, sine) =
                    by_series((QUARTER - steps) as f64 * (PI / (STEPS / 2) as f64));
                (sine, cosine)
            }
        };
        table[k] = match k / QUARTER {
            0 => (sine, cosine),
            1 => (cosine, -sine),
            2 => (-sine, -cosine),
            _ => (-cosine, sine),
        };
        k += 1;
    }
    table
};

/// Computes sine and cosine of an angle of at most an eighth of a turn, by Taylor series.
const fn by_series(angle_rad: f64) -> (f64, f64) {
    let square = angle_rad * angle_rad;
    // 1 − x²/(n(n − 1)) (1 − x²/((n − 2)(n − 3)) …): smallest terms first.
    let (mut sine, mut cosine) = (1.0, 1.0);
    let mut n = 20.0;
    while n > 0.0 {
        sine = 1.0 - square / (n * (n + 1.0)) * sine;
        cosine = 1.0 - square / (n * (n - 1.0)) * cosine;
        n -= 2.0;
    }
    (angle_rad * sine, cosine)
}

/// Computes sine and cosine of an angle, each within 2.3e-16: the values of the nearest table step are rotated by the
/// remaining angle.
#[inline(always)]
pub(crate) fn sin_cos(angle_rad: f64) -> (f64, f64) {
    if angle_rad.abs() > FARTHEST_RAD {
        return libm::sincos(angle_rad);
    }
    let shifted = angle_rad * ((STEPS / 2) as f64 / PI) + TO_INTEGER;
    let steps = shifted - TO_INTEGER;
    let (sine, cosine) = TABLE[shifted.to_bits() as usize % STEPS];
    let rest_rad = (angle_rad - steps * STEP_RAD) - steps * STEP_REST_RAD;
    // The remainder is at most half a table step: the terms left out are below 1e-17.
    let square = rest_rad * rest_rad;
    let along = square * (-1.0 / 2.0 + square * (1.0 / 24.0 - square * (1.0 / 720.0)));
    let across = rest_rad + rest_rad * (square * (-1.0 / 6.0 + square * (1.0 / 120.0)));
    (sine + (sine * along + cosine * across), cosine + (cosine * along - sine * across))
}

/// The largest tangent of a tilt for which [`tilt_rad`] uses the series.
const SMALL_TILT: f64 = 1.0 / 8.0;

/// Computes, to rounding, the angle (rad) whose tangent is `across / ahead`; both numbers must not be negative. A
/// hull's angle to a fender is mostly small, and for small angles the series costs a tenth of `libm`'s function.
#[inline(always)]
pub(crate) fn tilt_rad(across: f64, ahead: f64) -> f64 {
    if across <= SMALL_TILT * ahead && ahead > 0.0 {
        let tangent = across / ahead;
        let square = tangent * tangent;
        // The terms left out are below 3e-18 of the angle.
        let mut series = 1.0 / 17.0;
        for power in [15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0] {
            series = 1.0 / power - square * series;
        }
        return tangent - tangent * (square * series);
    }
    libm::atan2(across, ahead)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_near_libm(angle_rad: f64) {
        let ((sine, cosine), (sin, cos)) = (sin_cos(angle_rad), libm::sincos(angle_rad));
        assert!((sine - sin).abs() <= 2.3e-16, "{angle_rad}: {sine} for {sin}");
        assert!((cosine - cos).abs() <= 2.3e-16, "{angle_rad}: {cosine} for {cos}");
        assert!((sine * sine + cosine * cosine - 1.0).abs() <= 5e-16, "{angle_rad}");
    }

    /// Sine and cosine match to a unit in the last place.
    #[test]
    fn sine_and_cosine_match_libm() {
        for k in 0..200_000 {
            assert_near_libm(f64::from(k) * 1.000_37e-4 - 10.0);
        }
        for k in 0..100_000 {
            assert_near_libm(f64::from(k) * 0.400_123 - 2e4);
        }
    }

    #[test]
    fn half_table_steps_and_their_neighbours_match_libm() {
        for k in -4_000..4_000 {
            let angle_rad = f64::from(k) * 0.5 * (STEP_RAD + STEP_REST_RAD);
            for angle_rad in [angle_rad, angle_rad.next_up(), angle_rad.next_down()] {
                assert_near_libm(angle_rad);
            }
        }
    }

    #[test]
    fn negative_angles_mirror_positive_ones() {
        for k in 1..10_000 {
            let angle_rad = f64::from(k) * 1.234e-3;
            let ((sine, cosine), (other, same)) = (sin_cos(angle_rad), sin_cos(-angle_rad));
            assert_eq!((sine.to_bits(), cosine.to_bits()), ((-other).to_bits(), same.to_bits()));
        }
    }

    #[test]
    fn tilts_match_libm() {
        for k in 0..=100_000 {
            let across = f64::from(k) * 2e-6;
            let (ours, theirs) = (tilt_rad(3.0 * across, 3.0), libm::atan2(3.0 * across, 3.0));
            assert!((ours - theirs).abs() <= 3e-16 * theirs, "{across}: {ours} for {theirs}");
        }
        for (across, ahead) in [(0.0, 0.0), (1.0, 0.0), (1e-300, 0.0), (2.0, 1.0)] {
            assert_eq!(tilt_rad(across, ahead), libm::atan2(across, ahead));
        }
    }

    #[test]
    fn large_headings_match_libm() {
        for angle_rad in [FARTHEST_RAD, FARTHEST_RAD.next_up(), -3e9, 1e15] {
            assert_near_libm(angle_rad);
        }
    }
}
