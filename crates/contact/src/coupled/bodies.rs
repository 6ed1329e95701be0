//! The bodies of a step: what they begin with, and how they move.
//!
//! Sub-steps are a leapfrog: x⁺ = x + h v⁺ with v⁺ = v + κ M⁻¹ (W + contact). So v⁺ belongs to the middle of its
//! sub-step, v to the middle of the one before, and κ, from the one to the other, is (h_before + h)/2: h, as long as
//! sub-steps are of one length. Where their length changes half of the difference is owed. At rest loads and contacts
//! have the same κ and cancel, whatever the steps.

use alloc::vec::Vec;
use core::ops::Range;

use crate::admit::{Came, admit_call, admit_loads, admit_states, is_sound, tell_of_jumps};
use crate::coupled::island::Island;
use crate::error::StepError;
use crate::mass::InverseMatrix;
use crate::memory::{Memory, NOT_BEHIND};
use crate::model::Model;
use crate::number::{greater, lesser};
use crate::ranked::Rest;
use crate::report::{Displacement, Wrench};
use crate::state::{BodyState, Velocity};
use crate::vec2::{Pose, Rotation, Vec2, vec2};
use crate::workspace::Workspace;

/// How many bodies are taken at once: what one pass over them leaves is near the processor still in the next.
const AT_ONCE: usize = 64;

/// Stage 1: admits what the host gave, and finds what loads alone do to each body that floats, and the room each may
/// need in the step; but for those that stand as they stood at the last step, as quays and fenders on them do: these
/// are left as they are. `work.active` are the others. Whether all are still within their circles in the list of
/// those that are near. `moves_on` says that bodies have the velocities that the engine left them.
///
/// # Errors
/// What is not sound; nothing but what stages work with has changed then.
pub(crate) fn take(
    model: &Model,
    memory: &Memory,
    work: &mut Workspace,
    (states, loads): (&[BodyState], &[Wrench]),
    (step_s, moves_on): (f64, bool),
) -> Result<bool, StepError> {
    admit_call(model, memory, states, step_s)?;
    admit_loads(model, states, loads)?;
    let is_new = work.advanced.take() != Some(model.layout);
    if is_new {
        forget(model, work);
    }
    work.active.clear();
    work.teleported.clear();
    work.put.clear();
    work.moving_walls.clear();
    let count = model.ranked.len();
    work.shown.resize(count, BodyState::default());
    let mut all_held = true;
    for from in (0..count).step_by(AT_ONCE) {
        let (first, ranks) = (work.active.len(), from..count.min(from + AT_ONCE));
        if !place(model, memory, work, states, ranks) {
            return admit_states(model, states).map(|()| false);
        }
        let behind_s = moves_on.then_some(memory.behind_s.as_slice());
        all_held &= take_loads(model, work, (loads, behind_s), first, step_s);
    }
    // Not before all states are sound: these are results.
    if is_new {
        work.states_after.clear();
        work.motions.resize(count, Displacement::default());
    }
    tell_of_jumps(model, work);
    Ok(all_held)
}

/// Places those of these bodies that do not stand as they stood, and adds them to the active ones, and to those that
/// were put or jumped. False where a state is not sound.
#[inline(never)]
fn place(
    model: &Model,
    memory: &Memory,
    work: &mut Workspace,
    states: &[BodyState],
    ranks: Range<usize>,
) -> bool {
    let ranked = model.ranked.bodies();
    let count = ranked.len();
    let Workspace { shown, settled, poses, headings_rad, teleported, put, active, .. } = work;
    let inverses = &mut work.inverses;
    // Of one length, so that it is asked for once.
    let (shown, settled, poses) = (&mut shown[..count], &mut settled[..count], &mut poses[..count]);
    let (headings_rad, id_of) = (&mut headings_rad[..count], &model.id_of[..count]);
    for rank in ranks.start..ranks.end.min(count) {
        let (state, last) = (&states[id_of[rank].0 as usize], memory.last_states.get(rank));
        if settled[rank]
            && last.is_some_and(|last| (shown[rank].apart(state) | last.apart(state)) == 0)
        {
            continue;
        }
        if !is_sound(state) {
            return false;
        }
        active.push(rank as u32);
        shown[rank] = *state;
        poses[rank].position_m = state.position_m;
        let body = ranked.of(rank);
        if body.is_fixed() {
            let as_before = last.is_some_and(|last| last.apart(state) == 0);
            settled[rank] = as_before && state.is_at_rest();
        }
        if state.heading_rad.to_bits() != headings_rad[rank].to_bits() {
            headings_rad[rank] = state.heading_rad;
            poses[rank].rotation = Rotation::from_angle(state.heading_rad);
            if !body.is_alike {
                inverses[rank] = model.ranked.rest(rank).inverse.turned(poses[rank].rotation);
            }
        }
        match last.map(|last| memory.came(rank, last, state, body.radius_m)) {
            None | Some(Came::ByItself) => {}
            Some(how) => {
                put.push(rank as u32);
                if how == Came::Jumped {
                    teleported.push(rank as u32);
                }
            }
        }
    }
    true
}

/// What loads alone do to each active body that floats, from that one on, and the room each may need in the step.
/// Whether all are within their circles.
#[inline(never)]
fn take_loads(
    model: &Model,
    work: &mut Workspace,
    (loads, left_behind_s): (&[Wrench], Option<&[f64]>),
    first: usize,
    step_s: f64,
) -> bool {
    let ranked = model.ranked.bodies();
    let count = ranked.len();
    let Workspace { active, shown, moves, velocities, loads: own, inverses, .. } = work;
    let Workspace { accelerations, motions_by_rank, moving_walls, states, .. } = work;
    let Workspace { room_mps, fastest_mps, reach_m, behind_s, put, .. } = work;
    // Of one length, so that it is asked for once.
    let (shown, velocities) = (&shown[..count], &mut velocities[..count]);
    let (accelerations, behind_s) = (&mut accelerations[..count], &mut behind_s[..count]);
    let (fastest_mps, room_mps) = (&mut fastest_mps[..count], &mut room_mps[..count]);
    let (reach_m, id_of) = (&mut reach_m[..count], &model.id_of[..count]);
    let circles = work.near.circles_for(model);
    let mut all_held = true;
    for &rank in &active[first..] {
        let rank = rank as usize;
        let (body, state) = (ranked.of(rank), &shown[rank]);
        let mut room = state.yaw_rate_radps.abs() * body.reach_m;
        if body.is_fixed() {
            moves[rank] = !state.is_at_rest();
            behind_s[rank] = NOT_BEHIND;
            velocities[rank] = state.velocity();
            motions_by_rank[rank] = Displacement::default();
            if moves[rank] {
                moving_walls.push((rank as u32, *state));
                // Where it comes to, unless islands take it along: where nothing is near.
                let (velocity, mut alone) = (state.velocity(), *state);
                motions_by_rank[rank] =
                    moved_on(Displacement::default(), velocity, velocity, step_s);
                move_body(&mut alone, velocity, step_s);
                states[rank] = alone;
            }
        } else {
            let load = &loads[id_of[rank].0 as usize];
            let (way, turn) = if body.is_alike {
                (load.force_n * body.inverse_mass, load.moment_nm * body.inverse_inertia)
            } else {
                own[rank] = *load;
                inverses[rank].response(load.force_n, load.moment_nm)
            };
            accelerations[rank] = (way, turn);
            behind_s[rank] = match left_behind_s {
                // The velocities that a run begins with belong to the places that it begins at.
                Some([]) => 0.0,
                Some(left_s) if left_s[rank] >= 0.0 && !is_among(put, rank) => left_s[rank],
                _ => -0.5 * step_s,
            };
            let kick_s = kick_s(behind_s[rank], step_s);
            velocities[rank] = free_velocity(state, (way, turn), kick_s);
            room += (way.length() + turn.abs() * body.reach_m) * greater(kick_s, step_s);
        }
        let fastest = state.velocity_mps.length() + room;
        let reach = body.reach_m + fastest * step_s;
        (room_mps[rank], fastest_mps[rank], reach_m[rank]) = (room, fastest, reach);
        all_held &= circles.get(rank).is_some_and(|circle| circle.holds(state.position_m, reach));
    }
    all_held
}

/// Is this rank in the list of those that were put, which is empty most often?
#[inline(always)]
fn is_among(put: &[u32], rank: usize) -> bool {
    !put.is_empty() && put.binary_search(&(rank as u32)).is_ok()
}

/// κ of a sub-step of this length, of a body whose velocity belongs to so long before.
#[inline(always)]
pub(crate) fn kick_s(behind_s: f64, h: f64) -> f64 {
    behind_s.abs() + 0.5 * h
}

/// Makes room for the bodies of a model, of which this workspace knows nothing.
#[cold]
fn forget(model: &Model, work: &mut Workspace) {
    let count = model.ranked.len();
    // No heading is that one.
    refill(&mut work.headings_rad, count, f64::NAN);
    refill(&mut work.settled, count, false);
    refill(&mut work.moves, count, true);
    refill(&mut work.accelerations, count, Velocity::default());
    work.states.resize(count, BodyState::default());
    work.poses.resize(count, Pose::IDENTITY);
    work.reach_m.resize(count, 0.0);
    work.velocities.resize(count, Velocity::default());
    work.loads.resize(count, Wrench::default());
    work.inverses.clear();
    work.inverses.extend((0..count).map(|rank| model.ranked.rest(rank).inverse));
    refill(&mut work.behind_s, count, NOT_BEHIND);
    work.room_mps.resize(count, 0.0);
    work.fastest_mps.resize(count, 0.0);
    work.motions_by_rank.resize(count, Displacement::default());
    refill(&mut work.unheld_j, count, 0.0);
}

/// So many of one.
fn refill<T: Copy>(list: &mut Vec<T>, count: usize, one: T) {
    list.clear();
    list.resize(count, one);
}

/// No wrench of contacts yet, and nothing that was added up.
pub(crate) fn clear_results(model: &Model, work: &mut Workspace) {
    refill(&mut work.wrenches, model.ranked.len(), Wrench::default());
    work.sums = Sums::default();
}

/// Sums of all that a step leaves of its bodies: finite where all is, but for the largest of numbers.
// Asked at the end, without a branch for each.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sums {
    ways: Vec2,
    turns: Vec2,
    moment_nm: f64,
}

impl Sums {
    #[inline(always)]
    fn add(&mut self, state: &BodyState, push: &Wrench) {
        self.ways += state.position_m + state.velocity_mps + push.force_n;
        self.turns += vec2(state.heading_rad, state.yaw_rate_radps);
        self.moment_nm += push.moment_nm;
    }

    pub(crate) fn is_finite(&self) -> bool {
        self.ways.is_finite() && self.turns.is_finite() && self.moment_nm.is_finite()
    }
}

/// The bodies of islands as they were shown, where more than one sub-step moves them.
pub(crate) fn begin(work: &mut Workspace, h: f64) {
    let Workspace { island_bodies, shown, states, behind_s, .. } = work;
    for &rank in &*island_bodies {
        let rank = rank as usize;
        states[rank] = shown[rank];
        if behind_s[rank] < 0.0 {
            behind_s[rank] = 0.5 * h;
        }
    }
}

/// Bodies that touch each other begin with one κ, or what pushes one would not push the other: the least. Their
/// loads go with it. Says whether any has another than its own now.
#[inline(never)]
pub(crate) fn agree(model: &Model, work: &mut Workspace, islands: &[Island]) -> bool {
    let Workspace { found, own_patches, behind_s, .. } = work;
    let patches = &found.patches[own_patches.clone()];
    let mut changed = false;
    for island in islands {
        let own = &patches[island.patches_from(own_patches.start)];
        let floating = || {
            let both = own.iter().flat_map(|patch| [patch.candidate.a, patch.candidate.b]);
            both.map(|rank| rank as usize).filter(|&rank| !model.ranked[rank].is_fixed())
        };
        let least_s =
            floating().fold(f64::INFINITY, |least, rank| lesser(least, behind_s[rank].abs()));
        for rank in floating() {
            if behind_s[rank].abs() > least_s {
                (behind_s[rank], changed) = (least_s, true);
            }
        }
    }
    changed
}

/// v_free of the bodies of islands for a sub-step that is not the whole step, for which [`take`] has found it.
pub(crate) fn free_velocities(work: &mut Workspace, h: f64) {
    let Workspace { island_bodies, states, velocities, accelerations, behind_s, .. } = work;
    let count = states.len();
    let (velocities, accelerations) = (&mut velocities[..count], &accelerations[..count]);
    let behind_s = &behind_s[..count];
    for &rank in &*island_bodies {
        let rank = rank as usize;
        let kick_s = kick_s(behind_s[rank], h);
        velocities[rank] = free_velocity(&states[rank], accelerations[rank], kick_s);
    }
}

/// v_free = v + κ M⁻¹ W.
#[inline(always)]
fn free_velocity(state: &BodyState, (way, turn): Velocity, kick_s: f64) -> Velocity {
    (state.velocity_mps + way * kick_s, state.yaw_rate_radps + turn * kick_s)
}

/// Positions with the new velocities, and inverse masses as the bodies are turned then; and how far the
/// bodies went by the mean of the velocities before and after the solve: a force times it is that force's work
/// exactly. After it others of the step are to come.
pub(crate) fn advance_positions(model: &Model, work: &mut Workspace, h: f64, is_first: bool) {
    let Workspace { island_bodies, velocities, states, poses, headings_rad, .. } = work;
    let motions = &mut work.motions_by_rank;
    let alike = model.ranked.alike();
    let count = alike.len();
    let (states, velocities, motions) =
        (&mut states[..count], &velocities[..count], &mut motions[..count]);
    let (poses, headings_rad) = (&mut poses[..count], &mut headings_rad[..count]);
    let behind_s = &mut work.behind_s[..count];
    for &rank in &*island_bodies {
        let rank = rank as usize;
        let (state, motion, pose) = (&mut states[rank], &mut motions[rank], &mut poses[rank]);
        let so_far = if is_first { Displacement::default() } else { *motion };
        let kick_s = kick_s(behind_s[rank], h);
        behind_s[rank] = 0.5 * h;
        *motion = moved_on(so_far, state.velocity(), velocities[rank], kick_s);
        move_body(state, velocities[rank], h);
        pose.position_m = state.position_m;
        if !alike[rank] {
            turn_with(model.ranked.rest(rank), (state, pose), &mut work.inverses[rank], h);
            let load = &work.loads[rank];
            work.accelerations[rank] = work.inverses[rank].response(load.force_n, load.moment_nm);
            headings_rad[rank] = state.heading_rad;
        } else if state.yaw_rate_radps != 0.0 {
            headings_rad[rank] = state.heading_rad;
            pose.rotation = Rotation::from_angle(state.heading_rad);
        }
    }
    (work.jumps, work.puts) = (false, false);
}

/// The same at the end of the step: what there is of the bodies then is a result, and nothing asks for their poses
/// any more.
pub(crate) fn arrive(model: &Model, work: &mut Workspace, h: f64, is_first: bool) {
    let Workspace { island_bodies, velocities, states, motions_by_rank, .. } = work;
    let Workspace { wrenches, states_after, motions, sums, .. } = work;
    let alike = model.ranked.alike();
    let count = alike.len();
    let (states, velocities, motions_by_rank) =
        (&states[..count], &velocities[..count], &motions_by_rank[..count]);
    let (wrenches, states_after) = (&wrenches[..count], &mut states_after[..count]);
    let (motions, id_of) = (&mut motions[..count], &model.id_of[..count]);
    let behind_s = &mut work.behind_s[..count];
    let mut summed = *sums;
    for &rank in &*island_bodies {
        let rank = rank as usize;
        let (id, mut state) = (id_of[rank].0 as usize, states[rank]);
        let so_far = if is_first { Displacement::default() } else { motions_by_rank[rank] };
        let kick_s = kick_s(behind_s[rank], h);
        behind_s[rank] = 0.5 * h;
        motions[id] = moved_on(so_far, state.velocity(), velocities[rank], kick_s);
        move_body(&mut state, velocities[rank], h);
        if !alike[rank] {
            // Turned for the momentum's sake: so the next step need not.
            let (pose, inverse) = (&mut work.poses[rank], &mut work.inverses[rank]);
            turn_with(model.ranked.rest(rank), (&mut state, pose), inverse, h);
            work.headings_rad[rank] = state.heading_rad;
        }
        summed.add(&state, &wrenches[id]);
        states_after[id] = state;
    }
    *sums = summed;
}

/// How far a body went, with a sub-step from one velocity to the other, for as long as forces act in it: for their
/// works' sake.
#[inline(always)]
fn moved_on(so_far: Displacement, before: Velocity, after: Velocity, kick_s: f64) -> Displacement {
    let ((from_mps, from_radps), (to_mps, to_radps)) = (before, after);
    Displacement {
        translation_m: so_far.translation_m + (from_mps + to_mps) * (0.5 * kick_s),
        rotation_rad: so_far.rotation_rad + (from_radps + to_radps) * (0.5 * kick_s),
    }
}

/// Takes a body to where it comes to with this velocity.
#[inline(always)]
fn move_body(state: &mut BodyState, velocity: Velocity, h: f64) {
    (state.velocity_mps, state.yaw_rate_radps) = velocity;
    state.position_m += state.velocity_mps * h;
    state.heading_rad += state.yaw_rate_radps * h;
}

/// Turns pose, momentum and inverse mass of a body that moved.
fn turn_with(
    body: &Rest,
    (state, pose): (&mut BodyState, &mut Pose),
    inverse: &mut InverseMatrix,
    h: f64,
) {
    let before = core::mem::replace(&mut pose.rotation, Rotation::from_angle(state.heading_rad));
    turn_masses(body, state, (before, pose.rotation), h);
    *inverse = body.inverse.turned(pose.rotation);
}

/// The momentum of a body whose mass differs between surge and sway turns with it.
fn turn_masses(body: &Rest, state: &mut BodyState, (before, after): (Rotation, Rotation), h: f64) {
    if let Some(turns) = &body.turns {
        turns.turn(state, before, after, h);
    }
}

/// Bodies that nothing is near: one step by their loads. Of what is fixed, where it is then.
#[inline(never)]
pub(crate) fn drift_apart(model: &Model, work: &mut Workspace, step_s: f64) {
    if work.all_meet {
        return;
    }
    let Workspace { active, in_island, shown, accelerations, motions_by_rank, poses, .. } = work;
    let Workspace { wrenches, states_after, motions, sums, states, moves, behind_s, .. } = work;
    let in_island = &in_island[..model.ranked.len()];
    for &rank in &*active {
        let rank = rank as usize;
        if in_island[rank] {
            continue;
        }
        let (id, mut state) = (model.id_of[rank].0 as usize, shown[rank]);
        motions[id] = if model.ranked[rank].is_fixed() {
            if moves[rank] {
                state = states[rank];
            }
            motions_by_rank[rank]
        } else {
            let body = model.ranked.rest(rank);
            let kick_s = kick_s(behind_s[rank], step_s);
            behind_s[rank] = 0.5 * step_s;
            drift(body, &mut state, accelerations[rank], poses[rank].rotation, (step_s, kick_s))
        };
        sums.add(&state, &wrenches[id]);
        states_after[id] = state;
    }
}

/// One step of a body by its acceleration alone, and how far it went.
fn drift(
    body: &Rest,
    state: &mut BodyState,
    (way, turn): Velocity,
    before: Rotation,
    (step_s, kick_s): (f64, f64),
) -> Displacement {
    let (dv, dr) = (way * kick_s, turn * kick_s);
    let motion = Displacement {
        translation_m: (state.velocity_mps + dv * 0.5) * kick_s,
        rotation_rad: (state.yaw_rate_radps + 0.5 * dr) * kick_s,
    };
    let velocity = (state.velocity_mps + dv, state.yaw_rate_radps + dr);
    move_body(state, velocity, step_s);
    if body.turns.is_some() {
        turn_masses(body, state, (before, Rotation::from_angle(state.heading_rad)), step_s);
    }
    motion
}
