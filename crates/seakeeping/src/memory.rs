//! The memory of the water: the force ∫K(t − τ) ξ̇(τ) dτ of radiated waves, computed by a bank of resonators, with a
//! state of fixed size.
//!
//! One velocity u of the ship drives each resonator: x₁′ = −2σx₁ − ω₀x₂ + u, x₂′ = ω₀x₁. The two outputs of a resonator
//! have the transfer functions s/(s² + 2σs + ω₀²) and ω₀/(s² + 2σs + ω₀²). The force of the memory is Σ P x₁ + Q x₂
//! over the resonators, with symmetric matrices P and Q. Frequencies and widths of the resonators are fixed. The
//! matrices P and Q are fitted to the damping, and to the added mass that follows from the damping by Ogilvie's
//! relation. One function of frequency therefore satisfies both of Ogilvie's relations.
//!
//! The bank of resonators steps by the bilinear rule, and its matrices are fitted for the time step of the run. For a
//! time step h, the bank's transfer function is that of the data times tan(θ)/θ with θ = ωh/2. With the factor tan(θ)/θ
//! the whole step of [`super::Motion`] is exact to the fourth order. The bilinear rule keeps passivity: a system that
//! only takes energy still does so after discretisation. `make_passive` keeps the least eigenvalue of the damping at or
//! above zero over all frequencies. Radiation therefore takes energy from the ship at every step of every size.

use core::f64::consts::{FRAC_PI_2, PI};

use fenderline_contact::number::{greater, lesser};

use super::data::Hydrodynamics;
use super::least_squares::least_squares;
use super::matrix::{Matrix6, Six, ZERO, plus, smallest_eigenvalue, times};
use super::retardation::{Retardation, tangent_ratio};
use super::unknown_damping::TAIL;
use fenderline_ship::environment::waves::Complex;

/// Number of resonators, from frequency zero to where the damping has faded.
const RESONATORS: usize = 48;
/// Frequency and half-width of a wide resonator, divided by the last frequency of the hydrodynamic data. The wide
/// resonator takes no part in the fit. The wide resonator adds damping beyond the data where the fit lacks damping.
const WIDE: [f64; 2] = [2.5, 2.5];
/// Number of points of the fit, and frequency of its last point divided by the last frequency of the hydrodynamic data.
const POINTS: (usize, f64) = (200, 2.0);
/// Weight in the fit of the row at zero frequency, where the force must vanish.
const AT_REST: f64 = 300.0;
/// The least weight of a row in the fit counts as 1. The constant is the largest weight of a row, except of the row at
/// zero frequency.
const HEAVIEST: f64 = 30.0;
/// Between these shares of the last frequency, the weight of a row of the fit has the factor 1/ω (ω: its frequency).
const SLOW: [f64; 2] = [0.05, 0.4];
/// Ridge of the least-squares fit, relative to the size of the columns.
const RIDGE: f64 = 1e-7;
/// Share of its largest energy that a resonator must take at a frequency to count as near that frequency.
const NEAR: f64 = 0.3;
/// Lack of damping that is made up by a small damping at all frequencies, divided by the mass (1/s).
const LEFT: f64 = 3e-5;
/// Number of frequencies at which the damping of the bank of resonators is checked, and number of rounds of correction.
const CHECKED: (usize, usize) = (400, 60);

/// A resonator.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Resonator {
    frequency_radps: f64,
    half_width_radps: f64,
    /// Matrix A with which the resonator's two states step: x⁺ = A x + b (u + u⁺).
    step: [[f64; 2]; 2],
    input: [f64; 2],
}

/// The bank of resonators of a ship, for one time step.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Bank {
    resonators: Vec<Resonator>,
    /// The output matrices P and Q of each resonator.
    outputs: Vec<[Matrix6; 2]>,
    /// The part of the water's reaction that acts as mass with this time step, in addition to the effective added mass
    /// at infinite frequency.
    pub(super) mass: Matrix6,
    /// A small damping in place of the damping that the fit lacks (N·s/m and so on).
    pub(super) rest: Matrix6,
    /// Matrix that gives the part of the water's memory force at the end of a step that follows at once from the
    /// velocity at the end of the step.
    pub(super) at_once: Matrix6,
    step_s: f64,
}

/// The state of the bank of resonators: plain numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Memory {
    /// The two states of each resonator, for each motion of the ship.
    states: Vec<[Six; 2]>,
    /// The velocity of the ship in the last step.
    velocity: Six,
}

impl Memory {
    pub(super) fn copy_from(&mut self, other: &Memory) {
        self.states.clone_from(&other.states);
        self.velocity = other.velocity;
    }
}

impl Bank {
    /// Makes the bank of resonators of a ship for a time step (s).
    pub(super) fn new(data: &Hydrodynamics, step_s: f64) -> Bank {
        let last_radps = data.frequencies_radps[data.frequencies_radps.len() - 1];
        let spacing = TAIL * last_radps / RESONATORS as f64;
        let resonators: Vec<Resonator> = (0..RESONATORS)
            .map(|k| [(k as f64 + 0.5) * spacing, spacing])
            .chain([WIDE.map(|share| share * last_radps)])
            .map(|[w, width]| Resonator::new(w, width, step_s))
            .collect();
        let mut bank = Bank {
            outputs: vec![[ZERO; 2]; resonators.len()],
            resonators,
            mass: ZERO,
            rest: ZERO,
            at_once: ZERO,
            step_s,
        };
        bank.fit(data, last_radps);
        bank.make_passive(&data.total_mass());
        for (resonator, [p, q]) in bank.resonators.iter().zip(&bank.outputs) {
            bank.at_once = plus(&bank.at_once, resonator.input[0], p);
            bank.at_once = plus(&bank.at_once, resonator.input[1], q);
        }
        bank
    }

    /// The resonators that take part in the fit.
    fn narrow(&self) -> &[Resonator] {
        &self.resonators[..RESONATORS]
    }

    /// The highest frequency that the time step resolves (rad/s).
    fn resolved_radps(&self) -> f64 {
        2.0 / self.step_s
    }

    /// Fits the matrices P, Q and the mass to damping and added mass: within the frequencies of the data to those of
    /// the data, elsewhere to the damping that [`Retardation`] adds and the added mass that follows from it. How far
    /// added mass and damping contradict each other is checked when the data are read ([`Hydrodynamics::new`]).
    fn fit(&mut self, data: &Hydrodynamics, last_radps: f64) {
        let end_radps = lesser(POINTS.1 * last_radps, self.resolved_radps());
        let coupled = |&[i, j]: &[usize; 2]| data.is_coupled(i, j);
        let entries: Vec<[usize; 2]> =
            (0..6).flat_map(|i| (i..6).map(move |j| [i, j])).filter(coupled).collect();
        let retardation = data.retardation();
        let (mut rows, mut rights) = (Vec::new(), Vec::new());
        let frequencies_radps: Vec<f64> =
            (0..=POINTS.0).map(|point| end_radps * point as f64 / POINTS.0 as f64).collect();
        let added = retardation.added_mass(data, &frequencies_radps[1..]);
        let felt: Vec<f64> = frequencies_radps[1..]
            .iter()
            .map(|w| if *w > last_radps { 0.0 } else { felt(data, &retardation, *w, last_radps) })
            .collect();
        let least = felt.iter().copied().filter(|felt| *felt > 0.0).fold(f64::INFINITY, lesser);
        for (point, &w) in frequencies_radps.iter().enumerate() {
            let weight = match point {
                0 => AT_REST,
                _ => greater(lesser(felt[point - 1] / least, HEAVIEST), 1.0),
            };
            let factor = weight * tangent_ratio(0.5 * w * self.step_s);
            let both: Vec<[Complex; 2]> =
                self.narrow().iter().map(|one| one.outputs_at(w, self.step_s)).collect();
            let row = |part: fn(&Complex) -> f64, of_mass: f64| -> Vec<f64> {
                let of_bank = both.iter().flatten().map(|output| weight * part(output));
                of_bank.chain([of_mass]).collect()
            };
            let damping = retardation.damping_matrix(w);
            rows.push(row(|c| c.re, 0.0));
            rights.push(entries.iter().map(|&[i, j]| factor * damping[i][j]).collect::<Vec<_>>());
            if point > 0 {
                rows.push(row(|c| c.im, factor * w));
                let added = &added[point - 1];
                rights.push(entries.iter().map(|&[i, j]| factor * w * added[i][j]).collect());
            }
        }
        let largest = rows.iter().flatten().map(|value| value.abs()).fold(0.0, greater);
        let solutions = least_squares(&rows, &rights, RIDGE * largest);
        for (&[i, j], solution) in entries.iter().zip(&solutions) {
            let (of_bank, of_mass) = solution.split_at(2 * RESONATORS);
            for (output, of) in self.outputs.iter_mut().zip(of_bank.chunks(2)) {
                for (matrix, value) in output.iter_mut().zip(of) {
                    (matrix[i][j], matrix[j][i]) = (*value, *value);
                }
            }
            (self.mass[i][j], self.mass[j][i]) = (of_mass[0], of_mass[0]);
        }
    }

    /// Damping of two motions at a frequency (rad/s), and their added mass less the added mass at infinite frequency,
    /// as they act on a ship that moves in steps.
    pub(super) fn answer(&self, entry: [usize; 2], w: f64) -> [f64; 2] {
        let ratio = tangent_ratio(0.5 * w * self.step_s);
        let [i, j] = entry;
        let added = self.response(w, |c| c.im)[i][j] / ratio / w + self.mass[i][j];
        [self.response(w, |c| c.re)[i][j] / ratio, added]
    }

    /// The damping of the bank of resonators at a frequency, for a ship that moves in steps.
    fn damping(&self, w: f64) -> Matrix6 {
        plus(&self.response(w, |c| c.re), 1.0, &self.rest)
    }

    fn response(&self, w: f64, part: impl Fn(&Complex) -> f64) -> Matrix6 {
        let mut sum = ZERO;
        for (resonator, [p, q]) in self.resonators.iter().zip(&self.outputs) {
            let [one, two] = resonator.outputs_at(w, self.step_s);
            sum = plus(&sum, part(&one), p);
            sum = plus(&sum, part(&two), q);
        }
        sum
    }

    /// Adds damping where the fit gives a damping below zero for some combination of motions. First the nearest
    /// resonator adds the missing damping, because its first output takes energy at every frequency; or the wide
    /// resonator does. Damping that is still lacking after the resonators have added theirs is added at all
    /// frequencies. Combinations of motions are compared by the mass that moves in them.
    fn make_passive(&mut self, mass: &Matrix6) {
        let scale: Six = std::array::from_fn(|k| 1.0 / mass[k][k].sqrt());
        let least = |bank: &Bank| {
            let (mut worst, mut at, mut direction) = (0.0, 0.0, [0.0; 6]);
            for point in 0..CHECKED.0 {
                // All frequencies that a step of this length can represent.
                let w = 0.98 * PI / bank.step_s * square(point as f64 / CHECKED.0 as f64);
                let damping = bank.damping(w);
                let scaled: Matrix6 = std::array::from_fn(|i| {
                    std::array::from_fn(|j| damping[i][j] * scale[i] * scale[j])
                });
                let (value, vector) = smallest_eigenvalue(&scaled);
                if value < worst {
                    (worst, at, direction) = (value, w, vector);
                }
            }
            (worst, at, direction)
        };
        for _ in 0..CHECKED.1 {
            let (worst, at, direction) = least(self);
            if worst > -LEFT {
                break;
            }
            let share = |one: &Resonator| one.outputs_at(at, self.step_s)[0].re;
            // The nearest resonator is used if it is near. Elsewhere it would have to be so strong that its mass
            // counts.
            let near = |&k: &usize| {
                let one = &self.resonators[k];
                share(one) * 2.0 * one.half_width_radps > NEAR
            };
            let nearest = (0..RESONATORS).filter(near).reduce(|best, k| {
                if share(&self.resonators[k]) > share(&self.resonators[best]) { k } else { best }
            });
            let is_beyond = at > self.resonators[RESONATORS - 1].frequency_radps;
            let nearest = match nearest {
                Some(nearest) => nearest,
                None if is_beyond => RESONATORS,
                None => break,
            };
            let share = share(&self.resonators[nearest]);
            let size = -1.05 * worst / share;
            let added: Matrix6 = std::array::from_fn(|i| {
                std::array::from_fn(|j| size * direction[i] * direction[j] / (scale[i] * scale[j]))
            });
            self.outputs[nearest][0] = plus(&self.outputs[nearest][0], 1.0, &added);
        }
        let (worst, ..) = least(self);
        for (k, scale) in scale.iter().enumerate() {
            self.rest[k][k] += -worst / (scale * scale);
        }
    }

    /// The state of the bank of resonators for a ship that has moved with a steady velocity for a long time.
    pub(super) fn steady(&self, velocity: Six) -> Memory {
        // In steady motion x₁ = 0 and x₂ = u/ω₀.
        let states = self
            .resonators
            .iter()
            .map(|one| [[0.0; 6], velocity.map(|u| u / one.frequency_radps)])
            .collect();
        Memory { states, velocity }
    }

    /// The force of the water's memory against the motion at the end of the last step, without [`Bank::rest`].
    pub(super) fn force(&self, memory: &Memory) -> Six {
        let mut sum = [0.0; 6];
        for ([p, q], [one, two]) in self.outputs.iter().zip(&memory.states) {
            add(&mut sum, p, one);
            add(&mut sum, q, two);
        }
        sum
    }

    /// The force of the water's memory at the end of a step from `memory`, less [`Bank::at_once`] times the velocity at
    /// the end of the step.
    pub(super) fn force_ahead(&self, memory: &Memory) -> Six {
        let mut sum = [0.0; 6];
        let banks = self.resonators.iter().zip(&self.outputs).zip(&memory.states);
        for ((resonator, [p, q]), [one, two]) in banks {
            let [next_one, next_two] = resonator.stepped(one, two, &memory.velocity);
            add(&mut sum, p, &next_one);
            add(&mut sum, q, &next_two);
        }
        sum
    }

    /// Takes one step of the bank of resonators, at the end of which the ship has the given velocity.
    pub(super) fn advance(&self, memory: &mut Memory, velocity: &Six) {
        let both: Six = std::array::from_fn(|k| memory.velocity[k] + velocity[k]);
        for (resonator, state) in self.resonators.iter().zip(&mut memory.states) {
            *state = resonator.stepped(&state[0], &state[1], &both);
        }
        memory.velocity = *velocity;
    }
}

impl Resonator {
    fn new(frequency_radps: f64, half_width_radps: f64, step_s: f64) -> Resonator {
        // (I − hM/2)⁻¹(I + hM/2) and (I − hM/2)⁻¹ (h/2, 0) with M = [[−2σ, −ω₀], [ω₀, 0]].
        let (half_s, w, damping) = (0.5 * step_s, frequency_radps, 2.0 * half_width_radps);
        let determinant = 1.0 + half_s * damping + half_s * half_s * w * w;
        let (a, b) = (1.0 - half_s * damping, half_s * w);
        let inverse = [
            [1.0 / determinant, -b / determinant],
            [b / determinant, (1.0 + half_s * damping) / determinant],
        ];
        let explicit = [[a, -b], [b, 1.0]];
        let step = std::array::from_fn(|i| {
            std::array::from_fn(|j| inverse[i][0] * explicit[0][j] + inverse[i][1] * explicit[1][j])
        });
        let input = [half_s * inverse[0][0], half_s * inverse[1][0]];
        Resonator { frequency_radps, half_width_radps, step, input }
    }

    /// The two states of a resonator after a step. `velocities` is the sum of the ship's velocities before and after
    /// the step.
    fn stepped(&self, one: &Six, two: &Six, velocities: &Six) -> [Six; 2] {
        let [[a, b], [c, d]] = self.step;
        let [e, f] = self.input;
        [
            std::array::from_fn(|k| a * one[k] + b * two[k] + e * velocities[k]),
            std::array::from_fn(|k| c * one[k] + d * two[k] + f * velocities[k]),
        ]
    }

    /// Both outputs of the resonator at a frequency, when the bilinear rule steps it: s = (2i/h) tan(ωh/2).
    fn outputs_at(&self, w: f64, step_s: f64) -> [Complex; 2] {
        let theta = lesser(0.5 * w * step_s, 0.999 * FRAC_PI_2);
        let s = 2.0 / step_s * libm::tan(theta);
        let (w0, damping) = (self.frequency_radps, 2.0 * self.half_width_radps);
        // 1/(ω₀² − s² + i·2σs).
        let (re, im) = (w0 * w0 - s * s, damping * s);
        let squared = re * re + im * im;
        let inverse = Complex::new(re / squared, -im / squared);
        [inverse * Complex::new(0.0, s), inverse * w0]
    }
}

/// The weight in the fit of an error of the damping at a frequency (rad/s): by the norm of the inverse of a free ship's
/// equation of motion, in units of her own mass, added mass included, and by the frequency.
///
/// Near a resonance small errors of the fit give large motions: for the ship at a quay, mass, restoring and damping in
/// pitch cancel to 3 % at 0.9 rad/s (`waves_between.py --by-files`), where an error of 1 % of the mass is a third of
/// the motion. The weight is the square root of this norm, which was found by trial on the rows of `waves_between.rs`.
/// In slow motions, the force by acceleration is the force by velocity divided by the frequency.
fn felt(data: &Hydrodynamics, retardation: &Retardation, w: f64, last_radps: f64) -> f64 {
    let (total, mass, restoring) = (data.total_mass(), data.rigid_mass(), data.restoring());
    let damping = retardation.damping_matrix(w);
    let entry = |i: usize, j: usize| {
        let added = data.infinite()[i][j] + retardation.added_mass_change(i, j, w);
        let scale = 1.0 / (total[i][i] * total[j][j]).sqrt();
        let real = restoring[i][j] / (w * w) - mass[i][j] - added;
        [real * scale, damping[i][j] / w * scale]
    };
    // The complex equation as a real one of twice the size.
    let rows: Vec<Vec<f64>> = (0..12)
        .map(|i| {
            let of = |j: usize| {
                let [real, imaginary] = entry(i % 6, j % 6);
                match (i < 6, j < 6) {
                    (true, true) | (false, false) => real,
                    (true, false) => -imaginary,
                    (false, true) => imaginary,
                }
            };
            (0..12).map(of).collect()
        })
        .collect();
    let unit: Vec<Vec<f64>> =
        (0..12).map(|i| (0..12).map(|j| f64::from(i == j)).collect()).collect();
    let inverse = least_squares(&rows, &unit, 0.0);
    let squares: f64 = inverse.iter().flatten().map(|value| value * value).sum();
    let slow = lesser(greater(w / last_radps, SLOW[0]), SLOW[1]);
    (0.5 * squares).sqrt().sqrt() / slow
}

fn square(x: f64) -> f64 {
    x * x
}

/// Adds the product A v of a matrix and a vector to a sum.
fn add(sum: &mut Six, matrix: &Matrix6, vector: &Six) {
    for (sum, part) in sum.iter_mut().zip(times(matrix, vector)) {
        *sum += part;
    }
}
