//! Tension chains that part.

use alloc::vec::Vec;

use crate::panel::Panel;

/// Bit set of the chains of a panel that have parted: bit i stands for chain i.
pub(crate) type Parted = u32;

/// Parted chains are stored as sorted words: the number of the face times [`WORD`], plus the number of the chain.
pub(crate) const WORD: u32 = 16;

/// The state of the chains of a fender panel, on which the panel's force depends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ChainState {
    /// Factor on the stiffness of the chains, which is one over the factor on the cones' reactions. The factor of the
    /// cones is applied to the whole force later, and the chains must not have this factor.
    pub(crate) scale: f64,
    pub(crate) parted: Parted,
}

impl Default for ChainState {
    fn default() -> ChainState {
        ChainState { scale: 1.0, parted: 0 }
    }
}

/// The chains that part in a sub-step, with the tension at which each chain parts (N); 0 for a chain that does not part
/// in the sub-step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Broken {
    pub(crate) chains: Parted,
    pub(crate) tensions_n: [f64; Panel::MOST_CHAINS],
    /// Break load of the chain, divided by its tension at the start of the sub-step. A chain parts within the sub-step
    /// before the sub-step in which the engine finds that it parted.
    pub(crate) overshoot: f64,
}

/// The chains of a fender's face that have parted.
fn parted_of(list: &[u32], face: u32) -> Parted {
    let own = list.iter().filter(|&&word| word / WORD == face);
    own.fold(0, |parted, word| parted | 1 << (word % WORD))
}

/// The state of the chains of a face, from the list of parted chains and the factor on the face's reaction.
#[inline]
pub(crate) fn chain_state(face: u32, list: &[u32], factor: f64) -> ChainState {
    ChainState { scale: 1.0 / factor, parted: parted_of(list, face) }
}

/// Adds parted chains of a face to the list.
pub(crate) fn add_parted(list: &mut Vec<u32>, face: u32, parted: Parted) {
    for chain in (0..Panel::MOST_CHAINS as u32).filter(|chain| parted & (1 << chain) != 0) {
        let word = face * WORD + chain;
        if let Err(at) = list.binary_search(&word) {
            list.insert(at, word);
        }
    }
}

/// Returns true if a word of the list of parted chains stands for a chain that exists. `chains_of` gives the number of
/// chains of each face.
pub(crate) fn is_chain(word: u32, chains_of: impl Fn(u32) -> usize) -> bool {
    (word % WORD) < chains_of(word / WORD) as u32
}
