//! Buffers and results of a step for a following host.

use alloc::vec::Vec;

use crate::host::cosim::Followed;
use crate::host::lead::Start;
use crate::material::BodyId;
use crate::model::Model;
use crate::report::{Contact, Event, EventKind, Wrench};
use crate::state::BodyState;
use crate::workspace::Workspace;

/// Buffers and results of [`crate::CoSimHost::step`] and [`crate::DirectHost::step`]; nothing in it matters to the next step.
#[derive(Clone, Debug)]
pub struct HostWorkspace {
    pub(super) engine: Workspace,
    /// Body by body what is to be remembered, if the step succeeds.
    pub(super) next: Vec<Followed>,
    /// The host's present in the step under way, and in the last good one.
    pub(super) present_now: Vec<BodyState>,
    pub(super) present: Vec<BodyState>,
    /// Where the engine begins, and how far that is from the host's present.
    pub(super) starts: Vec<BodyState>,
    pub(super) leads: Vec<Start>,
    /// Loads of the step under way, and of the last good one.
    pub(super) loads_now: Vec<Wrench>,
    pub(super) loads: Vec<Wrench>,
    pub(super) touching: Vec<bool>,
    /// What a memory said of its bodies' velocities before the step.
    pub(super) behind_s: Vec<f64>,
    /// Bodies that were found to answer otherwise than their masses say.
    pub(super) differ: Vec<BodyId>,
    pub(super) wrenches: Vec<Wrench>,
    pub(super) peaks: Vec<Wrench>,
}

impl HostWorkspace {
    /// Buffers for a model.
    #[must_use]
    pub fn new(model: &Model) -> HostWorkspace {
        let count = model.bodies().len();
        HostWorkspace {
            engine: Workspace::new(model),
            next: Vec::with_capacity(count),
            present_now: Vec::with_capacity(count),
            present: Vec::with_capacity(count),
            starts: Vec::with_capacity(count),
            leads: Vec::with_capacity(count),
            loads_now: Vec::with_capacity(count),
            loads: Vec::with_capacity(count),
            touching: Vec::with_capacity(count),
            behind_s: Vec::with_capacity(count),
            differ: Vec::new(),
            wrenches: Vec::with_capacity(count),
            peaks: Vec::with_capacity(count),
        }
    }

    /// The events of bodies with other masses.
    pub(super) fn tell_of_masses(&mut self) {
        for &body in &self.differ {
            self.engine
                .results
                .events
                .push(Event { bodies: [body, body], kind: EventKind::MassMismatch });
        }
    }

    /// Which bodies touched in the engine's last step.
    pub(super) fn find_touching(&mut self, model: &Model) {
        self.touching.clear();
        self.touching.resize(model.bodies().len(), false);
        for contact in self.engine.contacts() {
            self.touching[contact.body_1.0 as usize] = true;
            self.touching[contact.body_2.0 as usize] = true;
        }
    }

    /// The wrenches of the last step, one a body: what moves it.
    #[must_use]
    pub fn wrenches(&self) -> &[Wrench] {
        &self.wrenches
    }

    /// The greatest wrench of contact on each body within the last step, one a body, in the engine's motion: see
    /// [`Workspace::peak_wrenches_into`]. Size fenders by it, and move the body by [`HostWorkspace::wrenches`].
    #[must_use]
    pub fn peak_wrenches(&self) -> &[Wrench] {
        &self.peaks
    }

    /// No results yet, where there are none of so many bodies.
    pub(super) fn make_room_for_results(&mut self, bodies: usize) {
        for results in [&mut self.wrenches, &mut self.peaks] {
            if results.len() != bodies {
                results.clear();
                results.resize(bodies, Wrench::default());
            }
        }
    }

    /// The states that the last step took for the host's present, one a body: as the host will show
    /// them when they are old enough.
    #[must_use]
    pub fn estimated_states(&self) -> &[BodyState] {
        &self.present
    }

    /// The loads that the last step reckoned with, told or observed, one a body.
    #[must_use]
    pub fn loads(&self) -> &[Wrench] {
        &self.loads
    }

    /// States at the end of the last step of a [`crate::DirectHost`], as [`Workspace::states_after`].
    #[must_use]
    pub fn states_after(&self) -> &[BodyState] {
        self.engine.states_after()
    }

    /// Contacts of the engine's motion in the last step, as [`Workspace::contacts`].
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        self.engine.contacts()
    }

    /// Events of the last step, as [`Workspace::events`].
    #[must_use]
    pub fn events(&self) -> &[Event] {
        self.engine.events()
    }
}
