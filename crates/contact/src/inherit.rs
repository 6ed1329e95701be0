//! Stage 3b, inherit: which patch of this step continues which memory of the last.
//!
//! A contact's memory belongs to its pair of bodies and its patch. It is kept while the contact moves from edge to edge
//! and from piece to piece. When a patch splits, each part keeps the whole shear, and its share by area of areas and
//! energies. When patches merge, the shear is their mean by area, areas and energies are added, and the reference speed is
//! the largest.

use alloc::vec::Vec;

use crate::candidates::Candidate;
use crate::events::{note, report_ends_and_splits};
use crate::inherited::Inherited;
use crate::matching::{Heirs, Matching};
use crate::memory::{Past, PatchMemory};
use crate::model::Model;
use crate::number::greater;
use crate::patch::{Patch, Place};
use crate::report::{Event, EventKind};
use crate::room::room_for;

/// What the patches of a (sub-)step inherit. Computed by [`Inheritance::find`].
#[derive(Clone, Debug, Default)]
pub(crate) struct Inheritance {
    /// One entry a patch.
    pub(crate) inherited: Vec<Inherited>,
    /// Memories made from parts of old ones.
    pub(crate) shares: Vec<PatchMemory>,
    /// Of the pair in hand.
    matching: Matching,
}

impl Inheritance {
    /// With room for so many patches.
    pub(crate) fn with_room(patches: usize) -> Inheritance {
        Inheritance { inherited: room_for(patches), ..Inheritance::default() }
    }

    /// Finds what each patch inherits, and adds the events of contacts that ended and patches that split.
    ///
    /// The first `matched` patches and memories are skipped: the caller knows that they continue one to one.
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
            // Most patches continue the old one in its place. Matching them first saves 12 % of the paper's method.
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

    /// Adds what the patches of a pair inherit from the old ones that they continue.
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

/// The memory of a patch that continues all of these, and whether these are several. `None` if there is none.
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

/// Does patch number `index` continue the old patch of the same number, each being the only patch of its pair?
#[inline(always)]
pub(crate) fn continues_alone(patches: &[Patch], old: &[PatchMemory], index: usize) -> bool {
    let (patch, memory) = (&patches[index], &old[index]);
    let (a, b, face) = patch.candidate.key();
    // Two convex bodies have at most one patch.
    memory.key() == (a, b, face, 0)
        && (patch.place().is_none() || are_only_ones(patches, old, index))
}

/// Are this patch and this old one the only ones of their pair?
#[inline(never)]
fn are_only_ones(patches: &[Patch], old: &[PatchMemory], index: usize) -> bool {
    patches[index].number == 0
        && patches.get(index + 1).is_none_or(|patch| patch.number == 0)
        && old.get(index + 1).is_none_or(|memory| memory.patch == 0)
}

/// Takes the old patches of candidates before `key`, and those of the candidate itself, off the sorted `memory`.
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

/// The share of a parent's memory that falls to `patch`, one of its heirs. Area and energies are shared by area: a split
/// is no loss of area to the damper.
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
