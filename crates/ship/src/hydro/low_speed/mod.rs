//! Hull forces at low speed, at any drift angle, ahead and astern: a linear part that depends on the direction of
//! motion, and cross-flow drag.

mod cross_flow;

pub use cross_flow::{CrossFlow, hoerner_drag_coefficient};

use std::f64::consts::PI;

use super::linear_terms::LinearTerms;
use super::particulars::Particulars;
use super::quantities::{Force, Velocity, Water};

/// Low-speed hull coefficients in the form of Yoshimura, Nakao & Ishibashi (2009), as used by Miyauchi et al. (2022),
/// divided by ½ρLdU². The low-speed form was checked against a public implementation of Miyauchi's model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LowSpeedHull {
    /// X'₀F: resistance ahead (negative).
    pub ahead: f64,
    /// X'₀A: resistance astern (negative).
    pub astern: f64,
    /// Coefficient X'vr.
    pub surge_vr: f64,
    /// Coefficient Y'v.
    pub sway_v: f64,
    /// Coefficient Y'r.
    pub sway_r: f64,
    /// Coefficient N'v.
    pub yaw_v: f64,
    /// Coefficient N'r.
    pub yaw_r: f64,
    /// The cross-flow part.
    pub cross_flow: CrossFlow,
}

/// Default ratio of the resistance astern to the resistance ahead, taken from Esso Osaka: 0.0319/0.0214.
const ASTERN_OVER_AHEAD: f64 = 0.0319 / 0.0214;

impl LowSpeedHull {
    /// Estimates the low-speed form from known linear terms: Hoerner's drag of the midship section, yaw gains of 1, and
    /// Esso Osaka's ratio of resistance astern to ahead.
    #[must_use]
    pub fn from_linear(linear: &LinearTerms, ship: &Particulars) -> LowSpeedHull {
        LowSpeedHull {
            ahead: linear.ahead,
            astern: linear.ahead * ASTERN_OVER_AHEAD,
            surge_vr: linear.surge_vr,
            sway_v: linear.sway_v,
            sway_r: linear.sway_r,
            yaw_v: linear.yaw_v,
            yaw_r: linear.yaw_r,
            cross_flow: CrossFlow {
                drag_coefficient: hoerner_drag_coefficient(ship.beam_m, ship.draught_m),
                yaw_gain_force: 1.0,
                yaw_gain_moment: 1.0,
            },
        }
    }

    /// Force of the hull at midship, without the Coriolis terms of the added mass:
    /// X = ½ρLd{[X₀F + (X₀A − X₀F)|β|/π]uU + Xvr v r L}, Y = ½ρLd{Yv v|u| + Yr r L u} and
    /// N = ½ρL²d{Nv v u + Nr r L|u|}, where the cross-flow drag is added to Y and N.
    pub fn force(&self, velocity: &Velocity, length_m: f64, draught_m: f64, water: Water) -> Force {
        let (u, v) = (velocity.surge_mps, velocity.sway_mps);
        let tip_mps = velocity.yaw_radps * length_m;
        let area = 0.5 * water.density_kgpm3 * length_m * draught_m;
        let resistance = self.ahead + (self.astern - self.ahead) * velocity.drift_rad().abs() / PI;
        let linear = Force {
            surge_n: resistance * u * velocity.speed_mps() + self.surge_vr * v * tip_mps,
            sway_n: self.sway_v * v * u.abs() + self.sway_r * tip_mps * u,
            yaw_nm: length_m * (self.yaw_v * v * u + self.yaw_r * tip_mps * u.abs()),
        };
        linear * area + self.cross_flow.force(velocity, length_m, draught_m, water)
    }
}
