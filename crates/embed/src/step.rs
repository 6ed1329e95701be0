//! The steps of an engine.

use std::mem;
use std::sync::Arc;

use fenderline_contact::{self as contact, BodyState, Mobility, Wrench};

use crate::engine::{Core, Engine, Latest, Plan};
use crate::error::EngineError;

impl Engine {
    /// Resets the engine to its start: it forgets contacts, states and loads. After the reset, the next step counts as
    /// the first step.
    pub fn reset(&mut self) {
        let recording = self.recording.take();
        *self = Engine::new(Arc::clone(&self.plan));
        self.recording = recording;
        self.restart_recording();
    }

    /// Takes one step of `step_s` seconds, from the states that were set last. A step of 0 s, as a paused host takes,
    /// moves nothing: the results are those of the last step, but without events and without the work of the contacts.
    ///
    /// # Errors
    /// Fails if the state of a floating body was never set, or if the step is neither 0 s nor from 1e-9 s to 1e6 s
    /// long.
    pub fn step(&mut self, step_s: f64) -> Result<(), EngineError> {
        let mut bodies = self.plan.model.bodies().iter().zip(&self.is_set);
        let unset = bodies.find(|(body, is_set)| !**is_set && body.mobility != Mobility::Fixed);
        if let Some((body, _)) = unset {
            return Err(EngineError::StateNotSet { body: body.name.clone() });
        }
        self.make_room_in_recording();
        let Engine { plan, core, spare, states, is_set, loads, no_loads, recording, .. } = self;
        if let Some(recording) = recording {
            recording.begin_step(states, is_set, loads.as_deref(), step_s);
        }
        let done = spare.take_step(core, plan, states, loads.as_deref(), no_loads, step_s);
        if let (Some(recording), Err(_)) = (recording, &done) {
            recording.refuse_step();
        }
        done?;
        mem::swap(core, spare);
        self.keep_results(step_s);
        self.end_step_of_recording();
        Ok(())
    }

    /// Does [`Engine::set_states`], [`Engine::set_loads`] if loads are given, and [`Engine::step`] in one call; returns
    /// the wrenches. If one of the calls in [`Engine::advance`] fails, nothing changes.
    ///
    /// # Errors
    /// Fails as [`Engine::set_states`], [`Engine::set_loads`] or [`Engine::step`] does.
    pub fn advance(
        &mut self,
        states: &[BodyState],
        loads: Option<&[Wrench]>,
        step_s: f64,
    ) -> Result<&[Wrench], EngineError> {
        self.check_states(states)?;
        if let Some(loads) = loads {
            self.check_loads(loads)?;
        }
        self.make_room_in_recording();
        let step_loads = loads.or(self.loads.as_deref());
        let Engine { plan, core, spare, no_loads, recording, .. } = self;
        if let Some(recording) = recording {
            recording.begin_step(states, &[], step_loads, step_s);
        }
        let done = spare.take_step(core, plan, states, step_loads, no_loads, step_s);
        if let (Some(recording), Err(_)) = (recording, &done) {
            recording.refuse_step();
        }
        done?;
        mem::swap(core, spare);
        self.states.copy_from_slice(states);
        self.is_set.fill(true);
        if loads.is_some() {
            self.set_loads(loads)?;
        }
        self.keep_results(step_s);
        self.end_step_of_recording();
        Ok(self.results()?.wrenches)
    }

    /// Notes where the engine keeps its latest results: after a step, the results are in the workspace. A pause of a
    /// restored engine keeps the results that were saved with the engine.
    fn keep_results(&mut self, step_s: f64) {
        match &mut self.latest {
            Latest::Saved(saved) if step_s == 0.0 => saved.pause(&self.states),
            latest => *latest = Latest::InWorkspace,
        }
    }
}

impl Core {
    /// Takes a step from the state of the core `before`, which stays unchanged. After an error this core (`self`) is
    /// not valid until its next step.
    fn take_step(
        &mut self,
        before: &Core,
        plan: &Plan,
        states: &[BodyState],
        loads: Option<&[Wrench]>,
        no_loads: &[Wrench],
        step_s: f64,
    ) -> Result<(), EngineError> {
        let model = &plan.model;
        if step_s == 0.0 {
            // The results stay those of the last step.
            self.clone_from(before);
        }
        match (&mut *self, before) {
            (Core::Paper { memory, work }, Core::Paper { memory: now, .. }) => {
                memory.copy_from(now);
                contact::step(model, memory, work, states, step_s)?;
            }
            (Core::Direct { host, work }, Core::Direct { host: now, .. }) => {
                host.copy_from(now);
                host.step(model, work, states, loads.unwrap_or(no_loads), step_s)?;
            }
            (Core::CoSimulation { host, work }, Core::CoSimulation { host: now, .. }) => {
                host.copy_from(now);
                host.step(model, work, states, loads, step_s)?;
            }
            _ => unreachable!("both cores of an engine are for the same kind of host"),
        }
        if self.results().are_finite() { Ok(()) } else { Err(EngineError::NotFinite) }
    }
}
