//! The motion of the bodies under given wrenches: integrators, and the Coriolis terms of a step.

use fenderline_contact::{self as contact, BodyState, Vec2, Wrench};

use super::Simulation;
use super::buffers::Buffers;
use crate::gather::gather;
use crate::integrate::{Rate, euler};
use fenderline_world::mean_velocity::MeanVelocity;
use fenderline_world::rigid_body::Inertia;
use fenderline_world::setup::{Integrator, Method};
use fenderline_world::turning::{TurningStep, YawRateAt, turning_wrench};

impl Simulation {
    /// Computes the wrench that turns each body's momentum with the body (Coriolis and centripetal terms). For vessels
    /// this wrench is a mean over the step; for other bodies it is the value at the start of the step.
    ///
    /// The contact forces of this step are not known yet, so the prediction of a vessel's motion uses the contact
    /// forces of the last step. Without the contact forces, a vessel at rest on her fenders would be expected to move
    /// through them.
    pub(super) fn turn_momentum(&mut self) {
        if self.engine_moves() && self.setup.world.vessels.is_empty() {
            return; // the engine turns that of plain bodies
        }
        let Buffers { loads, turning, .. } = &mut self.buffers;
        for ((wrench, inertia), state) in turning.iter_mut().zip(&self.inertias).zip(&self.states) {
            *wrench = inertia.momentum_wrench(state, Vec2::ZERO);
        }
        let step_s = self.setup.step_s;
        let step = match self.setup.integrator {
            Integrator::Euler => {
                Some(TurningStep { step_s, acts_s: step_s, turned_by: YawRateAt::Start })
            }
            // The engine's leapfrog starts with half a step for the velocities.
            Integrator::SemiImplicit if self.index == 0 => {
                Some(TurningStep { step_s, acts_s: 0.5 * step_s, turned_by: YawRateAt::End })
            }
            Integrator::SemiImplicit => {
                Some(TurningStep { step_s, acts_s: step_s, turned_by: YawRateAt::End })
            }
            // Each Runge–Kutta stage computes its own wrench.
            Integrator::Rk4 => None,
        };
        let contact = self.work.wrenches();
        for (vessel, water_inertia) in
            self.setup.world.vessels.iter().zip(&self.world.water_inertia)
        {
            let body = vessel.body;
            let (inertia, state) = (&self.inertias[body], &self.states[body]);
            let stream_mps = water_inertia.current_mps;
            turning[body] = match &step {
                Some(step) => {
                    let (load, contact) = (&loads[body], &contact[body]);
                    let acts = Wrench {
                        force_n: load.force_n + contact.force_n,
                        moment_nm: load.moment_nm + contact.moment_nm,
                    };
                    turning_wrench(inertia, state, &acts, stream_mps, step)
                }
                None => inertia.momentum_wrench(state, stream_mps),
            };
        }
    }

    /// Computes one step of an integrator with a single stage.
    pub(super) fn one_stage(&mut self, advance: fn(&BodyState, &Rate, f64) -> BodyState) {
        let Buffers { loads, turning, sums, .. } = &mut self.buffers;
        gather(loads, self.work.wrenches(), sums);
        for (sum, turning) in sums.iter_mut().zip(&*turning) {
            sum.force_n += turning.force_n;
            sum.moment_nm += turning.moment_nm;
        }
        for ((state, inertia), sum) in self.states.iter_mut().zip(&self.inertias).zip(&*sums) {
            *state = advance(state, &Rate::of(inertia, state, sum), self.setup.step_s);
        }
    }

    /// Computes one step of the classical Runge–Kutta method. In the method of Moreno et al. (2023) stages 2 to 4
    /// compute their contact forces on a copy of the contact memory. In the coupled method all stages use the mean
    /// contact wrench of the step.
    pub(super) fn runge_kutta(&mut self) -> Result<(), contact::StepError> {
        let step_s = self.setup.step_s;
        let buffers = &mut self.buffers;
        buffers.currents_mps.fill(Vec2::ZERO);
        for (vessel, water_inertia) in
            self.setup.world.vessels.iter().zip(&self.world.water_inertia)
        {
            buffers.currents_mps[vessel.body] = water_inertia.current_mps;
        }
        let bodies = InCurrent { inertias: &self.inertias, currents_mps: &buffers.currents_mps };
        let loads = &buffers.loads;
        bodies.rates(&self.states, loads, self.work.wrenches(), &mut buffers.rates[0]);
        for (stage, elapsed_s) in [(1, 0.5 * step_s), (2, 0.5 * step_s), (3, step_s)] {
            for (body, state) in self.states.iter().enumerate() {
                buffers.trial[body] = euler(state, &buffers.rates[stage - 1][body], elapsed_s);
            }
            let rates = &mut buffers.rates[stage];
            if self.setup.method == Method::Coupled {
                bodies.rates(&buffers.trial, loads, self.work.wrenches(), rates);
                continue;
            }
            buffers.stage_memory.copy_from(&self.memory);
            buffers.stage_memory.set_elapsed(elapsed_s);
            let (memory, work) = (&mut buffers.stage_memory, &mut buffers.stage_work);
            contact::step(&self.model, memory, work, &buffers.trial, step_s)?;
            bodies.rates(&buffers.trial, loads, work.wrenches(), rates);
            buffers.stage_contacts[stage - 1].clear();
            buffers.stage_contacts[stage - 1].extend_from_slice(work.contacts());
        }
        let [one, two, three, four] = &buffers.rates;
        for (body, state) in self.states.iter_mut().enumerate() {
            let mean = one[body].runge_kutta(two[body], three[body], four[body]);
            *state = euler(state, &mean, step_s);
            buffers.mean[body] = MeanVelocity::moved(mean.motion());
        }
        Ok(())
    }
}

/// Lists the bodies, and the current at each body.
struct InCurrent<'a> {
    inertias: &'a [Inertia],
    currents_mps: &'a [Vec2],
}

impl InCurrent<'_> {
    /// Computes the rates of change of `states` under loads and contact wrenches.
    fn rates(&self, states: &[BodyState], loads: &[Wrench], contact: &[Wrench], into: &mut [Rate]) {
        for (body, rate) in into.iter_mut().enumerate() {
            let (inertia, state) = (&self.inertias[body], &states[body]);
            let turning = inertia.momentum_wrench(state, self.currents_mps[body]);
            let sum = Wrench {
                force_n: loads[body].force_n + contact[body].force_n + turning.force_n,
                moment_nm: loads[body].moment_nm + contact[body].moment_nm + turning.moment_nm,
            };
            *rate = Rate::of(inertia, state, &sum);
        }
    }
}
