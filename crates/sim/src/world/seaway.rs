//! Vessels with hydrodynamic data in a world: their motion in six degrees of freedom around the engine's step.

use std::sync::Arc;

use fenderline_contact::{BodyState, Rotation, Vec2, Wrench, vec2};

use super::environment::Environment;
use super::vessel::{HullMotion, VesselForces, VesselSetup, VesselState};
use crate::attitude::{Attitude, AttitudeLoad};
use crate::hydro::Force;
use crate::seakeeping::{
    DriftSource, Motion, MotionState, SlowPlace, StepLoad, SubSteps, WaveForces, WaveLoad,
};

/// What is constant in a run for a vessel with hydrodynamic data.
#[derive(Clone, Debug)]
pub(super) struct Seaway {
    motion: Arc<Motion>,
    waves: Option<Arc<WaveForces>>,
}

/// What one step leaves for the next: plain numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct SeawayState {
    motion: MotionState,
    place: SlowPlace,
    /// Heading at the start of the step (rad), the stream there (m/s), and how long forces act in it (s).
    heading_rad: f64,
    stream_mps: Vec2,
    acts_s: f64,
}

impl SeawayState {
    pub(super) fn copy_from(&mut self, other: &SeawayState) {
        self.motion.copy_from(&other.motion);
        let SeawayState { place, heading_rad, stream_mps, acts_s, .. } = *other;
        (self.place, self.heading_rad, self.stream_mps, self.acts_s) =
            (place, heading_rad, stream_mps, acts_s);
    }
}

impl Seaway {
    /// `None` for a vessel without hydrodynamic data.
    pub(super) fn new(
        vessel: &VesselSetup,
        motion: &Arc<Motion>,
        environment: &Environment,
        step_s: f64,
    ) -> Option<Seaway> {
        let ship = vessel.seakeeping.as_ref()?;
        let hull = &vessel.ship.particulars;
        let drift = match &vessel.drift {
            _ if ship.data.has_drift() => DriftSource::Data,
            Some(of) => DriftSource::Estimate(
                of,
                -hull.centre_of_gravity_m,
                environment.water_density_kgpm3,
            ),
            None => DriftSource::Absent,
        };
        let waves = environment.sea.as_ref();
        Some(Seaway {
            motion: Arc::clone(motion),
            waves: waves.map(|sea| Arc::new(WaveForces::new(&ship.data, sea, drift, step_s))),
        })
    }

    /// The state at the start of a run.
    pub(super) fn start(&self, body: &BodyState) -> SeawayState {
        let own = Rotation::from_angle(body.heading_rad).apply_inverse(body.velocity_mps);
        SeawayState {
            motion: self.motion.start([own.x, own.y, body.yaw_rate_radps]),
            place: SlowPlace::new(body),
            ..SeawayState::default()
        }
    }

    /// The forces of the waves at a time, for loads that act in sub-steps.
    fn wave_load(&self, state: &SeawayState, t_s: f64, sub_steps: SubSteps) -> WaveLoad {
        let SlowPlace { position_m, heading_rad, .. } = state.place;
        self.waves
            .as_ref()
            .map_or(WaveLoad::default(), |waves| waves.at(position_m, heading_rad, t_s, sub_steps))
    }

    /// The load on her body in a step. `load` is that of everything else but contact, and `upright` what acts on heave, roll
    /// and pitch. Writes the forces of the waves and of the water's answer.
    pub(super) fn load(
        &self,
        own: (&VesselSetup, &mut VesselState, &mut VesselForces),
        body: &BodyState,
        (load, upright, stream_mps): (&Wrench, &AttitudeLoad, Vec2),
        (t_s, acts_s, sub_steps): (f64, f64, SubSteps),
    ) -> Wrench {
        let (vessel, vessel_state, forces) = own;
        let attitude = vessel_state.attitude;
        let Some(state) = &mut vessel_state.seaway else { return *load };
        (state.heading_rad, state.stream_mps, state.acts_s) =
            (body.heading_rad, stream_mps, acts_s);
        let waves = self.wave_load(state, t_s, sub_steps);
        let axes = Rotation::from_angle(body.heading_rad);
        let given = axes.apply_inverse(load.force_n);
        let [drift_x, drift_y, drift_n] = waves.drift;
        let horizontal = [given.x + drift_x, given.y + drift_y, load.moment_nm + drift_n];
        // Drift acts at the waterline.
        let mut upright = *upright;
        let gravity_m = vessel.float.map_or(0.0, |float| float.gravity_above_water_m);
        upright.add(drift_x, drift_y, -gravity_m);
        let [x, y, z, k, m, n] = waves.excitation;
        let force = [
            horizontal[0] + x,
            horizontal[1] + y,
            upright.heave_n + z,
            upright.roll_nm + k,
            upright.pitch_nm + m,
            horizontal[2] + n,
        ];
        let velocity = own_velocity(body, state.heading_rad, stream_mps);
        let [surge_n, sway_n, yaw_nm] = self.motion.predict(
            &mut state.motion,
            &attitude,
            velocity,
            &StepLoad { force, acts_s },
        );
        let ahead_m = vessel.ship.particulars.centre_of_gravity_m;
        // Forces on vessels are about midship.
        let midship = |[surge_n, sway_n, yaw_nm]: [f64; 3]| Force {
            surge_n,
            sway_n,
            yaw_nm: yaw_nm + ahead_m * sway_n,
        };
        forces.waves = midship(waves.drift);
        forces.excitation = midship([x, y, n]);
        forces.radiation = midship([
            surge_n - horizontal[0] - x,
            sway_n - horizontal[1] - y,
            yaw_nm - horizontal[2] - n,
        ]);
        Wrench { force_n: axes.apply(vec2(surge_n, sway_n)), moment_nm: yaw_nm }
    }

    /// Moves her in heave, roll and pitch after the step, by what contact did.
    pub(super) fn settle(
        &self,
        vessel: &mut VesselState,
        body: &BodyState,
        contact: &AttitudeLoad,
        step_s: f64,
    ) {
        let Some(state) = &mut vessel.seaway else { return };
        let velocity = own_velocity(body, state.heading_rad, state.stream_mps);
        let acts_s = state.acts_s;
        self.motion.settle(&mut state.motion, &mut vessel.attitude, velocity, contact, acts_s);
        state.place.follow(body, step_s);
    }
}

/// Velocity through the water in axes with a heading: surge, sway, yaw.
fn own_velocity(body: &BodyState, heading_rad: f64, stream_mps: Vec2) -> [f64; 3] {
    let axes = Rotation::from_angle(heading_rad);
    let own = axes.apply_inverse(body.velocity_mps - stream_mps);
    [own.x, own.y, body.yaw_rate_radps]
}

/// How a body with hydrodynamic data is afloat: her motion, and the height of her centre of gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Afloat {
    motion: HullMotion,
    gravity_above_water_m: f64,
}

impl Afloat {
    /// That of a vessel with hydrodynamic data; `None` for others, whose lines do not feel heave, roll and pitch.
    pub(super) fn of(vessel: &VesselSetup, state: &VesselState) -> Option<Afloat> {
        vessel.seakeeping.as_ref()?;
        let Attitude { heave, roll, pitch } = state.attitude;
        Some(Afloat {
            motion: HullMotion {
                heave_m: heave.value,
                roll_rad: roll.value,
                pitch_rad: pitch.value,
            },
            gravity_above_water_m: vessel.float?.gravity_above_water_m,
        })
    }

    /// Where a point of the ship is: in her axes (m), and its height above the water (m).
    pub(crate) fn place(&self, at_m: Vec2, above_water_m: f64) -> (Vec2, f64) {
        let HullMotion { roll_rad, pitch_rad, .. } = self.motion;
        let above_m = above_water_m - self.gravity_above_water_m;
        let moved = at_m + vec2(-pitch_rad, roll_rad) * above_m;
        (moved, above_water_m - self.motion.sinkage_m(at_m))
    }
}

/// Adds the load of a line's force at a fairlead: north, east, up (N).
pub(super) fn add_line(
    load: &mut AttitudeLoad,
    heading_rad: f64,
    (at_m, above_gravity_m): (Vec2, f64),
    [north_n, east_n, up_n]: [f64; 3],
) {
    let own = Rotation::from_angle(heading_rad).apply_inverse(vec2(north_n, east_n));
    load.add(own.x, own.y, above_gravity_m);
    load.add_upward(up_n, at_m);
}
