//! The retardation function K(t) = (2/π)∫B(ω) cos ωt dω of the damping B, and the added mass that follows from the
//! damping.

use core::f64::consts::{FRAC_2_PI, FRAC_PI_2};

use fenderline_contact::number::{greater, lesser};

use super::data::Hydrodynamics;
use super::matrix::{Matrix6, ZERO, plus};
use super::ogilvie::{change, integral};
use super::spline::Spline;
use super::unknown_damping::{FIRST_NODE, TAIL, unknown_damping};

/// Number of points of the fine frequency grid up to the last frequency of the hydrodynamic data, and beyond it.
const FINE: [usize; 2] = [400, 200];

/// Damping on a fine grid of frequencies: a cubic spline through the hydrodynamic data, and zero at zero frequency.
/// Below the first frequency of the data and beyond the last, the damping is the one that agrees best with the added
/// mass of the data (`unknown_damping`); at 1.5 times the last frequency it has faded. A reaction of the water that is
/// faster than the frequencies of the grid acts as mass (`effective_infinite`).
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
        let known = known_damping(data, &frequencies_radps);
        let unknown = unknown_damping(data, &frequencies_radps, &known);
        let damping = known.iter().zip(&unknown).map(|(known, rest)| plus(known, 1.0, rest));
        let damping = damping.collect();
        Retardation { frequencies_radps, damping }
    }

    /// The value of the retardation function K for two motions at a time (N/m, N, N·m).
    #[must_use]
    pub fn at(&self, row: usize, column: usize, t_s: f64) -> f64 {
        FRAC_2_PI
            * self.integral(|k| {
                self.damping[k][row][column] * libm::cos(self.frequencies_radps[k] * t_s)
            })
    }

    /// The damping for two motions at a frequency, linear on the fine grid.
    #[must_use]
    pub fn damping(&self, row: usize, column: usize, frequency_radps: f64) -> f64 {
        let axis = &self.frequencies_radps;
        let place = axis.partition_point(|w| *w < frequency_radps).clamp(1, axis.len() - 1);
        let share = (frequency_radps - axis[place - 1]) / (axis[place] - axis[place - 1]);
        let of = |k: usize| self.damping[k][row][column];
        of(place - 1) + lesser(share, 1.0) * (of(place) - of(place - 1))
    }

    /// The matrix of damping at a frequency, linear on the fine grid; zero beyond it.
    pub(super) fn damping_matrix(&self, frequency_radps: f64) -> Matrix6 {
        let end_radps = self.frequencies_radps[self.frequencies_radps.len() - 1];
        if frequency_radps >= end_radps {
            return ZERO;
        }
        std::array::from_fn(|i| std::array::from_fn(|j| self.damping(i, j, frequency_radps)))
    }

    /// The added mass for two motions, less the added mass at infinite frequency, computed from the damping B: A(ω) −
    /// A∞ = (2/π)∫(B(w) − B(ω))/(w² − ω²)dw. The integral for A(ω) − A∞ equals −(1/ω)∫K sin ωt dt (Ogilvie 1964), but
    /// has no singularity.
    #[must_use]
    pub fn added_mass_change(&self, row: usize, column: usize, frequency_radps: f64) -> f64 {
        change(&self.frequencies_radps, |k| self.damping[k][row][column], frequency_radps)
    }

    /// The matrices of added mass at some frequencies (rad/s), less the added mass at infinite frequency. Within the
    /// frequencies of the data these matrices are as the data have them; elsewhere they follow from the damping.
    pub(super) fn added_mass(
        &self,
        data: &Hydrodynamics,
        frequencies_radps: &[f64],
    ) -> Vec<Matrix6> {
        let axis = &data.frequencies_radps;
        let by_damping = |w: f64| -> Matrix6 {
            std::array::from_fn(|i| {
                std::array::from_fn(|j| match data.is_coupled(i, j) {
                    true => self.added_mass_change(i.min(j), i.max(j), w),
                    false => 0.0,
                })
            })
        };
        let spline = Spline::new(axis.clone(), data.added_mass.clone());
        let at = |w: &f64| match *w <= axis[0] || *w >= axis[axis.len() - 1] {
            true => by_damping(*w),
            false => plus(&spline.at(*w), -1.0, data.infinite()),
        };
        frequencies_radps.iter().map(at).collect()
    }

    /// Computes an integral over the frequency grid by the trapezoidal rule.
    fn integral(&self, of: impl Fn(usize) -> f64) -> f64 {
        integral(&self.frequencies_radps, of)
    }
}

/// Computes the effective added mass at infinite frequency. At each frequency of the data, A(ω) less the change that
/// follows from the damping by Ogilvie's relation gives a value for the effective added mass; the result is the median
/// of these values, up to where the damping has faded. The effective added mass differs from A∞ by the part of the
/// water's reaction that is faster than the data.
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

/// The damping of the hydrodynamic data at the frequencies of a grid (rad/s), as far as the data reach.
fn known_damping(data: &Hydrodynamics, grid_radps: &[f64]) -> Vec<Matrix6> {
    let spline = Spline::new(data.frequencies_radps.clone(), data.damping.clone());
    let last = data.frequencies_radps.len() - 1;
    let (first_radps, last_radps) = (data.frequencies_radps[0], data.frequencies_radps[last]);
    let at = |w: &f64| {
        if *w < first_radps {
            // Zero at zero frequency, with zero slope: such long waves carry no energy away.
            let t = w / first_radps;
            let (value, slope) = (t * t * (3.0 - 2.0 * t), t * t * (t - 1.0) * first_radps);
            let from_zero = plus(&ZERO, value, &data.damping[0]);
            return plus(&from_zero, slope, spline.first_slope());
        }
        if *w < last_radps {
            return spline.at(*w);
        }
        let share = greater(1.0 - (w / last_radps - 1.0) / (FIRST_NODE - 1.0), 0.0);
        data.damping[last].map(|row| row.map(|b| b * share))
    };
    grid_radps.iter().map(at).collect()
}

/// The ratio tan θ/θ, which is 1 at 0.
pub(super) fn tangent_ratio(theta: f64) -> f64 {
    debug_assert!(theta < FRAC_PI_2);
    if theta < 1e-4 { 1.0 + theta * theta / 3.0 } else { libm::tan(theta) / theta }
}
