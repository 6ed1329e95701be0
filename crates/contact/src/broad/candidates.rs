//! Pairs of bodies that are near enough to touch in a step.

use alloc::vec::Vec;

use crate::broad::neighbours::NeighbourList;
use crate::maths::room::room_for;
use crate::model::Model;
use crate::model::fender::RankedFender;
use crate::model::material::MaterialId;
use crate::model::pair::Bounds;

/// The candidates of a step: pairs of bodies that may touch. Stage 2 of a step, `broad::pair`, computes the candidates.
#[derive(Clone, Debug, Default)]
pub(crate) struct Candidates {
    /// The candidates of this step, in the order of [`Candidate::key`]. The coupled method sorts the candidates by
    /// island first.
    pub(crate) pairings: Vec<Pairing>,
    /// Pairs of bodies that the model lists in no `Pair`, and that were near each other when the neighbour list was
    /// made.
    pub(crate) neighbours: NeighbourList,
}

/// Two bodies near enough to touch, given by their ranks: `a < b`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Candidate {
    pub(crate) a: u32,
    pub(crate) b: u32,
    /// 0: outline against outline. If `face` is not 0, it is 1 + the index in `Model::faces` of a fender of one of the
    /// two bodies, which meets the outline of the other body.
    pub(crate) face: u32,
    pub(crate) material: MaterialId,
}

/// A candidate, with its island and the number of its pair of bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pairing {
    pub(crate) candidate: Candidate,
    /// Rank of a body that identifies the candidate's island (group of bodies that may touch each other) in the coupled
    /// method. If both bodies float, the number is [`JOINED`] until the island is known.
    ///
    /// [`JOINED`]: crate::model::pair::JOINED
    pub(crate) island: u32,
    /// Number of the pair: an index into `Model::pairs`; larger numbers continue in the neighbour list.
    pub(crate) pair: u32,
}

impl Candidate {
    pub(crate) fn key(&self) -> (u32, u32, u32) {
        (self.a, self.b, self.face)
    }

    /// Returns the fender if the candidate is a fender against an outline, else `None`.
    #[inline]
    pub(crate) fn fender<'m>(&self, model: &'m Model) -> Option<&'m RankedFender> {
        self.face.checked_sub(1).map(|index| &model.faces[index as usize])
    }
}

impl Candidates {
    /// Makes an empty list of candidates with room for `count` candidates.
    pub(crate) fn with_room(model: &Model, count: usize) -> Candidates {
        let neighbours = match model.all_other_pairs {
            Some(_) => NeighbourList::with_room(model.bodies().len(), count),
            None => NeighbourList::default(),
        };
        Candidates { pairings: room_for(count), neighbours }
    }

    /// Returns the bounds of the pair of bodies with this number.
    #[inline]
    pub(crate) fn bounds_of<'m>(&'m self, model: &'m Model, pair: u32) -> &'m Bounds {
        let (pair, named) = (pair as usize, &model.pair_bounds);
        if pair < named.len() {
            &named[pair]
        } else {
            &self.neighbours.bounds()[pair - named.len()]
        }
    }
}
