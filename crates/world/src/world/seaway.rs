//! Motion of the vessels with hydrodynamic data in six degrees of freedom, before and after the engine's step.

use std::sync::Arc;

use fenderline_contact::{BodyState, Rotation, Vec2, Wrench, vec2};

use super::afloat::{Afloat, Lever};
use super::environment::Environment;
use super::seaway_state::SeawayState;
use super::vessel::{VesselForces, VesselSetup, VesselState};
use fenderline_seakeeping::{
    DriftSource, Motion, SlowPlace, StepLoad, SubSteps, WaveForces, WaveLoad,
};
use fenderline_ship::attitude::AttitudeLoad;
use fenderline_ship::hydro::Force;

/// The constant data of a vessel with hydrodynamic data in a run.
#[derive(Clone, Debug)]
pub(super) struct Seaway {
    motion: Arc<Motion>,
    waves: Option<Arc<WaveForces>>,
}

/// The times of a step of a vessel with hydrodynamic data.
#[derive(Clone, Copy)]
pub(super) struct SeawayTimes {
    /// Start of the step (s).
    pub(super) t_s: f64,
    /// The time for which the loads of the step act (s).
    pub(super) acts_s: f64,
    pub(super) sub_steps: SubSteps,
}

impl Seaway {
    /// The constant data of a vessel; `None` for a vessel without hydrodynamic data.
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

    /// The state of the vessel at the start of a run.
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

    /// The load on the vessel's body in a step. The given load has everything except waves, radiation and contact. Also
    /// writes the forces of the waves and of the water's reaction to the vessel's forces.
    pub(super) fn load(
        &self,
        own: (&VesselSetup, &mut VesselState, &mut VesselForces),
        body: &BodyState,
        given: &Given<'_>,
        stream_mps: Vec2,
        SeawayTimes { t_s, acts_s, sub_steps }: SeawayTimes,
    ) -> Wrench {
        let (vessel, vessel_state, forces) = own;
        let attitude = vessel_state.attitude;
        let Some(state) = &mut vessel_state.seaway else { return *given.load };
        (state.heading_rad, state.stream_mps, state.acts_s) =
            (body.heading_rad, stream_mps, acts_s);
        let waves = self.wave_load(state, t_s, sub_steps);
        let axes = Rotation::from_angle(body.heading_rad);
        let in_plane = axes.apply_inverse(given.load.force_n);
        let [drift_x, drift_y, drift_n] = waves.drift;
        let horizontal =
            [in_plane.x + drift_x, in_plane.y + drift_y, given.load.moment_nm + drift_n];
        // Drift acts at the waterline.
        let mut upright = given.upright;
        let gravity_m = vessel.float.map_or(0.0, |float| float.gravity_above_water_m);
        upright.add(drift_x, drift_y, attitude.heave.value - gravity_m);
        let [x, y, z, k, m, n] = waves.excitation;
        let force = [
            horizontal[0] + x,
            horizontal[1] + y,
            upright.heave_n + z,
            upright.roll_nm + k,
            upright.pitch_nm + m,
            horizontal[2] + given.moved_nm + n,
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

    /// Moves the vessel in heave, roll and pitch after the step, with the effects of contact.
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

/// Velocity of a body through the water, in axes with this heading: surge, sway and yaw.
fn own_velocity(body: &BodyState, heading_rad: f64, stream_mps: Vec2) -> [f64; 3] {
    let axes = Rotation::from_angle(heading_rad);
    let own = axes.apply_inverse(body.velocity_mps - stream_mps);
    [own.x, own.y, body.yaw_rate_radps]
}

/// The load on a ship with hydrodynamic data in six degrees of freedom, without waves, radiation and contact.
pub(super) struct Given<'l> {
    /// The load on surge, sway and yaw.
    pub(super) load: &'l Wrench,
    /// The load on heave, roll and pitch.
    pub(super) upright: AttitudeLoad,
    /// The yaw moment that forces have because heel and trim have moved the points at which they act (N·m).
    pub(super) moved_nm: f64,
}

impl Given<'_> {
    /// Adds forces of the ship that act above or below the ship's centre of gravity, at points that turn with the ship.
    /// The moments of these forces in the upright position are already in the load on surge, sway and yaw.
    pub(super) fn add_own(&mut self, afloat: &Afloat, forces: impl Iterator<Item = (Force, f64)>) {
        for (Force { surge_n, sway_n, .. }, above_gravity_m) in forces {
            self.upright.add(surge_n, sway_n, above_gravity_m);
            self.moved_nm += (afloat.lean() * above_gravity_m).cross(vec2(surge_n, sway_n));
        }
    }

    /// Adds a force north, east and up (N). The yaw moment of this force is already in the load.
    pub(super) fn add_force(&mut self, heading_rad: f64, lever: Lever, force_n: [f64; 3]) {
        let [north_n, east_n, up_n] = force_n;
        let own = Rotation::from_angle(heading_rad).apply_inverse(vec2(north_n, east_n));
        self.upright.add(own.x, own.y, lever.above_gravity_m);
        self.upright.add_upward(up_n, lever.at_m);
    }

    /// Adds a force forward and to starboard (N) at a point of the ship that is at `at_m` when the ship is upright. The
    /// moment of this force in the upright position is already in the load.
    pub(super) fn add_at(&mut self, at_m: Vec2, lever: Lever, own_n: Vec2) {
        self.upright.add(own_n.x, own_n.y, lever.above_gravity_m);
        self.moved_nm += (lever.at_m - at_m).cross(own_n);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::world::HullMotion;

    const AFLOAT: Afloat = Afloat {
        motion: HullMotion { heave_m: 0.3, roll_rad: 2e-3, pitch_rad: -1e-3 },
        gravity_above_water_m: 3.0,
    };

    /// r turned by roll about the ship's axis, then by pitch, exactly: forward, to starboard, down.
    fn turned([x, y, z]: [f64; 3]) -> [f64; 3] {
        let HullMotion { roll_rad, pitch_rad, .. } = AFLOAT.motion;
        let (sr, cr) = (libm::sin(roll_rad), libm::cos(roll_rad));
        let (sp, cp) = (libm::sin(pitch_rad), libm::cos(pitch_rad));
        let (y, z) = (y * cr - z * sr, y * sr + z * cr);
        [x * cp + z * sp, y, z * cp - x * sp]
    }

    /// r × F: roll to starboard, pitch bow up, yaw to starboard.
    fn moment([x, y, z]: [f64; 3], [fx, fy, fz]: [f64; 3]) -> [f64; 3] {
        [y * fz - z * fy, z * fx - x * fz, x * fy - y * fx]
    }

    /// Lines and anchors, tugs, and the ship's own forces. Their moments about the centre of gravity are those at the
    /// point where each acts in the ship's present attitude, to the first order of the angles.
    #[test]
    fn every_force_acts_where_its_point_is_as_she_lies() {
        let load = Wrench::default();
        let fresh = || Given { load: &load, upright: AttitudeLoad::default(), moved_nm: 0.0 };
        let (at_m, above_water_m) = (vec2(40.0, -12.0), 9.0);
        let upright_m = [at_m.x, at_m.y, -(above_water_m - 3.0)];
        let lever = AFLOAT.lever(at_m, above_water_m);
        let own_n = vec2(3e5, -4e5);
        let of_yaw =
            |given: &Given<'_>| [given.upright.roll_nm, given.upright.pitch_nm, given.moved_nm];
        let check = |found: [f64; 3], wanted: [f64; 3], what: &str| {
            for (found, wanted) in found.into_iter().zip(wanted) {
                assert!((found - wanted).abs() < 1e-5 * 5e5 * 40.0, "{what}: {found} {wanted}");
            }
        };

        // A line or an anchor on a ship that heads east. The moment in yaw is in the load in the plane, with the same
        // lever.
        let mut line = fresh();
        line.add_force(core::f64::consts::FRAC_PI_2, lever, [4e5, 3e5, 1e5]);
        let mut found = of_yaw(&line);
        found[2] = lever.at_m.cross(own_n);
        check(found, moment(turned(upright_m), [3e5, -4e5, -1e5]), "a line");
        assert_eq!(line.upright.heave_n, -1e5);

        let mut tug = fresh();
        tug.add_at(at_m, lever, own_n);
        let mut found = of_yaw(&tug);
        found[2] += at_m.cross(own_n);
        check(found, moment(turned(upright_m), [3e5, -4e5, 0.0]), "a tug");

        let mut wind = fresh();
        let force = Force { surge_n: 3e5, sway_n: -4e5, yaw_nm: 0.0 };
        wind.add_own(&AFLOAT, core::iter::once((force, 15.0)));
        check(of_yaw(&wind), moment(turned([0.0, 0.0, -15.0]), [3e5, -4e5, 0.0]), "wind");
    }

    #[test]
    fn the_height_of_a_point_above_the_water_has_heave_and_its_lever_has_not() {
        let at_m = vec2(10.0, 8.0);
        let (_, height_m) = AFLOAT.place(at_m, 5.0);
        let lever = AFLOAT.lever(at_m, 5.0);
        assert!((lever.above_gravity_m - 2.0 - (10.0 * -1e-3 - 8.0 * 2e-3)).abs() < 1e-12);
        assert!((height_m - (lever.above_gravity_m + 3.0 - 0.3)).abs() < 1e-12);
    }
}
