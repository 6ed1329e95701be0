//! What a fender's face meets of a body: her outline, or her slice at its height.

use crate::fender::RankedFender;
use crate::geometry::convex::ConvexPolygon;
use crate::model::Model;
use crate::reaction::FenderLaw;
use crate::slice::{SideMet, Slice};
use crate::vec2::{Pose, Vec2};

impl Model {
    /// The convex pieces that a face (by its number, from 1) meets of a body.
    #[inline]
    pub(crate) fn pieces_met(&self, face: u32, rank: u32) -> &[ConvexPolygon] {
        match self.slices.place(face, rank) {
            None => self.ranked.pieces(rank as usize),
            Some(place) => self.slices.at(place).map_or(&[], |slice| &slice.pieces),
        }
    }

    /// The edges that a face (by its number, from 1) meets of a body, by their ends in the body's frame (m).
    pub(crate) fn edges_met(&self, face: u32, rank: u32) -> impl Iterator<Item = [Vec2; 2]> {
        let slice = self.slices.place(face, rank).map(|place| self.slices.at(place));
        let outline: &[Vec2] = match slice {
            None => self.bodies()[self.id_of[rank as usize].0 as usize].outline.vertices(),
            Some(_) => &[],
        };
        let cut = slice.flatten().into_iter().flat_map(Slice::edges_m);
        let whole = outline.iter().zip(outline.iter().cycle().skip(1));
        whole.map(|(&from, &to)| [from, to]).chain(cut)
    }

    /// [`Slice::side`] of the slice that a face meets of a body; `None` for a body with one outline, too.
    pub(crate) fn side_met(
        &self,
        face: &RankedFender,
        number: u32,
        rank: u32,
        hull: Pose,
        host: Pose,
    ) -> Option<SideMet> {
        let slice = self.slices.at(self.slices.place(number, rank)?)?;
        let by_depth = self.fenders()[face.id.0 as usize].law == FenderLaw::Area;
        slice.side(face, by_depth, hull, host)
    }
}
