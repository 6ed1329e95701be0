//! The solve at once, where nothing is at a limit: most of the sub-steps of most contacts.
//!
//! With N_i = f_i, and T_i the implicit shear spring's force while it sticks, which is a line in V_t⁺,
//!
//! T_i = T_i(V_t⁺ = 0) − c_i V_t,i⁺,  c_i = ϑ² k_s h,
//!
//! the velocities v⁺ of an island's one floating body follow from a system of three equations, whatever the number
//! of its contacts, here with walls that stand still:
//!
//! (1 + h M⁻¹ Σ c_i j_t j_tᵀ) v⁺ = v_free + h M⁻¹ Σ (−f_i j_n + T_i(0) j_t).
//!
//! It is the sweeps' answer where none of the bounds on N and T is reached with it, which is then asked of
//! each contact; else the sweeps have to find which are.

use crate::coupled::tie::{Grip, Side, Tie};
use crate::mass::InverseMatrix;
use crate::state::Velocity;
use crate::touch::Movers;
use crate::vec2::{Vec2, vec2};

/// New velocities of `bodies` and forces in `ties`, from velocities without contact. False where a bound would be
/// passed or more than one body floats: `bodies` are unchanged then, not so the forces.
// Apart: it needs all registers.
#[inline(never)]
pub(crate) fn solve(
    bodies: &mut [Velocity],
    inverses: &[InverseMatrix],
    ties: &mut [Tie],
    h: f64,
) -> bool {
    let Some(body) = ties.first().and_then(Tie::only_floating) else { return false };
    let of_force = inverses[body as usize].times(h);
    let mut push = Push::default();
    let mut stiffness = Stiffness::default();
    let mut walls_rest = true;
    for tie in &*ties {
        if tie.only_floating() != Some(body) {
            return false;
        }
        // Twice the same, so that no sign is asked for.
        match tie.floating_side() {
            Side::A => take(tie, Side::A, &mut push, &mut stiffness),
            Side::B => take(tie, Side::B, &mut push, &mut stiffness),
        }
        walls_rest &= tie.movers != Movers::Both;
    }
    if !walls_rest {
        take_walls(bodies, ties, &mut push);
    }
    let velocity = &mut bodies[body as usize];
    let (free_mps, free_radps) = *velocity;
    let (dv, dr) = push.response(&of_force);
    let found = stiffness.hold(&of_force, (free_mps + dv, free_radps + dr));
    for tie in ties {
        let of_wall_mps = if walls_rest { (0.0, 0.0) } else { tie.after_mps };
        let sticks = match tie.floating_side() {
            Side::A => stick(tie, Side::A, found, of_wall_mps, (&mut push, h)),
            Side::B => stick(tie, Side::B, found, of_wall_mps, (&mut push, h)),
        };
        if !sticks {
            return false;
        }
    }
    // By the forces themselves: no momentum is lost but by rounding, however stiff the springs.
    let (dv, dr) = push.response(&of_force);
    *velocity = (free_mps + dv, free_radps + dr);
    true
}

/// Takes in a contact whose body on this side floats: its forces if both its bodies stood still, and what its
/// shear spring loses with the velocity of that body.
#[inline(always)]
fn take(tie: &Tie, side: Side, push: &mut Push, stiffness: &mut Stiffness) {
    let (grip, sign) = (tie.grip(side), side.sign());
    push.add(&grip, sign * tie.law_n, sign * tie.spring_at_rest_n());
    stiffness.add(&grip, tie.spring_slope());
}

/// And what their other bodies do to them, which do not float but may move, as lock gates do.
#[cold]
#[inline(never)]
fn take_walls(bodies: &[Velocity], ties: &mut [Tie], push: &mut Push) {
    for tie in ties {
        let side = tie.floating_side();
        let (wall, sign) = match side {
            Side::A => (tie.b, 1.0),
            Side::B => (tie.a, -1.0),
        };
        let (normal_mps, tangential_mps) = tie.grip(side.other()).speeds(bodies[wall as usize]);
        tie.after_mps = (-sign * normal_mps, -sign * tangential_mps);
        push.shear(&tie.grip(side), tie.spring_slope() * tangential_mps);
    }
}

/// Its forces and speeds if the body moves so, and its wall makes so much of the speeds. False where a bound would be
/// passed.
#[inline(always)]
fn stick(
    tie: &mut Tie,
    side: Side,
    moves: Velocity,
    of_wall_mps: (f64, f64),
    (push, h): (&mut Push, f64),
) -> bool {
    let (grip, sign) = (tie.grip(side), side.sign());
    let (normal_mps, tangential_mps) = grip.speeds(moves);
    let speeds = (of_wall_mps.0 + sign * normal_mps, of_wall_mps.1 + sign * tangential_mps);
    let tangential_n = tie.spring_n(speeds.1);
    if !tie.is_within_bounds(speeds, tangential_n, h) {
        return false;
    }
    tie.stick(speeds, tangential_n);
    push.lose_shear(&grip, tie.spring_slope() * tangential_mps);
    true
}

/// Σ (−N n + T t) and its moment on the floating body, with N and T as they act on it: as B it feels their
/// opposites.
#[derive(Clone, Copy, Default)]
struct Push {
    /// Σ N n and Σ T n: what is turned is turned once for all.
    normal_n: Vec2,
    tangential_n: Vec2,
    moment_nm: f64,
}

impl Push {
    #[inline(always)]
    fn add(&mut self, grip: &Grip, normal_n: f64, tangential_n: f64) {
        self.normal_n += grip.along_n * normal_n;
        self.moment_nm -= grip.levers.n_m * normal_n;
        self.shear(grip, tangential_n);
    }

    #[inline(always)]
    fn shear(&mut self, grip: &Grip, tangential_n: f64) {
        self.tangential_n += grip.along_n * tangential_n;
        self.moment_nm += grip.levers.t_m * tangential_n;
    }

    #[inline(always)]
    fn lose_shear(&mut self, grip: &Grip, tangential_n: f64) {
        self.tangential_n -= grip.along_n * tangential_n;
        self.moment_nm -= grip.levers.t_m * tangential_n;
    }

    /// The change of velocity and yaw rate by it, with h M⁻¹.
    #[inline(always)]
    fn response(&self, of_force: &InverseMatrix) -> (Vec2, f64) {
        let force_n = self.tangential_n.quarter_turn() - self.normal_n;
        of_force.response(force_n, self.moment_nm)
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
    fn add(&mut self, grip: &Grip, slope: f64) {
        // t = (−n_y, n_x).
        let (Vec2 { x, y }, lever_m) = (grip.along_n, grip.levers.t_m);
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
    fn hold(&self, of_force: &InverseMatrix, (dv, dr): (Vec2, f64)) -> (Vec2, f64) {
        let column = |x: f64, y: f64, r: f64| {
            let (linear, turn) = of_force.response(vec2(x, y), r);
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
    use crate::coupled::rows::Laws;
    use crate::coupled::tie::Forces;
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

    /// A ship that closes on four fenders and slides along them, as body B: her inverse masses are coupled.
    fn ship_on_fenders(friction_static: f64) -> (Vec<Velocity>, Vec<InverseMatrix>, Vec<Tie>) {
        let ship = (vec2(2e-3, -0.05), 1e-5);
        let mass = [[9e7, 2e6, 1e8], [2e6, 1.4e8, -4e8], [1e8, -4e8, 5e11]];
        let inverse = InverseMatrix::of(&mass).expect("positive definite");
        let inverses = [InverseMatrix::default(), inverse].to_vec();
        let material = Material { friction_static, ..RUBBER };
        let ties = (0..4).map(|k| {
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
                may_give_j: 1e3,
                may_shear_j: 1e6,
                unheld_j: 0.0,
            };
            let forces = Forces { normal_n: 0.0, tangential_n: 0.0, friction: Friction::Stick };
            Tie::new((0, &inverses[0]), (1, &inverses[1]), &touch, &laws, forces, H)
        });
        let ties = ties.collect();
        ([Velocity::default(), ship].to_vec(), inverses, ties)
    }

    /// To rounding: each contact's forces are those that it would have with all others' as they are.
    #[test]
    fn the_direct_solve_is_where_a_sweep_changes_nothing() {
        let moving = (vec2(4e-3, 1e-2), 2e-4);
        for wall in [Velocity::default(), moving] {
            let (mut bodies, inverses, mut ties) = ship_on_fenders(0.5);
            bodies[0] = wall;
            if wall == moving {
                ties.iter_mut().for_each(|tie| tie.movers = Movers::Both);
            }
            let before = bodies[1];
            assert!(solve(&mut bodies, &inverses, &mut ties, H));
            assert!(bodies[1].0.y > before.0.y, "the fenders push");
            for tie in &ties {
                let (normal_mps, tangential_mps) = tie.speeds(&bodies);
                assert!((tie.after_mps.0 - normal_mps).abs() < 1e-15, "{tie:?}");
                assert!((tie.after_mps.1 - tangential_mps).abs() < 1e-15, "{tie:?}");
                let relaxed = tie.relaxed((normal_mps, tangential_mps), H);
                assert_eq!(relaxed.friction, Friction::Stick);
                assert_eq!(relaxed.normal_n, tie.law_n);
                assert!((relaxed.tangential_n - tie.forces.tangential_n).abs() < 1e-6, "{tie:?}");
            }
        }
    }

    #[test]
    fn where_a_bound_would_be_passed_no_body_changes() {
        let (bodies, inverses, mut ties) = ship_on_fenders(1e-3);
        let mut tried = bodies.clone();
        assert!(!solve(&mut tried, &inverses, &mut ties, H), "friction cannot hold");
        assert_eq!(tried, bodies);
    }
}
