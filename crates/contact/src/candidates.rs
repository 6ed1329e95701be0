//! Pairs of bodies that are near enough to touch in a step.

use alloc::vec::Vec;

use crate::fender::RankedFender;
use crate::material::MaterialId;
use crate::model::Model;
use crate::neighbours::NeighbourList;
use crate::pair::Bounds;
use crate::room::room_for;

/// Computed by stage 2, `broad::pair`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Candidates {
    /// In the order of [`Candidate::key`]; by the coupled method sorted by island first.
    pub(crate) pairings: Vec<Pairing>,
    /// Pairs that no `Pair` of the model names and that were near when the list was made.
    pub(crate) neighbours: NeighbourList,
}

/// Two bodies near enough to touch, by rank: `a < b`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Candidate {
    pub(crate) a: u32,
    pub(crate) b: u32,
    /// 0: outline against outline. Else 1 + the place in `Model::faces` of a fender of one of the two, against the
    /// other's outline.
    pub(crate) face: u32,
    pub(crate) material: MaterialId,
}

/// A candidate with its island and its pair.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pairing {
    pub(crate) candidate: Candidate,
    /// By the coupled method: the rank of a body that identifies the candidate's island. [`JOINED`] until that is
    /// known, where both bodies float.
    ///
    /// [`JOINED`]: crate::pair::JOINED
    pub(crate) island: u32,
    /// Number of its pair: in `Model::pairs`, or beyond them in the neighbour list.
    pub(crate) pair: u32,
}

impl Candidate {
    pub(crate) fn key(&self) -> (u32, u32, u32) {
        (self.a, self.b, self.face)
    }

    /// The fender, if it is one against an outline.
    #[inline]
    pub(crate) fn fender<'m>(&self, model: &'m Model) -> Option<&'m RankedFender> {
        self.face.checked_sub(1).map(|index| &model.faces[index as usize])
    }
}

impl Candidates {
    /// With room for so many of them.
    pub(crate) fn with_room(model: &Model, count: usize) -> Candidates {
        let neighbours = match model.all_other_pairs {
            Some(_) => NeighbourList::with_room(model.bodies().len(), count),
            None => NeighbourList::default(),
        };
        Candidates { pairings: room_for(count), neighbours }
    }

    /// Bounds of the pair with this number.
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
