//! The solve at once, where nothing is at a limit: most of the sub-steps of most contacts.
//!
//! With N_i = f_i, and T_i the implicit shear spring's force while it sticks, which is a line in V_t⁺,
//!
//! T_i = T_i(V_t free) − c_i j_t·Δv,  c_i = ϑ² k_s h,
//!
//! the velocities of an island's one floating body follow from a system of three equations, whatever the number
//! of its contacts:
//!
//! (1 + h M⁻¹ Σ c_i j_t j_tᵀ) Δv = h M⁻¹ Σ (−f_i j_n + T_i(V_t free) j_t).
//!
//! It is the sweeps' answer where none of the bounds on N and T is reached with it, which is then asked of
//! each contact; else the sweeps have to find which are.

use crate::coupled::tie::{Forces, Tie};
use crate::mass::InverseMatrix;
use crate::report::Friction;
use crate::state::{BodyState, Velocity};
use crate::vec2::{Vec2, vec2};

/// New velocities in `states` and forces in `ties`, from velocities without contact. False, and neither
/// changed, where a bound would be passed or more than one body floats.
pub(crate) fn solve(
    states: &mut [BodyState],
    inverses: &[InverseMatrix],
    ties: &mut [Tie],
    h: f64,
) -> bool {
    let Some(body) = only_floating(ties) else { return false };
    let inverse = &inverses[body as usize];
    let mut normal = Momentum::default();
    let mut tangential = Momentum::default();
    let mut stiffness = Stiffness::default();
    for tie in ties.iter_mut() {
        tie.after_mps = tie.speeds(states);
        let side = tie.side_of(body);
        normal.add(side.normal, -side.sign * tie.law_n);
        tangential.add(side.tangential, side.sign * tie.spring_n(tie.after_mps.1));
        stiffness.add(side.tangential, tie.spring_slope());
    }
    let pushed = normal.plus(&tangential).response(inverse, h);
    let change = stiffness.hold(inverse, h, pushed);

    tangential = Momentum::default();
    let mut within_bounds = true;
    for tie in ties.iter_mut() {
        let side = tie.side_of(body);
        let (normal_mps, tangential_mps) = tie.after_mps;
        tie.after_mps = (
            normal_mps + side.sign * along(side.normal, change),
            tangential_mps + side.sign * along(side.tangential, change),
        );
        let tangential_n = tie.spring_n(tie.after_mps.1);
        within_bounds &= tie.is_within_bounds(tie.after_mps, tangential_n, h);
        tangential.add(side.tangential, side.sign * tangential_n);
    }
    if !within_bounds {
        return false;
    }
    for tie in ties {
        tie.forces = Forces {
            normal_n: tie.law_n,
            tangential_n: tie.spring_n(tie.after_mps.1),
            friction: Friction::Stick,
        };
    }
    // By the forces themselves, so that not a bit of momentum is lost.
    let (dv, dr) = normal.plus(&tangential).response(inverse, h);
    let state = &mut states[body as usize];
    state.velocity_mps += dv;
    state.yaw_rate_radps += dr;
    true
}

/// j·v.
#[inline]
fn along([x, y, lever_m]: [f64; 3], (velocity_mps, turn_radps): Velocity) -> f64 {
    vec2(x, y).dot(velocity_mps) + lever_m * turn_radps
}

/// The one body that floats, where there is no more than one.
#[inline]
fn only_floating(ties: &[Tie]) -> Option<u32> {
    let first = match ties.first()?.floating() {
        [Some(rank), None] | [None, Some(rank)] => rank,
        _ => return None,
    };
    let alike =
        |tie: &Tie| tie.floating() == [Some(first), None] || tie.floating() == [None, Some(first)];
    ties.iter().all(alike).then_some(first)
}

/// Σ F j: a force and its moment [N, N·m].
#[derive(Clone, Copy, Default)]
struct Momentum {
    force_n: Vec2,
    moment_nm: f64,
}

impl Momentum {
    #[inline]
    fn add(&mut self, [x, y, lever_m]: [f64; 3], force_n: f64) {
        self.force_n += vec2(x, y) * force_n;
        self.moment_nm += lever_m * force_n;
    }

    #[inline]
    fn plus(&self, other: &Momentum) -> Momentum {
        Momentum {
            force_n: self.force_n + other.force_n,
            moment_nm: self.moment_nm + other.moment_nm,
        }
    }

    /// h M⁻¹ of it: a change of velocity and yaw rate.
    #[inline]
    fn response(&self, inverse: &InverseMatrix, h: f64) -> (Vec2, f64) {
        inverse.response(self.force_n * h, self.moment_nm * h)
    }
}

/// Σ c j jᵀ, symmetric: columns of x, y and yaw.
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
    #[inline]
    fn add(&mut self, [x, y, lever_m]: [f64; 3], slope: f64) {
        let (of_x, of_y, of_r) = (slope * x, slope * y, slope * lever_m);
        self.xx += of_x * x;
        self.xy += of_x * y;
        self.yy += of_y * y;
        self.xr += of_x * lever_m;
        self.yr += of_y * lever_m;
        self.rr += of_r * lever_m;
    }

    /// v of (1 + h M⁻¹ C) v = `free`, by Cramer's rule: M + h C is positive definite.
    #[inline]
    fn hold(&self, inverse: &InverseMatrix, h: f64, (dv, dr): (Vec2, f64)) -> (Vec2, f64) {
        let column = |x: f64, y: f64, r: f64| {
            let (linear, turn) = inverse.response(vec2(x, y) * h, r * h);
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
    use crate::model::Material;
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
    fn ship_on_fenders(friction_static: f64) -> (Vec<BodyState>, Vec<InverseMatrix>, Vec<Tie>) {
        let ship = BodyState {
            velocity_mps: vec2(2e-3, -0.05),
            yaw_rate_radps: 1e-5,
            ..BodyState::default()
        };
        let mass = [[9e7, 2e6, 1e8], [2e6, 1.4e8, -4e8], [1e8, -4e8, 5e11]];
        let inverse = InverseMatrix::of(&mass).expect("positive definite");
        let inverses = [InverseMatrix::default(), inverse].to_vec();
        let material = Material { friction_static, ..RUBBER };
        let ties = (0..4).map(|k| {
            let touch = Touch {
                normal: vec2(0.0, 1.0),
                arm_b_m: vec2(-90.0 + 60.0 * f64::from(k), -23.0),
                shear_m: 1e-3 * f64::from(k - 1),
                v_normal_mps: 0.05,
                v_tangential_mps: 2e-3,
                ..Touch::default()
            };
            let laws = Laws {
                material: &material,
                law_n: 3e5 + 1e4 * f64::from(k),
                rebound_mps: 5e-3,
                may_give_j: 1e3,
                may_shear_j: 1e6,
            };
            let forces = Forces { normal_n: 0.0, tangential_n: 0.0, friction: Friction::Stick };
            Tie::new((0, &inverses[0]), (1, &inverses[1]), &touch, &laws, forces, H)
        });
        let ties = ties.collect();
        ([BodyState::default(), ship].to_vec(), inverses, ties)
    }

    /// To rounding: each contact's forces are those that it would have with all others' as they are.
    #[test]
    fn the_direct_solve_is_where_a_sweep_changes_nothing() {
        let (mut states, inverses, mut ties) = ship_on_fenders(0.5);
        let before = states[1];
        assert!(solve(&mut states, &inverses, &mut ties, H));
        assert!(states[1].velocity_mps.y > before.velocity_mps.y, "the fenders push");
        for tie in &ties {
            let relaxed = tie.relaxed(tie.speeds(&states), H);
            assert_eq!(relaxed.friction, Friction::Stick);
            assert_eq!(relaxed.normal_n, tie.law_n);
            assert!((relaxed.tangential_n - tie.forces.tangential_n).abs() < 1e-6, "{tie:?}");
        }
    }

    #[test]
    fn where_a_bound_would_be_passed_nothing_changes() {
        let (states, inverses, ties) = ship_on_fenders(1e-3);
        let (mut tried, mut tried_ties) = (states.clone(), ties.clone());
        assert!(!solve(&mut tried, &inverses, &mut tried_ties, H), "friction cannot hold");
        assert_eq!(tried, states);
        for (one, other) in tried_ties.iter().zip(&ties) {
            assert_eq!(one.forces, other.forces);
        }
    }
}
