//! The energy ledger of a run: kinetic energy, work of the loads, and the energies of contacts.

use fenderline_contact::BodyState;
use fenderline_contact::number::greater;

use crate::contact_totals::ContactTotals;
use crate::dolphin::DolphinMotion;
use crate::energy::{Energy, LoadWork};
use crate::rigid_body::Inertia;

/// Inertias and states of all bodies, and the order in which the energies of the bodies are summed.
#[derive(Clone, Copy, Debug)]
pub struct Bodies<'a> {
    /// Indices of the bodies in the order of summation.
    pub order: &'a [usize],
    /// Inertia of each body.
    pub inertias: &'a [Inertia],
    /// State of each body.
    pub states: &'a [BodyState],
}

impl Bodies<'_> {
    fn kinetic_j(self) -> f64 {
        self.order.iter().map(|&body| self.inertias[body].kinetic_j(&self.states[body])).sum()
    }
}

/// The energy ledger, updated in each step.
#[derive(Clone, Debug)]
pub struct Ledger {
    start_j: f64,
    /// Sums of the energies so far, without the values that [`Ledger::energy`] computes when it is called.
    sums: Energy,
}

impl Ledger {
    /// The ledger of a run that starts with the bodies `bodies`.
    pub fn new(bodies: Bodies<'_>) -> Ledger {
        Ledger { start_j: bodies.kinetic_j(), sums: Energy::default() }
    }

    /// The present values of the ledger. The argument `bodies` must be the bodies after the last step. The values are
    /// computed on request, because many runs ask for the ledger only at their end.
    pub fn energy(&self, bodies: Bodies<'_>) -> Energy {
        let (kinetic_j, load_work_j) = (bodies.kinetic_j(), self.sums.loads.total_j());
        let work_j = load_work_j + self.sums.normal_work_j + self.sums.tangential_work_j;
        // Before the first step both energies may be infinite, because a start may have a larger velocity than a step
        // accepts.
        let gained_j = if kinetic_j == self.start_j { 0.0 } else { kinetic_j - self.start_j };
        let residual_j = gained_j - work_j;
        Energy { kinetic_j, load_work_j, residual_j, ..self.sums }
    }

    /// The energy that contacts absorbed, and the energy that contacts returned beyond the energy absorbed (J).
    pub fn contacts_j(&self) -> [f64; 2] {
        [self.sums.contact_taken_j, self.sums.contact_gained_j]
    }

    /// Adds the work of the loads and of the contacts in one step.
    pub fn add(&mut self, loads: &LoadWork, contacts: &ContactTotals, dolphins: &[DolphinMotion]) {
        let energy = &mut self.sums;
        energy.loads.add(loads);
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
    }
}
