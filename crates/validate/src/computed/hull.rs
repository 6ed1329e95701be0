//! Computes hull forces at low speed, added masses, forces of current, and squat in shallow water.

use fenderline_sim::constants::{KNOT_MPS, SEA_WATER_KGPM3};
use fenderline_sim::hydro::shallow::{
    barrass_channel_squat_m, barrass_squat_m, current_abeam_n, eryuzlu_squat_m,
    icorels_channel_squat_m, icorels_squat_m, shallow_cross_flow_drag,
};
use fenderline_sim::hydro::{
    CrossFlow, Particulars, Velocity, Water, clarke_added_mass, hoerner_drag_coefficient,
    zhou_added_mass,
};

use super::Values;
use super::ships::{container, tug, vessel};

pub(super) fn compute(values: &mut Values) {
    cross_flow(values);
    esso_osaka(values);
    added_masses(values);
    current(values);
    squat(values);
}

/// Cross-flow drag of the container ship in pure sway at 1 m/s and in pure yaw at 0.01 rad/s.
fn cross_flow(values: &mut Values) {
    let ship = container();
    let drag = hoerner_drag_coefficient(ship.beam_m, ship.draught_m);
    values.put("cross_flow/drag", drag, "");
    let flow = CrossFlow { drag_coefficient: drag, yaw_gain_force: 1.0, yaw_gain_moment: 1.0 };
    let force = |sway_mps, yaw_radps| {
        let velocity = Velocity { surge_mps: 0.0, sway_mps, yaw_radps };
        flow.force(&velocity, ship.length_m, ship.draught_m, Water::SEA)
    };
    values.put("cross_flow/sway", -force(1.0, 0.0).sway_n / 1e3, "kN");
    values.put("cross_flow/yaw", -force(0.0, 0.01).yaw_nm / 1e6, "MN·m");
    for (ratio, name) in [(0.5, "0.5"), (0.99, "0.99"), (1.31, "1.31"), (2.31, "2.31"), (4.0, "4")]
    {
        values.put(format!("hoerner/{name}"), hoerner_drag_coefficient(2.0 * ratio, 1.0), "");
    }
}

/// Hull force divided by ½ρLdV² and moment divided by ½ρL²dV², with V² = u² + v² + (rL)², of the tank model of Esso
/// Osaka in three motions.
fn esso_osaka(values: &mut Values) {
    let ship = vessel("esso-osaka").ship;
    let (length_m, draught_m) = (ship.particulars.length_m, ship.particulars.draught_m);
    let states =
        [("ahead", 0.2, -0.05, 0.03), ("astern", -0.15, 0.1, 0.08), ("crabbing", 0.0, 0.2, -0.1)];
    for (name, surge_mps, sway_mps, yaw_radps) in states {
        let velocity = Velocity { surge_mps, sway_mps, yaw_radps };
        let force = ship.hull.low_speed.force(&velocity, length_m, draught_m, Water::FRESH);
        let tip_mps = yaw_radps * length_m;
        let square = surge_mps * surge_mps + sway_mps * sway_mps + tip_mps * tip_mps;
        let unit_n = 0.5 * Water::FRESH.density_kgpm3 * length_m * draught_m * square;
        values.put(format!("esso_osaka/{name}/surge"), force.surge_n / unit_n, "");
        values.put(format!("esso_osaka/{name}/sway"), force.sway_n / unit_n, "");
        values.put(format!("esso_osaka/{name}/yaw"), force.yaw_nm / (unit_n * length_m), "");
    }
    values.put("esso_osaka/block", ship.particulars.block_coefficient(), "");
}

fn added_masses(values: &mut Values) {
    for (name, ship) in [("container", container()), ("tug", tug())] {
        let zhou = zhou_added_mass(&ship)
            .expect("the hull is inside the range of the charts of added mass");
        let mass_kg = SEA_WATER_KGPM3 * (ship.volume_m3 + zhou.surge_m3);
        values.put(format!("{name}/zhou/surge"), zhou.surge_m3 / ship.volume_m3, "");
        values.put(format!("{name}/zhou/sway"), zhou.sway_m3 / ship.volume_m3, "");
        values.put(format!("{name}/zhou/yaw"), zhou.yaw_m5 / ship.yaw_inertia_m5(), "");
        values.put(format!("{name}/zhou/mass"), mass_kg / 1e6, "kt");
    }
    let ship = container();
    let (sway_m3, yaw_m5) = clarke_added_mass(&ship).expect("the ship is slender");
    values.put("container/clarke/sway", sway_m3 / ship.volume_m3, "");
    values.put("container/clarke/yaw", yaw_m5 / ship.yaw_inertia_m5(), "");
}

/// Force of a current of 0.5 m/s abeam on the container ship.
fn current(values: &mut Values) {
    // The midship coefficient is assumed; validation/independent/ship_formulas.py takes the same.
    let (ship, midship_coefficient) = (container(), 0.98);
    for (ratio, name) in [(100.0, "100"), (2.0, "2"), (1.2, "1.2")] {
        let depth_m = ratio * ship.draught_m;
        let force_n = current_abeam_n(&ship, midship_coefficient, depth_m, 0.5, Water::SEA);
        values.put(format!("current/{name}"), force_n.expect("afloat") / 1e3, "kN");
        // The same by what the simulation does: her own drag coefficient in deep water.
        let deep = hoerner_drag_coefficient(ship.beam_m, ship.draught_m);
        let drag = shallow_cross_flow_drag(&ship, deep, depth_m).expect("afloat");
        let cross_flow =
            CrossFlow { drag_coefficient: drag, yaw_gain_force: 1.0, yaw_gain_moment: 1.0 };
        let adrift = Velocity { sway_mps: -0.5, ..Velocity::default() };
        let force = cross_flow.force(&adrift, ship.length_m, ship.draught_m, Water::SEA);
        values.put(format!("current/simulated/{name}"), force.sway_n / 1e3, "kN");
    }
}

/// Squat of the container ship at 8 kn in 1.2 draughts of water.
fn squat(values: &mut Values) {
    let ship = container();
    let (depth_m, speed_mps) = (1.2 * ship.draught_m, 8.0 * KNOT_MPS);
    let barrass_m = barrass_squat_m(&ship, depth_m, speed_mps).expect("afloat");
    let icorels_m = icorels_squat_m(&ship, depth_m, speed_mps).expect("afloat and slow");
    let eryuzlu_m = eryuzlu_squat_m(&ship, depth_m, speed_mps).expect("afloat");
    values.put("squat/barrass", barrass_m, "m");
    values.put("squat/icorels", icorels_m, "m");
    values.put("squat/eryuzlu", eryuzlu_m, "m");
    // The ship of the worked case in a canal of 200 × 14 m and in open water.
    let ship = Particulars::from_block(190.0, 32.26, 11.9, 0.78).expect("a good ship");
    let speed_mps = 9.0 * KNOT_MPS;
    for (name, width_m) in [("open", f64::INFINITY), ("200", 200.0)] {
        let section_m2 = 14.0 * width_m;
        let barrass_m = barrass_channel_squat_m(&ship, 14.0, section_m2, speed_mps);
        let icorels_m = icorels_channel_squat_m(&ship, 14.0, section_m2, speed_mps);
        values.put(format!("squat/channel/barrass/{name}"), barrass_m, "m");
        values.put(format!("squat/channel/icorels/{name}"), icorels_m.expect("afloat"), "m");
    }
}
