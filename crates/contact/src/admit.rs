//! Stage 1, admit: the host's input, checked before anything changes.

use crate::error::StepError;
use crate::memory::Memory;
use crate::model::Model;
use crate::report::{Event, EventKind, Wrench};
use crate::state::BodyState;
use crate::vec2::{Pose, Rotation, Vec2};
use crate::workspace::Workspace;

/// Largest size of a position, a velocity, a load and a time step [m, m/s, rad/s, rad, N, s]. Beyond these a
/// number is a host's mistake, and forces could overflow.
const FURTHEST_M: f64 = 1e9;
const FASTEST_MPS: f64 = 1e6;
const FASTEST_TURN_RADPS: f64 = 1e3;
const LARGEST_HEADING_RAD: f64 = 1e9;
pub(crate) const LARGEST_LOAD: f64 = 1e15;
pub(crate) const LONGEST_STEP_S: f64 = 1e6;
pub(crate) const SHORTEST_STEP_S: f64 = 1e-9;

/// Checks what the host gave, but for the states themselves: [`place_active`] does that.
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
    if !(SHORTEST_STEP_S..=LONGEST_STEP_S).contains(&step_s) {
        return Err(StepError::BadTimeStep { step_s });
    }
    Ok(())
}

/// Checks all that the host gave.
pub(crate) fn admit(
    model: &Model,
    memory: &Memory,
    states: &[BodyState],
    step_s: f64,
) -> Result<(), StepError> {
    admit_call(model, memory, states, step_s)?;
    admit_states(model, states)
}

/// Checks the states of all bodies.
fn admit_states(model: &Model, states: &[BodyState]) -> Result<(), StepError> {
    match states.iter().position(|state| !is_sound(state)) {
        None => Ok(()),
        Some(index) => Err(unsound(model, index, &states[index])),
    }
}

impl Model {
    /// Would a step take this state of the body of that index? For hosts that show their bodies one by one.
    ///
    /// # Errors
    /// [`StepError::BadState`], naming body and field.
    ///
    /// # Panics
    /// Where the model has no such body.
    pub fn check_state(&self, body: usize, state: &BodyState) -> Result<(), StepError> {
        if is_sound(state) { Ok(()) } else { Err(unsound(self, body, state)) }
    }

    /// As [`Model::check_state`], of a load.
    ///
    /// # Errors
    /// [`StepError::BadState`], naming body and field.
    ///
    /// # Panics
    /// Where the model has no such body.
    pub fn check_load(&self, body: usize, load: &Wrench) -> Result<(), StepError> {
        if is_sound_load(load) { Ok(()) } else { Err(unsound_load(self, body, load)) }
    }
}

/// Is every number of a state finite and within its bounds?
#[inline]
fn is_sound(state: &BodyState) -> bool {
    // Not a number is within no bounds. All are compared, without a branch for each.
    (state.position_m.x.abs() <= FURTHEST_M)
        & (state.position_m.y.abs() <= FURTHEST_M)
        & (state.velocity_mps.x.abs() <= FASTEST_MPS)
        & (state.velocity_mps.y.abs() <= FASTEST_MPS)
        & (state.heading_rad.abs() <= LARGEST_HEADING_RAD)
        & (state.yaw_rate_radps.abs() <= FASTEST_TURN_RADPS)
}

/// Names the first field of a state that is not sound.
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
    let within = |value: f64, largest: f64| value.abs() <= largest;
    let bad = fields.into_iter().find(|&(_, value, largest)| !within(value, largest));
    let (field, value, _) = bad.expect("one of the fields is not sound");
    StepError::BadState { body: model.bodies()[index].name.clone(), field, value }
}

/// Checks the loads that the coupled method is given.
pub(crate) fn admit_loads(
    model: &Model,
    states: &[BodyState],
    loads: &[Wrench],
) -> Result<(), StepError> {
    // All are asked, without a branch for each.
    let all_sound = loads.iter().fold(true, |sound, load| sound & is_sound_load(load));
    if loads.len() == model.bodies().len() && all_sound {
        return Ok(());
    }
    // A state that is not sound is told of first.
    admit_states(model, states)?;
    Err(match loads.iter().position(|load| !is_sound_load(load)) {
        Some(index) if loads.len() == model.bodies().len() => {
            unsound_load(model, index, &loads[index])
        }
        _ => StepError::WrongCount { bodies: model.bodies().len(), states: loads.len() },
    })
}

/// Is every part of a load finite and within its bounds?
#[inline]
fn is_sound_load(load: &Wrench) -> bool {
    (load.force_n.x.abs() <= LARGEST_LOAD)
        & (load.force_n.y.abs() <= LARGEST_LOAD)
        & (load.moment_nm.abs() <= LARGEST_LOAD)
}

/// Names the first part of a load that is not finite or too large.
#[cold]
fn unsound_load(model: &Model, index: usize, load: &Wrench) -> StepError {
    let fields = [
        ("north load", load.force_n.x),
        ("east load", load.force_n.y),
        ("moment of the load", load.moment_nm),
    ];
    let within = |value: f64| value.abs() <= LARGEST_LOAD;
    let bad = fields.into_iter().find(|&(_, value)| !within(value));
    let (field, value) = bad.expect("one of the fields is not sound");
    StepError::BadState { body: model.bodies()[index].name.clone(), field, value }
}

/// Puts states and poses in the order of the ranks, and finds bodies that jumped.
pub(crate) fn place(model: &Model, memory: &Memory, work: &mut Workspace, states: &[BodyState]) {
    let count = model.ranked.len();
    make_room(work, count);
    let Workspace { states: own, poses, headings_rad, teleported, active, reach_m, .. } =
        &mut *work;
    active.clear();
    active.extend(0..count as u32);
    let mut jumps = false;
    // In one pass: the bodies of a large model are far from the processor.
    let of_rank = own.iter_mut().zip(poses).zip(headings_rad).zip(teleported).zip(reach_m);
    for (rank, ((((own, pose), heading_rad), teleported), reach_m)) in of_rank.enumerate() {
        let body = &model.ranked[rank];
        let state = states[model.id_of[rank].0 as usize];
        (*own, *reach_m) = (state, body.reach_m);
        put(pose, heading_rad, &state);
        *teleported = jumped(memory, rank, &state, body.radius_m);
        jumps |= *teleported;
    }
    tell_of_jumps(model, work, jumps);
}

/// Admits and places the bodies but those that stand as they stood at the last step, as quays and fenders on them
/// do: these are left as they are. `work.active` are the others. Whether the workspace knew the bodies: else all
/// that it has of them but states and poses is of others.
///
/// # Errors
/// A state that is not sound; nothing but what stages work with has changed then.
#[inline(never)]
pub(crate) fn place_active(
    model: &Model,
    memory: &Memory,
    work: &mut Workspace,
    states: &[BodyState],
) -> Result<bool, StepError> {
    let known = work.advanced.take() == Some(model.fingerprint);
    if !known || memory.last_states.len() != model.ranked.len() {
        admit_states(model, states)?;
        place(model, memory, work, states);
        return Ok(false);
    }
    let ranked = model.ranked.bodies();
    let count = ranked.len();
    let Workspace { states: own, poses, headings_rad, teleported, active, moves, inverses, .. } =
        &mut *work;
    // Of one length, so that it is asked for once.
    let (own, last_states) = (&mut own[..count], &memory.last_states[..count]);
    let (poses, headings_rad) = (&mut poses[..count], &mut headings_rad[..count]);
    let (teleported, moves) = (&mut teleported[..count], &moves[..count]);
    let id_of = &model.id_of[..count];
    active.clear();
    let mut jumps = false;
    for rank in 0..count {
        let state = &states[id_of[rank].0 as usize];
        if !moves[rank] && stands(state, [&own[rank], &last_states[rank]], teleported[rank]) {
            continue;
        }
        if !is_sound(state) {
            return admit_states(model, states).map(|()| false);
        }
        active.push(rank as u32);
        let body = ranked.of(rank);
        own[rank] = *state;
        poses[rank].position_m = state.position_m;
        if state.heading_rad.to_bits() != headings_rad[rank].to_bits() {
            headings_rad[rank] = state.heading_rad;
            poses[rank].rotation = Rotation::from_angle(state.heading_rad);
            if !body.is_alike {
                inverses[rank] = model.ranked.rest(rank).inverse.turned(poses[rank].rotation);
            }
        }
        teleported[rank] = false;
        if jumped(memory, rank, state, body.radius_m) {
            (teleported[rank], jumps) = (true, true);
        }
    }
    tell_of_jumps(model, work, jumps);
    Ok(true)
}

/// Does a body stand as it stood, and did not jump there, when both the workspace and the memory saw it last?
#[inline(always)]
fn stands(state: &BodyState, [own, last]: [&BodyState; 2], teleported: bool) -> bool {
    // All is compared, without a branch for each.
    own.apart(state) | last.apart(state) | u64::from(teleported) == 0
}

/// The pose of a body. What does not turn is spared its sine and cosine.
#[inline(always)]
fn put(pose: &mut Pose, heading_rad: &mut f64, state: &BodyState) {
    pose.position_m = state.position_m;
    if state.heading_rad.to_bits() != heading_rad.to_bits() {
        *heading_rad = state.heading_rad;
        pose.rotation = Rotation::from_angle(state.heading_rad);
    }
}

/// Makes room for so many bodies, of which nothing is known.
#[cold]
fn make_room(work: &mut Workspace, count: usize) {
    if work.headings_rad.len() != count {
        work.headings_rad.clear();
        work.headings_rad.resize(count, 0.0);
        work.poses.clear();
        work.poses.resize(count, Pose::IDENTITY);
    }
    work.states.resize(count, BodyState::default());
    work.teleported.resize(count, false);
    work.reach_m.resize(count, 0.0);
}

/// Whether bodies jumped, and the events of it.
fn tell_of_jumps(model: &Model, work: &mut Workspace, jumps: bool) {
    work.jumps = jumps;
    work.events.clear();
    if jumps {
        for (&id, &teleported) in model.id_of.iter().zip(&work.teleported) {
            if teleported {
                work.events.push(Event { bodies: [id, id], kind: EventKind::Teleported });
            }
        }
    }
}

/// Takes note of the states at the start of a step, for the next one.
pub(crate) fn remember_states(
    model: &Model,
    memory: &mut Memory,
    active: &[u32],
    states: &[BodyState],
) {
    if memory.last_states.len() != model.id_of.len() {
        memory.last_states.clear();
        memory.last_states.extend(model.id_of.iter().map(|id| states[id.0 as usize]));
        return;
    }
    let count = model.id_of.len();
    let (last_states, id_of) = (&mut memory.last_states[..count], &model.id_of[..count]);
    for &rank in active {
        last_states[rank as usize] = states[id_of[rank as usize].0 as usize];
    }
}

/// Did the body of this rank move by more than its two velocities explain? The allowance, a tenth of its size,
/// is for hosts whose integrators differ from ours.
#[inline(always)]
fn jumped(memory: &Memory, rank: usize, now: &BodyState, radius_m: f64) -> bool {
    let Some(last) = memory.last_states.get(rank) else { return false };
    let moved = now.position_m - last.position_m;
    let mean = (now.velocity_mps + last.velocity_mps) * (0.5 * memory.last_step_s);
    let unexplained = moved - mean;
    // Most bodies are well within the second half of the allowance, and need no roots.
    let near_m = 0.09 * radius_m;
    unexplained.length_squared() > near_m * near_m
        && jumped_far(
            unexplained,
            now.velocity_mps - last.velocity_mps,
            memory.last_step_s,
            radius_m,
        )
}

/// The same of a body that moved by so much more than the mean of its two velocities explains.
#[cold]
fn jumped_far(unexplained_m: Vec2, change_mps: Vec2, step_s: f64, radius_m: f64) -> bool {
    unexplained_m.length() > change_mps.length() * step_s + 0.1 * radius_m
}
