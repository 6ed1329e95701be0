//! The bodies of a step: what they begin with, and how they move.

use alloc::vec::Vec;
use core::ops::Range;

use crate::admit::{Came, admit_call, admit_loads, admit_states, is_sound, tell_of_jumps};
use crate::error::StepError;
use crate::mass::InverseMatrix;
use crate::memory::Memory;
use crate::model::Model;
use crate::ranked::Rest;
use crate::report::{Motion, Wrench};
use crate::state::{BodyState, Velocity};
use crate::vec2::{Pose, Rotation, Vec2, vec2};
use crate::workspace::Workspace;

/// How many bodies are taken at once: what one pass over them leaves is near the processor still in the next.
const AT_ONCE: usize = 64;

/// Stage 1: admits what the host gave, and finds what loads alone do to each body that floats, and the room each may
/// need in the step; but for those that stand as they stood at the last step, as quays and fenders on them do: these
/// are left as they are. `work.active` are the others. Whether all are still within their circles in the list of
/// those that are near.
///
/// # Errors
/// What is not sound; nothing but what stages work with has changed then.
pub(crate) fn take(
    model: &Model,
    memory: &Memory,
    work: &mut Workspace,
    (states, loads): (&[BodyState], &[Wrench]),
    step_s: f64,
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
        all_held &= take_loads(model, work, loads, first, step_s);
    }
    // Not before all states are sound: these are results.
    if is_new {
        work.states_after.clear();
        work.motions.resize(count, Motion::default());
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
    loads: &[Wrench],
    first: usize,
    step_s: f64,
) -> bool {
    let ranked = model.ranked.bodies();
    let count = ranked.len();
    let Workspace { active, shown, moves, velocities, loads: own, inverses, .. } = work;
    let Workspace { accelerations, motions_by_rank, moving_walls, states, .. } = work;
    let Workspace { room_mps, fastest_mps, reach_m, .. } = work;
    // Of one length, so that it is asked for once.
    let (shown, velocities) = (&shown[..count], &mut velocities[..count]);
    let accelerations = &mut accelerations[..count];
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
            velocities[rank] = state.velocity();
            motions_by_rank[rank] = Motion::default();
            if moves[rank] {
                moving_walls.push((rank as u32, *state));
                // Where it comes to, unless islands take it along: where nothing is near.
                let (velocity, mut alone) = (state.velocity(), *state);
                motions_by_rank[rank] = moved_on(Motion::default(), velocity, velocity, step_s);
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
            velocities[rank] = free_velocity(state, (way, turn), step_s);
            room += (way.length() + turn.abs() * body.reach_m) * step_s;
        }
        let fastest = state.velocity_mps.length() + room;
        let reach = body.reach_m + fastest * step_s;
        (room_mps[rank], fastest_mps[rank], reach_m[rank]) = (room, fastest, reach);
        all_held &= circles.get(rank).is_some_and(|circle| circle.holds(state.position_m, reach));
    }
    all_held
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
    work.room_mps.resize(count, 0.0);
    work.fastest_mps.resize(count, 0.0);
    work.motions_by_rank.resize(count, Motion::default());
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
pub(crate) fn begin(work: &mut Workspace) {
    let Workspace { island_bodies, shown, states, .. } = work;
    for &rank in &*island_bodies {
        states[rank as usize] = shown[rank as usize];
    }
}

/// v_free of the bodies of islands for a sub-step that is not the whole step, for which [`take`] has found it.
pub(crate) fn free_velocities(work: &mut Workspace, h: f64) {
    let Workspace { island_bodies, states, velocities, accelerations, .. } = work;
    let count = states.len();
    let (velocities, accelerations) = (&mut velocities[..count], &accelerations[..count]);
    for &rank in &*island_bodies {
        let rank = rank as usize;
        velocities[rank] = free_velocity(&states[rank], accelerations[rank], h);
    }
}

/// v_free = v + h M⁻¹ W.
#[inline(always)]
fn free_velocity(state: &BodyState, (way, turn): Velocity, h: f64) -> Velocity {
    (state.velocity_mps + way * h, state.yaw_rate_radps + turn * h)
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
    for &rank in &*island_bodies {
        let rank = rank as usize;
        let (state, motion, pose) = (&mut states[rank], &mut motions[rank], &mut poses[rank]);
        let so_far = if is_first { Motion::default() } else { *motion };
        *motion = moved_on(so_far, state.velocity(), velocities[rank], h);
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
    let mut summed = *sums;
    for &rank in &*island_bodies {
        let rank = rank as usize;
        let (id, mut state) = (id_of[rank].0 as usize, states[rank]);
        let so_far = if is_first { Motion::default() } else { motions_by_rank[rank] };
        motions[id] = moved_on(so_far, state.velocity(), velocities[rank], h);
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

/// How far a body went, with a sub-step from one velocity to the other.
#[inline(always)]
fn moved_on(so_far: Motion, before: Velocity, after: Velocity, h: f64) -> Motion {
    let ((from_mps, from_radps), (to_mps, to_radps)) = (before, after);
    Motion {
        way_m: so_far.way_m + (from_mps + to_mps) * (0.5 * h),
        turn_rad: so_far.turn_rad + (from_radps + to_radps) * (0.5 * h),
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
    let Workspace { wrenches, states_after, motions, sums, states, moves, .. } = work;
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
            drift(body, &mut state, accelerations[rank], poses[rank].rotation, step_s)
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
    step_s: f64,
) -> Motion {
    let (dv, dr) = (way * step_s, turn * step_s);
    let motion = Motion {
        way_m: (state.velocity_mps + dv * 0.5) * step_s,
        turn_rad: (state.yaw_rate_radps + 0.5 * dr) * step_s,
    };
    let velocity = (state.velocity_mps + dv, state.yaw_rate_radps + dr);
    move_body(state, velocity, step_s);
    if body.turns.is_some() {
        turn_masses(body, state, (before, Rotation::from_angle(state.heading_rad)), step_s);
    }
    motion
}
