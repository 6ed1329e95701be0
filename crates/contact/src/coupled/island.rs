//! Islands: bodies that may touch each other in this step, however indirectly. Each is solved apart,
//! in sub-steps of its own. Fixed bodies join nothing.

use alloc::vec::Vec;
use core::ops::Range;

use crate::memory::{HintMemory, Memory, Past, PatchMemory};
use crate::model::Model;
use crate::workspace::{Candidate, Workspace};

/// A range of `Workspace::candidates`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Island {
    pub(crate) from: u32,
    pub(crate) to: u32,
}

/// What an island's last sub-step left, or what the last step did where that does not stand together in
/// the memory.
#[derive(Clone, Debug, Default)]
pub(crate) struct IslandMemory {
    patches: Vec<PatchMemory>,
    hints: Vec<HintMemory>,
}

impl IslandMemory {
    pub(crate) fn past(&self, last_step_s: f64) -> Past<'_> {
        Past { patches: &self.patches, hints: &self.hints, last_step_s }
    }

    /// Takes what the island's last sub-step left off what goes on to the next step.
    pub(crate) fn take(&mut self, work: &mut Workspace) {
        self.patches.clear();
        self.patches.extend(work.next_patches.drain(work.first_patch..));
        self.hints.clear();
        self.hints.extend(work.next_hints.drain(work.first_hint..));
    }
}

/// Splits the candidates into islands, in the order of their first candidates.
pub(crate) fn split(model: &Model, work: &mut Workspace) {
    work.islands.clear();
    (work.read_patches, work.read_hints) = (0, 0);
    work.in_island.clear();
    work.in_island.resize(model.ranked.len(), false);
    work.in_order = true;
    if work.candidates.is_empty() {
        return;
    }
    let root = &mut work.island_root;
    root.clear();
    root.extend(0..model.ranked.len() as u32);
    for candidate in &work.candidates {
        let [a, b] = [candidate.a, candidate.b];
        if !model.ranked[a as usize].is_fixed() && !model.ranked[b as usize].is_fixed() {
            let (one, two) = (find(root, a), find(root, b));
            root[one.max(two) as usize] = one.min(two);
        }
    }
    let island_of = |candidate: &Candidate, root: &mut [u32]| {
        let free =
            if model.ranked[candidate.a as usize].is_fixed() { candidate.b } else { candidate.a };
        find(root, free)
    };
    // By island; the candidates' own order within.
    let mut last = 0;
    let together = work.candidates.iter().all(|c| {
        let this = island_of(c, root);
        let in_order = last <= this;
        last = this;
        in_order
    });
    if !together {
        work.candidates.sort_unstable_by_key(|c| (island_of(c, root), c.key()));
        work.in_order = false;
    }
    let mut from = 0;
    let mut island = island_of(&work.candidates[0], root);
    for to in 1..work.candidates.len() {
        let next = island_of(&work.candidates[to], root);
        if next != island {
            work.islands.push(Island { from: from as u32, to: to as u32 });
            (from, island) = (to, next);
        }
    }
    work.islands.push(Island { from: from as u32, to: work.candidates.len() as u32 });
}

fn find(root: &mut [u32], mut i: u32) -> u32 {
    while root[i as usize] != i {
        root[i as usize] = root[root[i as usize] as usize];
        i = root[i as usize];
    }
    i
}

/// Makes island `index` the one that the stages work on.
pub(crate) fn enter(model: &Model, work: &mut Workspace, index: usize) {
    let Island { from, to } = work.islands[index];
    work.own_candidates = from as usize..to as usize;
    work.first_patch = work.next_patches.len();
    work.first_hint = work.next_hints.len();
    work.first_contact = work.contacts.len();
    let Workspace { candidates, states, in_island, island_bodies, .. } = work;
    island_bodies.clear();
    for candidate in &candidates[from as usize..to as usize] {
        for rank in [candidate.a, candidate.b] {
            let place = rank as usize;
            if !in_island[place] && !(model.ranked[place].is_fixed() && states[place].is_at_rest())
            {
                in_island[place] = true;
                island_bodies.push(rank);
            }
        }
    }
    if island_bodies.len() > 1 {
        island_bodies.sort_unstable();
    }
}

/// Where an island's part of the memory begins and ends.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    patches: Range<usize>,
    hints: Range<usize>,
}

impl Part {
    pub(crate) fn past<'m>(&self, memory: &'m Memory) -> Past<'m> {
        Past {
            patches: &memory.patches[self.patches.clone()],
            hints: &memory.hints[self.hints.clone()],
            last_step_s: memory.last_step_s,
        }
    }
}

/// The island's part of the memory, where it stands together there; else `None`, and it is copied to `own`.
pub(crate) fn part_of(
    memory: &Memory,
    work: &mut Workspace,
    own: &mut IslandMemory,
) -> Option<Part> {
    let Workspace { candidates, own_candidates, islands, read_patches, read_hints, .. } = work;
    if islands.len() == 1 {
        return Some(Part { patches: 0..memory.patches.len(), hints: 0..memory.hints.len() });
    }
    if own_candidates.len() == 1 {
        let key = candidates[own_candidates.start].key();
        return Some(Part {
            patches: run_of(&memory.patches, read_patches, key, PatchMemory::candidate),
            hints: run_of(&memory.hints, read_hints, key, HintMemory::candidate),
        });
    }
    own.patches.clear();
    own.hints.clear();
    for candidate in &candidates[own_candidates.clone()] {
        let key = candidate.key();
        let run = run_of(&memory.patches, read_patches, key, PatchMemory::candidate);
        own.patches.extend_from_slice(&memory.patches[run]);
        let run = run_of(&memory.hints, read_hints, key, HintMemory::candidate);
        own.hints.extend_from_slice(&memory.hints[run]);
    }
    None
}

/// The items of one candidate in a sorted list. `read` is where the last run ended and mostly where the
/// next one begins.
fn run_of<T>(
    sorted: &[T],
    read: &mut usize,
    key: (u32, u32, u32),
    key_of: fn(&T) -> (u32, u32, u32),
) -> Range<usize> {
    let is_own = |item: &T| key_of(item) == key;
    let at = (*read).min(sorted.len());
    let after_another = at == 0 || !is_own(&sorted[at - 1]);
    let from = match sorted.get(at) {
        Some(item) if is_own(item) && after_another => at,
        _ => sorted.partition_point(|item| key_of(item) < key),
    };
    let count = sorted[from..].iter().take_while(|item| is_own(item)).count();
    *read = from + count;
    from..from + count
}

/// What is fixed and moves may stand in several islands.
pub(crate) fn leave(model: &Model, work: &mut Workspace) {
    for &rank in &work.island_bodies {
        if model.ranked[rank as usize].is_fixed() {
            work.in_island[rank as usize] = false;
        }
    }
}
