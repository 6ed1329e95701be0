//! Minimum, maximum and clamp with the same bits on every machine.
//!
//! `f64::min`, `f64::max` and `f64::clamp` do not specify which of −0 and +0 they return: x86 and ARM differ. The sign
//! of a zero propagates to angles, quotients, snapshots and printed tables. The functions of this module only compare
//! numbers. Of two equal numbers the functions of this module return the second number, so the order of the arguments
//! decides. The functions of this module take one instruction; the functions of `std`, which also handle NaN, take
//! three.

/// Returns the smaller of two numbers; returns `q` if the two are equal (`lesser(0.0, -0.0)` is −0) or one of them is
/// NaN.
#[inline(always)]
#[must_use]
pub fn lesser(p: f64, q: f64) -> f64 {
    if p < q { p } else { q }
}

/// Returns the larger of two numbers; returns `q` if the two are equal (`greater(-0.0, 0.0)` is +0) or one of them is
/// NaN.
#[inline(always)]
#[must_use]
pub fn greater(p: f64, q: f64) -> f64 {
    if p > q { p } else { q }
}

/// `value` clamped to `low..=high`. A value equal to a bound keeps the sign of its zero, and NaN stays NaN.
///
/// # Panics
/// Panics in a build with debug assertions if `low` is greater than `high` or one of them is NaN, because no value lies
/// between them.
#[inline(always)]
#[must_use]
pub fn bounded(value: f64, low: f64, high: f64) -> f64 {
    debug_assert!(low <= high, "no value lies from {low} to {high}");
    if value < low {
        low
    } else if value > high {
        high
    } else {
        value
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sign of a zero from `f64::min` and `f64::max` depended on the machine: x86 gave one sign, aarch64 the other.
    #[test]
    fn signed_zeros_compare_alike_on_every_machine() {
        // Hidden from the compiler, which would otherwise compute the result by its own rules.
        let [plus, minus] = core::hint::black_box([0.0, -0.0]);
        for second in [plus, minus] {
            for first in [plus, minus] {
                assert_eq!(lesser(first, second).to_bits(), second.to_bits());
                assert_eq!(greater(first, second).to_bits(), second.to_bits());
                assert_eq!(bounded(first, second, 1.0).to_bits(), first.to_bits());
                assert_eq!(bounded(first, -1.0, second).to_bits(), first.to_bits());
            }
        }
    }

    #[test]
    fn nan_as_first_argument_gives_the_second() {
        assert_eq!(lesser(f64::NAN, 1.0), 1.0);
        assert_eq!(greater(f64::NAN, 1.0), 1.0);
        assert!(greater(1.0, f64::NAN).is_nan());
        assert!(bounded(f64::NAN, 0.0, 1.0).is_nan());
    }
}
