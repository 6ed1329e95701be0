//! Buffers and results of a step.

use alloc::vec::Vec;

use crate::bodies::{Bodies, Displaced};
use crate::candidates::Candidates;
use crate::coupled::contact_stage::Constraints;
use crate::coupled::dynamics::Dynamics;
use crate::coupled::island::{Group, IslandMemory, Islands};
use crate::coupled::peaks;
use crate::coupled::sub_steps::Kept;
use crate::geometry::clip::ClipBuffers;
use crate::inherit::Inheritance;
use crate::model::Model;
use crate::next_memory::NextMemory;
use crate::overlap::Overlap;
use crate::report::{Contact, Event, Motion, Wrench};
use crate::results::Results;
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
    pub(crate) gathered: IslandMemory,
    /// The memory of the next step.
    pub(crate) next_memory: NextMemory,
    /// Stage 6: what the step reports.
    pub(crate) results: Results,
}

impl Workspace {
    /// Buffers for a model.
    #[must_use]
    pub fn new(model: &Model) -> Workspace {
        let count = model.bodies().len();
        Workspace {
            bodies: Bodies::with_capacity(count),
            displaced: Displaced::default(),
            dynamics: Dynamics::default(),
            candidates: Candidates::default(),
            islands: Islands::default(),
            overlap: Overlap::default(),
            clip: ClipBuffers::default(),
            inheritance: Inheritance::default(),
            constraints: Constraints::default(),
            group: Group::default(),
            kept: Kept::default(),
            gathered: IslandMemory::default(),
            next_memory: NextMemory::default(),
            results: Results::new(count),
        }
    }

    /// States at the end of the last step by [`crate::advance`], one a body: what a host that lets
    /// the engine move its bodies goes on with. None after [`crate::advance_in_place`], which has moved them. Velocities
    /// are those of the middle of the last sub-step.
    #[must_use]
    pub fn states_after(&self) -> &[BodyState] {
        &self.results.states_after
    }

    /// How far each body went in the last step by [`crate::advance`], one a body: what a load works along.
    #[must_use]
    pub fn motions(&self) -> &[Motion] {
        &self.results.motions
    }

    /// Whether steps report their contacts one by one in [`Workspace::contacts`], as they do if not told
    /// otherwise. Wrenches, states, motions, events and what is remembered are the same to the bit without, and
    /// come somewhat sooner.
    pub fn tell_contacts(&mut self, told: bool) {
        self.results.reports_contacts = told;
    }

    /// Contacts of the last step, sorted by the bodies' keys and patch; none where they are not told of.
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        &self.results.contacts
    }

    /// Sum of the contact forces on each body in the last step, one a body: means over the step, by which bodies are
    /// moved. [`Workspace::tell_peaks`] has what was there at the worst moment.
    #[must_use]
    pub fn wrenches(&self) -> &[Wrench] {
        &self.results.wrenches
    }

    /// Writes the greatest sum of the contact forces on each body within the last step into a list, one a body: of its
    /// sub-steps the wrench of that in which the force was greatest; by the paper's method, and where the step was one
    /// sub-step, [`Workspace::wrenches`]. Size fenders and structures by it, but move no body: a force that falls off
    /// within a long step is this large for a part of it. Of a fixed body that floating ones touch which do not touch
    /// each other, what it is where they are greatest at one time.
    pub fn tell_peaks(&self, into: &mut Vec<Wrench>) {
        peaks::write(&self.results.peaks, &self.results.wrenches, into);
    }

    /// Events of the last step.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.results.events
    }
}
