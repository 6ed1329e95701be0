//! What a step reports.

use alloc::vec;
use alloc::vec::Vec;

use crate::coupled::peaks::PeakWrench;
use crate::error::StepError;
use crate::model::Model;
use crate::panel::report::PanelMotion;
use crate::pile::PileMotion;
use crate::report::{Contact, Displacement, Event, EventKind, Wrench};
use crate::room::room_for;
use crate::state::BodyState;

/// Results of the last step, by body id. Written by stages 1, 5 and 6.
#[derive(Clone, Debug)]
pub(crate) struct Results {
    /// Layout of the model whose bodies the results describe; `None` after a step that failed halfway.
    pub(crate) layout: Option<u64>,
    /// Whether contacts are reported one by one.
    pub(crate) reports_contacts: bool,
    pub(crate) contacts: Vec<Contact>,
    /// Sum of the contact forces on each body: the mean over the step.
    pub(crate) wrenches: Vec<Wrench>,
    pub(crate) events: Vec<Event>,
    /// Panels that were pressed.
    pub(crate) panels: Vec<PanelMotion>,
    /// Chains that have parted, before and in this step.
    pub(crate) parted: Vec<u32>,
    /// Motion of the piles, by rank.
    pub(crate) piles: Vec<PileMotion>,
    /// In the coupled method: states at the end of the step.
    pub(crate) states_after: Vec<BodyState>,
    /// In the coupled method: how far each body moved in the step.
    pub(crate) displacements: Vec<Displacement>,
    /// In the coupled method: greatest wrenches of bodies whose contacts took several sub-steps.
    pub(crate) peaks: Vec<PeakWrench>,
}

impl Results {
    /// Results for `count` bodies, with room for this number of contacts.
    pub(crate) fn new(count: usize, contacts: usize) -> Results {
        Results {
            layout: None,
            reports_contacts: true,
            contacts: room_for(contacts),
            wrenches: vec![Wrench::default(); count],
            events: room_for(contacts),
            panels: Vec::new(),
            parted: Vec::new(),
            piles: Vec::new(),
            states_after: room_for(count),
            displacements: room_for(count),
            peaks: Vec::new(),
        }
    }

    /// Resets to the results before the first step. The setting whether contacts are reported stays.
    pub(crate) fn forget(&mut self) {
        self.layout = None;
        self.clear_forces(self.wrenches.len());
        self.events.clear();
        self.parted.clear();
        self.piles.clear();
        self.states_after.clear();
        self.displacements.clear();
    }

    /// Clears contacts and wrenches for `count` bodies. Events stay, because stage 1 has already written them.
    pub(crate) fn clear_forces(&mut self, count: usize) {
        self.contacts.clear();
        self.panels.clear();
        self.peaks.clear();
        self.wrenches.clear();
        self.wrenches.resize(count, Wrench::default());
    }

    /// Drops the last step's events and reports the bodies that were teleported.
    pub(crate) fn begin_events(&mut self, model: &Model, teleported: &[u32]) {
        self.events.clear();
        for &rank in teleported {
            let bodies = model.ids_of([rank, rank]);
            self.events.push(Event { bodies, kind: EventKind::Teleported });
        }
    }

    /// Finds the first body with a non-finite state or wrench.
    pub(crate) fn not_finite(&self, model: &Model) -> Option<StepError> {
        let is_finite = |id: usize| {
            let (state, wrench) = (&self.states_after[id], &self.wrenches[id]);
            state.position_m.is_finite()
                && state.velocity_mps.is_finite()
                && state.heading_rad.is_finite()
                && state.yaw_rate_radps.is_finite()
                && wrench.force_n.is_finite()
                && wrench.moment_nm.is_finite()
        };
        let (_, body) = model.bodies().iter().enumerate().find(|&(id, _)| !is_finite(id))?;
        Some(StepError::NotFinite { body: body.name.clone() })
    }
}
