//! Newton acceleration: finds at once where the sweeps of a small island would end.
//!
//! A ship that comes to rest on many fenders has more tight contacts than degrees of freedom, and the sweeps pass the
//! load from one contact to the next for hundreds of rounds. Her velocities have three unknowns only. So each N is made a
//! very stiff line through its present force, N = mid(0, N_now + κ(V_n⁺ + γ v_ref), f), which is right wherever N no
//! longer changes (the method of multipliers; Hestenes 1969, Powell 1969). The velocities are those at which the forces
//! balance: the minimum of a convex, piecewise quadratic function of the few velocities. Newton's method with a line
//! search finds it. Each step solves
//!
//! (M + h Σ κ j_n j_nᵀ + h² Σ k_s j_t j_tᵀ) Δv = h Σ (j's times the forces that are not yet balanced),
//!
//! whose matrix is positive definite, however many contacts there are. The sweeps check the result: the acceleration
//! affects how fast they settle, not where.

use alloc::vec::Vec;

use crate::coupled::constraint::{Change, Constraint, Forces, Jacobian, Side, Speeds};
use crate::mass::InverseMatrix;
use crate::number::{greater, lesser};
use crate::report::Friction;
use crate::state::Velocity;
use crate::vec2::Vec2;

/// Most floating bodies of an island that is accelerated.
const MOST_BODIES: usize = 4;
/// Surge, sway and yaw of each.
const SIZE: usize = 3 * MOST_BODIES;
/// κ h n·K n: each acceleration divides the remaining error by about this.
const STIFFNESS: f64 = 1e5;
/// Most Newton steps, and halvings in each line search.
const NEWTON_STEPS: u32 = 12;
const HALVINGS: u32 = 12;

/// A contact within a Newton solve.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trial {
    speeds: Speeds,
    /// Change of the speeds along the Newton step.
    along: Speeds,
    bound: NormalBound,
}

impl Trial {
    fn speeds_at(&self, share: f64) -> Speeds {
        Speeds {
            normal_mps: self.speeds.normal_mps + share * self.along.normal_mps,
            tangential_mps: self.speeds.tangential_mps + share * self.along.tangential_mps,
        }
    }
}

/// Which bound decides N.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum NormalBound {
    /// N = f.
    Full,
    /// V_n⁺ = −γ v_ref.
    Tight,
    /// N = 0.
    Open,
}

/// Forces as lines: their change from now, and their slopes with the speeds, against which they act (N·s/m).
#[derive(Clone, Copy, Debug)]
struct Line {
    change: Change,
    normal_slope: f64,
    tangential_slope: f64,
}

/// Velocities of all the island's floating bodies.
type Velocities = [f64; SIZE];

/// Changes the forces in `constraints` and the bodies' `velocities` to where the sweeps converge. Returns false, and
/// changes nothing, if the island is too large.
pub(crate) fn accelerate(
    velocities: &mut [Velocity],
    inverses: &[InverseMatrix],
    constraints: &mut [Constraint],
    trials: &mut Vec<Trial>,
    h: f64,
) -> bool {
    let Some(bodies) = Bodies::of(inverses, constraints) else { return false };
    trials.clear();
    trials.extend(constraints.iter().map(|constraint| {
        let speeds = constraint.speeds(velocities);
        let bound = bound_of(constraint, speeds.normal_mps, h);
        Trial { speeds, along: Speeds::default(), bound }
    }));
    let mut moved = [0.0; SIZE];
    for _ in 0..NEWTON_STEPS {
        let Some(step) = newton_step(&bodies, constraints, trials, &moved, h) else { break };
        let mut bounds_stay = true;
        for (constraint, trial) in constraints.iter().zip(trials.iter_mut()) {
            trial.along = bodies.speeds_of(constraint, &step);
            let bound = bound_of(constraint, trial.speeds_at(1.0).normal_mps, h);
            bounds_stay &= bound == trial.bound;
        }
        let share = if bounds_stay {
            1.0
        } else {
            line_search(&bodies, constraints, trials, &moved, &step, h)
        };
        for (moved, step) in moved.iter_mut().zip(&step) {
            *moved += share * step;
        }
        for (constraint, trial) in constraints.iter().zip(trials.iter_mut()) {
            trial.speeds = trial.speeds_at(share);
            trial.bound = bound_of(constraint, trial.speeds.normal_mps, h);
        }
        if bounds_stay {
            break;
        }
    }
    for (constraint, trial) in constraints.iter_mut().zip(trials.iter()) {
        let forces = forces_at(constraint, trial, h);
        let more = forces.minus(&constraint.forces);
        constraint.forces = forces;
        constraint.apply_impulse(velocities, inverses, more, h);
    }
    true
}

/// N of a tight contact as a stiff line through its present force, of slope κ = stiffness/(h n·K n).
fn on_stiff_line_n(constraint: &Constraint, normal_mps: f64, h: f64) -> f64 {
    let slope = STIFFNESS * constraint.force_per_speed(h);
    constraint.forces.normal_n + slope * (normal_mps + constraint.rebound_mps)
}

/// Which bound decides N at a V_n.
fn bound_of(constraint: &Constraint, normal_mps: f64, h: f64) -> NormalBound {
    match on_stiff_line_n(constraint, normal_mps, h) {
        n if n >= constraint.law_n => NormalBound::Full,
        n if n <= 0.0 => NormalBound::Open,
        _ => NormalBound::Tight,
    }
}

/// The change of the forces at these speeds, and how it changes with them. A slipping contact slips with its present T.
fn line(constraint: &Constraint, speeds: Speeds, bound: NormalBound, h: f64) -> Line {
    let now = &constraint.forces;
    let (normal_n, normal_slope) = match bound {
        NormalBound::Full => (constraint.law_n, 0.0),
        NormalBound::Open => (0.0, 0.0),
        NormalBound::Tight => {
            let slope = STIFFNESS * constraint.force_per_speed(h);
            (on_stiff_line_n(constraint, speeds.normal_mps, h), slope)
        }
    };
    let (tangential_n, tangential_slope) = match now.friction {
        Friction::Slip => (now.tangential_n, 0.0),
        Friction::Stick => {
            (constraint.shear.force_n(speeds.tangential_mps), constraint.shear.slope)
        }
    };
    let forces = Forces { normal_n, tangential_n, friction: now.friction };
    Line { change: forces.minus(now), normal_slope, tangential_slope }
}

/// The forces at a trial's speeds, by the same lines and within all bounds.
fn forces_at(constraint: &Constraint, trial: &Trial, h: f64) -> Forces {
    let change = line(constraint, trial.speeds, trial.bound, h).change;
    let now = &constraint.forces;
    let normal_n = greater(lesser(now.normal_n + change.normal_n, constraint.law_n), 0.0);
    let tangential_n = now.tangential_n + change.tangential_n;
    let tangential_n = constraint.shear.coulomb.clamped(tangential_n, normal_n, now.friction);
    Forces { normal_n, tangential_n, friction: now.friction }
}

/// Newton's step from where the bodies' velocities have `moved` to. `None` if the matrix is not positive definite to
/// rounding.
fn newton_step(
    bodies: &Bodies,
    constraints: &[Constraint],
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
    for (constraint, trial) in constraints.iter().zip(trials) {
        let line = line(constraint, trial.speeds, trial.bound, h);
        for (row, force_n, slope) in [
            (bodies.normal_row(constraint), -line.change.normal_n, line.normal_slope),
            (bodies.tangential_row(constraint), line.change.tangential_n, line.tangential_slope),
        ] {
            for one in &row {
                for i in 0..3 {
                    unbalanced[one.at + i] += h * force_n * one.j[i];
                    if slope == 0.0 {
                        continue;
                    }
                    for other in &row {
                        for k in 0..3 {
                            matrix[one.at + i][other.at + k] += h * slope * one.j[i] * other.j[k];
                        }
                    }
                }
            }
        }
    }
    cholesky(&mut matrix, &mut unbalanced, 3 * bodies.count).then_some(unbalanced)
}

/// The fraction of a Newton step, at most 1, at which the function is least along it.
fn line_search(
    bodies: &Bodies,
    constraints: &[Constraint],
    trials: &[Trial],
    moved: &Velocities,
    step: &Velocities,
    h: f64,
) -> f64 {
    let momentum = bodies.momentum(step);
    let dot = |v: &Velocities| v.iter().zip(&momentum).map(|(v, p)| v * p).sum::<f64>();
    let (at_start, along) = (dot(moved), dot(step));
    // The function is convex: its slope along the step rises with the share.
    let slope = |share: f64| {
        let mut slope = at_start + share * along;
        for (constraint, trial) in constraints.iter().zip(trials) {
            let speeds = trial.speeds_at(share);
            let bound = bound_of(constraint, speeds.normal_mps, h);
            let Change { normal_n, tangential_n } = line(constraint, speeds, bound, h).change;
            slope +=
                h * (normal_n * trial.along.normal_mps - tangential_n * trial.along.tangential_mps);
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
    // `low` never overshoots; it is 0 only if the minimum lies very near the start.
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

/// One body's part of a constraint's row of the Jacobian, and where its unknowns begin.
#[derive(Clone, Copy)]
struct RowPart {
    at: usize,
    /// Derivatives by surge, sway and yaw velocity, earth-fixed; zero for a fixed body.
    j: [f64; 3],
}

impl Bodies {
    /// `None` if there are too many.
    fn of(inverses: &[InverseMatrix], constraints: &[Constraint]) -> Option<Bodies> {
        let mut bodies =
            Bodies { ranks: [0; MOST_BODIES], masses: [[[0.0; 3]; 3]; MOST_BODIES], count: 0 };
        for rank in constraints.iter().flat_map(Constraint::floating).flatten() {
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

    /// V_n = j·v: the parts of A and B.
    fn normal_row(&self, constraint: &Constraint) -> [RowPart; 2] {
        self.row(constraint, |of| (of.normal, of.levers.n_m))
    }

    /// V_t = j·v: the parts of A and B.
    fn tangential_row(&self, constraint: &Constraint) -> [RowPart; 2] {
        self.row(constraint, |of| (of.normal.quarter_turn(), of.levers.t_m))
    }

    fn row(
        &self,
        constraint: &Constraint,
        direction: fn(&Jacobian) -> (Vec2, f64),
    ) -> [RowPart; 2] {
        let [a, b] = constraint.floating();
        let part = |rank: Option<u32>, side: Side| {
            let (Vec2 { x, y }, lever_m) = direction(&constraint.jacobian(side));
            match rank.and_then(|rank| self.place_of(rank)) {
                Some(at) => {
                    let j = match side {
                        Side::A => [x, y, lever_m],
                        Side::B => [-x, -y, -lever_m],
                    };
                    RowPart { at, j }
                }
                None => RowPart { at: 0, j: [0.0; 3] },
            }
        };
        [part(a, Side::A), part(b, Side::B)]
    }

    /// The change of a contact's speeds by a change of the bodies' velocities.
    fn speeds_of(&self, constraint: &Constraint, change: &Velocities) -> Speeds {
        let dot = |row: [RowPart; 2]| {
            let [a, b] = row.map(|RowPart { at, j }| {
                j[0] * change[at] + j[1] * change[at + 1] + j[2] * change[at + 2]
            });
            a + b
        };
        Speeds {
            normal_mps: dot(self.normal_row(constraint)),
            tangential_mps: dot(self.tangential_row(constraint)),
        }
    }
}
