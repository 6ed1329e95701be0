//! The engine's state from one step to the next.

use alloc::vec::Vec;

use crate::broad::bodies::{Displaced, PoseChange, classify};
use crate::broad::candidates::Pairing;
use crate::geometry::clip::Hint;
use crate::maths::room::{expected_contacts, room_for};
use crate::maths::vec2::{Rotation, Vec2};
use crate::model::Model;
use crate::model::material::BodyId;
use crate::model::unloading::PLAYS;
use crate::overlap::patch::{Patch, Place};
use crate::state::body_state::BodyState;

/// All mutable state of a contact problem, as plain data that can be copied and compared. Copy the memory to branch a
/// run, compare it, save it with [`Memory::snapshot`], and restore it with [`Memory::restore`].
#[derive(Clone, Debug, PartialEq)]
pub struct Memory {
    /// Fingerprint of the model to which this memory belongs.
    pub(crate) fingerprint: u64,
    pub(crate) contacts: ContactMemory,
    /// States that the host gave in the last step, by rank; empty before the first step.
    pub(crate) last_states: Vec<BodyState>,
    /// Time from the last step to the next (s); 0 before the first step.
    pub(crate) last_step_s: f64,
    /// Sorted ranks of the bodies that the host has marked as teleported for its next input.
    pub(crate) placed: Vec<u32>,
    /// For each body by rank, after a step of the coupled method: the time by which the engine's velocity of the body
    /// is older than the body's position (s). This velocity lag is half of the body's last sub-step. [`NOT_BEHIND`] for
    /// fixed bodies. See [`crate::coupled::dynamics`].
    pub(crate) behind_s: Vec<f64>,
    /// Chains of fender panels that have parted, sorted: see [`crate::panel::chains`].
    pub(crate) parted: Vec<u32>,
    /// Permanent deflections of the piles, by rank (m); empty before the first step.
    pub(crate) pile_offsets_m: Vec<Vec2>,
}

/// The memory of contacts for the next step or sub-step.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ContactMemory {
    /// Contact patches, sorted by pair of bodies and number of the patch.
    pub(crate) patches: Vec<PatchMemory>,
    /// Places of the patches that have a place, sorted in the same way as the patches.
    pub(crate) places: Vec<PlaceMemory>,
    /// Hints from which the clip starts, for pieces of bodies that are near each other; sorted.
    pub(crate) hints: Vec<HintMemory>,
}

/// Stands for the velocity lag of a body whose velocity is taken to belong to the time of its position.
pub(crate) const NOT_BEHIND: f64 = -1.0;

/// State of a contact patch (§3.3 and §3.4 of the paper).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PatchMemory {
    /// Ranks of the two bodies, number of the fender's face (0: no fender) and number of the patch.
    pub(crate) a: u32,
    pub(crate) b: u32,
    pub(crate) face: u32,
    pub(crate) patch: u32,
    /// Flags of the patch: [`PatchMemory::CONTAINED`] and [`PatchMemory::DEEP`], which are set so that each event is
    /// reported only once, [`PatchMemory::APPROACHING`], [`PatchMemory::PRESSED_OUT`], [`PatchMemory::SLIPPING`] and
    /// [`PatchMemory::LIMITED`].
    pub(crate) flags: u32,
    /// S^{n−1} (m²).
    pub(crate) area_m2: f64,
    /// The material points of the two bodies that were at the contact point C, each in the frame of its body (m).
    pub(crate) point_in_a_m: Vec2,
    pub(crate) point_in_b_m: Vec2,
    /// The last valid normal of the contact (the outward normal of body A) in the frame of A, and the rotation of body
    /// B at that time. The normal in the frame of body B is computed from these two when it is needed.
    pub(crate) normal_in_a: Vec2,
    pub(crate) b_in_a: Rotation,
    /// Δs (m).
    pub(crate) shear_m: f64,
    /// In the paper's method, the two numbers are V_n⁰ and V_t⁰: the relative velocity when the contact began (m/s). In
    /// the coupled method, the first number is the largest normal speed V_n since V_n last changed sign, and the second
    /// number is unused.
    pub(crate) v_normal_0_mps: f64,
    pub(crate) v_tangential_0_mps: f64,
    /// Normal force N and tangential force T of the last step or sub-step (N). The coupled solve starts from these two
    /// forces.
    pub(crate) normal_force_n: f64,
    pub(crate) tangential_force_n: f64,
    /// Factor on the fender's reaction, set when the contact began.
    pub(crate) factor: f64,
    /// Energy that the normal force has taken from the bodies and has not returned (J). The normal force may return no
    /// more energy than `taken_j`. Coupled method only.
    pub(crate) taken_j: f64,
    /// Energy that the shear spring has taken from the bodies and still stores (J). The shear spring may return no more
    /// energy than `sheared_j`. Coupled method only.
    pub(crate) sheared_j: f64,
    /// The overlap area to which the damper has responded (m²), in the coupled method: see [`crate::law::damper`].
    pub(crate) damped_m2: f64,
    /// Top T of each play element of a fender's unloading law (J); 0 without an unloading law.
    pub(crate) tops_j: [f64; PLAYS],
}

impl PatchMemory {
    /// For the contact of two outlines: one body lies within the other body. For the contact of a fender: the fender is
    /// beyond its rated deflection.
    pub(crate) const CONTAINED: u32 = 1;
    /// For the contact of two outlines: half of a body lies within the other body. For the contact of a fender: the
    /// fender is in its stop.
    pub(crate) const DEEP: u32 = 2;
    /// The bodies approached each other at the start of the last step or sub-step: V_n was positive.
    pub(crate) const APPROACHING: u32 = 4;
    /// A host placed one body in the other body, and the contact is pushing it out.
    pub(crate) const PRESSED_OUT: u32 = 8;
    /// In the coupled method: the contact slides, and its sliding has not reversed.
    pub(crate) const SLIPPING: u32 = 16;
    /// In the coupled method: the normal force N was less than the force of its law.
    pub(crate) const LIMITED: u32 = 32;

    /// Makes the memory of a patch with this normal at this point. The force laws fill in the rest of the memory.
    #[inline(always)]
    pub(crate) fn of(patch: &Patch, point_in_a_m: Vec2, normal_in_a: Vec2) -> PatchMemory {
        PatchMemory {
            a: patch.candidate.a,
            b: patch.candidate.b,
            face: patch.candidate.face,
            patch: patch.number,
            area_m2: patch.area_m2,
            point_in_a_m,
            point_in_b_m: patch.b_in_a.apply_inverse(point_in_a_m),
            normal_in_a,
            b_in_a: patch.b_in_a.rotation,
            ..PatchMemory::default()
        }
    }

    /// The last valid normal of the contact in the frame of body B.
    pub(crate) fn normal_in_b(&self) -> Vec2 {
        self.b_in_a.apply_inverse(self.normal_in_a)
    }

    pub(crate) fn key(&self) -> (u32, u32, u32, u32) {
        (self.a, self.b, self.face, self.patch)
    }

    /// The candidate to which the patch belongs: the ranks of the bodies, and the number of the face.
    pub(crate) fn candidate(&self) -> (u32, u32, u32) {
        (self.a, self.b, self.face)
    }
}

/// Place of a patch of contact between bodies with several convex pieces. Patches of contact are matched between steps
/// by their places. Places are stored apart from [`PatchMemory`] because most patches are of convex bodies and have no
/// place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PlaceMemory {
    pub(crate) a: u32,
    pub(crate) b: u32,
    pub(crate) face: u32,
    pub(crate) patch: u32,
    pub(crate) place: Place,
}

impl PlaceMemory {
    /// Appends the places of these patches, if they have places, to the list of the next step or sub-step.
    #[inline]
    pub(crate) fn add_all(patches: &[Patch], places: &[Place], into: &mut Vec<PlaceMemory>) {
        if places.is_empty() {
            return;
        }
        into.extend(patches.iter().filter_map(|patch| {
            let (a, b, face) = patch.candidate.key();
            let place = places[patch.place()? as usize];
            Some(PlaceMemory { a, b, face, patch: patch.number, place })
        }));
    }

    pub(crate) fn key(&self) -> (u32, u32, u32, u32) {
        (self.a, self.b, self.face, self.patch)
    }

    pub(crate) fn candidate(&self) -> (u32, u32, u32) {
        (self.a, self.b, self.face)
    }
}

/// Looks up the place of an old patch; returns `None` if the patch has no place.
pub(crate) fn place_of(patch: &PatchMemory, places: &[PlaceMemory]) -> Option<Place> {
    let found = places.binary_search_by_key(&patch.key(), PlaceMemory::key);
    found.ok().map(|index| places[index].place)
}

/// The hint from which the clip starts for one piece of each of two bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct HintMemory {
    pub(crate) a: u32,
    pub(crate) b: u32,
    pub(crate) face: u32,
    pub(crate) piece_a: u32,
    pub(crate) piece_b: u32,
    pub(crate) hint: Hint,
}

impl HintMemory {
    pub(crate) fn key(&self) -> (u32, u32, u32, u32, u32) {
        (self.a, self.b, self.face, self.piece_a, self.piece_b)
    }

    pub(crate) fn candidate(&self) -> (u32, u32, u32) {
        (self.a, self.b, self.face)
    }
}

/// What a step or sub-step knows of the past: the memory that the last step or sub-step left for some candidates, in
/// sorted lists, and the time since that last step or sub-step began (s). The time since the last step is 0 before the
/// first step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Past<'m> {
    pub(crate) patches: &'m [PatchMemory],
    pub(crate) places: &'m [PlaceMemory],
    pub(crate) hints: &'m [HintMemory],
    pub(crate) last_step_s: f64,
    /// Bodies that the host displaced since the last step or sub-step.
    pub(crate) displaced: &'m Displaced,
}

impl<'m> Past<'m> {
    /// Splits off the memory of the candidates before `next`, or all memory if `next` is `None`. Both parts of the
    /// memory keep all places, because places are looked up by key. In most steps the part that is split off has
    /// `expected` patches, so the search tries this number first.
    pub(crate) fn before(&mut self, next: Option<(u32, u32, u32)>, expected: usize) -> Past<'m> {
        let Some(next) = next else { return *self };
        let is_before = |m: &PatchMemory| m.candidate() < next;
        let is_expected = match self.patches.get(expected.saturating_sub(1)..=expected) {
            Some([last, other]) => is_before(last) && !is_before(other),
            _ => false,
        };
        let patches = if is_expected { expected } else { self.patches.partition_point(is_before) };
        let hints = self.hints.partition_point(|m| m.candidate() < next);
        let (own_patches, other_patches) = self.patches.split_at(patches);
        let (own_hints, other_hints) = self.hints.split_at(hints);
        (self.patches, self.hints) = (other_patches, other_hints);
        Past { patches: own_patches, hints: own_hints, ..*self }
    }
}

impl ContactMemory {
    /// Makes a memory with room for this number of contacts.
    pub(crate) fn with_room(contacts: usize) -> ContactMemory {
        ContactMemory { patches: room_for(contacts), places: Vec::new(), hints: room_for(contacts) }
    }

    pub(crate) fn clear(&mut self) {
        self.patches.clear();
        self.places.clear();
        self.hints.clear();
    }

    pub(crate) fn sort(&mut self) {
        self.patches.sort_unstable_by_key(PatchMemory::key);
        self.places.sort_unstable_by_key(PlaceMemory::key);
        self.hints.sort_unstable_by_key(HintMemory::key);
    }

    /// This memory as the past of a step or sub-step that is `last_step_s` later. `displaced` are the bodies that the
    /// host displaced before the later step.
    pub(crate) fn past<'m>(&'m self, last_step_s: f64, displaced: &'m Displaced) -> Past<'m> {
        let ContactMemory { patches, places, hints } = self;
        Past { patches, places, hints, last_step_s, displaced }
    }

    /// Numbers of patches, places and hints in this memory.
    pub(crate) fn lengths(&self) -> [usize; 3] {
        [self.patches.len(), self.places.len(), self.hints.len()]
    }

    /// Moves what was added to `from` beyond these lengths into this memory, and drops the former content of this
    /// memory.
    pub(crate) fn take(&mut self, from: &mut ContactMemory, [patches, places, hints]: [usize; 3]) {
        self.clear();
        if [patches, places, hints] == [0; 3] {
            return core::mem::swap(self, from);
        }
        self.patches.extend(from.patches.drain(patches..));
        self.places.extend(from.places.drain(places..));
        self.hints.extend(from.hints.drain(hints..));
    }

    /// Copies what `from` holds about these candidates into this memory, and drops the former content of this memory.
    pub(crate) fn gather(&mut self, from: &ContactMemory, candidates: &[Pairing]) {
        self.clear();
        for pairing in candidates {
            let key = pairing.candidate.key();
            self.patches.extend(run_of(&from.patches, key, PatchMemory::candidate));
            self.places.extend(run_of(&from.places, key, PlaceMemory::candidate));
            self.hints.extend(run_of(&from.hints, key, HintMemory::candidate));
        }
    }

    /// Exchanges the lists of this memory with the lists of another step's memory. With `keeps_hints`, both memories
    /// keep their own hints.
    pub(crate) fn exchange(&mut self, other: &mut ContactMemory, keeps_hints: bool) {
        core::mem::swap(&mut self.patches, &mut other.patches);
        core::mem::swap(&mut self.places, &mut other.places);
        if !keeps_hints {
            core::mem::swap(&mut self.hints, &mut other.hints);
        }
    }
}

/// The entries of one candidate in a sorted list.
fn run_of<T: Copy>(
    sorted: &[T],
    key: (u32, u32, u32),
    key_of: fn(&T) -> (u32, u32, u32),
) -> impl Iterator<Item = T> {
    let from = sorted.partition_point(|item| key_of(item) < key);
    sorted[from..].iter().copied().take_while(move |item| key_of(item) == key)
}

impl Memory {
    /// Makes the memory of bodies that have never touched.
    #[must_use]
    pub fn new(model: &Model) -> Memory {
        Memory {
            fingerprint: model.fingerprint,
            contacts: ContactMemory::with_room(expected_contacts(model)),
            last_states: room_for(model.bodies().len()),
            last_step_s: 0.0,
            placed: Vec::new(),
            behind_s: room_for(model.bodies().len()),
            parted: Vec::new(),
            pile_offsets_m: Vec::new(),
        }
    }

    /// Turns this memory into the memory of bodies that have never touched, as [`Memory::new`] makes it. The buffers
    /// are kept.
    pub fn forget(&mut self) {
        let Memory {
            fingerprint: _,
            contacts,
            last_states,
            last_step_s,
            placed,
            behind_s,
            parted,
            pile_offsets_m,
        } = self;
        contacts.clear();
        last_states.clear();
        *last_step_s = 0.0;
        placed.clear();
        behind_s.clear();
        parted.clear();
        pile_offsets_m.clear();
    }

    /// Number of contact patches in the last step.
    #[must_use]
    pub fn touching_patches(&self) -> usize {
        self.contacts.patches.len()
    }

    /// Sets the time since the last step, in place of the length Δt of that step. This function is for integrators with
    /// several stages per step, such as Runge-Kutta, which call the engine within a step on a copy of the memory.
    ///
    /// # Panics
    /// Panics if `elapsed_s` is not positive and finite.
    pub fn set_elapsed(&mut self, elapsed_s: f64) {
        assert!(elapsed_s > 0.0 && elapsed_s.is_finite(), "time goes forward");
        self.last_step_s = elapsed_s;
    }

    /// Writes for each body, in the order in which bodies were added, the time by which the engine's velocity of the
    /// body is older than the body's position (s): half of the last sub-step of [`crate::advance_in_place`]. The time
    /// by which velocities are older than positions is 0 before the first step. The time is −1 for fixed bodies, and
    /// for bodies whose velocity the host gave to the engine. A load that depends on a body's position should be
    /// computed for the middle between the time of this velocity and the time of the next step's velocity.
    pub fn velocity_lags_into(&self, model: &Model, lags_s: &mut Vec<f64>) {
        lags_s.clear();
        let lag_of = |&rank: &u32| self.behind_s.get(rank as usize).copied().unwrap_or(0.0);
        lags_s.extend(model.rank_of.iter().map(lag_of));
    }

    /// Makes this memory a copy of the memory `other`. Memory is allocated only if a buffer is too small.
    pub fn copy_from(&mut self, other: &Memory) {
        self.fingerprint = other.fingerprint;
        self.contacts.patches.clone_from(&other.contacts.patches);
        self.contacts.places.clone_from(&other.contacts.places);
        self.contacts.hints.clone_from(&other.contacts.hints);
        self.last_states.clone_from(&other.last_states);
        self.last_step_s = other.last_step_s;
        self.placed.clone_from(&other.placed);
        self.behind_s.clone_from(&other.behind_s);
        self.parted.clone_from(&other.parted);
        self.pile_offsets_m.clone_from(&other.pile_offsets_m);
    }

    /// Marks the next input state of a body as a teleport: the host puts the body at a new place instead of moving it
    /// there. After a teleport the contacts of the body begin anew ([`crate::EventKind::Teleported`]). If the body then
    /// lies in another body, it is pushed out slowly ([`crate::EventKind::PlacedInOverlap`]). Without a call of this
    /// function the engine detects a teleport by itself: the displacement then differs from what the velocities give by
    /// more than a tenth of the body's radius.
    ///
    /// # Panics
    /// Panics if the model has no such body.
    pub fn mark_teleported(&mut self, model: &Model, body: BodyId) {
        let rank = model.rank_of[body.0 as usize];
        if let Err(at) = self.placed.binary_search(&rank) {
            self.placed.insert(at, rank);
        }
    }

    /// Classifies the pose of a body that the host gives, by the body's last state and the mark of the host.
    #[inline(always)]
    pub(crate) fn pose_change(
        &self,
        rank: usize,
        last: &BodyState,
        now: &BodyState,
        radius_m: f64,
    ) -> PoseChange {
        if !self.placed.is_empty() && self.placed.binary_search(&(rank as u32)).is_ok() {
            return PoseChange::Teleported;
        }
        classify(last, now, self.last_step_s, radius_m)
    }
}
