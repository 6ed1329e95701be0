//! Computes effects of shallow water: the factors of each set of corrections, and the turns and zig-zags with them.

use fenderline_sim::constants::STANDARD_GRAVITY_MPS2;
use fenderline_sim::hydro::manoeuvres::{Approach, turning_circle, zig_zag};
use fenderline_sim::hydro::shallow::{CorrectionSet, Corrections};
use fenderline_sim::hydro::vessels::Vessel;
use fenderline_sim::hydro::{EstimateMethod, Mmg, Model3, Particulars, Water};

use super::Values;
use super::estimates::{ReferenceShip, estimate_of};
use super::ships::vessel;

/// Ratios of depth to draught, with their names in the results.
const DEPTHS: [(f64, &str); 3] = [(2.0, "2"), (1.5, "1.5"), (1.2, "1.2")];
/// The sets of corrections that are compared.
const SETS: [CorrectionSet; 4] = [
    CorrectionSet::Combined,
    CorrectionSet::EffectiveAspectRatio,
    CorrectionSet::Ankudinov,
    CorrectionSet::Taimuri,
];
/// Ships with a propeller and a rudder; and for each, whether all sets of corrections are compared or only the default,
/// and whether drift and overshoot are compared.
const SHIPS: [(&str, bool, bool); 5] = [
    ("kvlcc2", true, true),
    ("kcs", true, true),
    ("esso-osaka", true, false),
    ("bulk-carrier", false, false),
    ("container-ship", false, false),
];
/// A correction factor: its name in the results, and the function that takes it from [`Corrections`].
type Factor = (&'static str, fn(&Corrections) -> f64);

const Y_V: Factor = ("y_v", |all| all.hull.y_v);
const Y_R: Factor = ("y_r", |all| all.hull.y_r);
const Y_VVV: Factor = ("y_vvv", |all| all.hull.y_vvv);
const N_V: Factor = ("n_v", |all| all.hull.n_v);
const N_R: Factor = ("n_r", |all| all.hull.n_r);
const N_VVR: Factor = ("n_vvr", |all| all.hull.n_vvr);
const X_VR: Factor = ("x_vr", |all| all.hull.x_vr);
const RESISTANCE: Factor = ("resistance", |all| all.hull.resistance);
const M_X: Factor = ("m_x", |all| all.mass.surge);
const M_Y: Factor = ("m_y", |all| all.mass.sway);
const J_Z: Factor = ("j_z", |all| all.mass.yaw);

/// The factors that are compared: ship, set of corrections, and the factors of this set.
const FACTORS: [(&str, CorrectionSet, &[Factor]); 7] = [
    (
        "tanker",
        CorrectionSet::Combined,
        &[Y_V, Y_R, Y_VVV, N_V, N_R, N_VVR, X_VR, RESISTANCE, M_X, M_Y, J_Z],
    ),
    ("tanker", CorrectionSet::EffectiveAspectRatio, &[N_R]),
    ("tanker", CorrectionSet::Ankudinov, &[N_R]),
    ("tanker", CorrectionSet::Taimuri, &[N_R]),
    ("kvlcc2", CorrectionSet::Combined, &[Y_V, Y_R, N_V, N_R, M_Y, J_Z]),
    ("kvlcc2", CorrectionSet::Ankudinov, &[N_V]),
    ("kvlcc2", CorrectionSet::Taimuri, &[Y_V]),
];
/// Time step of a manoeuvre, divided by the time in which the ship sails her own length.
const STEP: f64 = 0.01;
/// Froude number of the approach, for a ship whose data have no speed of approach.
const FROUDE: f64 = 0.15;

/// The name of a set of corrections in the results.
fn name_of(set: CorrectionSet) -> &'static str {
    match set {
        CorrectionSet::Combined => "combined",
        CorrectionSet::EffectiveAspectRatio => "aspect_ratio",
        CorrectionSet::Ankudinov => "ankudinov",
        CorrectionSet::Taimuri => "taimuri",
    }
}

pub(super) fn compute(values: &mut Values) {
    for (name, set, factors) in FACTORS {
        let ship = if name == "tanker" { tanker() } else { vessel(name).ship.particulars };
        let set_name = name_of(set);
        for (ratio, depth) in DEPTHS {
            let all = Corrections::of(set, &ship, ratio * ship.draught_m);
            for (factor, value) in factors {
                let name = format!("shallow/{name}/{set_name}/{factor}/{depth}");
                values.put(name, value(&all), "");
            }
        }
    }
    estimated(values);
    for (name, by_all_sets, whole) in SHIPS {
        let vessel = vessel(name);
        let deep = Measures::of(&vessel, vessel.ship);
        let sets = if by_all_sets { &SETS[..] } else { &[CorrectionSet::Combined] };
        for &set in sets {
            let set_name = name_of(set);
            for (ratio, depth) in DEPTHS {
                let ship = vessel.ship.at_depth_by(set, ratio * vessel.ship.particulars.draught_m);
                let there = Measures::of(&vessel, ship);
                let mut put = |measure: &str, there: f64, deep: f64| {
                    let name = format!("shallow/{name}/{set_name}/{measure}/{depth}");
                    values.put(name, there / deep, "");
                };
                put("diameter", there.diameter_m, deep.diameter_m);
                if whole && set == CorrectionSet::Combined {
                    put("drift", there.drift_rad, deep.drift_rad);
                    put("overshoot_20", there.overshoot_20_rad, deep.overshoot_20_rad);
                }
            }
        }
    }
}

/// Tactical diameters of ships that are estimated from particulars alone, by the estimation method that the program
/// chooses.
fn estimated(values: &mut Values) {
    for ship in ReferenceShip::ALL {
        let name = ship.name();
        let vessel = estimate_of(ship, EstimateMethod::YoshimuraMasumoto);
        let deep = Measures::of(&vessel, vessel.ship);
        for (ratio, depth) in DEPTHS {
            let ship = vessel.ship.at_depth(ratio * vessel.ship.particulars.draught_m);
            let there = Measures::of(&vessel, ship);
            let name = format!("shallow/estimated/{name}/diameter/{depth}");
            values.put(name, there.diameter_m / deep.diameter_m, "");
        }
    }
}

/// The particulars of the tanker of 190 000 dwt of van Berlekom & Goddard, for which factors are computed.
fn tanker() -> Particulars {
    Particulars {
        length_m: 304.8,
        beam_m: 47.17,
        draught_m: 18.46,
        volume_m3: 220_000.0,
        centre_of_gravity_m: 0.0,
        yaw_gyradius_ratio: 0.25,
    }
}

/// The measures of a turn with a rudder of 35° to starboard, and of a 20°/20° zig-zag.
struct Measures {
    diameter_m: f64,
    drift_rad: f64,
    overshoot_20_rad: f64,
}

impl Measures {
    /// Runs both manoeuvres at the speed of approach that the ship has in deep water. A measure is NaN if she cannot do
    /// its manoeuvre with a set of corrections.
    fn of(vessel: &Vessel, ship: Mmg) -> Measures {
        // In ratios the density of the water plays no part.
        let model = Model3::new(ship, Water::SEA);
        let length_m = ship.particulars.length_m;
        let speed_mps = vessel
            .approach_mps
            .unwrap_or_else(|| FROUDE * (STANDARD_GRAVITY_MPS2 * length_m).sqrt());
        let approach =
            Approach::at(&model, speed_mps, vessel.steering, STEP * length_m / speed_mps)
                .expect("some revolutions of the propeller hold the speed of approach");
        let turn = turning_circle(&model, &approach, 35_f64.to_radians()).ok();
        let check_rad = 20_f64.to_radians();
        let run = zig_zag(&model, &approach, check_rad, check_rad).ok();
        Measures {
            diameter_m: turn.map_or(f64::NAN, |turn| turn.tactical_diameter_m),
            drift_rad: turn.map_or(f64::NAN, |turn| turn.steady.drift_rad),
            overshoot_20_rad: run.map_or(f64::NAN, |run| run.first_overshoot_rad),
        }
    }
}
