//! What each kind of load does to the bodies in a step.

use fenderline_contact::{BodyState, Rotation, Vec2, Wrench, vec2};

use crate::fixed_order::SumOrder;
use crate::hydro::Force;
use crate::ledger::MeanVelocity;
use crate::record::LoadWork;
use crate::rigid_body::Inertia;
use crate::world::{Carried, Mooring, TugAtWork, VesselForces, WorldSetup};

/// A step as the books of the loads need it.
pub(crate) struct LoadedStep<'a> {
    pub(crate) inertias: &'a [Inertia],
    /// States at its start and its end.
    pub(crate) before: &'a [BodyState],
    pub(crate) after: &'a [BodyState],
    pub(crate) mean: &'a [MeanVelocity],
    /// Plain loads, and what the host puts on the bodies.
    pub(crate) others: &'a [Wrench],
    pub(crate) world: &'a WorldSetup,
    pub(crate) forces: &'a [VesselForces],
    pub(crate) carried: &'a [Carried],
    pub(crate) tugs: &'a [TugAtWork],
    pub(crate) lines: &'a [Mooring],
    pub(crate) order: &'a SumOrder,
    pub(crate) step_s: f64,
}

impl LoadedStep<'_> {
    /// Force times way over the ground, load by load.
    pub(crate) fn works(&self) -> LoadWork {
        let mut works = LoadWork::default();
        for &body in self.order.bodies.iter().filter(|&&body| !self.inertias[body].fixed) {
            works.other_j += self.mean[body].power_w(&self.others[body]) * self.step_s;
        }
        for &vessel in &self.order.vessels {
            self.vessel(vessel, self.world.vessels[vessel].body, &mut works);
        }
        for &tug in &self.order.tugs {
            works.tugs_j += self.of_force(self.world.tugs[tug].vessel, self.tugs[tug].force);
        }
        for &line in &self.order.lines {
            for end in self.world.lines[line].ends_on(&self.lines[line]) {
                works.lines_j += self.of_line_end(end);
            }
        }
        works
    }

    fn vessel(&self, index: usize, body: usize, works: &mut LoadWork) {
        let (forces, carried) = (&self.forces[index], &self.carried[index]);
        // Munk's moment and the centripetal terms stand in a hull's coefficients; here they are taken out again, as
        // they belong to the momentum that turns with her.
        works.hull_j += self.of_force(index, forces.hull + carried.ideal);
        works.propeller_j += self.of_force(index, forces.propeller);
        works.rudder_j += self.of_force(index, forces.rudder);
        works.thrusters_j += self.of_force(index, forces.thrusters);
        works.wind_j += self.of_force(index, forces.wind);
        works.waves_j += self.of_force(index, forces.waves);
        works.banks_j += self.of_force(index, forces.banks);
        works.bottom_j += self.of_force(index, forces.bottom);
        let stream_j = |state: &BodyState| {
            let adrift =
                BodyState { velocity_mps: carried.stream_mps, yaw_rate_radps: 0.0, ..*state };
            self.inertias[body].kinetic_j(&adrift)
        };
        works.current_j += self.mean[body].power_w(&carried.along) * self.step_s
            + stream_j(&self.after[body])
            - stream_j(&self.before[body]);
    }

    /// Work of a force about midship of a vessel.
    fn of_force(&self, vessel: usize, force: Force) -> f64 {
        let vessel = &self.world.vessels[vessel];
        let rotation = Rotation::from_angle(self.before[vessel.body].heading_rad);
        let ahead_m = vessel.ship.particulars.centre_of_gravity_m;
        let wrench = Wrench {
            force_n: rotation.apply(vec2(force.surge_n, force.sway_n)),
            moment_nm: force.yaw_nm - ahead_m * force.sway_n,
        };
        self.mean[vessel.body].power_w(&wrench) * self.step_s
    }

    fn of_line_end(&self, (body, at_m, force_n): (usize, Vec2, Vec2)) -> f64 {
        if self.inertias[body].fixed {
            return 0.0;
        }
        let arm_m = self.before[body].pose().rotation.apply(at_m);
        force_n.dot(self.mean[body].at(arm_m)) * self.step_s
    }
}
