//! The direct solve: all forces at once, for an island with one floating body and no force at a bound. Most sub-steps of
//! most islands are of this kind.
//!
//! With N_i = f_i, and T_i the implicit shear spring's force while it sticks, which is a line in V_t⁺,
//!
//! T_i = T_i(V_t⁺ = 0) − c_i V_t,i⁺,  c_i = ϑ² k_s h,
//!
//! the body's velocity v⁺ follows from a system of three equations, whatever the number of contacts. With fixed bodies at
//! rest it is
//!
//! (1 + h M⁻¹ Σ c_i j_t j_tᵀ) v⁺ = v_free + h M⁻¹ Σ (−f_i j_n + T_i(0) j_t).
//!
//! This is the sweeps' answer if it reaches none of the bounds on N and T. That is tested for each contact; if one fails,
//! the sweeps have to find which bounds are reached.

use crate::coupled::constraint::{Constraint, Jacobian, Side, Speeds};
use crate::mass::InverseMatrix;
use crate::state::Velocity;
use crate::touch::Movers;
use crate::vec2::{Vec2, vec2};

/// Computes the new velocity in `bodies` and the forces in `constraints`, from velocities without contact. Returns false
/// if a bound would be passed or more than one body floats: `bodies` are unchanged then, the forces undefined.
// Not inlined: it needs all registers.
#[inline(never)]
pub(crate) fn solve(
    bodies: &mut [Velocity],
    inverses: &[InverseMatrix],
    constraints: &mut [Constraint],
    h: f64,
) -> bool {
    let Some(body) = constraints.first().and_then(Constraint::only_floating) else { return false };
    let response = inverses[body as usize].times(h);
    let mut push = Push::default();
    let mut stiffness = Stiffness::default();
    let mut walls_rest = true;
    for constraint in &*constraints {
        if constraint.only_floating() != Some(body) {
            return false;
        }
        // Written out for both sides, so that the side is a constant.
        match constraint.floating_side() {
            Side::A => add(constraint, Side::A, &mut push, &mut stiffness),
            Side::B => add(constraint, Side::B, &mut push, &mut stiffness),
        }
        walls_rest &= constraint.movers != Movers::Both;
    }
    if !walls_rest {
        add_moving_fixed(bodies, constraints, &mut push);
    }
    let velocity = &mut bodies[body as usize];
    let (free_mps, free_radps) = *velocity;
    let (dv, dr) = push.response(&response);
    let found = stiffness.solve(&response, (free_mps + dv, free_radps + dr));
    for constraint in constraints {
        let of_fixed = if walls_rest { Speeds::default() } else { constraint.after };
        let sticks = match constraint.floating_side() {
            Side::A => stick(constraint, Side::A, found, of_fixed, &mut push, h),
            Side::B => stick(constraint, Side::B, found, of_fixed, &mut push, h),
        };
        if !sticks {
            return false;
        }
    }
    // From the sum of the forces: so momentum is conserved to rounding, however stiff the springs.
    let (dv, dr) = push.response(&response);
    *velocity = (free_mps + dv, free_radps + dr);
    true
}

/// Adds a contact: its forces if both bodies stood still, and the slope of its shear spring.
#[inline(always)]
fn add(constraint: &Constraint, side: Side, push: &mut Push, stiffness: &mut Stiffness) {
    let (jacobian, sign) = (constraint.jacobian(side), side.sign());
    push.add(&jacobian, sign * constraint.law_n, sign * constraint.shear.force_at_rest_n);
    stiffness.add(&jacobian, constraint.shear.slope);
}

/// Adds the shear by the motion of fixed bodies, such as lock gates.
#[cold]
#[inline(never)]
fn add_moving_fixed(bodies: &[Velocity], constraints: &mut [Constraint], push: &mut Push) {
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
        push.add_shear(&constraint.jacobian(side), constraint.shear.slope * tangential_mps);
    }
}

/// Sets forces and speeds for this velocity of the floating body; `of_fixed` is the fixed body's part of the speeds.
/// Returns false if a bound would be passed.
#[inline(always)]
fn stick(
    constraint: &mut Constraint,
    side: Side,
    velocity: Velocity,
    of_fixed: Speeds,
    push: &mut Push,
    h: f64,
) -> bool {
    let (jacobian, sign) = (constraint.jacobian(side), side.sign());
    let Speeds { normal_mps, tangential_mps } = jacobian.speeds(velocity);
    let speeds = Speeds {
        normal_mps: of_fixed.normal_mps + sign * normal_mps,
        tangential_mps: of_fixed.tangential_mps + sign * tangential_mps,
    };
    let tangential_n = constraint.shear.force_n(speeds.tangential_mps);
    if !constraint.is_within_bounds(speeds, tangential_n, h) {
        return false;
    }
    constraint.set_sticking(speeds, tangential_n);
    push.subtract_shear(&jacobian, constraint.shear.slope * tangential_mps);
    true
}

/// Σ (−N n + T t) and its moment on the floating body, with N and T as they act on it.
#[derive(Clone, Copy, Default)]
struct Push {
    /// Σ N n and Σ T n: the quarter turn from n to t is taken once, of the sum.
    normal_n: Vec2,
    tangential_n: Vec2,
    moment_nm: f64,
}

impl Push {
    #[inline(always)]
    fn add(&mut self, jacobian: &Jacobian, normal_n: f64, tangential_n: f64) {
        self.normal_n += jacobian.normal * normal_n;
        self.moment_nm -= jacobian.levers.n_m * normal_n;
        self.add_shear(jacobian, tangential_n);
    }

    #[inline(always)]
    fn add_shear(&mut self, jacobian: &Jacobian, tangential_n: f64) {
        self.tangential_n += jacobian.normal * tangential_n;
        self.moment_nm += jacobian.levers.t_m * tangential_n;
    }

    #[inline(always)]
    fn subtract_shear(&mut self, jacobian: &Jacobian, tangential_n: f64) {
        self.tangential_n -= jacobian.normal * tangential_n;
        self.moment_nm -= jacobian.levers.t_m * tangential_n;
    }

    /// The change of velocity and yaw rate, with h M⁻¹.
    #[inline(always)]
    fn response(&self, response: &InverseMatrix) -> (Vec2, f64) {
        let force_n = self.tangential_n.quarter_turn() - self.normal_n;
        response.response(force_n, self.moment_nm)
    }
}

/// C = Σ c j_t j_tᵀ, symmetric: columns of x, y and yaw.
#[derive(Clone, Copy, Default)]
struct Stiffness {
    xx: f64,
    xy: f64,
    yy: f64,
    xr: f64,
    yr: f64,
    rr: f64,
}

impl Stiffness {
    #[inline(always)]
    fn add(&mut self, jacobian: &Jacobian, slope: f64) {
        // t = (−n_y, n_x).
        let (Vec2 { x, y }, lever_m) = (jacobian.normal, jacobian.levers.t_m);
        let (of_x, of_y, of_r) = (slope * x, slope * y, slope * lever_m);
        self.xx += of_y * y;
        self.xy -= of_x * y;
        self.yy += of_x * x;
        self.xr -= of_y * lever_m;
        self.yr += of_x * lever_m;
        self.rr += of_r * lever_m;
    }

    /// v of (1 + h M⁻¹ C) v = `free`, by Cramer's rule: M + h C is positive definite.
    #[inline]
    fn solve(&self, response: &InverseMatrix, (dv, dr): (Vec2, f64)) -> (Vec2, f64) {
        let column = |x: f64, y: f64, r: f64| {
            let (linear, turn) = response.response(vec2(x, y), r);
            [linear.x, linear.y, turn]
        };
        let mut a = column(self.xx, self.xy, self.xr);
        let mut b = column(self.xy, self.yy, self.yr);
        let mut c = column(self.xr, self.yr, self.rr);
        a[0] += 1.0;
        b[1] += 1.0;
        c[2] += 1.0;
        let free = [dv.x, dv.y, dr];
        let b_c = cross(b, c);
        let a_free = cross(a, free);
        let scale = 1.0 / dot(a, b_c);
        (vec2(dot(free, b_c), dot(c, a_free)) * scale, -dot(b, a_free) * scale)
    }
}

#[inline]
fn dot(p: [f64; 3], q: [f64; 3]) -> f64 {
    p[0] * q[0] + p[1] * q[1] + p[2] * q[2]
}

#[inline]
fn cross(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coupled::constraint::{Forces, Laws};
    use crate::law::friction::Slide;
    use crate::material::Material;
    use crate::report::Friction;
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

    /// A ship that closes on four fenders and slides along them, as body B, with a full mass matrix.
    fn ship_on_fenders(
        friction_static: f64,
    ) -> (Vec<Velocity>, Vec<InverseMatrix>, Vec<Constraint>) {
        let ship = (vec2(2e-3, -0.05), 1e-5);
        let mass = [[9e7, 2e6, 1e8], [2e6, 1.4e8, -4e8], [1e8, -4e8, 5e11]];
        let inverse = InverseMatrix::of(&mass).expect("positive definite");
        let inverses = [InverseMatrix::default(), inverse].to_vec();
        let material = Material { friction_static, ..RUBBER };
        let constraints = (0..4).map(|k| {
            let arms_m =
                [(-80.0, 4.0), (-90.0, -23.0)].map(|(x, y)| vec2(x + 60.0 * f64::from(k), y));
            let touch = Touch {
                shear_m: 1e-3 * f64::from(k - 1),
                v_normal_mps: 0.05,
                v_tangential_mps: 2e-3,
                ..Touch::at(vec2(0.0, 1.0), arms_m)
            };
            let laws = Laws {
                material: &material,
                law_n: 3e5 + 1e4 * f64::from(k),
                rebound_mps: 5e-3,
                available_j: 1e3,
                shear_available_j: 1e6,
                unbalanced_j: 0.0,
                slide: Slide::Begins,
                h: H,
                kick_s: H,
            };
            let forces = Forces { normal_n: 0.0, tangential_n: 0.0, friction: Friction::Stick };
            Constraint::new((0, &inverses[0]), (1, &inverses[1]), &touch, &laws, forces)
        });
        let constraints = constraints.collect();
        ([Velocity::default(), ship].to_vec(), inverses, constraints)
    }

    /// To rounding: each contact's forces are those that it would have with all others' as they are.
    #[test]
    fn the_direct_solution_is_a_fixed_point_of_the_sweep() {
        let moving = (vec2(4e-3, 1e-2), 2e-4);
        for fixed in [Velocity::default(), moving] {
            let (mut bodies, inverses, mut constraints) = ship_on_fenders(0.5);
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

    #[test]
    fn a_direct_solution_beyond_a_bound_changes_no_body() {
        let (bodies, inverses, mut constraints) = ship_on_fenders(1e-3);
        let mut tried = bodies.clone();
        assert!(!solve(&mut tried, &inverses, &mut constraints, H), "friction cannot hold");
        assert_eq!(tried, bodies);
    }
}
