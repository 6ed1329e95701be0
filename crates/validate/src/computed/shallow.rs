//! Shallow water: factors of each set of corrections, and what they make of turns and zig-zags.

use fenderline_sim::constants::STANDARD_GRAVITY_MPS2;
use fenderline_sim::hydro::manoeuvres::{Approach, turning_circle, zig_zag};
use fenderline_sim::hydro::shallow::{CorrectionSet, Corrections};
use fenderline_sim::hydro::vessels::Vessel;
use fenderline_sim::hydro::{EstimateMethod, Mmg, Model3, Particulars, Water};

use super::Values;
use super::estimates::{self, estimate_of};
use super::ships::vessel;

/// Depth over draught, and their names.
const DEPTHS: [(f64, &str); 3] = [(2.0, "2"), (1.5, "1.5"), (1.2, "1.2")];
/// The sets of corrections, and their names.
const SETS: [(CorrectionSet, &str); 4] = [
    (CorrectionSet::Combined, "combined"),
    (CorrectionSet::EffectiveAspectRatio, "aspect_ratio"),
    (CorrectionSet::Ankudinov, "ankudinov"),
    (CorrectionSet::Taimuri, "taimuri"),
];
/// Ships that have a propeller and a rudder, whether all sets are compared for them or the one taken, and whether drift
/// and overshoot are, too.
const SHIPS: [(&str, bool, bool); 5] = [
    ("kvlcc2", true, true),
    ("kcs", true, true),
    ("esso-osaka", true, false),
    ("bulk-carrier", false, false),
    ("container-ship", false, false),
];
/// The factors that are compared, by ship and set.
const FACTORS: [(&str, usize, &[&str]); 7] = [
    (
        "tanker",
        0,
        &["y_v", "y_r", "y_vvv", "n_v", "n_r", "n_vvr", "x_vr", "resistance", "m_x", "m_y", "j_z"],
    ),
    ("tanker", 1, &["n_r"]),
    ("tanker", 2, &["n_r"]),
    ("tanker", 3, &["n_r"]),
    ("kvlcc2", 0, &["y_v", "y_r", "n_v", "n_r", "m_y", "j_z"]),
    ("kvlcc2", 2, &["n_v"]),
    ("kvlcc2", 3, &["y_v"]),
];
/// A step over the time in which the ship sails her own length.
const STEP: f64 = 0.01;
/// Froude number of the approach of a ship without a speed of her own.
const FROUDE: f64 = 0.15;

pub(super) fn compute(values: &mut Values) {
    for (name, set, terms) in FACTORS {
        let ship = if name == "tanker" { tanker() } else { vessel(name).ship.particulars };
        let (set, set_name) = SETS[set];
        for (ratio, depth) in DEPTHS {
            let all = Corrections::of(set, &ship, ratio * ship.draught_m);
            for term in terms {
                let name = format!("shallow/{name}/{set_name}/{term}/{depth}");
                values.put(name, factor(&all, term), "");
            }
        }
    }
    estimated(values);
    for (name, by_all_sets, whole) in SHIPS {
        let vessel = vessel(name);
        let deep = Measures::of(&vessel, vessel.ship);
        for &(set, set_name) in if by_all_sets { &SETS[..] } else { &SETS[..1] } {
            for (ratio, depth) in DEPTHS {
                let ship = vessel.ship.at_depth_by(set, ratio * vessel.ship.particulars.draught_m);
                let there = Measures::of(&vessel, ship);
                let mut put = |measure: &str, there: f64, deep: f64| {
                    let name = format!("shallow/{name}/{set_name}/{measure}/{depth}");
                    values.put(name, there / deep, "");
                };
                put("diameter", there.diameter_m, deep.diameter_m);
                if whole && set == SETS[0].0 {
                    put("drift", there.drift_rad, deep.drift_rad);
                    put("overshoot_20", there.overshoot_20_rad, deep.overshoot_20_rad);
                }
            }
        }
    }
}

/// Tactical diameters of ships that are estimated from particulars alone, by the route that the program takes.
fn estimated(values: &mut Values) {
    for name in estimates::SHIPS {
        let vessel = estimate_of(name, EstimateMethod::YoshimuraMasumoto);
        let deep = Measures::of(&vessel, vessel.ship);
        for (ratio, depth) in DEPTHS {
            let ship = vessel.ship.at_depth(ratio * vessel.ship.particulars.draught_m);
            let there = Measures::of(&vessel, ship);
            let name = format!("shallow/estimated/{name}/diameter/{depth}");
            values.put(name, there.diameter_m / deep.diameter_m, "");
        }
    }
}

/// A factor by the name of its term.
fn factor(all: &Corrections, term: &str) -> f64 {
    match term {
        "y_v" => all.hull.y_v,
        "y_r" => all.hull.y_r,
        "y_vvv" => all.hull.y_vvv,
        "n_v" => all.hull.n_v,
        "n_r" => all.hull.n_r,
        "n_vvr" => all.hull.n_vvr,
        "x_vr" => all.hull.x_vr,
        "resistance" => all.hull.resistance,
        "m_x" => all.mass.surge,
        "m_y" => all.mass.sway,
        "j_z" => all.mass.yaw,
        other => unreachable!("no factor is called {other}"),
    }
}

/// The tanker of 190 000 dwt of van Berlekom & Goddard.
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

/// Of a turn with a rudder of 35° to starboard, and of a 20°/20° zig-zag.
struct Measures {
    diameter_m: f64,
    drift_rad: f64,
    overshoot_20_rad: f64,
}

impl Measures {
    /// At the speed of approach that she has in deep water; a set that leaves her without an answer gives NaN.
    fn of(vessel: &Vessel, ship: Mmg) -> Measures {
        // In ratios the density of the water plays no part.
        let model = Model3::new(ship, Water::SEA);
        let length_m = ship.particulars.length_m;
        let speed_mps = vessel
            .approach_mps
            .unwrap_or_else(|| FROUDE * (STANDARD_GRAVITY_MPS2 * length_m).sqrt());
        let approach =
            Approach::at(&model, speed_mps, vessel.steering, STEP * length_m / speed_mps)
                .expect("the propeller holds the speed of approach");
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
