//! The table of vessels.

use fenderline_contact::BodyState;
use fenderline_sim::attitude::Attitude;
use fenderline_sim::hydro::{Force, Velocity};
use fenderline_sim::track::OnPlan;
use fenderline_sim::{Environment, Soundings, VesselForces, VesselSetup, VesselState};

use super::{Column, Layout, List, flag, float, known, name};
use crate::row::Row;

/// A row of the table of vessels: one vessel in one output interval.
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
    under_keel_m: [Option<f64>; 2],
    on_plan: Option<OnPlan>,
}

impl VesselRow {
    /// The row of vessel number `vessel` in a time step that began at `t_s` with the vessel in `state`.
    pub(crate) fn new(
        t_s: f64,
        vessel: usize,
        setup: (&VesselSetup, &Environment),
        state: &BodyState,
        (now, soundings): (&VesselState, &Soundings),
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
            tide_m: setup.1.level_m(t_s),
            aground: now.aground,
            under_keel_m: setup.0.clearances_m(now.squat_m, soundings),
            on_plan: setup.0.on_plan(state),
        }
    }

    /// The same row, with the time `start_s` as the start of its interval.
    pub(crate) fn at(self, start_s: f64) -> VesselRow {
        VesselRow { t_s: start_s, ..self }
    }
}

impl Row for VesselRow {
    type Key = usize;

    fn key(&self) -> usize {
        self.vessel
    }

    fn join(&mut self, later: VesselRow) {
        self.forces = each_force(&self.forces, |force, of| force + of(&later.forces));
        (self.attitude, self.wave_motion) = (later.attitude, later.wave_motion);
        self.aground |= later.aground;
    }

    fn close(&mut self, _own: f64, all: f64) {
        self.forces = each_force(&self.forces, |force, _| force * (1.0 / all));
    }
}

/// Replaces each force by the result of the function `with`, whose arguments are the force and a function that reads
/// the same force from the forces of another row.
fn each_force(
    forces: &VesselForces,
    with: impl Fn(Force, fn(&VesselForces) -> Force) -> Force,
) -> VesselForces {
    VesselForces {
        hull: with(forces.hull, |f| f.hull),
        propeller: with(forces.propeller, |f| f.propeller),
        rudder: with(forces.rudder, |f| f.rudder),
        thrusters: with(forces.thrusters, |f| f.thrusters),
        wind: with(forces.wind, |f| f.wind),
        waves: with(forces.waves, |f| f.waves),
        excitation: with(forces.excitation, |f| f.excitation),
        radiation: with(forces.radiation, |f| f.radiation),
        banks: with(forces.banks, |f| f.banks),
        passing: with(forces.passing, |f| f.passing),
        bottom: with(forces.bottom, |f| f.bottom),
    }
}

/// The table `vessels`.
pub(crate) fn vessels_table() -> Layout<VesselRow> {
    let columns: Vec<Column<VesselRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("vessel", "name of the vessel's body", List::Vessels, |r| Some(r.vessel)),
        float(
            "rudder_order_rad",
            "rad",
            "ordered rudder angle; positive turns the ship to starboard",
            |r| r.rudder_order_rad,
        ),
        float("rudder_rad", "rad", "rudder angle; positive turns the ship to starboard", |r| {
            r.rudder_rad
        }),
        float("shaft_order_rps", "1/s", "ordered revolutions per second, positive ahead", |r| {
            r.shaft_order_rps
        }),
        float("shaft_rps", "1/s", "revolutions per second, positive ahead", |r| r.shaft_rps),
        float(
            "surge_through_water_mps",
            "m/s",
            "surge velocity through the water, positive forward",
            |r| r.water.surge_mps,
        ),
        float(
            "sway_through_water_mps",
            "m/s",
            "sway velocity through the water at midship, positive to starboard",
            |r| r.water.sway_mps,
        ),
        float("r_radps", "rad/s", "yaw rate r, positive to starboard", |r| r.water.yaw_radps),
    ];
    let forces = [
        force_columns!(VesselRow, "hull_", "the hull, current included", forces.hull),
        force_columns!(VesselRow, "propeller_", "the propeller", forces.propeller),
        force_columns!(VesselRow, "rudder_", "the rudder", forces.rudder),
        force_columns!(
            VesselRow,
            "thrusters_",
            "tunnel thrusters and azimuth units",
            forces.thrusters
        ),
        force_columns!(VesselRow, "wind_", "the wind", forces.wind),
        force_columns!(VesselRow, "waves_", "mean and slow wave drift", forces.waves),
        force_columns!(
            VesselRow,
            "excitation_",
            "the waves' excitation of a vessel with hydrodynamic data",
            forces.excitation
        ),
        force_columns!(
            VesselRow,
            "radiation_",
            "the radiation force, the reaction of the water to the motion of a vessel with \
             hydrodynamic data, and the coupling with heave, roll and pitch",
            forces.radiation
        ),
        force_columns!(VesselRow, "banks_", "banks (unvalidated)", forces.banks),
        force_columns!(
            VesselRow,
            "passing_",
            "the flow of passing ships and of other vessels",
            forces.passing
        ),
        force_columns!(VesselRow, "bottom_", "the seabed while aground", forces.bottom),
    ];
    let motions: Vec<Column<VesselRow>> = vec![
        float(
            "wave_surge_m",
            "m",
            "first-order wave motion at the end of the interval: surge, positive forward",
            |r| r.wave_motion[0],
        ),
        float(
            "wave_sway_m",
            "m",
            "first-order wave motion at the end of the interval: sway, positive to starboard",
            |r| r.wave_motion[1],
        ),
        float(
            "wave_heave_m",
            "m",
            "first-order wave motion at the end of the interval: heave, positive down",
            |r| r.wave_motion[2],
        ),
        float(
            "wave_roll_rad",
            "rad",
            "first-order wave motion at the end of the interval: roll, positive to starboard",
            |r| r.wave_motion[3],
        ),
        float(
            "wave_pitch_rad",
            "rad",
            "first-order wave motion at the end of the interval: pitch, positive bow up",
            |r| r.wave_motion[4],
        ),
        float(
            "wave_yaw_rad",
            "rad",
            "first-order wave motion at the end of the interval: yaw, positive to starboard",
            |r| r.wave_motion[5],
        ),
        float(
            "heave_m",
            "m",
            "heave at the end of the interval, positive down; wave motion not included",
            |r| r.attitude.heave.value,
        ),
        float(
            "roll_rad",
            "rad",
            "roll angle at the end of the interval, positive to starboard; wave motion not included",
            |r| r.attitude.roll.value,
        ),
        float(
            "pitch_rad",
            "rad",
            "pitch angle at the end of the interval, positive bow up; wave motion not included",
            |r| r.attitude.pitch.value,
        ),
        float(
            "squat_m",
            "m",
            "squat: sinkage of the hull at the vessel's speed through the water",
            |r| r.squat_m,
        ),
        float("tide_m", "m", "water level above datum", |r| r.tide_m),
        flag("aground", "whether the vessel is aground in a step of the interval", |r| r.aground),
        known(
            "under_keel_fore_m",
            "m",
            "least clearance under the keel of the forward half of the vessel, squat included, without trim and waves",
            |r| r.under_keel_m[0],
        ),
        known(
            "under_keel_aft_m",
            "m",
            "least clearance under the keel of the after half of the vessel, squat included, without trim and waves",
            |r| r.under_keel_m[1],
        ),
        known(
            "along_track_m",
            "m",
            "distance of midship along the track of the vessel's passage plan from the first waypoint",
            |r| r.on_plan.map(|on| on.along_m),
        ),
        known(
            "cross_track_m",
            "m",
            "cross-track distance of midship from the track of the passage plan, positive to starboard of the track",
            |r| r.on_plan.map(|on| on.cross_track_m),
        ),
    ];
    let columns = columns.into_iter().chain(forces.into_iter().flatten()).chain(motions).collect();
    Layout {
        name: "vessels",
        rows: "one row per vessel and interval: states are those at the start of the interval, \
            forces are means over the interval",
        columns,
    }
}
