//! Esso Osaka, a tanker, as a model of 3 m: low-speed hull forces.

use super::{Source, Standing, Vessel};
use crate::hydro::actuator::RateLimited;
use crate::hydro::added_mass::AddedMass;
use crate::hydro::blend::Hull;
use crate::hydro::low_speed::{CrossFlow, LowSpeedHull};
use crate::hydro::mmg::Mmg;
use crate::hydro::particulars::Particulars;

const MIYAUCHI: &str = "Miyauchi et al. (2022), by the design sheet";

const SOURCES: &[Source] = &[
    Source {
        group: "particulars, mass and its inertia",
        source: MIYAUCHI,
        standing: Standing::Published,
    },
    Source { group: "low-speed hull, added mass", source: MIYAUCHI, standing: Standing::Published },
    Source {
        group: "centre of gravity 10.3/325 L forward; gyradius 0.25 L",
        source: "recalled from the ship's trials report; assumed",
        standing: Standing::Recalled,
    },
];

/// The bare hull of the model, without propeller and rudder: their coefficients are not in the sheet.
pub fn esso_osaka_model() -> Vessel {
    let (length_m, beam_m, draught_m) = (3.0, 0.489, 0.201);
    let mass_unit_m3 = 0.5 * length_m * length_m * draught_m;
    // m' 0.2708 is the rigid body; (Izz + Jzz)' 0.0286 holds both inertias.
    let yaw_gyradius_ratio = 0.25;
    let yaw_added = 0.0286 - 0.2708 * yaw_gyradius_ratio * yaw_gyradius_ratio;
    let particulars = Particulars {
        length_m,
        beam_m,
        draught_m,
        volume_m3: 0.2708 * mass_unit_m3,
        centre_of_gravity_m: 10.3 / 325.0 * length_m,
        yaw_gyradius_ratio,
    };
    let added_mass = AddedMass::from_mmg(&particulars, 0.0467, 0.2579, yaw_added);
    let low_speed = LowSpeedHull {
        ahead: -0.0214,
        astern: -0.0319,
        surge_vr: -0.0081,
        sway_v: -0.3728,
        sway_r: 0.116,
        yaw_v: -0.1458,
        yaw_r: -0.0485,
        cross_flow: CrossFlow {
            drag_coefficient: 0.9665,
            yaw_gain_force: 2.217,
            yaw_gain_moment: 0.8097,
        },
    };
    Vessel {
        name: "Esso Osaka, model of 3 m",
        ship: Mmg {
            particulars,
            added_mass,
            hull: Hull { under_way: None, low_speed },
            propulsion: None,
        },
        approach_mps: 0.0,
        steering: RateLimited { value: 0.0, rate_per_s: 0.0, stop: 0.0 },
        sources: SOURCES,
    }
}
