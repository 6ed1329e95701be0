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

pub(crate) mod direct;
pub(crate) mod island;
pub(crate) mod leap;
pub(crate) mod pace;
pub(crate) mod rows;
pub(crate) mod solve;
pub(crate) mod tie;
pub(crate) mod turning;

use crate::admit;
use crate::broad;
use crate::error::StepError;
use crate::inherit::inherit_all;
use crate::memory::Memory;
use crate::model::Model;
use crate::overlap::overlap;
use crate::report::{Motion, Wrench};
use crate::state::BodyState;
use crate::vec2::Rotation;
use crate::workspace::Workspace;

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
    work.all_patches.clear();
    work.all_hints.clear();
    for index in 0..work.islands.len() {
        island::enter(memory, work, index);
        advance_island(model, work, step_s);
        island::leave(model, work);
    }
    drift_apart(model, work, step_s);
    report(model, work, step_s);
    remember(memory, work, step_s, model, states);
    Ok(())
}

/// All sub-steps of the island in `work`.
fn advance_island(model: &Model, work: &mut Workspace, step_s: f64) {
    let mut memory = core::mem::replace(&mut work.island_memory, Memory::new(model));
    overlap(model, &memory, work);
    let sub_steps = pace::sub_steps(model, work, step_s);
    let h = step_s / f64::from(sub_steps);
    for sub_step in 0..sub_steps {
        if sub_step > 0 {
            overlap(model, &memory, work);
        }
        inherit_all(model, &memory, work);
        rows::collect(model, work, &memory, h);
        begin_motion(work);
        solve::velocities(model, work, h);
        end_motion(work, h);
        rows::book(model, work, h);
        advance_positions(model, work, h);
        core::mem::swap(&mut memory.patches, &mut work.next_patches);
        core::mem::swap(&mut memory.hints, &mut work.next_hints);
        memory.last_step_s = h;
    }
    work.island_memory = memory;
}

/// Loads and earth-fixed inverse masses by rank, the room each body may need in the step, and no
/// impulse yet.
fn take_loads(model: &Model, work: &mut Workspace, loads: &[Wrench], step_s: f64) {
    work.loads.clear();
    work.impulses.clear();
    work.impulses.resize(model.ranked.len(), Wrench::default());
    work.motions_by_rank.clear();
    work.motions_by_rank.resize(model.ranked.len(), Motion::default());
    work.inverses.clear();
    work.room_mps.clear();
    for (rank, body) in model.ranked.iter().enumerate() {
        let state = &work.states[rank];
        let (mut load, mut inverse) = (Wrench::default(), body.inverse);
        let mut room_mps = state.yaw_rate_radps.abs() * body.reach_m;
        if !body.is_fixed() {
            load = loads[body.id.0 as usize];
            inverse = inverse.turned(work.poses[rank].rotation);
            let (dv, dr) = inverse.response(load.force_n * step_s, load.moment_nm * step_s);
            room_mps += dv.length() + dr.abs() * body.reach_m;
        }
        work.loads.push(load);
        work.inverses.push(inverse);
        work.room_mps.push(room_mps);
        work.reach_m[rank] += (state.velocity_mps.length() + room_mps) * step_s;
    }
}

/// Positions with the new velocities, and inverse masses as the bodies are turned then.
fn advance_positions(model: &Model, work: &mut Workspace, h: f64) {
    for &rank in &work.island_bodies {
        let rank = rank as usize;
        move_body(&mut work.states[rank], h);
        let state = work.states[rank];
        work.poses[rank].position_m = state.position_m;
        let turns = &model.ranked[rank].turns;
        if state.yaw_rate_radps != 0.0 || turns.is_some() {
            let rotation = Rotation::from_angle(state.heading_rad);
            if let Some(turns) = turns {
                let before = work.poses[rank].rotation;
                turns.turn(&mut work.states[rank], before, rotation, h);
            }
            work.headings_rad[rank] = state.heading_rad;
            work.poses[rank].rotation = rotation;
            work.inverses[rank] = model.ranked[rank].inverse.turned(rotation);
        }
        work.teleported[rank] = false;
    }
}

fn move_body(state: &mut BodyState, h: f64) {
    state.position_m += state.velocity_mps * h;
    state.heading_rad += state.yaw_rate_radps * h;
}

/// Bodies that nothing is near: one step by their loads.
fn drift_apart(model: &Model, work: &mut Workspace, step_s: f64) {
    for (rank, body) in model.ranked.iter().enumerate() {
        if body.is_fixed() || work.in_island[rank] {
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

/// Takes note of the velocities before a solve.
fn begin_motion(work: &mut Workspace) {
    let Workspace { island_bodies, before, states, .. } = work;
    before.clear();
    let velocities = |&rank: &u32| {
        let state = &states[rank as usize];
        (state.velocity_mps, state.yaw_rate_radps)
    };
    before.extend(island_bodies.iter().map(velocities));
}

/// Adds what the mean of the velocities before and after a solve makes of the way: a force times it is that
/// force's work exactly.
fn end_motion(work: &mut Workspace, h: f64) {
    let Workspace { island_bodies, before, states, motions_by_rank, .. } = work;
    for (&rank, &(velocity_mps, yaw_rate_radps)) in island_bodies.iter().zip(before.iter()) {
        let (state, motion) = (&states[rank as usize], &mut motions_by_rank[rank as usize]);
        motion.way_m += (velocity_mps + state.velocity_mps) * (0.5 * h);
        motion.turn_rad += 0.5 * (yaw_rate_radps + state.yaw_rate_radps) * h;
    }
}

/// Mean forces and wrenches over the step, in the order of the keys.
fn report(model: &Model, work: &mut Workspace, step_s: f64) {
    let share = 1.0 / step_s;
    let key = |c: &crate::report::Contact| {
        let [one, two] = [c.body_1, c.body_2].map(|id| model.rank_of[id.0 as usize]);
        (one.min(two), one.max(two), model.face_of(c.fender), c.patch)
    };
    if !work.contacts.is_sorted_by_key(key) {
        work.contacts.sort_unstable_by_key(key);
    }
    for contact in &mut work.contacts {
        contact.normal_force_n *= share;
        contact.tangential_force_n *= share;
        contact.parts.scale(share);
    }
    work.wrenches.resize(model.bodies().len(), Wrench::default());
    work.states_after.resize(model.bodies().len(), BodyState::default());
    work.motions.resize(model.bodies().len(), Motion::default());
    for (rank, body) in model.ranked.iter().enumerate() {
        let impulse = work.impulses[rank];
        let id = body.id.0 as usize;
        work.wrenches[id] =
            Wrench { force_n: impulse.force_n * share, moment_nm: impulse.moment_nm * share };
        work.states_after[id] = work.states[rank];
        work.motions[id] = work.motions_by_rank[rank];
    }
}

/// The step is done: what it found becomes the memory of the next.
fn remember(
    memory: &mut Memory,
    work: &mut Workspace,
    step_s: f64,
    model: &Model,
    states: &[BodyState],
) {
    if !work.all_patches.is_sorted_by_key(crate::memory::PatchMemory::key) {
        work.all_patches.sort_unstable_by_key(crate::memory::PatchMemory::key);
        work.all_hints.sort_unstable_by_key(crate::memory::HintMemory::key);
    }
    core::mem::swap(&mut memory.patches, &mut work.all_patches);
    core::mem::swap(&mut memory.hints, &mut work.all_hints);
    memory.last_states.clear();
    memory.last_states.extend(model.ranked.iter().map(|body| states[body.id.0 as usize]));
    memory.last_step_s = step_s;
}
