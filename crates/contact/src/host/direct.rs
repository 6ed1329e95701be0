//! Hosts that pass present states and all loads, and may integrate the bodies themselves.

use alloc::vec;
use alloc::vec::Vec;

use crate::error::StepError;
use crate::host::inertia;
use crate::host::lead::{self, Lead, Start};
use crate::host::velocity::{Offset, Velocity};
use crate::host::workspace::HostWorkspace;
use crate::material::BodyId;
use crate::memory::Memory;
use crate::model::Model;
use crate::number::bounded;
use crate::pause::pause;
use crate::report::Wrench;
use crate::state::BodyState;

/// Largest deviation of a body's position from the path that the velocities give, as a share of the body's radius. The
/// engine's contact memory uses the same share.
const ALLOWANCE: f64 = 0.1;

/// Largest deviation of a host's velocity change from the change that the wrench gives, as a share of that change. If
/// the deviation is larger, the host does not move the body by the wrench.
const UNANSWERED: f64 = 0.5;

/// The coupled method for a host that passes the states at the start of each step, and all loads.
///
/// The host may let the engine move the bodies, by passing [`HostWorkspace::states_after`] unchanged. A step is then
/// the same as [`crate::advance_from_engine_states`]. Or the host integrates the bodies itself with the wrenches, by
/// any method and in steps of any length. While bodies touch, the engine then continues its own motion and not the
/// host's. The two differ by up to ½ a Δt²; with the host's motion stiff contacts would chatter.
///
/// If the host moves a body regardless of the wrench, such as a body on a prescribed path, the engine computes the
/// contact forces at the states passed.
///
/// All state is plain data, as in [`Memory`].
#[derive(Clone, Debug, PartialEq)]
pub struct DirectHost {
    pub(super) memory: Memory,
    /// One record per body, in the order in which bodies were added.
    pub(super) bodies: Vec<DirectRecord>,
    /// Length of the last step that was not a pause; 0 before the first (s).
    pub(super) last_step_s: f64,
}

/// The memory of a direct host for one body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct DirectRecord {
    /// The last input state, and the engine's state at the end of that step.
    pub(super) input: BodyState,
    pub(super) after: BodyState,
    /// Sum of the wrench returned and the load.
    pub(super) sum: Wrench,
    /// The wrench returned.
    pub(super) wrench: Wrench,
    /// How far the engine's velocity is ahead of the host's; `None` if the body had no contact.
    pub(super) ahead: Option<Lead>,
}

impl DirectHost {
    /// A host whose bodies have never touched.
    #[must_use]
    pub fn new(model: &Model) -> DirectHost {
        DirectHost {
            memory: Memory::new(model),
            bodies: vec![DirectRecord::default(); model.bodies().len()],
            last_step_s: 0.0,
        }
    }

    /// Becomes a copy of `other`. Allocates only if a buffer is too small.
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
    /// If the model has no such body.
    pub fn mark_teleported(&mut self, model: &Model, body: BodyId) {
        self.memory.mark_teleported(model, body);
        self.bodies[body.0 as usize].ahead = None;
    }

    /// Does one step, as [`crate::advance_from_engine_states`]. Returns the wrench that the host adds to its forces on
    /// each body.
    ///
    /// # Errors
    /// As [`crate::advance_from_engine_states`]; this host is then unchanged.
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

    /// Computes the states from which the engine starts, into `work.starts` and `work.leads`.
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

    /// The engine's offset from a host that integrates the body itself; `None` if the engine starts from the input.
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

    /// Computes the wrenches of the step, into `work.wrenches`, and updates the records.
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
