//! The energy ledger: where every joule of a step came from.

use fenderline_contact::{BodyState, Contact, Vec2, Wrench};

use crate::record::{Energy, PairWork};
use crate::rigid_body::Inertia;

/// Mean of the velocities before and after a step. A constant force times it is exactly the change
/// of kinetic energy: ½m(v₁² − v₀²) = m(v₁ − v₀)·½(v₀ + v₁).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct MeanVelocity {
    velocity_mps: Vec2,
    yaw_rate_radps: f64,
}

impl MeanVelocity {
    pub(crate) fn of(before: &BodyState, after: &BodyState) -> MeanVelocity {
        MeanVelocity {
            velocity_mps: (before.velocity_mps + after.velocity_mps) * 0.5,
            yaw_rate_radps: 0.5 * (before.yaw_rate_radps + after.yaw_rate_radps),
        }
    }

    fn at(&self, arm_m: Vec2) -> Vec2 {
        self.velocity_mps + arm_m.spun_by(self.yaw_rate_radps)
    }

    fn power_w(&self, wrench: &Wrench) -> f64 {
        wrench.force_n.dot(self.velocity_mps) + wrench.moment_nm * self.yaw_rate_radps
    }
}

/// Adds what `contacts` did in `seconds` to the work of their pairs.
pub(crate) fn add_contacts(
    works: &mut Vec<PairWork>,
    contacts: &[Contact],
    mean: &[MeanVelocity],
    seconds: f64,
) {
    for contact in contacts {
        let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
        let [one, two] = bodies.map(|body| mean[body]);
        let slip_mps = one.at(contact.arm_1_m) - two.at(contact.arm_2_m);
        let work = work_of(works, contact);
        let normal_n = contact.normal_force_n;
        work.normal_impulse_ns += normal_n * seconds;
        work.normal_j -= normal_n * contact.normal.dot(slip_mps) * seconds;
        work.tangential_j += contact.tangential_force_n * contact.tangent().dot(slip_mps) * seconds;
    }
}

/// The same for the coupled method's mean forces. Where the engine moved the bodies it knows the work
/// of each sub-step; where the host did, the mean forces act along the host's motion.
pub(crate) fn add_means(
    works: &mut Vec<PairWork>,
    contacts: &[Contact],
    mean: &[MeanVelocity],
    step_s: f64,
    engine_moved: bool,
) {
    if !engine_moved {
        add_contacts(works, contacts, mean, step_s);
        return;
    }
    for contact in contacts {
        let work = work_of(works, contact);
        work.normal_impulse_ns += contact.normal_force_n * step_s;
        work.normal_j += contact.normal_work_j;
        work.tangential_j += contact.tangential_work_j;
    }
}

/// The entry of a contact's pair.
fn work_of<'a>(works: &'a mut Vec<PairWork>, contact: &Contact) -> &'a mut PairWork {
    let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
    let index = works.iter().position(|w| w.bodies == bodies).unwrap_or_else(|| {
        works.push(PairWork { bodies, ..PairWork::default() });
        works.len() - 1
    });
    &mut works[index]
}

/// The ledger, step by step.
#[derive(Clone, Debug)]
pub(crate) struct Ledger {
    start_j: f64,
    pub(crate) energy: Energy,
}

impl Ledger {
    pub(crate) fn new(inertias: &[Inertia], states: &[BodyState]) -> Ledger {
        let kinetic_j = kinetic_j(inertias, states);
        Ledger { start_j: kinetic_j, energy: Energy { kinetic_j, ..Energy::default() } }
    }

    /// Books one step.
    pub(crate) fn book(
        &mut self,
        inertias: &[Inertia],
        after: &[BodyState],
        loads: &[Wrench],
        mean: &[MeanVelocity],
        works: &[PairWork],
        step_s: f64,
    ) {
        let energy = &mut self.energy;
        energy.kinetic_j = kinetic_j(inertias, after);
        for ((load, mean), inertia) in loads.iter().zip(mean).zip(inertias) {
            if !inertia.fixed {
                energy.load_work_j += mean.power_w(load) * step_s;
            }
        }
        for work in works {
            energy.normal_work_j += work.normal_j;
            energy.tangential_work_j += work.tangential_j;
        }
        let work_j = energy.load_work_j + energy.normal_work_j + energy.tangential_work_j;
        energy.residual_j = energy.kinetic_j - self.start_j - work_j;
    }
}

fn kinetic_j(inertias: &[Inertia], states: &[BodyState]) -> f64 {
    inertias.iter().zip(states).map(|(inertia, state)| inertia.kinetic_j(state)).sum()
}
