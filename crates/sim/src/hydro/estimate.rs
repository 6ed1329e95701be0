//! A manoeuvring model from main particulars alone, everything in it estimated: for ships without tests of
//! their own. To be shown as such.
//!
//! | what | by | standing |
//! |---|---|---|
//! | added mass | Zhou's regression | *recalled* |
//! | linear derivatives | Clarke, Gedling & Hine (1983) | *recalled*; KVLCC2's come out within 30 % |
//! | cross-flow drag | Hoerner's midship section | the design sheet |
//! | resistance | C_T = 0.004 on Mumford's wetted surface; astern as Esso Osaka | *recalled* |
//! | wake, thrust deduction | w = 0.5 Cb − 0.05 (Taylor), t = 0.6 w | *recalled* |
//! | propeller | Wageningen B4-70 | as [`super::Propeller`] |
//! | rudder and hull | f_α = 6.13Λ/(2.25 + Λ), interaction as of full ships | *recalled* |

use std::f64::consts::PI;

use super::added_mass::zhou_added_mass;
use super::blend::Hull;
use super::error::{HydroError, within};
use super::low_speed::{CrossFlow, LowSpeedHull, hoerner_drag_coefficient};
use super::mmg::{Mmg, Propulsion, Wake};
use super::particulars::Particulars;
use super::propeller::{Propeller, Series};
use super::rudder::Rudder;

/// What must be known of a propeller and its rudder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SternGear {
    /// Diameter of the propeller [m].
    pub propeller_m: f64,
    /// Movable area of the rudder [m²].
    pub rudder_m2: f64,
    /// Span of the rudder [m].
    pub rudder_span_m: f64,
}

/// Total resistance coefficient on the wetted surface.
const TOTAL_RESISTANCE: f64 = 0.004;
/// Resistance astern over ahead: Esso Osaka's.
const ASTERN_OVER_AHEAD: f64 = 0.0319 / 0.0214;

/// The model of a ship from her particulars, with propeller and rudder where she has them.
///
/// # Errors
/// Particulars that no ship has, or for which the regressions do not hold.
pub fn estimated(ship: Particulars, gear: Option<&SternGear>) -> Result<Mmg, HydroError> {
    let ship = ship.check()?;
    let added_mass = zhou_added_mass(&ship)?;
    let hull = Hull { under_way: None, low_speed: low_speed(&ship) };
    let propulsion = gear.map(|gear| propulsion(&ship, gear)).transpose()?;
    Ok(Mmg { particulars: ship, added_mass, hull, propulsion })
}

fn low_speed(ship: &Particulars) -> LowSpeedHull {
    let (length_m, beam_m, draught_m) = (ship.length_m, ship.beam_m, ship.draught_m);
    let block = ship.block_coefficient();
    let slender = draught_m / length_m;
    // Clarke's coefficients are over ½ρL²; ours over ½ρLd.
    let unit = PI * slender * slender * length_m / draught_m;
    let (broad, thick) = (beam_m / draught_m, beam_m / length_m);
    let wetted_m2 = 1.7 * length_m * draught_m + ship.volume_m3 / draught_m;
    let ahead = -TOTAL_RESISTANCE * wetted_m2 / (length_m * draught_m);
    LowSpeedHull {
        ahead,
        astern: ahead * ASTERN_OVER_AHEAD,
        surge_vr: 0.0,
        sway_v: -unit * (1.0 + 0.40 * block * broad),
        sway_r: -unit * (-0.5 + 2.2 * thick - 0.080 * broad),
        yaw_v: -unit * (0.5 + 2.4 * slender),
        yaw_r: -unit * (0.25 + 0.039 * broad - 0.56 * thick),
        cross_flow: CrossFlow {
            drag_coefficient: hoerner_drag_coefficient(beam_m, draught_m),
            yaw_gain_force: 1.0,
            yaw_gain_moment: 1.0,
        },
    }
}

fn propulsion(ship: &Particulars, gear: &SternGear) -> Result<Propulsion, HydroError> {
    within("diameter of the propeller [m]", gear.propeller_m, 0.01, ship.length_m)?;
    within("area of the rudder [m²]", gear.rudder_m2, 1e-4, ship.length_m * ship.draught_m)?;
    within("span of the rudder [m]", gear.rudder_span_m, 0.01, ship.length_m)?;
    let wake = (0.5 * ship.block_coefficient() - 0.05).max(0.05);
    let aspect = gear.rudder_span_m * gear.rudder_span_m / gear.rudder_m2;
    Ok(Propulsion {
        propeller: Propeller {
            diameter_m: gear.propeller_m,
            thrust_polynomial: None,
            series: Series::B4Pitch08,
        },
        thrust_deduction: 0.6 * wake,
        thrust_deduction_astern: 0.6 * wake,
        wake: Wake { straight: wake, rate: 0.0, limits: [1.0, 1.0], place: -0.48 },
        rudder: Rudder {
            area_m2: gear.rudder_m2,
            lift_gradient: 6.13 * aspect / (2.25 + aspect),
            propeller_to_span: (gear.propeller_m / gear.rudder_span_m).min(1.0),
            wake_ratio: 1.0,
            race_gain: 0.5,
            straightening: [0.4, 0.5],
            straightening_place: -0.7,
            resistance_deduction: 0.3,
            hull_gain: 0.3,
            hull_place: -0.45,
            place: -0.5,
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hydro::vessels::kvlcc2;

    /// The published polynomial's linear terms, against the regression at her particulars: within 30 %,
    /// which is what such regressions are good for.
    #[test]
    fn kvlcc2s_derivatives_come_out_as_well_as_a_regression_can() {
        let published = kvlcc2().ship.hull.low_speed;
        let ours = estimated(kvlcc2().ship.particulars, None).unwrap().hull.low_speed;
        for (ours, published) in [
            (ours.sway_v, published.sway_v),
            (ours.sway_r, published.sway_r),
            (ours.yaw_v, published.yaw_v),
            (ours.yaw_r, published.yaw_r),
            (ours.ahead, published.ahead),
        ] {
            assert!((ours / published - 1.0).abs() < 0.3, "{ours}, published {published}");
        }
    }

    #[test]
    fn impossible_ships_are_refused_by_name() {
        let ship = kvlcc2().ship.particulars;
        let fat = Particulars { volume_m3: 2.0 * ship.volume_m3, ..ship };
        assert!(estimated(fat, None).unwrap_err().to_string().contains("block coefficient"));
        let gear = SternGear { propeller_m: 9.0, rudder_m2: -1.0, rudder_span_m: 15.0 };
        assert!(estimated(ship, Some(&gear)).unwrap_err().to_string().contains("rudder"));
    }
}
