//! Islands: bodies that may touch each other in this step, however indirectly. Each is solved apart,
//! in sub-steps of its own. Fixed bodies join nothing.

use crate::memory::Memory;
use crate::model::Model;
use crate::workspace::{Candidate, Workspace};

/// A range of `Workspace::all_candidates`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Island {
    pub(crate) from: u32,
    pub(crate) to: u32,
}

/// Splits the candidates into islands, in the order of their first candidates.
pub(crate) fn split(model: &Model, work: &mut Workspace) {
    work.islands.clear();
    work.in_island.clear();
    work.in_island.resize(model.ranked.len(), false);
    core::mem::swap(&mut work.all_candidates, &mut work.candidates);
    if work.all_candidates.is_empty() {
        return;
    }
    let root = &mut work.island_root;
    root.clear();
    root.extend(0..model.ranked.len() as u32);
    for candidate in &work.all_candidates {
        let [a, b] = [candidate.a, candidate.b];
        if !model.ranked[a as usize].is_fixed() && !model.ranked[b as usize].is_fixed() {
            let (one, two) = (find(root, a), find(root, b));
            root[one.max(two) as usize] = one.min(two);
        }
    }
    // By island; the candidates' own order within.
    let key = |candidate: &Candidate, root: &mut [u32]| {
        let free =
            if model.ranked[candidate.a as usize].is_fixed() { candidate.b } else { candidate.a };
        (find(root, free), candidate.a, candidate.b, candidate.face)
    };
    let sorted = {
        let mut last = (0, 0, 0, 0);
        work.all_candidates.iter().all(|c| {
            let this = key(c, root);
            let in_order = last <= this;
            last = this;
            in_order
        })
    };
    if !sorted {
        work.all_candidates.sort_unstable_by_key(|c| key(c, root));
    }
    let mut from = 0;
    while from < work.all_candidates.len() {
        let (island, ..) = key(&work.all_candidates[from], root);
        let mut to = from + 1;
        while to < work.all_candidates.len() && key(&work.all_candidates[to], root).0 == island {
            to += 1;
        }
        work.islands.push(Island { from: from as u32, to: to as u32 });
        from = to;
    }
}

fn find(root: &mut [u32], mut i: u32) -> u32 {
    while root[i as usize] != i {
        root[i as usize] = root[root[i as usize] as usize];
        i = root[i as usize];
    }
    i
}

/// Makes island `index` the one that the stages work on.
pub(crate) fn enter(memory: &Memory, work: &mut Workspace, index: usize) {
    let Island { from, to } = work.islands[index];
    let candidates = &work.all_candidates[from as usize..to as usize];
    work.candidates.clear();
    work.candidates.extend_from_slice(candidates);
    work.first_contact = work.contacts.len();
    work.island_bodies.clear();
    for candidate in candidates {
        for rank in [candidate.a, candidate.b] {
            if !work.in_island[rank as usize] {
                work.in_island[rank as usize] = true;
                work.island_bodies.push(rank);
            }
        }
    }
    work.island_bodies.sort_unstable();
    let own = &mut work.island_memory;
    own.fingerprint = memory.fingerprint;
    own.last_step_s = memory.last_step_s;
    own.patches.clear();
    own.hints.clear();
    if work.islands.len() == 1 {
        own.patches.extend_from_slice(&memory.patches);
        own.hints.extend_from_slice(&memory.hints);
        return;
    }
    for candidate in candidates {
        let key = candidate.key();
        let at = memory.patches.partition_point(|m| m.candidate() < key);
        own.patches.extend(memory.patches[at..].iter().take_while(|m| m.candidate() == key));
        let at = memory.hints.partition_point(|m| m.candidate() < key);
        own.hints.extend(memory.hints[at..].iter().take_while(|m| m.candidate() == key));
    }
}

/// Puts the island's memory with the others'.
pub(crate) fn leave(model: &Model, work: &mut Workspace) {
    // A fixed body may stand in several islands.
    for &rank in &work.island_bodies {
        if model.ranked[rank as usize].is_fixed() {
            work.in_island[rank as usize] = false;
        }
    }
    work.all_patches.extend_from_slice(&work.island_memory.patches);
    work.all_hints.extend_from_slice(&work.island_memory.hints);
}
