//! Writes and reads a memory as bytes, in little-endian order, with a version number, the model's fingerprint and a
//! checksum.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `fndrline` |
//! | 4 | version |
//! | 8 | fingerprint of the model |
//! | 8 | Δt, the length of the last step (s) |
//! | 4 each | numbers of states, patches, hints, teleported bodies, velocity lags, parted chains, piles |
//! | 48 each | states, by rank |
//! | 252 each | patches |
//! | 40 each | hints |
//! | 4 each | ranks of bodies that the host has marked as teleported |
//! | 8 each | time by which the velocity of a body is older than its position, by rank |
//! | 4 each | parted chains: the number of the fender's face times 16, plus the number of the chain |
//! | 16 each | permanent deflections of the piles, by rank |
//! | 8 | FNV-1a hash of all bytes before |
//!
//! All lists in a snapshot are in the order of the bodies' keys: the bytes do not depend on the order in which bodies
//! were added to the model.

use alloc::vec::Vec;

use crate::admit::{LONGEST_STEP_S, SHORTEST_STEP_S};
use crate::error::RestoreError;
use crate::geometry::clip::Hint;
use crate::geometry::extent::Extent;
use crate::maths::vec2::Vec2;
use crate::model::Model;
use crate::overlap::patch::Place;
use crate::panel::chains::is_chain;
use crate::state::body_state::{BodyState, FURTHEST_M};
use crate::state::bytes::{Codec, Reader, Record, Writer, check_sum, records};
use crate::state::memory::{
    ContactMemory, HintMemory, Memory, NOT_BEHIND, PatchMemory, PlaceMemory, place_of,
};

const MAGIC: &[u8; 8] = b"fndrline";

records! {
    PatchMemory {
        a, b, face, patch, flags, area_m2, shear_m, v_normal_0_mps, v_tangential_0_mps,
        normal_force_n, tangential_force_n, factor, taken_j, sheared_j, damped_m2,
        point_in_a_m, point_in_b_m, normal_in_a, b_in_a, tops_j
    }
    Extent { low_m, high_m }
    Place { in_a, in_b }
    HintMemory { a, b, face, piece_a, piece_b, hint }
}

impl Record for Hint {
    fn code(&mut self, codec: &mut impl Codec) {
        let mut words = self.to_words();
        words.iter_mut().for_each(|word| codec.word(word));
        *self = Hint::from_words(words).unwrap_or_else(|| {
            codec.refuse();
            Hint::None
        });
    }
}

impl Memory {
    /// This memory as bytes.
    #[must_use]
    pub fn snapshot(&self) -> Vec<u8> {
        let mut out = Writer::new(MAGIC);
        out.bytes(&self.fingerprint.to_le_bytes());
        out.put(self.last_step_s);
        let Memory { last_states, placed, behind_s, parted, pile_offsets_m, .. } = self;
        let ContactMemory { patches, places, hints } = &self.contacts;
        let counts = [last_states.len(), patches.len(), hints.len(), placed.len()];
        let others = [behind_s.len(), parted.len(), pile_offsets_m.len()];
        for count in counts.into_iter().chain(others) {
            out.put(count as u32);
        }
        last_states.iter().for_each(|&state| out.put(state));
        for patch in patches {
            out.put((*patch, place_of(patch, places).unwrap_or_default()));
        }
        hints.iter().for_each(|&hint| out.put(hint));
        placed.iter().for_each(|&rank| out.put(rank));
        behind_s.iter().for_each(|&behind_s| out.put(behind_s));
        parted.iter().for_each(|&word| out.put(word));
        pile_offsets_m.iter().for_each(|&offset_m| out.put(offset_m));
        out.sealed()
    }

    /// Restores a memory that [`Memory::snapshot`] saved, for the same model.
    ///
    /// # Errors
    /// Returns a [`RestoreError`] if the bytes are not a whole, unchanged snapshot for this model; the memory is then
    /// unchanged.
    pub fn restore(&mut self, model: &Model, bytes: &[u8]) -> Result<(), RestoreError> {
        *self = read(model, bytes)?;
        Ok(())
    }
}

fn read(model: &Model, bytes: &[u8]) -> Result<Memory, RestoreError> {
    let mut input = Reader::open(bytes, MAGIC)?;
    let mut memory = Memory::new(model);
    let fingerprint = u64::from_le_bytes(input.array());
    memory.last_step_s = input.get();
    let counts: [u32; 7] = core::array::from_fn(|_| input.get());
    input.outcome()?;
    let sizes = [
        BodyState::byte_count(),
        <(PatchMemory, Place)>::byte_count(),
        HintMemory::byte_count(),
        u32::byte_count(),
        f64::byte_count(),
        u32::byte_count(),
        Vec2::byte_count(),
    ];
    input.check_left(
        counts.iter().zip(sizes).map(|(&count, size)| u128::from(count) * size).sum(),
    )?;
    check_sum(bytes)?;
    if fingerprint != model.fingerprint {
        return Err(RestoreError::OtherModel);
    }
    let [states, patches, hints, placed, times, parted, piles] = counts;
    memory.last_states.extend((0..states).map(|_| input.get::<BodyState>()));
    for _ in 0..patches {
        let (patch, place): (PatchMemory, Place) = input.get();
        memory.contacts.patches.push(patch);
        // A patch without a place has zeros here.
        if place != Place::default() {
            let PatchMemory { a, b, face, patch, .. } = patch;
            memory.contacts.places.push(PlaceMemory { a, b, face, patch, place });
        }
    }
    memory.contacts.hints.extend((0..hints).map(|_| input.get::<HintMemory>()));
    memory.placed.extend((0..placed).map(|_| input.get::<u32>()));
    memory.behind_s.extend((0..times).map(|_| input.get::<f64>()));
    memory.parted.extend((0..parted).map(|_| input.get::<u32>()));
    memory.pile_offsets_m.extend((0..piles).map(|_| input.get::<Vec2>()));
    input.outcome()?;
    check(model, &memory)?;
    Ok(memory)
}

/// Checks the values. The checksum alone cannot show that another program has written impossible values.
fn check(model: &Model, memory: &Memory) -> Result<(), RestoreError> {
    let bodies = model.ranked.len();
    let known = |(a, b, face): (u32, u32, u32)| {
        a < b
            && (b as usize) < bodies
            && face.checked_sub(1).is_none_or(|index| {
                model.faces.get(index as usize).is_some_and(|f| f.host == a || f.host == b)
            })
    };
    // `Memory::set_elapsed` may set a part of a step.
    let elapsed = 1e-3 * SHORTEST_STEP_S..=LONGEST_STEP_S;
    let in_time = |behind_s: f64| {
        behind_s.to_bits() == NOT_BEHIND.to_bits() || (0.0..=LONGEST_STEP_S).contains(&behind_s)
    };
    let ok = (memory.behind_s.is_empty() || memory.behind_s.len() == bodies)
        && memory.behind_s.iter().all(|&behind_s| in_time(behind_s))
        && (memory.last_states.is_empty() || memory.last_states.len() == bodies)
        && (memory.last_step_s == 0.0 || elapsed.contains(&memory.last_step_s))
        && (memory.pile_offsets_m.is_empty() || memory.pile_offsets_m.len() == model.piles.len())
        && memory.pile_offsets_m.iter().all(|offset_m| offset_m.length() <= FURTHEST_M)
        && memory.placed.windows(2).all(|w| w[0] < w[1])
        && memory.placed.last().is_none_or(|&rank| (rank as usize) < bodies)
        && memory.parted.windows(2).all(|w| w[0] < w[1])
        && memory.parted.iter().all(|&word| is_chain(word, |face| model.chains_of(face)))
        && memory.contacts.patches.windows(2).all(|w| w[0].key() < w[1].key())
        && memory.contacts.patches.iter().all(|p| known(p.candidate()) && p.area_m2 > 0.0)
        && memory.contacts.patches.iter().all(|p| p.taken_j >= 0.0 && p.sheared_j >= 0.0)
        && memory.contacts.patches.iter().all(|p| p.tops_j.iter().all(|&top_j| top_j >= 0.0))
        && memory.contacts.hints.windows(2).all(|w| w[0].key() < w[1].key())
        && memory.contacts.hints.iter().all(|h| known(h.candidate()));
    if ok { Ok(()) } else { Err(RestoreError::Content) }
}
