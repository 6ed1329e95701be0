//! Buffers and results of a step.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use crate::coupled::bodies::Sums;
use crate::coupled::island::{Island, IslandMemory};
use crate::coupled::leap::Trial;
use crate::coupled::peaks::{self, Peak};
use crate::coupled::rows::Row;
use crate::coupled::tie::Tie;
use crate::fender::RankedFender;
use crate::geometry::clip::ClipBuffers;
use crate::inherit::Inherited;
use crate::mass::InverseMatrix;
use crate::memory::{HintMemory, PatchMemory, PlaceMemory};
use crate::model::{MaterialId, Model};
use crate::near::NearList;
use crate::overlap::Overlap;
use crate::pairing::Bounds;
use crate::report::{Contact, Displacement, Event, Wrench};
use crate::state::{BodyState, Velocity};
use crate::vec2::Pose;

/// Buffers that a step writes to, and what it found. Nothing in it matters to the next step: it
/// can be shared between runs, be they of one model or of several, or thrown away at any time.
#[derive(Clone, Debug)]
pub struct Workspace {
    /// The layout of the last step's model, where that step was one of [`crate::advance`] and went through: what
    /// there is of its bodies is then what that step left.
    pub(crate) advanced: Option<u64>,
    /// The layout of the model of the last good step: the results are of its bodies.
    pub(crate) results_of: Option<u64>,
    pub(crate) contacts: Vec<Contact>,
    /// Whether contacts are reported one by one.
    pub(crate) contacts_told: bool,
    pub(crate) wrenches: Vec<Wrench>,
    pub(crate) events: Vec<Event>,
    /// States by rank. By the coupled method only of what several sub-steps move, and of what is fixed and moves:
    /// `shown` serves for the others.
    pub(crate) states: Vec<BodyState>,
    /// Poses by rank, with the heading each rotation was computed from.
    pub(crate) poses: Vec<Pose>,
    pub(crate) headings_rad: Vec<f64>,
    /// Ranks, in order, of the bodies that do not stand as they stood at the last step.
    pub(crate) active: Vec<u32>,
    /// What the host showed in this step, by rank; it changes places with the memory's of the step before.
    pub(crate) shown: Vec<BodyState>,
    /// By rank: what is fixed and at rest, where it was shown the same twice. What there is of it is then right as
    /// long as `shown` and the memory both have it as it is shown.
    pub(crate) settled: Vec<bool>,
    /// By rank: all but what is fixed and at rest.
    pub(crate) moves: Vec<bool>,
    /// Ranks of the bodies that jumped, in their order.
    pub(crate) teleported: Vec<u32>,
    /// Whether there are any; not after the first sub-step.
    pub(crate) jumps: bool,
    /// The same of all that their hosts put where they are, be it by a jump or by less.
    pub(crate) put: Vec<u32>,
    pub(crate) puts: bool,
    /// How far from its centre of gravity each body may reach in this step, by rank (m).
    pub(crate) reach_m: Vec<f64>,
    pub(crate) candidates: Vec<Pairing>,
    /// Those that the stages work on, and their patches: all, or those of some islands.
    pub(crate) own_candidates: Range<usize>,
    pub(crate) own_patches: Range<usize>,
    /// Pairs that were near each other a while ago.
    pub(crate) near: NearList,
    /// The overlaps of the candidates.
    pub(crate) found: Overlap,
    /// What each patch takes over from the last step.
    pub(crate) inherited: Vec<Inherited>,
    /// What patches take over that is not one old patch as it was.
    pub(crate) shares: Vec<PatchMemory>,
    pub(crate) clip: ClipBuffers,
    pub(crate) next_patches: Vec<PatchMemory>,
    pub(crate) next_places: Vec<PlaceMemory>,
    pub(crate) next_hints: Vec<HintMemory>,
    // What only the coupled method needs.
    pub(crate) states_after: Vec<BodyState>,
    /// Of what the step leaves of all that are active.
    pub(crate) sums: Sums,
    /// How far each body went: by rank as far as sub-steps have come and more are to come, then by id.
    pub(crate) motions_by_rank: Vec<Displacement>,
    pub(crate) motions: Vec<Displacement>,
    /// Velocities by rank: without contact before a solve and new after it, while `states` have those from before.
    pub(crate) velocities: Vec<Velocity>,
    /// What loads alone accelerate each body at, by rank (m/s², rad/s²); and the loads themselves, of those whose
    /// mass is not the same in all directions.
    pub(crate) accelerations: Vec<Velocity>,
    pub(crate) loads: Vec<Wrench>,
    /// How long before its position the velocity of each body belongs to, by rank, or the negative of that where it is
    /// taken to be as if all its (sub-)steps were as long as this one (s).
    pub(crate) behind_s: Vec<f64>,
    /// The most that any point of a body may move at in this step, by rank, and what of it acceleration and
    /// rotation add (m/s).
    pub(crate) fastest_mps: Vec<f64>,
    pub(crate) room_mps: Vec<f64>,
    pub(crate) islands: Vec<Island>,
    /// Whether there are islands of more than one body that floats.
    pub(crate) joined: bool,
    /// Each active body has an island of its own.
    pub(crate) all_meet: bool,
    pub(crate) island_root: Vec<u32>,
    /// By rank: those that move and are in islands; not asked for where that is all that are active.
    pub(crate) in_island: Vec<bool>,
    /// What is fixed and moves, by rank, where it was shown.
    pub(crate) moving_walls: Vec<(u32, BodyState)>,
    pub(crate) island_bodies: Vec<u32>,
    /// What the islands' last sub-step left.
    pub(crate) island_memory: IslandMemory,
    /// What the last step left of an island, where that does not stand together in the memory.
    pub(crate) gathered_memory: IslandMemory,
    /// What the first overlap of the step leaves, while later ones are found.
    pub(crate) first_found: Overlap,
    pub(crate) first_hints: Vec<HintMemory>,
    /// First of the islands' patches, places, hints and contacts in `next_patches`, `next_places`, `next_hints` and
    /// `contacts`.
    pub(crate) first_patch: usize,
    pub(crate) first_place: usize,
    pub(crate) first_hint: usize,
    pub(crate) first_contact: usize,
    /// Greatest wrenches of those bodies whose contacts took several sub-steps, and the first of the islands'.
    pub(crate) peaks: Vec<Peak>,
    pub(crate) first_peak: usize,
    /// Islands, and so what they leave, are in the order of the candidates' keys.
    pub(crate) in_order: bool,
    /// The contacts of a sub-step, and beyond them places for more.
    pub(crate) rows: Vec<Row>,
    /// The same contacts as the solve sees them.
    pub(crate) ties: Vec<Tie>,
    /// The same contacts in a leap of the solve.
    pub(crate) trials: Vec<Trial>,
    /// Earth-fixed inverse mass by rank.
    pub(crate) inverses: Vec<InverseMatrix>,
    /// Stored energy that nothing holds, of each body's contacts with what is fixed, by rank (J).
    pub(crate) unheld_j: Vec<f64>,
}

/// A pair of bodies near enough to touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Candidate {
    pub(crate) a: u32,
    pub(crate) b: u32,
    /// 0: outline against outline. Else 1 + the place in `Model::faces` of a fender of one of the two
    /// against the other's outline.
    pub(crate) face: u32,
    pub(crate) material: MaterialId,
}

/// A candidate, and what is known of its bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pairing {
    pub(crate) candidate: Candidate,
    /// A body of its island, the same for all of it, by the coupled method; until that is known [`JOINED`] where
    /// both bodies float.
    ///
    /// [`JOINED`]: crate::pairing::JOINED
    pub(crate) island: u32,
    /// Number of its pair: in `Model::pairs`, or beyond them in the list of those that are near.
    pub(crate) pair: u32,
}

impl Candidate {
    pub(crate) fn key(&self) -> (u32, u32, u32) {
        (self.a, self.b, self.face)
    }

    /// The fender, where there is one.
    #[inline]
    pub(crate) fn fender<'m>(&self, model: &'m Model) -> Option<&'m RankedFender> {
        self.face.checked_sub(1).map(|index| &model.faces[index as usize])
    }
}

impl Workspace {
    /// Buffers for a model.
    #[must_use]
    pub fn new(model: &Model) -> Workspace {
        let count = model.bodies().len();
        Workspace {
            advanced: None,
            results_of: None,
            contacts: Vec::new(),
            contacts_told: true,
            wrenches: vec![Wrench::default(); count],
            events: Vec::new(),
            states: Vec::with_capacity(count),
            poses: Vec::with_capacity(count),
            headings_rad: Vec::with_capacity(count),
            active: Vec::with_capacity(count),
            shown: Vec::with_capacity(count),
            settled: Vec::with_capacity(count),
            moves: Vec::with_capacity(count),
            teleported: Vec::new(),
            reach_m: Vec::with_capacity(count),
            jumps: false,
            put: Vec::new(),
            puts: false,
            candidates: Vec::new(),
            own_candidates: 0..0,
            own_patches: 0..0,
            near: NearList::default(),
            found: Overlap::default(),
            inherited: Vec::new(),
            shares: Vec::new(),
            clip: ClipBuffers::default(),
            next_patches: Vec::new(),
            next_places: Vec::new(),
            next_hints: Vec::new(),
            states_after: Vec::with_capacity(count),
            sums: Sums::default(),
            motions_by_rank: Vec::with_capacity(count),
            motions: Vec::with_capacity(count),
            velocities: Vec::with_capacity(count),
            accelerations: Vec::with_capacity(count),
            loads: Vec::with_capacity(count),
            behind_s: Vec::with_capacity(count),
            fastest_mps: Vec::with_capacity(count),
            room_mps: Vec::with_capacity(count),
            islands: Vec::new(),
            joined: false,
            all_meet: false,
            island_root: Vec::new(),
            in_island: Vec::new(),
            moving_walls: Vec::new(),
            island_bodies: Vec::new(),
            island_memory: IslandMemory::default(),
            gathered_memory: IslandMemory::default(),
            first_found: Overlap::default(),
            first_hints: Vec::new(),
            first_patch: 0,
            first_place: 0,
            first_hint: 0,
            first_contact: 0,
            peaks: Vec::new(),
            first_peak: 0,
            in_order: true,
            rows: Vec::new(),
            ties: Vec::new(),
            trials: Vec::new(),
            inverses: Vec::with_capacity(count),
            unheld_j: vec![0.0; count],
        }
    }

    /// Bounds of the pair of that number.
    #[inline]
    pub(crate) fn bounds_of<'m>(&'m self, model: &'m Model, pair: u32) -> &'m Bounds {
        let (pair, named) = (pair as usize, &model.pair_bounds);
        if pair < named.len() { &named[pair] } else { &self.near.bounds()[pair - named.len()] }
    }

    /// Did one of two bodies jump before this (sub-)step?
    #[inline]
    pub(crate) fn jumped(&self, a: u32, b: u32) -> bool {
        self.jumps && has_either(&self.teleported, a, b)
    }

    /// States at the end of the last step by [`crate::advance`], one a body: what a host that lets
    /// the engine move its bodies goes on with. None after [`crate::advance_in_place`], which has moved them. Velocities
    /// are those of the middle of the last sub-step.
    #[must_use]
    pub fn states_after(&self) -> &[BodyState] {
        &self.states_after
    }

    /// How far each body went in the last step by [`crate::advance`], one a body: what a load works along.
    #[must_use]
    pub fn displacements(&self) -> &[Displacement] {
        &self.motions
    }

    /// Whether steps report their contacts one by one in [`Workspace::contacts`], as they do if not told
    /// otherwise. Wrenches, states, motions, events and what is remembered are the same to the bit without, and
    /// come somewhat sooner.
    pub fn report_contacts(&mut self, told: bool) {
        self.contacts_told = told;
    }

    /// Contacts of the last step, sorted by the bodies' keys and patch; none where they are not told of.
    #[must_use]
    pub fn contacts(&self) -> &[Contact] {
        &self.contacts
    }

    /// Sum of the contact forces on each body in the last step, one a body: means over the step, by which bodies are
    /// moved. [`Workspace::peak_wrenches_into`] has what was there at the worst moment.
    #[must_use]
    pub fn wrenches(&self) -> &[Wrench] {
        &self.wrenches
    }

    /// Writes the greatest sum of the contact forces on each body within the last step into a list, one a body: of its
    /// sub-steps the wrench of that in which the force was greatest; by the paper's method, and where the step was one
    /// sub-step, [`Workspace::wrenches`]. Size fenders and structures by it, but move no body: a force that falls off
    /// within a long step is this large for a part of it. Of a fixed body that floating ones touch which do not touch
    /// each other, what it is where they are greatest at one time.
    pub fn peak_wrenches_into(&self, into: &mut Vec<Wrench>) {
        peaks::tell(&self.peaks, &self.wrenches, into);
    }

    /// Events of the last step.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }
}

/// Is one of the two ranks in the list, which is in their order?
#[inline]
pub(crate) fn has_either(ranks: &[u32], a: u32, b: u32) -> bool {
    ranks.binary_search(&a).is_ok() || ranks.binary_search(&b).is_ok()
}
