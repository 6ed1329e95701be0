//! What a step reports.

use alloc::vec;
use alloc::vec::Vec;

use crate::coupled::peaks::PeakWrench;
use crate::error::StepError;
use crate::maths::room::room_for;
use crate::model::Model;
use crate::model::pile::PileMotion;
use crate::panel::report::PanelMotion;
use crate::state::body_state::BodyState;
use crate::state::report::{Contact, Displacement, Event, EventKind, Wrench};

/// Results of the last step, in lists by body id. Stages 1, 5 and 6 of the step write the results.
#[derive(Clone, Debug)]
pub(crate) struct Results {
    /// Layout of the model whose bodies the results describe; `None` after a step that failed halfway.
    pub(crate) layout: Option<u64>,
    /// True if contacts are reported one by one.
    pub(crate) reports_contacts: bool,
    pub(crate) contacts: Vec<Contact>,
    /// Sum of the contact forces on each body, as the mean over the step.
    pub(crate) wrenches: Vec<Wrench>,
    pub(crate) events: Vec<Event>,
    /// Panels that were pressed.
    pub(crate) panels: Vec<PanelMotion>,
    /// Chains of fender panels that have parted, before and in this step.
    pub(crate) parted: Vec<u32>,
    /// Motion of the piles, in the order of the ranks of their bodies.
    pub(crate) piles: Vec<PileMotion>,
    /// In the coupled method: states of the bodies at the end of the step.
    pub(crate) states_after: Vec<BodyState>,
    /// In the coupled method: how far each body moved in the step.
    pub(crate) displacements: Vec<Displacement>,
    /// In the coupled method: greatest wrenches of the bodies whose contacts took several sub-steps.
    pub(crate) peaks: Vec<PeakWrench>,
}

impl Results {
    /// Makes the results of a model with `count` bodies, with room for this number of contacts.
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

    /// Resets the results to those before the first step. The setting that tells whether contacts are reported stays.
    pub(crate) fn forget(&mut self) {
        self.layout = None;
        self.clear_forces(self.wrenches.len());
        self.events.clear();
        self.parted.clear();
        self.piles.clear();
        self.states_after.clear();
        self.displacements.clear();
    }

    /// Clears the contacts and the wrenches of `count` bodies. Events stay, because stage 1 of the step has already
    /// written them.
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

    /// Finds the first body whose state or wrench is not finite.
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
