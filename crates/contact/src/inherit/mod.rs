//! Stage 3b of a step, "inherit", finds which patch of this step continues which memory of the last step.
//!
//! The memory of a contact belongs to a pair of bodies and a patch of contact. The memory of a contact is kept while
//! the contact moves from edge to edge and from piece to piece of the outlines. When a patch splits, each part keeps
//! the whole shear of the patch, and gets a share of areas and energies in proportion to its own area. When patches
//! merge, the new shear is the mean of their shears weighted by area, areas and energies are added, and the new
//! reference speed is the largest of their reference speeds.

pub(crate) mod inherited;
pub(crate) mod matching;

use alloc::vec::Vec;

use crate::broad::candidates::Candidate;
use crate::inherit::inherited::Inherited;
use crate::inherit::matching::{Heirs, Matching};
use crate::maths::number::greater;
use crate::maths::room::room_for;
use crate::model::Model;
use crate::overlap::patch::{Patch, Place};
use crate::state::events::{note, report_ends_and_splits};
use crate::state::memory::{Past, PatchMemory};
use crate::state::report::{Event, EventKind};

/// The memory that the patches of a step or sub-step inherit. Computed by [`Inheritance::find`].
#[derive(Clone, Debug, Default)]
pub(crate) struct Inheritance {
    /// One entry per patch.
    pub(crate) inherited: Vec<Inherited>,
    /// Memories that were made from parts of old memories.
    pub(crate) shares: Vec<PatchMemory>,
    /// Buffers for the pair of bodies that is being matched.
    matching: Matching,
}

impl Inheritance {
    /// Makes buffers with room for this number of patches.
    pub(crate) fn with_room(patches: usize) -> Inheritance {
        Inheritance { inherited: room_for(patches), ..Inheritance::default() }
    }

    /// Finds what each patch inherits, and adds events for contacts that ended and patches that split.
    ///
    /// The first `matched` patches and memories are skipped, because the caller knows that they continue one to one.
    pub(crate) fn find(
        &mut self,
        model: &Model,
        past: Past<'_>,
        patches: &[Patch],
        places: &[Place],
        matched: usize,
        events: &mut Vec<Event>,
    ) {
        self.inherited.clear();
        self.shares.clear();
        let last = past.patches;
        let mut old = &last[matched..];
        let mut patches = &patches[matched..];
        loop {
            // Most patches continue the old patch at the same place in the list. Matching these first saves 12 % of a
            // step of the paper's method.
            if past.displaced.teleported.is_empty() {
                let count = (0..patches.len().min(old.len()))
                    .take_while(|&index| continues_alone(patches, old, index))
                    .count();
                let place = (last.len() - old.len()) as u32;
                self.inherited.extend((place..place + count as u32).map(Inherited::One));
                (patches, old) = (&patches[count..], &old[count..]);
            }
            let Some(Patch { candidate, of, .. }) = patches.first().copied() else { break };
            let Candidate { a, b, .. } = candidate;
            let count = patches.iter().take_while(|patch| patch.of == of).count();
            let (of_pair, rest) = patches.split_at(count);
            patches = rest;
            let (ended, mut own) = take_pair(&mut old, candidate.key());
            ended.iter().for_each(|m| note(model, events, m.a, m.b, EventKind::ContactEnded));
            if past.displaced.is_teleported(a, b) {
                own.iter().for_each(|_| note(model, events, a, b, EventKind::ContactEnded));
                own = &[];
            }
            match own {
                [] => self.inherited.extend(of_pair.iter().map(|_| Inherited::Nothing)),
                [_] if of_pair.len() == 1 => {
                    self.inherited.push(Inherited::One((last.len() - old.len() - 1) as u32));
                }
                _ => {
                    self.matching.find(of_pair, places, own, past.places);
                    report_ends_and_splits(model, events, own, &self.matching.heirs);
                    self.add_several(own, of_pair);
                }
            }
        }
        old.iter().for_each(|m| note(model, events, m.a, m.b, EventKind::ContactEnded));
    }

    /// Adds what the patches of a pair inherit from the old patches that the patches continue.
    fn add_several(&mut self, old: &[PatchMemory], patches: &[Patch]) {
        let Inheritance { inherited, shares, matching } = self;
        let mut matches = matching.matches.as_slice();
        for (number, patch) in (0..).zip(patches) {
            let own = matches.iter().take_while(|&&(of, _)| of == number).count();
            let (parents, rest) = matches.split_at(own);
            matches = rest;
            let parents = parents.iter().map(|&(_, parent)| {
                share_of(&old[parent as usize], matching.heirs[parent as usize], patch)
            });
            let Some((merged, several)) = merge(parents) else {
                inherited.push(Inherited::Nothing);
                continue;
            };
            let place = shares.len() as u32;
            shares.push(merged);
            let kind = if several { Inherited::Merged } else { Inherited::Part };
            inherited.push(kind(place));
        }
    }
}

/// The memory of a patch that continues all the old patches in `parents`, and whether there is more than one old patch.
/// Returns `None` if there is no old patch.
fn merge(mut parents: impl Iterator<Item = PatchMemory>) -> Option<(PatchMemory, bool)> {
    let mut merged = parents.next()?;
    let mut several = false;
    for parent in parents {
        several = true;
        let whole = merged.area_m2 + parent.area_m2;
        merged.shear_m =
            (merged.shear_m * merged.area_m2 + parent.shear_m * parent.area_m2) / whole;
        let share = parent.area_m2 / whole;
        merged.point_in_a_m += (parent.point_in_a_m - merged.point_in_a_m) * share;
        merged.point_in_b_m += (parent.point_in_b_m - merged.point_in_b_m) * share;
        merged.area_m2 = whole;
        merged.v_normal_0_mps = greater(merged.v_normal_0_mps, parent.v_normal_0_mps);
        if parent.v_tangential_0_mps.abs() > merged.v_tangential_0_mps.abs() {
            merged.v_tangential_0_mps = parent.v_tangential_0_mps;
        }
        merged.flags |= parent.flags;
        merged.taken_j += parent.taken_j;
        merged.sheared_j += parent.sheared_j;
        merged.damped_m2 += parent.damped_m2;
        for (top_j, more_j) in merged.tops_j.iter_mut().zip(parent.tops_j) {
            *top_j += more_j;
        }
    }
    Some((merged, several))
}

/// Returns true if the patch with the number `index` continues the old patch with the same number. Each of the two
/// patches must be the only patch of its pair of bodies.
#[inline(always)]
pub(crate) fn continues_alone(patches: &[Patch], old: &[PatchMemory], index: usize) -> bool {
    let (patch, memory) = (&patches[index], &old[index]);
    let (a, b, face) = patch.candidate.key();
    // Two convex bodies have at most one patch.
    memory.key() == (a, b, face, 0)
        && (patch.place().is_none() || are_only_ones(patches, old, index))
}

/// Returns true if this patch and this old patch are the only patches of their pair of bodies.
#[inline(never)]
fn are_only_ones(patches: &[Patch], old: &[PatchMemory], index: usize) -> bool {
    patches[index].number == 0
        && patches.get(index + 1).is_none_or(|patch| patch.number == 0)
        && old.get(index + 1).is_none_or(|memory| memory.patch == 0)
}

/// Removes the old patches of candidates before `key` from the sorted `memory`; then removes and returns the old
/// patches of the candidate with this key.
#[inline]
fn take_pair<'a>(
    memory: &mut &'a [PatchMemory],
    key: (u32, u32, u32),
) -> (&'a [PatchMemory], &'a [PatchMemory]) {
    let skipped = memory.iter().take_while(|m| m.candidate() < key).count();
    let (before, rest) = memory.split_at(skipped);
    let own = rest.iter().take_while(|m| m.candidate() == key).count();
    let (own, rest) = rest.split_at(own);
    *memory = rest;
    (before, own)
}

/// The share of the memory of an old patch that goes to `patch`, one of the patches that continue it. Area and energies
/// are shared in proportion to the areas of the patches, so the damper sees no loss of area when a patch splits.
fn share_of(parent: &PatchMemory, heirs: Heirs, patch: &Patch) -> PatchMemory {
    let share = patch.area_m2 / heirs.area_m2;
    PatchMemory {
        area_m2: parent.area_m2 * share,
        taken_j: parent.taken_j * share,
        sheared_j: parent.sheared_j * share,
        damped_m2: parent.damped_m2 * share,
        tops_j: parent.tops_j.map(|top_j| top_j * share),
        ..*parent
    }
}
