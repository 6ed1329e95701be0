//! Islands: bodies that may touch each other in this step, however indirectly. Each is solved apart,
//! in sub-steps of its own. Fixed bodies join nothing.

use crate::memory::{HintMemory, Memory, PatchMemory};
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
    (work.read_patches, work.read_hints) = (0, 0);
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
    let Workspace {
        all_candidates,
        candidates,
        contacts,
        first_contact,
        in_island,
        island_bodies,
        island_memory: own,
        islands,
        read_patches,
        read_hints,
        ..
    } = work;
    *first_contact = contacts.len();
    candidates.clear();
    candidates.extend_from_slice(&all_candidates[from as usize..to as usize]);
    island_bodies.clear();
    for candidate in candidates.iter() {
        for rank in [candidate.a, candidate.b] {
            if !in_island[rank as usize] {
                in_island[rank as usize] = true;
                island_bodies.push(rank);
            }
        }
    }
    island_bodies.sort_unstable();
    own.fingerprint = memory.fingerprint;
    own.last_step_s = memory.last_step_s;
    own.patches.clear();
    own.hints.clear();
    if islands.len() == 1 {
        own.patches.extend_from_slice(&memory.patches);
        own.hints.extend_from_slice(&memory.hints);
        return;
    }
    for candidate in candidates.iter() {
        let key = candidate.key();
        let run = run_of(&memory.patches, read_patches, key, PatchMemory::candidate);
        own.patches.extend_from_slice(run);
        let run = run_of(&memory.hints, read_hints, key, HintMemory::candidate);
        own.hints.extend_from_slice(run);
    }
}

/// The items of one candidate in a sorted list. `read` is where the last run ended and mostly where the
/// next one begins.
fn run_of<'m, T>(
    sorted: &'m [T],
    read: &mut usize,
    key: (u32, u32, u32),
    key_of: fn(&T) -> (u32, u32, u32),
) -> &'m [T] {
    let before = |at: usize| at.checked_sub(1).is_none_or(|last| key_of(&sorted[last]) < key);
    let after = |at: usize| sorted.get(at).is_none_or(|item| key_of(item) >= key);
    let from = match *read {
        at if at <= sorted.len() && before(at) && after(at) => at,
        _ => sorted.partition_point(|item| key_of(item) < key),
    };
    let count = sorted[from..].iter().take_while(|item| key_of(item) == key).count();
    *read = from + count;
    &sorted[from..from + count]
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
