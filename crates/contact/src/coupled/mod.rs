//! The coupled method: one solve for all contacts of a step, with the external loads in it, in
//! sub-steps where the step is too long for the contact.
//!
//! What it mends in the paper's method: limits of several contacts that add up, loads that the
//! limiter does not know and that creep through it, and steps longer than the contact itself.
//!
//! One sub-step of length h of an island (bodies that may touch each other, however indirectly):
//!
//! 1. overlap and kinematics, as in the paper's method ([`rows`]);
//! 2. v_free = v + h M⁻¹ W, with M the full mass matrix and W all but the contact forces;
//! 3. N and T of all contacts together ([`solve`]);
//! 4. positions with the new velocities.
//!
//! Islands know nothing of each other; neighbours that need as many sub-steps go through these stages
//! together, so that no contact waits for what another's island does.

pub(crate) mod bodies;
pub(crate) mod book;
pub(crate) mod contacts;
pub(crate) mod direct;
pub(crate) mod island;
pub(crate) mod leap;
pub(crate) mod let_go;
pub(crate) mod pace;
pub(crate) mod peaks;
pub(crate) mod press_out;
pub(crate) mod rows;
pub(crate) mod solve;
pub(crate) mod tie;
pub(crate) mod turning;

use alloc::vec::Vec;

use crate::broad;
use crate::coupled::island::Island;
use crate::error::StepError;
use crate::events::note;
use crate::memory::{HintMemory, Memory, Past, PatchMemory, PlaceMemory};
use crate::model::Model;
use crate::overlap::overlap;
use crate::pause::pause;
use crate::report::{EventKind, Wrench};
use crate::state::BodyState;
use crate::workspace::Workspace;

/// Contact forces for the step of `step_s` seconds that begins at `states`, by the coupled method,
/// and the states at its end. `states` and `loads` are in the order in which bodies were added;
/// `loads` is all that acts on each body in this step except contact, about its centre of gravity:
/// hull forces, wind, lines, and the Coriolis and centripetal terms where the host has them.
///
/// Results are in `work`: [`Workspace::wrenches`] has the *mean* contact wrench over the step, what
/// a host that integrates by itself adds to its forces, and [`Workspace::peak_wrenches_into`] the greatest within it;
/// [`Workspace::states_after`] the states that the engine came to; [`Workspace::contacts`] mean forces and true peaks. Hosts that let the engine move their bodies
/// take [`advance_from_engine_states`] or [`advance_in_place`], which know more of the velocities that they are shown.
///
/// In a step of 0 s, of a host that is paused, nothing goes on: `memory` stays as it is, the states after it are those
/// shown, and wrenches and contacts those of the last step, without work and events.
///
/// Where a host puts a body farther than its velocities lead it, contacts give back what they hold there.
///
/// # Errors
/// As [`crate::step()`]; but `work` has no good results after [`StepError::NotFinite`].
pub fn advance(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    states: &[BodyState],
    loads: &[Wrench],
    step_s: f64,
) -> Result<(), StepError> {
    advance_from(model, memory, work, (states, loads), (step_s, false))
}

/// The same for hosts that let the engine move their bodies, and show the velocities that it left in
/// [`Workspace::states_after`], but for what they change of them themselves. These belong to the middle of the last
/// sub-step, and where this step's are longer or shorter that counts: a body that is on a fender when a stiffer one is
/// met, or Δt changes, would else leave with some per cent too much or too little.
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
    advance_from(model, memory, work, (states, loads), (step_s, true))
}

fn advance_from(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    (states, loads): (&[BodyState], &[Wrench]),
    (step_s, moves_on): (f64, bool),
) -> Result<(), StepError> {
    if step_s == 0.0 {
        return pause(model, memory, work, states, Some(loads));
    }
    let all_held = bodies::take(model, memory, work, (states, loads), (step_s, moves_on))?;
    // Of those that stand as they stood nothing is written.
    if work.states_after.len() != states.len() {
        work.states_after.clear();
        work.states_after.extend_from_slice(states);
    }
    carry_out(model, memory, work, all_held, step_s)
}

/// The same as [`advance_from_engine_states`], where `states` become those at the end of the step, with nothing to copy. [`Workspace::states_after`] has none then.
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
/// As [`crate::step()`]; `states` are what they were then.
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
        work.states_after.clear();
        return Ok(());
    }
    let all_held = bodies::take(model, memory, work, (states, loads), (step_s, true))?;
    core::mem::swap(states, &mut work.states_after);
    let carried_out = carry_out(model, memory, work, all_held, step_s);
    core::mem::swap(states, &mut work.states_after);
    work.states_after.clear();
    if carried_out.is_err() {
        for (id, shown) in model.id_of.iter().zip(&work.shown) {
            states[id.0 as usize] = *shown;
        }
    }
    carried_out
}

/// The stages after it. `states_after` in `work` have what does not move already.
fn carry_out(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    all_held: bool,
    step_s: f64,
) -> Result<(), StepError> {
    work.contacts.clear();
    bodies::clear_results(model, work);
    work.peaks.clear();
    broad::pair(model, work, all_held);
    island::split(model, work);
    work.next_patches.clear();
    work.next_places.clear();
    work.next_hints.clear();
    let all_go_on = advance_islands(model, memory, work, step_s);
    bodies::drift_apart(model, work, step_s);
    work.results_of = None;
    report(model, work)?;
    work.results_of = Some(model.layout);
    remember(memory, work, all_go_on, step_s);
    work.advanced = Some(model.layout);
    Ok(())
}

/// All islands: together as far as they are in the order of the memory. True where all its hints go on as they are.
fn advance_islands(model: &Model, memory: &Memory, work: &mut Workspace, step_s: f64) -> bool {
    let mut islands = core::mem::take(&mut work.islands);
    let mut all_go_on = false;
    if islands.is_empty() || !work.in_order {
        end_what_left(model, memory, work);
    }
    let put = (work.jumps, work.puts);
    if work.in_order {
        all_go_on = advance_in_order(model, memory.past(), work, &mut islands, step_s);
    } else {
        let mut gathered = core::mem::take(&mut work.gathered_memory);
        for island in &mut islands {
            gathered.gather(memory, &work.candidates[island.candidates()]);
            let past = gathered.past(memory.last_step_s);
            (work.jumps, work.puts) = put;
            // The islands before have moved them.
            island::put_walls_back(work, island.candidates());
            if advance_in_order(model, past, work, core::slice::from_mut(island), step_s) {
                work.next_hints.extend_from_slice(past.hints);
            }
        }
        work.gathered_memory = gathered;
    }
    work.islands = islands;
    all_go_on
}

/// Tells of contacts whose pairs are no candidates any more, as they are only where a body jumped, where
/// [`crate::inherit`] does not come upon them.
fn end_what_left(model: &Model, memory: &Memory, work: &mut Workspace) {
    if !work.jumps {
        return;
    }
    for patch in &memory.patches {
        if !work.candidates.iter().any(|pairing| pairing.candidate.key() == patch.candidate()) {
            note(model, &mut work.events, patch.a, patch.b, EventKind::ContactEnded);
        }
    }
}

/// Islands that are in the order of what the last step left of them: the first overlap of all of them, and
/// then their sub-steps, stage by stage for neighbours that need as many. What they leave is added to that of the
/// next step, but for the hints where all of the last one's go on as they are: it is true then.
fn advance_in_order(
    model: &Model,
    past: Past<'_>,
    work: &mut Workspace,
    islands: &mut [Island],
    step_s: f64,
) -> bool {
    let ([first, ..], [.., last]) = (&*islands, &*islands) else { return false };
    work.own_candidates = first.candidates().start..last.candidates().end;
    let mut own_hints = core::mem::take(&mut work.first_hints);
    own_hints.clear();
    let mut all_go_on = overlap(model, past.hints, work, &mut own_hints);
    let hints = if all_go_on { past.hints } else { own_hints.as_slice() };
    pace::set_paces(model, work, islands, hints, step_s);

    let mut rest = Past { hints, ..past };
    let put = (work.jumps, work.puts);
    let mut from = 0;
    while from < islands.len() {
        let alike = |island: &&Island| island.sub_steps == islands[from].sub_steps;
        let to = from + islands[from..].iter().take_while(alike).count();
        let next = islands
            .get(to)
            .map(|island| work.candidates[island.candidates().start].candidate.key());
        (work.jumps, work.puts) = put;
        island::enter(work, &islands[from..to]);
        let begun = rest.before(next);
        advance_group(model, begun, work, &mut islands[from..to], step_s);
        island::leave(model, work);
        let one_sub_step = islands[from].sub_steps == 1;
        let all = one_sub_step && to - from == islands.len();
        // What goes on to the next step is the whole list, most often: not copied then.
        if all && all_go_on {
            // With room for them, as if they had been.
            work.next_hints.reserve(begun.hints.len());
            break;
        }
        if all && work.next_hints.is_empty() {
            core::mem::swap(&mut work.next_hints, &mut own_hints);
            break;
        }
        all_go_on = false;
        if one_sub_step {
            work.next_hints.extend_from_slice(begun.hints);
        }
        from = to;
    }
    work.first_hints = own_hints;
    all_go_on
}

/// All sub-steps of the islands in `work`, after the first overlap: `begun` has the patches of the last step and
/// the hints of that overlap.
fn advance_group(
    model: &Model,
    begun: Past<'_>,
    work: &mut Workspace,
    islands: &mut [Island],
    step_s: f64,
) {
    let sub_steps = islands[0].sub_steps;
    if sub_steps > 1 {
        peaks::begin(model, work);
    }
    sub_step(model, begun, work, islands, (0, step_s));
    if sub_steps == 1 {
        return;
    }
    let share = 1.0 / f64::from(sub_steps);
    peaks::note(work, share);
    let mut own = core::mem::take(&mut work.island_memory);
    let mut first_found = core::mem::take(&mut work.first_found);
    core::mem::swap(&mut first_found, &mut work.found);
    own.take_first(work, begun.hints);
    for later in 1..sub_steps {
        if later > 1 {
            own.take(work);
        }
        let mut hints = core::mem::take(&mut work.next_hints);
        if overlap(model, &own.hints, work, &mut hints) {
            hints.extend_from_slice(&own.hints);
        }
        work.next_hints = hints;
        island::tell_of_patches(islands, &work.found.patches);
        let last_step_s = step_s / f64::from(sub_steps);
        sub_step(model, own.past(last_step_s), work, islands, (later, step_s));
        peaks::note(work, share);
    }
    core::mem::swap(&mut first_found, &mut work.found);
    work.first_found = first_found;
    work.island_memory = own;
}

/// One of the sub-steps, after its overlap.
fn sub_step(
    model: &Model,
    past: Past<'_>,
    work: &mut Workspace,
    islands: &[Island],
    (number, step_s): (u32, f64),
) {
    let sub_steps = islands[0].sub_steps;
    let h = step_s / f64::from(sub_steps);
    if sub_steps == 1 {
        // Nothing moves the bodies before the end: they are as they were shown.
        core::mem::swap(&mut work.states, &mut work.shown);
        if work.joined && bodies::agree(model, work, islands) {
            bodies::free_velocities(work, h);
        }
    } else {
        if number == 0 {
            bodies::begin(work, h);
        }
        if number == 0 && work.joined {
            bodies::agree(model, work, islands);
        }
        bodies::free_velocities(work, h);
    }
    contacts::act(model, past, work, islands, (h, 1.0 / f64::from(sub_steps)));
    if number + 1 < sub_steps {
        bodies::advance_positions(model, work, h, number == 0);
    } else {
        bodies::arrive(model, work, h, number == 0);
    }
    if sub_steps == 1 {
        core::mem::swap(&mut work.states, &mut work.shown);
    }
}

/// Contacts in the order of the keys.
///
/// # Errors
/// A number that is none: next to no mass under a load, or more than the bounded sub-steps can follow.
#[inline(never)]
fn report(model: &Model, work: &mut Workspace) -> Result<(), StepError> {
    let key = |c: &crate::report::Contact| {
        let [one, two] = [c.body_1, c.body_2].map(|id| model.rank_of[id.0 as usize]);
        (one.min(two), one.max(two), model.face_of(c.fender), c.patch)
    };
    if !work.in_order {
        work.contacts.sort_unstable_by_key(key);
    }
    if work.sums.is_finite() { Ok(()) } else { overflow(model, work) }
}

/// Names the first body whose state or wrench is not finite.
#[cold]
fn overflow(model: &Model, work: &Workspace) -> Result<(), StepError> {
    let is_finite = |index: usize| {
        let (state, push) = (&work.states_after[index], &work.wrenches[index]);
        state.position_m.is_finite()
            && state.velocity_mps.is_finite()
            && state.heading_rad.is_finite()
            && state.yaw_rate_radps.is_finite()
            && push.force_n.is_finite()
            && push.moment_nm.is_finite()
    };
    match model.bodies().iter().enumerate().find(|&(index, _)| !is_finite(index)) {
        Some((_, body)) => Err(StepError::NotFinite { body: body.name.clone() }),
        None => Ok(()),
    }
}

/// The step is done: what it found becomes the memory of the next. Where all hints go on the memory has them.
fn remember(memory: &mut Memory, work: &mut Workspace, all_go_on: bool, step_s: f64) {
    if !work.in_order {
        work.next_patches.sort_unstable_by_key(PatchMemory::key);
        work.next_places.sort_unstable_by_key(PlaceMemory::key);
        work.next_hints.sort_unstable_by_key(HintMemory::key);
    }
    core::mem::swap(&mut memory.patches, &mut work.next_patches);
    core::mem::swap(&mut memory.places, &mut work.next_places);
    if !all_go_on {
        core::mem::swap(&mut memory.hints, &mut work.next_hints);
    }
    core::mem::swap(&mut memory.last_states, &mut work.shown);
    memory.last_step_s = step_s;
    memory.placed.clear();
    memory.behind_s.clone_from(&work.behind_s);
}
