//! Finds the part of a body that a fender's face meets: the outline of the body, or its slice at the height of the
//! fender.

use core::slice;

use crate::broad::candidates::Candidate;
use crate::geometry::convex::ConvexPolygon;
use crate::geometry::shapes::Shapes;
use crate::maths::vec2::{Pose, Vec2};
use crate::model::Model;
use crate::model::fender::RankedFender;
use crate::model::outline::Outline;
use crate::model::reaction::FenderLaw;
use crate::model::slice::{SideMet, Slice};

impl Model {
    /// The shapes of both sides of a candidate. Each of the two shapes is an outline, a slice, or the zone of a fender.
    pub(crate) fn shapes_of<'m>(&'m self, candidate: &Candidate) -> [Shapes<'m>; 2] {
        let face = candidate.fender(self);
        [candidate.a, candidate.b].map(|rank| match face {
            None => self.ranked.shapes(rank as usize),
            Some(face) if face.host == rank => Shapes::few(slice::from_ref(&face.zone)),
            Some(_) => match self.slices.place(candidate.face, rank) {
                None => self.ranked.shapes(rank as usize),
                Some(_) => Shapes::few(self.pieces_met(candidate.face, rank)),
            },
        })
    }

    /// The convex pieces of a body that a fender's face meets. `face` is the number of the fender's face, counted
    /// from 1.
    #[inline]
    pub(crate) fn pieces_met(&self, face: u32, rank: u32) -> &[ConvexPolygon] {
        match self.slices.place(face, rank) {
            None => self.ranked.pieces(rank as usize),
            Some(place) => self.slices.at(place).map_or(&[], |slice| &slice.pieces),
        }
    }

    /// The edges of a body that a fender's face meets, given by their ends in the frame of the body (m). `face` is the
    /// number of the fender's face, counted from 1.
    pub(crate) fn edges_met(&self, face: u32, rank: u32) -> impl Iterator<Item = [Vec2; 2]> {
        let slice = self.slices.place(face, rank).map(|place| self.slices.at(place));
        let outline = match slice {
            None => Some(&self.bodies()[self.id_of[rank as usize].0 as usize].outline),
            Some(_) => None,
        };
        let cut = slice.flatten().into_iter().flat_map(Slice::edges_m);
        outline.into_iter().flat_map(Outline::edges).chain(cut)
    }

    /// The [`Slice::side`] of that slice of a body which a fender's face meets. The function also returns `None` for a
    /// body that has only one outline.
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
