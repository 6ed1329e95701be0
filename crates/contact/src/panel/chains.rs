//! Tension chains that part.

use alloc::vec::Vec;

use crate::panel::Panel;

/// Which chains of a panel have parted: bit i for chain i.
pub(crate) type Parted = u32;

/// The chains that have parted, as sorted words: the number of the face times [`WORD`], plus that of the chain.
pub(crate) const WORD: u32 = 16;

/// What the force of a panel depends on besides the hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ChainState {
    /// Stiffness of chains over that of cones: one over the factor on the cones' reactions, which is applied to all.
    pub(crate) scale: f64,
    pub(crate) parted: Parted,
}

impl Default for ChainState {
    fn default() -> ChainState {
        ChainState { scale: 1.0, parted: 0 }
    }
}

/// The chains that part in a sub-step, with the tensions at which they part; 0 of the others.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Broken {
    pub(crate) chains: Parted,
    pub(crate) tensions_n: [f64; Panel::MOST_CHAINS],
    /// Break load over tension at the start of the sub-step in which it is found: a chain parts within the one before.
    pub(crate) overshoot: f64,
}

/// Which chains of a face have parted.
fn parted_of(list: &[u32], face: u32) -> Parted {
    let own = list.iter().filter(|&&word| word / WORD == face);
    own.fold(0, |parted, word| parted | 1 << (word % WORD))
}

/// The state of a face's chains: parted ones by the list, and the factor on its reaction.
#[inline]
pub(crate) fn chain_state(face: u32, list: &[u32], factor: f64) -> ChainState {
    ChainState { scale: 1.0 / factor, parted: parted_of(list, face) }
}

/// Adds chains of a face to the list.
pub(crate) fn add_parted(list: &mut Vec<u32>, face: u32, parted: Parted) {
    for chain in (0..Panel::MOST_CHAINS as u32).filter(|chain| parted & (1 << chain) != 0) {
        let word = face * WORD + chain;
        if let Err(at) = list.binary_search(&word) {
            list.insert(at, word);
        }
    }
}

/// Whether a word of a list is that of a chain, by the number of chains of each face.
pub(crate) fn is_chain(word: u32, chains_of: impl Fn(u32) -> usize) -> bool {
    (word % WORD) < chains_of(word / WORD) as u32
}
