//! The retardation function K(t) = (2/π)∫B(ω) cos ωt dω, and the added mass that follows from the damping.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

use fenderline_contact::number::lesser;

use super::data::Hydrodynamics;
use super::matrix::{Matrix6, ZERO};

/// Number of points of the fine grid up to the last frequency of the data, and beyond it.
const FINE: [usize; 2] = [400, 200];
/// End of the tail, over the last frequency of the data.
pub(super) const TAIL: f64 = 1.5;

/// Damping on a fine grid of frequencies: cubic between the data, zero at zero frequency. Beyond the last frequency of
/// the data it fades to zero over half of this frequency. A reaction of the water that is faster acts as mass
/// (`effective_infinite`).
#[derive(Clone, Debug)]
pub struct Retardation {
    frequencies_radps: Vec<f64>,
    damping: Vec<Matrix6>,
}

impl Retardation {
    pub(super) fn new(data: &Hydrodynamics) -> Retardation {
        let last_radps = data.frequencies_radps[data.frequencies_radps.len() - 1];
        let fine = (0..=FINE[0]).map(|k| last_radps * k as f64 / FINE[0] as f64);
        let tail =
            (1..=FINE[1]).map(|k| last_radps * (1.0 + (TAIL - 1.0) * k as f64 / FINE[1] as f64));
        let frequencies_radps: Vec<f64> = fine.chain(tail).collect();
        let damping = frequencies_radps.iter().map(|w| damping_at(data, *w)).collect();
        Retardation { frequencies_radps, damping }
    }

    /// The value of K for two motions at a time (N/m, N, N·m).
    #[must_use]
    pub fn at(&self, row: usize, column: usize, t_s: f64) -> f64 {
        FRAC_2_PI
            * self.integral(|k| {
                self.damping[k][row][column] * libm::cos(self.frequencies_radps[k] * t_s)
            })
    }

    /// The damping of two motions at a frequency, linear on the fine grid.
    #[must_use]
    pub fn damping(&self, row: usize, column: usize, frequency_radps: f64) -> f64 {
        let axis = &self.frequencies_radps;
        let place = axis.partition_point(|w| *w < frequency_radps).clamp(1, axis.len() - 1);
        let share = (frequency_radps - axis[place - 1]) / (axis[place] - axis[place - 1]);
        let of = |k: usize| self.damping[k][row][column];
        of(place - 1) + lesser(share, 1.0) * (of(place) - of(place - 1))
    }

    /// The added mass of two motions, less the added mass at infinite frequency, computed from the damping: A(ω) − A∞ =
    /// (2/π)∫(B(w) − B(ω))/(w² − ω²)dw. This is −(1/ω)∫K sin ωt dt (Ogilvie 1964), but without the singularity.
    #[must_use]
    pub fn added_mass_change(&self, row: usize, column: usize, frequency_radps: f64) -> f64 {
        let of = |k: usize| self.damping[k][row][column];
        let w0 = frequency_radps;
        let axis = &self.frequencies_radps;
        let place = axis.partition_point(|w| *w < w0).clamp(1, axis.len() - 1);
        let share = lesser((w0 - axis[place - 1]) / (axis[place] - axis[place - 1]), 1.0);
        let own = of(place - 1) + share * (of(place) - of(place - 1));
        let slope = (of(place) - of(place - 1)) / (axis[place] - axis[place - 1]);
        let inner = self.integral(|k| {
            let square = axis[k] * axis[k] - w0 * w0;
            if square.abs() < 1e-9 * w0 * w0 { 0.5 * slope / w0 } else { (of(k) - own) / square }
        });
        // Beyond the grid, where the damping has faded, ∫ dw/(w² − ω²) is ln((W + ω)/(W − ω))/2ω.
        let end = axis[axis.len() - 1];
        let beyond = match own == 0.0 {
            true => 0.0,
            false => -own * libm::log((end + w0) / (end - w0).abs()) / (2.0 * w0),
        };
        FRAC_2_PI * (inner + beyond)
    }

    /// The integral over the grid by the trapezoidal rule.
    fn integral(&self, of: impl Fn(usize) -> f64) -> f64 {
        let axis = &self.frequencies_radps;
        let (mut sum, mut before) = (0.0, of(0));
        for k in 1..axis.len() {
            let now = of(k);
            sum += 0.5 * (before + now) * (axis[k] - axis[k - 1]);
            before = now;
        }
        sum
    }
}

/// The effective added mass at infinite frequency. At each frequency of the data, A(ω) less the change that follows
/// from the damping by Ogilvie's relation gives a value; the result is the median of these values, up to where the
/// damping has faded. The median differs from A∞ by the part of the water's reaction that is faster than the data.
pub(super) fn effective_infinite(data: &Hydrodynamics, retardation: &Retardation) -> Matrix6 {
    let of = |i: usize, j: usize| {
        let mut values: Vec<f64> = data
            .radiation()
            .map(|(w, added, _)| match data.is_coupled(i, j) {
                true => added[i][j] - retardation.added_mass_change(i, j, w),
                false => added[i][j],
            })
            .collect();
        values.sort_by(f64::total_cmp);
        values[values.len() / 2]
    };
    std::array::from_fn(|i| std::array::from_fn(|j| of(i.min(j), i.max(j))))
}

/// Damping at a frequency.
pub(super) fn damping_at(data: &Hydrodynamics, w: f64) -> Matrix6 {
    let axis = &data.frequencies_radps;
    let last = axis.len() - 1;
    if w >= axis[last] {
        let t = lesser((w / axis[last] - 1.0) / (TAIL - 1.0), 1.0);
        let share = 0.5 * (1.0 + libm::cos(PI * t));
        return data.damping[last].map(|row| row.map(|b| b * share));
    }
    // Zero at zero frequency, with zero slope: such long waves carry no energy away.
    interpolated(axis, |k| &data.damping[k], &ZERO, w)
}

/// A matrix interpolated on an axis, by cubics with the slopes of parabolas through three neighbours. At zero the
/// matrix is `zero`.
fn interpolated<'m>(
    axis: &[f64],
    matrix: impl Fn(usize) -> &'m Matrix6,
    zero: &'m Matrix6,
    w: f64,
) -> Matrix6 {
    // Index 0 stands for zero frequency.
    let at = |k: usize| if k == 0 { 0.0 } else { axis[k - 1] };
    let of = |k: usize| if k == 0 { zero } else { matrix(k - 1) };
    let last = axis.len();
    let low = (0..last).rfind(|&k| at(k) <= w).unwrap_or(0);
    let width = at(low + 1) - at(low);
    let t = (w - at(low)) / width;
    let basis = [
        (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t),
        t * (1.0 - t) * (1.0 - t) * width,
        t * t * (3.0 - 2.0 * t),
        t * t * (t - 1.0) * width,
    ];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let value = |k: usize| of(k)[i][j];
            let slope = |k: usize| {
                if k == 0 {
                    return 0.0;
                }
                if k == last {
                    return (value(k) - value(k - 1)) / (at(k) - at(k - 1));
                }
                let (before, after) = (at(k) - at(k - 1), at(k + 1) - at(k));
                let (left, right) =
                    ((value(k) - value(k - 1)) / before, (value(k + 1) - value(k)) / after);
                (left * after + right * before) / (before + after)
            };
            basis[0] * value(low)
                + basis[1] * slope(low)
                + basis[2] * value(low + 1)
                + basis[3] * slope(low + 1)
        })
    })
}

/// The ratio tan θ/θ, which is 1 at 0.
pub(super) fn tangent_ratio(theta: f64) -> f64 {
    debug_assert!(theta < FRAC_PI_2);
    if theta < 1e-4 { 1.0 + theta * theta / 3.0 } else { libm::tan(theta) / theta }
}
