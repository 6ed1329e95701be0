//! Fenders that lean with their ship: a host moves a fender in the plane, because roll and pitch of the ship move the
//! place at which the ship carries the fender (docs/contact_model.md, section 8).
//!
//! The contacts of the fender continue. The energy that the movement of the fender puts into its contacts is no work of
//! the bodies' motion in the plane: the host counts this energy as work of roll and pitch, as for
//! [`Model::renew_slice`].

use crate::broad::candidates::Candidate;
use crate::maths::vec2::Vec2;
use crate::model::Model;
use crate::model::fender::RankedFender;
use crate::model::material::{BodyId, FenderId};
use crate::model::renew::{Met, RenewalBuffers};
use crate::state::body_state::BodyState;
use crate::state::memory::Memory;

impl Model {
    /// Moves a fender by `lean_m` from the place at which the model was built with it, in the frame of the body that
    /// carries the fender (m), from the next step on. `states` are the states at which the next step begins.
    ///
    /// Returns the energy that the movement put into the fender's contacts (J), by the body that touches the fender.
    /// The energy is negative if the movement took energy out.
    ///
    /// # Panics
    /// Panics if the model has no such fender.
    pub fn lean_fender<'b>(
        &'b mut self,
        memory: &mut Memory,
        states: &[BodyState],
        (fender, lean_m): (FenderId, Vec2),
        buffers: &'b mut RenewalBuffers,
    ) -> impl Iterator<Item = (BodyId, f64)> + 'b {
        let number = self.face_of(Some(fender));
        let RankedFender { host, material, .. } = self.faces[number as usize - 1];
        let mut last = None;
        let own = memory.contacts.patches.iter().filter(|patch| patch.face == number);
        let candidates = own.filter_map(|patch| {
            let candidate = Candidate { a: patch.a, b: patch.b, face: number, material };
            (last.replace(candidate.key()) != Some(candidate.key())).then_some(candidate)
        });
        buffers.meet(candidates);
        self.change_met(memory, states, buffers, |model| model.set_lean(fender, lean_m));
        let id_of = &self.id_of;
        buffers.met.iter().map(move |Met { candidate: Candidate { a, b, .. }, work_j, .. }| {
            let touching = if *a == host { *b } else { *a };
            (id_of[touching as usize], *work_j)
        })
    }

    /// Sets the place of a fender as [`Model::lean_fender`] does, but leaves the memory of the contacts: for a host that
    /// restores an earlier place and memory, after a step that failed.
    ///
    /// # Panics
    /// Panics if the model has no such fender.
    pub fn set_lean(&mut self, fender: FenderId, lean_m: Vec2) {
        let number = self.face_of(Some(fender)) as usize - 1;
        let upright = &self.fenders[fender.0 as usize];
        self.faces[number].move_to(upright, upright.position_m + lean_m);
    }
}
