//! Buffers and results of a step.

use alloc::vec;
use alloc::vec::Vec;

use crate::geometry::clip::ClipBuffers;
use crate::inherit::Inherited;
use crate::memory::{HintMemory, PatchMemory};
use crate::model::{MaterialId, Model};
use crate::overlap::{Patch, PieceLens};
use crate::report::{Contact, Event, Wrench};
use crate::state::BodyState;
use crate::vec2::{Pose, Vec2};

/// Buffers that a step writes to, and what it found. Nothing in it matters to the next step: it
/// can be shared between runs of the same model or thrown away at any time.
#[derive(Clone, Debug)]
pub struct Workspace {
    pub(crate) contacts: Vec<Contact>,
    pub(crate) wrenches: Vec<Wrench>,
    pub(crate) events: Vec<Event>,
    /// States by rank.
    pub(crate) states: Vec<BodyState>,
    /// Poses by rank, with the heading each rotation was computed from.
    pub(crate) poses: Vec<Pose>,
    pub(crate) headings_rad: Vec<f64>,
    /// Bodies that jumped, by rank.
    pub(crate) teleported: Vec<bool>,
    pub(crate) candidates: Vec<Candidate>,
    /// Order of the bodies along the x axis, warm from the last step.
    pub(crate) by_x: Vec<(f64, u32)>,
    pub(crate) patches: Vec<Patch>,
    /// What each patch takes over from the last step.
    pub(crate) inherited: Vec<Inherited>,
    pub(crate) lenses: Vec<PieceLens>,
    pub(crate) outline_m: Vec<Vec2>,
    pub(crate) clip: ClipBuffers,
    pub(crate) next_patches: Vec<PatchMemory>,
    pub(crate) next_hints: Vec<HintMemory>,
}

/// A pair of bodies near enough to touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Candidate {
    pub(crate) a: u32,
    pub(crate) b: u32,
    pub(crate) material: MaterialId,
}

impl Workspace {
    /// Buffers for a model.
    #[must_use]
    pub fn new(model: &Model) -> Workspace {
        let count = model.bodies().len();
        Workspace {
            contacts: Vec::new(),
            wrenches: vec![Wrench::default(); count],
            events: Vec::new(),
            states: Vec::with_capacity(count),
            poses: Vec::with_capacity(count),
            headings_rad: Vec::with_capacity(count),
            teleported: Vec::with_capacity(count),
            candidates: Vec::new(),
            by_x: Vec::new(),
            patches: Vec::new(),
            inherited: Vec::new(),
            lenses: Vec::new(),
            outline_m: Vec::new(),
            clip: ClipBuffers::default(),
            next_patches: Vec::new(),
            next_hints: Vec::new(),
        }
    }

    /// Contacts of the last step, sorted by the bodies' keys and patch.
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Sum of the contact forces on each body in the last step, one a body.
    #[must_use]
    pub fn wrenches(&self) -> &[Wrench] {
        &self.wrenches
    }

    /// Events of the last step.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }
}
