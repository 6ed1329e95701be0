//! Records a vessel's way along her passage plan.

use fenderline_contact::BodyState;
use fenderline_contact::number::{greater, lesser};
use fenderline_sim::track::PassagePlan;
use fenderline_sim::{Soundings, VesselSetup};

use crate::plot::Decimator;

/// A vessel's way along her passage plan. The series go along the planned track: a vessel that goes back adds nothing
/// until she is farther than she was, and nothing before the first waypoint and after the last one.
pub(in crate::run_page) struct PlanTrace {
    /// Cross-track distance by distance along the track (m), positive to starboard of the track.
    pub(in crate::run_page) cross_track_m: Decimator,
    /// Speed over ground by distance along the track (m/s, m).
    pub(in crate::run_page) speed_mps: Decimator,
    /// Least under-keel clearance of the forward and of the after half by distance along the track (m), squat included;
    /// empty in deep water.
    pub(in crate::run_page) under_keel_m: [Decimator; 2],
    pub(in crate::run_page) legs: Vec<LegTrace>,
    farthest_m: f64,
    ship: VesselSetup,
}

/// What happened on a leg.
#[derive(Clone, Copy, Debug, Default)]
pub(in crate::run_page) struct LegTrace {
    /// First and last time on the leg (s).
    pub(in crate::run_page) times_s: Option<[f64; 2]>,
    /// The largest cross-track distance to either side, with its sign: positive to starboard of the track (m).
    pub(in crate::run_page) cross_track_m: f64,
    /// Lowest and highest speed over ground (m/s).
    pub(in crate::run_page) speeds_mps: [f64; 2],
}

impl PlanTrace {
    pub(super) fn new(plan: &PassagePlan, vessel: &VesselSetup) -> PlanTrace {
        PlanTrace {
            ship: vessel.clone(),
            cross_track_m: Decimator::new(),
            speed_mps: Decimator::new(),
            under_keel_m: Default::default(),
            legs: vec![LegTrace::default(); plan.legs().len()],
            farthest_m: f64::NEG_INFINITY,
        }
    }

    /// Adds a step that began at `t_s`, with the state of the vessel, her squat (m) and the depths under her.
    pub(super) fn push(
        &mut self,
        t_s: f64,
        state: &BodyState,
        squat_m: f64,
        soundings: &Soundings,
    ) {
        let Some(on) = self.ship.on_plan(state) else { return };
        let clearances_m = self.ship.clearances_m(squat_m, soundings);
        let speed_mps = state.velocity_mps.length();
        // Before the first waypoint and after the last one the vessel is on no leg: at the berth the plan is over.
        if !on.is_on_leg() {
            return;
        }
        if on.along_m > self.farthest_m {
            self.farthest_m = on.along_m;
            self.cross_track_m.push(on.along_m, on.cross_track_m);
            self.speed_mps.push(on.along_m, speed_mps);
            for (trace, clearance_m) in self.under_keel_m.iter_mut().zip(clearances_m) {
                if let Some(clearance_m) = clearance_m {
                    trace.push(on.along_m, clearance_m);
                }
            }
        }
        let leg = &mut self.legs[on.leg];
        match &mut leg.times_s {
            Some([_, last_s]) => *last_s = t_s,
            None => {
                leg.times_s = Some([t_s; 2]);
                leg.speeds_mps = [speed_mps; 2];
            }
        }
        leg.speeds_mps[0] = lesser(leg.speeds_mps[0], speed_mps);
        leg.speeds_mps[1] = greater(leg.speeds_mps[1], speed_mps);
        if on.cross_track_m.abs() > leg.cross_track_m.abs() {
            leg.cross_track_m = on.cross_track_m;
        }
    }
}
