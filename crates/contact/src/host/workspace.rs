//! Buffers and results of a step for hosts that integrate the bodies themselves.

use alloc::vec::Vec;

use crate::admit::refuse_piles;
use crate::coupled::advance_from_engine_states;
use crate::error::StepError;
use crate::host::lead::Start;
use crate::host::record::BodyRecord;
use crate::model::Model;
use crate::model::material::BodyId;
use crate::panel::report::PanelMotion;
use crate::state::body_state::BodyState;
use crate::state::memory::{Memory, NOT_BEHIND};
use crate::state::report::{Contact, Event, EventKind, Wrench};
use crate::state::workspace::Workspace;

/// Buffers and results of [`crate::CoSimHost::step`] and [`crate::DirectHost::step`]; the next step does not depend on
/// this workspace.
#[derive(Clone, Debug)]
pub struct HostWorkspace {
    pub(super) engine: Workspace,
    /// New records of the bodies; the host keeps these records if the step succeeds.
    pub(super) next: Vec<BodyRecord>,
    /// Present states of the bodies in the host, in the current step and in the last good step.
    pub(super) present_now: Vec<BodyState>,
    pub(super) present: Vec<BodyState>,
    /// States of the bodies from which the engine starts, and their offsets from the host's present states.
    pub(super) starts: Vec<BodyState>,
    pub(super) leads: Vec<Start>,
    /// Loads on the bodies in the current step, and in the last good step.
    pub(super) loads_now: Vec<Wrench>,
    pub(super) loads: Vec<Wrench>,
    pub(super) touching: Vec<bool>,
    /// Copy of the list `behind_s` in the memory, made before the step.
    pub(super) behind_s: Vec<f64>,
    /// Bodies whose response to the wrenches does not match their mass in the model.
    pub(super) mass_mismatches: Vec<BodyId>,
    pub(super) wrenches: Vec<Wrench>,
    pub(super) peaks: Vec<Wrench>,
}

impl HostWorkspace {
    /// Buffers for a model.
    #[must_use]
    pub fn new(model: &Model) -> HostWorkspace {
        let count = model.bodies().len();
        HostWorkspace {
            engine: Workspace::new(model),
            next: Vec::with_capacity(count),
            present_now: Vec::with_capacity(count),
            present: Vec::with_capacity(count),
            starts: Vec::with_capacity(count),
            leads: Vec::with_capacity(count),
            loads_now: Vec::with_capacity(count),
            loads: Vec::with_capacity(count),
            touching: Vec::with_capacity(count),
            behind_s: Vec::with_capacity(count),
            mass_mismatches: Vec::new(),
            wrenches: Vec::with_capacity(count),
            peaks: Vec::with_capacity(count),
        }
    }

    /// Adds events for the bodies whose response does not match their mass.
    pub(super) fn report_mass_mismatches(&mut self) {
        for &body in &self.mass_mismatches {
            self.engine
                .results
                .events
                .push(Event { bodies: [body, body], kind: EventKind::MassMismatch });
        }
    }

    /// Does the engine's step from `starts` under `loads_now`: computes wrenches, their peaks, and the bodies that
    /// touched. If the engine returns an error, the memory is unchanged.
    ///
    /// The memory holds by how much the engine's velocities are older than its positions. The memory marks each body
    /// whose velocity was given by the host. Without the mark, a correction that belongs to a step of another length
    /// would be applied in this step, by a wrench many times the contact wrench.
    pub(super) fn advance(
        &mut self,
        model: &Model,
        memory: &mut Memory,
        step_s: f64,
    ) -> Result<(), StepError> {
        refuse_piles(model)?;
        self.behind_s.clone_from(&memory.behind_s);
        for (start, &rank) in self.leads.iter().zip(&model.rank_of) {
            if !start.exact
                && let Some(behind_s) = memory.behind_s.get_mut(rank as usize)
            {
                *behind_s = NOT_BEHIND;
            }
        }
        let (starts, loads) = (&self.starts, &self.loads_now);
        advance_from_engine_states(model, memory, &mut self.engine, starts, loads, step_s)
            .inspect_err(|_| memory.behind_s.clone_from(&self.behind_s))?;
        self.engine.peak_wrenches_into(&mut self.peaks);
        self.wrenches.clear();
        self.wrenches.extend_from_slice(self.engine.wrenches());
        self.find_touching(model);
        Ok(())
    }

    /// Finds the bodies that touched in the engine's last step.
    fn find_touching(&mut self, model: &Model) {
        self.touching.clear();
        self.touching.resize(model.bodies().len(), false);
        for contact in self.engine.contacts() {
            self.touching[contact.body_1.0 as usize] = true;
            self.touching[contact.body_2.0 as usize] = true;
        }
    }

    /// The wrenches of the last step, one for each body. The host adds these wrenches to its other forces on the
    /// bodies.
    #[must_use]
    pub fn wrenches(&self) -> &[Wrench] {
        &self.wrenches
    }

    /// The largest contact wrench on each body within the last step, in the engine's motion: see
    /// [`Workspace::peak_wrenches_into`]. Use these peak wrenches to size structures; use [`HostWorkspace::wrenches`]
    /// to move the bodies.
    #[must_use]
    pub fn peak_wrenches(&self) -> &[Wrench] {
        &self.peaks
    }

    /// Fills the results with zeros if there are no results for this number of bodies.
    pub(super) fn make_room_for_results(&mut self, bodies: usize) {
        for results in [&mut self.wrenches, &mut self.peaks] {
            if results.len() != bodies {
                results.clear();
                results.resize(bodies, Wrench::default());
            }
        }
    }

    /// The present states of the bodies of a [`crate::CoSimHost`] that the last step estimated, one for each body. The
    /// host will pass the true values of these states later, when they are `delay_steps` old.
    #[must_use]
    pub fn estimated_states(&self) -> &[BodyState] {
        &self.present
    }

    /// The loads of the last step, reported or observed, one for each body.
    #[must_use]
    pub fn loads(&self) -> &[Wrench] {
        &self.loads
    }

    /// States of the bodies at the end of the last step of a [`crate::DirectHost`], like [`Workspace::states_after`].
    #[must_use]
    pub fn states_after(&self) -> &[BodyState] {
        self.engine.states_after()
    }

    /// Contacts in the engine's motion in the last step, like [`Workspace::contacts`].
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        self.engine.contacts()
    }

    /// Fender panels that were pressed in the last step, like [`Workspace::panels`].
    #[must_use]
    pub fn panels(&self) -> &[PanelMotion] {
        self.engine.panels()
    }

    /// Events of the last step, like [`Workspace::events`].
    #[must_use]
    pub fn events(&self) -> &[Event] {
        self.engine.events()
    }
}
