//! What the engine remembers from step to step.

use alloc::vec::Vec;

use crate::bodies::{Displaced, PoseChange, classify};
use crate::geometry::clip::Hint;
use crate::material::BodyId;
use crate::model::Model;
use crate::overlap::{Patch, Place};
use crate::state::BodyState;
use crate::unloading::PLAYS;
use crate::vec2::{Rotation, Vec2};

/// All mutable state of a contact problem: plain data. Copy it to branch a run, compare it, save it
/// with [`Memory::snapshot`] and get it back with [`Memory::restore`].
#[derive(Clone, Debug, PartialEq)]
pub struct Memory {
    /// The model this belongs to.
    pub(crate) fingerprint: u64,
    /// Touching patches, sorted by pair and patch.
    pub(crate) patches: Vec<PatchMemory>,
    /// Where those of them lay that have places, sorted in the same way.
    pub(crate) places: Vec<PlaceMemory>,
    /// Where the clip begins, for pieces that are near one another, sorted.
    pub(crate) hints: Vec<HintMemory>,
    /// States of the last step by rank; empty before the first.
    pub(crate) last_states: Vec<BodyState>,
    /// Time from the last step to the next (s); 0 before the first.
    pub(crate) last_step_s: f64,
    /// Ranks, in order, of the bodies of which the host has said that it put them where it shows them next.
    pub(crate) placed: Vec<u32>,
    /// By rank, after a step of the coupled method: how long before its position the velocity that the engine left of
    /// a body belongs to, which is half of its last sub-step (s); [`NOT_BEHIND`] of what does not float. See
    /// [`crate::coupled::bodies`].
    pub(crate) behind_s: Vec<f64>,
}

/// Of bodies of whose velocities it is not known that they belong to another time than their positions.
pub(crate) const NOT_BEHIND: f64 = -1.0;

/// What a patch of contact remembers (§3.3 and §3.4 of the paper).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PatchMemory {
    /// Ranks of the two bodies, number of the face (0: none) and of the patch.
    pub(crate) a: u32,
    pub(crate) b: u32,
    pub(crate) face: u32,
    pub(crate) patch: u32,
    /// [`PatchMemory::CONTAINED`] and [`PatchMemory::DEEP`], so that each is told once,
    /// [`PatchMemory::APPROACHING`] and [`PatchMemory::SLIPPING`].
    pub(crate) flags: u32,
    /// S^{n−1} (m²).
    pub(crate) area_m2: f64,
    /// The material points that were at C, in each body's frame (m).
    pub(crate) point_in_a_m: Vec2,
    pub(crate) point_in_b_m: Vec2,
    /// The last good normal (A's outward one) in A's frame, and how B was turned there: it is seldom asked for in
    /// B's.
    pub(crate) normal_in_a: Vec2,
    pub(crate) b_in_a: Rotation,
    /// Δs (m).
    pub(crate) shear_m: f64,
    /// By the paper's method V_n⁰ and V_t⁰, the relative velocity when the contact began. By the
    /// coupled method the largest V_n since it last changed sign, and nothing (m/s).
    pub(crate) v_normal_0_mps: f64,
    pub(crate) v_tangential_0_mps: f64,
    /// N and T of the last (sub-)step, where the coupled solve begins (N).
    pub(crate) normal_force_n: f64,
    pub(crate) tangential_force_n: f64,
    /// Factor on the law, as it was when the contact began.
    pub(crate) factor: f64,
    /// What the bodies have lost to the normal force and not got back, by the coupled method (J): the
    /// most that it may give them.
    pub(crate) taken_j: f64,
    /// What the shear spring has taken from the bodies and still stores, by the coupled method (J): the
    /// most that it may give them.
    pub(crate) sheared_j: f64,
    /// The area whose growth the damper has answered, by the coupled method (m²): see [`crate::law::damper`].
    pub(crate) damped_m2: f64,
    /// T of each play of a fender's unloading law (J); 0 without one.
    pub(crate) tops_j: [f64; PLAYS],
}

impl PatchMemory {
    /// One body within the other; on a face, beyond the rated deflection.
    pub(crate) const CONTAINED: u32 = 1;
    /// Half of a body within the other; on a face, into the stop.
    pub(crate) const DEEP: u32 = 2;
    /// V_n was positive at the last (sub-)step's start.
    pub(crate) const APPROACHING: u32 = 4;
    /// A body was put into the other and is pressed out.
    pub(crate) const PRESSED_OUT: u32 = 8;
    /// By the coupled method: it slides, and has not been turned back.
    pub(crate) const SLIPPING: u32 = 16;

    /// Of a patch with this normal, at this point: all that the laws do not say.
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

    /// The last good normal in B's frame.
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

/// Where a patch of bodies of several pieces lay: which patch is which when there are several. Apart from
/// [`PatchMemory`], as most patches are of convex bodies.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct PlaceMemory {
    pub(crate) a: u32,
    pub(crate) b: u32,
    pub(crate) face: u32,
    pub(crate) patch: u32,
    pub(crate) place: Place,
}

impl PlaceMemory {
    /// Adds the places of these patches, as far as they have any, to what the next (sub-)step begins with.
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

/// The place of an old patch in a sorted list of them, where it has one.
pub(crate) fn place_of(patch: &PatchMemory, places: &[PlaceMemory]) -> Option<Place> {
    let found = places.binary_search_by_key(&patch.key(), PlaceMemory::key);
    found.ok().map(|index| places[index].place)
}

/// A box along the axes of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Extent {
    pub(crate) low_m: Vec2,
    pub(crate) high_m: Vec2,
}

impl Extent {
    #[inline]
    pub(crate) fn overlaps(&self, other: &Extent) -> bool {
        self.low_m.x <= other.high_m.x
            && other.low_m.x <= self.high_m.x
            && self.low_m.y <= other.high_m.y
            && other.low_m.y <= self.high_m.y
    }
}

/// A clip's starting place for one piece of each body.
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

/// What a (sub-)step begins with: what the last one left of some candidates, each list sorted, and how long
/// ago that began (s); 0 before the first.
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
    /// Takes off what belongs to candidates before `next`; all where there is none. Both keep all places, which are
    /// looked up.
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
    /// All of it.
    pub(crate) fn past<'m>(&'m self, displaced: &'m Displaced) -> Past<'m> {
        let Memory { patches, places, hints, last_step_s, .. } = self;
        Past { patches, places, hints, last_step_s: *last_step_s, displaced }
    }

    /// Memory of bodies that have never touched.
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

    /// Number of patches that touched in the last step.
    #[must_use]
    pub fn touching_patches(&self) -> usize {
        self.patches.len()
    }

    /// Says that the next step comes `elapsed_s` after the last one rather than the whole Δt that was
    /// given then: for integrators that look ahead within a step, on a copy of the memory.
    ///
    /// # Panics
    /// If `elapsed_s` is not positive and finite.
    pub fn set_elapsed(&mut self, elapsed_s: f64) {
        assert!(elapsed_s > 0.0 && elapsed_s.is_finite(), "time goes forward");
        self.last_step_s = elapsed_s;
    }

    /// Becomes a copy of `other` without allocating where the buffers are large enough: for
    /// integrators that look ahead.
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

    /// The host has put a body where the next step shows it: its contacts start afresh there
    /// ([`crate::EventKind::Teleported`]), and where it is put into another one it is pressed out slowly
    /// ([`crate::EventKind::PlacedInOverlap`]). Without a word of the host that is found out where the way is longer than a
    /// tenth of the body's radius.
    ///
    /// # Panics
    /// Where the model has no such body.
    pub fn mark_teleported(&mut self, model: &Model, body: BodyId) {
        let rank = model.rank_of[body.0 as usize];
        if let Err(at) = self.placed.binary_search(&rank) {
            self.placed.insert(at, rank);
        }
    }

    /// Classifies a body's input pose by its last state and what the host said of it.
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
