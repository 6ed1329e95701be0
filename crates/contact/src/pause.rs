//! Takes a step of 0 s, in which the host is paused.

use crate::admit::{admit, admit_loads};
use crate::error::StepError;
use crate::model::Model;
use crate::state::body_state::BodyState;
use crate::state::memory::Memory;
use crate::state::report::{ContactImpulse, ContactWork, Displacement, Wrench};
use crate::state::workspace::Workspace;

/// Takes a step of 0 s. A step of 0 s does not change the memory. In a step of 0 s wrenches and contacts stay those of
/// the last step; impulses, work, displacements and events are zero or empty; the states at the end are the input
/// states.
///
/// # Errors
/// Returns the same errors as a step of any other length.
pub(crate) fn pause(
    model: &Model,
    memory: &Memory,
    work: &mut Workspace,
    states: &[BodyState],
    loads: Option<&[Wrench]>,
) -> Result<(), StepError> {
    admit(model, memory, states, 0.0)?;
    if let Some(loads) = loads {
        admit_loads(model, states, loads)?;
    }
    let Workspace { results, dynamics, .. } = work;
    let count = model.bodies().len();
    if results.layout != Some(model.layout) {
        results.clear_forces(count);
        results.layout = Some(model.layout);
    }
    for contact in &mut results.contacts {
        contact.work = ContactWork::default();
        contact.impulse = ContactImpulse::default();
    }
    results.events.clear();
    results.displacements.clear();
    results.displacements.resize(count, Displacement::default());
    results.states_after.clear();
    results.states_after.extend_from_slice(states);
    // For settled bodies, the states at the end are kept from step to step. They are now overwritten, so the next step
    // must compute all bodies anew.
    dynamics.invalidate();
    Ok(())
}
