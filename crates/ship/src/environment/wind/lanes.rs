//! Computes the sum of the gusts' harmonics, four harmonics at a time. The compiler makes vector instructions of the
//! loops over harmonics, because the loops call no functions of libm. The only branch in the functions for four
//! harmonics is the choice between two formulas. For the gusts on each ship, a sum of 200 harmonics is needed in each
//! step. With one call of libm's functions per harmonic, the sum of the gusts took half of the time of a whole
//! simulated berthing.
//!
//! The sums have the same bits on every machine, because the functions use only additions, multiplications, divisions
//! and square roots, in a fixed order.

use core::array::from_fn;

use crate::environment::harmonics::Harmonic;

/// Harmonics in a group.
const LANES: usize = 4;

pub(super) type Lanes = [f64; LANES];

/// Four harmonics of rising frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Group {
    frequency_hz: Lanes,
    amplitude: Lanes,
    /// Phases, in full turns.
    phase_turns: Lanes,
}

impl Group {
    /// Makes groups of four harmonics; the last group is filled up with harmonics of amplitude 0.
    pub(super) fn all(harmonics: &[Harmonic]) -> Vec<Group> {
        let group = |four: &[Harmonic]| {
            let last = four[four.len() - 1];
            let none = Harmonic { amplitude: 0.0, ..last };
            let of = |lane: usize| *four.get(lane).unwrap_or(&none);
            Group {
                frequency_hz: from_fn(|lane| of(lane).frequency),
                amplitude: from_fn(|lane| of(lane).amplitude),
                phase_turns: from_fn(|lane| of(lane).phase_rad / core::f64::consts::TAU),
            }
        };
        harmonics.chunks(LANES).map(group).collect()
    }

    #[inline(always)]
    fn cosines(&self, t_s: f64) -> Lanes {
        cos_of_turns(from_fn(|k| self.frequency_hz[k] * t_s + self.phase_turns[k]))
    }

    /// Values of the harmonics at a time.
    fn at(&self, t_s: f64) -> Lanes {
        let cosines = self.cosines(t_s);
        from_fn(|k| self.amplitude[k] * cosines[k])
    }

    /// The shares √(R(s₁ f) R(s₂ f)) of the harmonics that remain in the mean over a ship's front, with the function R
    /// of [`correlated`].
    fn shares(&self, scales_s: [f64; 2]) -> Lanes {
        let [one, two] =
            scales_s.map(|scale_s| correlated(from_fn(|k| scale_s * self.frequency_hz[k])));
        from_fn(|k| (one[k] * two[k]).sqrt())
    }

    /// The harmonics' amplitudes times the shares that remain in the mean over a ship's front.
    pub(super) fn reduced(&self, scales_s: [f64; 2]) -> Lanes {
        let shares = self.shares(scales_s);
        from_fn(|k| shares[k] * self.amplitude[k])
    }
}

/// Computes Σ a cos(2π f t + ε) over all harmonics.
pub(super) fn sum(groups: &[Group], t_s: f64) -> f64 {
    let add = |sums: Lanes, group: &Group| {
        let now = group.at(t_s);
        from_fn(|k| sums[k] + now[k])
    };
    total(groups.iter().fold([0.0; LANES], add))
}

/// Computes Σ √(R(s₁ f) R(s₂ f)) a cos(2π f t + ε) over all harmonics, with the function R of [`correlated`].
pub(super) fn sum_over(groups: &[Group], scales_s: [f64; 2], t_s: f64) -> f64 {
    let add = |sums: Lanes, group: &Group| {
        let (now, shares) = (group.at(t_s), group.shares(scales_s));
        from_fn(|k| sums[k] + shares[k] * now[k])
    };
    total(groups.iter().fold([0.0; LANES], add))
}

/// Computes Σ (Σ w b) cos(2π f t + ε) over all harmonics: the amplitude of each harmonic is a weighted sum over
/// `tables` of amplitudes b.
pub(super) fn sum_between<const N: usize>(
    groups: &[Group],
    tables: [&[Lanes]; N],
    weights: [f64; N],
    t_s: f64,
) -> f64 {
    // Slices of one length, so that the compiler checks no bounds per harmonic.
    let tables = tables.map(|table| &table[..groups.len()]);
    let mut sums = [0.0; LANES];
    for (index, group) in groups.iter().enumerate() {
        let mut amplitude = [0.0; LANES];
        for (table, weight) in tables.iter().zip(weights) {
            amplitude = from_fn(|k| amplitude[k] + weight * table[index][k]);
        }
        let cosines = group.cosines(t_s);
        sums = from_fn(|k| sums[k] + amplitude[k] * cosines[k]);
    }
    total(sums)
}

fn total([a, b, c, d]: Lanes) -> f64 {
    (a + c) + (b + d)
}

/// Computes R(a) = 2 (a − 1 + e⁻ᵃ)/a² for four numbers that are not negative and come in rising order.
fn correlated(a: Lanes) -> Lanes {
    if a[LANES - 1] < FEW {
        return by_series(a);
    }
    if a[0] >= FEW {
        return by_exponential(a);
    }
    let (series, closed) = (by_series(a), by_exponential(a));
    from_fn(|k| if a[k] < FEW { series[k] } else { closed[k] })
}

/// Below this value of a, R(a) is computed by its series, because the closed form loses digits.
const FEW: f64 = 0.5;

/// Coefficients 2(−1)ⁿ/(n+2)! of the series of R(a), the last first. The first term of R(a)'s series that is left out
/// is below 2e-16 at [`FEW`].
const SERIES: [f64; 13] = [
    2.0 / 87178291200.0,
    -2.0 / 6227020800.0,
    2.0 / 479001600.0,
    -2.0 / 39916800.0,
    2.0 / 3628800.0,
    -2.0 / 362880.0,
    2.0 / 40320.0,
    -2.0 / 5040.0,
    2.0 / 720.0,
    -2.0 / 120.0,
    2.0 / 24.0,
    -2.0 / 6.0,
    1.0,
];

#[inline(always)]
fn by_series(a: Lanes) -> Lanes {
    SERIES.iter().fold([0.0; LANES], |sum, term| from_fn(|k| sum[k] * a[k] + term))
}

#[inline(always)]
fn by_exponential(a: Lanes) -> Lanes {
    let exponentials = exp_of_minus(a);
    from_fn(|k| 2.0 * (a[k] - 1.0 + exponentials[k]) / (a[k] * a[k]))
}

/// A number for rounding: added to a number of up to 2⁵⁰, it leaves the nearest whole number in the last bits of the
/// sum.
const WHOLE: f64 = 6_755_399_441_055_744.0;

/// Coefficients 1/n! of the exponential's series, the last first. The first term of the exponential's series that is
/// left out is below 1e-17 at ½ ln 2.
const EXPONENTIAL: [f64; 14] = [
    1.0 / 6227020800.0,
    1.0 / 479001600.0,
    1.0 / 39916800.0,
    1.0 / 3628800.0,
    1.0 / 362880.0,
    1.0 / 40320.0,
    1.0 / 5040.0,
    1.0 / 720.0,
    1.0 / 120.0,
    1.0 / 24.0,
    1.0 / 6.0,
    1.0 / 2.0,
    1.0,
    1.0,
];

/// Computes e⁻ᵃ for four numbers that are not negative. For arguments beyond 700 the exponential at 700 is used, which
/// is negligible beside 1.
#[inline(always)]
fn exp_of_minus(a: Lanes) -> Lanes {
    // ln 2 in two parts, the first with few bits, as in libm's exp.
    const LN_2: [f64; 2] = [6.931_471_803_691_238e-1, 1.908_214_929_270_587_7e-10];
    let x: Lanes = from_fn(|k| -if a[k] < 700.0 { a[k] } else { 700.0 });
    let shifted: Lanes = from_fn(|k| x[k] * core::f64::consts::LOG2_E + WHOLE);
    let rest: Lanes = from_fn(|k| {
        let doublings = shifted[k] - WHOLE;
        x[k] - doublings * LN_2[0] - doublings * LN_2[1]
    });
    let power =
        EXPONENTIAL.iter().fold([0.0; LANES], |sum, term| from_fn(|k| sum[k] * rest[k] + term));
    from_fn(|k| {
        let exponent = (shifted[k].to_bits() << 52).wrapping_add(1023 << 52);
        power[k] * f64::from_bits(exponent)
    })
}

/// Coefficients (−1)ⁿ/(2n+1)! of the sine's series, the last first. The first term of the sine's series that is left
/// out is below 2e-18 at π/2.
const SINE: [f64; 11] = [
    1.0 / 51090942171709440000.0,
    -1.0 / 121645100408832000.0,
    1.0 / 355687428096000.0,
    -1.0 / 1307674368000.0,
    1.0 / 6227020800.0,
    -1.0 / 39916800.0,
    1.0 / 362880.0,
    -1.0 / 5040.0,
    1.0 / 120.0,
    -1.0 / 6.0,
    1.0,
];

/// Computes cos 2πx = 1 − 2 sin² πx, after x is reduced to within half a turn.
#[inline(always)]
fn cos_of_turns(turns: Lanes) -> Lanes {
    let half: Lanes = from_fn(|k| {
        let whole = (turns[k] + WHOLE) - WHOLE;
        (turns[k] - whole) * core::f64::consts::PI
    });
    let squares: Lanes = from_fn(|k| half[k] * half[k]);
    let over = SINE.iter().fold([0.0; LANES], |sum, term| from_fn(|k| sum[k] * squares[k] + term));
    from_fn(|k| {
        let sine = half[k] * over[k];
        1.0 - 2.0 * (sine * sine)
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::f64::consts::TAU;

    /// libm's cosine and exponential are right to their last bit or two. The tolerances are a few roundings of numbers
    /// of this size, including the angle after hours of gusts, 1e4 rad.
    #[test]
    fn cosine_and_exponential_are_those_of_libm() {
        for step in -20_000..=20_000 {
            let turns = f64::from(step) * 0.012_345_67;
            let [cosine, ..] = cos_of_turns([turns; LANES]);
            let off = cosine - libm::cos(TAU * turns);
            assert!(off.abs() < 1e-15 * (2.0 + TAU * turns.abs()), "{turns}: {off}");
        }
        for step in 0..7000 {
            let a = f64::from(step) * 0.1;
            let [power, ..] = exp_of_minus([a; LANES]);
            assert!((power / libm::exp(-a) - 1.0).abs() < 1e-15 * (2.0 + 0.2 * a), "{a}: {power}");
        }
        assert!(exp_of_minus([1e300; LANES])[0] < 1e-300);
    }

    /// The reference is the share of one harmonic in `admittance`. Below a = 1e-3 it takes three terms of the series;
    /// the next term is a³/60.
    #[test]
    fn the_share_is_that_of_the_closed_form_in_every_lane() {
        let front = super::super::WindFront { width_m: 200.0, height_m: 0.0 };
        for step in 0..4000 {
            let low = libm::exp(-12.0 + 0.006 * f64::from(step));
            let a = [low, 1.3 * low, 1.9 * low, 2.5 * low];
            let ours = correlated(a);
            for k in 0..LANES {
                // The frequency is chosen so that DECAY f b / U = a.
                let share = front.share(a[k] / (9.2 * 200.0), 1.0);
                let off = ours[k].sqrt() / share - 1.0;
                let most = if a[k] < 1e-3 { 1e-11 } else { 1e-12 };
                assert!(off.abs() < most, "{}: {off}", a[k]);
            }
        }
    }

    #[test]
    fn a_group_that_is_not_full_adds_its_own_harmonics_alone() {
        let harmonic = |k: u32| Harmonic {
            frequency: 0.01 * f64::from(k + 1),
            amplitude: 1.0 + f64::from(k),
            phase_rad: f64::from(k),
        };
        for count in 1..=9 {
            let harmonics: Vec<_> = (0..count).map(harmonic).collect();
            let groups = Group::all(&harmonics);
            for t_s in [0.0, 12.5, 3600.0] {
                let plain: f64 = harmonics
                    .iter()
                    .map(|h| h.amplitude * libm::cos(TAU * h.frequency * t_s + h.phase_rad))
                    .sum();
                assert!((sum(&groups, t_s) - plain).abs() < 1e-11, "{count} at {t_s} s");
                assert_eq!(sum_over(&groups, [0.0; 2], t_s), sum(&groups, t_s));
            }
        }
    }
}
