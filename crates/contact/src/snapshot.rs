//! A memory as bytes: versioned, little-endian, with the model's fingerprint and a checksum.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `fndrline` |
//! | 4 | version |
//! | 8 | fingerprint of the model |
//! | 8 | Δt of the last step |
//! | 4, 4, 4, 4, 4 | numbers of states, patches, hints, teleported bodies and times |
//! | 48 each | states, by rank |
//! | 252 each | patches |
//! | 40 each | hints |
//! | 4 each | ranks of bodies that the host has marked as teleported |
//! | 8 each | time by which the velocity precedes the position, by rank |
//! | 8 | FNV-1a of all bytes before |
//!
//! Everything is in the order of the bodies' keys: the bytes do not depend on the order in which
//! bodies were added to the model.

use alloc::vec::Vec;

use crate::admit::{LONGEST_STEP_S, SHORTEST_STEP_S};
use crate::error::RestoreError;
use crate::geometry::clip::Hint;
use crate::hash::Fnv1a;
use crate::memory::{HintMemory, Memory, NOT_BEHIND, PatchMemory, PlaceMemory, place_of};
use crate::model::Model;
use crate::patch::{Extent, Place};
use crate::state::BodyState;
use crate::vec2::{Rotation, Vec2, vec2};

/// The version that [`Memory::snapshot`] writes and [`Memory::restore`] reads.
pub const SNAPSHOT_VERSION: u32 = 6;

const MAGIC: &[u8; 8] = b"fndrline";
const STATE_BYTES: usize = 48;
const PATCH_BYTES: usize = 252;
const HINT_BYTES: usize = 40;
const TIME_BYTES: usize = 8;

impl Memory {
    /// All of this memory as bytes.
    #[must_use]
    pub fn snapshot(&self) -> Vec<u8> {
        let mut out = Writer(Vec::with_capacity(
            56 + self.placed.len() * 4
                + self.last_states.len() * STATE_BYTES
                + self.patches.len() * PATCH_BYTES
                + self.hints.len() * HINT_BYTES
                + self.behind_s.len() * TIME_BYTES,
        ));
        out.0.extend_from_slice(MAGIC);
        out.word32(SNAPSHOT_VERSION);
        out.word64(self.fingerprint);
        out.number(self.last_step_s);
        out.word32(self.last_states.len() as u32);
        out.word32(self.patches.len() as u32);
        out.word32(self.hints.len() as u32);
        out.word32(self.placed.len() as u32);
        out.word32(self.behind_s.len() as u32);
        self.last_states.iter().for_each(|s| out.state(s));
        for patch in &self.patches {
            out.patch(patch);
            out.place(&place_of(patch, &self.places).unwrap_or_default());
        }
        self.hints.iter().for_each(|h| out.hint(h));
        self.placed.iter().for_each(|&rank| out.word32(rank));
        self.behind_s.iter().for_each(|&behind_s| out.number(behind_s));
        let mut sum = Fnv1a::default();
        sum.bytes(&out.0);
        out.word64(sum.finish());
        out.0
    }

    /// Becomes what [`Memory::snapshot`] saved, for the same model.
    ///
    /// # Errors
    /// [`RestoreError`] for bytes that are not a whole, unchanged snapshot of this model; the memory
    /// is then as it was.
    pub fn restore(&mut self, model: &Model, bytes: &[u8]) -> Result<(), RestoreError> {
        *self = read(model, bytes)?;
        Ok(())
    }
}

fn read(model: &Model, bytes: &[u8]) -> Result<Memory, RestoreError> {
    let mut input = Reader(bytes);
    if input.take(8)? != MAGIC {
        return Err(RestoreError::NotASnapshot);
    }
    let found = input.word32()?;
    if found != SNAPSHOT_VERSION {
        return Err(RestoreError::Version { found });
    }
    let fingerprint = input.word64()?;
    let last_step_s = input.number()?;
    let [states, patches, hints] = [input.word32()?, input.word32()?, input.word32()?];
    let [states, patches, hints] = [states as usize, patches as usize, hints as usize];
    let placed = input.word32()?;
    let times = input.word32()?;
    let body = states as u128 * STATE_BYTES as u128
        + patches as u128 * PATCH_BYTES as u128
        + hints as u128 * HINT_BYTES as u128
        + u128::from(placed) * 4
        + u128::from(times) * TIME_BYTES as u128;
    if input.0.len() as u128 != body + 8 {
        return Err(RestoreError::Length);
    }
    let (summed, sum) = bytes.split_at(bytes.len() - 8);
    let mut expected = Fnv1a::default();
    expected.bytes(summed);
    if sum != expected.finish().to_le_bytes() {
        return Err(RestoreError::Checksum);
    }
    if fingerprint != model.fingerprint {
        return Err(RestoreError::OtherModel);
    }
    let mut memory = Memory::new(model);
    memory.last_step_s = last_step_s;
    for _ in 0..states {
        memory.last_states.push(input.state()?);
    }
    for _ in 0..patches {
        let patch = input.patch()?;
        memory.patches.push(patch);
        // Nothing but nought where it has none.
        let place = input.place()?;
        if place != Place::default() {
            let PatchMemory { a, b, face, patch, .. } = patch;
            memory.places.push(PlaceMemory { a, b, face, patch, place });
        }
    }
    for _ in 0..hints {
        memory.hints.push(input.hint()?);
    }
    for _ in 0..placed {
        memory.placed.push(input.word32()?);
    }
    for _ in 0..times {
        memory.behind_s.push(input.number()?);
    }
    check(model, &memory)?;
    Ok(memory)
}

/// What the check sum cannot tell: a snapshot written by somebody else.
fn check(model: &Model, memory: &Memory) -> Result<(), RestoreError> {
    let bodies = model.ranked.len();
    let known = |(a, b, face): (u32, u32, u32)| {
        a < b
            && (b as usize) < bodies
            && face.checked_sub(1).is_none_or(|index| {
                model.faces.get(index as usize).is_some_and(|f| f.host == a || f.host == b)
            })
    };
    // `Memory::set_elapsed` takes parts of a step.
    let elapsed = 1e-3 * SHORTEST_STEP_S..=LONGEST_STEP_S;
    let in_time = |behind_s: f64| {
        behind_s.to_bits() == NOT_BEHIND.to_bits() || (0.0..=LONGEST_STEP_S).contains(&behind_s)
    };
    let ok = (memory.behind_s.is_empty() || memory.behind_s.len() == bodies)
        && memory.behind_s.iter().all(|&behind_s| in_time(behind_s))
        && (memory.last_states.is_empty() || memory.last_states.len() == bodies)
        && (memory.last_step_s == 0.0 || elapsed.contains(&memory.last_step_s))
        && memory.placed.windows(2).all(|w| w[0] < w[1])
        && memory.placed.last().is_none_or(|&rank| (rank as usize) < bodies)
        && memory.patches.windows(2).all(|w| w[0].key() < w[1].key())
        && memory.patches.iter().all(|p| known(p.candidate()) && p.area_m2 > 0.0)
        && memory.patches.iter().all(|p| p.taken_j >= 0.0 && p.sheared_j >= 0.0)
        && memory.patches.iter().all(|p| p.tops_j.iter().all(|&top_j| top_j >= 0.0))
        && memory.hints.windows(2).all(|w| w[0].key() < w[1].key())
        && memory.hints.iter().all(|h| known(h.candidate()));
    if ok { Ok(()) } else { Err(RestoreError::Content) }
}

pub(crate) struct Writer(pub(crate) Vec<u8>);

impl Writer {
    pub(crate) fn word32(&mut self, word: u32) {
        self.0.extend_from_slice(&word.to_le_bytes());
    }

    pub(crate) fn word64(&mut self, word: u64) {
        self.0.extend_from_slice(&word.to_le_bytes());
    }

    pub(crate) fn number(&mut self, value: f64) {
        self.word64(value.to_bits());
    }

    pub(crate) fn vector(&mut self, v: Vec2) {
        self.number(v.x);
        self.number(v.y);
    }

    pub(crate) fn state(&mut self, s: &BodyState) {
        self.vector(s.position_m);
        self.number(s.heading_rad);
        self.vector(s.velocity_mps);
        self.number(s.yaw_rate_radps);
    }

    fn extent(&mut self, e: &Extent) {
        self.vector(e.low_m);
        self.vector(e.high_m);
    }

    fn patch(&mut self, p: &PatchMemory) {
        [p.a, p.b, p.face, p.patch, p.flags].into_iter().for_each(|w| self.word32(w));
        [p.area_m2, p.shear_m, p.v_normal_0_mps, p.v_tangential_0_mps]
            .into_iter()
            .for_each(|v| self.number(v));
        [p.normal_force_n, p.tangential_force_n, p.factor, p.taken_j, p.sheared_j, p.damped_m2]
            .into_iter()
            .for_each(|v| self.number(v));
        [p.point_in_a_m, p.point_in_b_m, p.normal_in_a].into_iter().for_each(|v| self.vector(v));
        [p.b_in_a.cos, p.b_in_a.sin].into_iter().for_each(|v| self.number(v));
        p.tops_j.into_iter().for_each(|v| self.number(v));
    }

    fn place(&mut self, p: &Place) {
        self.extent(&p.in_a);
        self.extent(&p.in_b);
    }

    fn hint(&mut self, h: &HintMemory) {
        [h.a, h.b, h.face, h.piece_a, h.piece_b].into_iter().for_each(|w| self.word32(w));
        h.hint.to_words().into_iter().for_each(|w| self.word32(w));
    }
}

pub(crate) struct Reader<'a>(pub(crate) &'a [u8]);

impl<'a> Reader<'a> {
    pub(crate) fn take(&mut self, count: usize) -> Result<&'a [u8], RestoreError> {
        let (taken, rest) = self.0.split_at_checked(count).ok_or(RestoreError::Length)?;
        self.0 = rest;
        Ok(taken)
    }

    pub(crate) fn word32(&mut self) -> Result<u32, RestoreError> {
        let bytes = self.take(4)?.try_into().map_err(|_| RestoreError::Length)?;
        Ok(u32::from_le_bytes(bytes))
    }

    fn word64(&mut self) -> Result<u64, RestoreError> {
        let bytes = self.take(8)?.try_into().map_err(|_| RestoreError::Length)?;
        Ok(u64::from_le_bytes(bytes))
    }

    /// Finite and of a size that cannot overflow in the next step.
    pub(crate) fn number(&mut self) -> Result<f64, RestoreError> {
        let value = f64::from_bits(self.word64()?);
        if value.abs() <= 1e30 { Ok(value) } else { Err(RestoreError::Content) }
    }

    pub(crate) fn vector(&mut self) -> Result<Vec2, RestoreError> {
        Ok(vec2(self.number()?, self.number()?))
    }

    pub(crate) fn state(&mut self) -> Result<BodyState, RestoreError> {
        Ok(BodyState {
            position_m: self.vector()?,
            heading_rad: self.number()?,
            velocity_mps: self.vector()?,
            yaw_rate_radps: self.number()?,
        })
    }

    fn extent(&mut self) -> Result<Extent, RestoreError> {
        Ok(Extent { low_m: self.vector()?, high_m: self.vector()? })
    }

    fn patch(&mut self) -> Result<PatchMemory, RestoreError> {
        Ok(PatchMemory {
            a: self.word32()?,
            b: self.word32()?,
            face: self.word32()?,
            patch: self.word32()?,
            flags: self.word32()?,
            area_m2: self.number()?,
            shear_m: self.number()?,
            v_normal_0_mps: self.number()?,
            v_tangential_0_mps: self.number()?,
            normal_force_n: self.number()?,
            tangential_force_n: self.number()?,
            factor: self.number()?,
            taken_j: self.number()?,
            sheared_j: self.number()?,
            damped_m2: self.number()?,
            point_in_a_m: self.vector()?,
            point_in_b_m: self.vector()?,
            normal_in_a: self.vector()?,
            b_in_a: Rotation { cos: self.number()?, sin: self.number()? },
            tops_j: [self.number()?, self.number()?, self.number()?],
        })
    }

    fn place(&mut self) -> Result<Place, RestoreError> {
        Ok(Place { in_a: self.extent()?, in_b: self.extent()? })
    }

    fn hint(&mut self) -> Result<HintMemory, RestoreError> {
        let [a, b, face] = [self.word32()?, self.word32()?, self.word32()?];
        let [piece_a, piece_b] = [self.word32()?, self.word32()?];
        let mut words = [0; 5];
        for word in &mut words {
            *word = self.word32()?;
        }
        let hint = Hint::from_words(words).ok_or(RestoreError::Content)?;
        Ok(HintMemory { a, b, face, piece_a, piece_b, hint })
    }
}
