//! The equations of the direct solve: the contact forces on a body, and the stiffness with which shear springs hold the
//! body.

use crate::coupled::constraint::{Constraint, Jacobian};
use crate::maths::vec2::{Vec2, vec2};
use crate::model::mass::InverseMatrix;
use crate::state::body_state::Velocity;

/// Sum of the contact forces −N n + T t on the floating body, and the moment of this sum. N and T are the normal and
/// the tangential force on the floating body.
#[derive(Clone, Copy, Default)]
pub(super) struct Push {
    /// The sums Σ N n and Σ T n: the quarter turn from n to t is applied only once, to the sum.
    pub(super) normal_n: Vec2,
    tangential_n: Vec2,
    pub(super) moment_nm: f64,
}

impl Push {
    /// The force and moment that the normal force N of this contact alone exerts on the floating body.
    pub(super) fn of_normal(constraint: &Constraint, normal_n: f64) -> Push {
        let (jacobian, sign) = constraint.floating_jacobian();
        Push {
            normal_n: jacobian.normal * (sign * normal_n),
            moment_nm: -jacobian.levers.n_m * (sign * normal_n),
            ..Push::default()
        }
    }

    #[inline(always)]
    pub(super) fn add(&mut self, jacobian: &Jacobian, normal_n: f64, tangential_n: f64) {
        self.normal_n += jacobian.normal * normal_n;
        self.moment_nm -= jacobian.levers.n_m * normal_n;
        self.add_shear(jacobian, tangential_n);
    }

    #[inline(always)]
    pub(super) fn add_shear(&mut self, jacobian: &Jacobian, tangential_n: f64) {
        self.tangential_n += jacobian.normal * tangential_n;
        self.moment_nm += jacobian.levers.t_m * tangential_n;
    }

    #[inline(always)]
    pub(super) fn subtract_shear(&mut self, jacobian: &Jacobian, tangential_n: f64) {
        self.tangential_n -= jacobian.normal * tangential_n;
        self.moment_nm -= jacobian.levers.t_m * tangential_n;
    }

    /// The change of velocity and yaw rate that the push causes; `response` is h M⁻¹.
    #[inline(always)]
    pub(super) fn response(&self, response: &InverseMatrix) -> Velocity {
        let force_n = self.tangential_n.quarter_turn() - self.normal_n;
        response.response(force_n, self.moment_nm)
    }
}

/// Symmetric stiffness matrix C = Σ c j_t j_tᵀ of the shear springs, for x, y and yaw.
#[derive(Clone, Copy, Default)]
pub(super) struct Stiffness {
    xx: f64,
    xy: f64,
    yy: f64,
    xr: f64,
    yr: f64,
    rr: f64,
}

impl Stiffness {
    #[inline(always)]
    pub(super) fn add(&mut self, jacobian: &Jacobian, slope: f64) {
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

    /// The matrix 1 + h M⁻¹ C of the equations; it can be inverted because M + h C is positive definite.
    #[inline]
    pub(super) fn system(&self, response: &InverseMatrix) -> System {
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
        let b_c = cross(b, c);
        System { a, b, c, b_c, scale: 1.0 / dot(a, b_c) }
    }
}

/// A system of three equations, given by the columns of its matrix.
pub(super) struct System {
    a: [f64; 3],
    b: [f64; 3],
    c: [f64; 3],
    /// The cross product b × c of two columns, and 1 over the determinant of the matrix.
    b_c: [f64; 3],
    scale: f64,
}

impl System {
    /// Solves the system (a b c) v = `free` for v by Cramer's rule.
    #[inline]
    pub(super) fn solve(&self, (dv, dr): Velocity) -> Velocity {
        let System { a, b, c, b_c, scale } = *self;
        let free = [dv.x, dv.y, dr];
        let a_free = cross(a, free);
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
