//! The memory that a step writes for the next one.

use alloc::vec::Vec;

use crate::memory::{HintMemory, Memory, PatchMemory, PlaceMemory};

/// Written by stages 3 to 6; becomes part of the [`Memory`] when the step is done.
#[derive(Clone, Debug, Default)]
pub(crate) struct NextMemory {
    pub(crate) patches: Vec<PatchMemory>,
    pub(crate) places: Vec<PlaceMemory>,
    pub(crate) hints: Vec<HintMemory>,
}

impl NextMemory {
    pub(crate) fn clear(&mut self) {
        self.patches.clear();
        self.places.clear();
        self.hints.clear();
    }

    pub(crate) fn sort(&mut self) {
        self.patches.sort_unstable_by_key(PatchMemory::key);
        self.places.sort_unstable_by_key(PlaceMemory::key);
        self.hints.sort_unstable_by_key(HintMemory::key);
    }

    /// Exchanges its lists with those of the memory; `keeps_hints` if the memory's hints stay as they are.
    pub(crate) fn exchange(&mut self, memory: &mut Memory, keeps_hints: bool) {
        core::mem::swap(&mut memory.patches, &mut self.patches);
        core::mem::swap(&mut memory.places, &mut self.places);
        if !keeps_hints {
            core::mem::swap(&mut memory.hints, &mut self.hints);
        }
    }
}
