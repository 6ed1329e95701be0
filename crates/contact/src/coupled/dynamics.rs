//! The bodies' dynamics in the coupled method: what a step begins with, and how bodies move.
//!
//! Sub-steps are a leapfrog: x⁺ = x + h v⁺ with v⁺ = v + κ M⁻¹ (W + contact). So v⁺ belongs to the middle of its
//! sub-step, v to the middle of the one before, and κ, the time between the two, is (h_before + h)/2. That is h as long as
//! all sub-steps have one length. At rest loads and contacts have the same κ and cancel, whatever the sub-steps.

use alloc::vec::Vec;

use crate::admit::{admit_call, admit_loads, admit_states, is_sound};
use crate::bodies::{Bodies, Displaced, PoseChange, set_pose};
use crate::candidates::Pairing;
use crate::coupled::island::{Group, Island};
use crate::coupled::motion::{Motion, kick_s};
use crate::coupled::sub_step::SubStep;
use crate::error::StepError;
use crate::mass::InverseMatrix;
use crate::memory::{Memory, NOT_BEHIND};
use crate::model::Model;
use crate::number::lesser;
use crate::patch::Patch;
use crate::ranked::Rest;
use crate::report::{Displacement, Wrench};
use crate::results::Results;
use crate::state::{BodyState, Velocity};
use crate::vec2::{Pose, Rotation};

/// What the coupled method knows of the bodies. Lists are by rank.
#[derive(Clone, Debug, Default)]
pub(crate) struct Dynamics {
    /// Layout of the model that all lists are valid for; `None` if the last step was not one of this method, or failed.
    pub(crate) layout: Option<u64>,
    /// Ranks of the fixed bodies with a velocity, such as lock gates.
    pub(crate) moving_fixed: Vec<u32>,
    pub(crate) motions: Vec<Motion>,
    /// M⁻¹, earth-fixed.
    pub(crate) inverses: Vec<InverseMatrix>,
    /// States at the start of the sub-step.
    pub(crate) states: Vec<BodyState>,
    /// Before the solve of a sub-step v_free, without contact; after it v⁺.
    pub(crate) velocities: Vec<Velocity>,
}

/// What the host gives for a step.
#[derive(Clone, Copy)]
pub(crate) struct HostInput<'a> {
    /// By id.
    pub(crate) states: &'a [BodyState],
    pub(crate) loads: &'a [Wrench],
    pub(crate) step_s: f64,
    /// Bodies have the velocities that the engine left them, which lag behind their positions.
    pub(crate) velocities_continue: bool,
}

impl Dynamics {
    pub(crate) fn invalidate(&mut self) {
        self.layout = None;
    }

    /// Stage 1: checks the host's input, places the bodies, and computes what loads alone do to them.
    ///
    /// Settled bodies, such as quays, are skipped while their state stays the same.
    ///
    /// # Errors
    /// Input that is not sound. Nothing that matters to a later step has changed then.
    pub(crate) fn begin(
        &mut self,
        model: &Model,
        memory: &Memory,
        input: &HostInput<'_>,
        bodies: &mut Bodies,
        displaced: &mut Displaced,
    ) -> Result<(), StepError> {
        admit_call(model, memory, input.states, input.step_s)?;
        admit_loads(model, input.states, input.loads)?;
        let count = model.ranked.len();
        if self.layout.take() != Some(model.layout) {
            self.forget(model);
            bodies.forget_poses(count);
        }
        self.moving_fixed.clear();
        displaced.clear();
        bodies.resize(count);
        let Dynamics { motions, inverses, states, velocities, moving_fixed, .. } = self;
        let Bodies { input: inputs, poses, headings_rad, reach_m, active } = bodies;
        // Slices of one known length, so that ranks are not bounds-checked.
        let (motions, inverses) = (&mut motions[..count], &mut inverses[..count]);
        let (states, velocities) = (&mut states[..count], &mut velocities[..count]);
        let (inputs, poses) = (&mut inputs[..count], &mut poses[..count]);
        let (headings_rad, reach_m) = (&mut headings_rad[..count], &mut reach_m[..count]);
        let id_of = &model.id_of[..count];
        for rank in 0..count {
            let id = id_of[rank].0 as usize;
            let (state, motion) = (&input.states[id], &mut motions[rank]);
            let last = memory.last_states.get(rank);
            let is_unchanged = || last.is_some_and(|last| last.apart(state) == 0);
            if motion.settled && inputs[rank].apart(state) == 0 && is_unchanged() {
                continue;
            }
            if !is_sound(state) {
                return admit_states(model, input.states);
            }
            active.push(rank as u32);
            (inputs[rank], states[rank]) = (*state, *state);
            let body = &model.ranked[rank];
            let pose = &mut poses[rank];
            if set_pose(pose, &mut headings_rad[rank], state) && !body.is_alike {
                inverses[rank] = model.ranked.rest(rank).inverse.turned(pose.rotation);
            }
            let change = last.map_or(PoseChange::Consistent, |last| {
                memory.pose_change(rank, last, state, body.radius_m)
            });
            displaced.add(rank as u32, change);
            if body.is_fixed() {
                *motion = Motion::of_fixed(body, state, is_unchanged());
                velocities[rank] = state.velocity();
                if motion.moves {
                    moving_fixed.push(rank as u32);
                }
            } else {
                let lag_s = match memory.behind_s.get(rank) {
                    _ if !input.velocities_continue => NOT_BEHIND,
                    // Before the first step velocities and positions belong to the same time.
                    None => 0.0,
                    Some(_) if change != PoseChange::Consistent => NOT_BEHIND,
                    Some(&last_s) => last_s,
                };
                let lag_s = if lag_s >= 0.0 { lag_s } else { -0.5 * input.step_s };
                *motion = Motion::of_floating(
                    body,
                    state,
                    &input.loads[id],
                    &inverses[rank],
                    lag_s,
                    input.step_s,
                );
                velocities[rank] =
                    free_velocity(state, motion.acceleration, kick_s(lag_s, input.step_s));
            }
            reach_m[rank] = body.reach_m + motion.fastest_mps * input.step_s;
        }
        Ok(())
    }

    /// Lists of the right length for a model of which nothing is known yet.
    #[cold]
    fn forget(&mut self, model: &Model) {
        let count = model.ranked.len();
        self.motions.clear();
        self.motions.resize(count, Motion::UNKNOWN);
        self.states.resize(count, BodyState::default());
        self.velocities.resize(count, Velocity::default());
        self.inverses.clear();
        self.inverses.extend((0..count).map(|rank| model.ranked.rest(rank).inverse));
    }

    /// Begins a sub-step of a group: v_free. `islands` are those of the group, if they have more than one floating body.
    pub(crate) fn begin_sub_step(
        &mut self,
        model: &Model,
        group: &Group,
        islands: Option<&[Island]>,
        patches: &[Patch],
        sub_step: SubStep,
    ) {
        if sub_step.is_first() && !sub_step.is_only() {
            for &rank in &group.bodies {
                let lag_s = &mut self.motions[rank as usize].velocity_lag_s;
                *lag_s = if *lag_s < 0.0 { 0.5 * sub_step.h } else { *lag_s };
            }
        }
        let changed = sub_step.is_first()
            && islands.is_some_and(|islands| self.agree(model, group, islands, patches));
        // `begin` has computed v_free for a sub-step that is the whole step.
        if changed || !sub_step.is_only() {
            self.free_velocities(group, sub_step.h);
        }
    }

    /// Gives bodies that touch each other the same κ, the least: otherwise a contact would push one and not the other.
    /// Their loads act for the same time. Returns whether any κ has changed.
    #[inline(never)]
    fn agree(
        &mut self,
        model: &Model,
        group: &Group,
        islands: &[Island],
        patches: &[Patch],
    ) -> bool {
        let motions = &mut self.motions;
        let mut changed = false;
        for island in islands {
            let own = &patches[island.patches_from(group.patches.start)];
            let floating = || {
                let both = own.iter().flat_map(|patch| [patch.candidate.a, patch.candidate.b]);
                both.map(|rank| rank as usize).filter(|&rank| !model.ranked[rank].is_fixed())
            };
            let least_s = floating().fold(f64::INFINITY, |least, rank| {
                lesser(least, motions[rank].velocity_lag_s.abs())
            });
            for rank in floating() {
                let lag_s = &mut motions[rank].velocity_lag_s;
                if lag_s.abs() > least_s {
                    (*lag_s, changed) = (least_s, true);
                }
            }
        }
        changed
    }

    /// v_free = v + κ M⁻¹ W of the bodies of a group.
    fn free_velocities(&mut self, group: &Group, h: f64) {
        for &rank in &group.bodies {
            let rank = rank as usize;
            let Motion { velocity_lag_s, acceleration, .. } = self.motions[rank];
            let kick_s = kick_s(velocity_lag_s, h);
            self.velocities[rank] = free_velocity(&self.states[rank], acceleration, kick_s);
        }
    }

    /// x⁺ = x + h v⁺ of the bodies of a group, with poses and inverse masses; and how far the bodies moved, by the mean
    /// velocity of the sub-step: a force times it is exactly that force's work.
    pub(crate) fn advance_positions(
        &mut self,
        model: &Model,
        group: &Group,
        bodies: &mut Bodies,
        results: &mut Results,
        sub_step: SubStep,
    ) {
        let (count, h) = (model.ranked.len(), sub_step.h);
        // Slices of one known length, so that each rank is bounds-checked once.
        let (states, motions) = (&mut self.states[..count], &mut self.motions[..count]);
        let (poses, velocities) = (&mut bodies.poses[..count], &self.velocities[..count]);
        let (id_of, displacements) = (&model.id_of[..count], &mut results.displacements[..count]);
        let states_after = &mut results.states_after[..count];
        for &rank in &group.bodies {
            let rank = rank as usize;
            let id = id_of[rank].0 as usize;
            let (state, motion, pose) = (&mut states[rank], &mut motions[rank], &mut poses[rank]);
            let (velocity, displacement) = (velocities[rank], &mut displacements[id]);
            let so_far = if sub_step.is_first() { Displacement::default() } else { *displacement };
            let kick_s = kick_s(motion.velocity_lag_s, h);
            motion.velocity_lag_s = 0.5 * h;
            *displacement = moved(so_far, state.velocity(), velocity, kick_s);
            move_body(state, velocity, h);
            if !model.ranked[rank].is_alike {
                pose.position_m = state.position_m;
                turn_with(model.ranked.rest(rank), state, pose, &mut self.inverses[rank], h);
                bodies.headings_rad[rank] = state.heading_rad;
                let Wrench { force_n, moment_nm } = motion.load;
                motion.acceleration = self.inverses[rank].response(force_n, moment_nm);
            } else if !sub_step.is_last() {
                set_pose(pose, &mut bodies.headings_rad[rank], state);
            }
            states_after[id] = *state;
        }
    }

    /// Marks the fixed bodies that a group has moved through the step. They may be in other groups as well.
    pub(crate) fn mark_moved_fixed(&mut self) {
        for &rank in &self.moving_fixed {
            let motion = &mut self.motions[rank as usize];
            motion.has_moved |= core::mem::take(&mut motion.in_island);
        }
    }

    /// Returns the moving fixed bodies of these candidates to their input states: each group moves them through the step.
    pub(crate) fn reset_moving_fixed(&mut self, bodies: &mut Bodies, candidates: &[Pairing]) {
        for &rank in &self.moving_fixed {
            let is_of =
                |pairing: &Pairing| [pairing.candidate.a, pairing.candidate.b].contains(&rank);
            if candidates.iter().any(is_of) {
                let rank = rank as usize;
                self.states[rank] = bodies.input[rank];
                let (pose, heading) = (&mut bodies.poses[rank], &mut bodies.headings_rad[rank]);
                set_pose(pose, heading, &bodies.input[rank]);
            }
        }
    }

    /// Moves the bodies that no island contains.
    ///
    /// Returns a sum over all states at the end of the step. It is finite if they are, except for the very largest; a
    /// wrench that is not finite makes a state so.
    pub(crate) fn drift(
        &mut self,
        model: &Model,
        bodies: &Bodies,
        step_s: f64,
        results: &mut Results,
    ) -> f64 {
        let mut sum = 0.0;
        for &rank in &bodies.active {
            let rank = rank as usize;
            let motion = &self.motions[rank];
            if !motion.in_island && !motion.has_moved {
                let id = model.id_of[rank].0 as usize;
                results.displacements[id] = self.drift_one(model, rank, bodies, step_s);
                results.states_after[id] = self.states[rank];
            }
            let state = &self.states[rank];
            let linear = state.position_m + state.velocity_mps;
            sum += linear.x + linear.y + state.heading_rad + state.yaw_rate_radps;
        }
        sum
    }

    /// Moves a body for a step by its load alone, or by its velocity if it is fixed.
    #[inline(never)]
    fn drift_one(
        &mut self,
        model: &Model,
        rank: usize,
        bodies: &Bodies,
        step_s: f64,
    ) -> Displacement {
        let (motion, state) = (&mut self.motions[rank], &mut self.states[rank]);
        if !motion.moves {
            return Displacement::default();
        }
        if model.ranked[rank].is_fixed() {
            let velocity = state.velocity();
            move_body(state, velocity, step_s);
            return moved(Displacement::default(), velocity, velocity, step_s);
        }
        let kick_s = kick_s(motion.velocity_lag_s, step_s);
        motion.velocity_lag_s = 0.5 * step_s;
        let (way, turn) = motion.acceleration;
        let (dv, dr) = (way * kick_s, turn * kick_s);
        let displacement = Displacement {
            translation_m: (state.velocity_mps + dv * 0.5) * kick_s,
            rotation_rad: (state.yaw_rate_radps + 0.5 * dr) * kick_s,
        };
        let velocity = (state.velocity_mps + dv, state.yaw_rate_radps + dr);
        move_body(state, velocity, step_s);
        if let Some(kirchhoff) = &model.ranked.rest(rank).kirchhoff {
            let after = Rotation::from_angle(state.heading_rad);
            kirchhoff.turn(state, bodies.poses[rank].rotation, after, step_s);
        }
        displacement
    }
}

/// v_free = v + κ M⁻¹ W.
#[inline(always)]
fn free_velocity(state: &BodyState, (way, turn): Velocity, kick_s: f64) -> Velocity {
    (state.velocity_mps + way * kick_s, state.yaw_rate_radps + turn * kick_s)
}

/// The motion after another sub-step, by the mean of the velocities before and after it.
#[inline(always)]
fn moved(so_far: Displacement, before: Velocity, after: Velocity, kick_s: f64) -> Displacement {
    let ((from_mps, from_radps), (to_mps, to_radps)) = (before, after);
    Displacement {
        translation_m: so_far.translation_m + (from_mps + to_mps) * (0.5 * kick_s),
        rotation_rad: so_far.rotation_rad + (from_radps + to_radps) * (0.5 * kick_s),
    }
}

/// Moves a body with its new velocity.
#[inline(always)]
fn move_body(state: &mut BodyState, velocity: Velocity, h: f64) {
    (state.velocity_mps, state.yaw_rate_radps) = velocity;
    state.position_m += state.velocity_mps * h;
    state.heading_rad += state.yaw_rate_radps * h;
}

/// Turns pose, momentum and inverse mass of a body that has moved.
fn turn_with(
    body: &Rest,
    state: &mut BodyState,
    pose: &mut Pose,
    inverse: &mut InverseMatrix,
    h: f64,
) {
    let after = Rotation::from_angle(state.heading_rad);
    let before = core::mem::replace(&mut pose.rotation, after);
    if let Some(kirchhoff) = &body.kirchhoff {
        kirchhoff.turn(state, before, after, h);
    }
    *inverse = body.inverse.turned(after);
}
