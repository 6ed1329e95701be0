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

pub(crate) mod book;
pub(crate) mod direct;
pub(crate) mod island;
pub(crate) mod leap;
pub(crate) mod let_go;
pub(crate) mod pace;
pub(crate) mod rows;
pub(crate) mod solve;
pub(crate) mod tie;
pub(crate) mod turning;

use crate::admit;
use crate::broad;
use crate::coupled::book::Books;
use crate::coupled::island::Island;
use crate::coupled::let_go::let_go;
use crate::coupled::rows::{Begun, Row, Taken};
use crate::coupled::tie::Tie;
use crate::error::StepError;
use crate::events::note;
use crate::inherit::{Inherited, inherit_all};
use crate::mass::InverseMatrix;
use crate::memory::{HintMemory, Memory, Past, PatchMemory};
use crate::model::Model;
use crate::overlap::{Patch, overlap};
use crate::report::{EventKind, Motion, Wrench};
use crate::state::{BodyState, Velocity};
use crate::touch::Scene;
use crate::vec2::Rotation;
use crate::workspace::Workspace;

/// Islands that go through the stages together: as many as leave what the stages hand to one another near the
/// processor.
const BLOCK: usize = 64;

/// Contact forces for the step of `step_s` seconds that begins at `states`, by the coupled method,
/// and the states at its end. `states` and `loads` are in the order in which bodies were added;
/// `loads` is all that acts on each body in this step except contact, about its centre of gravity:
/// hull forces, wind, lines, and the Coriolis and centripetal terms where the host has them.
///
/// Results are in `work`: [`Workspace::wrenches`] has the *mean* contact wrench over the step, what
/// a host that integrates by itself adds to its forces; [`Workspace::states_after`] the states that
/// the engine came to, for hosts that let it; [`Workspace::contacts`] mean forces and true peaks.
///
/// # Errors
/// As [`crate::step`].
pub fn advance(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    states: &[BodyState],
    loads: &[Wrench],
    step_s: f64,
) -> Result<(), StepError> {
    admit::admit(model, memory, states, step_s)?;
    admit::admit_loads(model, loads)?;
    work.events.clear();
    work.contacts.clear();
    admit::place(model, memory, work, states);
    take_loads(model, work, loads, step_s);
    broad::pair(model, work);
    island::split(model, work);
    work.next_patches.clear();
    work.next_hints.clear();
    advance_islands(model, memory, work, step_s);
    drift_apart(model, work, step_s);
    report(model, work)?;
    remember(memory, work, step_s, model, states);
    Ok(())
}

/// All islands: together as far as they are in the order of the memory.
fn advance_islands(model: &Model, memory: &Memory, work: &mut Workspace, step_s: f64) {
    let mut islands = core::mem::take(&mut work.islands);
    if islands.is_empty() || !work.in_order {
        end_what_left(model, memory, work);
    }
    let jumps = work.jumps;
    if work.in_order {
        let mut rest = memory.past();
        let mut blocks = islands.chunks_mut(BLOCK).peekable();
        while let Some(block) = blocks.next() {
            let next = blocks.peek().map(|next| work.candidates[next[0].candidates.start].key());
            work.jumps = jumps;
            advance_in_order(model, rest.before(next), work, block, step_s);
        }
    } else {
        let mut gathered = core::mem::take(&mut work.gathered_memory);
        for island in &mut islands {
            gathered.gather(memory, &work.candidates[island.candidates.clone()]);
            let past = gathered.past(memory.last_step_s);
            work.jumps = jumps;
            advance_in_order(model, past, work, core::slice::from_mut(island), step_s);
        }
        work.gathered_memory = gathered;
    }
    work.islands = islands;
}

/// Tells of contacts whose pairs are no candidates any more, as they are only where a body jumped, where
/// [`inherit_all`] does not come upon them.
fn end_what_left(model: &Model, memory: &Memory, work: &mut Workspace) {
    if !work.jumps {
        return;
    }
    for patch in &memory.patches {
        if !work.candidates.iter().any(|candidate| candidate.key() == patch.candidate()) {
            note(model, &mut work.events, patch.a, patch.b, EventKind::ContactEnded);
        }
    }
}

/// Islands that are in the order of what the last step left of them: the first overlap of all of them, and
/// then their sub-steps, stage by stage for neighbours that need as many.
fn advance_in_order(
    model: &Model,
    past: Past<'_>,
    work: &mut Workspace,
    islands: &mut [Island],
    step_s: f64,
) {
    let ([first, ..], [.., last]) = (&*islands, &*islands) else { return };
    work.own_candidates = first.candidates.start..last.candidates.end;
    let mut hints = core::mem::take(&mut work.first_hints);
    hints.clear();
    overlap(model, past.hints, work, &mut hints);
    island::set_paces(model, work, islands, &hints, step_s);

    let mut rest = Past { hints: &hints, ..past };
    let jumps = work.jumps;
    let mut from = 0;
    while from < islands.len() {
        let alike = |island: &&Island| island.sub_steps == islands[from].sub_steps;
        let to = from + islands[from..].iter().take_while(alike).count();
        let next = islands.get(to).map(|island| work.candidates[island.candidates.start].key());
        work.jumps = jumps;
        island::enter(work, &islands[from..to]);
        advance_group(model, rest.before(next), work, &islands[from..to], step_s);
        island::leave(model, work);
        from = to;
    }
    work.first_hints = hints;
}

/// All sub-steps of the islands in `work`, after the first overlap: `begun` has the patches of the last step and
/// the hints of that overlap.
fn advance_group(
    model: &Model,
    begun: Past<'_>,
    work: &mut Workspace,
    islands: &[Island],
    step_s: f64,
) {
    let sub_steps = islands[0].sub_steps;
    sub_step(model, begun, work, islands, step_s);
    if sub_steps == 1 {
        work.next_hints.extend_from_slice(begun.hints);
        return;
    }
    let mut own = core::mem::take(&mut work.island_memory);
    let mut first_found = core::mem::take(&mut work.first_found);
    core::mem::swap(&mut first_found, &mut work.found);
    own.take_first(work, begun.hints);
    for later in 1..sub_steps {
        if later > 1 {
            own.take(work);
        }
        let mut hints = core::mem::take(&mut work.next_hints);
        overlap(model, &own.hints, work, &mut hints);
        work.next_hints = hints;
        let last_step_s = step_s / f64::from(sub_steps);
        sub_step(model, own.past(last_step_s), work, islands, step_s);
    }
    core::mem::swap(&mut first_found, &mut work.found);
    work.first_found = first_found;
    work.island_memory = own;
}

/// One of the sub-steps, of `h` seconds, after its overlap.
fn sub_step(model: &Model, past: Past<'_>, work: &mut Workspace, islands: &[Island], step_s: f64) {
    let sub_steps = f64::from(islands[0].sub_steps);
    let h = step_s / sub_steps;
    inherit_all(model, past.patches, work);
    solve::free_velocities(work, h);
    contacts_of(model, past, work, islands, (h, 1.0 / sub_steps));
    advance_positions(model, work, h);
}

/// The contacts of a sub-step, of `h` seconds and this `share` of the step: their laws, the solve of each island and what
/// it leaves.
fn contacts_of(
    model: &Model,
    past: Past<'_>,
    work: &mut Workspace,
    islands: &[Island],
    (h, share): (f64, f64),
) {
    let Workspace {
        found,
        own_patches,
        inherited,
        shares,
        poses,
        states,
        before,
        inverses,
        jumps,
        teleported,
        clip: buffers,
        events,
        rows,
        ties,
        trials,
        unheld_j,
        pushes,
        contacts,
        first_contact,
        next_patches,
        in_order,
        ..
    } = work;
    let elapsed_s = if past.last_step_s > 0.0 { past.last_step_s } else { h };
    let begun = Begun { scene: Scene { model, found, poses }, before, inverses, elapsed_s, h };
    let first_sub_step = contacts.len() == *first_contact;
    let first_contact = *first_contact;
    let mut books =
        Books { pushes, contacts, first_contact, next_patches, in_order, first_sub_step, h, share };
    let taken = |patch: &Patch, inherited: Inherited| Taken {
        inherited,
        old: inherited.of(past.patches, shares),
        placed: past.last_step_s == 0.0
            || *jumps
                && [patch.candidate.a, patch.candidate.b]
                    .iter()
                    .any(|&rank| teleported[rank as usize]),
    };
    // Each stage over all contacts, so that none waits for what another's solve does; written where they are to
    // stay.
    let patches = &found.patches[own_patches.clone()];
    if ties.len() < patches.len() {
        ties.resize(patches.len(), Tie::default());
        rows.resize(patches.len(), Row::default());
    }
    let (ties, rows) = (&mut ties[..patches.len()], &mut rows[..patches.len()]);
    let both = ties.iter_mut().zip(rows.iter_mut());
    for ((patch, &inherited), (tie, row)) in patches.iter().zip(&*inherited).zip(both) {
        let taken = taken(patch, inherited);
        // Twice the same: without a fender most of it is nought, which the compiler then knows.
        (*tie, *row) = match patch.candidate.fender(model) {
            None => rows::collect(&begun, (events, buffers), patch, None, taken),
            face => rows::collect(&begun, (events, buffers), patch, face, taken),
        };
    }
    let mut from = 0;
    for island in islands {
        let own = |patch: &&Patch| (patch.of as usize) < island.candidates.end;
        let to = from + patches[from..].iter().take_while(own).count();
        let (ties, rows) = (&mut ties[from..to], &mut rows[from..to]);
        from = to;
        let_go(model, rows, ties, unheld_j);
        if solve::velocities(states, inverses, ties, trials, h) > solve::TOLD_MPS {
            note(model, events, ties[0].a, ties[0].b, EventKind::NotConverged);
        }
    }
    let both = ties.iter().zip(&*rows);
    for ((patch, both), index) in patches.iter().zip(both).zip(0..) {
        books.book(&begun.scene, index, patch, both);
    }
}

/// Loads and earth-fixed inverse masses by rank, the room each body may need in the step, and no
/// push of contacts yet.
fn take_loads(model: &Model, work: &mut Workspace, loads: &[Wrench], step_s: f64) {
    let count = model.ranked.len();
    let Workspace {
        states,
        poses,
        reach_m,
        pushes,
        motions_by_rank,
        loads: own,
        inverses,
        room_mps,
        moves,
        before,
        moving_walls,
        ..
    } = work;
    moving_walls.clear();
    before.resize(count, Velocity::default());
    own.resize(count, Wrench::default());
    inverses.resize(count, InverseMatrix::default());
    room_mps.resize(count, 0.0);
    moves.resize(count, false);
    pushes.clear();
    pushes.resize(count, Wrench::default());
    motions_by_rank.clear();
    motions_by_rank.resize(count, Motion::default());
    // Of one length, so that it is asked for once.
    let (states, poses, reach_m) = (&states[..count], &poses[..count], &mut reach_m[..count]);
    let (own, inverses) = (&mut own[..count], &mut inverses[..count]);
    let (room_mps, moves) = (&mut room_mps[..count], &mut moves[..count]);
    for (rank, body) in model.ranked.iter().enumerate() {
        let (state, fixed) = (&states[rank], body.is_fixed());
        before[rank] = state.velocity();
        moves[rank] = !(fixed && state.is_at_rest());
        if !moves[rank] {
            inverses[rank] = InverseMatrix::default();
            room_mps[rank] = 0.0;
            continue;
        }
        let (mut load, mut inverse) = (Wrench::default(), InverseMatrix::default());
        let mut room = state.yaw_rate_radps.abs() * body.reach_m;
        if !fixed {
            load = loads[model.id_of[rank].0 as usize];
            inverse = body.inverse.turned(poses[rank].rotation);
            let (dv, dr) = inverse.response(load.force_n * step_s, load.moment_nm * step_s);
            room += dv.length() + dr.abs() * body.reach_m;
        } else {
            moving_walls.push((rank as u32, *state));
        }
        own[rank] = load;
        inverses[rank] = inverse;
        room_mps[rank] = room;
        reach_m[rank] += (state.velocity_mps.length() + room) * step_s;
    }
}

/// Positions with the new velocities, and inverse masses as the bodies are turned then; and how far the
/// bodies went by the mean of the velocities before and after the solve: a force times it is that force's work
/// exactly.
fn advance_positions(model: &Model, work: &mut Workspace, h: f64) {
    let Workspace {
        island_bodies,
        before,
        states,
        poses,
        headings_rad,
        inverses,
        motions_by_rank,
        jumps,
        ..
    } = work;
    for &rank in &*island_bodies {
        let rank = rank as usize;
        let (velocity_mps, yaw_rate_radps) = before[rank];
        let (state, motion) = (&mut states[rank], &mut motions_by_rank[rank]);
        motion.way_m += (velocity_mps + state.velocity_mps) * (0.5 * h);
        motion.turn_rad += 0.5 * (yaw_rate_radps + state.yaw_rate_radps) * h;
        move_body(state, h);
        poses[rank].position_m = state.position_m;
        let turns = &model.ranked[rank].turns;
        if state.yaw_rate_radps != 0.0 || turns.is_some() {
            let rotation = Rotation::from_angle(state.heading_rad);
            if let Some(turns) = turns {
                turns.turn(state, poses[rank].rotation, rotation, h);
            }
            headings_rad[rank] = state.heading_rad;
            poses[rank].rotation = rotation;
            inverses[rank] = model.ranked[rank].inverse.turned(rotation);
        }
    }
    *jumps = false;
}

fn move_body(state: &mut BodyState, h: f64) {
    state.position_m += state.velocity_mps * h;
    state.heading_rad += state.yaw_rate_radps * h;
}

/// Bodies that nothing is near: one step by their loads.
fn drift_apart(model: &Model, work: &mut Workspace, step_s: f64) {
    for (rank, body) in model.ranked.iter().enumerate() {
        // Of most there is nothing else to ask.
        if work.in_island[rank] || !work.moves[rank] || body.is_fixed() {
            continue;
        }
        let load = work.loads[rank];
        let inverse = &work.inverses[rank];
        let (dv, dr) = inverse.response(load.force_n * step_s, load.moment_nm * step_s);
        let (state, pose) = (&mut work.states[rank], work.poses[rank]);
        let motion = &mut work.motions_by_rank[rank];
        motion.way_m = (state.velocity_mps + dv * 0.5) * step_s;
        motion.turn_rad = (state.yaw_rate_radps + 0.5 * dr) * step_s;
        state.velocity_mps += dv;
        state.yaw_rate_radps += dr;
        move_body(state, step_s);
        if let Some(turns) = &body.turns {
            turns.turn(state, pose.rotation, Rotation::from_angle(state.heading_rad), step_s);
        }
    }
}

/// Contacts in the order of the keys, and what there is of each body in the order in which they were added.
///
/// # Errors
/// A number that is none: the step is too long for its sub-steps, of which there is a bound.
fn report(model: &Model, work: &mut Workspace) -> Result<(), StepError> {
    let key = |c: &crate::report::Contact| {
        let [one, two] = [c.body_1, c.body_2].map(|id| model.rank_of[id.0 as usize]);
        (one.min(two), one.max(two), model.face_of(c.fender), c.patch)
    };
    if !work.in_order {
        work.contacts.sort_unstable_by_key(key);
    }
    let count = model.ranked.len();
    let Workspace { wrenches, states_after, motions, pushes, states, motions_by_rank, .. } = work;
    wrenches.resize(count, Wrench::default());
    states_after.resize(count, BodyState::default());
    motions.resize(count, Motion::default());
    let by_rank = pushes.iter().zip(states.iter()).zip(motions_by_rank.iter());
    let mut nothing = 0.0;
    for (id, ((push, state), motion)) in model.id_of.iter().zip(by_rank) {
        let id = id.0 as usize;
        wrenches[id] = *push;
        states_after[id] = *state;
        motions[id] = *motion;
        // Nothing times nothing, unless it is infinite or none. Without a branch for each.
        let sum = state.position_m + state.velocity_mps + push.force_n;
        nothing += 0.0 * (sum.x + sum.y + state.heading_rad + state.yaw_rate_radps);
        nothing += 0.0 * push.moment_nm;
    }
    if nothing == 0.0 { Ok(()) } else { Err(overflow(model, work)) }
}

/// Names the first body whose state or wrench is not finite.
#[cold]
fn overflow(model: &Model, work: &Workspace) -> StepError {
    let is_finite = |index: usize| {
        let (state, push) = (&work.states_after[index], &work.wrenches[index]);
        state.position_m.is_finite()
            && state.velocity_mps.is_finite()
            && state.heading_rad.is_finite()
            && state.yaw_rate_radps.is_finite()
            && push.force_n.is_finite()
            && push.moment_nm.is_finite()
    };
    let bodies = model.bodies();
    let bad = (0..bodies.len()).find(|&index| !is_finite(index)).unwrap_or(0);
    StepError::NotFinite { body: bodies[bad].name.clone() }
}

/// The step is done: what it found becomes the memory of the next.
fn remember(
    memory: &mut Memory,
    work: &mut Workspace,
    step_s: f64,
    model: &Model,
    states: &[BodyState],
) {
    if !work.in_order {
        work.next_patches.sort_unstable_by_key(PatchMemory::key);
        work.next_hints.sort_unstable_by_key(HintMemory::key);
    }
    core::mem::swap(&mut memory.patches, &mut work.next_patches);
    core::mem::swap(&mut memory.hints, &mut work.next_hints);
    memory.last_states.clear();
    memory.last_states.extend(model.id_of.iter().map(|id| states[id.0 as usize]));
    memory.last_step_s = step_s;
}
