//! Buffers and results of a step of the engine.

use alloc::vec::Vec;

use crate::broad::bodies::{Bodies, Displaced};
use crate::broad::candidates::Candidates;
use crate::coupled::contact_stage::Constraints;
use crate::coupled::dynamics::Dynamics;
use crate::coupled::island::{Group, Islands};
use crate::coupled::peaks;
use crate::coupled::sub_steps::Kept;
use crate::geometry::clip::ClipBuffers;
use crate::inherit::Inheritance;
use crate::maths::room::{expected_contacts, most_corners};
use crate::model::Model;
use crate::model::pile::PileMotion;
use crate::overlap::lenses::Overlap;
use crate::panel::report::PanelMotion;
use crate::state::body_state::BodyState;
use crate::state::memory::ContactMemory;
use crate::state::report::{Contact, Displacement, Event, Wrench};
use crate::state::results::Results;

/// Buffers that a step writes to, and the results of the step. The next step does not depend on a workspace: it can be
/// shared between runs, of one model or of several, or dropped at any time.
///
/// The parts of the workspace are in the order in which a step computes them. Each stage of a step takes the parts that
/// it reads or writes.
#[derive(Clone, Debug)]
pub struct Workspace {
    /// Stage 1: input states and poses of the bodies.
    pub(crate) bodies: Bodies,
    /// Stage 1: bodies that the host displaced.
    pub(crate) displaced: Displaced,
    /// Stage 1 of the coupled method, and its sub-steps: velocities and masses.
    pub(crate) dynamics: Dynamics,
    /// Stage 2: pairs of bodies that are near each other.
    pub(crate) candidates: Candidates,
    /// The coupled method: the islands, which are groups of candidates that must be solved together.
    pub(crate) islands: Islands,
    /// Stage 3: patches of contact, and the buffers of the clip.
    pub(crate) overlap: Overlap,
    pub(crate) clip: ClipBuffers,
    /// Stage 3: what the patches of contact inherit from the last step.
    pub(crate) inheritance: Inheritance,
    /// Stages 4 and 5 of the coupled method: the contact laws and the solve.
    pub(crate) constraints: Constraints,
    /// The coupled method: the islands that go through their sub-steps at present.
    pub(crate) group: Group,
    /// The coupled method: buffers that are kept between sub-steps.
    pub(crate) kept: Kept,
    /// The coupled method: the memory that the last step left for an island, collected here if its parts lie apart in
    /// the list of all memories.
    pub(crate) gathered: ContactMemory,
    /// The memory that this step makes for the next step.
    pub(crate) next_memory: ContactMemory,
    /// Stage 6: what the step reports.
    pub(crate) results: Results,
}

impl Workspace {
    /// Buffers for a model. Lists of the bodies of the model are made at once. If many contacts are expected (one per
    /// floating body and one per fender), the lists of contacts are made too, so that the first step does not wait for
    /// memory.
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

    /// Resets the results to those before the first step. The buffers are kept.
    pub fn forget_results(&mut self) {
        self.results.forget();
    }

    /// States of the bodies at the end of the last step by [`crate::advance`], one per body. A host that lets the
    /// engine move its bodies passes these states to the next step. Empty after [`crate::advance_in_place`]. The
    /// velocities in these states belong to the middle of the last sub-step.
    #[must_use]
    pub fn states_after(&self) -> &[BodyState] {
        &self.results.states_after
    }

    /// Displacement of each body in the last step by [`crate::advance`]: the work of a load on the body is the load
    /// times this displacement.
    #[must_use]
    pub fn displacements(&self) -> &[Displacement] {
        &self.results.displacements
    }

    /// Sets whether steps report their contacts one by one in [`Workspace::contacts`]. By default they do. Without the
    /// report of contacts a step is somewhat faster. Wrenches, states, displacements, events and memory have the same
    /// bits with and without the report.
    pub fn report_contacts(&mut self, report: bool) {
        self.results.reports_contacts = report;
    }

    /// Contacts of the last step, sorted by the keys of the bodies and by patch. The list of contacts is empty if
    /// contacts are not reported.
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        &self.results.contacts
    }

    /// The fender panels on which hulls pressed in the last step, one entry per panel and hull.
    #[must_use]
    pub fn panels(&self) -> &[PanelMotion] {
        &self.results.panels
    }

    /// Motion of the piles in the last step, in the order of the keys of the bodies on the piles.
    #[must_use]
    pub fn piles(&self) -> &[PileMotion] {
        &self.results.piles
    }

    /// Sum of the contact forces on each body, one sum per body: the mean over the last step. Use this sum to move the
    /// bodies. For the greatest sum within the step see [`Workspace::peak_wrenches_into`].
    #[must_use]
    pub fn wrenches(&self) -> &[Wrench] {
        &self.results.wrenches
    }

    /// Writes a list with the greatest sum of the contact forces on each body within the last step: the wrench of the
    /// sub-step in which the force was greatest. In the paper's method, and if the step was one sub-step, this list is
    /// the same as [`Workspace::wrenches`].
    ///
    /// Use these wrenches to size fenders and structures, not to move bodies: a force that falls off within a long step
    /// is this large only for a part of the step. Several floating bodies that do not touch each other may touch one
    /// fixed body. The wrench on a fixed body that several floating bodies touch is computed as if their greatest
    /// forces acted at the same time.
    pub fn peak_wrenches_into(&self, into: &mut Vec<Wrench>) {
        peaks::write(&self.results.peaks, &self.results.wrenches, into);
    }

    /// Events of the last step.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.results.events
    }
}
