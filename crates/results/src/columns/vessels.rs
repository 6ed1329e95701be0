//! The table of vessels.

use fenderline_contact::BodyState;
use fenderline_sim::attitude::Attitude;
use fenderline_sim::hydro::Velocity;
use fenderline_sim::{Environment, VesselForces, VesselSetup, VesselState};

use super::{Column, List, flag, float, name};

/// One vessel in one step.
pub(crate) struct VesselRow {
    t_s: f64,
    vessel: usize,
    rudder_order_rad: f64,
    rudder_rad: f64,
    shaft_order_rps: f64,
    shaft_rps: f64,
    water: Velocity,
    forces: VesselForces,
    attitude: Attitude,
    wave_motion: [f64; 6],
    squat_m: f64,
    tide_m: f64,
    aground: bool,
}

impl VesselRow {
    /// The row of vessel number `vessel` in a step that began at `t_s` in `state`.
    pub(crate) fn new(
        t_s: f64,
        vessel: usize,
        setup: (&VesselSetup, &Environment),
        state: &BodyState,
        now: &VesselState,
        forces: &VesselForces,
    ) -> VesselRow {
        VesselRow {
            t_s,
            vessel,
            rudder_order_rad: now.orders.rudder_rad,
            rudder_rad: now.rudder.value,
            shaft_order_rps: now.orders.shaft * now.shaft.stop,
            shaft_rps: now.shaft.value,
            water: setup.0.velocity(state, setup.1, t_s),
            forces: *forces,
            attitude: now.attitude,
            wave_motion: now.wave_motion.motion,
            squat_m: now.squat_m,
            tide_m: setup.1.tide.level_m(t_s),
            aground: now.aground,
        }
    }
}

/// The columns of `vessels`, in their order.
pub(crate) fn vessels_columns() -> Vec<Column<VesselRow>> {
    vec![
        float("t_s", "s", "start of the step", |r| r.t_s),
        name("vessel", "name of the vessel's body", List::Vessels, |r| Some(r.vessel)),
        float("rudder_order_rad", "rad", "rudder ordered, positive turns to starboard", |r| {
            r.rudder_order_rad
        }),
        float("rudder_rad", "rad", "rudder in the step", |r| r.rudder_rad),
        float("shaft_order_rps", "1/s", "revolutions ordered, positive ahead", |r| {
            r.shaft_order_rps
        }),
        float("shaft_rps", "1/s", "revolutions in the step", |r| r.shaft_rps),
        float("u_water_mps", "m/s", "surge through the water, forward", |r| r.water.surge_mps),
        float("v_water_mps", "m/s", "sway through the water at midship, to starboard", |r| {
            r.water.sway_mps
        }),
        float("r_radps", "rad/s", "rate of turn, positive to starboard", |r| r.water.yaw_radps),
        float("hull_x_n", "N", "force of hull, current in it: forward", |r| r.forces.hull.surge_n),
        float("hull_y_n", "N", "force of hull, current in it: to starboard", |r| {
            r.forces.hull.sway_n
        }),
        float(
            "hull_n_nm",
            "N·m",
            "moment of hull, current in it: about midship, to starboard",
            |r| r.forces.hull.yaw_nm,
        ),
        float("propeller_x_n", "N", "force of propeller: forward", |r| r.forces.propeller.surge_n),
        float("propeller_y_n", "N", "force of propeller: to starboard", |r| {
            r.forces.propeller.sway_n
        }),
        float("propeller_n_nm", "N·m", "moment of propeller: about midship, to starboard", |r| {
            r.forces.propeller.yaw_nm
        }),
        float("rudder_x_n", "N", "force of rudder: forward", |r| r.forces.rudder.surge_n),
        float("rudder_y_n", "N", "force of rudder: to starboard", |r| r.forces.rudder.sway_n),
        float("rudder_n_nm", "N·m", "moment of rudder: about midship, to starboard", |r| {
            r.forces.rudder.yaw_nm
        }),
        float("thrusters_x_n", "N", "force of thrusters, azimuth units among them: forward", |r| {
            r.forces.thrusters.surge_n
        }),
        float(
            "thrusters_y_n",
            "N",
            "force of thrusters, azimuth units among them: to starboard",
            |r| r.forces.thrusters.sway_n,
        ),
        float(
            "thrusters_n_nm",
            "N·m",
            "moment of thrusters, azimuth units among them: about midship, to starboard",
            |r| r.forces.thrusters.yaw_nm,
        ),
        float("wind_x_n", "N", "force of wind: forward", |r| r.forces.wind.surge_n),
        float("wind_y_n", "N", "force of wind: to starboard", |r| r.forces.wind.sway_n),
        float("wind_n_nm", "N·m", "moment of wind: about midship, to starboard", |r| {
            r.forces.wind.yaw_nm
        }),
        float("waves_x_n", "N", "force of mean wave drift: forward", |r| r.forces.waves.surge_n),
        float("waves_y_n", "N", "force of mean wave drift: to starboard", |r| {
            r.forces.waves.sway_n
        }),
        float(
            "waves_n_nm",
            "N·m",
            "moment of mean wave drift: about midship, to starboard",
            |r| r.forces.waves.yaw_nm,
        ),
        float("banks_x_n", "N", "force of banks, unvalidated: forward", |r| r.forces.banks.surge_n),
        float("banks_y_n", "N", "force of banks, unvalidated: to starboard", |r| {
            r.forces.banks.sway_n
        }),
        float(
            "banks_n_nm",
            "N·m",
            "moment of banks, unvalidated: about midship, to starboard",
            |r| r.forces.banks.yaw_nm,
        ),
        float("bottom_x_n", "N", "force of the bottom, where she is aground: forward", |r| {
            r.forces.bottom.surge_n
        }),
        float("bottom_y_n", "N", "force of the bottom, where she is aground: to starboard", |r| {
            r.forces.bottom.sway_n
        }),
        float(
            "bottom_n_nm",
            "N·m",
            "moment of the bottom, where she is aground: about midship, to starboard",
            |r| r.forces.bottom.yaw_nm,
        ),
        float(
            "wave_surge_m",
            "m",
            "first-order wave motion: surge, forward, at the end of the step",
            |r| r.wave_motion[0],
        ),
        float(
            "wave_sway_m",
            "m",
            "first-order wave motion: sway, to starboard, at the end of the step",
            |r| r.wave_motion[1],
        ),
        float(
            "wave_heave_m",
            "m",
            "first-order wave motion: heave, down, at the end of the step",
            |r| r.wave_motion[2],
        ),
        float(
            "wave_roll_rad",
            "rad",
            "first-order wave motion: roll, to starboard, at the end of the step",
            |r| r.wave_motion[3],
        ),
        float(
            "wave_pitch_rad",
            "rad",
            "first-order wave motion: pitch, bow up, at the end of the step",
            |r| r.wave_motion[4],
        ),
        float(
            "wave_yaw_rad",
            "rad",
            "first-order wave motion: yaw, to starboard, at the end of the step",
            |r| r.wave_motion[5],
        ),
        float("heave_m", "m", "heave at the end of the step, positive down, without waves", |r| {
            r.attitude.heave.value
        }),
        float("roll_rad", "rad", "heel at the end of the step, to starboard, without waves", |r| {
            r.attitude.roll.value
        }),
        float("pitch_rad", "rad", "pitch at the end of the step, bow up, without waves", |r| {
            r.attitude.pitch.value
        }),
        float("squat_m", "m", "how much deeper she sits because she is under way", |r| r.squat_m),
        float("tide_m", "m", "level of the water above datum", |r| r.tide_m),
        flag("aground", "whether the bottom holds her", |r| r.aground),
    ]
}
