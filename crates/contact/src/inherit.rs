//! Which patch of this step goes on with which memory of the last: a contact's memory belongs to
//! the pair of bodies and its patch, and outlives the walk from edge to edge and piece to piece.

use alloc::vec::Vec;
use core::ops::Range;

use crate::events::{note, report_ends_and_splits};
use crate::memory::{Past, PatchMemory, PlaceMemory, place_of};
use crate::model::Model;
use crate::number::greater;
use crate::overlap::{Overlap, Patch, Place};
use crate::report::EventKind;
use crate::workspace::{Candidate, Workspace};

/// What a patch takes over from the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Inherited {
    /// A new contact.
    Nothing,
    /// One patch, as it was: its place in the last step's patches.
    One(u32),
    /// One patch's part that falls to this one, others having the rest: its place in `Workspace::shares`.
    Part(u32),
    /// Several patches that became one: the mean of their shears, weighted by area (the shear is a
    /// displacement, so that it neither adds up nor is lost), and the fastest first touch. Its place in
    /// `Workspace::shares`.
    Merged(u32),
}

impl Inherited {
    /// The memory itself; `old` is what was asked for it, `shares` are those of the workspace.
    #[inline]
    pub(crate) fn of<'m>(
        self,
        old: &'m [PatchMemory],
        shares: &'m [PatchMemory],
    ) -> Option<&'m PatchMemory> {
        match self {
            Inherited::Nothing => None,
            Inherited::One(place) => Some(&old[place as usize]),
            Inherited::Part(place) | Inherited::Merged(place) => Some(&shares[place as usize]),
        }
    }
}

/// For every patch of this step what it inherits of those of the last, in `work.inherited`; and the events of
/// contacts that ended and patches that split. All but the first of both, of which so many as have `gone_on` go on
/// one from the other.
pub(crate) fn inherit_from(
    model: &Model,
    Past { patches: last, places: old_places, .. }: Past<'_>,
    work: &mut Workspace,
    gone_on: usize,
) {
    work.inherited.clear();
    work.shares.clear();
    let mut old = &last[gone_on..];
    let Range { start, end } = work.own_patches;
    let mut from = start + gone_on;
    while from < end {
        if !work.jumps {
            let patches = &work.found.patches[from..end];
            let pairs = patches.iter().zip(old).enumerate();
            let count = pairs.take_while(|&(i, pair)| goes_on(pair, patches, old, i)).count();
            let place = (last.len() - old.len()) as u32;
            work.inherited.extend((place..place + count as u32).map(Inherited::One));
            (from, old) = (from + count, &old[count..]);
            if from == end {
                break;
            }
        }
        let Patch { candidate, of, .. } = work.found.patches[from];
        let Candidate { a, b, .. } = candidate;
        let key = candidate.key();
        let jumped = work.jumped(a, b);
        let of_pair = |p: &&Patch| p.of == of;
        let to = from + work.found.patches[from..end].iter().take_while(of_pair).count();
        let (ended, mut own) = patches_of(&mut old, key);
        ended.iter().for_each(|m| note(model, &mut work.events, m.a, m.b, EventKind::ContactEnded));
        if jumped {
            own.iter().for_each(|_| note(model, &mut work.events, a, b, EventKind::ContactEnded));
            own = &[];
        }
        report_ends_and_splits(model, work, (own, old_places), from, to);
        let Workspace { found: Overlap { patches, places, .. }, inherited, shares, .. } =
            &mut *work;
        let patches = &patches[from..to];
        inherited.extend(patches.iter().map(|patch| match own {
            [] => Inherited::Nothing,
            // The patches that are left come after this one, and nothing else does.
            [_] if patches.len() == 1 => Inherited::One((last.len() - old.len() - 1) as u32),
            _ => inherit_of_several((own, old_places), patches, patch, places, shares),
        }));
        from = to;
    }
    old.iter().for_each(|m| note(model, &mut work.events, m.a, m.b, EventKind::ContactEnded));
}

/// Does a patch go on from an old one, each number `index` of these, as its pair's only one? Most do.
#[inline(always)]
pub(crate) fn goes_on(
    (patch, memory): (&Patch, &PatchMemory),
    patches: &[Patch],
    old: &[PatchMemory],
    index: usize,
) -> bool {
    let (a, b, face) = patch.candidate.key();
    // Of two convex bodies there is only one.
    memory.key() == (a, b, face, 0)
        && (patch.place().is_none() || are_only_ones(patches, old, index))
}

/// Are these two, of one pair, its only ones: the old one, its first, and the patch?
#[inline(never)]
fn are_only_ones(patches: &[Patch], old: &[PatchMemory], index: usize) -> bool {
    patches[index].number == 0
        && patches.get(index + 1).is_none_or(|patch| patch.number == 0)
        && old.get(index + 1).is_none_or(|memory| memory.patch == 0)
}

/// The last step's patches of candidates before `key`, and those of the candidate itself; `memory` is sorted,
/// and moves on to what comes after.
#[inline]
fn patches_of<'a>(
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

/// What `patch`, one of `patches` of its pair, inherits from `old`.
fn inherit_of_several(
    (old, old_places): (&[PatchMemory], &[PlaceMemory]),
    patches: &[Patch],
    patch: &Patch,
    places: &[Place],
    shares: &mut Vec<PatchMemory>,
) -> Inherited {
    let mut parents = old
        .iter()
        .map(|m| (m, place_of(m, old_places)))
        .filter(|&(_, place)| continues(place, patch, places))
        .map(|old| share_of(old, patches, patch, places));
    let Some(first) = parents.next() else { return Inherited::Nothing };
    let mut merged = first;
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
    let place = shares.len() as u32;
    shares.push(merged);
    if several { Inherited::Merged(place) } else { Inherited::Part(place) }
}

/// The memory of one parent, with the part of its area that falls to `patch` among all that
/// continue its `place`: what an overlap loses by parting is no loss of area to the damper. Energy parts likewise.
fn share_of(
    (parent, place): (&PatchMemory, Option<Place>),
    patches: &[Patch],
    patch: &Patch,
    places: &[Place],
) -> PatchMemory {
    let heirs = patches.iter().filter(|p| continues(place, p, places));
    let heirs_m2: f64 = heirs.map(|p| p.area_m2).sum();
    let share = patch.area_m2 / heirs_m2;
    PatchMemory {
        area_m2: parent.area_m2 * share,
        taken_j: parent.taken_j * share,
        sheared_j: parent.sheared_j * share,
        damped_m2: parent.damped_m2 * share,
        tops_j: parent.tops_j.map(|top_j| top_j * share),
        ..*parent
    }
}

/// Does the patch lie where the `old` one lay, as one of the two bodies sees it? A contact that slides
/// stays in place on at least one of them. Of two convex bodies there is one patch, which is the same.
pub(crate) fn continues(old: Option<Place>, patch: &Patch, places: &[Place]) -> bool {
    let (Some(old), Some(place)) = (old, patch.place()) else { return true };
    let Place { in_a, in_b } = places[place as usize];
    old.in_a.overlaps(&in_a) || old.in_b.overlaps(&in_b)
}
