//! Buffers and results of a step.

use alloc::vec::Vec;

use crate::bodies::{Bodies, Displaced};
use crate::candidates::Candidates;
use crate::coupled::contact_stage::Constraints;
use crate::coupled::dynamics::Dynamics;
use crate::coupled::island::{Group, Islands};
use crate::coupled::peaks;
use crate::coupled::sub_steps::Kept;
use crate::geometry::clip::ClipBuffers;
use crate::inherit::Inheritance;
use crate::lenses::Overlap;
use crate::memory::ContactMemory;
use crate::model::Model;
use crate::panel::report::PanelMotion;
use crate::pile::PileMotion;
use crate::report::{Contact, Displacement, Event, Wrench};
use crate::results::Results;
use crate::room::{expected_contacts, most_corners};
use crate::state::BodyState;

/// Buffers that a step writes to, and its results. Nothing in it matters to the next step: it can be shared between runs,
/// of one model or of several, or dropped at any time.
///
/// Its parts are in the order in which a step computes them. Each stage takes the parts that it reads or writes.
#[derive(Clone, Debug)]
pub struct Workspace {
    /// Stage 1: input states and poses.
    pub(crate) bodies: Bodies,
    /// Stage 1: bodies that the host displaced.
    pub(crate) displaced: Displaced,
    /// Stage 1 of the coupled method, and its sub-steps: velocities and masses.
    pub(crate) dynamics: Dynamics,
    /// Stage 2: pairs that are near each other.
    pub(crate) candidates: Candidates,
    /// The coupled method: islands of candidates.
    pub(crate) islands: Islands,
    /// Stage 3: patches of contact, and the clip's buffers.
    pub(crate) overlap: Overlap,
    pub(crate) clip: ClipBuffers,
    /// Stage 3: what patches inherit from the last step.
    pub(crate) inheritance: Inheritance,
    /// Stages 4 and 5 of the coupled method: laws and solve.
    pub(crate) constraints: Constraints,
    /// The coupled method: the islands that are in their sub-steps.
    pub(crate) group: Group,
    /// The coupled method: what is kept between sub-steps.
    pub(crate) kept: Kept,
    /// The coupled method: what the last step left of an island, if that is not contiguous in the memory.
    pub(crate) gathered: ContactMemory,
    /// The memory of the next step.
    pub(crate) next_memory: ContactMemory,
    /// Stage 6: what the step reports.
    pub(crate) results: Results,
}

impl Workspace {
    /// Buffers for a model. Lists of its bodies are made at once, and where these are many those of contacts too, one a floating
    /// body and one a fender, so that the first step does not wait for their memory.
    #[must_use]
    pub fn new(model: &Model) -> Workspace {
        let (count, contacts) = (model.bodies().len(), expected_contacts(model));
        let mut bodies = Bodies::with_capacity(count);
        bodies.resize(count);
        Workspace {
            bodies,
            displaced: Displaced::default(),
            dynamics: Dynamics::new(model),
            candidates: Candidates::with_room(model, contacts),
            islands: Islands::with_room(contacts),
            overlap: Overlap::with_room(contacts),
            clip: ClipBuffers::with_room(most_corners(model)),
            inheritance: Inheritance::with_room(contacts),
            constraints: Constraints::with_room(contacts, count),
            group: Group::with_room(count),
            kept: Kept::with_room(contacts),
            gathered: ContactMemory::default(),
            next_memory: ContactMemory::with_room(contacts),
            results: Results::new(count, contacts),
        }
    }

    /// Becomes a workspace whose results are those before the first step, and keeps its buffers.
    pub fn forget_results(&mut self) {
        self.results.forget();
    }

    /// States at the end of the last step by [`crate::advance`], one a body. A host that lets the engine move its bodies
    /// takes these as its next input. Empty after [`crate::advance_in_place`]. Velocities belong to the middle of the last
    /// sub-step.
    #[must_use]
    pub fn states_after(&self) -> &[BodyState] {
        &self.results.states_after
    }

    /// Displacement of each body in the last step by [`crate::advance`], one a body: what a load does work along.
    #[must_use]
    pub fn displacements(&self) -> &[Displacement] {
        &self.results.displacements
    }

    /// Whether steps report their contacts one by one in [`Workspace::contacts`]; they do by default. Without, a step is
    /// somewhat faster. Wrenches, states, displacements, events and memory are the same to the bit either way.
    pub fn report_contacts(&mut self, report: bool) {
        self.results.reports_contacts = report;
    }

    /// Contacts of the last step, sorted by the bodies' keys and patch. Empty if they are not reported.
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        &self.results.contacts
    }

    /// The panels that hulls pressed in the last step, one entry a panel and hull.
    #[must_use]
    pub fn panels(&self) -> &[PanelMotion] {
        &self.results.panels
    }

    /// What the piles of bodies did in the last step, in the order of these bodies' keys.
    #[must_use]
    pub fn piles(&self) -> &[PileMotion] {
        &self.results.piles
    }

    /// Sum of the contact forces on each body, one a body: the mean over the last step, by which bodies are moved. See
    /// [`Workspace::peak_wrenches_into`] for the greatest within it.
    #[must_use]
    pub fn wrenches(&self) -> &[Wrench] {
        &self.results.wrenches
    }

    /// Writes the greatest sum of the contact forces on each body within the last step into a list, one a body: the wrench
    /// of the sub-step in which the force was greatest. By the paper's method, and if the step was one sub-step, that is
    /// [`Workspace::wrenches`].
    ///
    /// Use it to size fenders and structures, not to move bodies: a force that falls off within a long step is this large
    /// for a part of it only. On a fixed body that several floating bodies touch, which do not touch each other, it is the
    /// wrench as if their greatest forces acted at one time.
    pub fn peak_wrenches_into(&self, into: &mut Vec<Wrench>) {
        peaks::write(&self.results.peaks, &self.results.wrenches, into);
    }

    /// Events of the last step.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.results.events
    }
}
