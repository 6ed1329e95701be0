//! Computes works and energies of a step: the work of contacts and loads on the bodies.

use super::Simulation;
use crate::load_work::{LoadedStep, plain_work_j};
use fenderline_world::contact_totals::WorkSource;
use fenderline_world::mean_velocity::MeanVelocity;
use fenderline_world::record::LoadWork;
use fenderline_world::setup::{Integrator, Method};

/// Weights of the four stages of classical Runge–Kutta.
const RUNGE_KUTTA: [f64; 4] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0];

impl Simulation {
    /// Adds the works that contacts and loads do in the step to the energy ledger.
    pub(super) fn account_energy(&mut self) {
        self.find_mean_velocities();
        self.account_contacts();
        let (mean, plain) = (&self.buffers.mean, &self.buffers.plain_loads);
        let (order, step_s) = (&self.world.order.bodies, self.setup.step_s);
        let other_j = plain_work_j(order, &self.inertias, mean, plain, step_s);
        let works = LoadWork { other_j, ..self.works_of_world() };
        self.ledger.add(&works, &self.contact_totals, &self.dolphins.motions);
    }

    /// Computes the works of vessels, tugs, lines, anchors and piles in the step.
    fn works_of_world(&self) -> LoadWork {
        let (world, buffers) = (&self.setup.world, &self.buffers);
        if !world.changes() && self.dolphins.motions.is_empty() {
            return LoadWork::default();
        }
        let step = LoadedStep {
            inertias: &self.inertias,
            before: &buffers.before,
            after: &self.states,
            mean: &buffers.mean,
            world,
            forces: &self.world.forces,
            water_inertia: &self.world.water_inertia,
            tugs: &self.world.tugs,
            lines: &self.world.lines,
            anchors: &self.world.anchors,
            dolphins: &self.dolphins.motions,
            order: &self.world.order,
            step_s: self.setup.step_s,
        };
        step.works()
    }

    /// Returns true if the contact engine moves the bodies itself.
    pub(super) fn engine_moves(&self) -> bool {
        self.setup.method == Method::Coupled && self.setup.integrator == Integrator::SemiImplicit
    }

    /// Mean velocity of each body over the step, from which the works of all forces are computed.
    fn find_mean_velocities(&mut self) {
        let step_s = self.setup.step_s;
        if self.engine_moves() {
            for (mean, motion) in self.buffers.mean.iter_mut().zip(self.work.displacements()) {
                *mean = MeanVelocity::over(motion, step_s);
            }
            return;
        }
        if self.setup.method == Method::Coupled && self.setup.integrator == Integrator::Rk4 {
            // `runge_kutta` has set the mean velocities. With forces held over the step, work is force times
            // displacement.
            return;
        }
        let states = self.buffers.before.iter().zip(&self.states);
        for (mean, (before, after)) in self.buffers.mean.iter_mut().zip(states) {
            *mean = MeanVelocity::of(before, after);
        }
    }

    /// Computes the work and the energies of each contact in the step.
    fn account_contacts(&mut self) {
        let step_s = self.setup.step_s;
        let engine_moves = self.engine_moves();
        let (contacts, buffers) = (self.work.contacts(), &self.buffers);
        let totals = &mut self.contact_totals;
        totals.open(contacts, &self.sides.works);
        if engine_moves {
            totals.add(contacts, &buffers.mean, WorkSource::Engine);
        } else if self.setup.method == Method::Paper && self.setup.integrator == Integrator::Rk4 {
            let [one, later @ ..] = RUNGE_KUTTA;
            totals.add(contacts, &buffers.mean, WorkSource::MeanVelocity(one * step_s));
            for (contacts, weight) in buffers.stage_contacts.iter().zip(later) {
                totals.add(contacts, &buffers.mean, WorkSource::MeanVelocity(weight * step_s));
            }
        } else {
            totals.add(contacts, &buffers.mean, WorkSource::MeanVelocity(step_s));
        }
        totals.close();
    }
}
