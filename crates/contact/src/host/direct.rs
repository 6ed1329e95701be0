//! Hosts of the present that tell their loads, and may move their bodies by themselves.

use alloc::vec;
use alloc::vec::Vec;

use crate::coupled::advance_from_engine_states;
use crate::error::StepError;
use crate::host::inertia;
use crate::host::lead::{self, Lead, Start};
use crate::host::steering::{Velocity, Way};
use crate::host::workspace::HostWorkspace;
use crate::material::BodyId;
use crate::memory::{Memory, NOT_BEHIND};
use crate::model::Model;
use crate::number::bounded;
use crate::pause::pause;
use crate::report::Wrench;
use crate::state::BodyState;

/// Share of the body's radius that it may be away from where its velocities lead; as for the engine's own memory of
/// contacts.
const ALLOWANCE: f64 = 0.1;

/// Share of what a wrench does to the velocity that the host's velocity may be off and still be an answer to it.
const UNANSWERED: f64 = 0.5;

/// The coupled method for a host that shows the states of each step's beginning and tells its loads. It may let the
/// engine move its bodies, showing [`HostWorkspace::states_after`] again to the bit: then this is
/// [`crate::advance_from_engine_states`]. Or it moves them by itself, with the wrenches and whatever integrator, in steps of any
/// lengths: then the engine goes on from where it was itself while bodies touch, not from where the host's
/// integration came to, by half the acceleration times Δt² elsewhere. Stiff contacts chatter else.
///
/// A host that shows a body with velocities that no wrench changes, as one that is dragged along, gets the contact's
/// forces at the states shown.
///
/// All state is plain data, as [`Memory`] is.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectHost {
    pub(super) memory: Memory,
    /// In the order in which bodies were added.
    pub(super) bodies: Vec<Beside>,
    /// The length of the last step that was one; 0 before the first (s).
    pub(super) last_step_s: f64,
}

/// What is remembered of one body.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Beside {
    /// The last state shown, and where the engine came to from there.
    pub(super) shown: BodyState,
    pub(super) after: BodyState,
    /// The wrench given, with the load told.
    pub(super) sum: Wrench,
    /// The wrench alone.
    pub(super) wrench: Wrench,
    /// How far the engine's velocity is ahead; nothing where nothing touched the body.
    pub(super) ahead: Option<Lead>,
}

impl DirectHost {
    /// A host whose bodies have never touched.
    #[must_use]
    pub fn new(model: &Model) -> DirectHost {
        DirectHost {
            memory: Memory::new(model),
            bodies: vec![Beside::default(); model.bodies().len()],
            last_step_s: 0.0,
        }
    }

    /// Becomes a copy of `other` without allocating where the buffers are large enough.
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

    /// As [`Memory::mark_teleported`].
    ///
    /// # Panics
    /// Where the model has no such body.
    pub fn mark_teleported(&mut self, model: &Model, body: BodyId) {
        self.memory.mark_teleported(model, body);
        self.bodies[body.0 as usize].ahead = None;
    }

    /// One step, as [`crate::advance_from_engine_states`]; gives the wrench that each body is to be given for it.
    ///
    /// # Errors
    /// As [`crate::advance_from_engine_states`]; this host is then as it was.
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
        self.set_out(model, work, states);
        self.leave_velocities(model, work, states);
        let (memory, engine) = (&mut self.memory, &mut work.engine);
        if let Err(error) =
            advance_from_engine_states(model, memory, engine, &work.starts, loads, step_s)
        {
            memory.behind_s.clone_from(&work.behind_s);
            return Err(error);
        }
        work.engine.peak_wrenches_into(&mut work.peaks);
        self.lead_on(model, work, (states, loads), step_s);
        self.last_step_s = step_s;
        Ok(&work.wrenches)
    }

    /// Says of which bodies the velocities are those that the engine left, and keeps what the memory said.
    fn leave_velocities(&mut self, model: &Model, work: &mut HostWorkspace, states: &[BodyState]) {
        let behind_s = &mut self.memory.behind_s;
        work.behind_s.clone_from(behind_s);
        if behind_s.is_empty() {
            return;
        }
        for (index, (beside, state)) in self.bodies.iter().zip(states).enumerate() {
            if state.apart(&beside.after) != 0 {
                behind_s[model.rank_of[index] as usize] = NOT_BEHIND;
            }
        }
    }

    /// Where the engine begins, into `work.starts` and `work.leads`.
    fn set_out(&self, model: &Model, work: &mut HostWorkspace, states: &[BodyState]) {
        work.starts.clear();
        work.leads.clear();
        for (index, state) in states.iter().enumerate() {
            // A wrong number of states, or bad ones, are the engine's to refuse.
            let beside =
                self.bodies.get(index).and_then(|beside| self.apart(model, index, beside, state));
            let start = beside.unwrap_or_default();
            let place = start.way.from(state);
            let velocity = Velocity::of(state).plus(start.velocity);
            work.starts.push(if beside.is_some() { velocity.of_a_body_at(&place) } else { *state });
            work.leads.push(start);
        }
    }

    /// How far the engine is from a host that moves the body by itself; `None` where it goes on from what is shown.
    fn apart(
        &self,
        model: &Model,
        index: usize,
        beside: &Beside,
        state: &BodyState,
    ) -> Option<Start> {
        let lead = beside.ahead?;
        if state.apart(&beside.after) == 0 {
            return None;
        }
        let body = &model.bodies()[index];
        let radius_m = body.outline.radius_m();
        let inverse = &model.ranked.rest(model.rank_of[index] as usize).inverse;
        let kick = |wrench| inertia::kick(inverse, &beside.shown, wrench, self.last_step_s);
        let change = Velocity::of(state).minus(Velocity::of(&beside.shown));
        let off_mps = change.minus(kick(&beside.sum)).at(radius_m);
        let off_m = off_course(&beside.shown, state, self.last_step_s);
        let answers = off_mps <= UNANSWERED * kick(&beside.wrench).at(radius_m);
        if !answers || off_m.linear_m.length() > ALLOWANCE * radius_m {
            return None;
        }
        let way = Way::between(state, &beside.after).plus(off_m);
        Some(Start { exact: false, velocity: lead.velocity, way })
    }

    /// The wrenches of the step, into `work.wrenches`, and what is remembered of it.
    fn lead_on(
        &mut self,
        model: &Model,
        work: &mut HostWorkspace,
        (states, loads): (&[BodyState], &[Wrench]),
        step_s: f64,
    ) {
        work.find_touching(model);
        work.wrenches.clear();
        work.wrenches.extend_from_slice(work.engine.wrenches());
        for (index, beside) in self.bodies.iter_mut().enumerate() {
            let inverse = &model.ranked.rest(model.rank_of[index] as usize).inverse;
            let (touches, start) = (work.touching[index], &work.leads[index]);
            beside.shown = states[index];
            beside.after = work.engine.states_after()[index];
            if !inverse.floats() || (!touches && beside.ahead.is_none()) {
                continue;
            }
            let due_s = beside.ahead.map_or(0.0, |lead| lead.due_s);
            beside.ahead = if !touches && lead::is_near(start.way) {
                lead::paid_off(start.velocity, due_s, step_s)
            } else {
                Some(lead::apart(lead::closed(start, step_s), Way::default()))
            };
            let left = beside.ahead.map_or(Velocity::default(), |lead| lead.velocity);
            let mobility = &model.bodies()[index].mobility;
            let owed = inertia::impulse_for(mobility, &states[index], start.velocity.minus(left));
            let wrench = &mut work.wrenches[index];
            wrench.force_n += owed.force_n * (1.0 / step_s);
            wrench.moment_nm += owed.moment_nm / step_s;
            beside.wrench = *wrench;
            beside.sum = Wrench {
                force_n: wrench.force_n + loads[index].force_n,
                moment_nm: wrench.moment_nm + loads[index].moment_nm,
            };
        }
    }
}

/// How far a body is from where its two velocities lead it, whatever lies between them.
fn off_course(from: &BodyState, to: &BodyState, step_s: f64) -> Way {
    let (first, second) = (Velocity::of(from).way(step_s), Velocity::of(to).way(step_s));
    let gone = Way::between(from, to);
    let share =
        |over: f64, whole: f64| if whole > 0.0 { bounded(over / whole, 0.0, 1.0) } else { 0.0 };
    let (off_m, apart_m) = (gone.linear_m - first.linear_m, second.linear_m - first.linear_m);
    let (off_rad, apart_rad) =
        (gone.rotation_rad - first.rotation_rad, second.rotation_rad - first.rotation_rad);
    Way {
        linear_m: off_m - apart_m * share(off_m.dot(apart_m), apart_m.length_squared()),
        rotation_rad: off_rad - apart_rad * share(off_rad * apart_rad, apart_rad * apart_rad),
    }
}
