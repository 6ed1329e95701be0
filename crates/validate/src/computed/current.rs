//! Computes the force of a current on a ship at rest, from all directions: side force, yaw moment and surge of the
//! hull.

use fenderline_sim::hydro::{Known, Mmg, Particulars, Velocity, Water, estimated};

use super::Values;

/// Angles off the bow from which the current comes (°).
const OFF_THE_BOW_DEG: [u32; 12] = [0, 10, 20, 40, 60, 80, 100, 120, 140, 160, 170, 180];
/// Depth over draught.
const DEPTH_RATIO: f64 = 1.1;

pub(super) fn compute(values: &mut Values) {
    let deep = tanker();
    let there = deep.at_depth(DEPTH_RATIO * deep.particulars.draught_m);
    for angle_deg in OFF_THE_BOW_DEG {
        let [surge, sway, yaw] = coefficients(&there, f64::from(angle_deg));
        let mut put = |what: &str, value: f64| {
            values.put(format!("current/tanker_250/{what}/{angle_deg}"), value, "");
        };
        put("surge", surge);
        // From ahead and astern both are zero.
        if angle_deg % 180 != 0 {
            put("sway", sway);
            put("yaw", yaw);
        }
    }
}

/// Force coefficients C_X and C_Y (divided by ½ρLTV²) and moment coefficient C_N (divided by ½ρL²TV²), for a current
/// from ahead, from starboard or from astern. C_X is positive if the water pushes the ship ahead, C_Y if it pushes her
/// to port, and C_N if it turns her bow to port.
fn coefficients(ship: &Mmg, off_the_bow_deg: f64) -> [f64; 3] {
    let hull = &ship.particulars;
    let (sin, cos) = libm::sincos(off_the_bow_deg.to_radians());
    // The water comes from starboard, so through the water she goes to starboard.
    let velocity = Velocity { surge_mps: cos, sway_mps: sin, yaw_radps: 0.0 };
    let force = ship.hull.force(&velocity, hull, &ship.added_mass, Water::SEA);
    let unit_n = 0.5 * Water::SEA.density_kgpm3 * hull.length_m * hull.draught_m;
    [force.surge_n / unit_n, -force.sway_n / unit_n, -force.yaw_nm / (unit_n * hull.length_m)]
}

/// The tanker of 250,000 dwt of the worked example in OCIMF's guidelines, with her particulars. The tanker's beam and
/// block coefficient are not in the example of OCIMF: they are usual for such ships.
fn tanker() -> Mmg {
    let particulars = Particulars::from_block(329.3, 51.8, 19.2, 0.85).expect("she floats");
    let known =
        Known { particulars, added_mass: None, polynomial: None, low_speed: None, gear: None };
    estimated(&known).expect("inside the regressions").model
}
