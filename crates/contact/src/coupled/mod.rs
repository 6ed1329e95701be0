//! The coupled method: solves all contacts of an island together with the external loads, in sub-steps if the step is
//! too long for the contacts.
//!
//! The coupled method mends three faults of the paper's method. In the paper's method, the limits of several contacts
//! add up. The limiter of the paper's method does not know the external loads, so bodies creep through it. In the
//! paper's method, a step can be longer than the contact itself.
//!
//! The list has the stages of one sub-step of length h of an island (bodies that may touch each other, directly or
//! through other bodies):
//!
//! 1. compute overlap and kinematics, as in the paper's method ([`crate::overlap`], [`crate::touch`]);
//! 2. compute v_free = v + κ M⁻¹ W, with M the full mass matrix and W all forces but contact ([`dynamics`]);
//! 3. write the laws of each contact as a constraint ([`assemble`]);
//! 4. solve for the normal forces N and tangential forces T of all contacts together ([`solve`]);
//! 5. advance the positions of the bodies with the new velocities ([`dynamics`]).
//!
//! Islands do not affect each other in a step.

mod accumulate;
mod assemble;
mod block_cholesky;
mod constraint;
pub(crate) mod contact_stage;
mod direct;
mod direct_system;
pub(crate) mod dynamics;
pub(crate) mod held;
pub(crate) mod island;
mod motion;
mod moving_pile;
mod newton;
pub(crate) mod peaks;
pub(crate) mod piles;
pub(crate) mod press_out;
#[cfg(test)]
mod reference;
mod release;
mod solve;
mod sub_step;
mod sub_step_count;
pub(crate) mod sub_steps;
mod unknowns;

use alloc::vec::Vec;

use crate::admit::refuse_piles;
use crate::broad;
use crate::broad::bodies::Displaced;
use crate::broad::candidates::{Candidates, Pairing};
pub(crate) use crate::coupled::assemble::add_held;
use crate::coupled::dynamics::HostInput;
use crate::coupled::sub_steps::SubSteps;
use crate::error::StepError;
use crate::model::Model;
use crate::pause::pause;
use crate::state::body_state::BodyState;
use crate::state::events::note;
use crate::state::memory::Memory;
use crate::state::report::{Contact, Displacement, EventKind, Wrench};
use crate::state::results::Results;
use crate::state::workspace::Workspace;

/// Computes the contact forces by the coupled method, for the step of `step_s` seconds that begins at `states`, and the
/// states at the end of the step. `states` and `loads` are in the order in which bodies were added. `loads` is all that
/// acts on each body in this step except contact, about the body's centre of gravity: hull forces, wind, lines, and the
/// Coriolis and centripetal terms if the host has them.
///
/// Results are in `work`. [`Workspace::wrenches`] has the *mean* contact wrench over the step: a host that integrates
/// by itself adds it to its forces. [`Workspace::peak_wrenches_into`] has the greatest wrench within the step,
/// [`Workspace::states_after`] the states at the end of the step, and [`Workspace::contacts`] mean forces and true
/// peaks. Hosts that let the engine move their bodies call [`advance_from_engine_states`] or [`advance_in_place`]
/// instead: the engine's velocities belong to the middle of a sub-step, and only these two functions know it.
///
/// A step of 0 s means that the host is paused. It does not change `memory`. The states after it are the input states.
/// Wrenches and contacts are those of the last step, without work and events.
///
/// If a host displaces a body farther than its velocities lead, contacts give back all the energy that they store at
/// the new place.
///
/// # Errors
/// As [`crate::step()`], except that `work` has no valid results after [`StepError::NotFinite`].
pub fn advance(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    states: &[BodyState],
    loads: &[Wrench],
    step_s: f64,
) -> Result<(), StepError> {
    let input = HostInput { states, loads, step_s, velocities_continue: false };
    advance_copy(model, memory, work, &input)
}

/// As [`advance`], for hosts that let the engine move their bodies. `states` have the velocities of
/// [`Workspace::states_after`], unless the host itself changed them.
///
/// These velocities belong to the middle of the last sub-step. This matters if the sub-steps of the new step are longer
/// or shorter, because Δt changes or because a body meets a stiffer fender. [`advance`] would then give a rebound that
/// is wrong by some per cent.
///
/// # Errors
/// As [`advance`].
pub fn advance_from_engine_states(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    states: &[BodyState],
    loads: &[Wrench],
    step_s: f64,
) -> Result<(), StepError> {
    let input = HostInput { states, loads, step_s, velocities_continue: true };
    advance_copy(model, memory, work, &input)
}

/// As [`advance_from_engine_states`], but writes the states at the end of the step into `states`. This saves a copy of
/// all states. [`Workspace::states_after`] is empty afterwards.
///
/// ```
/// use fenderline_contact::*;
/// # let square = [vec2(-5.0, -5.0), vec2(5.0, -5.0), vec2(5.0, 5.0), vec2(-5.0, 5.0)];
/// # let (outline, _) = Outline::new(&square)?;
/// # let mut builder = Model::builder();
/// # builder.body(Body { name: "barge".into(), key: 1, outline,
/// #     mobility: Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 6e7 } });
/// # let model = builder.build()?;
/// # let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
/// let mut states = vec![BodyState { velocity_mps: vec2(0.5, 0.0), ..Default::default() }];
/// let loads = [Wrench { force_n: vec2(0.0, 1e5), moment_nm: 0.0 }];
/// for _ in 0..100 {
///     advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, 0.1)?;
/// }
/// // A velocity belongs to the middle of the last (sub-)step, 9.95 s after the start, and a place to its end.
/// assert!((states[0].velocity_mps.y - 0.995).abs() < 1e-12);
/// assert!((states[0].position_m.y - 5.0).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// As [`crate::step()`]; `states` are unchanged then.
pub fn advance_in_place(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    states: &mut Vec<BodyState>,
    loads: &[Wrench],
    step_s: f64,
) -> Result<(), StepError> {
    if step_s == 0.0 {
        pause(model, memory, work, states, Some(loads))?;
        work.results.states_after.clear();
        return Ok(());
    }
    let input = HostInput { states, loads, step_s, velocities_continue: true };
    begin(model, memory, work, &input)?;
    // The caller's list is where the step writes its states.
    core::mem::swap(states, &mut work.results.states_after);
    let outcome = carry_out(model, memory, work, loads, step_s);
    core::mem::swap(states, &mut work.results.states_after);
    work.results.states_after.clear();
    if outcome.is_err() {
        for (id, input) in model.id_of.iter().zip(&work.bodies.input) {
            states[id.0 as usize] = *input;
        }
    }
    outcome
}

/// Does a step, and leaves the states at its end in the workspace.
fn advance_copy(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    input: &HostInput<'_>,
) -> Result<(), StepError> {
    let HostInput { states, loads, step_s, velocities_continue } = *input;
    if !velocities_continue {
        refuse_piles(model)?;
    }
    if step_s == 0.0 {
        return pause(model, memory, work, states, Some(loads));
    }
    begin(model, memory, work, input)?;
    // Settled bodies keep the states of the last step: these are not rewritten.
    if work.results.states_after.len() != states.len() {
        work.results.states_after.clear();
        work.results.states_after.extend_from_slice(states);
    }
    carry_out(model, memory, work, loads, step_s)
}

/// 1. Admit: checks the input, places the bodies, and applies their loads.
fn begin(
    model: &Model,
    memory: &Memory,
    work: &mut Workspace,
    input: &HostInput<'_>,
) -> Result<(), StepError> {
    let Workspace { bodies, displaced, dynamics, results, constraints, .. } = work;
    let continues = dynamics.layout == Some(model.layout);
    dynamics.begin(model, memory, input, bodies, displaced)?;
    if !continues {
        results.states_after.clear();
        results.displacements.resize(model.bodies().len(), Displacement::default());
        constraints.solver.resize(model.ranked.len());
    }
    results.begin_events(model, &displaced.teleported);
    if !model.piles.is_empty() {
        dynamics.begin_pile_motions(model, results);
    }
    Ok(())
}

/// Stages 2 to 6, after [`begin`]. `Results::states_after` already has the states of bodies that do not move.
fn carry_out(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    loads: &[Wrench],
    step_s: f64,
) -> Result<(), StepError> {
    let Workspace { bodies, candidates, islands, next_memory, results, .. } = work;
    results.layout = None;
    results.clear_forces(model.bodies().len());
    next_memory.clear();
    results.parted.clone_from(&memory.parted);

    // 2. Broad phase: candidates, and their islands.
    broad::pair(model, bodies, &memory.contacts.patches, candidates);
    islands.split(model, &mut candidates.pairings);

    // 3–6. Overlaps, laws, solve and motion, in sub-steps (see `SubSteps::sub_step`).
    let keeps_hints = advance_islands(model, memory, work, loads, step_s);
    let Workspace { bodies, dynamics, islands, next_memory, results, .. } = work;
    let is_finite = dynamics.drift(model, loads, bodies, step_s, results);
    if !islands.in_order {
        sort_contacts(model, results);
        next_memory.sort();
    }
    if !is_finite && let Some(error) = results.not_finite(model) {
        return Err(error);
    }
    results.layout = Some(model.layout);

    // The step is done. The new memory becomes the memory of the next step.
    next_memory.exchange(&mut memory.contacts, keeps_hints);
    memory.parted.clone_from(&results.parted);
    if !model.piles.is_empty() {
        dynamics.store_offsets(memory);
    }
    core::mem::swap(&mut memory.last_states, &mut bodies.input);
    memory.last_step_s = step_s;
    memory.placed.clear();
    memory.behind_s.clear();
    memory.behind_s.extend_from_slice(&dynamics.velocity_lags_s);
    dynamics.layout = Some(model.layout);
    Ok(())
}

/// Moves all islands through the step: together if they are in the order of the memory, else one by one. Returns true
/// if all hints of the memory stay unchanged.
fn advance_islands(
    model: &Model,
    memory: &Memory,
    work: &mut Workspace,
    loads: &[Wrench],
    step_s: f64,
) -> bool {
    let Workspace { displaced, islands, kept, gathered, overlap, candidates, .. } = work;
    let is_empty = islands.list.is_empty();
    if is_empty || !islands.in_order {
        end_contacts_of_teleported(model, memory, candidates, displaced, &mut work.results);
    }
    if is_empty {
        return false;
    }
    let (joined, in_order) = (islands.joined(), islands.in_order);
    let mut sub_steps = SubSteps {
        model,
        loads,
        candidates,
        joined,
        bodies: &mut work.bodies,
        dynamics: &mut work.dynamics,
        group: &mut work.group,
        clip: &mut work.clip,
        inheritance: &mut work.inheritance,
        constraints: &mut work.constraints,
        next_memory: &mut work.next_memory,
        results: &mut work.results,
        in_order: &mut islands.in_order,
    };
    if in_order {
        let past = memory.contacts.past(memory.last_step_s, displaced);
        return sub_steps.advance(past, &mut islands.list, overlap, kept, step_s);
    }
    for island in &mut islands.list {
        let own = &candidates.pairings[island.candidates()];
        gathered.gather(&memory.contacts, own);
        // The islands before this one have moved these bodies.
        sub_steps.dynamics.reset_moving_fixed(sub_steps.bodies, own);
        let past = gathered.past(memory.last_step_s, displaced);
        if sub_steps.advance(past, core::slice::from_mut(island), overlap, kept, step_s) {
            sub_steps.next_memory.hints.extend_from_slice(past.hints);
        }
    }
    false
}

/// Reports the end of contacts whose pairs are no longer candidates. [`crate::inherit`] does not see these contacts.
/// They exist only if a body was teleported.
fn end_contacts_of_teleported(
    model: &Model,
    memory: &Memory,
    candidates: &Candidates,
    displaced: &Displaced,
    results: &mut Results,
) {
    if displaced.teleported.is_empty() {
        return;
    }
    for patch in &memory.contacts.patches {
        let is_of = |pairing: &Pairing| pairing.candidate.key() == patch.candidate();
        if !candidates.pairings.iter().any(is_of) {
            note(model, &mut results.events, patch.a, patch.b, EventKind::ContactEnded);
        }
    }
}

/// Sorts the contacts in the order of their bodies' keys.
fn sort_contacts(model: &Model, results: &mut Results) {
    results.contacts.sort_unstable_by_key(|contact: &Contact| {
        let [one, two] = [contact.body_1, contact.body_2].map(|id| model.rank_of[id.0 as usize]);
        (one.min(two), one.max(two), model.face_of(contact.fender), contact.patch)
    });
}
