//! Computes the work of the loads on the bodies in a step, by kind of load.

use fenderline_contact::{BodyState, Rotation, Vec2, Wrench, vec2};

use fenderline_ship::hydro::Force;
use fenderline_world::dolphin::DolphinMotion;
use fenderline_world::fixed_order::SumOrder;
use fenderline_world::mean_velocity::MeanVelocity;
use fenderline_world::record::LoadWork;
use fenderline_world::rigid_body::Inertia;
use fenderline_world::world::{
    AnchorAtWork, Mooring, TugAtWork, VesselForces, WaterInertia, WorldSetup,
};

/// The forces and the motion of the bodies in one step.
pub(crate) struct LoadedStep<'a> {
    pub(crate) inertias: &'a [Inertia],
    /// States of the bodies at the start and at the end of the step.
    pub(crate) before: &'a [BodyState],
    pub(crate) after: &'a [BodyState],
    pub(crate) mean: &'a [MeanVelocity],
    pub(crate) world: &'a WorldSetup,
    pub(crate) forces: &'a [VesselForces],
    pub(crate) water_inertia: &'a [WaterInertia],
    pub(crate) tugs: &'a [TugAtWork],
    pub(crate) lines: &'a [Mooring],
    pub(crate) anchors: &'a [AnchorAtWork],
    pub(crate) dolphins: &'a [DolphinMotion],
    pub(crate) order: &'a SumOrder,
    pub(crate) step_s: f64,
}

/// Work that the loads of the set-up and of the host program do in a step (J). `order` is the order in which the bodies
/// are summed.
pub(crate) fn plain_work_j(
    order: &[usize],
    inertias: &[Inertia],
    mean: &[MeanVelocity],
    plain: &[Wrench],
    step_s: f64,
) -> f64 {
    let floating = order.iter().filter(|&&body| !inertias[body].fixed);
    floating.fold(0.0, |sum_j, &body| sum_j + mean[body].power_w(&plain[body]) * step_s)
}

impl LoadedStep<'_> {
    /// Work of each kind of load, except the loads of the set-up and of the host program: force times displacement over
    /// the ground.
    pub(crate) fn works(&self) -> LoadWork {
        let mut works = LoadWork::default();
        for &vessel in &self.order.vessels {
            self.vessel(vessel, self.world.vessels[vessel].body, &mut works);
        }
        for &tug in &self.order.tugs {
            let vessel = self.world.tugs[tug].vessel;
            works.tugs_j += self.of_force(vessel, self.attitude(vessel), self.tugs[tug].force);
        }
        for &line in &self.order.lines {
            let of = &self.world.lines[line];
            for (body, lever, force_n) in of.pulls(&self.lines[line], &self.world.bollards) {
                works.lines_j += self.of_line_end(body, lever.at_m, force_n);
            }
        }
        for &anchor in &self.order.anchors {
            let of = &self.world.anchors[anchor];
            let AnchorAtWork { load, lever, .. } = &self.anchors[anchor];
            let body = self.world.vessels[of.vessel].body;
            works.anchors_j += self.of_line_end(body, lever.at_m, load.on_ship_n);
        }
        works.piles_j += self.dolphins.iter().map(|dolphin| dolphin.pile.work_j).sum::<f64>();
        works
    }

    /// Adds the work of a vessel's own forces, and the work of the current on the vessel.
    fn vessel(&self, index: usize, body: usize, works: &mut LoadWork) {
        let (forces, water_inertia) = (&self.forces[index], &self.water_inertia[index]);
        let attitude = self.attitude(index);
        let of_force = |force: Force| self.of_force(index, attitude, force);
        // The hull coefficients contain the Munk moment and the centripetal terms of the added mass. They do no work
        // and are part of the turning momentum, so they are removed here.
        works.hull_j += of_force(forces.hull + water_inertia.coriolis);
        works.propeller_j += of_force(forces.propeller);
        works.rudder_j += of_force(forces.rudder);
        works.thrusters_j += of_force(forces.thrusters);
        works.wind_j += of_force(forces.wind);
        works.waves_j += of_force(forces.waves) + of_force(forces.excitation);
        works.radiation_j += of_force(forces.radiation);
        works.banks_j += of_force(forces.banks);
        works.passing_j += of_force(forces.passing);
        works.bottom_j += of_force(forces.bottom);
        let stream_j = |state: &BodyState| {
            let drifting = BodyState {
                velocity_mps: water_inertia.current_mps,
                yaw_rate_radps: 0.0,
                ..*state
            };
            self.inertias[body].kinetic_j(&drifting)
        };
        works.current_j += self.mean[body].power_w(&water_inertia.acceleration) * self.step_s
            + stream_j(&self.after[body])
            - stream_j(&self.before[body]);
    }

    /// The attitude of a vessel at the start of the step.
    fn attitude(&self, vessel: usize) -> Rotation {
        Rotation::from_angle(self.before[self.world.vessels[vessel].body].heading_rad)
    }

    /// Work of a force on a vessel in the step. The force on the vessel is given about midship.
    fn of_force(&self, vessel: usize, attitude: Rotation, force: Force) -> f64 {
        let vessel = &self.world.vessels[vessel];
        let forward_m = vessel.ship.particulars.centre_of_gravity_m;
        let wrench = Wrench {
            force_n: attitude.apply(vec2(force.surge_n, force.sway_n)),
            moment_nm: force.yaw_nm - forward_m * force.sway_n,
        };
        self.mean[vessel.body].power_w(&wrench) * self.step_s
    }

    /// Work of the force of a mooring line or an anchor chain on the body at one of its ends.
    fn of_line_end(&self, body: usize, at_m: Vec2, [north_n, east_n, _]: [f64; 3]) -> f64 {
        if self.inertias[body].fixed {
            return 0.0;
        }
        let arm_m = self.before[body].pose().rotation.apply(at_m);
        vec2(north_n, east_n).dot(self.mean[body].at(arm_m)) * self.step_s
    }
}
