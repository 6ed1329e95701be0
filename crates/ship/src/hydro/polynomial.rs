//! Polynomials for the force on a hull: the two forms in which they are published, and a form for ships without a
//! polynomial.

use super::added_mass::AddedMass;
use super::linear_terms::LinearTerms;
use super::low_speed::LowSpeedHull;
use super::particulars::Particulars;
use super::quantities::{Force, Velocity, Water};

/// Polynomial for the force on the hull of a ship under way. In the polynomial, forces are divided by ½ρLdU² and
/// moments by ½ρL²dU².
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Polynomial {
    /// The polynomial is in v' = v/U and r' = rL/U (Yasukawa & Yoshimura 2015), without added-mass terms.
    Sway(SwayPolynomial),
    /// The polynomial is in the drift angle β (rad) and r' (the form of Yoshimura & Masumoto). In the form over β, the
    /// coefficient Xβr includes −m'y and Yr includes −m'x, which are the Coriolis terms of the added mass.
    Drift(DriftPolynomial),
    /// The ship has no polynomial: the low-speed form is used, with the cross-flow drag of a ship under way, without
    /// added-mass terms. In shallow water the cross-flow drag of a ship under way differs from that of a ship at her
    /// berth.
    CrossFlow(LowSpeedHull),
}

/// Coefficients of the hull polynomial over v' and r'.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(
    missing_docs,
    reason = "the index of each coefficient in the method's notation is its powers of v' and r'"
)]
pub struct SwayPolynomial {
    /// Resistance R'₀, positive.
    pub resistance: f64,
    pub x_vv: f64,
    pub x_vr: f64,
    pub x_rr: f64,
    pub x_vvvv: f64,
    pub y_v: f64,
    pub y_r: f64,
    pub y_vvv: f64,
    pub y_vvr: f64,
    pub y_vrr: f64,
    pub y_rrr: f64,
    pub n_v: f64,
    pub n_r: f64,
    pub n_vvv: f64,
    pub n_vvr: f64,
    pub n_vrr: f64,
    pub n_rrr: f64,
}

/// Coefficients of the hull polynomial over β and r'.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(
    missing_docs,
    reason = "the index of each coefficient in the method's notation is its powers of β and r'"
)]
pub struct DriftPolynomial {
    /// Resistance X'₀, negative.
    pub x_0: f64,
    pub x_bb: f64,
    pub x_br: f64,
    pub x_rr: f64,
    pub x_bbbb: f64,
    pub y_b: f64,
    pub y_r: f64,
    pub y_bbb: f64,
    pub y_bbr: f64,
    pub y_brr: f64,
    pub y_rrr: f64,
    pub n_b: f64,
    pub n_r: f64,
    pub n_bbb: f64,
    pub n_bbr: f64,
    pub n_brr: f64,
    pub n_rrr: f64,
}

impl Polynomial {
    /// Force of the hull at midship *with* the Coriolis terms of the added mass, X + m_y v r and Y − m_x u r. With the
    /// Coriolis terms of the added mass, both forms of the polynomial are equivalent. The ship must be
    /// moving (speed U > 0).
    pub(crate) fn force(
        &self,
        velocity: &Velocity,
        ship: &Particulars,
        added: &AddedMass,
        water: Water,
    ) -> Force {
        if let Polynomial::CrossFlow(hull) = self {
            return hull.force(velocity, ship.length_m, ship.draught_m, water)
                + coriolis(velocity, added, water);
        }
        let speed_mps = velocity.speed_mps();
        let yaw = velocity.yaw_radps * ship.length_m / speed_mps;
        let area = 0.5 * water.density_kgpm3 * ship.length_m * ship.draught_m;
        let (shape, coriolis) = match self {
            Polynomial::Sway(p) => {
                (p.shape(velocity.sway_mps / speed_mps, yaw), coriolis(velocity, added, water))
            }
            Polynomial::Drift(p) => (p.shape(velocity.drift_rad(), yaw), Force::default()),
            Polynomial::CrossFlow(_) => unreachable!("handled above"),
        };
        let force = Force { surge_n: shape[0], sway_n: shape[1], yaw_nm: shape[2] * ship.length_m };
        force * (area * speed_mps * speed_mps) + coriolis
    }

    /// Every coefficient of the polynomial, in the order of its fields.
    pub(crate) fn coefficients(&self) -> [f64; 17] {
        match *self {
            Polynomial::Sway(p) => [
                p.resistance,
                p.x_vv,
                p.x_vr,
                p.x_rr,
                p.x_vvvv,
                p.y_v,
                p.y_r,
                p.y_vvv,
                p.y_vvr,
                p.y_vrr,
                p.y_rrr,
                p.n_v,
                p.n_r,
                p.n_vvv,
                p.n_vvr,
                p.n_vrr,
                p.n_rrr,
            ],
            Polynomial::Drift(p) => [
                p.x_0, p.x_bb, p.x_br, p.x_rr, p.x_bbbb, p.y_b, p.y_r, p.y_bbb, p.y_bbr, p.y_brr,
                p.y_rrr, p.n_b, p.n_r, p.n_bbb, p.n_bbr, p.n_brr, p.n_rrr,
            ],
            Polynomial::CrossFlow(p) => {
                let flow = p.cross_flow;
                let own = [
                    p.ahead,
                    p.astern,
                    p.surge_vr,
                    p.sway_v,
                    p.sway_r,
                    p.yaw_v,
                    p.yaw_r,
                    flow.drag_coefficient,
                    flow.yaw_gain_force,
                    flow.yaw_gain_moment,
                ];
                let mut all = [0.0; 17];
                all[..own.len()].copy_from_slice(&own);
                all
            }
        }
    }

    /// The linear terms of the polynomial, without added mass.
    pub fn linear(&self, ship: &Particulars, added: &AddedMass) -> LinearTerms {
        match self {
            Polynomial::Sway(p) => LinearTerms {
                ahead: -p.resistance,
                surge_vr: p.x_vr,
                sway_v: p.y_v,
                sway_r: p.y_r,
                yaw_v: p.n_v,
                yaw_r: p.n_r,
            },
            // For small angles β = −v'.
            Polynomial::Drift(p) => LinearTerms {
                ahead: p.x_0,
                surge_vr: -(p.x_br + added.sway_m3 / ship.mass_unit_m3()),
                sway_v: -p.y_b,
                sway_r: p.y_r + added.surge_m3 / ship.mass_unit_m3(),
                yaw_v: -p.n_b,
                yaw_r: p.n_r,
            },
            Polynomial::CrossFlow(p) => LinearTerms {
                ahead: p.ahead,
                surge_vr: p.surge_vr,
                sway_v: p.sway_v,
                sway_r: p.sway_r,
                yaw_v: p.yaw_v,
                yaw_r: p.yaw_r,
            },
        }
    }
}

/// The Coriolis terms of the added mass in the MMG method, (m_y v r, −m_x u r, 0): the Munk moment (m_x − m_y)uv is
/// part of N_v, and is not added again.
pub(crate) fn coriolis(velocity: &Velocity, added: &AddedMass, water: Water) -> Force {
    let turn = water.density_kgpm3 * velocity.yaw_radps;
    Force {
        surge_n: added.sway_m3 * velocity.sway_mps * turn,
        sway_n: -added.surge_m3 * velocity.surge_mps * turn,
        yaw_nm: 0.0,
    }
}

impl SwayPolynomial {
    /// The dimensionless forces and moment X', Y', N' of the polynomial over v' and r'.
    fn shape(&self, v: f64, r: f64) -> [f64; 3] {
        let (vv, vr, rr) = (v * v, v * r, r * r);
        [
            -self.resistance
                + self.x_vv * vv
                + self.x_vr * vr
                + self.x_rr * rr
                + self.x_vvvv * vv * vv,
            self.y_v * v
                + self.y_r * r
                + self.y_vvv * vv * v
                + self.y_vvr * vv * r
                + self.y_vrr * v * rr
                + self.y_rrr * rr * r,
            self.n_v * v
                + self.n_r * r
                + self.n_vvv * vv * v
                + self.n_vvr * vv * r
                + self.n_vrr * v * rr
                + self.n_rrr * rr * r,
        ]
    }
}

impl DriftPolynomial {
    /// The dimensionless forces and moment X', Y', N' of the polynomial over β and r'.
    fn shape(&self, b: f64, r: f64) -> [f64; 3] {
        let (bb, br, rr) = (b * b, b * r, r * r);
        [
            self.x_0 + self.x_bb * bb + self.x_br * br + self.x_rr * rr + self.x_bbbb * bb * bb,
            self.y_b * b
                + self.y_r * r
                + self.y_bbb * bb * b
                + self.y_bbr * bb * r
                + self.y_brr * b * rr
                + self.y_rrr * rr * r,
            self.n_b * b
                + self.n_r * r
                + self.n_bbb * bb * b
                + self.n_bbr * bb * r
                + self.n_brr * b * rr
                + self.n_rrr * rr * r,
        ]
    }
}
