//! A co-simulation host: the memory of the host, and one step of it from start to end.

use alloc::vec;
use alloc::vec::Vec;

use crate::admit;
use crate::error::StepError;
use crate::host::inertia;
use crate::host::lead::{self, Lead, Start, is_steady};
use crate::host::past_step::PastStep;
use crate::host::record::BodyRecord;
use crate::host::settings::{HostIntegration, HostSettings};
use crate::host::steering;
use crate::host::velocity::{Offset, Velocity};
use crate::host::workspace::HostWorkspace;
use crate::host::{observer, predictor};
use crate::maths::number::greater;
use crate::model::Model;
use crate::model::material::BodyId;
use crate::pause::pause;
use crate::state::body_state::BodyState;
use crate::state::memory::Memory;
use crate::state::report::Wrench;

/// Contact by the coupled method for a co-simulation host. A co-simulation host integrates the bodies itself, with a
/// step that may vary. A co-simulation host may pass states that are some steps old, and need not report its loads.
///
/// The host integrates M(v′ − v)/Δt = W + load. W is the wrench from the engine, and M the model's mass matrix at the
/// body's heading at the start of the step. The wrenches of [`CoSimHost::step`] make the host's positions follow the
/// engine's motion in sub-steps for any Δt: the same rebound, and the same depth at rest. With a constant step, the
/// host's positions during a contact are the engine's positions, and the host's velocities are means over a step. If
/// the step changes during a contact, the host's velocities are the engine's velocities, and the host's positions
/// differ by up to ½ a Δt². The difference of the positions decays in some 10 s.
///
/// All state of the host is plain data, as in [`Memory`]: copy the host to branch a run, compare it, save it with
/// [`CoSimHost::snapshot`], and restore it with [`CoSimHost::restore`].
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
/// // A tug of 1000 t moves towards a quay at 2 m/s, γ = 0.1. The states passed are one step old.
/// let quay = BodyState { position_m: vec2(11.0, 0.0), ..Default::default() };
/// let mut tug = BodyState { velocity_mps: vec2(2.0, 0.0), ..Default::default() };
/// let mut delayed = tug;
/// for _ in 0..200 {
///     let wrenches = host.step(&model, &mut work, &[delayed, quay], None, 0.1)?;
///     delayed = tug;
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
    /// One record per body, in the order in which bodies were added.
    pub(super) bodies: Vec<BodyRecord>,
    /// Wrenches and loads of the last steps, for at most `delay_steps` + 1 steps. The oldest step comes first, and each
    /// step has one entry per body.
    pub(super) past_steps: Vec<PastStep>,
    /// Length of the last step that was not a pause (s); 0 before the first step.
    pub(super) last_step_s: f64,
}

impl CoSimHost {
    /// Makes a host whose bodies have never touched.
    #[must_use]
    pub fn new(model: &Model, settings: HostSettings) -> CoSimHost {
        CoSimHost {
            settings,
            memory: Memory::new(model),
            bodies: vec![BodyRecord::default(); model.bodies().len()],
            past_steps: Vec::new(),
            last_step_s: 0.0,
        }
    }

    /// Resets the host: the next step counts as the first.
    pub fn reset(&mut self, model: &Model) {
        *self = CoSimHost::new(model, self.settings);
    }

    /// Makes this host a copy of the host `other`. Memory is allocated only if a buffer is too small.
    pub fn copy_from(&mut self, other: &CoSimHost) {
        self.settings = other.settings;
        self.memory.copy_from(&other.memory);
        self.bodies.clone_from(&other.bodies);
        self.past_steps.clone_from(&other.past_steps);
        self.last_step_s = other.last_step_s;
    }

    /// Marks the next input state of a body as a teleport. The body's contacts begin anew, no load is inferred from the
    /// displacement, and the body is pushed slowly out of any other body. See [`Memory::mark_teleported`].
    ///
    /// # Panics
    /// Panics if the model has no such body.
    pub fn mark_teleported(&mut self, model: &Model, body: BodyId) {
        self.memory.mark_teleported(model, body);
        self.bodies[body.0 as usize].placed = true;
    }

    /// The host's properties.
    #[must_use]
    pub fn settings(&self) -> HostSettings {
        self.settings
    }

    /// The contacts' memory.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// Does one step of the host. The host passes states that are `delay_steps` steps old. Returns the wrench on each
    /// body for the step of `step_s` seconds that begins now: in earth-fixed axes, about the centre of gravity, in the
    /// order in which bodies were added.
    ///
    /// `reported_loads` are all forces of this step except contact, as in [`crate::advance`]. If `reported_loads` is
    /// `None`, the engine uses the load that it observed last: M Δv/Δt of the host minus the wrench given to the host,
    /// Coriolis and centripetal terms included. The observed load is zero until two states are known. A sudden load
    /// becomes known one step later, plus the `delay_steps` of the host.
    ///
    /// The wrench on a fixed body is the mean contact wrench of the step. The wrench on a floating body comes up to one
    /// step late, so that the positions of host and engine agree. Although the wrench comes late, its impulse over the
    /// whole contact is the same.
    ///
    /// The next position of a forward Euler host does not depend on the wrench. If a body starts nearer to a contact
    /// than it moves in a step, the body will be inside the contact after the step. The wrench cannot balance a load
    /// that is not yet known: with a long Δt and a delay, a sudden load may push a body deep into a contact.
    ///
    /// A step of 0 s is a pause: nothing changes, and the returned wrenches are those of the last step.
    ///
    /// A body whose response to a hit does not match its mass in the model is reported once
    /// ([`crate::EventKind::MassMismatch`]). The rebound of a body with a wrong mass is right nevertheless, and its
    /// depth at rest is right within a tenth.
    ///
    /// If a body is not where its velocity leads, the host has teleported the body. After a teleport no load is
    /// inferred from the displacement, and the contacts of the body begin anew ([`crate::EventKind::Teleported`]).
    ///
    /// # Errors
    /// Returns the errors of [`crate::step()`] for states, loads and Δt, and an error if values computed from them are
    /// out of the engine's range. After an error this host is unchanged, and `work` keeps the results of the last good
    /// step.
    pub fn step<'w>(
        &mut self,
        model: &Model,
        work: &'w mut HostWorkspace,
        delayed_states: &[BodyState],
        reported_loads: Option<&[Wrench]>,
        step_s: f64,
    ) -> Result<&'w [Wrench], StepError> {
        admit::admit(model, &self.memory, delayed_states, step_s)?;
        if let Some(loads) = reported_loads {
            admit::admit_loads(model, delayed_states, loads)?;
        }
        self.observe(model, work, delayed_states);
        self.predict(model, work, reported_loads);
        if step_s == 0.0 {
            self.pause_step(model, work, reported_loads)?;
            return Ok(&work.wrenches);
        }
        self.compute_starts(model, work, step_s);
        work.advance(model, &mut self.memory, step_s)?;
        work.report_mass_mismatches();
        self.steer(model, work, step_s);
        self.remember(work, reported_loads, step_s);
        Ok(&work.wrenches)
    }

    /// Number of past steps that the host remembers.
    pub(super) fn past_step_count(&self) -> usize {
        self.past_steps.len() / self.bodies.len().max(1)
    }

    /// Computes the loads that follow from the input states, and writes them into `work.next`.
    fn observe(&self, model: &Model, work: &mut HostWorkspace, delayed_states: &[BodyState]) {
        work.next.clone_from(&self.bodies);
        work.mass_mismatches.clear();
        // Before the oldest remembered wrench belongs to the step between the last two input states, both of these are
        // the initial state.
        let has_two_states = self.past_step_count() > self.settings.delay_steps as usize;
        for (index, (next, &input)) in work.next.iter_mut().zip(delayed_states).enumerate() {
            if has_two_states {
                let given = &self.past_steps[index];
                let body = &model.bodies()[index];
                if next.placed
                    || observer::was_teleported(
                        self.settings.integration,
                        body,
                        &next.input,
                        &input,
                        given,
                    )
                {
                    next.ahead = None;
                    next.answers.forget();
                } else if given.step_s > 0.0
                    && let Some(load) = observer::load(body, &next.input, &input, given)
                {
                    next.observed = load;
                    let load = given.reported_load.unwrap_or(load);
                    if next.answers.note(body, (&next.input, &input), given, &load) {
                        work.mass_mismatches.push(BodyId(index as u32));
                    }
                }
            }
            if next.placed {
                next.ahead = None;
                next.placed = false;
            }
            next.input = input;
        }
    }

    /// Does a step of 0 s, which is a pause. A step of 0 s counts as one of the host's `delay_steps`.
    fn pause_step(
        &mut self,
        model: &Model,
        work: &mut HostWorkspace,
        reported_loads: Option<&[Wrench]>,
    ) -> Result<(), StepError> {
        pause(model, &self.memory, &mut work.engine, &work.present_now, None)?;
        work.report_mass_mismatches();
        work.make_room_for_results(self.bodies.len());
        self.remember(work, reported_loads, 0.0);
        Ok(())
    }

    /// Computes the host's present states and loads, and writes them into `work.present_now` and `work.loads_now`.
    fn predict(&self, model: &Model, work: &mut HostWorkspace, reported_loads: Option<&[Wrench]>) {
        let bodies = self.bodies.len();
        let delay_steps = self.settings.delay_steps as usize;
        let forgotten = self.past_step_count().saturating_sub(delay_steps);
        let since_input = &self.past_steps[forgotten * bodies..];
        work.present_now.clear();
        work.loads_now.clear();
        for (index, next) in work.next.iter().enumerate() {
            let mut state = next.input;
            for given in since_input.iter().skip(index).step_by(bodies) {
                let load = given.reported_load.unwrap_or(next.observed);
                let inverse = model.inverse_of(index);
                let integration = self.settings.integration;
                state = predictor::next(integration, inverse, &state, given, &load);
            }
            work.present_now.push(state);
            work.loads_now.push(reported_loads.map_or(next.observed, |loads| loads[index]));
        }
    }

    /// Computes the states from which the engine starts, and writes them into `work.starts` and `work.leads`.
    fn compute_starts(&self, model: &Model, work: &mut HostWorkspace, step_s: f64) {
        let is_steady = is_steady(self.last_step_s, step_s);
        let integration = self.settings.integration;
        // The engine is one step ahead of a forward Euler host that follows the engine exactly.
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
                    None => self.to_engine_time(model, work, index, step_s),
                    Some(lead) => {
                        let inverse = model.inverse_of(index);
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
            work.starts.push(velocity.of_body_at(&start.offset.applied_to(&present)));
            work.leads.push(start);
        }
    }

    /// The change of a body's velocity that shifts it from the host's time of velocities to the engine's. Without
    /// contact, the velocity of a host with steady steps is the mean velocity of its last step. The engine expects the
    /// velocity at the middle of its last sub-step or, before any sub-step, at the time of the position.
    fn to_engine_time(
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

    /// Remembers a step that ended without an error.
    fn remember(
        &mut self,
        work: &mut HostWorkspace,
        reported_loads: Option<&[Wrench]>,
        step_s: f64,
    ) {
        core::mem::swap(&mut work.present_now, &mut work.present);
        core::mem::swap(&mut work.loads_now, &mut work.loads);
        let bodies = self.bodies.len();
        if self.past_step_count() > self.settings.delay_steps as usize {
            self.past_steps.drain(..bodies);
        }
        for (index, &wrench) in work.wrenches.iter().enumerate() {
            let reported_load = reported_loads.map(|loads| loads[index]);
            self.past_steps.push(PastStep { step_s, wrench, reported_load });
        }
        self.bodies.clone_from(&work.next);
        if step_s > 0.0 {
            self.last_step_s = step_s;
        }
    }

    /// Computes the wrenches for the host from the engine's displacement of the bodies, and writes them into
    /// `work.wrenches`. Also updates how far the engine is ahead of the host.
    fn steer(&self, model: &Model, work: &mut HostWorkspace, step_s: f64) {
        for (index, next) in work.next.iter_mut().enumerate() {
            let inverse = model.inverse_of(index);
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

    /// The velocity at which a host with a varying step should end the step. Also updates how far the engine is ahead
    /// of the host after the step.
    fn follow(
        &self,
        next: &mut BodyRecord,
        start: &Start,
        end: &BodyState,
        (present, touches): (&BodyState, bool),
        step_s: f64,
    ) -> Velocity {
        let due_s = next.ahead.map_or(0.0, |lead| lead.due_s);
        if !touches && lead::is_near(start.offset) {
            next.ahead = lead::decayed(start.velocity, due_s, step_s);
            let left = next.ahead.map_or(Velocity::default(), |lead| lead.velocity);
            return Velocity::of(end).minus(left);
        }
        let left = lead::closed(start, step_s);
        let after = Velocity::of(end).minus(left);
        let arrival = steering::arrival(self.settings.integration, present, after, step_s);
        next.ahead = Some(lead::apart(left, Offset::between(&arrival, end)));
        after
    }
}
