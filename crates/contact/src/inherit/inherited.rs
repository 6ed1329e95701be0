//! What a patch of contact inherits from the memory of the last step.

use crate::state::memory::PatchMemory;

/// What a patch of contact inherits from the memory of the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Inherited {
    /// Nothing: a new contact.
    Nothing,
    /// One old patch, unchanged. The number is the place of the old patch in the list of the last step's patches.
    One(u32),
    /// The patch inherits a share of one old patch that has split. The number is the place of the inherited memory in
    /// `Inheritance::shares`.
    Part(u32),
    /// The patch continues several old patches that have merged: it inherits their mean shear, weighted by area, and
    /// the largest speed at first touch. The shear of merged patches is averaged because it is a displacement: it
    /// neither adds up nor is lost. The number is the place of the inherited memory in `Inheritance::shares`.
    Merged(u32),
}

impl Inherited {
    /// Returns the inherited memory; `old` are the patches of the last step.
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
