//! The full mass matrix of a body in the plane, and its inverse.

use crate::maths::vec2::{Rotation, Vec2, vec2};
use crate::touch::levers::Levers;

/// Inverse of the symmetric 3×3 mass matrix of a body for surge, sway and yaw (1/kg, 1/(kg·m), 1/(kg·m²)). All numbers
/// are zero for a fixed body: an inverse matrix avoids infinities.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct InverseMatrix {
    xx: f64,
    xy: f64,
    yy: f64,
    xr: f64,
    yr: f64,
    rr: f64,
}

impl InverseMatrix {
    /// The inverse mass matrix of a body with the same mass in all directions.
    pub(crate) fn isotropic(mass_kg: f64, yaw_inertia_kgm2: f64) -> InverseMatrix {
        let inverse = 1.0 / mass_kg;
        InverseMatrix { xx: inverse, yy: inverse, rr: 1.0 / yaw_inertia_kgm2, ..Self::default() }
    }

    /// The inverse mass matrix of a body that does not turn and has the same mass in all directions (1/kg).
    pub(crate) fn unturnable(per_kg: f64) -> InverseMatrix {
        InverseMatrix { xx: per_kg, yy: per_kg, ..Self::default() }
    }

    /// Inverts a symmetric mass matrix; returns `None` if the matrix is not positive definite.
    pub(crate) fn of(m: &[[f64; 3]; 3]) -> Option<InverseMatrix> {
        let [[a, b, c], [_, d, e], [_, _, f]] = *m;
        let (minor_xx, minor_xy, minor_xr) = (d * f - e * e, c * e - b * f, b * e - c * d);
        let determinant = a * minor_xx + b * minor_xy + c * minor_xr;
        // Sylvester's criterion.
        if !(a > 0.0 && a * d - b * b > 0.0 && determinant > 0.0 && determinant.is_finite()) {
            return None;
        }
        let scale = 1.0 / determinant;
        Some(InverseMatrix {
            xx: minor_xx * scale,
            xy: minor_xy * scale,
            xr: minor_xr * scale,
            yy: (a * f - c * c) * scale,
            yr: (b * c - a * e) * scale,
            rr: (a * d - b * b) * scale,
        })
    }

    /// The inverse mass matrix in earth-fixed axes, for a body turned by `rotation`. An isotropic matrix does not
    /// change when the body turns, and needs no call.
    #[inline]
    pub(crate) fn turned(&self, rotation: Rotation) -> InverseMatrix {
        let Rotation { cos, sin } = rotation;
        let (cc, ss, cs) = (cos * cos, sin * sin, cos * sin);
        InverseMatrix {
            xx: cc * self.xx - 2.0 * cs * self.xy + ss * self.yy,
            yy: ss * self.xx + 2.0 * cs * self.xy + cc * self.yy,
            xy: cs * (self.xx - self.yy) + (cc - ss) * self.xy,
            xr: cos * self.xr - sin * self.yr,
            yr: sin * self.xr + cos * self.yr,
            rr: self.rr,
        }
    }

    /// Returns true if the mass of the body is equal in all directions. The test compares the bits that
    /// [`InverseMatrix::isotropic`] sets.
    #[inline]
    pub(crate) fn is_isotropic(&self) -> bool {
        let coupled = self.xy.to_bits() | self.xr.to_bits() | self.yr.to_bits();
        coupled == 0 && self.xx.to_bits() == self.yy.to_bits()
    }

    /// Returns true if the body floats: a fixed body has an infinite mass.
    #[inline]
    pub(crate) fn floats(&self) -> bool {
        self.rr.to_bits() != 0
    }

    /// Change of the body's velocity and yaw rate by an impulse and its moment.
    #[inline]
    pub(crate) fn response(&self, impulse: Vec2, moment: f64) -> (Vec2, f64) {
        (
            vec2(
                self.xx * impulse.x + self.xy * impulse.y + self.xr * moment,
                self.xy * impulse.x + self.yy * impulse.y + self.yr * moment,
            ),
            self.xr * impulse.x + self.yr * impulse.y + self.rr * moment,
        )
    }

    /// The matrix times `factor`.
    #[inline]
    pub(crate) fn times(&self, factor: f64) -> InverseMatrix {
        let InverseMatrix { xx, xy, yy, xr, yr, rr } = *self;
        InverseMatrix {
            xx: xx * factor,
            xy: xy * factor,
            yy: yy * factor,
            xr: xr * factor,
            yr: yr * factor,
            rr: rr * factor,
        }
    }

    /// Returns the mass matrix itself; `None` for a fixed body.
    pub(crate) fn matrix(&self) -> Option<[[f64; 3]; 3]> {
        let InverseMatrix { xx, xy, yy, xr, yr, rr } = *self;
        let inverse = InverseMatrix::of(&[[xx, xy, xr], [xy, yy, yr], [xr, yr, rr]])?;
        let InverseMatrix { xx, xy, yy, xr, yr, rr } = inverse;
        Some([[xx, xy, xr], [xy, yy, yr], [xr, yr, rr]])
    }

    /// Inverse of the body's inertia in yaw (1/(kg·m²)).
    pub(crate) fn inverse_inertia(&self) -> f64 {
        self.rr
    }

    /// The largest inverse mass of the body in any direction, without rotation (1/kg).
    pub(crate) fn largest_inverse_mass(&self) -> f64 {
        // The larger eigenvalue of the translational block.
        let (mean, half) = (0.5 * (self.xx + self.yy), 0.5 * (self.xx - self.yy));
        mean + libm::sqrt(half * half + self.xy * self.xy)
    }
}

/// Response (inverse effective mass) at a contact: the changes of velocity by impulses along the normal n and the
/// tangent t (1/kg). The tangent t is n turned by +90°.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Response {
    /// Inverse effective masses n·K n, t·K n and t·K t along the normal n and the tangent t.
    pub(crate) normal: f64,
    pub(crate) cross: f64,
    pub(crate) tangential: f64,
    /// n·K n without rotation.
    pub(crate) linear: f64,
    /// `is_isotropic` is true if only one body floats and its mass is equal in all directions. If `is_isotropic` is
    /// true, `linear` is the inverse mass of this body, and `inverse_inertia` the inverse of its inertia in yaw
    /// (1/(kg·m²)).
    pub(crate) is_isotropic: bool,
    pub(crate) inverse_inertia: f64,
}

impl Response {
    /// The response at a contact of one body with equal mass in all directions. The levers are those of the normal n
    /// and the tangent t about the body's centre of gravity.
    #[inline(always)]
    pub(crate) fn isotropic(inverse_mass: f64, inverse_inertia: f64, levers: Levers) -> Response {
        let (turn_n, turn_t) = (inverse_inertia * levers.n_m, inverse_inertia * levers.t_m);
        Response {
            normal: inverse_mass + turn_n * levers.n_m,
            cross: turn_n * levers.t_m,
            tangential: inverse_mass + turn_t * levers.t_m,
            linear: inverse_mass,
            is_isotropic: true,
            inverse_inertia,
        }
    }

    /// The response at a contact of one body with any mass matrix.
    #[inline(always)]
    pub(crate) fn of(of: &InverseMatrix, n: Vec2, levers: Levers) -> Response {
        let Levers { n_m: lever_n_m, t_m: lever_t_m } = levers;
        // The quadratic form of (n, lever of n) and (t, lever of t), with t = (−n_y, n_x).
        let (x_x, y_y, x_y) = (n.x * n.x, n.y * n.y, n.x * n.y);
        let mixed = 2.0 * of.xy * x_y;
        let linear = of.xx * x_x + of.yy * y_y + mixed;
        let linear_t = of.xx * y_y + of.yy * x_x - mixed;
        let linear_cross = (of.yy - of.xx) * x_y + of.xy * (x_x - y_y);
        let turn_n = of.xr * n.x + of.yr * n.y;
        let turn_t = of.yr * n.x - of.xr * n.y;
        Response {
            normal: linear + lever_n_m * (2.0 * turn_n + of.rr * lever_n_m),
            cross: linear_cross + turn_n * lever_t_m + lever_n_m * (turn_t + of.rr * lever_t_m),
            tangential: linear_t + lever_t_m * (2.0 * turn_t + of.rr * lever_t_m),
            linear,
            is_isotropic: false,
            inverse_inertia: of.rr,
        }
    }

    /// The response at a contact of the two bodies together.
    pub(crate) fn both(a: Response, b: Response) -> Response {
        Response {
            normal: a.normal + b.normal,
            cross: a.cross + b.cross,
            tangential: a.tangential + b.tangential,
            linear: a.linear + b.linear,
            is_isotropic: false,
            inverse_inertia: 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_undoes_the_matrix_in_any_attitude() {
        let m = [[3.0, 0.4, -0.2], [0.4, 5.0, 0.7], [-0.2, 0.7, 9.0]];
        let inverse = InverseMatrix::of(&m).expect("positive definite");
        let rotation = Rotation::from_angle(0.7);
        let turned = inverse.turned(rotation);
        let (force, moment) = (vec2(1.0, -2.0), 0.5);
        let (v, r) = turned.response(force, moment);
        let own = rotation.apply_inverse(v);
        let back = |row: [f64; 3]| row[0] * own.x + row[1] * own.y + row[2] * r;
        let felt = rotation.apply_inverse(force);
        for (ours, exact) in [(back(m[0]), felt.x), (back(m[1]), felt.y), (back(m[2]), moment)] {
            assert!((ours - exact).abs() < 1e-14);
        }
        assert!(inverse.largest_inverse_mass() >= 1.0 / 3.0 - 1e-3);
    }

    #[test]
    fn response_at_a_contact_matches_that_of_the_body() {
        let m = [[3.0, 0.4, -0.2], [0.4, 5.0, 0.7], [-0.2, 0.7, 9.0]];
        let inverse = InverseMatrix::of(&m).expect("positive definite");
        let (n, lever_n_m, lever_t_m) = (vec2(0.6, -0.8), 1.5, -0.7);
        let t = n.quarter_turn();
        let at_contact = Response::of(&inverse, n, Levers { n_m: lever_n_m, t_m: lever_t_m });
        let speed = |(v, r): (Vec2, f64), along: Vec2, lever_m: f64| v.dot(along) + r * lever_m;
        let (of_n, of_t) = (inverse.response(n, lever_n_m), inverse.response(t, lever_t_m));
        for (ours, exact) in [
            (at_contact.normal, speed(of_n, n, lever_n_m)),
            (at_contact.cross, speed(of_n, t, lever_t_m)),
            (at_contact.cross, speed(of_t, n, lever_n_m)),
            (at_contact.tangential, speed(of_t, t, lever_t_m)),
            (at_contact.linear, inverse.response(n, 0.0).0.dot(n)),
        ] {
            assert!((ours - exact).abs() < 1e-15, "{ours} {exact}");
        }
    }

    #[test]
    fn a_matrix_that_would_make_energy_is_refused() {
        assert_eq!(InverseMatrix::of(&[[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), None);
    }
}
