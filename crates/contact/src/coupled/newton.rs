//! Newton acceleration: finds at once the contact forces to which the sweeps over an island would converge.
//!
//! A ship that comes to rest on many fenders has more tight contacts than degrees of freedom, and the sweeps pass the
//! load from one contact to the next hundreds of times. In a raft of barges the sweeps pass the load from barge to
//! barge. The velocities, however, have only three unknowns per body, whatever the number of contacts. So the
//! acceleration replaces each normal force N by a very stiff line through the present force, N = mid(0, N_now +
//! κ(V_n⁺ + γ v_ref), f). This stiff line is exact where the normal force N no longer changes (the method of
//! multipliers; Hestenes 1969, Powell 1969). The wanted velocities are those at which the forces balance. The wanted
//! velocities are the minimum of a convex, piecewise quadratic function. Newton's method with a line search finds this
//! minimum (Castro et al. 2022, IEEE Transactions on Robotics 38(2)).
//!
//! Each Newton step solves the linear system (M + h Σ κ j_n j_nᵀ + h² Σ k_s j_t j_tᵀ) Δv = h Σ (j times the forces that
//! are not yet balanced).
//!
//! The matrix of the Newton step is positive definite, however many contacts there are, and sparse: see
//! [`super::block_cholesky`]. The sweeps check the result of the acceleration. The acceleration affects how fast the
//! sweeps converge, not the forces to which they converge.

use alloc::vec::Vec;

use crate::coupled::block_cholesky::Triple;
use crate::coupled::constraint::{Change, Constraint, Forces, NormalBound, Speeds};
use crate::coupled::unknowns::{Row, Unknowns};
use crate::maths::number::{greater, lesser};
use crate::model::mass::InverseMatrix;
use crate::state::body_state::Velocity;

/// The stiff lines that replace the contact forces in a Newton acceleration.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lines {
    /// Length of the sub-step, over which the forces act (s).
    pub(crate) h: f64,
    /// Stiffness of the lines, κ h n·K n: each acceleration divides the remaining error by about this number.
    pub(crate) stiffness: f64,
    /// Newton's method ends after a step that changes the speeds of every contact by no more than this (m/s).
    pub(crate) settled_mps: f64,
}

/// Largest number of Newton steps, and largest number of trials in each line search. A line search ends when the share
/// of the Newton step changes by less than `NEAR`.
const NEWTON_STEPS: u32 = 40;
const SEARCHES: u32 = 40;
const NEAR: f64 = 1e-4;

/// The state of a contact within a Newton solve.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Trial {
    speeds: Speeds,
    /// Change of the contact's speeds along the Newton step.
    along: Speeds,
    bounds: Bounds,
    /// Slope κ of the stiff line of the normal force (N·s/m).
    stiffness: f64,
    /// True if the energy that the shear spring stores limits the tangential force T. Then T stays as it is until the
    /// next sweep.
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

/// The bounds that decide the normal and the tangential force of a contact.
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
    /// Neither the spring nor friction decides T: the force T stays as it is.
    Held,
}

/// The forces of a contact as linear functions of its speeds: their change from the present forces, and their slopes
/// (N·s/m). The forces of a contact act against its speeds.
#[derive(Clone, Copy, Debug)]
struct Line {
    change: Change,
    normal_slope: f64,
    tangential_slope: f64,
}

/// Buffers for the Newton solve of an island.
#[derive(Clone, Debug, Default)]
pub(crate) struct NewtonBuffers {
    pub(crate) unknowns: Unknowns,
    /// One [`Trial`] per contact of the island.
    trials: Vec<Trial>,
    /// For each floating body, in the order of elimination: the last Newton step, and the change of the velocity by all
    /// Newton steps so far.
    pub(crate) step: Vec<Triple>,
    moved: Vec<Triple>,
}

/// Changes the forces in `constraints` and the `velocities` of the bodies to the values to which the sweeps would
/// converge. `buffers.unknowns` must be set to the island before.
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

/// The normal force N of a tight contact, on the stiff line through the present force.
fn on_stiff_line_n(constraint: &Constraint, normal_mps: f64, stiffness: f64) -> f64 {
    constraint.forces.normal_n + stiffness * (normal_mps + constraint.rebound_mps)
}

/// The bounds that decide the forces of the contact at these speeds.
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

/// The tangential force T within Coulomb's limit for the present normal force N. With a limit that follows N, the
/// function that Newton's method minimises would not be convex. The sweeps and the next acceleration use Coulomb's
/// limit for the new N.
fn clamped_n(constraint: &Constraint, spring_n: f64) -> f64 {
    let Forces { normal_n, friction, .. } = constraint.forces;
    constraint.shear.coulomb.clamped(spring_n, normal_n, friction)
}

/// The change of the contact's forces at these speeds, and the slope of this change.
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

/// The forces of the contact at the speeds of a trial, on the stiff lines of the trial and within all bounds.
fn forces_at(constraint: &Constraint, trial: &Trial) -> Forces {
    let change = line(constraint, trial.speeds, trial.bounds, trial.stiffness).change;
    let now = &constraint.forces;
    let normal_n = greater(lesser(now.normal_n + change.normal_n, constraint.law_n), 0.0);
    let tangential_n = now.tangential_n + change.tangential_n;
    let tangential_n = constraint.shear.coulomb.clamped(tangential_n, normal_n, now.friction);
    Forces { normal_n, tangential_n, friction: now.friction }
}

/// Computes the Newton `step` from the velocities to which the bodies have `moved`, and writes it. Returns false if the
/// matrix of the step is not positive definite within rounding.
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

/// The fraction of a Newton step, at most 1, at which the minimised function is least along the step.
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
