//! Totals of a vessel over a run.

use fenderline_contact::BodyState;
use fenderline_sim::VesselState;
use fenderline_sim::hydro::{Force, Velocity};
use fenderline_sim::overhead::AirClearance;
use fenderline_sim::track::OnPlan;

use super::{Lasting, Peak};

/// Totals of one vessel.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct VesselTotals {
    /// Largest speed over ground (m/s).
    pub over_ground_mps: Peak,
    /// Largest speed through the water at midship (m/s).
    pub through_water_mps: Peak,
    /// Largest rate of turn, positive to starboard (rad/s).
    pub rate_of_turn_radps: Peak,
    /// Largest rudder angle; a positive angle turns the ship to starboard (rad).
    pub rudder_rad: Peak,
    /// Largest roll with wave motion, positive to starboard (rad).
    pub roll_rad: Peak,
    /// Largest heel, which is the roll without first-order wave motion (rad).
    pub heel_rad: Peak,
    /// Largest pitch with wave motion, positive bow up (rad).
    pub pitch_rad: Peak,
    /// Largest squat (m).
    pub squat_m: Peak,
    /// Minimum under-keel clearance, squat included (m); `None` in deep water.
    pub under_keel_m: Option<Peak>,
    /// Largest cross-track distance from the vessel's passage plan between the first and the last waypoint, positive to
    /// starboard of the track (m); `None` if the vessel was on no leg of a plan.
    pub cross_track_m: Option<Peak>,
    /// Least clearance under a bridge or cable (m), and its index in
    /// [`fenderline_sim::overhead::OverheadSetup::structures`]; `None` if the vessel passed under none, or if her air
    /// draught is not known.
    pub air_clearance_m: Option<(Peak, usize)>,
    /// Largest surge force, sway force and yaw moment by the flow around passing ships and other vessels (N, N, N·m).
    pub passing: [Peak; 3],
    /// Time for which the vessel was aground.
    pub aground: Lasting,
}

impl VesselTotals {
    pub(super) fn add_passing(&mut self, t_s: f64, force: &Force) {
        let parts = [force.surge_n, force.sway_n, force.yaw_nm];
        for (peak, part) in self.passing.iter_mut().zip(parts) {
            peak.raise(part, t_s);
        }
    }

    pub(super) fn add_place(&mut self, t_s: f64, on_plan: Option<OnPlan>) {
        if let Some(on) = on_plan.filter(OnPlan::is_on_leg) {
            let first = Peak { value: on.cross_track_m, at_s: t_s };
            self.cross_track_m.get_or_insert(first).raise(on.cross_track_m, t_s);
        }
    }

    pub(super) fn add_overhead(&mut self, t_s: f64, now: &AirClearance) {
        let value = now.clearance_m;
        if self.air_clearance_m.is_none_or(|(least, _)| value < least.value) {
            self.air_clearance_m = Some((Peak { value, at_s: t_s }, now.structure));
        }
    }

    pub(super) fn add(
        &mut self,
        t_s: f64,
        step_s: f64,
        state: &BodyState,
        water: &Velocity,
        now: &VesselState,
    ) {
        self.over_ground_mps.raise(state.velocity_mps.length(), t_s);
        self.through_water_mps.raise(water.speed_mps(), t_s);
        self.rate_of_turn_radps.raise(state.yaw_rate_radps, t_s);
        self.rudder_rad.raise(now.rudder.value, t_s);
        // Attitude belongs to the end of the step.
        let end_s = t_s + step_s;
        let [_, _, _, wave_roll_rad, wave_pitch_rad, _] = now.wave_motion.motion;
        self.heel_rad.raise(now.attitude.roll.value, end_s);
        self.roll_rad.raise(now.attitude.roll.value + wave_roll_rad, end_s);
        self.pitch_rad.raise(now.attitude.pitch.value + wave_pitch_rad, end_s);
        self.squat_m.raise(now.squat_m, t_s);
        if let Some(value) = now.under_keel_m
            && self.under_keel_m.is_none_or(|least| value < least.value)
        {
            self.under_keel_m = Some(Peak { value, at_s: t_s });
        }
        self.aground.count(now.aground, step_s);
    }
}
