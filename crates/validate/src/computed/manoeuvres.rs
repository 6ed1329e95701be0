//! Computes the standard manoeuvres of KVLCC2, KCS and Esso Osaka.

use fenderline_sim::hydro::manoeuvres::{Approach, self_propulsion_rps, turning_circle, zig_zag};
use fenderline_sim::hydro::vessels::Vessel;
use fenderline_sim::hydro::{Model3, Water};

use super::Values;
use super::ships::{fitted_kvlcc2, vessel};

/// Time step of a manoeuvre, divided by the time in which the ship sails her own length; this is 0.08 s for KVLCC2.
const STEP: f64 = 0.002;

pub(super) fn compute(values: &mut Values) {
    for (name, key) in [("kvlcc2", "kvlcc2"), ("kvlcc2_model", "kvlcc2-model"), ("kcs", "kcs")] {
        let trial = Trial::of(&vessel(key));
        for (side, sign) in [("starboard", 1.0), ("port", -1.0)] {
            trial.turn(values, &format!("{name}/turn_35/{side}"), sign * 35.0);
            trial.zig_zag(values, &format!("{name}/zigzag_10/{side}"), sign * 10.0);
            trial.zig_zag(values, &format!("{name}/zigzag_20/{side}"), sign * 20.0);
        }
    }
    for name in ["kvlcc2", "kcs"] {
        let vessel = vessel(name);
        let model = Model3::new(vessel.ship, Water::SEA);
        let rps = self_propulsion_rps(&model, approach_mps(&vessel)).expect("a balance");
        values.put(format!("{name}/self_propulsion"), rps, "1/s");
    }
    // The fit took the revolutions of the tests, which are her full revolutions, and no others hold her speed.
    let data = fitted_kvlcc2();
    let mut fitted = Trial::of(&data.trial());
    fitted.approach.shaft_rps = data.shaft.expect("she has a propeller").full_rps;
    for (side, sign) in [("starboard", 1.0), ("port", -1.0)] {
        fitted.turn(values, &format!("kvlcc2_fitted/turn_35/{side}"), sign * 35.0);
    }
    // In ratios the density of the water plays no part.
    let esso_osaka = Trial::of(&vessel("esso-osaka"));
    for (side, sign) in [("starboard", 1.0), ("port", -1.0)] {
        esso_osaka.turn(values, &format!("esso_osaka/turn_35/{side}"), sign * 35.0);
        esso_osaka.turn(values, &format!("esso_osaka/turn_20/{side}"), sign * 20.0);
    }
}

fn approach_mps(vessel: &Vessel) -> f64 {
    vessel.approach_mps.expect("every published ship has a speed of approach")
}

/// A ship at her speed of approach, ready for a standard manoeuvre.
pub(super) struct Trial {
    pub(super) model: Model3,
    pub(super) approach: Approach,
    pub(super) length_m: f64,
}

impl Trial {
    fn of(vessel: &Vessel) -> Trial {
        Trial::stepped(vessel, STEP)
    }

    /// Makes a trial from a vessel and a step, given as a share of the time in which she sails her own length.
    pub(super) fn stepped(vessel: &Vessel, step: f64) -> Trial {
        let model = Model3::new(vessel.ship, Water::SEA);
        let length_m = vessel.ship.particulars.length_m;
        let approach_mps = approach_mps(vessel);
        let step_s = step * length_m / approach_mps;
        let approach = Approach::at(&model, approach_mps, vessel.steering, step_s)
            .expect("some revolutions of the propeller hold the speed of approach");
        Trial { model, approach, length_m }
    }

    /// Computes a turn with the rudder to one side: every measure counts positive to that side.
    fn turn(&self, values: &mut Values, name: &str, rudder_deg: f64) {
        let turn = turning_circle(&self.model, &self.approach, rudder_deg.to_radians())
            .expect("she turns");
        let steady = turn.steady;
        values.put(format!("{name}/advance"), turn.advance_m / self.length_m, "L");
        values.put(format!("{name}/diameter"), turn.tactical_diameter_m / self.length_m, "L");
        values.put(format!("{name}/speed_ratio"), steady.speed_ratio, "");
        values.put(format!("{name}/rate"), steady.yaw_rate.abs(), "");
        values.put(format!("{name}/drift"), steady.drift_rad.to_degrees().abs(), "°");
    }

    fn zig_zag(&self, values: &mut Values, name: &str, rudder_deg: f64) {
        let check_rad = rudder_deg.abs().to_radians();
        let run = zig_zag(&self.model, &self.approach, rudder_deg.to_radians(), check_rad)
            .expect("she answers her rudder");
        values.put(format!("{name}/first"), run.first_overshoot_rad.to_degrees(), "°");
        values.put(format!("{name}/second"), run.second_overshoot_rad.to_degrees(), "°");
    }
}
