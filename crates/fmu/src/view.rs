//! The results of a run from which an FMU's outputs are read.

use fenderline_contact::{BodyState, Contact, Wrench};
use fenderline_sim::Simulation;

use crate::axes::body_fixed;

/// The results of a run from which an FMU's outputs are read.
pub(crate) struct View<'a> {
    pub(crate) states: &'a [BodyState],
    /// Contact wrenches in earth-fixed axes, one on each body.
    pub(crate) wrenches: &'a [Wrench],
    /// The largest contact wrench on each body within the last step; empty for a simulation.
    pub(crate) peaks: &'a [Wrench],
    pub(crate) contacts: &'a [Contact],
    /// Whether wrenches are reported in the bodies' axes.
    pub(crate) body_fixed: bool,
    /// The running simulation; `None` for an engine.
    pub(crate) simulation: Option<&'a Simulation>,
}

impl View<'_> {
    pub(crate) fn wrench(&self, body: usize) -> Wrench {
        self.reported(self.wrenches, body)
    }

    pub(crate) fn peak(&self, body: usize) -> Wrench {
        self.reported(self.peaks, body)
    }

    pub(crate) fn reported(&self, wrenches: &[Wrench], body: usize) -> Wrench {
        let wrench = wrenches.get(body).copied().unwrap_or_default();
        if self.body_fixed {
            let force_n = body_fixed(&self.states[body], wrench.force_n);
            Wrench { force_n, ..wrench }
        } else {
            wrench
        }
    }

    pub(crate) fn own_velocity(&self, body: usize) -> fenderline_contact::Vec2 {
        body_fixed(&self.states[body], self.states[body].velocity_mps)
    }

    pub(crate) fn on_fender(&self, fender: usize) -> impl Iterator<Item = &Contact> {
        let is = move |c: &&Contact| c.fender.is_some_and(|id| id.0 as usize == fender);
        self.contacts.iter().filter(is)
    }

    /// Patches of two outlines.
    pub(crate) fn of_pair(&self, bodies: [usize; 2]) -> impl Iterator<Item = &Contact> {
        self.contacts.iter().filter(move |c| {
            let own = [c.body_1.0 as usize, c.body_2.0 as usize];
            c.fender.is_none() && (own == bodies || own == [bodies[1], bodies[0]])
        })
    }

    pub(crate) fn of_simulation(&self, read: impl Fn(&Simulation) -> f64) -> f64 {
        self.simulation.map_or(0.0, read)
    }
}
