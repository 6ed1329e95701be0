//! The direct solve: computes all forces at once, for an island with one floating body whose contacts stick. In most
//! sub-steps most islands have one floating body whose contacts stick.
//!
//! In the direct solve, the normal force N_i equals the force f_i of its law. The force of the implicit shear spring is
//! linear in the tangential speed V_t⁺ while the contact sticks: T_i = T_i(V_t⁺ = 0) − c_i V_t,i⁺ with the slope c_i =
//! ϑ² k_s h.
//!
//! Three equations then give the body's velocity v⁺, whatever the number of contacts. If the fixed bodies are at rest,
//! the equations for v⁺ are (1 + h M⁻¹ Σ c_i j_t j_tᵀ) v⁺ = v_free + h M⁻¹ Σ (−f_i j_n + T_i(0) j_t).
//!
//! When a ship comes off her fenders, the normal force N of some contacts is at a bound for many steps. Most of these
//! contacts are open, which means N = 0. One or two contacts are tight, which means V_n⁺ = −γ v_ref, and each tight
//! contact adds an equation ([`hold`]). The solver first assumes that each contact has the bound that it had in the
//! last sub-step. If the solution contradicts an assumed bound, the bound is corrected, and the equations are solved
//! again.
//!
//! If the solution reaches no other bound on N and T, it is the same as the result of the iterative sweeps. The direct
//! solve tests each contact for a bound that the solution reaches. If one contact fails this test, the iterative sweeps
//! take over and find the bounds.

use crate::coupled::constraint::{Constraint, Forces, NormalBound, Side, Speeds};
use crate::coupled::direct_system::{Push, Stiffness, System};
use crate::model::mass::InverseMatrix;
use crate::state::body_state::Velocity;
use crate::state::report::Friction;
use crate::touch::Movers;

/// Largest number of corrections of the assumed bounds in one solve.
const CORRECTIONS: u32 = 6;

/// Most tight contacts. More tight contacts, for example at fenders in a line, would not determine N of each contact.
const MOST_TIGHT: usize = 2;

/// The result of checking the assumed bounds against a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Verdict {
    /// All assumed bounds on the contact forces are right.
    Right,
    /// Some assumed bounds were wrong; the constraints now have the right bounds.
    Corrected,
    /// The direct solve cannot find the solution, for example because a contact has a second floating body. The
    /// iterative sweeps must then solve the contacts.
    Beyond,
}

/// Computes the new velocity of the body in `bodies` and the forces in `constraints`, from the velocities without
/// contact. Returns false if the iterative sweeps are needed, or if more than one body floats. If the function returns
/// false, `bodies` are unchanged and the forces are undefined.
#[inline]
pub(crate) fn solve(
    bodies: &mut [Velocity],
    inverses: &[InverseMatrix],
    constraints: &mut [Constraint],
    h: f64,
) -> bool {
    let Some(body) = constraints.first().and_then(Constraint::only_floating) else { return false };
    let response = inverses[body as usize].times(h);
    if !constraints.iter().any(|constraint| constraint.was_limited) {
        match solve_at_bounds::<false>(bodies, body, &response, constraints, h) {
            Verdict::Right => return true,
            Verdict::Corrected => {}
            Verdict::Beyond => return false,
        }
    }
    solve_below_law(bodies, body, &response, constraints, h)
}

/// Does the same as [`solve`] for the case that some contacts have less force than their law gives.
#[inline(never)]
fn solve_below_law(
    bodies: &mut [Velocity],
    body: u32,
    response: &InverseMatrix,
    constraints: &mut [Constraint],
    h: f64,
) -> bool {
    for constraint in constraints.iter_mut() {
        constraint.bound = match constraint.was_limited {
            true if constraint.forces.normal_n > 0.0 => NormalBound::Tight,
            true => NormalBound::Open,
            false => NormalBound::Full,
        };
    }
    for _ in 0..=CORRECTIONS {
        match solve_at_bounds::<true>(bodies, body, response, constraints, h) {
            Verdict::Right => return true,
            Verdict::Corrected => {}
            Verdict::Beyond => return false,
        }
    }
    false
}

/// Solves the contacts of a body, each contact at the bound in its [`Constraint::bound`]; without `BELOW_LAW`, all
/// contacts have the force of their law.
// Not inlined: it needs all registers.
#[inline(never)]
fn solve_at_bounds<const BELOW_LAW: bool>(
    bodies: &mut [Velocity],
    body: u32,
    response: &InverseMatrix,
    constraints: &mut [Constraint],
    h: f64,
) -> Verdict {
    let mut push = Push::default();
    let mut stiffness = Stiffness::default();
    let mut walls_rest = true;
    for constraint in &*constraints {
        if constraint.only_floating() != Some(body) {
            return Verdict::Beyond;
        }
        // Written out for both sides, so that the side is a constant.
        match constraint.floating_side() {
            Side::A => add::<BELOW_LAW>(constraint, Side::A, &mut push, &mut stiffness),
            Side::B => add::<BELOW_LAW>(constraint, Side::B, &mut push, &mut stiffness),
        }
        walls_rest &= constraint.movers != Movers::Both;
    }
    if !walls_rest {
        add_moving_fixed::<BELOW_LAW>(bodies, constraints, &mut push);
    }
    let velocity = &mut bodies[body as usize];
    let (free_mps, free_radps) = *velocity;
    let (dv, dr) = push.response(response);
    let system = stiffness.system(response);
    let mut found = system.solve((free_mps + dv, free_radps + dr));
    if BELOW_LAW && !hold(constraints, &system, response, walls_rest, &mut found, &mut push) {
        return Verdict::Beyond;
    }
    let mut verdict = Verdict::Right;
    for constraint in &mut *constraints {
        let of_fixed = if walls_rest { Speeds::default() } else { constraint.after };
        let of_contact = match constraint.floating_side() {
            Side::A => settle::<BELOW_LAW>(constraint, Side::A, found, of_fixed, &mut push, h),
            Side::B => settle::<BELOW_LAW>(constraint, Side::B, found, of_fixed, &mut push, h),
        };
        match of_contact {
            Verdict::Right => {}
            Verdict::Corrected => verdict = Verdict::Corrected,
            Verdict::Beyond => return Verdict::Beyond,
        }
    }
    if verdict == Verdict::Right {
        // The velocity is computed from the sum of the forces, so momentum is conserved to rounding, however stiff the
        // springs are.
        let (dv, dr) = push.response(response);
        *velocity = (free_mps + dv, free_radps + dr);
    } else if BELOW_LAW {
        tighten(constraints);
    }
    verdict
}

/// Finds the contact whose law's force drives the bodies apart fastest beyond γ v_ref, and makes this contact tight.
/// Only this one contact is made tight, because when its force is reduced, the bounds assumed for the other contacts
/// may be right.
fn tighten(constraints: &mut [Constraint]) {
    let mut fastest = None;
    let mut least_mps = 0.0;
    for constraint in constraints {
        let beyond_mps = constraint.after.normal_mps + constraint.rebound_mps;
        if constraint.bound == NormalBound::Full && beyond_mps < least_mps {
            least_mps = beyond_mps;
            fastest = Some(constraint);
        }
    }
    if let Some(constraint) = fastest {
        constraint.bound = NormalBound::Tight;
    }
}

/// Adds a contact to the equations: its forces if both bodies stood still, and the slope of its shear spring. The
/// normal force of a tight contact is added later, by [`hold`].
#[inline(always)]
fn add<const BELOW_LAW: bool>(
    constraint: &Constraint,
    side: Side,
    push: &mut Push,
    stiffness: &mut Stiffness,
) {
    let (jacobian, sign) = (constraint.jacobian(side), side.sign());
    let normal_n = match constraint.bound {
        NormalBound::Tight if BELOW_LAW => 0.0,
        NormalBound::Open if BELOW_LAW => return,
        _ => constraint.law_n,
    };
    push.add(&jacobian, sign * normal_n, sign * constraint.shear.force_at_rest_n);
    stiffness.add(&jacobian, constraint.shear.slope);
}

/// Sets the normal force of each tight contact so that V_n⁺ = −γ v_ref there, and adds the effect of these forces to
/// the body's velocity and to the sum of the contact forces on the body. Returns false if the equations do not
/// determine these normal forces.
///
/// A normal force N changes the velocity of the body by N w, where w is the change by a unit force. The sums Σ_k
/// (j_i·w_k) N_k must bring the normal speed V_n,i⁺ of each tight contact to −γ v_ref.
#[inline(never)]
fn hold(
    constraints: &mut [Constraint],
    system: &System,
    response: &InverseMatrix,
    walls_rest: bool,
    found: &mut Velocity,
    push: &mut Push,
) -> bool {
    let mut tight = [usize::MAX; MOST_TIGHT];
    let mut count = 0;
    for (index, constraint) in constraints.iter().enumerate() {
        if constraint.bound == NormalBound::Tight {
            if count == MOST_TIGHT {
                return false;
            }
            tight[count] = index;
            count += 1;
        }
    }
    let tight = &tight[..count];
    // One equation a row; the rows beyond the tight contacts say N = 0.
    let (mut rows, mut wanted_mps) = ([[1.0, 0.0], [0.0, 1.0]], [0.0; MOST_TIGHT]);
    for (row, &index) in tight.iter().enumerate() {
        let constraint = &constraints[index];
        let (jacobian, sign) = constraint.floating_jacobian();
        for (column, &other) in tight.iter().enumerate() {
            let unit = Push::of_normal(&constraints[other], 1.0);
            let by_unit = system.solve(unit.response(response));
            rows[row][column] = sign * jacobian.speeds(by_unit).normal_mps;
        }
        let of_fixed_mps = if walls_rest { 0.0 } else { constraint.after.normal_mps };
        let without_mps = of_fixed_mps + sign * jacobian.speeds(*found).normal_mps;
        wanted_mps[row] = -constraint.rebound_mps - without_mps;
    }
    let [[a, b], [c, d]] = rows;
    let determinant = a * d - b * c;
    // Two contacts at one place could share N in any way.
    if determinant.abs() <= 1e-9 * (a * d).abs() {
        return false;
    }
    let [one_mps, two_mps] = wanted_mps;
    let normals_n = [one_mps * d - two_mps * b, two_mps * a - one_mps * c];
    for (&index, normal_n) in tight.iter().zip(normals_n) {
        let normal_n = normal_n / determinant;
        let own = Push::of_normal(&constraints[index], normal_n);
        let (dv, dr) = system.solve(own.response(response));
        (found.0, found.1) = (found.0 + dv, found.1 + dr);
        push.normal_n += own.normal_n;
        push.moment_nm += own.moment_nm;
        constraints[index].forces.normal_n = normal_n;
    }
    true
}

/// Adds the shear of the contacts that the motion of fixed bodies, such as lock gates, causes.
#[cold]
#[inline(never)]
fn add_moving_fixed<const BELOW_LAW: bool>(
    bodies: &[Velocity],
    constraints: &mut [Constraint],
    push: &mut Push,
) {
    for constraint in constraints {
        let side = constraint.floating_side();
        let (fixed, sign) = match side {
            Side::A => (constraint.b, 1.0),
            Side::B => (constraint.a, -1.0),
        };
        let Speeds { normal_mps, tangential_mps } =
            constraint.jacobian(side.other()).speeds(bodies[fixed as usize]);
        constraint.after =
            Speeds { normal_mps: -sign * normal_mps, tangential_mps: -sign * tangential_mps };
        if !BELOW_LAW || constraint.bound != NormalBound::Open {
            push.add_shear(&constraint.jacobian(side), constraint.shear.slope * tangential_mps);
        }
    }
}

/// Sets the forces and speeds of the contact for this velocity of the floating body; `of_fixed` is the part of the
/// speeds that the fixed body's motion adds. Corrects the bound on the normal force N if another bound is right. The
/// bound of a contact at its law's force is corrected elsewhere, by [`tighten`].
#[inline(always)]
fn settle<const BELOW_LAW: bool>(
    constraint: &mut Constraint,
    side: Side,
    velocity: Velocity,
    of_fixed: Speeds,
    push: &mut Push,
    h: f64,
) -> Verdict {
    let (jacobian, sign) = (constraint.jacobian(side), side.sign());
    let Speeds { normal_mps, tangential_mps } = jacobian.speeds(velocity);
    let speeds = Speeds {
        normal_mps: of_fixed.normal_mps + sign * normal_mps,
        tangential_mps: of_fixed.tangential_mps + sign * tangential_mps,
    };
    if BELOW_LAW && constraint.bound != NormalBound::Full {
        let verdict = settle_below_law(constraint, speeds, h);
        if verdict == Verdict::Right && constraint.bound == NormalBound::Tight {
            push.subtract_shear(&jacobian, constraint.shear.slope * tangential_mps);
        }
        return verdict;
    }
    let tangential_n = constraint.shear.force_n(speeds.tangential_mps);
    if !constraint.is_within_bounds(speeds, tangential_n, h) {
        if speeds.normal_mps >= -constraint.rebound_mps {
            return Verdict::Beyond;
        }
        constraint.after = speeds;
        return Verdict::Corrected;
    }
    constraint.set_sticking(speeds, tangential_n);
    push.subtract_shear(&jacobian, constraint.shear.slope * tangential_mps);
    Verdict::Right
}

/// Does the same as [`settle`] for a contact that is tight or open. The normal force of a tight contact is already set.
#[inline(never)]
fn settle_below_law(constraint: &mut Constraint, speeds: Speeds, h: f64) -> Verdict {
    constraint.after = speeds;
    if constraint.bound == NormalBound::Open {
        if speeds.normal_mps > -constraint.rebound_mps {
            constraint.bound = NormalBound::Tight;
            return Verdict::Corrected;
        }
        let k_t = constraint.inverse_mass.tangential;
        let (tangential_n, friction) =
            constraint.shear.solve(speeds.tangential_mps, 0.0, Friction::Stick, k_t, h);
        constraint.forces = Forces { normal_n: 0.0, tangential_n, friction };
        return Verdict::Right;
    }
    let normal_n = constraint.forces.normal_n;
    if normal_n >= constraint.law_n || normal_n <= 0.0 {
        constraint.bound = if normal_n <= 0.0 { NormalBound::Open } else { NormalBound::Full };
        // A rounding error beyond the bound would make the contact tight again.
        constraint.after.normal_mps = -constraint.rebound_mps;
        return Verdict::Corrected;
    }
    let tangential_n = constraint.shear.force_n(speeds.tangential_mps);
    if !constraint.has_energy_and_holds(speeds, normal_n, tangential_n, h) {
        return Verdict::Beyond;
    }
    constraint.forces = Forces { normal_n, tangential_n, friction: Friction::Stick };
    Verdict::Right
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coupled::constraint::Laws;
    use crate::law::friction::Slide;
    use crate::maths::vec2::vec2;
    use crate::model::material::Material;
    use crate::touch::Touch;
    use alloc::vec::Vec;

    const RUBBER: Material = Material {
        stiffness_npm2: 0.0,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e6,
        friction_static: 0.5,
        friction_dynamic: 0.4,
        restitution: 0.1,
    };
    const H: f64 = 0.1;

    /// A ship with a full mass matrix, as body B. She closes on four fenders and slides along them.
    fn ship_on_fenders(
        friction_static: f64,
        closing_mps: f64,
    ) -> (Vec<Velocity>, Vec<InverseMatrix>, Vec<Constraint>) {
        let ship = (vec2(2e-3, -closing_mps), 1e-5);
        let mass = [[9e7, 2e6, 1e8], [2e6, 1.4e8, -4e8], [1e8, -4e8, 5e11]];
        let inverse = InverseMatrix::of(&mass).expect("positive definite");
        let inverses = [InverseMatrix::default(), inverse].to_vec();
        let material = Material { friction_static, ..RUBBER };
        let constraints = (0..4).map(|k| {
            let arms_m =
                [(-80.0, 4.0), (-90.0, -23.0)].map(|(x, y)| vec2(x + 60.0 * f64::from(k), y));
            let touch = Touch {
                shear_m: 1e-3 * f64::from(k - 1),
                v_normal_mps: closing_mps,
                v_tangential_mps: 2e-3,
                ..Touch::at(vec2(0.0, 1.0), arms_m)
            };
            let laws = Laws {
                material: &material,
                law_n: 3e5 + 1e4 * f64::from(k),
                rebound_mps: 0.1 * closing_mps,
                available_j: 1e3,
                shear_available_j: 1e6,
                unbalanced_j: 0.0,
                slide: Slide::Begins,
                was_limited: false,
                h: H,
                kick_s: H,
            };
            let forces = Forces { normal_n: 0.0, tangential_n: 0.0, friction: Friction::Stick };
            Constraint::new((0, &inverses[0]), (1, &inverses[1]), &touch, &laws, forces)
        });
        let constraints = constraints.collect();
        ([Velocity::default(), ship].to_vec(), inverses, constraints)
    }

    /// A sweep over the direct solution changes no contact's forces, to rounding.
    #[test]
    fn the_direct_solution_is_a_fixed_point_of_the_sweep() {
        let moving = (vec2(4e-3, 1e-2), 2e-4);
        for fixed in [Velocity::default(), moving] {
            let (mut bodies, inverses, mut constraints) = ship_on_fenders(0.5, 0.05);
            bodies[0] = fixed;
            if fixed == moving {
                constraints.iter_mut().for_each(|constraint| constraint.movers = Movers::Both);
            }
            let before = bodies[1];
            assert!(solve(&mut bodies, &inverses, &mut constraints, H));
            assert!(bodies[1].0.y > before.0.y, "the fenders push");
            for constraint in &constraints {
                let speeds = constraint.speeds(&bodies);
                let after = constraint.after;
                assert!((after.normal_mps - speeds.normal_mps).abs() < 1e-15, "{constraint:?}");
                assert!(
                    (after.tangential_mps - speeds.tangential_mps).abs() < 1e-15,
                    "{constraint:?}"
                );
                let relaxed = constraint.relaxed(speeds, H);
                assert_eq!(relaxed.friction, Friction::Stick);
                assert_eq!(relaxed.normal_n, constraint.law_n);
                assert!(
                    (relaxed.tangential_n - constraint.forces.tangential_n).abs() < 1e-6,
                    "{constraint:?}"
                );
            }
        }
    }

    /// A sweep changes no contact's forces, to rounding, even if the solve began with a wrong guess which contacts are
    /// below their law's force.
    #[test]
    fn contacts_below_their_law_are_a_fixed_point_of_the_sweep() {
        let moving = (vec2(4e-3, 2e-4), 1e-6);
        let mut open = 0;
        for (fixed, guessed) in [
            (Velocity::default(), 0b0000),
            (Velocity::default(), 0b1001),
            (Velocity::default(), 0b0010),
            (moving, 0b0000),
            (moving, 0b1000),
        ] {
            for closing_mps in [4e-4, 3e-4, 2e-4] {
                let (mut bodies, inverses, mut constraints) = ship_on_fenders(1e3, closing_mps);
                bodies[0] = fixed;
                for (index, constraint) in constraints.iter_mut().enumerate() {
                    constraint.was_limited = guessed >> index & 1 == 1;
                    constraint.forces.normal_n = 1.0;
                    if fixed == moving {
                        constraint.movers = Movers::Both;
                    }
                }
                assert!(solve(&mut bodies, &inverses, &mut constraints, H), "{closing_mps}");
                assert!(constraints.iter().any(|of| of.forces.normal_n < of.law_n));
                open += constraints.iter().filter(|of| of.forces.normal_n == 0.0).count();
                for constraint in &constraints {
                    let relaxed = constraint.relaxed(constraint.speeds(&bodies), H);
                    let off = relaxed.minus(&constraint.forces);
                    let scale_n = 1e-9 * constraint.law_n;
                    assert!(off.normal_n.abs() < scale_n, "{constraint:?} {relaxed:?}");
                    assert!(off.tangential_n.abs() < scale_n, "{constraint:?} {relaxed:?}");
                }
            }
        }
        assert!(open > 0, "some contacts are open");
    }

    #[test]
    fn a_direct_solution_beyond_a_bound_changes_no_body() {
        let (bodies, inverses, mut constraints) = ship_on_fenders(1e-3, 0.05);
        let mut tried = bodies.clone();
        assert!(!solve(&mut tried, &inverses, &mut constraints, H), "friction cannot hold");
        assert_eq!(tried, bodies);
    }
}
