//! The engine's state from one step to the next.

use alloc::vec::Vec;

use crate::bodies::{Displaced, PoseChange, classify};
use crate::geometry::clip::Hint;
use crate::material::BodyId;
use crate::model::Model;
use crate::patch::{Patch, Place};
use crate::state::BodyState;
use crate::unloading::PLAYS;
use crate::vec2::{Rotation, Vec2};

/// All mutable state of a contact problem, as plain data. Copy it to branch a run, compare it, save it with
/// [`Memory::snapshot`] and restore it with [`Memory::restore`].
#[derive(Clone, Debug, PartialEq)]
pub struct Memory {
    /// Fingerprint of the model to which it belongs.
    pub(crate) fingerprint: u64,
    /// Contact patches, sorted by pair and patch.
    pub(crate) patches: Vec<PatchMemory>,
    /// Locations of the patches that have one, sorted likewise.
    pub(crate) places: Vec<PlaceMemory>,
    /// Starting points for the clip of pieces that are near each other, sorted.
    pub(crate) hints: Vec<HintMemory>,
    /// Input states of the last step by rank; empty before the first.
    pub(crate) last_states: Vec<BodyState>,
    /// Time from the last step to the next (s); 0 before the first step.
    pub(crate) last_step_s: f64,
    /// Sorted ranks of the bodies that the host has marked as teleported in its next input.
    pub(crate) placed: Vec<u32>,
    /// By rank, after a step of the coupled method: the time by which the engine's velocity of a body precedes its
    /// position, half of its last sub-step (s); [`NOT_BEHIND`] for fixed bodies. See [`crate::coupled::dynamics`].
    pub(crate) behind_s: Vec<f64>,
}

/// For bodies whose velocity is taken to belong to the time of their position.
pub(crate) const NOT_BEHIND: f64 = -1.0;

/// State of a contact patch (§3.3 and §3.4 of the paper).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PatchMemory {
    /// Ranks of the two bodies, number of the face (0: none) and of the patch.
    pub(crate) a: u32,
    pub(crate) b: u32,
    pub(crate) face: u32,
    pub(crate) patch: u32,
    /// [`PatchMemory::CONTAINED`] and [`PatchMemory::DEEP`], so that each is reported once,
    /// [`PatchMemory::APPROACHING`], [`PatchMemory::PRESSED_OUT`] and [`PatchMemory::SLIPPING`].
    pub(crate) flags: u32,
    /// S^{n−1} (m²).
    pub(crate) area_m2: f64,
    /// The material points of both bodies that were at C, in each body's frame (m).
    pub(crate) point_in_a_m: Vec2,
    pub(crate) point_in_b_m: Vec2,
    /// The last valid normal (A's outward one) in A's frame, and the rotation of B there, from which the normal in B's
    /// frame is computed when needed.
    pub(crate) normal_in_a: Vec2,
    pub(crate) b_in_a: Rotation,
    /// Δs (m).
    pub(crate) shear_m: f64,
    /// By the paper's method V_n⁰ and V_t⁰, the relative velocity when the contact began (m/s). By the coupled method
    /// the first is the largest V_n since it last changed sign, and the second is unused.
    pub(crate) v_normal_0_mps: f64,
    pub(crate) v_tangential_0_mps: f64,
    /// N and T of the last (sub-)step: warm start of the coupled solve (N).
    pub(crate) normal_force_n: f64,
    pub(crate) tangential_force_n: f64,
    /// Factor on the fender's reaction, set when the contact began.
    pub(crate) factor: f64,
    /// Energy that the normal force has absorbed from the bodies and not returned, by the coupled method (J): the most
    /// that it may return.
    pub(crate) taken_j: f64,
    /// Energy that the shear spring has absorbed from the bodies and still stores, by the coupled method (J): the most
    /// that it may return.
    pub(crate) sheared_j: f64,
    /// The overlap area up to which the damper has acted, by the coupled method (m²): see [`crate::law::damper`].
    pub(crate) damped_m2: f64,
    /// T of each play of a fender's unloading law (J); 0 without one.
    pub(crate) tops_j: [f64; PLAYS],
}

impl PatchMemory {
    /// One body lies within the other; at a fender: beyond the rated deflection.
    pub(crate) const CONTAINED: u32 = 1;
    /// Half of a body lies within the other; at a fender: in the stop.
    pub(crate) const DEEP: u32 = 2;
    /// V_n was positive at the start of the last (sub-)step.
    pub(crate) const APPROACHING: u32 = 4;
    /// A body was placed in the other and is being pushed out.
    pub(crate) const PRESSED_OUT: u32 = 8;
    /// By the coupled method: the contact slides, and sliding has not reversed.
    pub(crate) const SLIPPING: u32 = 16;

    /// Geometry of a patch with this normal at this point; the laws fill in the rest.
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

    /// The last valid normal in B's frame.
    pub(crate) fn normal_in_b(&self) -> Vec2 {
        self.b_in_a.apply_inverse(self.normal_in_a)
    }

    pub(crate) fn key(&self) -> (u32, u32, u32, u32) {
        (self.a, self.b, self.face, self.patch)
    }

    /// Which candidate it belongs to.
    pub(crate) fn candidate(&self) -> (u32, u32, u32) {
        (self.a, self.b, self.face)
    }
}

/// Location of a patch of bodies with several pieces, by which patches are matched between steps. Separate from
/// [`PatchMemory`] because most patches are of convex bodies and have none.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PlaceMemory {
    pub(crate) a: u32,
    pub(crate) b: u32,
    pub(crate) face: u32,
    pub(crate) patch: u32,
    pub(crate) place: Place,
}

impl PlaceMemory {
    /// Appends the locations of these patches, where they have one, to the next (sub-)step's list.
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

/// Looks up the location of an old patch; `None` where it has none.
pub(crate) fn place_of(patch: &PatchMemory, places: &[PlaceMemory]) -> Option<Place> {
    let found = places.binary_search_by_key(&patch.key(), PlaceMemory::key);
    found.ok().map(|index| places[index].place)
}

/// The clip's starting point for one piece of each body.
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

/// The past of a (sub-)step: memory that the last one left for some candidates, each list sorted, and the time since it
/// began (s), 0 before the first.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Past<'m> {
    pub(crate) patches: &'m [PatchMemory],
    pub(crate) places: &'m [PlaceMemory],
    pub(crate) hints: &'m [HintMemory],
    pub(crate) last_step_s: f64,
    /// Bodies that the host displaced since then.
    pub(crate) displaced: &'m Displaced,
}

impl<'m> Past<'m> {
    /// Splits off the memory of the candidates before `next`, or all where that is `None`. Both parts keep all
    /// locations, which are looked up by key.
    pub(crate) fn before(&mut self, next: Option<(u32, u32, u32)>) -> Past<'m> {
        let Some(next) = next else { return *self };
        let patches = self.patches.iter().take_while(|m| m.candidate() < next).count();
        let hints = self.hints.iter().take_while(|m| m.candidate() < next).count();
        let (own_patches, other_patches) = self.patches.split_at(patches);
        let (own_hints, other_hints) = self.hints.split_at(hints);
        (self.patches, self.hints) = (other_patches, other_hints);
        Past { patches: own_patches, hints: own_hints, ..*self }
    }
}

impl Memory {
    /// The whole memory as the past of a step.
    pub(crate) fn past<'m>(&'m self, displaced: &'m Displaced) -> Past<'m> {
        let Memory { patches, places, hints, last_step_s, .. } = self;
        Past { patches, places, hints, last_step_s: *last_step_s, displaced }
    }

    /// The memory of bodies that have never touched.
    #[must_use]
    pub fn new(model: &Model) -> Memory {
        Memory {
            fingerprint: model.fingerprint,
            patches: Vec::new(),
            places: Vec::new(),
            hints: Vec::new(),
            last_states: Vec::new(),
            last_step_s: 0.0,
            placed: Vec::new(),
            behind_s: Vec::new(),
        }
    }

    /// Number of contact patches in the last step.
    #[must_use]
    pub fn touching_patches(&self) -> usize {
        self.patches.len()
    }

    /// Sets the time since the last step, in place of its Δt: for integrators with several stages per step, such as
    /// Runge-Kutta, which call the engine within a step on a copy of the memory.
    ///
    /// # Panics
    /// If `elapsed_s` is not positive and finite.
    pub fn set_elapsed(&mut self, elapsed_s: f64) {
        assert!(elapsed_s > 0.0 && elapsed_s.is_finite(), "time goes forward");
        self.last_step_s = elapsed_s;
    }

    /// Becomes a copy of `other`, without allocation where the buffers are large enough.
    pub fn copy_from(&mut self, other: &Memory) {
        self.fingerprint = other.fingerprint;
        self.patches.clone_from(&other.patches);
        self.places.clone_from(&other.places);
        self.hints.clone_from(&other.hints);
        self.last_states.clone_from(&other.last_states);
        self.last_step_s = other.last_step_s;
        self.placed.clone_from(&other.placed);
        self.behind_s.clone_from(&other.behind_s);
    }

    /// Marks the next input state of a body as a teleport: the host sets it to a new place rather than moving it there. Its
    /// contacts begin anew ([`crate::EventKind::Teleported`]), and out of another body it is pushed slowly
    /// ([`crate::EventKind::PlacedInOverlap`]). Without this call the engine detects a teleport where the displacement
    /// differs by more than a tenth of the body's radius from that of its velocities.
    ///
    /// # Panics
    /// If the model has no such body.
    pub fn mark_teleported(&mut self, model: &Model, body: BodyId) {
        let rank = model.rank_of[body.0 as usize];
        if let Err(at) = self.placed.binary_search(&rank) {
            self.placed.insert(at, rank);
        }
    }

    /// Classifies a body's input pose by its last state and the host's mark.
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
