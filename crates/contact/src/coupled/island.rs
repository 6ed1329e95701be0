//! Islands: bodies that may touch each other in this step, however indirectly. Each is solved apart,
//! in sub-steps of its own. Fixed bodies join nothing.

use alloc::vec::Vec;
use core::ops::Range;

use crate::coupled::pace;
use crate::memory::{HintMemory, Memory, Past, PatchMemory};
use crate::model::Model;
use crate::overlap::Patch;
use crate::report::Motion;
use crate::workspace::{Candidate, Workspace};

/// Bodies that may touch each other: a range of `Workspace::candidates`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Island {
    pub(crate) candidates: Range<usize>,
    /// Its patches in the first overlap of the step.
    pub(crate) patches: Range<usize>,
    /// How many sub-steps it needs.
    pub(crate) sub_steps: u32,
}

/// What islands left of the last (sub-)step.
#[derive(Clone, Debug, Default)]
pub(crate) struct IslandMemory {
    patches: Vec<PatchMemory>,
    pub(crate) hints: Vec<HintMemory>,
}

impl IslandMemory {
    pub(crate) fn past(&self, last_step_s: f64) -> Past<'_> {
        Past { patches: &self.patches, hints: &self.hints, last_step_s }
    }

    /// Takes what the islands' first sub-step left off what goes on to the next step; `hints` are those of its
    /// overlap.
    pub(crate) fn take_first(&mut self, work: &mut Workspace, hints: &[HintMemory]) {
        self.patches.clear();
        self.patches.extend(work.next_patches.drain(work.first_patch..));
        self.hints.clear();
        self.hints.extend_from_slice(hints);
    }

    /// The same of a later sub-step, which left its hints there too.
    pub(crate) fn take(&mut self, work: &mut Workspace) {
        self.patches.clear();
        self.patches.extend(work.next_patches.drain(work.first_patch..));
        self.hints.clear();
        self.hints.extend(work.next_hints.drain(work.first_hint..));
    }

    /// Gathers what the last step left of an island.
    pub(crate) fn gather(&mut self, memory: &Memory, candidates: &[Candidate]) {
        self.patches.clear();
        self.hints.clear();
        for candidate in candidates {
            let key = candidate.key();
            self.patches.extend(run_of(&memory.patches, key, PatchMemory::candidate));
            self.hints.extend(run_of(&memory.hints, key, HintMemory::candidate));
        }
    }
}

/// The items of one candidate in a sorted list.
fn run_of<T: Copy>(
    sorted: &[T],
    key: (u32, u32, u32),
    key_of: fn(&T) -> (u32, u32, u32),
) -> impl Iterator<Item = T> {
    let from = sorted.partition_point(|item| key_of(item) < key);
    sorted[from..].iter().copied().take_while(move |item| key_of(item) == key)
}

/// Splits the candidates into islands, in the order of their first candidates.
pub(crate) fn split(model: &Model, work: &mut Workspace) {
    work.islands.clear();
    work.in_island.clear();
    work.in_island.resize(model.ranked.len(), false);
    work.in_order = true;
    if work.candidates.is_empty() {
        return;
    }
    let root = &mut work.island_root;
    root.clear();
    root.extend(0..model.ranked.len() as u32);
    for candidate in &mut work.candidates {
        let [a, b] = [candidate.a, candidate.b];
        let fixed = [a, b].map(|rank| model.ranked[rank as usize].is_fixed());
        candidate.island = if fixed[0] { b } else { a };
        if !fixed[0] && !fixed[1] {
            let (one, two) = (find(root, a), find(root, b));
            root[one.max(two) as usize] = one.min(two);
        }
    }
    // By island; the candidates' own order within.
    let mut last = 0;
    for candidate in &mut work.candidates {
        candidate.island = find(root, candidate.island);
        work.in_order &= last <= candidate.island;
        last = candidate.island;
    }
    if !work.in_order {
        work.candidates.sort_unstable_by_key(|c| (c.island, c.key()));
    }
    let mut from = 0;
    let mut last = work.candidates[0].island;
    for (index, candidate) in work.candidates.iter().enumerate() {
        if candidate.island != last {
            work.islands.push(Island::of(from..index));
            (from, last) = (index, candidate.island);
        }
    }
    work.islands.push(Island::of(from..work.candidates.len()));
}

impl Island {
    fn of(candidates: Range<usize>) -> Island {
        Island { candidates, patches: 0..0, sub_steps: 0 }
    }
}

fn find(root: &mut [u32], mut i: u32) -> u32 {
    while root[i as usize] != i {
        root[i as usize] = root[root[i as usize] as usize];
        i = root[i as usize];
    }
    i
}

/// Each island's patches of the first overlap, which left `hints`, and how many sub-steps it needs.
pub(crate) fn set_paces(
    model: &Model,
    work: &Workspace,
    islands: &mut [Island],
    hints: &[HintMemory],
    step_s: f64,
) {
    let mut from = 0;
    for island in islands {
        let candidates = island.candidates.clone();
        let own = |patch: &&Patch| (patch.of as usize) < candidates.end;
        let to = from + work.found.patches[from..].iter().take_while(own).count();
        island.patches = from..to;
        let patches = &work.found.patches[from..to];
        island.sub_steps = pace::sub_steps(model, work, candidates, patches, hints, step_s);
        from = to;
    }
}

/// Makes these islands the ones that the stages work on.
pub(crate) fn enter(work: &mut Workspace, islands: &[Island]) {
    let ([first, ..], [.., last]) = (islands, islands) else { return };
    work.own_candidates = first.candidates.start..last.candidates.end;
    work.own_patches = first.patches.start..last.patches.end;
    work.first_patch = work.next_patches.len();
    work.first_hint = work.next_hints.len();
    work.first_contact = work.contacts.len();
    let Workspace { candidates, own_candidates, moves, in_island, island_bodies, .. } = work;
    island_bodies.clear();
    for candidate in &candidates[own_candidates.clone()] {
        for rank in [candidate.a, candidate.b] {
            let place = rank as usize;
            if moves[place] && !in_island[place] {
                in_island[place] = true;
                island_bodies.push(rank);
            }
        }
    }
    if island_bodies.len() > 1 {
        island_bodies.sort_unstable();
    }
    put_walls_back(work);
}

/// What is fixed and moves goes through the step with each group of islands: from where it was shown.
fn put_walls_back(work: &mut Workspace) {
    let Workspace { moving_walls, in_island, states, poses, headings_rad, motions_by_rank, .. } =
        work;
    for &(rank, shown) in &*moving_walls {
        let rank = rank as usize;
        if in_island[rank] {
            states[rank] = shown;
            poses[rank] = shown.pose();
            headings_rad[rank] = shown.heading_rad;
            motions_by_rank[rank] = Motion::default();
        }
    }
}

/// What is fixed and moves may stand in several islands.
pub(crate) fn leave(model: &Model, work: &mut Workspace) {
    for &rank in &work.island_bodies {
        if model.ranked[rank as usize].is_fixed() {
            work.in_island[rank as usize] = false;
        }
    }
}
