//! Interpolates the forces of waves on a hull between the headings and frequencies of hydrodynamic data.
//!
//! **Headings.** The force of a wave is a sum over places x of the hull of e^{−ik·x}, with weights that do not depend
//! on the heading (Haskind's relation, from memory). The force of a wave therefore has few harmonics in the heading:
//! about kL/2. The force of a wave is interpolated with functions that belong to sources spread evenly over a disc: the
//! kernel is K(μ − μ′) = 2J₁(z)/z with z = 2b sin(½(μ − μ′)), and b is k times the radius of the disc. For headings at
//! equal steps the interpolation is nearly the trigonometric polynomial through the data. The number b is the largest
//! value that the widest step of the headings resolves. At the headings of the data the interpolated force is that of
//! the data.
//!
//! **Frequencies.** At one heading the phases of the forces on bow and stern turn by ±½L Δk cos μ from one frequency to
//! the next. For a long ship the phases at bow and stern turn fast with the frequency. The phases at bow and stern stay
//! the same at a heading at which the wave is as long along the ship as before. Forces at neighbouring frequencies are
//! therefore joined along the headings μᵢ with tan μᵢ = tan μ kᵢ/k: near the beam kᵢ cos μᵢ = k cos μ, and a wave from
//! ahead stays a wave from ahead. Along the joined headings the force is a cubic in the frequency, with the slopes of
//! parabolas through three neighbours. In mean drift the phases cancel for the most part, so that drift is interpolated
//! by a cubic at a constant heading.
//!
//! Phases of the forces are relative to the wave's crest at the centre of gravity. If the reference point of the data
//! is not the centre of gravity, the phase of the incident wave at the reference point is taken out first.

use core::f64::consts::{PI, TAU};

use fenderline_contact::number::greater;

use super::data::Hydrodynamics;
use super::matrix::Six;
use fenderline_ship::constants::STANDARD_GRAVITY_MPS2;
use fenderline_ship::environment::waves::{Complex, wave_number};

/// Signs of the six motions when port and starboard are mirrored.
pub(super) const MIRROR: Six = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];
/// Signs of surge, sway and yaw when port and starboard are mirrored.
pub(super) const MIRROR_DRIFT: [f64; 3] = [1.0, -1.0, -1.0];
/// Number of steps of the fine grid of headings in a half turn. Cubics between the headings of the fine grid have an
/// error within 0.1 % for 17 harmonics in the heading, and within 0.4 % for 25.
const FINE: usize = 120;
/// The bandwidth of the kernel, divided by the bandwidth that the widest step of the headings resolves (half a wave per
/// step).
const BAND: f64 = 0.9;
/// Small value that is added to the diagonal of the kernel's matrix. Without the value on the diagonal, headings very
/// near each other would make the kernel's matrix singular to rounding.
const RIDGE: f64 = 1e-10;

/// The fine grid of headings: equal steps from 0 to π for hydrodynamic data that are alike to both sides, otherwise
/// from −π all round. The fine grid has one extra row before the first heading and two after the last, so that cubics
/// can pass the ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct FineHeadings {
    pub(super) is_mirrored: bool,
}

/// A place of a heading on the fine grid of headings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FinePlace {
    /// Index of the first of the four rows around the place.
    row: usize,
    weights: [f64; 4],
    /// Sign of a mirrored number: −1 if the mirror image is used, else 1.
    side: f64,
}

impl FineHeadings {
    /// Number of rows.
    fn rows(self) -> usize {
        if self.is_mirrored { FINE + 4 } else { 2 * FINE + 3 }
    }

    /// The heading of a row of the fine grid (rad).
    pub(super) fn of_row(self, row: usize) -> f64 {
        let first_rad = if self.is_mirrored { 0.0 } else { -PI };
        first_rad + PI * (row as f64 - 1.0) / FINE as f64
    }

    /// The place of a heading (rad) on the fine grid.
    pub(super) fn place(self, towards_rad: f64) -> FinePlace {
        let angle_rad = libm::atan2(libm::sin(towards_rad), libm::cos(towards_rad));
        let (from_first, side) = match self.is_mirrored {
            true => (angle_rad.abs(), if angle_rad < 0.0 { -1.0 } else { 1.0 }),
            false => (angle_rad + PI, 1.0),
        };
        let steps = greater(from_first * FINE as f64 / PI, 0.0);
        let most = if self.is_mirrored { FINE } else { 2 * FINE - 1 };
        let row = (steps as usize).min(most);
        FinePlace { row, weights: cubic(steps - row as f64), side }
    }
}

impl FinePlace {
    /// Interpolates a number at a place of the fine grid from the rows around the place. `sign` is the sign that the
    /// number takes in the mirror image.
    pub(super) fn of<T>(&self, rows: &[T], sign: f64, of: impl Fn(&T) -> f64) -> f64 {
        let four = &rows[self.row..self.row + 4];
        let [a, b, c, d] = self.weights;
        let sum = a * of(&four[0]) + b * of(&four[1]) + c * of(&four[2]) + d * of(&four[3]);
        if self.side < 0.0 { sign * sum } else { sum }
    }
}

/// Weights of the four numbers at −1, 0, 1 and 2, in the value at `t` of the cubic through these numbers.
fn cubic(t: f64) -> [f64; 4] {
    let (before, after, far) = (t + 1.0, t - 1.0, t - 2.0);
    [
        -t * after * far / 6.0,
        before * after * far / 2.0,
        -before * t * far / 2.0,
        before * t * after / 6.0,
    ]
}

/// The wave forces of the hydrodynamic data, interpolated to the fine grid of headings.
#[derive(Clone, Debug)]
pub(super) struct Between<'d> {
    data: &'d Hydrodynamics,
    /// Wave number k at each frequency of the hydrodynamic data, in the depth of water of the data (rad/m).
    numbers_radpm: Vec<f64>,
    pub(super) headings: FineHeadings,
    /// Exciting force for each frequency of the data, at each heading of the fine grid.
    excitation: Vec<Vec<[Complex; 6]>>,
    /// Mean drift for each frequency of the data, at each heading of the fine grid; empty for data without drift.
    drift: Vec<Vec<[f64; 3]>>,
}

impl<'d> Between<'d> {
    pub(super) fn new(data: &'d Hydrodynamics) -> Between<'d> {
        let headings = FineHeadings { is_mirrored: data.is_mirrored };
        let weights = HeadingWeights::new(&data.headings_rad, headings);
        let count = data.headings_rad.len();
        let numbers_radpm: Vec<f64> =
            data.wave_frequencies_radps.iter().map(|w| data.wave_number(*w)).collect();
        let excitation = data
            .excitation
            .chunks(count)
            .zip(&numbers_radpm)
            .map(|(given, number)| {
                let at_gravity = data.about_gravity(given, *number);
                weights.spread(&at_gravity, MIRROR)
            })
            .collect();
        let drift = data
            .drift
            .iter()
            .flat_map(|drift| drift.chunks(count))
            .map(|given| weights.spread(given, MIRROR_DRIFT))
            .collect();
        Between { data, numbers_radpm, headings, excitation, drift }
    }

    /// Computes, at each fine heading, the exciting force in a wave of amplitude 1 m with its crest at the centre of
    /// gravity at time 0.
    pub(super) fn excitation(&self, frequency_radps: f64) -> Vec<[Complex; 6]> {
        let number = self.data.wave_number(frequency_radps);
        let parts = weights_of(&self.data.wave_frequencies_radps, frequency_radps);
        let is_held = parts.len() == 1;
        let row = |row: usize| {
            let towards_rad = self.headings.of_row(row);
            let (sin, cos) = (libm::sin(towards_rad), libm::cos(towards_rad));
            let mut sum = [Complex::default(); 6];
            for &(at, weight) in &parts {
                let there = match is_held {
                    true => self.headings.place(towards_rad),
                    false => {
                        self.headings.place(libm::atan2(sin * self.numbers_radpm[at], cos * number))
                    }
                };
                let rows = &self.excitation[at];
                for (k, sum) in sum.iter_mut().enumerate() {
                    sum.re += weight * there.of(rows, MIRROR[k], |force| force[k].re);
                    sum.im += weight * there.of(rows, MIRROR[k], |force| force[k].im);
                }
            }
            sum
        };
        (0..self.headings.rows()).map(row).collect()
    }

    /// Computes the mean drift divided by the square of the amplitude at each fine heading; zero for data without
    /// drift.
    pub(super) fn drift(&self, frequency_radps: f64) -> Vec<[f64; 3]> {
        let mut rows = vec![[0.0; 3]; self.headings.rows()];
        if self.drift.is_empty() {
            return rows;
        }
        for (at, weight) in weights_of(&self.data.wave_frequencies_radps, frequency_radps) {
            for (sum, given) in rows.iter_mut().zip(&self.drift[at]) {
                for (sum, given) in sum.iter_mut().zip(given) {
                    *sum += weight * given;
                }
            }
        }
        rows
    }

    /// The fine headings (rad).
    pub(super) fn fine_headings(&self) -> impl Iterator<Item = f64> {
        let headings = self.headings;
        (0..headings.rows()).map(move |row| headings.of_row(row))
    }
}

impl Hydrodynamics {
    /// The exciting force in a wave of amplitude 1 m with its crest at the centre of gravity at time 0, for any
    /// frequency (rad/s) and heading (rad; the direction towards which the wave runs, clockwise from the bow). Beyond
    /// the frequencies of the data the exciting force at the nearest frequency of the data is used.
    #[must_use]
    pub fn excitation_towards(&self, frequency_radps: f64, towards_rad: f64) -> [Complex; 6] {
        let between = Between::new(self);
        let rows = between.excitation(frequency_radps);
        let place = between.headings.place(towards_rad);
        std::array::from_fn(|k| {
            Complex::new(
                place.of(&rows, MIRROR[k], |force| force[k].re),
                place.of(&rows, MIRROR[k], |force| force[k].im),
            )
        })
    }

    /// The mean drift of the data divided by the square of the amplitude (surge and sway in N/m², yaw in N/m) in a wave
    /// of any frequency (rad/s) and heading, as for [`Hydrodynamics::excitation_towards`]; `None` where the data have
    /// no drift.
    #[must_use]
    pub fn drift_towards(&self, frequency_radps: f64, towards_rad: f64) -> Option<[f64; 3]> {
        self.drift.as_ref()?;
        let between = Between::new(self);
        let rows = between.drift(frequency_radps);
        let place = between.headings.place(towards_rad);
        Some(std::array::from_fn(|k| place.of(&rows, MIRROR_DRIFT[k], |drift| drift[k])))
    }

    /// Wave number k in the depth of water of the data (rad/m).
    pub(super) fn wave_number(&self, frequency_radps: f64) -> f64 {
        match self.depth_m {
            Some(depth_m) => wave_number(frequency_radps, depth_m),
            None => frequency_radps * frequency_radps / STANDARD_GRAVITY_MPS2,
        }
    }

    /// The forces of waves at the headings of the data. The forces have phases relative to the wave's crest at the
    /// centre of gravity, not at the reference point.
    fn about_gravity(&self, given: &[[Complex; 6]], number_radpm: f64) -> Vec<[Complex; 6]> {
        let turned = |(force, towards_rad): (&[Complex; 6], &f64)| {
            let along_m = self.origin_m.x * libm::cos(*towards_rad)
                + self.origin_m.y * libm::sin(*towards_rad);
            let phase = number_radpm * along_m;
            let turn = Complex::new(libm::cos(phase), -libm::sin(phase));
            force.map(|part| part * turn)
        };
        given.iter().zip(&self.headings_rad).map(turned).collect()
    }
}

/// A force or a drift at a heading, as a list of numbers.
trait Parts: Copy + Default {
    /// Adds another force or drift, multiplied by `weight`, to this list.
    fn add(&mut self, weight: f64, other: &Self);
}

impl Parts for Complex {
    fn add(&mut self, weight: f64, other: &Complex) {
        self.re += weight * other.re;
        self.im += weight * other.im;
    }
}

impl Parts for f64 {
    fn add(&mut self, weight: f64, other: &f64) {
        *self += weight * other;
    }
}

/// The weights of the headings of the hydrodynamic data, for each heading of the fine grid.
struct HeadingWeights {
    is_mirrored: bool,
    /// For each row of the fine grid, the weights of the headings all round: first the headings of the data, then their
    /// mirror images (without 0 and π) in reverse order.
    rows: Vec<Vec<f64>>,
}

impl HeadingWeights {
    fn new(given_rad: &[f64], fine: FineHeadings) -> HeadingWeights {
        let mut round_rad = given_rad.to_vec();
        if fine.is_mirrored {
            let inner = &given_rad[1..given_rad.len() - 1];
            round_rad.extend(inner.iter().rev().map(|heading| TAU - heading));
        } else if given_rad[given_rad.len() - 1] - given_rad[0] > TAU - 1e-6 {
            // Both ends are the same heading.
            round_rad.pop();
        }
        let band = BAND * PI / widest_step(given_rad, fine.is_mirrored);
        let matrix: Vec<Vec<f64>> = round_rad
            .iter()
            .enumerate()
            .map(|(row, one)| {
                let mut line: Vec<f64> =
                    round_rad.iter().map(|other| kernel(one - other, band)).collect();
                line[row] += RIDGE;
                line
            })
            .collect();
        let inverse = inverse(matrix);
        let rows = (0..fine.rows())
            .map(|row| {
                let to = fine.of_row(row);
                let near: Vec<f64> = round_rad.iter().map(|from| kernel(to - from, band)).collect();
                inverse
                    .iter()
                    .map(|line| line.iter().zip(&near).map(|(a, b)| a * b).sum())
                    .collect()
            })
            .collect();
        HeadingWeights { is_mirrored: fine.is_mirrored, rows }
    }

    /// Interpolates forces at the headings of the hydrodynamic data to the headings of the fine grid.
    fn spread<P: Parts, const N: usize>(&self, given: &[[P; N]], mirror: [f64; N]) -> Vec<[P; N]> {
        let images = if self.is_mirrored { &given[1..given.len() - 1] } else { &[] };
        let sum_of = |weights: &Vec<f64>| {
            let mut sum = [P::default(); N];
            let (own, of_images) = weights.split_at(given.len().min(weights.len()));
            for (weight, force) in own.iter().zip(given) {
                for (sum, part) in sum.iter_mut().zip(force) {
                    sum.add(*weight, part);
                }
            }
            for (weight, force) in of_images.iter().zip(images.iter().rev()) {
                for (k, part) in force.iter().enumerate() {
                    sum[k].add(weight * mirror[k], part);
                }
            }
            sum
        };
        self.rows.iter().map(sum_of).collect()
    }
}

/// The widest step between neighbouring headings of the hydrodynamic data, all round (rad).
pub(super) fn widest_step(headings_rad: &[f64], is_mirrored: bool) -> f64 {
    let inner = headings_rad.windows(2).map(|two| two[1] - two[0]).fold(0.0, greater);
    let [first, last] = [headings_rad[0], headings_rad[headings_rad.len() - 1]];
    if is_mirrored { inner } else { greater(inner, first + TAU - last) }
}

/// The kernel of the interpolation, 2J₁(z)/z with z = 2b sin(½δ).
fn kernel(off_rad: f64, band: f64) -> f64 {
    let z = 2.0 * band * libm::sin(0.5 * off_rad).abs();
    if z < 1e-4 { 1.0 - z * z / 8.0 } else { 2.0 * libm::j1(z) / z }
}

/// Inverts a symmetric positive matrix, by the method of Gauss and Jordan.
fn inverse(mut matrix: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let count = matrix.len();
    for (row, line) in matrix.iter_mut().enumerate() {
        line.extend((0..count).map(|column| f64::from(row == column)));
    }
    for column in 0..count {
        let pivot = matrix[column][column];
        debug_assert!(pivot > 0.0, "the kernel is positive");
        for value in &mut matrix[column][column..] {
            *value /= pivot;
        }
        let line = std::mem::take(&mut matrix[column]);
        for other in matrix.iter_mut().filter(|other| !other.is_empty()) {
            let factor = other[column];
            if factor != 0.0 {
                for (value, own) in other[column..].iter_mut().zip(&line[column..]) {
                    *value -= factor * own;
                }
            }
        }
        matrix[column] = line;
    }
    matrix.into_iter().map(|line| line[count..].to_vec()).collect()
}

/// Rows of an axis and their weights at a place on the axis, for a cubic that has the slopes of parabolas through three
/// neighbours. Beyond the ends of the axis, the first or the last row has all the weight.
fn weights_of(axis: &[f64], at: f64) -> Vec<(usize, f64)> {
    let last = axis.len() - 1;
    if at <= axis[0] || last == 0 {
        return vec![(0, 1.0)];
    }
    if at >= axis[last] {
        return vec![(last, 1.0)];
    }
    let low = axis.partition_point(|value| *value <= at) - 1;
    let width = axis[low + 1] - axis[low];
    let t = (at - axis[low]) / width;
    let first = low.saturating_sub(1);
    let mut parts: Vec<(usize, f64)> = (first..=last.min(low + 2)).map(|row| (row, 0.0)).collect();
    let mut add = |row: usize, weight: f64| parts[row - first].1 += weight;
    add(low, (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t));
    add(low + 1, t * t * (3.0 - 2.0 * t));
    let ends = [(low, t * (1.0 - t) * (1.0 - t) * width), (low + 1, t * t * (t - 1.0) * width)];
    for (row, weight) in ends {
        for (of, share) in slope_of(axis, row) {
            add(of, weight * share);
        }
    }
    parts
}

/// The slope at a row, as weights of the numbers of rows. The slope is that of the parabola through the row and its two
/// neighbours; at an end, through the row and the next two.
fn slope_of(axis: &[f64], row: usize) -> [(usize, f64); 3] {
    if axis.len() == 2 {
        let inverse = 1.0 / (axis[1] - axis[0]);
        return [(0, -inverse), (1, inverse), (row, 0.0)];
    }
    let first = row.saturating_sub(1).min(axis.len() - 3);
    let at = axis[row];
    let [a, b, c] = [axis[first], axis[first + 1], axis[first + 2]];
    [
        (first, (2.0 * at - b - c) / ((a - b) * (a - c))),
        (first + 1, (2.0 * at - a - c) / ((b - a) * (b - c))),
        (first + 2, (2.0 * at - a - b) / ((c - a) * (c - b))),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A row of sources along a ship of 285 m: the force of each has the phase of the wave there.
    fn of_sources(number_radpm: f64, towards_rad: f64) -> [Complex; 6] {
        let mut sum = [Complex::default(); 6];
        for k in 0..58 {
            let (x_m, y_m) = (5.0 * f64::from(k) - 142.5, if k % 2 == 0 { 20.0 } else { -20.0 });
            let phase =
                -number_radpm * (x_m * libm::cos(towards_rad) + y_m * libm::sin(towards_rad));
            let size = 1.0 + 0.3 * libm::sin(f64::from(k));
            for (part, arm) in sum.iter_mut().zip([1.0, y_m, x_m]) {
                *part =
                    *part + Complex::new(libm::cos(phase), libm::sin(phase)) * (size * arm / 142.5);
            }
        }
        sum
    }

    #[test]
    fn forces_between_headings_are_those_of_the_hull_in_equal_and_unequal_steps() {
        let fine = FineHeadings { is_mirrored: false };
        let equal: Vec<f64> =
            (0..36).map(|k| (-180.0 + 10.0 * f64::from(k)).to_radians()).collect();
        let unequal: Vec<f64> =
            equal.iter().enumerate().map(|(k, at)| at + 0.02 * libm::sin(k as f64)).collect();
        // The wave number at which kLΔμ is 4, for the widest step.
        for headings in [equal, unequal] {
            let number = 4.0 / (285.0 * widest_step(&headings, false));
            let given: Vec<_> = headings.iter().map(|at| of_sources(number, *at)).collect();
            let rows = HeadingWeights::new(&headings, fine).spread(&given, MIRROR);
            let (mut most, mut off) = (0.0, 0.0);
            for k in 0..1000 {
                let towards_rad = 0.0063 * f64::from(k) - PI;
                let (place, wanted) = (fine.place(towards_rad), of_sources(number, towards_rad));
                for (part, wanted) in wanted.iter().enumerate() {
                    let re = place.of(&rows, 1.0, |force| force[part].re) - wanted.re;
                    let im = place.of(&rows, 1.0, |force| force[part].im) - wanted.im;
                    off = greater(off, libm::hypot(re, im));
                    most = greater(most, libm::hypot(wanted.re, wanted.im));
                }
            }
            assert!(off < 0.02 * most, "{}", off / most);
        }
    }

    #[test]
    fn the_headings_of_the_data_are_kept_and_a_mirror_changes_signs() {
        let headings: Vec<f64> = (0..=12).map(|k| (15.0 * f64::from(k)).to_radians()).collect();
        let fine = FineHeadings { is_mirrored: true };
        let given: Vec<[f64; 3]> = headings
            .iter()
            .map(|at| [libm::cos(3.0 * at), libm::sin(2.0 * at), libm::sin(*at)])
            .collect();
        let rows = HeadingWeights::new(&headings, fine).spread(&given, MIRROR_DRIFT);
        for (at, given) in headings.iter().zip(&given) {
            for side in [1.0, -1.0] {
                let place = fine.place(side * at);
                for (k, (given, mirror)) in given.iter().zip(MIRROR_DRIFT).enumerate() {
                    let found = place.of(&rows, mirror, |row| row[k]);
                    let sign = if side < 0.0 { mirror } else { 1.0 };
                    assert!((found - sign * given).abs() < 1e-6, "{at} {k}: {found}");
                }
            }
        }
    }

    #[test]
    fn a_cubic_between_frequencies_has_parabolas_exactly_and_holds_the_ends() {
        let axis = [0.1, 0.15, 0.3, 0.4, 0.9];
        let of = |w: f64| 3.0 - 2.0 * w + 5.0 * w * w;
        for w in [0.1, 0.12, 0.2, 0.35, 0.8, 0.9] {
            let found: f64 = weights_of(&axis, w).iter().map(|(row, by)| by * of(axis[*row])).sum();
            assert!((found - of(w)).abs() < 1e-12, "{w}: {found}");
        }
        assert_eq!(weights_of(&axis, 0.05), vec![(0, 1.0)]);
        assert_eq!(weights_of(&axis, 2.0), vec![(4, 1.0)]);
        assert_eq!(weights_of(&[0.5, 1.0], 0.75).iter().map(|part| part.1).sum::<f64>(), 1.0);
    }
}
