//! The bodies of a step: what they begin with, and how they move.

use crate::mass::InverseMatrix;
use crate::model::Model;
use crate::report::{Motion, Wrench};
use crate::state::{BodyState, Velocity};
use crate::vec2::Rotation;
use crate::workspace::Workspace;

/// Loads and earth-fixed inverse masses by rank, the room each body may need in the step, and no wrench of
/// contacts yet. Of bodies that stand as they stood nothing changes.
pub(crate) fn take_loads(model: &Model, work: &mut Workspace, loads: &[Wrench], step_s: f64) {
    let count = model.ranked.len();
    make_room(work, count);
    work.moving_walls.clear();
    work.wrenches.clear();
    work.wrenches.resize(count, Wrench::default());
    let Workspace { active, states, poses, moves, before, loads: own, inverses, .. } = work;
    let Workspace { motions_by_rank, room_mps, fastest_mps, reach_m, moving_walls, .. } = work;
    // Of one length, so that it is asked for once.
    let (states, poses, moves) = (&states[..count], &poses[..count], &mut moves[..count]);
    let (before, own, inverses) = (&mut before[..count], &mut own[..count], &mut inverses[..count]);
    let (motions, room_mps) = (&mut motions_by_rank[..count], &mut room_mps[..count]);
    let (fastest_mps, reach_m) = (&mut fastest_mps[..count], &mut reach_m[..count]);
    let (ranked, id_of) = (&model.ranked[..count], &model.id_of[..count]);
    for &rank in &*active {
        let rank = rank as usize;
        let (body, state) = (&ranked[rank], &states[rank]);
        let (mut load, mut inverse) = (Wrench::default(), InverseMatrix::default());
        let mut room = state.yaw_rate_radps.abs() * body.reach_m;
        moves[rank] = !(body.is_fixed() && state.is_at_rest());
        if !body.is_fixed() {
            load = loads[id_of[rank].0 as usize];
            inverse = body.inverse.turned(poses[rank].rotation);
            let (dv, dr) = inverse.response(load.force_n * step_s, load.moment_nm * step_s);
            room += dv.length() + dr.abs() * body.reach_m;
        } else if moves[rank] {
            moving_walls.push((rank as u32, *state));
        }
        let fastest = state.velocity_mps.length() + room;
        before[rank] = state.velocity();
        own[rank] = load;
        inverses[rank] = inverse;
        motions[rank] = Motion::default();
        room_mps[rank] = room;
        fastest_mps[rank] = fastest;
        reach_m[rank] += fastest * step_s;
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
    work.room_mps.resize(count, 0.0);
    work.fastest_mps.resize(count, 0.0);
    work.motions_by_rank.resize(count, Motion::default());
    work.states_after.resize(count, BodyState::default());
    work.motions.resize(count, Motion::default());
}

/// v_free = v + h M⁻¹ W. Takes note of v.
pub(crate) fn free_velocities(work: &mut Workspace, h: f64) {
    let Workspace { island_bodies, states, before, loads, inverses, .. } = work;
    for &rank in &*island_bodies {
        let rank = rank as usize;
        let (state, load) = (&mut states[rank], &loads[rank]);
        before[rank] = state.velocity();
        let (dv, dr) = inverses[rank].response(load.force_n * h, load.moment_nm * h);
        state.velocity_mps += dv;
        state.yaw_rate_radps += dr;
    }
}

/// Positions with the new velocities, and inverse masses as the bodies are turned then; and how far the
/// bodies went by the mean of the velocities before and after the solve: a force times it is that force's work
/// exactly.
pub(crate) fn advance_positions(model: &Model, work: &mut Workspace, h: f64) {
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
pub(crate) fn drift_apart(model: &Model, work: &mut Workspace, step_s: f64) {
    for &rank in &work.active {
        let rank = rank as usize;
        let body = &model.ranked[rank];
        if work.in_island[rank] || body.is_fixed() {
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
