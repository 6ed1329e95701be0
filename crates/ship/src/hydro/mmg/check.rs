//! Limits on the coefficients of a manoeuvring model, so that every force is finite.

use super::{Mmg, Propulsion};
use crate::hydro::error::{HydroError, within};
use crate::hydro::low_speed::LowSpeedHull;

/// Largest size of a coefficient that is accepted, far above any published value.
const LARGEST: f64 = 1e3;

impl Mmg {
    /// Checks a manoeuvring model and returns it.
    ///
    /// # Errors
    /// Fails with [`HydroError::OutOfRange`], which names the first value out of range: particulars, negative added
    /// mass, a negative drag, a propeller without diameter, fractions outside 0 to 1, a propeller wider than the
    /// rudder's span.
    pub fn check(self) -> Result<Mmg, HydroError> {
        self.particulars.check()?;
        let added = &self.added_mass;
        within("added mass in surge over density [m³]", added.surge_m3, 0.0, f64::MAX)?;
        within("added mass in sway over density [m³]", added.sway_m3, 0.0, f64::MAX)?;
        within("added inertia in yaw over density [m⁵]", added.yaw_m5, 0.0, f64::MAX)?;
        check_low_speed(&self.hull.low_speed)?;
        if let Some(polynomial) = &self.hull.under_way {
            let linear = polynomial.linear(&self.particulars, added);
            within("resistance ahead X'₀", linear.ahead, -LARGEST, 0.0)?;
            for coefficient in polynomial.coefficients() {
                within("hull polynomial coefficient", coefficient, -LARGEST, LARGEST)?;
            }
        }
        if let Some(propulsion) = &self.propulsion {
            check_propulsion(propulsion)?;
        }
        Ok(self)
    }
}

fn check_low_speed(hull: &LowSpeedHull) -> Result<(), HydroError> {
    within("resistance ahead X'₀F", hull.ahead, -LARGEST, 0.0)?;
    within("resistance astern X'₀A", hull.astern, -LARGEST, 0.0)?;
    for coefficient in [hull.surge_vr, hull.sway_v, hull.sway_r, hull.yaw_v, hull.yaw_r] {
        within("low-speed hull coefficient", coefficient, -LARGEST, LARGEST)?;
    }
    let flow = &hull.cross_flow;
    within("cross-flow drag coefficient", flow.drag_coefficient, 0.0, LARGEST)?;
    within("yaw gain of the cross-flow force", flow.yaw_gain_force, -LARGEST, LARGEST)?;
    within("yaw gain of the cross-flow moment", flow.yaw_gain_moment, -LARGEST, LARGEST)?;
    Ok(())
}

fn check_propulsion(propulsion: &Propulsion) -> Result<(), HydroError> {
    let (wake, rudder) = (&propulsion.wake, &propulsion.rudder);
    within("propeller diameter [m]", propulsion.propeller.diameter_m, 0.001, 100.0)?;
    for coefficient in propulsion.propeller.thrust_polynomial.unwrap_or_default() {
        within("thrust coefficient K_T", coefficient, -LARGEST, LARGEST)?;
    }
    within("thrust deduction", propulsion.thrust_deduction, -0.5, 1.0)?;
    within("thrust deduction astern", propulsion.thrust_deduction_astern, -0.5, 1.0)?;
    within("wake fraction", wake.straight, -0.5, 1.0)?;
    within("wake change C1", wake.rate, 0.0, LARGEST)?;
    for limit in wake.limits {
        within("wake change C2", limit, 0.0, 10.0)?;
    }
    within("place of the propeller x'P", wake.place, -2.0, 2.0)?;
    within("rudder area [m²]", rudder.area_m2, 0.0, 10_000.0)?;
    within("rudder lift gradient", rudder.lift_gradient, 0.0, 10.0)?;
    within("propeller diameter over rudder span", rudder.propeller_to_span, 0.0, 1.0)?;
    within("wake ratio ε", rudder.wake_ratio, 0.0, 10.0)?;
    within("race gain κ", rudder.race_gain, 0.0, 10.0)?;
    for straightening in rudder.straightening {
        within("flow straightening γR", straightening, 0.0, 10.0)?;
    }
    within("place l'R", rudder.straightening_place, -2.0, 2.0)?;
    within("steering resistance deduction tR", rudder.resistance_deduction, -1.0, 1.0)?;
    within("hull gain aH", rudder.hull_gain, -1.0, 10.0)?;
    within("place x'H", rudder.hull_place, -2.0, 2.0)?;
    within("place x'R", rudder.place, -2.0, 2.0)?;
    Ok(())
}
