//! Renewal of slices: a host changes the outline of a hull that a fender meets, because the hull's height at the fender
//! has changed (docs/contact_model.md, section 8).
//!
//! A contact continues through a renewal: its shear, the tops of its unloading law and its reference speed stay. A
//! renewal stores energy in the fender or takes energy out. This energy of a renewal is no work of the bodies' motion
//! in the plane: the host counts it as work of tide, heave, roll and pitch. The contact may return the energy that a
//! renewal stored. The damper reacts to the change of the area by a renewal as to any other change.
//!
//! The forces of a sub-step act from half a step before its start to half a step after it (section 6.7). So a renewal
//! counts from half a step before the start of a sub-step, and the energies before and after the renewal are compared
//! at that time. If the energies were compared at the start of the sub-step, a ship that closes in while the tide takes
//! her side away would gain k δ̇² h/2 again and again.
//!
//! A fender with an unloading law follows the net change of its deflection from the start of the last sub-step to the
//! start of the present sub-step. So the work of the renewal is the energy for this net change, less the work of the
//! motion: the force at the start of the last sub-step for half a step, and the force at the start of the present
//! sub-step for another half.

use alloc::vec::Vec;

use crate::broad::bodies::Bodies;
use crate::broad::candidates::{Candidate, Pairing};
use crate::coupled::add_held;
use crate::coupled::held::Held;
use crate::geometry::clip::ClipBuffers;
use crate::maths::number::greater;
use crate::maths::vec2::Pose;
use crate::model::Model;
use crate::model::material::{BodyId, FenderId};
use crate::model::slice::{SideMet, Slice};
use crate::overlap::hints::Hints;
use crate::overlap::lenses::Overlap;
use crate::overlap::overlap;
use crate::state::body_state::BodyState;
use crate::state::memory::{HintMemory, Memory, PatchMemory};
use crate::touch::{Movers, Scene, touch};

/// The result of the renewal of a slice.
#[derive(Clone, Debug, PartialEq)]
pub struct Renewal {
    /// The energy that the renewal put into the fender (J); negative if the renewal took energy out.
    pub work_j: f64,
    /// The slice that the renewal replaced.
    pub before: Option<Slice>,
}

/// Buffers for renewals. A renewal with buffers that were used before allocates no memory.
#[derive(Clone, Debug, Default)]
pub struct RenewalBuffers {
    /// The candidates whose contacts meet the renewed part.
    pub(crate) met: Vec<Met>,
    scene: SceneBuffers,
}

/// A candidate whose contacts meet a renewed part of the model.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Met {
    pub(crate) candidate: Candidate,
    is_near: bool,
    /// Energy and force of the contacts in the model before the change, at two times: a whole and a half of the last
    /// step or sub-step before the start of the next step.
    before: [Held; 2],
    /// The energy that the change put into the contacts (J).
    pub(crate) work_j: f64,
}

/// Buffers for the overlap of one candidate.
#[derive(Clone, Debug)]
struct SceneBuffers {
    bodies: Bodies,
    states: Vec<BodyState>,
    found: Overlap,
    hints: Vec<HintMemory>,
    clip: ClipBuffers,
}

impl Default for SceneBuffers {
    fn default() -> SceneBuffers {
        SceneBuffers {
            bodies: Bodies::with_capacity(0),
            states: Vec::new(),
            found: Overlap::default(),
            hints: Vec::new(),
            clip: ClipBuffers::default(),
        }
    }
}

impl RenewalBuffers {
    /// Puts the candidates of the next renewal into these buffers.
    pub(crate) fn meet(&mut self, candidates: impl IntoIterator<Item = Candidate>) {
        self.met.clear();
        self.met.extend(candidates.into_iter().map(|candidate| Met {
            candidate,
            is_near: false,
            before: [Held::default(); 2],
            work_j: 0.0,
        }));
    }
}

impl Model {
    /// Sets the outline at which a fender meets a body with outlines by height, from the next step on. `None` means
    /// that the body has no side at the height of the fender. `states` are the states of the bodies at which the next
    /// step begins.
    ///
    /// # Panics
    /// Panics if the builder did not declare the body with [`crate::ModelBuilder::outlines_by_height`], or if an id
    /// does not exist.
    pub fn renew_slice(
        &mut self,
        memory: &mut Memory,
        states: &[BodyState],
        (fender, body): (FenderId, BodyId),
        slice: Option<Slice>,
        buffers: &mut RenewalBuffers,
    ) -> Renewal {
        let (candidate, place) = self.met(fender, body);
        if *self.slices.slot(place) == slice {
            return Renewal { work_j: 0.0, before: slice };
        }
        let change = |model: &mut Model| core::mem::replace(model.slices.slot(place), slice);
        buffers.meet([candidate]);
        let before = self.change_met(memory, states, buffers, change);
        Renewal { work_j: buffers.met[0].work_j, before }
    }

    /// Changes a part of the model that the contacts of the candidates in `buffers` meet. The contacts continue. Writes the
    /// energy that the change puts into the contacts of each candidate into `buffers`, and returns what `change` returns.
    pub(crate) fn change_met<T>(
        &mut self,
        memory: &mut Memory,
        states: &[BodyState],
        buffers: &mut RenewalBuffers,
        change: impl FnOnce(&mut Model) -> T,
    ) -> T {
        // The held energy, by the time before the start in halves of the last step or sub-step.
        for index in 0..buffers.met.len() {
            let candidate = buffers.met[index].candidate;
            buffers.met[index].is_near = self.is_near(&candidate, states);
            if buffers.met[index].is_near {
                let held = [2.0, 1.0].map(|halves| {
                    self.held(memory, &candidate, states, halves, &mut buffers.scene)
                });
                buffers.met[index].before = held;
            }
        }
        let changed = change(self);
        for met in &mut buffers.met {
            let Met { candidate, is_near, before: [last, old], .. } = *met;
            let [new, next] = [1.0, 0.0].map(|halves| match is_near {
                true => self.held(memory, &candidate, states, halves, &mut buffers.scene),
                false => Held::default(),
            });
            let by_motion_j = last.share() * (old.loading_j - last.loading_j)
                + next.share() * (next.loading_j - new.loading_j);
            met.work_j = next.energy_j - last.energy_j - by_motion_j;
            memory.contacts.hints.retain(|hint| hint.candidate() != candidate.key());
            let is_own = |patch: &&mut PatchMemory| patch.candidate() == candidate.key();
            let patches = &mut memory.contacts.patches;
            let whole_m2: f64 = patches.iter_mut().filter(is_own).map(|patch| patch.area_m2).sum();
            for patch in patches.iter_mut().filter(is_own) {
                let share = patch.area_m2 / whole_m2;
                patch.taken_j = greater(patch.taken_j + met.work_j * share, 0.0);
            }
        }
        changed
    }

    /// Puts back the slice that a renewal replaced, after a step that failed. The caller must restore the memory
    /// itself.
    ///
    /// # Panics
    /// As [`Model::renew_slice`].
    pub fn undo_renewal(&mut self, (fender, body): (FenderId, BodyId), before: Option<Slice>) {
        let (_, place) = self.met(fender, body);
        *self.slices.slot(place) = before;
    }

    /// The side of a body with outlines by height that is before a fender's face: the side where body and fender touch,
    /// or where the body is nearest. If this side flares out upwards, the fender pushes the body up with a force of the
    /// slope times the contact's normal force. Returns `None` for a body with one outline, and if no side of the body
    /// is before the face.
    ///
    /// # Panics
    /// Panics if an id does not exist.
    #[must_use]
    pub fn side_met_by(
        &self,
        fender: FenderId,
        body: BodyId,
        states: &[BodyState],
    ) -> Option<SideMet> {
        let rank = self.rank_of[body.0 as usize];
        let number = self.face_of(Some(fender));
        let face = &self.faces[number as usize - 1];
        let pose = |rank: u32| states[self.id_of[rank as usize].0 as usize].pose();
        // Computed relative to the host, so that no digits are lost far from the origin.
        let hull = pose(face.host).to(pose(rank));
        self.side_met(face, number, rank, hull, Pose::IDENTITY)
    }

    /// Returns true if a fender would press on a body with this outline.
    ///
    /// # Panics
    /// As [`Model::renew_slice`].
    #[must_use]
    pub fn would_press(
        &mut self,
        (fender, body): (FenderId, BodyId),
        states: &[BodyState],
        slice: &Slice,
    ) -> bool {
        let (candidate, place) = self.met(fender, body);
        if !self.is_near(&candidate, states) {
            return false;
        }
        let own = self.slices.slot(place).replace(slice.clone());
        let mut scene = SceneBuffers::default();
        let state = |rank: u32| states[self.id_of[rank as usize].0 as usize];
        self.overlap_of(&candidate, state, &mut scene);
        *self.slices.slot(place) = own;
        !scene.found.patches.is_empty()
    }

    /// The candidate of a fender and of a body with outlines by height, and the index of the slice that the fender
    /// meets.
    fn met(&self, fender: FenderId, body: BodyId) -> (Candidate, usize) {
        let number = self.face_of(Some(fender));
        let face = &self.faces[number as usize - 1];
        let rank = self.rank_of[body.0 as usize];
        let place = self.slices.place(number, rank).expect("the body has outlines by height");
        let (a, b) = (face.host.min(rank), face.host.max(rank));
        (Candidate { a, b, face: number, material: face.material }, place)
    }

    /// Returns true if the circle around the fender's zone meets the circle around the body.
    fn is_near(&self, candidate: &Candidate, states: &[BodyState]) -> bool {
        let Some(face) = candidate.fender(self) else { return false };
        let other = if face.host == candidate.a { candidate.b } else { candidate.a };
        let state = |rank: u32| &states[self.id_of[rank as usize].0 as usize];
        let center_m = state(face.host).pose().apply(face.zone.center_m());
        let reach_m = face.zone.radius_m() + self.ranked[other as usize].radius_m;
        (center_m - state(other).position_m).length_squared() <= reach_m * reach_m
    }

    /// The overlap of a candidate's two bodies at these states by rank. Only the poses and states of the two bodies are set.
    fn overlap_of(
        &self,
        candidate: &Candidate,
        state: impl Fn(u32) -> BodyState,
        SceneBuffers { bodies, states, found, hints, clip }: &mut SceneBuffers,
    ) {
        bodies.poses.resize(self.ranked.len(), Pose::IDENTITY);
        states.resize(self.ranked.len(), BodyState::default());
        for rank in [candidate.a, candidate.b] {
            let state = state(rank);
            bodies.poses[rank as usize] = state.pose();
            states[rank as usize] = state;
        }
        let pairing = Pairing { candidate: *candidate, island: 0, pair: 0 };
        hints.clear();
        let _ = overlap(self, bodies, &[pairing], 0, Hints::new(&[], hints), clip, found);
    }

    /// Energy and force of the contacts of a candidate at a time before these states, computed with the memory of the
    /// last step. The time before these states is given in halves of the last step or sub-step.
    fn held(
        &self,
        memory: &Memory,
        candidate: &Candidate,
        states: &[BodyState],
        halves: f64,
        buffers: &mut SceneBuffers,
    ) -> Held {
        let earlier = |rank: u32| {
            let state = states[self.id_of[rank as usize].0 as usize];
            let half_s = memory.behind_s.get(rank as usize).map_or(0.0, |&s| greater(s, 0.0));
            let ago_s = halves * half_s;
            BodyState {
                position_m: state.position_m - state.velocity_mps * ago_s,
                heading_rad: state.heading_rad - state.yaw_rate_radps * ago_s,
                ..state
            }
        };
        self.overlap_of(candidate, earlier, buffers);
        let SceneBuffers { bodies, states, found, clip, .. } = buffers;
        let scene = Scene { model: self, overlap: found, poses: &bodies.poses, states };
        let mut held = Held::default();
        for patch in &scene.overlap.patches {
            let (a, b, number) = candidate.key();
            let wanted = (a, b, number, patch.number);
            let place = memory.contacts.patches.binary_search_by_key(&wanted, PatchMemory::key);
            let old = place.ok().map(|index| &memory.contacts.patches[index]);
            let face = candidate.fender(self);
            if let Some(face) = face {
                let factor = old.map(|memory| memory.factor);
                clip.panel.state = face.chain_state(number, &memory.parted, factor);
            }
            let touch = touch(&scene, clip, patch, face, old, Movers::Both);
            add_held(&mut held, self, patch, touch, old);
        }
        held
    }
}
