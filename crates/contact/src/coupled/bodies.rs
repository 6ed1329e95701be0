//! The bodies of a step: what they begin with, and how they move.

use crate::mass::InverseMatrix;
use crate::model::Model;
use crate::ranked::Rest;
use crate::report::{Motion, Wrench};
use crate::state::{BodyState, Velocity};
use crate::vec2::Rotation;
use crate::workspace::Workspace;

/// Of bodies of which this workspace knows nothing: inverse masses in their attitudes, and no loads on them.
#[cold]
pub(crate) fn take_all(model: &Model, work: &mut Workspace) {
    make_room(work, model.ranked.len());
    for rank in 0..model.ranked.len() {
        let inverse = &model.ranked.rest(rank).inverse;
        work.inverses[rank] = inverse.turned(work.poses[rank].rotation);
        work.accelerations[rank] = Velocity::default();
    }
}

/// What loads alone do to each body that floats, the room each may need in the step, and no wrench of contacts
/// yet. Of bodies that stand as they stood nothing changes.
#[inline(never)]
pub(crate) fn take_loads(model: &Model, work: &mut Workspace, loads: &[Wrench], step_s: f64) {
    let ranked = model.ranked.bodies();
    let count = ranked.len();
    work.moving_walls.clear();
    work.wrenches.clear();
    work.wrenches.resize(count, Wrench::default());
    let Workspace { active, states, moves, before, loads: own, inverses, accelerations, .. } = work;
    let Workspace { motions_by_rank, room_mps, fastest_mps, reach_m, moving_walls, .. } = work;
    // Of one length, so that it is asked for once.
    let (states, moves, before) = (&states[..count], &mut moves[..count], &mut before[..count]);
    let (own, inverses) = (&mut own[..count], &inverses[..count]);
    let (motions, accelerations) = (&mut motions_by_rank[..count], &mut accelerations[..count]);
    let (fastest_mps, room_mps) = (&mut fastest_mps[..count], &mut room_mps[..count]);
    let (reach_m, id_of) = (&mut reach_m[..count], &model.id_of[..count]);
    for &rank in &*active {
        let rank = rank as usize;
        let (body, state) = (ranked.of(rank), &states[rank]);
        let mut room = state.yaw_rate_radps.abs() * body.reach_m;
        if body.is_fixed() {
            moves[rank] = !state.is_at_rest();
            before[rank] = state.velocity();
            if moves[rank] {
                moving_walls.push((rank as u32, *state));
            }
        } else {
            moves[rank] = true;
            let load = &loads[id_of[rank].0 as usize];
            let (way, turn) = if body.is_alike {
                (load.force_n * body.inverse_mass, load.moment_nm * body.inverse_inertia)
            } else {
                own[rank] = *load;
                inverses[rank].response(load.force_n, load.moment_nm)
            };
            accelerations[rank] = (way, turn);
            room += (way.length() + turn.abs() * body.reach_m) * step_s;
        }
        motions[rank] = Motion::default();
        room_mps[rank] = room;
        fastest_mps[rank] = state.velocity_mps.length() + room;
        reach_m[rank] = body.reach_m + fastest_mps[rank] * step_s;
    }
}

/// Makes room for so many bodies.
fn make_room(work: &mut Workspace, count: usize) {
    if work.motions.len() == count {
        return;
    }
    work.moves.resize(count, false);
    work.before.resize(count, Velocity::default());
    work.loads.resize(count, Wrench::default());
    work.inverses.resize(count, InverseMatrix::default());
    work.accelerations.resize(count, Velocity::default());
    work.room_mps.resize(count, 0.0);
    work.fastest_mps.resize(count, 0.0);
    work.motions_by_rank.resize(count, Motion::default());
    work.states_after.resize(count, BodyState::default());
    work.motions.resize(count, Motion::default());
}

/// v_free = v + h M⁻¹ W. Takes note of v.
pub(crate) fn free_velocities(work: &mut Workspace, h: f64) {
    let Workspace { island_bodies, states, before, accelerations, .. } = work;
    let count = states.len();
    let (before, accelerations) = (&mut before[..count], &accelerations[..count]);
    for &rank in &*island_bodies {
        let rank = rank as usize;
        let state = &mut states[rank];
        before[rank] = state.velocity();
        let (way, turn) = accelerations[rank];
        state.velocity_mps += way * h;
        state.yaw_rate_radps += turn * h;
    }
}

/// Positions with the new velocities, and inverse masses as the bodies are turned then; and how far the
/// bodies went by the mean of the velocities before and after the solve: a force times it is that force's work
/// exactly.
pub(crate) fn advance_positions(model: &Model, work: &mut Workspace, h: f64) {
    let Workspace { island_bodies, before, states, poses, headings_rad, motions_by_rank, .. } =
        work;
    let alike = model.ranked.alike();
    let count = alike.len();
    let (states, before, motions) =
        (&mut states[..count], &before[..count], &mut motions_by_rank[..count]);
    let (poses, headings_rad) = (&mut poses[..count], &mut headings_rad[..count]);
    for &rank in &*island_bodies {
        let rank = rank as usize;
        let (velocity_mps, yaw_rate_radps) = before[rank];
        let (state, motion, pose) = (&mut states[rank], &mut motions[rank], &mut poses[rank]);
        motion.way_m += (velocity_mps + state.velocity_mps) * (0.5 * h);
        motion.turn_rad += (yaw_rate_radps + state.yaw_rate_radps) * (0.5 * h);
        move_body(state, h);
        pose.position_m = state.position_m;
        if !alike[rank] {
            let rest = model.ranked.rest(rank);
            let (inverses, accelerations) = (&mut work.inverses, &mut work.accelerations);
            let before =
                core::mem::replace(&mut pose.rotation, Rotation::from_angle(state.heading_rad));
            turn_masses(rest, state, (before, pose.rotation), h);
            inverses[rank] = rest.inverse.turned(pose.rotation);
            let load = &work.loads[rank];
            accelerations[rank] = inverses[rank].response(load.force_n, load.moment_nm);
            headings_rad[rank] = state.heading_rad;
        } else if state.yaw_rate_radps != 0.0 {
            headings_rad[rank] = state.heading_rad;
            pose.rotation = Rotation::from_angle(state.heading_rad);
        }
    }
    work.jumps = false;
}

#[inline(always)]
fn move_body(state: &mut BodyState, h: f64) {
    state.position_m += state.velocity_mps * h;
    state.heading_rad += state.yaw_rate_radps * h;
}

/// The momentum of a body whose mass differs between surge and sway turns with it.
fn turn_masses(body: &Rest, state: &mut BodyState, (before, after): (Rotation, Rotation), h: f64) {
    if let Some(turns) = &body.turns {
        turns.turn(state, before, after, h);
    }
}

/// Bodies that nothing is near: one step by their loads.
#[inline(never)]
pub(crate) fn drift_apart(model: &Model, work: &mut Workspace, step_s: f64) {
    let Workspace { active, in_island, states, accelerations, motions_by_rank, poses, .. } = work;
    let ranked = model.ranked.bodies();
    let count = ranked.len();
    let (states, in_island, accelerations) =
        (&mut states[..count], &in_island[..count], &accelerations[..count]);
    let (motions, poses) = (&mut motions_by_rank[..count], &poses[..count]);
    for &rank in &*active {
        let rank = rank as usize;
        if in_island[rank] || ranked.of(rank).is_fixed() {
            continue;
        }
        let (way, turn) = accelerations[rank];
        let (dv, dr) = (way * step_s, turn * step_s);
        let (state, motion) = (&mut states[rank], &mut motions[rank]);
        motion.way_m = (state.velocity_mps + dv * 0.5) * step_s;
        motion.turn_rad = (state.yaw_rate_radps + 0.5 * dr) * step_s;
        state.velocity_mps += dv;
        state.yaw_rate_radps += dr;
        move_body(state, step_s);
        let rest = model.ranked.rest(rank);
        if rest.turns.is_some() {
            let after = Rotation::from_angle(state.heading_rad);
            turn_masses(rest, state, (poses[rank].rotation, after), step_s);
        }
    }
}
