//! The memory that a patch inherits from the last step.

use crate::memory::PatchMemory;

/// The memory that a patch inherits from the last step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Inherited {
    /// Nothing: a new contact.
    Nothing,
    /// One old patch, unchanged. The number is its place in the last step's patches.
    One(u32),
    /// A share of one old patch that has split. The number is the place in `Inheritance::shares`.
    Part(u32),
    /// Several old patches that have merged: their mean shear, weighted by area, and the largest speed at first touch.
    /// The shear is a displacement: it neither adds up nor is lost. The number is the place in `Inheritance::shares`.
    Merged(u32),
}

impl Inherited {
    /// The inherited memory; `old` are the last step's patches.
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
