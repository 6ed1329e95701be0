//! Propellers in four quadrants, and thrusters.

use fenderline_sim::hydro::{Propeller, Series, Water, tunnel_effect};

use super::Values;
use super::ships::vessel;

/// Metres a second in a knot.
const KNOT_MPS: f64 = 1852.0 / 3600.0;

pub(super) fn compute(values: &mut Values) {
    own_polynomial(values);
    series_at_bollard(values);
    force_astern(values);
    for (knots, name) in [(0.0, "0"), (4.0, "4"), (15.0, "15")] {
        values.put(format!("bow_thruster/{name}"), tunnel_effect(knots * KNOT_MPS), "");
    }
}

/// K_T of KVLCC2's propeller ahead.
fn own_polynomial(values: &mut Values) {
    let propeller = vessel("kvlcc2").ship.propulsion.expect("she has a propeller").propeller;
    for (advance, name) in [(0.0, "0"), (0.4, "0.4"), (0.8, "0.8")] {
        let coefficient = thrust_coefficient(&propeller, advance, 1.0);
        values.put(format!("kvlcc2/kt/{name}"), coefficient, "");
    }
}

/// K_T and K_Q of the series at J = 0.
fn series_at_bollard(values: &mut Values) {
    for (name, series) in [("0.8", Series::B4Pitch08), ("1.0", Series::B4Pitch10)] {
        let propeller = Propeller { diameter_m: 1.0, thrust_polynomial: None, series };
        let torque_nm = propeller.torque_nm(0.0, 1.0, Water::SEA);
        let unit_nm = Water::SEA.density_kgpm3; // ρn²D⁵ at 1 m and 1 s⁻¹
        values.put(format!("series/{name}/kt"), thrust_coefficient(&propeller, 0.0, 1.0), "");
        values.put(format!("series/{name}/kq"), torque_nm / unit_nm, "");
    }
}

/// Force on KVLCC2 over ρn²D⁴ with the propeller astern while she goes ahead, with wake and thrust deduction as
/// her model has them, by Js = u/(nD).
fn force_astern(values: &mut Values) {
    let propulsion = vessel("kvlcc2").ship.propulsion.expect("she has a propeller");
    for (js, name) in [(0.0, "0"), (-0.1, "-0.1"), (-0.2, "-0.2"), (-0.4, "-0.4")] {
        let advance = (1.0 - propulsion.wake.straight) * js;
        let thrust = thrust_coefficient(&propulsion.propeller, advance, -1.0);
        let force = (1.0 - propulsion.thrust_deduction_astern) * thrust;
        values.put(format!("kvlcc2/astern/{name}"), force, "");
    }
}

/// Thrust over ρn²D⁴ at J = va/(nD) and n [1/s].
fn thrust_coefficient(propeller: &Propeller, advance: f64, shaft_rps: f64) -> f64 {
    let diameter_m = propeller.diameter_m;
    let square = diameter_m * diameter_m;
    let thrust_n = propeller.thrust_n(advance * shaft_rps * diameter_m, shaft_rps, Water::SEA);
    thrust_n / (Water::SEA.density_kgpm3 * shaft_rps * shaft_rps * square * square)
}
