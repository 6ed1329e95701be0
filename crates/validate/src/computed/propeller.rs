//! Computes forces of propellers in four quadrants, and of thrusters.

use std::f64::consts::PI;

use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::hydro::{Propeller, Series, Water, tunnel_effect};

use super::Values;
use super::ships::vessel;

pub(super) fn compute(values: &mut Values) {
    own_polynomial(values);
    series(values);
    force_astern(values);
    for (knots, name) in [(0.0, "0"), (4.0, "4"), (15.0, "15")] {
        values.put(format!("bow_thruster/{name}"), tunnel_effect(knots * KNOT_MPS), "");
    }
}

/// Thrust coefficient K_T of KVLCC2's propeller going ahead.
fn own_polynomial(values: &mut Values) {
    let propeller = vessel("kvlcc2").ship.propulsion.expect("she has a propeller").propeller;
    for (advance, name) in [(0.0, "0"), (0.4, "0.4"), (0.8, "0.8")] {
        let coefficient = thrust_coefficient(&propeller, advance, 1.0);
        values.put(format!("kvlcc2/kt/{name}"), coefficient, "");
    }
}

/// Coefficients K_T and K_Q of the propeller series ahead by advance ratio J, and C_T* and C_Q* in the other quadrants
/// by angle β.
fn series(values: &mut Values) {
    let density_kgpm3 = Water::SEA.density_kgpm3;
    for (name, series) in [("0.8", Series::B4Pitch08), ("1.0", Series::B4Pitch10)] {
        let propeller = Propeller { diameter_m: 1.0, thrust_polynomial: None, series };
        for (advance, at) in [(0.0, "0"), (0.4, "0.4"), (0.8, "0.8")] {
            // ρn²D⁴ and ρn²D⁵ at 1 m and 1 s⁻¹.
            let thrust = propeller.thrust_n(advance, 1.0, Water::SEA) / density_kgpm3;
            let torque = propeller.torque_nm(advance, 1.0, Water::SEA) / density_kgpm3;
            values.put(format!("series/{name}/kt/{at}"), thrust, "");
            values.put(format!("series/{name}/kq/{at}"), torque, "");
        }
        for degrees in [90, 150, 210, 330] {
            // At 1 m/s over the blades' 0.7 radius and the water together.
            let (sin, cos) = libm::sincos(f64::from(degrees).to_radians());
            let shaft_rps = cos / (0.7 * PI);
            let unit = 0.5 * density_kgpm3 * 0.25 * PI;
            let thrust = propeller.thrust_n(sin, shaft_rps, Water::SEA) / unit;
            let torque = propeller.torque_nm(sin, shaft_rps, Water::SEA) / unit;
            values.put(format!("series/{name}/ct/{degrees}"), thrust, "");
            values.put(format!("series/{name}/cq/{degrees}"), torque, "");
        }
    }
}

/// Force on KVLCC2, divided by ρn²D⁴, by Js = u/(nD): the propeller turns astern while she goes ahead. Wake and thrust
/// deduction are those of her manoeuvring model.
fn force_astern(values: &mut Values) {
    let propulsion = vessel("kvlcc2").ship.propulsion.expect("she has a propeller");
    for (js, name) in [(0.0, "0"), (-0.1, "-0.1"), (-0.2, "-0.2"), (-0.4, "-0.4")] {
        let advance = (1.0 - propulsion.wake.straight) * js;
        let thrust = thrust_coefficient(&propulsion.propeller, advance, -1.0);
        let force = (1.0 - propulsion.thrust_deduction_astern) * thrust;
        values.put(format!("kvlcc2/astern/{name}"), force, "");
    }
}

/// Thrust of a propeller divided by ρn²D⁴, at an advance ratio J = va/(nD) and revolutions n (1/s).
fn thrust_coefficient(propeller: &Propeller, advance: f64, shaft_rps: f64) -> f64 {
    let diameter_m = propeller.diameter_m;
    let square = diameter_m * diameter_m;
    let thrust_n = propeller.thrust_n(advance * shaft_rps * diameter_m, shaft_rps, Water::SEA);
    thrust_n / (Water::SEA.density_kgpm3 * shaft_rps * shaft_rps * square * square)
}
