//! Vessel files and the numbers of vessels, in the form of a vessel file. `fenderline.identify` writes vessel files of
//! them.

use fenderline_scenario::VesselLibrary;
use fenderline_sim::VesselSetup;
use fenderline_sim::hydro::{Mmg, Polynomial, Propulsion};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::errors;
use crate::scenario::Scenario;

/// Names and texts of the built-in vessel files.
#[pyfunction]
pub(crate) fn vessel_files() -> Vec<(&'static str, &'static str)> {
    VesselLibrary::built_in_files().to_vec()
}

/// The coefficients of a body's vessel in deep water, estimated ones too, by their paths in a vessel file, and what the
/// file's other forms need: `particulars.length_bp` and `particulars.centre_of_gravity` (m).
#[pyfunction]
pub(crate) fn vessel_numbers<'py>(
    py: Python<'py>,
    scenario: &Scenario,
    body: &str,
) -> PyResult<Bound<'py, PyDict>> {
    let setup = &scenario.checked.setup;
    let is_hers = |vessel: &&VesselSetup| setup.bodies[vessel.body].name == body;
    let Some(vessel) = setup.world.vessels.iter().find(is_hers) else {
        return Err(errors::bad_argument(format!("the body `{body}` is no vessel")));
    };
    let all = PyDict::new(py);
    for (path, value) in numbers(&vessel.deep) {
        all.set_item(path, value)?;
    }
    Ok(all)
}

type Numbers = Vec<(&'static str, f64)>;

fn numbers(ship: &Mmg) -> Numbers {
    let of = &ship.particulars;
    let mut all = vec![
        ("particulars.length_bp", of.length_m),
        ("particulars.centre_of_gravity", of.centre_of_gravity_m),
        ("added_mass.surge", ship.added_mass.surge_m3 / of.mass_unit_m3()),
        ("added_mass.sway", ship.added_mass.sway_m3 / of.mass_unit_m3()),
        ("added_mass.yaw", ship.added_mass.yaw_m5 / of.inertia_unit_m5()),
    ];
    let slow = &ship.hull.low_speed;
    all.extend([
        ("low_speed.ahead", slow.ahead),
        ("low_speed.astern", slow.astern),
        ("low_speed.x_vr", slow.surge_vr),
        ("low_speed.y_v", slow.sway_v),
        ("low_speed.y_r", slow.sway_r),
        ("low_speed.n_v", slow.yaw_v),
        ("low_speed.n_r", slow.yaw_r),
        ("low_speed.drag", slow.cross_flow.drag_coefficient),
        ("low_speed.yaw_gain_force", slow.cross_flow.yaw_gain_force),
        ("low_speed.yaw_gain_moment", slow.cross_flow.yaw_gain_moment),
    ]);
    all.extend(ship.hull.under_way.as_ref().map(polynomial).unwrap_or_default());
    all.extend(ship.propulsion.as_ref().map(stern).unwrap_or_default());
    all
}

fn polynomial(of: &Polynomial) -> Numbers {
    match of {
        Polynomial::Sway(of) => vec![
            ("sway_polynomial.resistance", of.resistance),
            ("sway_polynomial.x_vv", of.x_vv),
            ("sway_polynomial.x_vr", of.x_vr),
            ("sway_polynomial.x_rr", of.x_rr),
            ("sway_polynomial.x_vvvv", of.x_vvvv),
            ("sway_polynomial.y_v", of.y_v),
            ("sway_polynomial.y_r", of.y_r),
            ("sway_polynomial.y_vvv", of.y_vvv),
            ("sway_polynomial.y_vvr", of.y_vvr),
            ("sway_polynomial.y_vrr", of.y_vrr),
            ("sway_polynomial.y_rrr", of.y_rrr),
            ("sway_polynomial.n_v", of.n_v),
            ("sway_polynomial.n_r", of.n_r),
            ("sway_polynomial.n_vvv", of.n_vvv),
            ("sway_polynomial.n_vvr", of.n_vvr),
            ("sway_polynomial.n_vrr", of.n_vrr),
            ("sway_polynomial.n_rrr", of.n_rrr),
        ],
        Polynomial::Drift(of) => vec![
            ("drift_polynomial.x_0", of.x_0),
            ("drift_polynomial.x_bb", of.x_bb),
            ("drift_polynomial.x_br", of.x_br),
            ("drift_polynomial.x_rr", of.x_rr),
            ("drift_polynomial.x_bbbb", of.x_bbbb),
            ("drift_polynomial.y_b", of.y_b),
            ("drift_polynomial.y_r", of.y_r),
            ("drift_polynomial.y_bbb", of.y_bbb),
            ("drift_polynomial.y_bbr", of.y_bbr),
            ("drift_polynomial.y_brr", of.y_brr),
            ("drift_polynomial.y_rrr", of.y_rrr),
            ("drift_polynomial.n_b", of.n_b),
            ("drift_polynomial.n_r", of.n_r),
            ("drift_polynomial.n_bbb", of.n_bbb),
            ("drift_polynomial.n_bbr", of.n_bbr),
            ("drift_polynomial.n_brr", of.n_brr),
            ("drift_polynomial.n_rrr", of.n_rrr),
        ],
        // A vessel file has no form for this hull: she has no polynomial to choose from.
        Polynomial::CrossFlow(_) => Vec::new(),
    }
}

fn stern(of: &Propulsion) -> Numbers {
    let (wake, rudder) = (&of.wake, &of.rudder);
    let mut all = vec![
        ("propeller.thrust_deduction", of.thrust_deduction),
        ("propeller.thrust_deduction_astern", of.thrust_deduction_astern),
        ("propeller.wake", wake.straight),
        ("propeller.place", wake.place),
    ];
    if let Some([k0, k1, k2]) = of.propeller.thrust_polynomial {
        all.extend([
            ("propeller.thrust.k0", k0),
            ("propeller.thrust.k1", k1),
            ("propeller.thrust.k2", k2),
        ]);
    }
    // A wake that does not change has no key.
    if wake.rate > 0.0 {
        all.extend([
            ("propeller.wake_change.c1", wake.rate),
            ("propeller.wake_change.c2_below", wake.limits[0]),
            ("propeller.wake_change.c2_above", wake.limits[1]),
        ]);
    }
    all.extend([
        ("rudder.lift_gradient", rudder.lift_gradient),
        ("rudder.wake_ratio", rudder.wake_ratio),
        ("rudder.race_gain", rudder.race_gain),
        ("rudder.straightening.below", rudder.straightening[0]),
        ("rudder.straightening.above", rudder.straightening[1]),
        ("rudder.straightening_place", rudder.straightening_place),
        ("rudder.resistance_deduction", rudder.resistance_deduction),
        ("rudder.hull_gain", rudder.hull_gain),
        ("rudder.hull_place", rudder.hull_place),
        ("rudder.place", rudder.place),
    ]);
    all
}
