//! The energy ledger of a run: kinetic energy, work of the loads, and where the contacts' energy went.

use fenderline_contact::BodyState;
use fenderline_contact::number::greater;

use crate::contact_totals::ContactTotals;
use crate::dolphin::DolphinMotion;
use crate::record::{Energy, LoadWork};
use crate::rigid_body::Inertia;

/// Inertias and states of all bodies, and the order in which their energies are summed.
#[derive(Clone, Copy)]
pub(crate) struct Bodies<'a> {
    pub(crate) order: &'a [usize],
    pub(crate) inertias: &'a [Inertia],
    pub(crate) states: &'a [BodyState],
}

impl Bodies<'_> {
    fn kinetic_j(self) -> f64 {
        self.order.iter().map(|&body| self.inertias[body].kinetic_j(&self.states[body])).sum()
    }
}

/// The energy ledger, updated in each step.
#[derive(Clone, Debug)]
pub(crate) struct Ledger {
    start_j: f64,
    pub(crate) energy: Energy,
}

impl Ledger {
    pub(crate) fn new(bodies: Bodies<'_>) -> Ledger {
        let kinetic_j = bodies.kinetic_j();
        Ledger { start_j: kinetic_j, energy: Energy { kinetic_j, ..Energy::default() } }
    }

    /// Adds one step: the bodies after it, the works of the loads and of the contacts in it.
    pub(crate) fn add(
        &mut self,
        bodies: Bodies<'_>,
        loads: &LoadWork,
        contacts: &ContactTotals,
        dolphins: &[DolphinMotion],
    ) {
        let energy = &mut self.energy;
        energy.kinetic_j = bodies.kinetic_j();
        energy.loads.add(loads);
        energy.load_work_j = energy.loads.total_j();
        energy.pile_stored_j = 0.0;
        for DolphinMotion { pile, .. } in dolphins {
            energy.pile_stored_j += pile.stored_j;
            energy.pile_damping_j += pile.damping_j;
            energy.pile_yield_j += pile.yield_j;
        }
        (energy.stored_j, energy.shear_stored_j) = (0.0, 0.0);
        energy.contact_gained_j = contacts.gained_j();
        for contact in &contacts.all {
            energy.contact_taken_j += greater(-(contact.normal_j + contact.tangential_j), 0.0);
            energy.normal_work_j += contact.normal_j;
            energy.height_work_j += contact.height_j;
            energy.tangential_work_j += contact.tangential_j;
            energy.stored_j += contact.stored_j;
            energy.shear_stored_j += contact.shear_stored_j;
            energy.hysteresis_j += contact.hysteresis_j;
            energy.damping_j += contact.damping_j;
            energy.restitution_j += contact.restitution_j;
            energy.friction_j += contact.friction_j;
            energy.contact_residual_j += contact.residual_j;
        }
        let work_j = energy.load_work_j + energy.normal_work_j + energy.tangential_work_j;
        energy.residual_j = energy.kinetic_j - self.start_j - work_j;
    }
}
