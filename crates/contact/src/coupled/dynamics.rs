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
use crate::coupled::sub_step::SubStep;
use crate::error::StepError;
use crate::mass::InverseMatrix;
use crate::memory::{Memory, NOT_BEHIND};
use crate::model::Model;
use crate::neighbours::NeighbourList;
use crate::number::{greater, lesser};
use crate::patch::Patch;
use crate::ranked::Rest;
use crate::report::{Displacement, Wrench};
use crate::results::Results;
use crate::state::{BodyState, Velocity};
use crate::vec2::{Pose, Rotation};

/// What the coupled method knows of the bodies, by rank.
#[derive(Clone, Debug, Default)]
pub(crate) struct Dynamics {
    /// Layout of the model that all lists are valid for; `None` if the last step was not one of this method, or failed.
    pub(crate) layout: Option<u64>,

    // Which bodies are concerned. Computed by `Dynamics::begin`.
    /// Ranks, ascending, of the bodies that this step computes: all but the settled ones whose input has not changed.
    pub(crate) active: Vec<u32>,
    /// Fixed bodies at rest whose input was the same twice.
    settled: Vec<bool>,
    /// All but fixed bodies at rest.
    pub(crate) moves: Vec<bool>,
    /// Fixed bodies with a velocity.
    pub(crate) moving_fixed: Vec<MovingFixed>,
    /// Bodies in islands. Set by `Group::enter`.
    pub(crate) in_island: Vec<bool>,

    // Position dependent.
    /// M⁻¹, earth-fixed.
    pub(crate) inverses: Vec<InverseMatrix>,

    // Velocity dependent.
    /// All forces but contact, of bodies whose mass differs between directions.
    loads: Vec<Wrench>,
    /// M⁻¹ W (m/s², rad/s²).
    accelerations: Vec<Velocity>,
    /// States at the start of the sub-step. Valid for the bodies of the present group.
    pub(crate) states: Vec<BodyState>,
    /// Before the solve of a sub-step v_free, without contact; after it v⁺.
    pub(crate) velocities: Vec<Velocity>,
    /// How long before its position each body's velocity belongs to (s). Negative if the host gave the velocity: then it is
    /// taken to lag by half of this step.
    pub(crate) velocity_lags_s: Vec<f64>,
    /// How far each body has moved in this step. Valid for the bodies of the present group.
    displacements: Vec<Displacement>,

    // Bounds on the motion within this step.
    /// The largest speed of any point of a body (m/s).
    pub(crate) fastest_mps: Vec<f64>,
    /// The part of it by acceleration and rotation (m/s).
    pub(crate) room_mps: Vec<f64>,
}

/// A fixed body with a velocity, such as a lock gate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MovingFixed {
    rank: u32,
    /// A group of islands has moved it through this step.
    has_moved: bool,
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

    /// Stage 1: checks the host's input, places the bodies, and computes what loads alone do to them. Returns whether the
    /// neighbour list is still valid.
    ///
    /// Settled bodies, such as quays, are skipped if their input has not changed.
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
        neighbours: &NeighbourList,
    ) -> Result<bool, StepError> {
        admit_call(model, memory, input.states, input.step_s)?;
        admit_loads(model, input.states, input.loads)?;
        if self.layout.take() != Some(model.layout) {
            self.forget(model);
            bodies.forget_poses(model.ranked.len());
        }
        self.active.clear();
        self.moving_fixed.clear();
        self.in_island.clear();
        self.in_island.resize(model.ranked.len(), false);
        displaced.clear();
        bodies.resize(model.ranked.len());
        if !self.place(model, memory, input.states, bodies, displaced) {
            return admit_states(model, input.states).map(|()| false);
        }
        let lags_s = input.velocities_continue.then_some(memory.behind_s.as_slice());
        Ok(self.apply_loads(model, input, lags_s, bodies, displaced, neighbours))
    }

    /// Lists of the right length for a model of which nothing is known yet.
    #[cold]
    fn forget(&mut self, model: &Model) {
        let count = model.ranked.len();
        refill(&mut self.settled, count, false);
        refill(&mut self.moves, count, true);
        refill(&mut self.accelerations, count, Velocity::default());
        refill(&mut self.velocity_lags_s, count, NOT_BEHIND);
        self.states.resize(count, BodyState::default());
        self.velocities.resize(count, Velocity::default());
        self.loads.resize(count, Wrench::default());
        self.inverses.clear();
        self.inverses.extend((0..count).map(|rank| model.ranked.rest(rank).inverse));
        self.room_mps.resize(count, 0.0);
        self.fastest_mps.resize(count, 0.0);
        self.displacements.resize(count, Displacement::default());
    }

    /// Places the bodies that are not settled, lists them as active, and finds the displaced ones. Returns false if a state
    /// is not sound.
    #[inline(never)]
    fn place(
        &mut self,
        model: &Model,
        memory: &Memory,
        states: &[BodyState],
        bodies: &mut Bodies,
        displaced: &mut Displaced,
    ) -> bool {
        let count = model.ranked.len();
        let Bodies { input, poses, headings_rad, .. } = bodies;
        // Slices of one known length, so that each rank is bounds-checked once.
        let (input, settled, poses) =
            (&mut input[..count], &mut self.settled[..count], &mut poses[..count]);
        let (headings_rad, id_of) = (&mut headings_rad[..count], &model.id_of[..count]);
        for rank in 0..count {
            let (state, last) = (&states[id_of[rank].0 as usize], memory.last_states.get(rank));
            if settled[rank]
                && last.is_some_and(|last| (input[rank].apart(state) | last.apart(state)) == 0)
            {
                continue;
            }
            if !is_sound(state) {
                return false;
            }
            self.active.push(rank as u32);
            input[rank] = *state;
            let body = &model.ranked[rank];
            if body.is_fixed() {
                let unchanged = last.is_some_and(|last| last.apart(state) == 0);
                settled[rank] = unchanged && state.is_at_rest();
            }
            let turned = set_pose(&mut poses[rank], &mut headings_rad[rank], state);
            if turned && !body.is_alike {
                self.inverses[rank] = model.ranked.rest(rank).inverse.turned(poses[rank].rotation);
            }
            let Some(last) = last else { continue };
            match memory.pose_change(rank, last, state, body.radius_m) {
                PoseChange::Consistent => {}
                PoseChange::Displaced => displaced.all.push(rank as u32),
                PoseChange::Teleported => {
                    displaced.all.push(rank as u32);
                    displaced.teleported.push(rank as u32);
                }
            }
        }
        true
    }

    /// Computes v_free of each active body and how far it may reach in this step. `last_lags_s` are the lags of velocities
    /// that the engine left. Returns whether the neighbour list is still valid.
    #[inline(never)]
    fn apply_loads(
        &mut self,
        model: &Model,
        input: &HostInput<'_>,
        last_lags_s: Option<&[f64]>,
        bodies: &mut Bodies,
        displaced: &Displaced,
        neighbours: &NeighbourList,
    ) -> bool {
        let count = model.ranked.len();
        let step_s = input.step_s;
        let Dynamics { active, moves, velocities, loads, inverses, accelerations, .. } = self;
        let Dynamics { moving_fixed, room_mps, fastest_mps, velocity_lags_s, .. } = self;
        let Bodies { input: states, reach_m, .. } = bodies;
        // Slices of one known length, so that each rank is bounds-checked once.
        let (states, velocities) = (&states[..count], &mut velocities[..count]);
        let (accelerations, lags_s) = (&mut accelerations[..count], &mut velocity_lags_s[..count]);
        let (fastest_mps, room_mps) = (&mut fastest_mps[..count], &mut room_mps[..count]);
        let (reach_m, id_of) = (&mut reach_m[..count], &model.id_of[..count]);
        let circles = neighbours.circles_for(model);
        let mut list_holds = true;
        for &rank in &*active {
            let rank = rank as usize;
            let (body, state) = (&model.ranked[rank], &states[rank]);
            let mut room = state.yaw_rate_radps.abs() * body.reach_m;
            if body.is_fixed() {
                moves[rank] = !state.is_at_rest();
                lags_s[rank] = NOT_BEHIND;
                velocities[rank] = state.velocity();
                if moves[rank] {
                    moving_fixed.push(MovingFixed { rank: rank as u32, has_moved: false });
                }
            } else {
                let load = &input.loads[id_of[rank].0 as usize];
                let (way, turn) = if body.is_alike {
                    (load.force_n * body.inverse_mass, load.moment_nm * body.inverse_inertia)
                } else {
                    loads[rank] = *load;
                    inverses[rank].response(load.force_n, load.moment_nm)
                };
                accelerations[rank] = (way, turn);
                lags_s[rank] = match last_lags_s {
                    // Before the first step velocities and positions belong to the same time.
                    Some([]) => 0.0,
                    Some(last_s)
                        if last_s[rank] >= 0.0
                            && !displaced.is_displaced(rank as u32, rank as u32) =>
                    {
                        last_s[rank]
                    }
                    _ => -0.5 * step_s,
                };
                let kick_s = kick_s(lags_s[rank], step_s);
                velocities[rank] = free_velocity(state, (way, turn), kick_s);
                room += (way.length() + turn.abs() * body.reach_m) * greater(kick_s, step_s);
            }
            let fastest = state.velocity_mps.length() + room;
            let reach = body.reach_m + fastest * step_s;
            (room_mps[rank], fastest_mps[rank], reach_m[rank]) = (room, fastest, reach);
            list_holds &=
                circles.get(rank).is_some_and(|circle| circle.holds(state.position_m, reach));
        }
        list_holds
    }

    /// Begins a sub-step of a group: states at its start, and v_free. `islands` are those of the group, if they have more
    /// than one floating body.
    pub(crate) fn begin_sub_step(
        &mut self,
        model: &Model,
        group: &Group,
        islands: Option<&[Island]>,
        patches: &[Patch],
        input: &[BodyState],
        sub_step: SubStep,
    ) {
        if sub_step.is_first() {
            for &rank in &group.bodies {
                let rank = rank as usize;
                self.states[rank] = input[rank];
                if !sub_step.is_only() && self.velocity_lags_s[rank] < 0.0 {
                    self.velocity_lags_s[rank] = 0.5 * sub_step.h;
                }
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
        let lags_s = &mut self.velocity_lags_s;
        let mut changed = false;
        for island in islands {
            let own = &patches[island.patches_from(group.patches.start)];
            let floating = || {
                let both = own.iter().flat_map(|patch| [patch.candidate.a, patch.candidate.b]);
                both.map(|rank| rank as usize).filter(|&rank| !model.ranked[rank].is_fixed())
            };
            let least_s =
                floating().fold(f64::INFINITY, |least, rank| lesser(least, lags_s[rank].abs()));
            for rank in floating() {
                if lags_s[rank].abs() > least_s {
                    (lags_s[rank], changed) = (least_s, true);
                }
            }
        }
        changed
    }

    /// v_free = v + κ M⁻¹ W of the bodies of a group.
    fn free_velocities(&mut self, group: &Group, h: f64) {
        for &rank in &group.bodies {
            let rank = rank as usize;
            let kick_s = kick_s(self.velocity_lags_s[rank], h);
            self.velocities[rank] =
                free_velocity(&self.states[rank], self.accelerations[rank], kick_s);
        }
    }

    /// x⁺ = x + h v⁺ of the bodies of a group, with poses and inverse masses; and how far the bodies moved, by the mean
    /// velocity of the sub-step: a force times it is exactly that force's work.
    pub(crate) fn advance_positions(
        &mut self,
        model: &Model,
        group: &Group,
        bodies: &mut Bodies,
        sub_step: SubStep,
    ) {
        let count = model.ranked.len();
        let h = sub_step.h;
        let (states, velocities) = (&mut self.states[..count], &self.velocities[..count]);
        let (displacements, lags_s) =
            (&mut self.displacements[..count], &mut self.velocity_lags_s[..count]);
        let (poses, headings_rad) = (&mut bodies.poses[..count], &mut bodies.headings_rad[..count]);
        for &rank in &group.bodies {
            let rank = rank as usize;
            let (state, displacement, pose) =
                (&mut states[rank], &mut displacements[rank], &mut poses[rank]);
            let so_far = if sub_step.is_first() { Displacement::default() } else { *displacement };
            let kick_s = kick_s(lags_s[rank], h);
            lags_s[rank] = 0.5 * h;
            *displacement = moved(so_far, state.velocity(), velocities[rank], kick_s);
            move_body(state, velocities[rank], h);
            if !model.ranked[rank].is_alike {
                pose.position_m = state.position_m;
                turn_with(model.ranked.rest(rank), state, pose, &mut self.inverses[rank], h);
                headings_rad[rank] = state.heading_rad;
                let load = &self.loads[rank];
                self.accelerations[rank] =
                    self.inverses[rank].response(load.force_n, load.moment_nm);
            } else if !sub_step.is_last() {
                set_pose(pose, &mut headings_rad[rank], state);
            }
        }
    }

    /// Stage 6: results of the bodies of a group after its last sub-step.
    pub(crate) fn report(&mut self, model: &Model, group: &Group, results: &mut Results) {
        for &rank in &group.bodies {
            let id = model.id_of[rank as usize].0 as usize;
            results.states_after[id] = self.states[rank as usize];
            results.displacements[id] = self.displacements[rank as usize];
        }
        if self.moving_fixed.is_empty() {
            return;
        }
        for fixed in &mut self.moving_fixed {
            // It may be in other groups as well.
            if core::mem::take(&mut self.in_island[fixed.rank as usize]) {
                fixed.has_moved = true;
            }
        }
    }

    /// Places the moving fixed bodies of these candidates at their input poses: each group moves them through the step.
    pub(crate) fn reset_moving_fixed(&mut self, bodies: &mut Bodies, candidates: &[Pairing]) {
        for fixed in &self.moving_fixed {
            let is_of = |pairing: &Pairing| {
                [pairing.candidate.a, pairing.candidate.b].contains(&fixed.rank)
            };
            if candidates.iter().any(is_of) {
                let rank = fixed.rank as usize;
                let (pose, heading) = (&mut bodies.poses[rank], &mut bodies.headings_rad[rank]);
                set_pose(pose, heading, &bodies.input[rank]);
            }
        }
    }

    /// Moves the bodies that no island contains: one step by their loads alone, or by their velocity if they are fixed.
    #[inline(never)]
    pub(crate) fn drift(
        &mut self,
        model: &Model,
        bodies: &Bodies,
        step_s: f64,
        results: &mut Results,
    ) {
        for &rank in &self.active {
            let rank = rank as usize;
            if self.in_island[rank] {
                continue;
            }
            let is_of = |fixed: &&MovingFixed| fixed.rank as usize == rank;
            if self.moves[rank]
                && self.moving_fixed.iter().find(is_of).is_some_and(|fixed| fixed.has_moved)
            {
                continue;
            }
            let id = model.id_of[rank].0 as usize;
            let (mut state, body) = (bodies.input[rank], model.ranked.rest(rank));
            results.displacements[id] = if !self.moves[rank] {
                Displacement::default()
            } else if model.ranked[rank].is_fixed() {
                let velocity = state.velocity();
                move_body(&mut state, velocity, step_s);
                moved(Displacement::default(), velocity, velocity, step_s)
            } else {
                let kick_s = kick_s(self.velocity_lags_s[rank], step_s);
                self.velocity_lags_s[rank] = 0.5 * step_s;
                let (way, turn) = self.accelerations[rank];
                let (dv, dr) = (way * kick_s, turn * kick_s);
                let displacement = Displacement {
                    translation_m: (state.velocity_mps + dv * 0.5) * kick_s,
                    rotation_rad: (state.yaw_rate_radps + 0.5 * dr) * kick_s,
                };
                let velocity = (state.velocity_mps + dv, state.yaw_rate_radps + dr);
                move_body(&mut state, velocity, step_s);
                if let Some(kirchhoff) = &body.kirchhoff {
                    let after = Rotation::from_angle(state.heading_rad);
                    kirchhoff.turn(&mut state, bodies.poses[rank].rotation, after, step_s);
                }
                displacement
            };
            results.states_after[id] = state;
        }
    }
}

/// κ of a sub-step of length h, of a body whose velocity lags by `lag_s`.
#[inline(always)]
pub(crate) fn kick_s(lag_s: f64, h: f64) -> f64 {
    lag_s.abs() + 0.5 * h
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

fn refill<T: Copy>(list: &mut Vec<T>, count: usize, one: T) {
    list.clear();
    list.resize(count, one);
}
