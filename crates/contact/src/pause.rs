//! A step of no length: a host that is paused goes on asking.

use crate::admit::{admit, admit_loads};
use crate::error::StepError;
use crate::memory::Memory;
use crate::model::Model;
use crate::report::{ContactImpulse, ContactWork, Displacement, Wrench};
use crate::state::BodyState;
use crate::workspace::Workspace;

/// Takes a step of no length, in which nothing goes on: `memory` need not change. The wrenches and contacts are
/// those of the last step, without impulse, work, motion and events; the states after it are those that are shown.
///
/// # Errors
/// As of any step.
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
    let count = model.bodies().len();
    if work.results_of != Some(model.layout) {
        work.contacts.clear();
        work.peaks.clear();
        work.wrenches.clear();
        work.wrenches.resize(count, Wrench::default());
        work.results_of = Some(model.layout);
    }
    for contact in &mut work.contacts {
        contact.work = ContactWork::default();
        contact.impulse = ContactImpulse::default();
    }
    work.events.clear();
    work.motions.clear();
    work.motions.resize(count, Displacement::default());
    work.states_after.clear();
    work.states_after.extend_from_slice(states);
    // What is known of bodies that stand goes by what the last step left of them.
    work.advanced = None;
    Ok(())
}
