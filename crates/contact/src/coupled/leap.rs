//! A leap: where the sweeps of a small island would end, found at once.
//!
//! A ship that comes to rest on many fenders has more tight contacts than ways to move, and the sweeps
//! hand the load from one to the next for hundreds of rounds. Her velocities have three unknowns only. So
//! each N is made a very stiff line through its present force, N = mid(0, N_now + κ(V_n⁺ + γ v_ref), f),
//! which is right wherever N no longer changes (the method of multipliers; Hestenes 1969, Powell 1969), and
//! the velocities are those where the forces balance: the minimum of a convex function of the few
//! velocities, quadratic in pieces. Newton's method with a search along the line finds it, each step from
//!
//! (M + h Σ κ j_n j_nᵀ + h² Σ k_s j_t j_tᵀ) Δv = h Σ (j's times the forces that are not yet balanced),
//!
//! whose matrix is positive definite, however many contacts there are. The sweeps judge the result: a leap
//! decides how fast they settle, not where.

use alloc::vec::Vec;

use crate::coupled::tie::{Kind, Tie};
use crate::mass::InverseMatrix;
use crate::state::Velocity;

/// Most floating bodies of an island that is leapt.
const MOST_BODIES: usize = 4;
/// Surge, sway and yaw of each.
const SIZE: usize = 3 * MOST_BODIES;
/// κ h n·K n: each leap takes this much off what is left.
const STIFFNESS: f64 = 1e5;
/// Most of Newton's steps, and halvings of each.
const NEWTON_STEPS: u32 = 12;
const HALVINGS: u32 = 12;

/// A contact in a leap: its speeds (m/s), how they change along the step, and where N stands.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trial {
    speeds: (f64, f64),
    along: (f64, f64),
    kind: Kind,
}

impl Trial {
    fn speeds_at(&self, share: f64) -> (f64, f64) {
        (self.speeds.0 + share * self.along.0, self.speeds.1 + share * self.along.1)
    }
}

/// Velocities of all the island's floating bodies.
type Velocities = [f64; SIZE];

/// Changes the forces in `ties` and the bodies' `velocities` to where the sweeps seem to go. False, and
/// nothing changed, where the island is too large.
pub(crate) fn leap(
    velocities: &mut [Velocity],
    inverses: &[InverseMatrix],
    ties: &mut [Tie],
    trials: &mut Vec<Trial>,
    h: f64,
) -> bool {
    let Some(bodies) = Bodies::of(inverses, ties) else { return false };
    trials.clear();
    trials.extend(ties.iter().map(|tie| {
        let speeds = tie.speeds(velocities);
        Trial { speeds, along: (0.0, 0.0), kind: tie.kind(speeds.0, STIFFNESS, h) }
    }));
    let mut moved = [0.0; SIZE];
    for _ in 0..NEWTON_STEPS {
        let Some(step) = newton_step(&bodies, ties, trials, &moved, h) else { break };
        let mut stays = true;
        for (tie, trial) in ties.iter().zip(trials.iter_mut()) {
            trial.along = bodies.seen_by(tie, &step);
            stays &= tie.kind(trial.speeds_at(1.0).0, STIFFNESS, h) == trial.kind;
        }
        let share = if stays { 1.0 } else { share_of(&bodies, ties, trials, (&moved, &step), h) };
        for (moved, step) in moved.iter_mut().zip(&step) {
            *moved += share * step;
        }
        for (tie, trial) in ties.iter().zip(trials.iter_mut()) {
            trial.speeds = trial.speeds_at(share);
            trial.kind = tie.kind(trial.speeds.0, STIFFNESS, h);
        }
        if stays {
            break;
        }
    }
    for (tie, trial) in ties.iter_mut().zip(trials.iter()) {
        let forces = tie.stiffened(trial.speeds, trial.kind, STIFFNESS, h);
        let more = forces.less(&tie.forces);
        tie.forces = forces;
        tie.push(velocities, inverses, more.0 * h, more.1 * h);
    }
    true
}

/// Newton's step from where the bodies' velocities have `moved` to. `None` where the matrix is not positive
/// definite to rounding.
fn newton_step(
    bodies: &Bodies,
    ties: &[Tie],
    trials: &[Trial],
    moved: &Velocities,
    h: f64,
) -> Option<Velocities> {
    let mut matrix = [[0.0; SIZE]; SIZE];
    let mut unbalanced = bodies.momentum(moved).map(|p| -p);
    for (place, mass) in bodies.masses[..bodies.count].iter().enumerate() {
        for (i, row) in mass.iter().enumerate() {
            matrix[3 * place + i][3 * place..3 * place + 3].copy_from_slice(row);
        }
    }
    for (tie, trial) in ties.iter().zip(trials) {
        let line = tie.line(trial.speeds, trial.kind, STIFFNESS, h);
        for (j, force_n, slope) in [
            (bodies.row(tie, Tie::normal_row), -line.normal_n, line.normal_slope),
            (bodies.row(tie, Tie::tangential_row), line.tangential_n, line.tangential_slope),
        ] {
            for &(at_i, j_i) in &j {
                for i in 0..3 {
                    unbalanced[at_i + i] += h * force_n * j_i[i];
                    if slope == 0.0 {
                        continue;
                    }
                    for &(at_k, j_k) in &j {
                        for k in 0..3 {
                            matrix[at_i + i][at_k + k] += h * slope * j_i[i] * j_k[k];
                        }
                    }
                }
            }
        }
    }
    cholesky(&mut matrix, &mut unbalanced, 3 * bodies.count).then_some(unbalanced)
}

/// The share of a step, at most all of it, to where the function is least along it.
fn share_of(
    bodies: &Bodies,
    ties: &[Tie],
    trials: &[Trial],
    (moved, step): (&Velocities, &Velocities),
    h: f64,
) -> f64 {
    let momentum = bodies.momentum(step);
    let dot = |v: &Velocities| v.iter().zip(&momentum).map(|(v, p)| v * p).sum::<f64>();
    let (at_start, along) = (dot(moved), dot(step));
    // The function's slope along the step rises with the share, as the function is convex.
    let slope = |share: f64| {
        let mut slope = at_start + share * along;
        for (tie, trial) in ties.iter().zip(trials) {
            let speeds = trial.speeds_at(share);
            let line = tie.line(speeds, tie.kind(speeds.0, STIFFNESS, h), STIFFNESS, h);
            slope += h * (line.normal_n * trial.along.0 - line.tangential_n * trial.along.1);
        }
        slope
    };
    if slope(1.0) <= 0.0 {
        return 1.0;
    }
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if slope(middle) > 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    // Half of the last stretch is gone for certain.
    if low > 0.0 { low } else { high }
}

/// Solves A x = b in place for the first `count` unknowns; false where A is not positive definite.
fn cholesky(a: &mut [[f64; SIZE]; SIZE], b: &mut [f64; SIZE], count: usize) -> bool {
    let dot = |p: &[f64], q: &[f64]| p.iter().zip(q).map(|(p, q)| p * q).sum::<f64>();
    for j in 0..count {
        let diagonal = a[j][j] - dot(&a[j][..j], &a[j][..j]);
        // Not a number is not positive either.
        let positive = diagonal > 0.0;
        if !positive {
            return false;
        }
        a[j][j] = libm::sqrt(diagonal);
        for i in j + 1..count {
            a[i][j] = (a[i][j] - dot(&a[i][..j], &a[j][..j])) / a[j][j];
        }
    }
    for i in 0..count {
        b[i] = (b[i] - dot(&a[i][..i], &b[..i])) / a[i][i];
    }
    for i in (0..count).rev() {
        b[i] = (i + 1..count).fold(b[i], |sum, k| sum - a[k][i] * b[k]) / a[i][i];
    }
    true
}

/// The floating bodies of an island, in the order of its contacts, and their masses.
struct Bodies {
    ranks: [u32; MOST_BODIES],
    masses: [[[f64; 3]; 3]; MOST_BODIES],
    count: usize,
}

impl Bodies {
    /// `None` where there are too many.
    fn of(inverses: &[InverseMatrix], ties: &[Tie]) -> Option<Bodies> {
        let mut bodies =
            Bodies { ranks: [0; MOST_BODIES], masses: [[[0.0; 3]; 3]; MOST_BODIES], count: 0 };
        for rank in ties.iter().flat_map(Tie::floating).flatten() {
            if bodies.place_of(rank).is_none() {
                *bodies.ranks.get_mut(bodies.count)? = rank;
                bodies.masses[bodies.count] = inverses[rank as usize].matrix()?;
                bodies.count += 1;
            }
        }
        Some(bodies)
    }

    /// M v.
    fn momentum(&self, velocities: &Velocities) -> Velocities {
        let mut momentum = [0.0; SIZE];
        for (place, mass) in self.masses[..self.count].iter().enumerate() {
            let v = &velocities[3 * place..3 * place + 3];
            for (i, row) in mass.iter().enumerate() {
                momentum[3 * place + i] = row[0] * v[0] + row[1] * v[1] + row[2] * v[2];
            }
        }
        momentum
    }

    /// Where a body's unknowns begin.
    fn place_of(&self, rank: u32) -> Option<usize> {
        let place = self.ranks[..self.count].iter().position(|&own| own == rank)?;
        Some(3 * place)
    }

    /// The parts of a contact's row j, and where they stand; zeros for what is fixed.
    fn row(&self, tie: &Tie, of: fn(&Tie) -> [[f64; 3]; 2]) -> [(usize, [f64; 3]); 2] {
        let ([a, b], [j_a, j_b]) = (tie.floating(), of(tie));
        let part = |rank: Option<u32>, j: [f64; 3]| match rank.and_then(|rank| self.place_of(rank))
        {
            Some(place) => (place, j),
            None => (0, [0.0; 3]),
        };
        [part(a, j_a), part(b, j_b)]
    }

    /// What a contact sees of a change of the velocities: of V_n and of V_t (m/s).
    fn seen_by(&self, tie: &Tie, change: &Velocities) -> (f64, f64) {
        let along = |of: fn(&Tie) -> [[f64; 3]; 2]| {
            let [(at_a, a), (at_b, b)] = self.row(tie, of);
            let dot = |at: usize, j: [f64; 3]| {
                j[0] * change[at] + j[1] * change[at + 1] + j[2] * change[at + 2]
            };
            dot(at_a, a) + dot(at_b, b)
        };
        (along(Tie::normal_row), along(Tie::tangential_row))
    }
}
