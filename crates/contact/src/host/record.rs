//! What a co-simulation host remembers about one body.

use crate::host::lead::Lead;
use crate::host::mass_check::Answers;
use crate::state::body_state::BodyState;
use crate::state::report::Wrench;

/// What a co-simulation host remembers about one body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct BodyRecord {
    /// The last input state.
    pub(super) input: BodyState,
    /// The last observed load.
    pub(super) observed: Wrench,
    /// The response of the body to the wrenches, for the check of the body's mass.
    pub(super) answers: Answers,
    /// True if the host has marked the next input state of the body as a teleport.
    pub(super) placed: bool,
    /// How far the engine's motion of the body is ahead of the host's motion because of a contact; `None` without a
    /// contact.
    pub(super) ahead: Option<Lead>,
}
