//! Hosts that pass the present states and all loads, and may integrate the bodies themselves.

use alloc::vec;
use alloc::vec::Vec;

use crate::error::StepError;
use crate::host::inertia;
use crate::host::lead::{self, Lead, Start};
use crate::host::velocity::{Offset, Velocity};
use crate::host::workspace::HostWorkspace;
use crate::maths::number::bounded;
use crate::model::Model;
use crate::model::material::BodyId;
use crate::pause::pause;
use crate::state::body_state::BodyState;
use crate::state::memory::Memory;
use crate::state::report::Wrench;

/// Largest deviation of a body's position from the path that its velocities give, as a share of the body's radius. The
/// engine's contact memory uses the same share of the radius.
const ALLOWANCE: f64 = 0.1;

/// Largest deviation of the velocity change of a body in the host from the change that the wrench gives, as a share of
/// this change. If the deviation is larger, the host does not move the body by the wrench of the engine.
const UNANSWERED: f64 = 0.5;

/// Contact by the coupled method for a host that passes the states at the start of each step, and all loads.
///
/// The host may let the engine move the bodies, by passing [`HostWorkspace::states_after`] unchanged. With a host that
/// lets the engine move the bodies, a step is the same as [`crate::advance_from_engine_states`]. A host may also
/// integrate the bodies itself with the wrenches, by any method and in steps of any length. While bodies touch, the
/// engine then continues its own motion of the bodies and not the host's motion. The host's motion and the engine's
/// motion differ by up to ½ a Δt²; if the engine took the host's motion, stiff contacts would chatter.
///
/// If the host moves a body regardless of the wrench, for example on a prescribed path, the engine computes the contact
/// forces at the states that the host passes.
///
/// All state of the host is plain data, as in [`Memory`].
#[derive(Clone, Debug, PartialEq)]
pub struct DirectHost {
    pub(super) memory: Memory,
    /// One record per body, in the order in which bodies were added.
    pub(super) bodies: Vec<DirectRecord>,
    /// Length of the last step that was not a pause (s); 0 before the first step.
    pub(super) last_step_s: f64,
}

/// What a direct host remembers about one body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct DirectRecord {
    /// The state of the body at the start of the last step, and the engine's state at the end of this step.
    pub(super) input: BodyState,
    pub(super) after: BodyState,
    /// Sum of the returned wrench and the load of the last step.
    pub(super) sum: Wrench,
    /// The wrench returned.
    pub(super) wrench: Wrench,
    /// How far the engine's velocity of the body is ahead of the host's velocity; `None` if the body had no contact.
    pub(super) ahead: Option<Lead>,
}

impl DirectHost {
    /// Makes a host whose bodies have never touched.
    #[must_use]
    pub fn new(model: &Model) -> DirectHost {
        DirectHost {
            memory: Memory::new(model),
            bodies: vec![DirectRecord::default(); model.bodies().len()],
            last_step_s: 0.0,
        }
    }

    /// Makes this host a copy of the host `other`. Memory is allocated only if a buffer is too small.
    pub fn copy_from(&mut self, other: &DirectHost) {
        self.memory.copy_from(&other.memory);
        self.bodies.clone_from(&other.bodies);
        self.last_step_s = other.last_step_s;
    }

    /// The contacts' memory.
    #[must_use]
    pub fn memory(&self) -> &Memory {
        &self.memory
    }

    /// Marks a body as teleported, as [`Memory::mark_teleported`] does.
    ///
    /// # Panics
    /// Panics if the model has no such body.
    pub fn mark_teleported(&mut self, model: &Model, body: BodyId) {
        self.memory.mark_teleported(model, body);
        self.bodies[body.0 as usize].ahead = None;
    }

    /// Does one step, like [`crate::advance_from_engine_states`]. Returns, for each body, the wrench that the host adds
    /// to its forces on the body.
    ///
    /// # Errors
    /// Returns the errors of [`crate::advance_from_engine_states`]; after an error this host is unchanged.
    pub fn step<'w>(
        &mut self,
        model: &Model,
        work: &'w mut HostWorkspace,
        states: &[BodyState],
        loads: &[Wrench],
        step_s: f64,
    ) -> Result<&'w [Wrench], StepError> {
        if step_s == 0.0 {
            pause(model, &self.memory, &mut work.engine, states, Some(loads))?;
            work.make_room_for_results(states.len());
            return Ok(&work.wrenches);
        }
        self.compute_starts(model, work, states);
        work.loads_now.clear();
        work.loads_now.extend_from_slice(loads);
        work.advance(model, &mut self.memory, step_s)?;
        self.compute_wrenches(model, work, (states, loads), step_s);
        self.last_step_s = step_s;
        Ok(&work.wrenches)
    }

    /// Computes the states from which the engine starts, and writes them into `work.starts` and `work.leads`.
    fn compute_starts(&self, model: &Model, work: &mut HostWorkspace, states: &[BodyState]) {
        work.starts.clear();
        work.leads.clear();
        for (index, state) in states.iter().enumerate() {
            // The engine refuses a wrong number of states, and bad ones.
            let record = self.bodies.get(index);
            let continues = record.is_some_and(|record| state.apart(&record.after) == 0);
            let record = record.and_then(|record| self.apart(model, index, record, state));
            let start = Start { exact: continues, ..record.unwrap_or_default() };
            let place = start.offset.applied_to(state);
            let velocity = Velocity::of(state).plus(start.velocity);
            work.starts.push(if record.is_some() { velocity.of_body_at(&place) } else { *state });
            work.leads.push(start);
        }
    }

    /// The offset of the engine from a host that integrates the body itself; `None` if the engine starts from the input
    /// state.
    fn apart(
        &self,
        model: &Model,
        index: usize,
        record: &DirectRecord,
        state: &BodyState,
    ) -> Option<Start> {
        let lead = record.ahead?;
        if state.apart(&record.after) == 0 {
            return None;
        }
        let body = &model.bodies()[index];
        let radius_m = body.outline.radius_m();
        let inverse = model.inverse_of(index);
        let kick = |wrench| inertia::kick(inverse, &record.input, wrench, self.last_step_s);
        let change = Velocity::of(state).minus(Velocity::of(&record.input));
        let off_mps = change.minus(kick(&record.sum)).at(radius_m);
        let off_m = path_error(&record.input, state, self.last_step_s);
        let answers = off_mps <= UNANSWERED * kick(&record.wrench).at(radius_m);
        if !answers || off_m.linear_m.length() > ALLOWANCE * radius_m {
            return None;
        }
        let offset = Offset::between(state, &record.after).plus(off_m);
        Some(Start { exact: false, velocity: lead.velocity, offset })
    }

    /// Computes the wrenches of the step, writes them into `work.wrenches`, and updates the records of the bodies.
    fn compute_wrenches(
        &mut self,
        model: &Model,
        work: &mut HostWorkspace,
        (states, loads): (&[BodyState], &[Wrench]),
        step_s: f64,
    ) {
        for (index, record) in self.bodies.iter_mut().enumerate() {
            let inverse = model.inverse_of(index);
            let (touches, start) = (work.touching[index], &work.leads[index]);
            record.input = states[index];
            record.after = work.engine.states_after()[index];
            if !inverse.floats() || (!touches && record.ahead.is_none()) {
                continue;
            }
            let due_s = record.ahead.map_or(0.0, |lead| lead.due_s);
            record.ahead = if !touches && lead::is_near(start.offset) {
                lead::decayed(start.velocity, due_s, step_s)
            } else {
                Some(lead::apart(lead::closed(start, step_s), Offset::default()))
            };
            let left = record.ahead.map_or(Velocity::default(), |lead| lead.velocity);
            let mobility = &model.bodies()[index].mobility;
            let owed = inertia::impulse_for(mobility, &states[index], start.velocity.minus(left));
            let wrench = &mut work.wrenches[index];
            wrench.force_n += owed.force_n * (1.0 / step_s);
            wrench.moment_nm += owed.moment_nm / step_s;
            record.wrench = *wrench;
            record.sum = wrench.plus(&loads[index]);
        }
    }
}

/// The part of a body's displacement that no combination of the old and the new velocity explains.
fn path_error(from: &BodyState, to: &BodyState, step_s: f64) -> Offset {
    let (first, second) =
        (Velocity::of(from).displacement(step_s), Velocity::of(to).displacement(step_s));
    let gone = Offset::between(from, to);
    let share =
        |over: f64, whole: f64| if whole > 0.0 { bounded(over / whole, 0.0, 1.0) } else { 0.0 };
    let (off_m, apart_m) = (gone.linear_m - first.linear_m, second.linear_m - first.linear_m);
    let (off_rad, apart_rad) =
        (gone.rotation_rad - first.rotation_rad, second.rotation_rad - first.rotation_rad);
    Offset {
        linear_m: off_m - apart_m * share(off_m.dot(apart_m), apart_m.length_squared()),
        rotation_rad: off_rad - apart_rad * share(off_rad * apart_rad, apart_rad * apart_rad),
    }
}
