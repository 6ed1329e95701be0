//! Which patch of this step goes on with which memory of the last: a contact's memory belongs to
//! the pair of bodies and its patch, and outlives the walk from edge to edge and piece to piece.

use crate::memory::PatchMemory;
use crate::overlap::Patch;

/// What a patch takes over from the last step.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Inherited {
    /// A new contact.
    Nothing,
    /// One patch, as it was.
    One(PatchMemory),
    /// Several patches that became one: the mean of their shears, weighted by area (the shear is a
    /// displacement, so that it neither adds up nor is lost), and the fastest first touch.
    Merged(PatchMemory),
}

impl Inherited {
    pub(crate) fn memory(&self) -> Option<&PatchMemory> {
        match self {
            Inherited::Nothing => None,
            Inherited::One(memory) | Inherited::Merged(memory) => Some(memory),
        }
    }
}

/// The last step's patches of the pair `(a, b)`; `memory` is sorted, and what comes before is done.
#[inline]
pub(crate) fn patches_of<'a>(
    memory: &mut &'a [PatchMemory],
    a: u32,
    b: u32,
) -> (&'a [PatchMemory], &'a [PatchMemory]) {
    let skipped = memory.iter().take_while(|m| (m.a, m.b) < (a, b)).count();
    let (before, rest) = memory.split_at(skipped);
    let own = rest.iter().take_while(|m| (m.a, m.b) == (a, b)).count();
    let (own, rest) = rest.split_at(own);
    *memory = rest;
    (before, own)
}

/// What `patch`, one of `patches` of its pair, inherits from `old`.
#[inline]
pub(crate) fn inherit(old: &[PatchMemory], patches: &[Patch], patch: &Patch) -> Inherited {
    match old {
        [] => Inherited::Nothing,
        [only] if patches.len() == 1 => Inherited::One(*only),
        _ => inherit_of_several(old, patch),
    }
}

fn inherit_of_several(old: &[PatchMemory], patch: &Patch) -> Inherited {
    let mut parents = old.iter().filter(|m| continues(m, patch));
    let Some(first) = parents.next() else { return Inherited::Nothing };
    let mut merged = *first;
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
        merged.v_normal_0_mps = merged.v_normal_0_mps.max(parent.v_normal_0_mps);
        if parent.v_tangential_0_mps.abs() > merged.v_tangential_0_mps.abs() {
            merged.v_tangential_0_mps = parent.v_tangential_0_mps;
        }
        merged.flags |= parent.flags;
    }
    if several { Inherited::Merged(merged) } else { Inherited::One(merged) }
}

/// Does the patch lie where the old one lay, as one of the two bodies sees it? A contact that slides
/// stays in place on at least one of them.
pub(crate) fn continues(old: &PatchMemory, patch: &Patch) -> bool {
    old.extent_in_a.overlaps(&patch.extent_in_a) || old.extent_in_b.overlaps(&patch.extent_in_b)
}
