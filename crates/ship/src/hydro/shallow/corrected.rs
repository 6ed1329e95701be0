//! Applies the corrections for shallow water to a ship's manoeuvring model.

use fenderline_contact::number::greater;

use super::CorrectionSet;
use super::berth::drag_to_the_bottom;
use super::factors::{Corrections, HullFactors, MassFactors, SternFactors};
use super::limits::SHALLOWEST_RATIO;
use crate::hydro::added_mass::AddedMass;
use crate::hydro::blend::Hull;
use crate::hydro::low_speed::{CrossFlow, LowSpeedHull};
use crate::hydro::mmg::{Mmg, Propulsion, Wake};
use crate::hydro::particulars::Particulars;
use crate::hydro::polynomial::Polynomial;
use crate::hydro::rudder::Rudder;
use crate::hydro::stall::Stall;

impl Mmg {
    /// Gives the ship's model in water of a given depth, by the corrections of [`CorrectionSet::default`] to added
    /// mass, hull, propeller and rudder. In water shallower than [`SHALLOWEST_RATIO`] draughts, also aground, the
    /// corrections are those at that ratio; the cross-flow drag alone goes on to increase until the ship touches the
    /// bottom. Every force on the ship is therefore a continuous function of depth.
    ///
    /// # Panics
    /// Panics if the depth is NaN.
    #[must_use]
    pub fn at_depth(&self, depth_m: f64) -> Mmg {
        self.at_depth_by(CorrectionSet::default(), depth_m)
    }

    /// Gives the ship's model in water of a given depth, by a given set of corrections.
    ///
    /// # Panics
    /// See [`Mmg::at_depth`].
    #[must_use]
    pub fn at_depth_by(&self, set: CorrectionSet, depth_m: f64) -> Mmg {
        Corrections::of(set, &self.particulars, depth_m).on(self, depth_m)
    }
}

impl Corrections {
    /// Gives the ship's manoeuvring model in water of a depth (m), from her model in deep water.
    ///
    /// If the ship crabs, drifts or lies at her berth, the cross-flow drag increases by
    /// [`super::shallow_cross_flow_drag`]; it goes on to increase until the ship touches the bottom. If the ship is
    /// under way, shallow water does not increase her cross-flow drag. All other corrections are held constant below
    /// [`SHALLOWEST_RATIO`] draughts of water. [`crate::hydro::polynomial_weight`] blends the forces of a ship under
    /// way with those of a ship that crabs or drifts. A ship without a polynomial uses her low-speed form both under
    /// way and at low speed.
    pub(crate) fn on(&self, deep: &Mmg, depth_m: f64) -> Mmg {
        let ship = &deep.particulars;
        let MassFactors { surge, sway, yaw } = self.mass;
        let added_mass = deep.added_mass.scaled(surge, sway, yaw);
        let masses = [&deep.added_mass, &added_mass];
        let deep_hull = &deep.hull;
        let slow = low_speed(&deep_hull.low_speed, &self.hull, ship, masses);
        let flow = deep_hull.low_speed.cross_flow;
        let drag_coefficient = drag_to_the_bottom(ship, flow.drag_coefficient, depth_m);
        let berthed = LowSpeedHull { cross_flow: CrossFlow { drag_coefficient, ..flow }, ..slow };
        let share = ship.draught_m / greater(depth_m, SHALLOWEST_RATIO * ship.draught_m);
        let stall = Stall::of(&deep_hull.low_speed, &berthed, share);
        let under_way = match &deep_hull.under_way {
            Some(polynomial) => polynomial_in(polynomial, &self.hull, ship, masses),
            None => Polynomial::CrossFlow(slow),
        };
        Mmg {
            particulars: *ship,
            added_mass,
            hull: Hull { under_way: Some(under_way), low_speed: berthed, stall },
            propulsion: deep.propulsion.as_ref().map(|propulsion| stern(propulsion, &self.stern)),
        }
    }
}

/// Derivatives X_vr and Y_r of the hull, without the Coriolis term of the added mass. The factor on X_vr applies to the
/// sum of X_vr and the Coriolis term; the Coriolis term in shallow water is then subtracted.
fn without_coriolis(
    surge_vr: f64,
    sway_r: f64,
    factors: &HullFactors,
    ship: &Particulars,
    [before, after]: [&AddedMass; 2],
) -> [f64; 2] {
    let unit = ship.mass_unit_m3();
    let surge = (surge_vr + before.sway_m3 / unit) * factors.x_vr - after.sway_m3 / unit;
    [surge, sway_r * factors.y_r]
}

fn low_speed(
    deep: &LowSpeedHull,
    factors: &HullFactors,
    ship: &Particulars,
    masses: [&AddedMass; 2],
) -> LowSpeedHull {
    let [surge_vr, sway_r] = without_coriolis(deep.surge_vr, deep.sway_r, factors, ship, masses);
    LowSpeedHull {
        ahead: deep.ahead * factors.resistance,
        astern: deep.astern * factors.resistance,
        surge_vr,
        sway_v: deep.sway_v * factors.y_v,
        sway_r,
        yaw_v: deep.yaw_v * factors.n_v,
        yaw_r: deep.yaw_r * factors.n_r,
        cross_flow: deep.cross_flow,
    }
}

fn polynomial_in(
    deep: &Polynomial,
    factors: &HullFactors,
    ship: &Particulars,
    masses: [&AddedMass; 2],
) -> Polynomial {
    match *deep {
        Polynomial::Sway(mut p) => {
            [p.x_vr, p.y_r] = without_coriolis(p.x_vr, p.y_r, factors, ship, masses);
            p.resistance *= factors.resistance;
            p.x_vv *= factors.x_vv;
            p.x_rr *= factors.x_rr;
            p.x_vvvv *= factors.x_vvvv;
            p.y_v *= factors.y_v;
            p.y_vvv *= factors.y_vvv;
            p.y_vvr *= factors.y_vvr;
            p.y_vrr *= factors.y_vrr;
            p.y_rrr *= factors.y_rrr;
            p.n_v *= factors.n_v;
            p.n_r *= factors.n_r;
            p.n_vvv *= factors.n_vvv;
            p.n_vvr *= factors.n_vvr;
            p.n_vrr *= factors.n_vrr;
            p.n_rrr *= factors.n_rrr;
            Polynomial::Sway(p)
        }
        Polynomial::Drift(mut p) => {
            let [before, after] = masses.map(|mass| mass.surge_m3 / ship.mass_unit_m3());
            p.x_0 *= factors.resistance;
            p.x_bb *= factors.x_vv;
            // Xβr includes −m'y, so the factor applies to all of it.
            p.x_br *= factors.x_vr;
            p.x_rr *= factors.x_rr;
            p.x_bbbb *= factors.x_vvvv;
            p.y_b *= factors.y_v;
            p.y_r = (p.y_r + before) * factors.y_r - after;
            p.y_bbb *= factors.y_vvv;
            p.y_bbr *= factors.y_vvr;
            p.y_brr *= factors.y_vrr;
            p.y_rrr *= factors.y_rrr;
            p.n_b *= factors.n_v;
            p.n_r *= factors.n_r;
            p.n_bbb *= factors.n_vvv;
            p.n_bbr *= factors.n_vvr;
            p.n_brr *= factors.n_vrr;
            p.n_rrr *= factors.n_rrr;
            Polynomial::Drift(p)
        }
        Polynomial::CrossFlow(hull) => {
            Polynomial::CrossFlow(low_speed(&hull, factors, ship, masses))
        }
    }
}

fn stern(deep: &Propulsion, factors: &SternFactors) -> Propulsion {
    let open = |fraction: f64, factor: f64| 1.0 - (1.0 - fraction) * factor;
    Propulsion {
        thrust_deduction: open(deep.thrust_deduction, factors.driving),
        wake: Wake {
            straight: open(deep.wake.straight * factors.wake, factors.inflow),
            ..deep.wake
        },
        rudder: Rudder {
            straightening: deep.rudder.straightening.map(|gain| gain * factors.straightening),
            ..deep.rudder
        },
        ..*deep
    }
}
