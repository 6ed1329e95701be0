//! The memory of a co-simulation host for one body.

use crate::host::lead::Lead;
use crate::host::mass_check::Answers;
use crate::report::Wrench;
use crate::state::BodyState;

/// The memory of a co-simulation host for one body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct BodyRecord {
    /// The last input state.
    pub(super) input: BodyState,
    /// The last observed load.
    pub(super) observed: Wrench,
    /// The body's response to the wrenches, for the check of its mass.
    pub(super) answers: Answers,
    /// Whether the host has marked the body's next input state as a teleport.
    pub(super) placed: bool,
    /// How far the engine's motion is ahead of the host's because of a contact; `None` without a contact.
    pub(super) ahead: Option<Lead>,
}
