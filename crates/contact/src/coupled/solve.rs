//! The solver: computes the normal and tangential forces of all contacts of an island together.
//!
//! The unknowns of the solve are the normal force N_i and the tangential force T_i of each contact. V⁺ is the relative
//! velocity of the two bodies at a contact after *all* forces of the sub-step:
//!
//! - The normal forces satisfy 0 ≤ N_i ≤ f_i and V_n,i⁺ + γ v_ref,i ≥ 0, and N_i < f_i only where the bound on V_n,i⁺
//!   is tight. This is a boxed linear complementarity problem with the solution N_i = mid(0, N at which the bound is
//!   tight, f_i). With one contact and no load, this solution is the paper's limiter (eq. 26).
//! - The tangential force T_i = −k_s(Δs + ϑ h V̄), with V̄ = (1 − ϑ) V_t + ϑ V_t⁺, is the force of the shear spring,
//!   taken implicitly and within Coulomb's limit (eq. 4–8). See [`crate::law::friction`].
//! - The normal force N_i gives the bodies no more energy than N_i has taken from them, and the tangential force T_i no
//!   more than T_i has taken.
//!
//! If an island has one floating body and no contact reaches a bound, the forces follow directly ([`super::direct`]).
//! For other islands the solver uses projected Gauss–Seidel sweeps on the velocities of the bodies. The sweeps start
//! with the forces of the last sub-step and run in the fixed order of the contacts. Where sweeps converge slowly,
//! Newton acceleration ([`super::newton`]) helps. The work of the solver is bounded: if the forces have not settled
//! after [`SWEEPS`] sweeps, the engine reports this.

use crate::coupled::constraint::{Change, Constraint, Forces, Speeds};
use crate::coupled::direct;
use crate::coupled::newton::{Lines, NewtonBuffers, accelerate};
use crate::maths::number::greater;
use crate::model::mass::InverseMatrix;
use crate::state::body_state::Velocity;
use crate::state::memory::PatchMemory;
use crate::state::report::Friction;

/// Largest number of sweeps over the contacts of an island.
const SWEEPS: u32 = 400;
/// Largest number of Newton accelerations of an island, and number of sweeps before each acceleration. The first number
/// of sweeps is for islands with one floating body, whose sweeps mostly converge by themselves; the second number is
/// for islands with several floating bodies.
const ACCELERATIONS: usize = 20;
const SWEEPS_PER_ACCELERATION: [u32; 2] = [6, 2];
/// Stiffnesses of the lines in the Newton accelerations ([`Lines`]), one for each acceleration in turn. For several
/// floating bodies the stiffness rises: the soft lines of the first accelerations find the reached bounds in few steps,
/// and the stiff lines of later accelerations find the exact forces. In a raft of 10 × 10 barges stiff lines alone
/// would take ten times as many steps.
const STIFFNESSES: [f64; 3] = [1e2, 1e3, 1e4];
/// The sweeps have converged when a sweep changes no velocity at a contact by more than this share of the island's
/// speeds, or by more than `SETTLED_MPS`.
const SETTLED: f64 = 1e-9;
const SETTLED_MPS: f64 = 1e-13;
/// Largest change of velocity in the last sweep that is not reported to the user (m/s).
pub(crate) const REPORTED_MPS: f64 = 1e-6;

/// Computes the new velocities of the `bodies` of an island from their velocities without contact, and the forces in
/// the island's `constraints`. The sweeps begin with the forces in `memories`. Returns the largest change of velocity
/// in the last sweep (m/s).
#[inline]
pub(crate) fn solve_island(
    bodies: &mut [Velocity],
    inverses: &[InverseMatrix],
    constraints: &mut [Constraint],
    memories: &[PatchMemory],
    buffers: &mut NewtonBuffers,
    h: f64,
) -> f64 {
    if direct::solve(bodies, inverses, constraints, h) {
        return 0.0;
    }
    let equations = if is_joined(constraints) {
        if buffers.unknowns.set(inverses, constraints) {
            Equations::Joined
        } else {
            Equations::None
        }
    } else {
        Equations::OfOne
    };
    for (constraint, memory) in constraints.iter_mut().zip(memories) {
        constraint.forces = Forces {
            normal_n: memory.normal_force_n,
            tangential_n: memory.tangential_force_n,
            friction: Friction::Stick,
        };
    }
    let change_mps = sweep_until_settled(bodies, inverses, constraints, buffers, equations, h);
    for constraint in constraints {
        constraint.after = constraint.speeds(bodies);
    }
    change_mps
}

/// The state of the equations for the Newton acceleration of an island.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Equations {
    /// There are no equations, because a mass matrix cannot be inverted.
    None,
    /// The equations of one floating body. The equations of one floating body are set up when the first acceleration
    /// needs them, because most sweeps converge before.
    OfOne,
    /// The equations of several floating bodies, already set up.
    Joined,
}

/// Returns true if the contacts touch more than one floating body.
fn is_joined(constraints: &[Constraint]) -> bool {
    let first = constraints.first().and_then(Constraint::only_floating);
    first.is_none() || constraints.iter().any(|constraint| constraint.only_floating() != first)
}

/// Sweeps over all contacts of an island until the forces have settled, with Newton acceleration. Returns the largest
/// change of velocity in the last sweep (m/s).
fn sweep_until_settled(
    bodies: &mut [Velocity],
    inverses: &[InverseMatrix],
    constraints: &mut [Constraint],
    buffers: &mut NewtonBuffers,
    mut equations: Equations,
    h: f64,
) -> f64 {
    warm_start(bodies, inverses, constraints, h);
    let settled_mps = settled_mps(constraints, h);
    let joined = equations == Equations::Joined;
    let every = SWEEPS_PER_ACCELERATION[usize::from(joined)];
    let stiffnesses = if joined { &STIFFNESSES[..] } else { &STIFFNESSES[2..] };
    let mut change_mps = 0.0;
    let mut accelerations = 0;
    for count in 1..=SWEEPS {
        change_mps = sweep(bodies, inverses, constraints, h);
        if change_mps <= settled_mps {
            break;
        }
        if count % every != 0 || accelerations == ACCELERATIONS || equations == Equations::None {
            continue;
        }
        if !joined && accelerations == 0 && !buffers.unknowns.set(inverses, constraints) {
            equations = Equations::None;
            continue;
        }
        let stiffness = stiffnesses[accelerations.min(stiffnesses.len() - 1)];
        let lines = Lines { h, stiffness, settled_mps };
        accelerate(bodies, inverses, constraints, buffers, lines);
        accelerations += 1;
    }
    change_mps
}

/// The change of velocity below which an island counts as settled (m/s), computed from the speeds at the contacts and
/// from the speeds that the contact forces could give.
fn settled_mps(constraints: &[Constraint], h: f64) -> f64 {
    let speed_mps = |of: &Constraint| {
        greater(of.normal_before_mps.abs(), of.law_n * h * of.inverse_mass.normal)
    };
    greater(SETTLED * constraints.iter().map(speed_mps).fold(0.0, greater), SETTLED_MPS)
}

/// Applies the impulses of the forces with which the sweeps begin to the velocities of the bodies.
fn warm_start(
    bodies: &mut [Velocity],
    inverses: &[InverseMatrix],
    constraints: &mut [Constraint],
    h: f64,
) {
    for constraint in constraints {
        constraint.apply_impulse(bodies, inverses, constraint.forces.change(), h);
    }
}

/// Solves each contact in turn, with the forces of all other contacts given. Returns the largest change of velocity in
/// this sweep (m/s).
fn sweep(
    bodies: &mut [Velocity],
    inverses: &[InverseMatrix],
    constraints: &mut [Constraint],
    h: f64,
) -> f64 {
    let mut change_mps = 0.0;
    for constraint in constraints {
        let forces = constraint.relaxed(constraint.speeds(bodies), h);
        let more = forces.minus(&constraint.forces);
        constraint.forces = forces;
        if more != Change::NONE {
            constraint.apply_impulse(bodies, inverses, more, h);
            change_mps = greater(change_mps, constraint.change_mps(more, h));
        }
    }
    change_mps
}

/// Does the same as [`solve_island`] for an island with one contact. The normal and the tangential speed of the
/// island's only contact are the only unknowns. If the contact reaches no bound, its forces follow directly.
#[inline(always)]
pub(crate) fn solve_single(
    bodies: &mut [Velocity],
    inverses: &[InverseMatrix],
    constraint: &mut Constraint,
    h: f64,
) -> f64 {
    let free = constraint.speeds(bodies);
    let (tangential_n, speeds) = constraint.sticking(free, h);
    let mut change_mps = 0.0;
    if constraint.is_within_bounds(speeds, tangential_n, h) {
        constraint.set_sticking(speeds, tangential_n);
    } else {
        change_mps = sweep_single(constraint, free, h);
    }
    constraint.apply_impulse(bodies, inverses, constraint.forces.change(), h);
    change_mps
}

/// Sweeps over the only contact of an island, from its speeds without contact forces.
#[inline(never)]
fn sweep_single(constraint: &mut Constraint, free: Speeds, h: f64) -> f64 {
    let mut speeds = constraint.speeds_after(free, constraint.forces.change(), h);
    let mut change_mps = 0.0;
    for _ in 0..SWEEPS {
        let forces = constraint.relaxed(speeds, h);
        let more = forces.minus(&constraint.forces);
        constraint.forces = forces;
        speeds = constraint.speeds_after(speeds, more, h);
        change_mps = constraint.change_mps(more, h);
        if change_mps <= SETTLED_MPS {
            break;
        }
    }
    constraint.after = speeds;
    change_mps
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec::Vec;

    use crate::coupled::constraint::Laws;
    use crate::law::friction::Slide;
    use crate::maths::number::bounded;
    use crate::maths::vec2::vec2;
    use crate::model::material::Material;
    use crate::touch::Touch;

    const RUBBER: Material = Material {
        stiffness_npm2: 0.0,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e6,
        friction_static: 0.5,
        friction_dynamic: 0.4,
        restitution: 0.1,
    };
    const H: f64 = 0.1;

    /// A ship on eight fenders that would throw her back too fast. Each fender has its own bound.
    fn ship_on_fenders() -> (Vec<Velocity>, Vec<InverseMatrix>, Vec<Constraint>) {
        let bodies = [(vec2(1e-3, 1e-3), 3e-6), Velocity::default()];
        let inverses = [InverseMatrix::isotropic(9e7, 5e11), InverseMatrix::default()];
        let constraints = (0..8).map(|k| {
            let arm_a_m = vec2(-110.0 + 28.0 * f64::from(k), 23.0);
            let touch =
                Touch { shear_m: 1e-4, ..Touch::at(vec2(0.0, 1.0), [arm_a_m, vec2(0.0, 0.0)]) };
            let law_n = 3e5 + 1e4 * f64::from(k * k % 7);
            let rebound_mps = 1e-3 + 1e-5 * f64::from(k * k % 5);
            let [available_j, shear_available_j] = [f64::MAX; 2];
            let material = &RUBBER;
            let laws = Laws {
                material,
                law_n,
                rebound_mps,
                available_j,
                shear_available_j,
                unbalanced_j: 0.0,
                slide: Slide::Begins,
                was_limited: false,
                h: H,
                kick_s: H,
            };
            let forces = Forces { normal_n: law_n, tangential_n: 0.0, friction: Friction::Stick };
            Constraint::new((0, &inverses[0]), (1, &inverses[1]), &touch, &laws, forces)
        });
        (bodies.to_vec(), inverses.to_vec(), constraints.collect())
    }

    #[test]
    fn newton_acceleration_reaches_the_solution_of_the_sweeps() {
        let (mut bodies, inverses, mut constraints) = ship_on_fenders();
        let mut buffers = NewtonBuffers::default();
        let equations = Equations::OfOne;
        let last_mps = sweep_until_settled(
            &mut bodies,
            &inverses,
            &mut constraints,
            &mut buffers,
            equations,
            H,
        );
        assert!(last_mps <= SETTLED_MPS, "{last_mps}");

        let (mut swept, _, mut swept_constraints) = ship_on_fenders();
        warm_start(&mut swept, &inverses, &mut swept_constraints, H);
        let mut count = 0;
        while sweep(&mut swept, &inverses, &mut swept_constraints, H) > SETTLED_MPS {
            count += 1;
            assert!(count < 1_000_000);
        }
        assert!(count > 30, "{count}: slow without acceleration");
        // Both have settled to 1e-13 m/s a sweep; the slowest sweeps reduce the rest by a few per cent each.
        let apart = swept[0].0 - bodies[0].0;
        let turn = swept[0].1 - bodies[0].1;
        assert!(apart.length() < 1e-11 && turn.abs() < 1e-13, "{apart:?} {turn}");
    }

    /// In one of 100,000 random hits the ship gained 0.5 % energy, from a shear spring that was stiff for the time step
    /// while other forces changed.
    #[test]
    fn a_stiff_shear_spring_returned_more_energy_than_it_absorbed() {
        let material = Material { shear_stiffness_npm: 1e8, friction_static: 1e30, ..RUBBER };
        let inverses = [InverseMatrix::isotropic(9e5, 6e7), InverseMatrix::default()];
        let mut body: Velocity = (vec2(0.3, 0.0), 0.0);
        let kinetic_j = |(velocity_mps, turn_radps): Velocity| {
            0.5 * (9e5 * velocity_mps.length_squared() + 6e7 * turn_radps * turn_radps)
        };
        let start_j = kinetic_j(body);
        let (mut shear_m, mut stored_j) = (0.0, 0.0);
        for step in 0..400_i32 {
            // A push to and fro, as from neighbouring contacts.
            let pushed_mps = 0.02 * f64::from((step * step) % 7 - 3);
            let touch = Touch {
                shear_m,
                v_tangential_mps: -(body.0.x - 5.0 * body.1),
                ..Touch::at(vec2(0.0, 1.0), [vec2(0.0, 5.0), vec2(0.0, 0.0)])
            };
            let laws = Laws {
                material: &material,
                law_n: 1e-9,
                rebound_mps: 1.0,
                available_j: f64::MAX,
                shear_available_j: stored_j,
                unbalanced_j: 0.0,
                slide: Slide::Begins,
                was_limited: false,
                h: 0.5,
                kick_s: 0.5,
            };
            let forces = Forces { normal_n: 0.0, tangential_n: 0.0, friction: Friction::Stick };
            let mut constraint =
                Constraint::new((0, &inverses[0]), (1, &inverses[1]), &touch, &laws, forces);
            let (before_mps, before_j) = (body.0.x, kinetic_j(body) + stored_j);
            let mut bodies = [body, Velocity::default()];
            bodies[0].0.x += pushed_mps;
            let last_mps = solve_single(&mut bodies, &inverses, &mut constraint, 0.5);
            assert!(last_mps <= SETTLED_MPS, "{last_mps}");
            body = bodies[0];
            let put_in_j = 9e5 * pushed_mps * 0.5 * (before_mps + body.0.x);
            let after_mps = constraint.speeds(&bodies).tangential_mps;
            let Forces { normal_n, friction, .. } = constraint.forces;
            let slip_m = 0.25 * (touch.v_tangential_mps + after_mps);
            shear_m = constraint.shear.shear_after_m(shear_m, after_mps, normal_n, friction, 0.5);
            stored_j = bounded(
                stored_j - constraint.forces.tangential_n * slip_m,
                0.0,
                constraint.shear.stored_j(shear_m),
            );
            let gain_j = kinetic_j(body) + stored_j - before_j - put_in_j;
            assert!(gain_j < 1e-9 * start_j, "step {step}: {gain_j} J");
        }
    }
}
