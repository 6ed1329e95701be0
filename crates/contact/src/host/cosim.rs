//! The host's memory and one step, top to bottom.

use alloc::vec;
use alloc::vec::Vec;

use crate::admit;
use crate::coupled::advance_from_engine_states;
use crate::error::StepError;
use crate::host::inertia;
use crate::host::lead::{self, Lead, Start, is_steady};
use crate::host::mass_check::Answers;
use crate::host::settings::{HostIntegration, HostSettings};
use crate::host::steering::{self, Velocity, Way};
use crate::host::workspace::HostWorkspace;
use crate::host::{observer, predictor};
use crate::material::BodyId;
use crate::memory::{Memory, NOT_BEHIND};
use crate::model::Model;
use crate::number::greater;
use crate::pause::pause;
use crate::report::Wrench;
use crate::state::BodyState;

/// The coupled method for a host that integrates its bodies by itself, with a step that may vary, shows states
/// that may be some steps old, and need not tell its loads.
///
/// The host answers wrench W and its own load by M(v′ − v)/Δt = W + load, with the mass matrix of the
/// model in the body's attitude at the step's start. The wrenches of [`CoSimHost::step`] make its
/// positions follow the engine's sub-stepped motion, whatever Δt: the same rebound, the same depth at
/// rest. While bodies touch and the step is always the same, the velocities of the host are means over a step, and
/// its places those of the engine. In a contact in which the step changes the velocities are the engine's, and the
/// places are off by up to half the acceleration times Δt², which is made good in some 10 s.
///
/// All state is plain data, as [`Memory`] is: copy it to branch a run, compare it, save it with
/// [`CoSimHost::snapshot`] and get it back with [`CoSimHost::restore`].
///
/// ```
/// use fenderline_contact::*;
/// # let square = [vec2(-5.0, -5.0), vec2(5.0, -5.0), vec2(5.0, 5.0), vec2(-5.0, 5.0)];
/// # let (outline, _) = Outline::new(&square)?;
/// # let mut builder = Model::builder();
/// # let tug = builder.body(Body { name: "tug".into(), key: 1, outline: outline.clone(),
/// #     mobility: Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 6e7 } });
/// # let quay = builder.body(Body { name: "quay".into(), key: 2, outline, mobility: Mobility::Fixed });
/// # let rubber = builder.material(Material { stiffness_npm2: 500e3, damping_nspm2: 0.0,
/// #     shear_stiffness_npm: 3e6, friction_static: 0.5, friction_dynamic: 0.5, restitution: 0.1 });
/// # builder.pair(Pair { bodies: [tug, quay], material: rubber });
/// # let model = builder.build()?;
/// let settings = HostSettings { delay_steps: 1, integration: HostIntegration::ForwardEuler };
/// let mut host = CoSimHost::new(&model, settings);
/// let mut work = HostWorkspace::new(&model);
/// // A tug of 1000 t at 2 m/s towards a quay, γ = 0.1; the host shows her one step late.
/// let quay = BodyState { position_m: vec2(11.0, 0.0), ..Default::default() };
/// let mut tug = BodyState { velocity_mps: vec2(2.0, 0.0), ..Default::default() };
/// let mut shown = tug;
/// for _ in 0..200 {
///     let wrenches = host.step(&model, &mut work, &[shown, quay], None, 0.1)?;
///     shown = tug;
///     tug.position_m += tug.velocity_mps * 0.1;
///     tug.velocity_mps += wrenches[0].force_n * (0.1 / 1e6);
/// }
/// assert!((tug.velocity_mps.x + 0.2).abs() < 0.002);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CoSimHost {
    pub(super) settings: HostSettings,
    pub(super) memory: Memory,
    /// In the order in which bodies were added.
    pub(super) bodies: Vec<Followed>,
    /// What was given in the last steps, at most `delay_steps` + 1 of them, the oldest first; body by
    /// body within a step.
    pub(super) given: Vec<Given>,
    /// The length of the last step that was one; 0 before the first (s).
    pub(super) last_step_s: f64,
}

/// What is remembered of one body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Followed {
    /// The last state shown.
    pub(super) shown: BodyState,
    /// The last load observed.
    pub(super) observed: Wrench,
    /// Whether it answers wrenches as its mass says.
    pub(super) answers: Answers,
    /// The host has said that it puts the body where it shows it next.
    pub(super) placed: bool,
    /// What contact did to the engine's motion that the host's has not got yet; nothing where nothing
    /// touched the body.
    pub(super) ahead: Option<Lead>,
}

/// What one body was given for one step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Given {
    pub(super) step_s: f64,
    pub(super) wrench: Wrench,
    /// The load that the host told, where it did.
    pub(super) told: Option<Wrench>,
}

impl CoSimHost {
    /// A host whose bodies have never touched.
    #[must_use]
    pub fn new(model: &Model, settings: HostSettings) -> CoSimHost {
        CoSimHost {
            settings,
            memory: Memory::new(model),
            bodies: vec![Followed::default(); model.bodies().len()],
            given: Vec::new(),
            last_step_s: 0.0,
        }
    }

    /// Forgets all that happened: the next step is the first.
    pub fn reset(&mut self, model: &Model) {
        *self = CoSimHost::new(model, self.settings);
    }

    /// Becomes a copy of `other` without allocating where the buffers are large enough.
    pub fn copy_from(&mut self, other: &CoSimHost) {
        self.settings = other.settings;
        self.memory.copy_from(&other.memory);
        self.bodies.clone_from(&other.bodies);
        self.given.clone_from(&other.given);
        self.last_step_s = other.last_step_s;
    }

    /// The host has put a body where the next step shows it: its contacts start afresh, no load is read from it, and
    /// where it lies within another one it is pressed out slowly. See [`Memory::mark_teleported`].
    ///
    /// # Panics
    /// Where the model has no such body.
    pub fn mark_teleported(&mut self, model: &Model, body: BodyId) {
        self.memory.mark_teleported(model, body);
        self.bodies[body.0 as usize].placed = true;
    }

    /// What is known of the host.
    #[must_use]
    pub fn settings(&self) -> HostSettings {
        self.settings
    }

    /// The contacts' memory.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// One step of the host: from the states it shows, `delay_steps` old, to the wrench that each body
    /// is to be given for the step of `step_s` seconds that begins now; earth-fixed, about the centre of
    /// gravity, in the order in which bodies were added.
    ///
    /// `told_loads` are all other forces of this step, as in [`crate::advance`]. With `None` they are
    /// taken to be as they were when last observed: M Δv/Δt of the host less what it was given, Coriolis
    /// and centripetal terms among it; zero until two states were shown. A load that begins suddenly
    /// is known one step later, and `delay_steps` besides.
    ///
    /// A fixed body's wrench is the mean contact wrench of the step. That of a floating one comes up to
    /// a step later, so that positions agree; the impulse over the whole contact is the same.
    ///
    /// A forward Euler host goes its next step whatever it is given: one that begins nearer to a contact
    /// than it goes in a step begins within it. No load that is not yet known can be answered; with a
    /// long Δt and delay a body at rest may be driven deep before it is.
    ///
    /// In a step of 0 s, of a host that is paused, nothing goes on, and the wrenches are those of the last step.
    ///
    /// A body that answers the wrenches of a hit otherwise than its mass in the model says is told of once
    /// ([`crate::EventKind::MassMismatch`]): its rebound is right nevertheless, its depth at rest within a tenth.
    ///
    /// Where a body's shown position is not where its velocity leads, the host has put it elsewhere:
    /// no load is read from that, and its contacts start afresh
    /// ([`crate::EventKind::Teleported`]).
    ///
    /// # Errors
    /// As [`crate::step()`], for states, loads and Δt, and where what is reckoned from them leaves what the engine
    /// takes; this host is then as it was, and `work` keeps the results of the last good step.
    pub fn step<'w>(
        &mut self,
        model: &Model,
        work: &'w mut HostWorkspace,
        states_shown: &[BodyState],
        told_loads: Option<&[Wrench]>,
        step_s: f64,
    ) -> Result<&'w [Wrench], StepError> {
        admit::admit(model, &self.memory, states_shown, step_s)?;
        if let Some(loads) = told_loads {
            admit::admit_loads(model, states_shown, loads)?;
        }
        self.observe(model, work, states_shown);
        self.predict(model, work, told_loads);
        if step_s == 0.0 {
            self.stand_still(model, work, told_loads)?;
            return Ok(&work.wrenches);
        }
        self.set_out(model, work, step_s);
        self.leave_velocities(model, work);
        let (starts, loads, memory) = (&work.starts, &work.loads_now, &mut self.memory);
        if let Err(error) =
            advance_from_engine_states(model, memory, &mut work.engine, starts, loads, step_s)
        {
            memory.behind_s.clone_from(&work.behind_s);
            return Err(error);
        }
        work.tell_of_masses();
        work.engine.peak_wrenches_into(&mut work.peaks);
        self.steer(model, work, step_s);
        self.remember(work, told_loads, step_s);
        core::mem::swap(&mut work.present_now, &mut work.present);
        core::mem::swap(&mut work.loads_now, &mut work.loads);
        Ok(&work.wrenches)
    }

    /// Whole steps that are remembered.
    pub(super) fn steps_given(&self) -> usize {
        self.given.len() / self.bodies.len().max(1)
    }

    /// Loads as far as they can be told from the states shown, into `work.next`.
    fn observe(&self, model: &Model, work: &mut HostWorkspace, states_shown: &[BodyState]) {
        work.next.clone_from(&self.bodies);
        work.differ.clear();
        // The state shown before this one is the initial state as well until the oldest wrench
        // remembered is the one given between the two.
        let two_states = self.steps_given() > self.settings.delay_steps as usize;
        for (index, (next, &shown)) in work.next.iter_mut().zip(states_shown).enumerate() {
            if two_states {
                let given = &self.given[index];
                let body = &model.bodies()[index];
                if next.placed
                    || observer::was_moved(
                        self.settings.integration,
                        body,
                        &next.shown,
                        &shown,
                        given,
                    )
                {
                    next.ahead = None;
                    next.answers.forget();
                } else if given.step_s > 0.0
                    && let Some(load) = observer::load(body, &next.shown, &shown, given)
                {
                    next.observed = load;
                    let load = given.told.unwrap_or(load);
                    if next.answers.note(body, (&next.shown, &shown), given, &load) {
                        work.differ.push(BodyId(index as u32));
                    }
                }
            }
            if next.placed {
                next.ahead = None;
                next.placed = false;
            }
            next.shown = shown;
        }
    }

    /// A step of no length: nothing but what the host shows later is another step older by then.
    fn stand_still(
        &mut self,
        model: &Model,
        work: &mut HostWorkspace,
        told_loads: Option<&[Wrench]>,
    ) -> Result<(), StepError> {
        pause(model, &self.memory, &mut work.engine, &work.present_now, None)?;
        work.tell_of_masses();
        work.make_room_for_results(self.bodies.len());
        self.remember(work, told_loads, 0.0);
        core::mem::swap(&mut work.present_now, &mut work.present);
        core::mem::swap(&mut work.loads_now, &mut work.loads);
        Ok(())
    }

    /// The host's present and its loads, into `work.present_now` and `work.loads_now`.
    fn predict(&self, model: &Model, work: &mut HostWorkspace, told_loads: Option<&[Wrench]>) {
        let bodies = self.bodies.len();
        let delay_steps = self.settings.delay_steps as usize;
        let forgotten = self.steps_given().saturating_sub(delay_steps);
        let since_shown = &self.given[forgotten * bodies..];
        work.present_now.clear();
        work.loads_now.clear();
        for (index, next) in work.next.iter().enumerate() {
            let mut state = next.shown;
            for given in since_shown.iter().skip(index).step_by(bodies) {
                let load = given.told.unwrap_or(next.observed);
                let inverse = &model.ranked.rest(model.rank_of[index] as usize).inverse;
                let integration = self.settings.integration;
                state = predictor::next(integration, inverse, &state, given, &load);
            }
            work.present_now.push(state);
            work.loads_now.push(told_loads.map_or(next.observed, |loads| loads[index]));
        }
    }

    /// Where the engine begins, into `work.starts` and `work.leads`.
    fn set_out(&self, model: &Model, work: &mut HostWorkspace, step_s: f64) {
        let is_steady = is_steady(self.last_step_s, step_s);
        let integration = self.settings.integration;
        // A forward Euler host that was steered exactly has the engine a step ahead.
        let early_s = match integration {
            HostIntegration::ForwardEuler => self.last_step_s,
            HostIntegration::SemiImplicit => 0.0,
        };
        work.starts.clear();
        work.leads.clear();
        for index in 0..work.present_now.len() {
            let (present, ahead) = (work.present_now[index], work.next[index].ahead);
            if is_steady && ahead.is_none_or(|lead| lead.exact) {
                let lead = match ahead {
                    None => self.to_the_engines_time(model, work, index, step_s),
                    Some(lead) => {
                        let inverse = &model.ranked.rest(model.rank_of[index] as usize).inverse;
                        let load = &work.loads_now[index];
                        lead.velocity.plus(steering::half_kick(inverse, &present, load, step_s))
                    }
                };
                work.starts.push(steering::start(integration, &present, lead, step_s));
                work.leads.push(Start { exact: true, ..Start::default() });
                continue;
            }
            let start = lead::start_varying(ahead.as_ref(), &present, early_s);
            let velocity = Velocity::of(&present).plus(start.velocity);
            work.starts.push(velocity.of_a_body_at(&start.way.from(&present)));
            work.leads.push(start);
        }
    }

    /// What brings the velocity of a body that goes by its host's steady steps alone, the mean over the last of them, to
    /// where the engine takes it to belong: the middle of its own last sub-step, or, before any, the body's place.
    fn to_the_engines_time(
        &self,
        model: &Model,
        work: &HostWorkspace,
        index: usize,
        step_s: f64,
    ) -> Velocity {
        let rank = model.rank_of[index] as usize;
        let left_s = self.memory.behind_s.get(rank).map_or(0.0, |&left_s| greater(left_s, 0.0));
        let inverse = &model.ranked.rest(rank).inverse;
        let (present, load) = (&work.present_now[index], &work.loads_now[index]);
        inertia::kick(inverse, present, load, 0.5 * step_s - left_s)
    }

    /// Says of which bodies the velocities are those that the engine left: of those that are steered exactly. What
    /// another step owes of the others' would be paid in this one, by a wrench many times the contact's.
    fn leave_velocities(&mut self, model: &Model, work: &mut HostWorkspace) {
        let behind_s = &mut self.memory.behind_s;
        work.behind_s.clone_from(behind_s);
        if behind_s.is_empty() {
            return;
        }
        for (index, start) in work.leads.iter().enumerate() {
            if !start.exact {
                behind_s[model.rank_of[index] as usize] = NOT_BEHIND;
            }
        }
    }

    /// The step is done.
    fn remember(&mut self, work: &HostWorkspace, told_loads: Option<&[Wrench]>, step_s: f64) {
        let bodies = self.bodies.len();
        if self.steps_given() > self.settings.delay_steps as usize {
            self.given.drain(..bodies);
        }
        for (index, &wrench) in work.wrenches.iter().enumerate() {
            let told = told_loads.map(|loads| loads[index]);
            self.given.push(Given { step_s, wrench, told });
        }
        self.bodies.clone_from(&work.next);
        if step_s > 0.0 {
            self.last_step_s = step_s;
        }
    }

    /// Wrenches for the host from the way that the engine went, into `work.wrenches`; and how far its motion
    /// is ahead of the host's.
    fn steer(&self, model: &Model, work: &mut HostWorkspace, step_s: f64) {
        work.find_touching(model);
        work.wrenches.clear();
        work.wrenches.extend_from_slice(work.engine.wrenches());
        for (index, next) in work.next.iter_mut().enumerate() {
            let inverse = &model.ranked.rest(model.rank_of[index] as usize).inverse;
            let touches = work.touching[index];
            if !inverse.floats() || (!touches && next.ahead.is_none()) {
                continue;
            }
            let (present, load) = (&work.present_now[index], &work.loads_now[index]);
            let (begun, end) = (&work.starts[index], &work.engine.states_after()[index]);
            let start = &work.leads[index];
            let after = if start.exact {
                let mean = Velocity::mean(begun, end, step_s);
                let half_kick = steering::half_kick(inverse, present, load, step_s);
                next.ahead = touches.then(|| Lead {
                    velocity: Velocity::of(end).minus(mean).minus(half_kick),
                    half_kick,
                    exact: true,
                    ..Lead::default()
                });
                mean
            } else {
                self.follow(next, start, end, (present, touches), step_s)
            };
            let mobility = &model.bodies()[index].mobility;
            work.wrenches[index] = steering::wrench(mobility, present, after, load, step_s);
        }
    }

    /// The velocity with which a host whose step varies is to end a step, and what the engine is ahead then.
    fn follow(
        &self,
        next: &mut Followed,
        start: &Start,
        end: &BodyState,
        (present, touches): (&BodyState, bool),
        step_s: f64,
    ) -> Velocity {
        let due_s = next.ahead.map_or(0.0, |lead| lead.due_s);
        if !touches && lead::is_near(start.way) {
            next.ahead = lead::paid_off(start.velocity, due_s, step_s);
            let left = next.ahead.map_or(Velocity::default(), |lead| lead.velocity);
            return Velocity::of(end).minus(left);
        }
        let left = lead::closed(start, step_s);
        let after = Velocity::of(end).minus(left);
        let arrival = steering::arrival(self.settings.integration, present, after, step_s);
        next.ahead = Some(lead::apart(left, Way::between(&arrival, end)));
        after
    }
}
