//! Bodies on piles in the order of their ranks.

use alloc::vec::Vec;

use crate::model::body::{Body, Mobility};
use crate::model::material::BodyId;
use crate::model::pile::Pile;

/// A pile, with the mass of the body that stands on it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RankedPile {
    /// Rank of the body that stands on the pile.
    pub(crate) rank: u32,
    pub(crate) mass_kg: f64,
    pub(crate) pile: Pile,
}

impl RankedPile {
    /// Lists the piles of all bodies that stand on piles, by rank.
    pub(crate) fn all(bodies: &[Body], id_of: &[BodyId]) -> Vec<RankedPile> {
        let of_rank = |(rank, id): (u32, &BodyId)| match bodies[id.0 as usize].mobility {
            Mobility::OnPile { mass_kg, pile } => Some(RankedPile { rank, mass_kg, pile }),
            _ => None,
        };
        (0..).zip(id_of).filter_map(of_rank).collect()
    }

    /// Square ω² of the natural frequency of the body on its pile (1/s²).
    pub(crate) fn rate_squared(&self) -> f64 {
        self.pile.stiffness_npm / self.mass_kg
    }

    /// ω (rad/s).
    pub(crate) fn rate_radps(&self) -> f64 {
        libm::sqrt(self.rate_squared())
    }
}
