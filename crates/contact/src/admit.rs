//! Stage 1, admit: the host's input, checked before anything changes.

use core::f64::consts::TAU;

use crate::error::StepError;
use crate::memory::Memory;
use crate::model::Model;
use crate::report::{Event, EventKind, Wrench};
use crate::state::BodyState;
use crate::vec2::{Pose, Rotation, Vec2};
use crate::workspace::Workspace;

/// Largest size of a position, a velocity, a load and a time step (m, m/s, rad/s, rad, N, s). Beyond these a
/// number is a host's mistake, and forces could overflow.
const FURTHEST_M: f64 = 1e9;
const FASTEST_MPS: f64 = 1e6;
const FASTEST_TURN_RADPS: f64 = 1e3;
const LARGEST_HEADING_RAD: f64 = 1e9;
pub(crate) const LARGEST_LOAD: f64 = 1e15;
pub(crate) const LONGEST_STEP_S: f64 = 1e6;
pub(crate) const SHORTEST_STEP_S: f64 = 1e-9;

/// Checks what the host gave, but for the states themselves: [`bodies::take`] does that.
///
/// [`bodies::take`]: crate::coupled::bodies::take
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
pub(crate) fn admit_states(model: &Model, states: &[BodyState]) -> Result<(), StepError> {
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
pub(crate) fn is_sound(state: &BodyState) -> bool {
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
    let Workspace { states: own, poses, headings_rad, teleported, put, reach_m, .. } = &mut *work;
    teleported.clear();
    // By the paper's method it does not matter how else a body came.
    put.clear();
    // In one pass: the bodies of a large model are far from the processor.
    let of_rank = own.iter_mut().zip(poses).zip(headings_rad).zip(reach_m);
    for (rank, (((own, pose), heading_rad), reach_m)) in of_rank.enumerate() {
        let body = &model.ranked[rank];
        let state = states[model.id_of[rank].0 as usize];
        (*own, *reach_m) = (state, body.reach_m);
        take_pose(pose, heading_rad, &state);
        if let Some(last) = memory.last_states.get(rank)
            && memory.came(rank, last, &state, body.radius_m) == Came::Jumped
        {
            teleported.push(rank as u32);
        }
    }
    tell_of_jumps(model, work);
}

/// The pose of a body. What does not turn is spared its sine and cosine.
#[inline(always)]
fn take_pose(pose: &mut Pose, heading_rad: &mut f64, state: &BodyState) {
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
    work.reach_m.resize(count, 0.0);
}

/// Whether bodies jumped, and the events of it.
pub(crate) fn tell_of_jumps(model: &Model, work: &mut Workspace) {
    (work.jumps, work.puts) = (!work.teleported.is_empty(), !work.put.is_empty());
    work.events.clear();
    for &rank in &work.teleported {
        let bodies = model.ids_of([rank, rank]);
        work.events.push(Event { bodies, kind: EventKind::Teleported });
    }
}

/// How a body came to where it is shown from where it was.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Came {
    /// As its velocities lead it.
    ByItself,
    /// Its host put it there: neither of its velocities leads it so far.
    Put,
    /// By so much more than its two velocities explain that nothing is as it was. The allowance, a tenth of its size,
    /// is for hosts whose integrators differ from ours.
    Jumped,
}

/// The smallest way of a body at rest that its host has put elsewhere (m): far from the chart's origin positions are
/// rounded.
const PUT_M: f64 = 1e-6;

/// How a body of this radius came to where it is shown, from `last`, so many seconds ago.
#[inline(always)]
pub(crate) fn came((last, step_s): (&BodyState, f64), now: &BodyState, radius_m: f64) -> Came {
    let translation_m = now.position_m - last.position_m;
    let unexplained_m = translation_m - (now.velocity_mps + last.velocity_mps) * (0.5 * step_s);
    let rotation_rad = now.heading_rad - last.heading_rad;
    // Most bodies are well within the second half of the allowance, and go as they move: that needs no roots.
    let near_m = 0.09 * radius_m;
    if unexplained_m.length_squared() <= near_m * near_m
        && moves_so_far((last, step_s), now, (translation_m, rotation_rad), radius_m)
    {
        return Came::ByItself;
    }
    came_far((last, step_s), now, (translation_m, unexplained_m, rotation_rad), radius_m)
}

/// May a body go and turn so far as it moves? Its velocity may turn round within a step.
#[inline(always)]
fn moves_so_far(
    (last, step_s): (&BodyState, f64),
    now: &BodyState,
    (translation_m, rotation_rad): (Vec2, f64),
    radius_m: f64,
) -> bool {
    let farthest = 4.0 * step_s * step_s;
    let speeds = last.velocity_mps.length_squared() + now.velocity_mps.length_squared();
    let turns = last.yaw_rate_radps * last.yaw_rate_radps + now.yaw_rate_radps * now.yaw_rate_radps;
    let too_far = translation_m.length_squared() - farthest * speeds;
    let turned_too_far = rotation_rad * rotation_rad - farthest * turns;
    too_far + turned_too_far * (radius_m * radius_m) <= PUT_M * PUT_M
}

/// The same of a body that went, or turned, far.
#[cold]
#[inline(never)]
fn came_far(
    (last, step_s): (&BodyState, f64),
    now: &BodyState,
    (translation_m, unexplained_m, rotation_rad): (Vec2, Vec2, f64),
    radius_m: f64,
) -> Came {
    let change_mps = now.velocity_mps - last.velocity_mps;
    if unexplained_m.length() > change_mps.length() * step_s + 0.1 * radius_m {
        return Came::Jumped;
    }
    // A host may count headings anew after a whole turn.
    let rotation_rad = rotation_rad - libm::rint(rotation_rad / TAU) * TAU;
    if moves_so_far((last, step_s), now, (translation_m, rotation_rad), radius_m) {
        Came::ByItself
    } else {
        Came::Put
    }
}
