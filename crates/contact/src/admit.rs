//! Stage 1 of a step, "admit": checks the host's input before anything changes.

use crate::error::StepError;
use crate::model::Model;
use crate::state::body_state::{BodyState, FURTHEST_M};
use crate::state::memory::Memory;
use crate::state::report::Wrench;

/// Largest velocities, heading, load and time step that a host may give (m/s, rad/s, rad, N, s). Larger velocities,
/// loads or time steps are a mistake of the host, and forces could overflow.
const FASTEST_MPS: f64 = 1e6;
const FASTEST_TURN_RADPS: f64 = 1e3;
const LARGEST_HEADING_RAD: f64 = 1e9;
const LARGEST_LOAD: f64 = 1e15;
pub(crate) const LONGEST_STEP_S: f64 = 1e6;
pub(crate) const SHORTEST_STEP_S: f64 = 1e-9;

/// Refuses a model that has bodies on piles.
///
/// # Errors
/// A model with a body on a pile fails with [`StepError::OnPile`], which names the first such body.
pub(crate) fn refuse_piles(model: &Model) -> Result<(), StepError> {
    match model.piles.first() {
        None => Ok(()),
        Some(pile) => {
            let body = &model.bodies()[model.id_of[pile.rank as usize].0 as usize];
            Err(StepError::OnPile { body: body.name.clone() })
        }
    }
}

/// Checks the host's input except the states of the bodies, for a caller that checks each state when it reads the
/// state.
pub(crate) fn admit_call(
    model: &Model,
    memory: &Memory,
    states: &[BodyState],
    step_s: f64,
) -> Result<(), StepError> {
    if memory.fingerprint != model.fingerprint {
        return Err(StepError::WrongModel);
    }
    if states.len() != model.bodies().len() {
        return Err(StepError::WrongCount { bodies: model.bodies().len(), states: states.len() });
    }
    if step_s != 0.0 && !(SHORTEST_STEP_S..=LONGEST_STEP_S).contains(&step_s) {
        return Err(StepError::BadTimeStep { step_s });
    }
    Ok(())
}

/// Checks the host's input.
pub(crate) fn admit(
    model: &Model,
    memory: &Memory,
    states: &[BodyState],
    step_s: f64,
) -> Result<(), StepError> {
    admit_call(model, memory, states, step_s)?;
    admit_states(model, states)
}

/// Checks the states of all bodies that the host gives.
pub(crate) fn admit_states(model: &Model, states: &[BodyState]) -> Result<(), StepError> {
    match states.iter().position(|state| !is_sound(state)) {
        None => Ok(()),
        Some(index) => Err(unsound(model, index, &states[index])),
    }
}

impl Model {
    /// Checks whether a step would accept this state of the body with the index `body`. This function is for hosts that
    /// pass bodies one by one.
    ///
    /// # Errors
    /// Returns [`StepError::BadState`], which names the body and the field, if a step would refuse the state.
    ///
    /// # Panics
    /// Panics if the model has no body with this index.
    pub fn check_state(&self, body: usize, state: &BodyState) -> Result<(), StepError> {
        if is_sound(state) { Ok(()) } else { Err(unsound(self, body, state)) }
    }

    /// Checks whether a step would accept this load on the body with the index `body`.
    ///
    /// # Errors
    /// Returns [`StepError::BadState`], which names the body and the field, if a step would refuse the load.
    ///
    /// # Panics
    /// Panics if the model has no body with this index.
    pub fn check_load(&self, body: usize, load: &Wrench) -> Result<(), StepError> {
        if is_sound_load(load) { Ok(()) } else { Err(unsound_load(self, body, load)) }
    }
}

/// Returns true if every number of the state is finite and within its bounds.
#[inline]
pub(crate) fn is_sound(state: &BodyState) -> bool {
    // NaN is within no bounds. `&` instead of `&&` makes one branch of all tests.
    (state.position_m.x.abs() <= FURTHEST_M)
        & (state.position_m.y.abs() <= FURTHEST_M)
        & (state.velocity_mps.x.abs() <= FASTEST_MPS)
        & (state.velocity_mps.y.abs() <= FASTEST_MPS)
        & (state.heading_rad.abs() <= LARGEST_HEADING_RAD)
        & (state.yaw_rate_radps.abs() <= FASTEST_TURN_RADPS)
}

/// Returns the error that names the first field of the state that is not finite or too large.
#[cold]
fn unsound(model: &Model, index: usize, state: &BodyState) -> StepError {
    let fields = [
        ("north position", state.position_m.x, FURTHEST_M),
        ("east position", state.position_m.y, FURTHEST_M),
        ("heading", state.heading_rad, LARGEST_HEADING_RAD),
        ("north velocity", state.velocity_mps.x, FASTEST_MPS),
        ("east velocity", state.velocity_mps.y, FASTEST_MPS),
        ("yaw rate", state.yaw_rate_radps, FASTEST_TURN_RADPS),
    ];
    bad_number(model, index, &fields)
}

/// Returns the error for the first field in the list (name, value and largest value) whose value is not within its
/// bounds.
fn bad_number(model: &Model, index: usize, fields: &[(&'static str, f64, f64)]) -> StepError {
    let is_within = |value: f64, largest: f64| value.abs() <= largest;
    let bad = fields.iter().find(|&&(_, value, largest)| !is_within(value, largest));
    let &(field, value, _) = bad.expect("one of the fields is not finite or too large");
    StepError::BadState { body: model.bodies()[index].name.clone(), field, value }
}

/// Checks the loads that the host gives to the coupled method.
pub(crate) fn admit_loads(
    model: &Model,
    states: &[BodyState],
    loads: &[Wrench],
) -> Result<(), StepError> {
    // One branch for all loads.
    let all_sound = loads.iter().fold(true, |sound, load| sound & is_sound_load(load));
    if loads.len() == model.bodies().len() && all_sound {
        return Ok(());
    }
    // A state that is not sound is reported first.
    admit_states(model, states)?;
    Err(match loads.iter().position(|load| !is_sound_load(load)) {
        Some(index) if loads.len() == model.bodies().len() => {
            unsound_load(model, index, &loads[index])
        }
        _ => StepError::WrongCount { bodies: model.bodies().len(), states: loads.len() },
    })
}

/// Returns true if every part of the load is finite and within its bounds.
#[inline]
pub(crate) fn is_sound_load(load: &Wrench) -> bool {
    (load.force_n.x.abs() <= LARGEST_LOAD)
        & (load.force_n.y.abs() <= LARGEST_LOAD)
        & (load.moment_nm.abs() <= LARGEST_LOAD)
}

/// Returns the error that names the first part of the load that is not finite or too large.
#[cold]
fn unsound_load(model: &Model, index: usize, load: &Wrench) -> StepError {
    let fields = [
        ("north load", load.force_n.x, LARGEST_LOAD),
        ("east load", load.force_n.y, LARGEST_LOAD),
        ("moment of the load", load.moment_nm, LARGEST_LOAD),
    ];
    bad_number(model, index, &fields)
}
