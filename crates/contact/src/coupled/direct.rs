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
use crate::state::BodyState;
use crate::vec2::{Vec2, vec2};

/// New velocities in `states` and forces in `ties`, from velocities without contact. False, and nothing
/// changed, where a bound would be passed or more than one body floats.
pub(crate) fn solve(
    states: &mut [BodyState],
    inverses: &[InverseMatrix],
    ties: &mut [Tie],
    h: f64,
) -> bool {
    let Some(body) = only_floating(ties) else { return false };
    let free = states[body as usize];
    let inverse = &inverses[body as usize];
    let mut normal = Momentum::default();
    let mut tangential = Momentum::default();
    let mut stiffness = Stiffness::default();
    for tie in &*ties {
        let (_, tangential_mps) = tie.speeds(states);
        normal.add(tie.normal_row_of(body), -tie.law_n);
        let along_t = tie.tangential_row_of(body);
        tangential.add(along_t, tie.spring_n(tangential_mps));
        stiffness.add(along_t, tie.spring_slope());
    }
    let pushed = normal.plus(&tangential).response(inverse, h);
    states[body as usize] = changed(&free, stiffness.hold(inverse, h, pushed));

    tangential = Momentum::default();
    for tie in ties.iter_mut() {
        let speeds = tie.speeds(states);
        let tangential_n = tie.spring_n(speeds.1);
        if !tie.is_within_bounds(speeds, tangential_n, h) {
            states[body as usize] = free;
            return false;
        }
        tangential.add(tie.tangential_row_of(body), tangential_n);
        tie.trial_tangential_n = tangential_n;
    }
    for tie in ties {
        tie.forces = Forces {
            normal_n: tie.law_n,
            tangential_n: tie.trial_tangential_n,
            friction: Friction::Stick,
        };
    }
    // By the forces themselves, so that not a bit of momentum is lost.
    states[body as usize] = changed(&free, normal.plus(&tangential).response(inverse, h));
    true
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

#[inline]
fn changed(state: &BodyState, (dv, dr): (Vec2, f64)) -> BodyState {
    BodyState {
        velocity_mps: state.velocity_mps + dv,
        yaw_rate_radps: state.yaw_rate_radps + dr,
        ..*state
    }
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
