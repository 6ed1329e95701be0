//! Islands: bodies that may touch each other in this step, however indirectly. Each is solved apart,
//! in sub-steps of its own. Fixed bodies join nothing.

use alloc::vec::Vec;
use core::ops::Range;

use crate::memory::{HintMemory, Memory, Past, PatchMemory, PlaceMemory};
use crate::model::Model;
use crate::overlap::Patch;
use crate::pairing::JOINED;
use crate::workspace::{Pairing, Workspace};

/// Bodies that may touch each other: a range of `Workspace::candidates`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Island {
    candidates: Range<u32>,
    /// Its patches in the overlap of its sub-step.
    patches: Range<u32>,
    /// How many sub-steps it needs.
    pub(crate) sub_steps: u32,
}

/// What islands left of the last (sub-)step.
#[derive(Clone, Debug, Default)]
pub(crate) struct IslandMemory {
    patches: Vec<PatchMemory>,
    places: Vec<PlaceMemory>,
    pub(crate) hints: Vec<HintMemory>,
}

impl IslandMemory {
    pub(crate) fn past(&self, last_step_s: f64) -> Past<'_> {
        let IslandMemory { patches, places, hints } = self;
        Past { patches, places, hints, last_step_s }
    }

    /// Takes what the islands' first sub-step left off what goes on to the next step; `hints` are those of its
    /// overlap.
    pub(crate) fn take_first(&mut self, work: &mut Workspace, hints: &[HintMemory]) {
        self.take_patches(work);
        self.hints.clear();
        self.hints.extend_from_slice(hints);
    }

    /// The same of a later sub-step, which left its hints there too.
    pub(crate) fn take(&mut self, work: &mut Workspace) {
        self.take_patches(work);
        self.hints.clear();
        self.hints.extend(work.next_hints.drain(work.first_hint..));
    }

    /// The patches of that, and where they lay.
    fn take_patches(&mut self, work: &mut Workspace) {
        self.patches.clear();
        self.patches.extend(work.next_patches.drain(work.first_patch..));
        self.places.clear();
        self.places.extend(work.next_places.drain(work.first_place..));
    }

    /// Gathers what the last step left of an island.
    pub(crate) fn gather(&mut self, memory: &Memory, candidates: &[Pairing]) {
        self.patches.clear();
        self.places.clear();
        self.hints.clear();
        for pairing in candidates {
            let key = pairing.candidate.key();
            self.patches.extend(run_of(&memory.patches, key, PatchMemory::candidate));
            self.places.extend(run_of(&memory.places, key, PlaceMemory::candidate));
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
    let mut order = part(&work.candidates, &mut work.islands);
    work.joined = order == Order::Unknown;
    if work.joined {
        join(model, work);
        order = part(&work.candidates, &mut work.islands);
    }
    work.in_order = order == Order::Ranked;
    if !work.in_order {
        // By island; the candidates' own order within.
        work.candidates.sort_unstable_by_key(|p| (p.island, p.candidate.key()));
        part(&work.candidates, &mut work.islands);
    }
    work.all_meet =
        !work.joined && work.moving_walls.is_empty() && work.islands.len() == work.active.len();
    if !work.all_meet {
        work.in_island.clear();
        work.in_island.resize(model.ranked.len(), false);
    }
}

/// How islands come in the list of the candidates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    /// In the order of their bodies' ranks.
    Ranked,
    Mixed,
    /// It is not known yet of some candidates which island they belong to.
    Unknown,
}

/// Parts candidates where one island ends and the next begins.
#[inline(never)]
fn part(candidates: &[Pairing], islands: &mut Vec<Island>) -> Order {
    islands.clear();
    let Some(first) = candidates.first() else { return Order::Ranked };
    if first.island == JOINED {
        return Order::Unknown;
    }
    let (mut from, mut last, mut in_order) = (0, first.island, true);
    for (index, pairing) in (0..).zip(candidates) {
        if pairing.island != last {
            if pairing.island == JOINED {
                return Order::Unknown;
            }
            islands.push(Island::of(from..index));
            in_order &= last < pairing.island;
            (from, last) = (index, pairing.island);
        }
    }
    islands.push(Island::of(from..candidates.len() as u32));
    if in_order { Order::Ranked } else { Order::Mixed }
}

/// Finds the islands where bodies that float may touch each other: each goes by the lowest rank of them.
fn join(model: &Model, work: &mut Workspace) {
    let root = &mut work.island_root;
    root.clear();
    root.extend(0..model.ranked.len() as u32);
    for Pairing { candidate, island, .. } in &work.candidates {
        if *island == JOINED {
            let (one, two) = (find(root, candidate.a), find(root, candidate.b));
            root[one.max(two) as usize] = one.min(two);
        }
    }
    for Pairing { candidate, island, .. } in &mut work.candidates {
        *island = find(root, if *island == JOINED { candidate.a } else { *island });
    }
}

impl Island {
    fn of(candidates: Range<u32>) -> Island {
        Island { candidates, patches: 0..0, sub_steps: 0 }
    }

    /// Its place in `Workspace::candidates`.
    #[inline(always)]
    pub(crate) fn candidates(&self) -> Range<usize> {
        self.candidates.start as usize..self.candidates.end as usize
    }

    /// Its patches in the first overlap of the step are these, and it needs so many sub-steps.
    #[inline(always)]
    pub(crate) fn go(&mut self, patches: Range<usize>, sub_steps: u32) {
        (self.patches, self.sub_steps) = (patches.start as u32..patches.end as u32, sub_steps);
    }

    /// Its patches in the overlap of its sub-step, counted from this one.
    #[inline(always)]
    pub(crate) fn patches_from(&self, first: usize) -> Range<usize> {
        self.patches.start as usize - first..self.patches.end as usize - first
    }
}

fn find(root: &mut [u32], mut i: u32) -> u32 {
    while root[i as usize] != i {
        root[i as usize] = root[root[i as usize] as usize];
        i = root[i as usize];
    }
    i
}

/// Makes these islands the ones that the stages work on.
pub(crate) fn enter(work: &mut Workspace, islands: &[Island]) {
    let ([first, ..], [.., last]) = (islands, islands) else { return };
    let candidates = first.candidates().start..last.candidates().end;
    work.own_candidates = candidates.clone();
    work.own_patches = first.patches.start as usize..last.patches.end as usize;
    work.first_patch = work.next_patches.len();
    work.first_place = work.next_places.len();
    work.first_hint = work.next_hints.len();
    work.first_contact = work.contacts.len();
    find_bodies(work, islands);
    put_walls_back(work, candidates);
}

/// Tells islands which of the patches are theirs, after an overlap of theirs alone.
pub(crate) fn tell_of_patches(islands: &mut [Island], patches: &[Patch]) {
    let mut from = 0;
    for island in islands {
        let own = patches[from..].iter().take_while(|patch| patch.of < island.candidates.end);
        let to = from + own.count();
        island.go(from..to, island.sub_steps);
        from = to;
    }
}

/// Lists the bodies that move and are in these islands.
fn find_bodies(work: &mut Workspace, islands: &[Island]) {
    if work.joined || !work.moving_walls.is_empty() {
        return find_among_candidates(work);
    }
    // Each has one, by which it goes, and they are in the order of these.
    let Workspace { candidates, in_island, island_bodies, active, .. } = work;
    island_bodies.clear();
    if work.all_meet && islands.len() == active.len() {
        return island_bodies.extend_from_slice(active);
    }
    island_bodies.extend(islands.iter().map(|of| candidates[of.candidates().start].island));
    if !work.all_meet {
        island_bodies.iter().for_each(|&rank| in_island[rank as usize] = true);
    }
}

/// The same where several that float are in one island, or what is fixed moves too.
#[inline(never)]
fn find_among_candidates(work: &mut Workspace) {
    let Workspace { candidates, own_candidates, moves, in_island, island_bodies, .. } = work;
    // Of one length, so that it is asked for once.
    let in_island = in_island.as_mut_slice();
    let moves = &moves[..in_island.len()];
    island_bodies.clear();
    let (mut last, mut in_order) = (0, true);
    for Pairing { candidate, .. } in &candidates[own_candidates.clone()] {
        for rank in [candidate.a, candidate.b] {
            let place = rank as usize;
            if moves[place] && !in_island[place] {
                in_island[place] = true;
                island_bodies.push(rank);
                in_order &= last <= rank;
                last = rank;
            }
        }
    }
    if !in_order {
        island_bodies.sort_unstable();
    }
}

/// What is fixed and moves goes through the step with each group of islands: from where it was shown.
pub(crate) fn put_walls_back(work: &mut Workspace, candidates: Range<usize>) {
    if work.moving_walls.is_empty() {
        return;
    }
    let own = &work.candidates[candidates];
    for &(rank, shown) in &work.moving_walls {
        if own.iter().any(|Pairing { candidate, .. }| [candidate.a, candidate.b].contains(&rank)) {
            let rank = rank as usize;
            work.poses[rank] = shown.pose();
            work.headings_rad[rank] = shown.heading_rad;
        }
    }
}

/// What is fixed and moves may stand in several islands: where it came to with these.
pub(crate) fn leave(model: &Model, work: &mut Workspace) {
    if work.moving_walls.is_empty() {
        return;
    }
    for &rank in &work.island_bodies {
        let rank = rank as usize;
        if model.ranked[rank].is_fixed() {
            let id = model.id_of[rank].0 as usize;
            work.in_island[rank] = false;
            work.states[rank] = work.states_after[id];
            work.motions_by_rank[rank] = work.motions[id];
        }
    }
}
