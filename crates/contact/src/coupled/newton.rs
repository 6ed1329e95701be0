//! Newton acceleration: finds in one go the forces at which the sweeps of an island would end.
//!
//! A ship that comes to rest on many fenders has more tight contacts than degrees of freedom, and the sweeps pass the
//! load from one contact to the next for hundreds of rounds. In a raft of barges they pass it from barge to barge. The
//! velocities, however, have only three unknowns per body. So the acceleration makes each N a very stiff line through
//! the present force, N = mid(0, N_now + κ(V_n⁺ + γ v_ref), f). The line is right where N no longer changes (the method
//! of multipliers; Hestenes 1969, Powell 1969). The velocities wanted are those at which the forces balance. These
//! velocities are the minimum of a convex, piecewise quadratic function. Newton's method with a line search finds it
//! (Castro et al. 2022, IEEE Trans. Robotics 38(2)). Each Newton step solves
//!
//! (M + h Σ κ j_n j_nᵀ + h² Σ k_s j_t j_tᵀ) Δv = h Σ (j times the forces that are not yet balanced),
//!
//! The matrix is positive definite, however many contacts there are, and sparse: see [`super::block_cholesky`]. The
//! sweeps check the result. The acceleration affects how fast the sweeps settle, not where they settle.

use alloc::vec::Vec;

use crate::coupled::block_cholesky::Triple;
use crate::coupled::constraint::{Change, Constraint, Forces, NormalBound, Speeds};
use crate::coupled::unknowns::{Row, Unknowns};
use crate::mass::InverseMatrix;
use crate::number::{greater, lesser};
use crate::state::Velocity;

/// The stiff lines that replace the forces in an acceleration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lines {
    /// Length over which forces act (s).
    pub(crate) h: f64,
    /// κ h n·K n: each acceleration divides the remaining error by about this.
    pub(crate) stiffness: f64,
    /// Newton ends after a step that changes no speed at a contact by more than this (m/s).
    pub(crate) settled_mps: f64,
}

/// Most Newton steps, and most trials in each line search. A line search ends when the share changes by less than
/// `NEAR`.
const NEWTON_STEPS: u32 = 40;
const SEARCHES: u32 = 40;
const NEAR: f64 = 1e-4;

/// A contact within a Newton solve.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trial {
    speeds: Speeds,
    /// Change of the speeds along the Newton step.
    along: Speeds,
    bounds: Bounds,
    /// κ of the stiff line (N·s/m).
    stiffness: f64,
    /// Whether the energy that the shear spring stores limits T. Then T stays as it is until the next sweep.
    limited: bool,
}

impl Trial {
    fn speeds_at(&self, share: f64) -> Speeds {
        Speeds {
            normal_mps: self.speeds.normal_mps + share * self.along.normal_mps,
            tangential_mps: self.speeds.tangential_mps + share * self.along.tangential_mps,
        }
    }
}

/// The bounds that decide a contact's forces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Bounds {
    normal: NormalBound,
    shear: ShearBound,
}

/// What decides T.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ShearBound {
    /// The shear spring.
    Sticks,
    /// Friction.
    Slides,
    /// Neither: T stays as it is.
    Held,
}

/// A contact's forces as lines: their change from the present forces, and their slopes (N·s/m). The forces act against
/// the speeds.
#[derive(Clone, Copy, Debug)]
struct Line {
    change: Change,
    normal_slope: f64,
    tangential_slope: f64,
}

/// Buffers of the solve of an island.
#[derive(Clone, Debug, Default)]
pub(crate) struct NewtonBuffers {
    pub(crate) unknowns: Unknowns,
    /// One trial per contact of the island.
    trials: Vec<Trial>,
    /// For each contact by its place: the last Newton step, and the change of the velocities by all Newton steps.
    pub(crate) step: Vec<Triple>,
    moved: Vec<Triple>,
}

/// Changes the forces in `constraints` and the bodies' `velocities` to the values to which the sweeps converge. The
/// island is the one set in `buffers.unknowns`.
pub(crate) fn accelerate(
    velocities: &mut [Velocity],
    inverses: &[InverseMatrix],
    constraints: &mut [Constraint],
    buffers: &mut NewtonBuffers,
    lines: Lines,
) {
    let NewtonBuffers { unknowns, trials, step, moved } = buffers;
    trials.clear();
    trials.extend(constraints.iter().map(|constraint| {
        let speeds = constraint.speeds(velocities);
        let limited = !constraint.shear.has_energy_for(speeds.tangential_mps, lines.h);
        let stiffness = lines.stiffness * constraint.force_per_speed(lines.h);
        let bounds = bounds_at(constraint, speeds, limited, stiffness);
        Trial { speeds, along: Speeds::default(), bounds, stiffness, limited }
    }));
    moved.clear();
    moved.resize(unknowns.bodies(), Triple::default());
    for _ in 0..NEWTON_STEPS {
        if !newton_step(unknowns, constraints, trials, moved, step, lines) {
            break;
        }
        let (mut bounds_stay, mut change_mps) = (true, 0.0);
        for ((constraint, trial), &seat) in
            constraints.iter().zip(trials.iter_mut()).zip(unknowns.seats())
        {
            trial.along = Unknowns::speeds(seat, constraint, step);
            bounds_stay &=
                bounds_at(constraint, trial.speeds_at(1.0), trial.limited, trial.stiffness)
                    == trial.bounds;
            change_mps = greater(change_mps, trial.along.normal_mps.abs());
        }
        let share = if bounds_stay {
            1.0
        } else {
            line_search(unknowns, constraints, trials, moved, step, lines)
        };
        for (moved, step) in moved.iter_mut().flatten().zip(step.iter().flatten()) {
            *moved += share * step;
        }
        for (constraint, trial) in constraints.iter().zip(trials.iter_mut()) {
            trial.speeds = trial.speeds_at(share);
            trial.bounds = bounds_at(constraint, trial.speeds, trial.limited, trial.stiffness);
        }
        if bounds_stay || share * change_mps <= lines.settled_mps {
            break;
        }
    }
    for (constraint, trial) in constraints.iter_mut().zip(trials.iter()) {
        let forces = forces_at(constraint, trial);
        let more = forces.minus(&constraint.forces);
        constraint.forces = forces;
        constraint.apply_impulse(velocities, inverses, more, lines.h);
    }
}

/// N of a tight contact, on the stiff line through the present force.
fn on_stiff_line_n(constraint: &Constraint, normal_mps: f64, stiffness: f64) -> f64 {
    constraint.forces.normal_n + stiffness * (normal_mps + constraint.rebound_mps)
}

/// The bounds that decide the forces at these speeds.
fn bounds_at(constraint: &Constraint, speeds: Speeds, limited: bool, stiffness: f64) -> Bounds {
    let normal = match on_stiff_line_n(constraint, speeds.normal_mps, stiffness) {
        n if n >= constraint.law_n => NormalBound::Full,
        n if n <= 0.0 => NormalBound::Open,
        _ => NormalBound::Tight,
    };
    let spring_n = constraint.shear.force_n(speeds.tangential_mps);
    let slides = || clamped_n(constraint, spring_n).to_bits() != spring_n.to_bits();
    let shear = match limited {
        true => ShearBound::Held,
        false if slides() => ShearBound::Slides,
        false => ShearBound::Sticks,
    };
    Bounds { normal, shear }
}

/// T within Coulomb's limit for the present N. With a limit that follows N, the function would not be convex. The
/// sweeps and the next acceleration use the new N.
fn clamped_n(constraint: &Constraint, spring_n: f64) -> f64 {
    let Forces { normal_n, friction, .. } = constraint.forces;
    constraint.shear.coulomb.clamped(spring_n, normal_n, friction)
}

/// The change of the forces at these speeds, and the slope of that change.
fn line(constraint: &Constraint, speeds: Speeds, bounds: Bounds, stiffness: f64) -> Line {
    let now = &constraint.forces;
    let (normal_n, normal_slope) = match bounds.normal {
        NormalBound::Full => (constraint.law_n, 0.0),
        NormalBound::Open => (0.0, 0.0),
        NormalBound::Tight => {
            (on_stiff_line_n(constraint, speeds.normal_mps, stiffness), stiffness)
        }
    };
    let spring_n = || constraint.shear.force_n(speeds.tangential_mps);
    let (tangential_n, tangential_slope) = match bounds.shear {
        ShearBound::Sticks => (spring_n(), constraint.shear.slope),
        ShearBound::Slides => (clamped_n(constraint, spring_n()), 0.0),
        ShearBound::Held => (now.tangential_n, 0.0),
    };
    let forces = Forces { normal_n, tangential_n, friction: now.friction };
    Line { change: forces.minus(now), normal_slope, tangential_slope }
}

/// The forces at a trial's speeds, on the trial's lines and within all bounds.
fn forces_at(constraint: &Constraint, trial: &Trial) -> Forces {
    let change = line(constraint, trial.speeds, trial.bounds, trial.stiffness).change;
    let now = &constraint.forces;
    let normal_n = greater(lesser(now.normal_n + change.normal_n, constraint.law_n), 0.0);
    let tangential_n = now.tangential_n + change.tangential_n;
    let tangential_n = constraint.shear.coulomb.clamped(tangential_n, normal_n, now.friction);
    Forces { normal_n, tangential_n, friction: now.friction }
}

/// Writes Newton's `step`, from the velocities that the bodies have `moved` to. Returns false if the matrix is not
/// positive definite to rounding.
fn newton_step(
    unknowns: &mut Unknowns,
    constraints: &[Constraint],
    trials: &[Trial],
    moved: &[Triple],
    step: &mut Vec<Triple>,
    lines: Lines,
) -> bool {
    step.clear();
    step.resize(moved.len(), Triple::default());
    unknowns.subtract_momentum(moved, step);
    unknowns.begin();
    for (index, (constraint, trial)) in constraints.iter().zip(trials).enumerate() {
        let Line { change, normal_slope, tangential_slope } =
            line(constraint, trial.speeds, trial.bounds, trial.stiffness);
        let seat = unknowns.seats()[index];
        let (row, force_n) = (Row::normal(constraint), -change.normal_n);
        unknowns.add(seat, &row, lines.h * force_n, lines.h * normal_slope, step);
        let (row, force_n) = (Row::tangential(constraint), change.tangential_n);
        unknowns.add(seat, &row, lines.h * force_n, lines.h * tangential_slope, step);
    }
    unknowns.solve(step)
}

/// The fraction of a Newton step, at most 1, at which the function has its minimum along the step.
fn line_search(
    unknowns: &Unknowns,
    constraints: &[Constraint],
    trials: &[Trial],
    moved: &[Triple],
    step: &[Triple],
    lines: Lines,
) -> f64 {
    let at_start = unknowns.mass_product(moved, step);
    let along = unknowns.mass_product(step, step);
    // The function is convex and piecewise quadratic: the slope along the step rises with the share, in straight
    // pieces.
    let slope_at = |share: f64| {
        let (mut slope, mut curvature) = (at_start + share * along, along);
        for (constraint, trial) in constraints.iter().zip(trials) {
            let speeds = trial.speeds_at(share);
            let bounds = bounds_at(constraint, speeds, trial.limited, trial.stiffness);
            let Line { change, normal_slope, tangential_slope } =
                line(constraint, speeds, bounds, trial.stiffness);
            let Speeds { normal_mps, tangential_mps } = trial.along;
            slope +=
                lines.h * (change.normal_n * normal_mps - change.tangential_n * tangential_mps);
            curvature += lines.h
                * (normal_slope * normal_mps * normal_mps
                    + tangential_slope * tangential_mps * tangential_mps);
        }
        (slope, curvature)
    };
    // Newton's method within a bracket. It is exact on the last piece.
    let (mut low, mut high, mut share) = (0.0, f64::INFINITY, 1.0);
    for _ in 0..SEARCHES {
        let (slope, curvature) = slope_at(share);
        if slope > 0.0 {
            high = share;
        } else if share >= 1.0 {
            return 1.0;
        } else {
            low = share;
        }
        let next = share - slope / curvature;
        let next = if next > low && next < high { next } else { 0.5 * (low + high) };
        if (next - share).abs() <= NEAR * share {
            break;
        }
        share = next;
    }
    // Stay before the minimum, unless the minimum lies very near the start.
    if low > 0.0 { low } else { share }
}
