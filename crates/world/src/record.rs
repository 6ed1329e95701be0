//! The record of one time step.

use fenderline_contact::{BodyState, Contact, Event, PanelMotion, Wrench};

use crate::chain::ChainTension;
use crate::dolphin::DolphinMotion;
pub use crate::energy::{ContactEnergy, Energy, LoadWork, WorkCause};
use crate::hull::HullTouch;
use crate::ledger::{Bodies, Ledger};
use crate::world::{
    AnchorAtWork, Mooring, Soundings, TugAtWork, VesselForces, VesselState, WorldEvent,
};

/// The record of one step: the states before and after the step, and the forces that acted in the step.
#[derive(Clone, Copy, Debug)]
pub struct StepRecord<'a> {
    /// Number of the step; the first step is 0.
    pub index: u64,
    /// Time at the start of the step (s).
    pub t_s: f64,
    /// States at the start of the step, one per body, in the order of the set-up.
    pub states: &'a [BodyState],
    /// States at the end of the step, one per body, in the order of the set-up.
    pub states_after: &'a [BodyState],
    /// Contact patches at the start of the step, in a fixed order.
    pub contacts: &'a [Contact],
    /// Work and energy of each contact in this step: one entry per fender and hull, or per pair of outlines. Contacts
    /// that ended after the last step are included.
    pub contact_energies: &'a [ContactEnergy],
    /// For each contact, how the fender meets a hull with outlines at several heights; `None` for other contacts. The
    /// list is empty in a run without such hulls.
    pub hull_touches: &'a [Option<HullTouch>],
    /// Panels on several cones that hulls press in this step.
    pub panels: &'a [PanelMotion],
    /// Chains of the fenders that are touched in this step.
    pub chains: &'a [ChainTension],
    /// Contact wrenches (force and moment) of the step, one per body.
    pub wrenches: &'a [Wrench],
    /// Contact events of this step.
    pub events: &'a [Event],
    /// The energy ledger, and the bodies whose kinetic energy [`StepRecord::energy`] needs.
    pub ledger: (&'a Ledger, Bodies<'a>),
    /// Controls and attitude of the vessels at the end of the step, in the order of the set-up.
    pub vessels: &'a [VesselState],
    /// Forces on each vessel in this step, separate for each cause.
    pub vessel_forces: &'a [VesselForces],
    /// The depths under each vessel at the start of the step.
    pub soundings: &'a [Soundings],
    /// The tugs at the end of the step, in the order of the set-up.
    pub tugs: &'a [TugAtWork],
    /// The lines at the end of the step, in the order of the set-up.
    pub lines: &'a [Mooring],
    /// The anchors at the end of the step, in the order of the set-up.
    pub anchors: &'a [AnchorAtWork],
    /// Motion of the flexible dolphins, in the order of the set-up.
    pub dolphins: &'a [DolphinMotion],
    /// Events of vessels, tugs, lines and anchors in this step.
    pub world_events: &'a [WorldEvent],
}

impl StepRecord<'_> {
    /// The energy ledger at the end of the step.
    #[must_use]
    pub fn energy(&self) -> Energy {
        let (ledger, bodies) = self.ledger;
        ledger.energy(bodies)
    }
}
