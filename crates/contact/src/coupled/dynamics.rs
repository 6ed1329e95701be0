//! The dynamics of the bodies in the coupled method: their state at the start of a step, and their motion in the step.
//!
//! The sub-steps are a leapfrog scheme: x⁺ = x + h v⁺ with v⁺ = v + κ M⁻¹ (W + contact). So the velocity v⁺ belongs to
//! the middle of its own sub-step, and the velocity v to the middle of the sub-step before. The time between the
//! velocities v and v⁺ is κ = (h_before + h)/2. While all sub-steps have the same length, the time κ equals the length
//! h. Loads and contact forces act for the same time κ, so that they cancel for bodies at rest, whatever the lengths of
//! the sub-steps.

use alloc::vec::Vec;

use crate::admit::{admit_call, admit_loads, admit_states, is_sound};
use crate::broad::bodies::{Bodies, Displaced, PoseChange};
use crate::broad::candidates::Pairing;
use crate::coupled::island::{Group, Island};
use crate::coupled::motion::{Role, SpeedBound, acceleration, kick_s};
use crate::coupled::moving_pile::MovingPile;
use crate::coupled::sub_step::SubStep;
use crate::error::StepError;
use crate::maths::number::{greater, lesser};
use crate::maths::vec2::Pose;
use crate::model::Model;
use crate::model::mass::InverseMatrix;
use crate::model::ranked::Rest;
use crate::overlap::patch::Patch;
use crate::state::body_state::{BodyState, Velocity};
use crate::state::memory::{Memory, NOT_BEHIND};
use crate::state::report::{Displacement, Wrench};
use crate::state::results::Results;

/// The data of the bodies that the coupled method needs. Lists are by rank.
#[derive(Clone, Debug, Default)]
pub(crate) struct Dynamics {
    /// Hash of the layout (bodies, pairs and materials) of the model for which all lists are valid. `None` if the last
    /// step used another method, or failed.
    pub(crate) layout: Option<u64>,
    /// Ranks of the fixed bodies with a velocity, such as lock gates.
    pub(crate) moving_fixed: Vec<u32>,
    pub(crate) roles: Vec<Role>,
    /// Time by which the velocity of each body is older than its position (s). The velocity lag of a body is negative
    /// if the host gave the velocity: then half of this step is taken as the lag.
    pub(crate) velocity_lags_s: Vec<f64>,
    pub(crate) speed_bounds: Vec<SpeedBound>,
    /// M⁻¹, earth-fixed.
    pub(crate) inverses: Vec<InverseMatrix>,
    /// States of the bodies at the start of the sub-step.
    pub(crate) states: Vec<BodyState>,
    /// Before the solve of a sub-step these are v_free, the velocities without contact. After the solve, v⁺.
    pub(crate) velocities: Vec<Velocity>,
    /// The bodies on piles, in the order of [`Model::piles`].
    pub(crate) piles: Vec<MovingPile>,
    /// Sum over all states that the step has computed: the sum is finite if all states are finite, except for states
    /// near the largest number.
    state_sum: f64,
}

/// What the host gives to the engine for a step: states, loads and the length of the step.
#[derive(Clone, Copy)]
pub(crate) struct HostInput<'a> {
    /// States by id.
    pub(crate) states: &'a [BodyState],
    pub(crate) loads: &'a [Wrench],
    pub(crate) step_s: f64,
    /// True if the bodies still have the velocities of the engine's last step, which lag behind their positions.
    pub(crate) velocities_continue: bool,
}

impl Dynamics {
    pub(crate) fn new(model: &Model) -> Dynamics {
        let mut dynamics = Dynamics::default();
        dynamics.forget(model);
        dynamics
    }

    pub(crate) fn invalidate(&mut self) {
        self.layout = None;
    }

    /// Stage 1: checks the host's input, places the bodies, and computes their motion by loads alone.
    ///
    /// Settled bodies, such as quays, are skipped while their state stays the same.
    ///
    /// # Errors
    /// Returns an error if a number of the input is not finite or too large. If the function returns an error, nothing
    /// has changed that a later step needs.
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
        }
        self.moving_fixed.clear();
        self.state_sum = 0.0;
        displaced.clear();
        bodies.resize(count);
        let Dynamics { roles, velocity_lags_s, speed_bounds, moving_fixed, .. } = self;
        let Dynamics { inverses, states, velocities, .. } = self;
        let Bodies { input: inputs, poses, reach_m, active } = bodies;
        // Slices of one known length, so that the compiler needs no bounds checks for ranks.
        let (roles, inverses) = (&mut roles[..count], &mut inverses[..count]);
        let lags_s = &mut velocity_lags_s[..count];
        let speed_bounds = &mut speed_bounds[..count];
        let (states, velocities) = (&mut states[..count], &mut velocities[..count]);
        let (inputs, poses) = (&mut inputs[..count], &mut poses[..count]);
        let reach_m = &mut reach_m[..count];
        let id_of = &model.id_of[..count];
        for rank in 0..count {
            let id = id_of[rank].0 as usize;
            let (state, role) = (&input.states[id], &mut roles[rank]);
            let last = memory.last_states.get(rank);
            let is_unchanged = || last.is_some_and(|last| last.apart(state) == 0);
            if role.settled && inputs[rank].apart(state) == 0 && is_unchanged() {
                continue;
            }
            if !is_sound(state) {
                return admit_states(model, input.states);
            }
            active.push(rank as u32);
            let body = &model.ranked[rank];
            // The last step left the body at this attitude. The inverse mass of this body turns with the body.
            let is_turned = role.moves && !body.is_alike && {
                states[rank].heading_rad.to_bits() == state.heading_rad.to_bits()
            };
            (inputs[rank], states[rank]) = (*state, *state);
            poses[rank] = match is_turned {
                true => Pose { position_m: state.position_m, ..poses[rank] },
                false => state.pose(),
            };
            if !body.is_alike {
                inverses[rank] = model.ranked.rest(rank).inverse.turned(poses[rank].rotation);
            }
            let change = last.map_or(PoseChange::Consistent, |last| {
                memory.pose_change(rank, last, state, body.radius_m)
            });
            displaced.add(rank as u32, change);
            if body.is_fixed() {
                let moves = !state.is_at_rest();
                *role = Role::new(moves, !moves && is_unchanged());
                lags_s[rank] = NOT_BEHIND;
                if moves {
                    moving_fixed.push(rank as u32);
                    lags_s[rank] = -0.5 * input.step_s;
                }
                velocities[rank] = state.velocity();
                speed_bounds[rank] = SpeedBound::of(body, state, Velocity::default(), 0.0);
            } else {
                let lag_s = match memory.behind_s.get(rank) {
                    _ if !input.velocities_continue => NOT_BEHIND,
                    // Before the first step, velocities and positions belong to the same time.
                    None => 0.0,
                    Some(_) if change != PoseChange::Consistent => NOT_BEHIND,
                    Some(&last_s) => last_s,
                };
                *role = Role::new(true, false);
                lags_s[rank] = if lag_s >= 0.0 { lag_s } else { -0.5 * input.step_s };
                let kick_s = kick_s(lags_s[rank], input.step_s);
                let by_load = acceleration(body, &inverses[rank], &input.loads[id]);
                let time_s = greater(kick_s, input.step_s);
                speed_bounds[rank] = SpeedBound::of(body, state, by_load, time_s);
                velocities[rank] = free_velocity(state, by_load, kick_s);
            }
            reach_m[rank] = body.reach_m + speed_bounds[rank].fastest_mps * input.step_s;
        }
        if !model.piles.is_empty() {
            self.begin_piles(model, memory, input, bodies, displaced);
        }
        Ok(())
    }

    /// Resets the lists to the right length for a model, with nothing known about the model's bodies yet.
    #[cold]
    #[inline(never)]
    fn forget(&mut self, model: &Model) {
        let count = model.ranked.len();
        self.roles.clear();
        self.roles.resize(count, Role::default());
        self.velocity_lags_s.resize(count, NOT_BEHIND);
        self.speed_bounds.resize(count, SpeedBound::default());
        self.states.resize(count, BodyState::default());
        self.velocities.resize(count, Velocity::default());
        self.inverses.clear();
        self.inverses.extend((0..count).map(|rank| model.ranked.rest(rank).inverse));
    }

    /// Begins a sub-step of a group: computes the velocities v_free without contact under `loads`, which are listed by
    /// id. `islands` are the islands of the group, if one of them has more than one floating body.
    pub(crate) fn begin_sub_step(
        &mut self,
        model: &Model,
        loads: &[Wrench],
        group: &Group,
        islands: Option<&[Island]>,
        patches: &[Patch],
        sub_step: SubStep,
    ) {
        if sub_step.is_first() && !sub_step.is_only() {
            for &rank in &group.bodies {
                let lag_s = &mut self.velocity_lags_s[rank as usize];
                *lag_s = if *lag_s < 0.0 { 0.5 * sub_step.h } else { *lag_s };
            }
        }
        let changed = sub_step.is_first()
            && islands.is_some_and(|islands| self.agree(model, group, islands, patches));
        // For a sub-step that is the whole step, `begin` has already computed v_free.
        if changed || !sub_step.is_only() {
            self.free_velocities(model, loads, group, sub_step.h);
            if !model.piles.is_empty() {
                self.begin_pile_sub_step(model, loads, group, sub_step);
            }
        }
    }

    /// Gives bodies that touch each other the same time κ, the least of their times. With different times κ, a contact
    /// would give its two bodies different impulses. The loads of bodies that touch each other then act for the same
    /// time κ too. Returns true if a time κ has changed.
    #[inline(never)]
    fn agree(
        &mut self,
        model: &Model,
        group: &Group,
        islands: &[Island],
        patches: &[Patch],
    ) -> bool {
        let lags_s = &mut self.velocity_lags_s;
        let mut changed = false;
        for island in islands {
            let own = &patches[island.patches_from(group.patches.start)];
            let mut least_s = f64::INFINITY;
            for_each_floating(model, own, |rank| least_s = lesser(least_s, lags_s[rank].abs()));
            for_each_floating(model, own, |rank| {
                let lag_s = &mut lags_s[rank];
                if lag_s.abs() > least_s {
                    (*lag_s, changed) = (least_s, true);
                }
            });
        }
        changed
    }

    /// Computes the velocities without contact, v_free = v + κ M⁻¹ W, for the bodies of a group.
    fn free_velocities(&mut self, model: &Model, loads: &[Wrench], group: &Group, h: f64) {
        for &rank in &group.bodies {
            let rank = rank as usize;
            let kick_s = kick_s(self.velocity_lags_s[rank], h);
            let load = &loads[model.id_of[rank].0 as usize];
            let by_load = acceleration(&model.ranked[rank], &self.inverses[rank], load);
            self.velocities[rank] = free_velocity(&self.states[rank], by_load, kick_s);
        }
    }

    /// Moves the bodies of a group by x⁺ = x + h v⁺, and updates their poses and inverse masses. The function also
    /// computes the displacement of each body by the mean velocity of the sub-step: a force times this displacement is
    /// exactly the work of the force.
    pub(crate) fn advance_positions(
        &mut self,
        model: &Model,
        group: &Group,
        bodies: &mut Bodies,
        results: &mut Results,
        sub_step: SubStep,
    ) {
        let (count, h) = (model.ranked.len(), sub_step.h);
        // Slices of one known length, so that the compiler checks the bounds of each rank once.
        let (states, lags_s) = (&mut self.states[..count], &mut self.velocity_lags_s[..count]);
        let (poses, velocities) = (&mut bodies.poses[..count], &self.velocities[..count]);
        let (id_of, displacements) = (&model.id_of[..count], &mut results.displacements[..count]);
        let states_after = &mut results.states_after[..count];
        let mut sum = 0.0;
        for &rank in &group.bodies {
            let rank = rank as usize;
            let id = id_of[rank].0 as usize;
            let (state, lag_s, pose) = (&mut states[rank], &mut lags_s[rank], &mut poses[rank]);
            let (velocity, displacement) = (velocities[rank], &mut displacements[id]);
            let so_far = if sub_step.is_first() { Displacement::default() } else { *displacement };
            let kick_s = kick_s(*lag_s, h);
            *lag_s = 0.5 * h;
            *displacement = moved(so_far, state.velocity(), velocity, kick_s);
            move_body(state, velocity, h);
            if !model.ranked[rank].is_alike {
                turn_with(model.ranked.rest(rank), state, pose, h);
                if !sub_step.is_last() {
                    self.inverses[rank] = model.ranked.rest(rank).inverse.turned(pose.rotation);
                }
            } else if !sub_step.is_last() {
                *pose = state.pose();
            }
            if sub_step.is_last() {
                states_after[id] = *state;
                sum += sum_of(state);
            }
        }
        self.state_sum += sum;
        if !model.piles.is_empty() {
            self.advance_piles(model, group, bodies, results, sub_step);
        }
    }

    /// Marks the fixed bodies that a group of islands has moved through the step. A fixed body with a velocity may be
    /// in other groups as well.
    pub(crate) fn mark_moved_fixed(&mut self) {
        for &rank in &self.moving_fixed {
            let role = &mut self.roles[rank as usize];
            role.has_moved |= core::mem::take(&mut role.in_island);
        }
    }

    /// Returns the moving fixed bodies of these candidates to their input states, because each group moves them through
    /// the step.
    pub(crate) fn reset_moving_fixed(&mut self, bodies: &mut Bodies, candidates: &[Pairing]) {
        for &rank in &self.moving_fixed {
            let is_of =
                |pairing: &Pairing| [pairing.candidate.a, pairing.candidate.b].contains(&rank);
            if candidates.iter().any(is_of) {
                let rank = rank as usize;
                self.states[rank] = bodies.input[rank];
                bodies.poses[rank] = bodies.input[rank].pose();
            }
        }
    }

    /// Moves the bodies that are in no island through the step.
    ///
    /// Returns true if all states at the end of the step are finite, except for states near the largest number. A
    /// wrench that is not finite makes the state of its body not finite.
    pub(crate) fn drift(
        &mut self,
        model: &Model,
        loads: &[Wrench],
        bodies: &mut Bodies,
        step_s: f64,
        results: &mut Results,
    ) -> bool {
        let Bodies { active, poses, .. } = bodies;
        for &rank in &*active {
            let rank = rank as usize;
            let role = self.roles[rank];
            if !role.in_island && !role.has_moved {
                let id = model.id_of[rank].0 as usize;
                results.displacements[id] = self.drift_one(model, rank, &mut poses[rank], step_s);
                results.states_after[id] = self.states[rank];
                self.state_sum += sum_of(&self.states[rank]);
            }
        }
        if !model.piles.is_empty() {
            self.drift_piles(model, loads, bodies, step_s, results);
        }
        self.state_sum.is_finite()
    }

    /// Moves a body through a step with the velocity that `begin` gave the body. A floating body moves by its load
    /// alone, and a fixed body moves as the host says.
    #[inline(never)]
    fn drift_one(
        &mut self,
        model: &Model,
        rank: usize,
        pose: &mut Pose,
        step_s: f64,
    ) -> Displacement {
        if !self.roles[rank].moves {
            return Displacement::default();
        }
        let (body, velocity) = (&model.ranked[rank], self.velocities[rank]);
        let (state, lag_s) = (&mut self.states[rank], &mut self.velocity_lags_s[rank]);
        let kick_s = kick_s(*lag_s, step_s);
        *lag_s = if body.is_fixed() { NOT_BEHIND } else { 0.5 * step_s };
        let displacement = moved(Displacement::default(), state.velocity(), velocity, kick_s);
        move_body(state, velocity, step_s);
        if !body.is_alike {
            turn_with(model.ranked.rest(rank), state, pose, step_s);
        }
        displacement
    }
}

/// Calls the function `call` with the rank of each floating body of the patches, once per patch.
#[inline(always)]
fn for_each_floating(model: &Model, patches: &[Patch], mut call: impl FnMut(usize)) {
    for patch in patches {
        for rank in [patch.candidate.a as usize, patch.candidate.b as usize] {
            if !model.ranked[rank].is_fixed() {
                call(rank);
            }
        }
    }
}

/// Adds up all numbers of a body's state. The sum is not finite if one number of the state is not finite.
#[inline(always)]
fn sum_of(state: &BodyState) -> f64 {
    let linear = state.position_m + state.velocity_mps;
    linear.x + linear.y + state.heading_rad + state.yaw_rate_radps
}

/// Returns the velocity of a body without contact, v_free = v + κ M⁻¹ W.
#[inline(always)]
fn free_velocity(state: &BodyState, (way, turn): Velocity, kick_s: f64) -> Velocity {
    (state.velocity_mps + way * kick_s, state.yaw_rate_radps + turn * kick_s)
}

/// Adds the way in another sub-step to a body's displacement, by the mean of the velocities before and after the
/// sub-step.
#[inline(always)]
fn moved(so_far: Displacement, before: Velocity, after: Velocity, kick_s: f64) -> Displacement {
    let ((from_mps, from_radps), (to_mps, to_radps)) = (before, after);
    Displacement {
        translation_m: so_far.translation_m + (from_mps + to_mps) * (0.5 * kick_s),
        rotation_rad: so_far.rotation_rad + (from_radps + to_radps) * (0.5 * kick_s),
    }
}

/// Moves the state of a body by its new velocity.
#[inline(always)]
fn move_body(state: &mut BodyState, velocity: Velocity, h: f64) {
    (state.velocity_mps, state.yaw_rate_radps) = velocity;
    state.position_m += state.velocity_mps * h;
    state.heading_rad += state.yaw_rate_radps * h;
}

/// Updates the pose of a body to the body's new state. If the body's mass differs between surge and sway, the function
/// also changes the velocities by Kirchhoff's equations.
fn turn_with(body: &Rest, state: &mut BodyState, pose: &mut Pose, h: f64) {
    let before = core::mem::replace(pose, state.pose()).rotation;
    if let Some(kirchhoff) = &body.kirchhoff {
        kirchhoff.turn(state, before, pose.rotation, h);
    }
}
