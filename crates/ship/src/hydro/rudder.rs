//! A rudder behind a propeller in all conditions: propeller ahead, stopped or astern.
//!
//! With the propeller ahead the rudder is that of the MMG standard method (Yasukawa & Yoshimura 2015), in the form of
//! the inflow speed u_R that is finite at bollard pull. The rudder behind a propeller that is stopped or goes astern is
//! our addition. Our addition for a propeller stopped or astern is chosen for continuous forces, and is not validated:
//!
//! - The speed of the propeller race relative to the surrounding water is ±(√(u_P² + 8|T|/(πρD²)) − |u_P|). The speed
//!   of the propeller race has the sign of the thrust T.
//! - If the propeller race passes over the rudder, its speed is multiplied by κ, as in the MMG method. If the rudder is
//!   on the propeller's intake side, the race's speed is multiplied by ½(1 − 1/√2) = 0.146, by actuator-disc theory
//!   half a diameter upstream.
//! - The ship's drift enters the rudder's inflow as Uβ up to about 40° and as −v beyond, because β is discontinuous for
//!   motion straight astern.
//! - In reversed flow the rudder has the same lift as in flow from ahead, which is optimistic.

use std::f64::consts::PI;

use super::quantities::{Force, Velocity, Water, smooth_step};

/// Speed that the propeller induces half a diameter upstream of its disc, divided by the speed that it induces far
/// downstream.
const INTAKE: f64 = 0.5 * (1.0 - std::f64::consts::FRAC_1_SQRT_2);
/// Value of cos β up to which drift enters the rudder's inflow as −v, and value from which on it enters as Uβ.
const DRIFT_COSINES: [f64; 2] = [0.26, 0.77];

/// A rudder, with coefficients of its interaction with hull and propeller, by the MMG method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rudder {
    /// Movable area A_R (m²).
    pub area_m2: f64,
    /// Lift gradient f_α.
    pub lift_gradient: f64,
    /// Ratio η of the propeller's diameter to the rudder's span.
    pub propeller_to_span: f64,
    /// Wake ratio ε: 1 − w at the rudder divided by 1 − w at the propeller.
    pub wake_ratio: f64,
    /// Share κ of the propeller race's speed that reaches the rudder.
    pub race_gain: f64,
    /// Flow straightening coefficient γ_R for a rudder inflow angle β_R below and above 0.
    pub straightening: [f64; 2],
    /// Effective position l'_R of the rudder, divided by L, used in the inflow angle β_R = β − l'_R r'.
    pub straightening_place: f64,
    /// Steering resistance deduction t_R.
    pub resistance_deduction: f64,
    /// Ratio a_H of the lateral force on the hull due to steering to the lateral force on the rudder.
    pub hull_gain: f64,
    /// Position x'_H of the lateral force on the hull due to steering, divided by L.
    pub hull_place: f64,
    /// Position x'_R of the rudder, divided by L (−0.5 at the after perpendicular).
    pub place: f64,
}

/// The propeller race that meets the rudder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Race {
    /// Speed of advance of the propeller, u_P = u(1 − w) (m/s).
    pub advance_mps: f64,
    /// Thrust of the propeller (N).
    pub thrust_n: f64,
    /// Diameter of the propeller (m).
    pub diameter_m: f64,
}

impl Rudder {
    /// Forces and moment of the rudder: X_R = −(1−t_R) F_N sin δ, Y_R = −(1+a_H) F_N cos δ, N_R = −(x_R + a_H x_H) F_N
    /// cos δ.
    pub fn force(
        &self,
        velocity: &Velocity,
        race: &Race,
        rudder_rad: f64,
        length_m: f64,
        water: Water,
    ) -> Force {
        let (sin, cos) = libm::sincos(rudder_rad);
        let normal_n = self.normal_force_n(velocity, race, sin, cos, length_m, water);
        let place_m = (self.place + self.hull_gain * self.hull_place) * length_m;
        Force {
            surge_n: -(1.0 - self.resistance_deduction) * normal_n * sin,
            sway_n: -(1.0 + self.hull_gain) * normal_n * cos,
            yaw_nm: -place_m * normal_n * cos,
        }
    }

    /// Normal force of the rudder, F_N = ½ρ A_R f_α U_R² sin(δ − atan2(v_R, u_R)), which we compute without the angle.
    fn normal_force_n(
        &self,
        velocity: &Velocity,
        race: &Race,
        sin: f64,
        cos: f64,
        length_m: f64,
        water: Water,
    ) -> f64 {
        let along_mps = self.inflow_along_mps(race, water);
        let across_mps = self.inflow_across_mps(velocity, length_m);
        let speed_mps = (along_mps * along_mps + across_mps * across_mps).sqrt();
        0.5 * water.density_kgpm3
            * self.area_m2
            * self.lift_gradient
            * speed_mps
            * (along_mps * sin - across_mps * cos)
    }

    /// Inflow speed u_R along the ship (m/s): the MMG method's ε√(η(u_P + κΔ)² + (1−η)u_P²), where Δ is the race's gain
    /// of speed. If the two parts p and q under the root, in the race and outside, have different signs, (p|p| +
    /// q|q|)/√(p² + q²) extends the formula for u_R; for equal signs both formulas agree.
    fn inflow_along_mps(&self, race: &Race, water: Water) -> f64 {
        let advance_mps = race.advance_mps;
        let loading =
            8.0 * race.thrust_n / (PI * water.density_kgpm3 * race.diameter_m * race.diameter_m);
        let gained_mps = (advance_mps * advance_mps + loading.abs()).sqrt() - advance_mps.abs();
        let gain = INTAKE + (self.race_gain - INTAKE) * share_over_rudder(advance_mps, loading);
        let in_race_mps = advance_mps + gain * gained_mps.copysign(loading);
        let race_part = self.propeller_to_span.sqrt() * in_race_mps;
        let free_part = (1.0 - self.propeller_to_span).sqrt() * advance_mps;
        let squared = race_part * race_part + free_part * free_part;
        if squared == 0.0 {
            return 0.0;
        }
        let signed = race_part * race_part.abs() + free_part * free_part.abs();
        self.wake_ratio * signed / squared.sqrt()
    }

    /// Inflow speed v_R = γ_R(Uβ − l_R r) across the ship (m/s), with γ_R for the side from which the water comes.
    ///
    /// The coefficient γ_R is selected by the sign of β_R, which makes v_R continuous; some sources select it by the
    /// sign of β_P.
    fn inflow_across_mps(&self, velocity: &Velocity, length_m: f64) -> f64 {
        let speed_mps = velocity.speed_mps();
        if speed_mps == 0.0 {
            return self.straightened(-self.straightening_place * length_m * velocity.yaw_radps);
        }
        let cosine = velocity.surge_mps / speed_mps;
        let [none, all] = DRIFT_COSINES;
        let as_angle = smooth_step((cosine - none) / (all - none));
        let mut drift_mps = -velocity.sway_mps * (1.0 - as_angle);
        if as_angle > 0.0 {
            drift_mps += as_angle * speed_mps * velocity.drift_rad();
        }
        self.straightened(drift_mps - self.straightening_place * length_m * velocity.yaw_radps)
    }

    fn straightened(&self, across_mps: f64) -> f64 {
        let [negative, positive] = self.straightening;
        across_mps * if across_mps < 0.0 { negative } else { positive }
    }
}

/// Share of the water through the propeller disc that passes over the rudder: 1 if all of it does, 0 if the rudder is
/// on the intake side. The share is between 0 and 1 if thrust and speed of advance have different signs.
fn share_over_rudder(advance_mps: f64, loading: f64) -> f64 {
    let advance_squared = advance_mps * advance_mps;
    let sum = advance_squared + loading.abs();
    if sum == 0.0 {
        // There is no race, and no speed of advance or one whose computed square is 0: any share gives no flow.
        return 1.0;
    }
    match (advance_mps >= 0.0, loading >= 0.0) {
        (true, true) => 1.0,
        (false, true) => loading / sum,
        (true, false) => advance_squared / sum,
        (false, false) => 0.0,
    }
}
