//! Islands: bodies that may touch each other in this step, directly or through others. Each island is solved by itself,
//! in sub-steps of its own. Fixed bodies do not connect islands.

use alloc::vec::Vec;
use core::ops::Range;

use crate::bodies::{Displaced, NONE_DISPLACED};
use crate::candidates::Pairing;
use crate::coupled::motion::Motion;
use crate::memory::{HintMemory, Memory, Past, PatchMemory, PlaceMemory};
use crate::model::Model;
use crate::next_memory::NextMemory;
use crate::pair::JOINED;
use crate::patch::Patch;
use crate::results::Results;

/// The islands of a step. Computed by [`Islands::split`].
#[derive(Clone, Debug, Default)]
pub(crate) struct Islands {
    pub(crate) list: Vec<Island>,
    /// The candidates are in the order of their keys, although sorted by island.
    pub(crate) in_order: bool,
    /// Some islands have more than one floating body.
    joined: bool,
    /// A body of each body's island, by rank, while islands are joined.
    root: Vec<u32>,
}

/// Bodies that may touch each other: a range of `Candidates::pairings`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Island {
    candidates: Range<u32>,
    /// Its patches in the overlap of its sub-step.
    patches: Range<u32>,
    pub(crate) sub_steps: u32,
}

/// Neighbouring islands that take the same number of sub-steps and go through them together. Set by [`Group::enter`].
#[derive(Clone, Debug, Default)]
pub(crate) struct Group {
    /// In `Candidates::pairings`.
    pub(crate) candidates: Range<usize>,
    /// In the overlap of the sub-step.
    pub(crate) patches: Range<usize>,
    /// Ranks of its moving bodies, ascending.
    pub(crate) bodies: Vec<u32>,
    /// Where its patches, places and hints begin in the next memory.
    pub(crate) first_patch: usize,
    pub(crate) first_place: usize,
    pub(crate) first_hint: usize,
    /// Where its contacts begin in the results.
    pub(crate) first_contact: usize,
}

/// How islands are ordered in the list of candidates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    /// By their bodies' ranks: the candidates are in the order of their keys.
    Ranked,
    Mixed,
    /// Some candidates' islands are not known yet.
    Unknown,
}

impl Islands {
    /// Splits the candidates into islands, in the order of their first candidates.
    pub(crate) fn split(&mut self, model: &Model, candidates: &mut [Pairing]) {
        let mut order = self.part(candidates);
        self.joined = order == Order::Unknown;
        if self.joined {
            self.join(model, candidates);
            order = self.part(candidates);
        }
        self.in_order = order == Order::Ranked;
        if !self.in_order {
            // By island; within an island in the order of the keys.
            candidates.sort_unstable_by_key(|p| (p.island, p.candidate.key()));
            self.part(candidates);
        }
    }

    /// Parts candidates where one island ends and the next begins.
    #[inline(never)]
    fn part(&mut self, candidates: &[Pairing]) -> Order {
        self.list.clear();
        let Some(first) = candidates.first() else { return Order::Ranked };
        let (mut from, mut last, mut in_order) = (0, first.island, true);
        if last == JOINED {
            return Order::Unknown;
        }
        for (index, pairing) in (0..).zip(candidates) {
            if pairing.island != last {
                if pairing.island == JOINED {
                    return Order::Unknown;
                }
                self.list.push(Island::of(from..index));
                in_order &= last < pairing.island;
                (from, last) = (index, pairing.island);
            }
        }
        self.list.push(Island::of(from..candidates.len() as u32));
        if in_order { Order::Ranked } else { Order::Mixed }
    }

    /// Finds the islands if floating bodies may touch each other (union–find). An island is known by its lowest rank.
    fn join(&mut self, model: &Model, candidates: &mut [Pairing]) {
        let root = &mut self.root;
        root.clear();
        root.extend(0..model.ranked.len() as u32);
        for Pairing { candidate, island, .. } in &*candidates {
            if *island == JOINED {
                let (one, two) = (find(root, candidate.a), find(root, candidate.b));
                root[one.max(two) as usize] = one.min(two);
            }
        }
        for Pairing { candidate, island, .. } in candidates {
            *island = find(root, if *island == JOINED { candidate.a } else { *island });
        }
    }

    /// True if some islands have more than one floating body.
    pub(crate) fn joined(&self) -> bool {
        self.joined
    }
}

fn find(root: &mut [u32], mut i: u32) -> u32 {
    while root[i as usize] != i {
        root[i as usize] = root[root[i as usize] as usize];
        i = root[i as usize];
    }
    i
}

impl Island {
    fn of(candidates: Range<u32>) -> Island {
        Island { candidates, patches: 0..0, sub_steps: 0 }
    }

    /// Its place in `Candidates::pairings`.
    #[inline(always)]
    pub(crate) fn candidates(&self) -> Range<usize> {
        self.candidates.start as usize..self.candidates.end as usize
    }

    #[inline(always)]
    pub(crate) fn set_patches(&mut self, patches: Range<usize>) {
        self.patches = patches.start as u32..patches.end as u32;
    }

    /// Its patches in the overlap of its sub-step, counted from patch number `first`.
    #[inline(always)]
    pub(crate) fn patches_from(&self, first: usize) -> Range<usize> {
        self.patches.start as usize - first..self.patches.end as usize - first
    }
}

/// Finds each island's patches in an overlap of these islands alone.
pub(crate) fn set_patches(islands: &mut [Island], patches: &[Patch]) {
    let mut from = 0;
    for island in islands {
        let own = patches[from..].iter().take_while(|patch| patch.of < island.candidates.end);
        let to = from + own.count();
        island.set_patches(from..to);
        from = to;
    }
}

impl Group {
    /// Sets the group to these islands, with their moving bodies, which are marked as in an island.
    pub(crate) fn enter(
        &mut self,
        islands: &[Island],
        candidates: &[Pairing],
        motions: &mut [Motion],
    ) {
        let ([first, ..], [.., last]) = (islands, islands) else { return };
        self.candidates = first.candidates().start..last.candidates().end;
        self.patches = first.patches.start as usize..last.patches.end as usize;
        self.bodies.clear();
        for Pairing { candidate, .. } in &candidates[self.candidates.clone()] {
            for rank in [candidate.a, candidate.b] {
                let motion = &mut motions[rank as usize];
                if motion.moves && !motion.in_island {
                    motion.in_island = true;
                    self.bodies.push(rank);
                }
            }
        }
        if !self.bodies.is_sorted() {
            self.bodies.sort_unstable();
        }
    }

    /// Marks where the group's items begin in the lists of the next memory and of the results.
    pub(crate) fn begin_lists(&mut self, next: &NextMemory, results: &Results) {
        self.first_patch = next.patches.len();
        self.first_place = next.places.len();
        self.first_hint = next.hints.len();
        self.first_contact = results.contacts.len();
    }
}

/// What a group, or one island, left at its last (sub-)step.
#[derive(Clone, Debug, Default)]
pub(crate) struct IslandMemory {
    patches: Vec<PatchMemory>,
    places: Vec<PlaceMemory>,
    pub(crate) hints: Vec<HintMemory>,
}

impl IslandMemory {
    /// As the past of the next sub-step, `last_step_s` later, before which the host displaced these bodies.
    pub(crate) fn past<'m>(&'m self, last_step_s: f64, displaced: &'m Displaced) -> Past<'m> {
        let IslandMemory { patches, places, hints } = self;
        Past { patches, places, hints, last_step_s, displaced }
    }

    /// As the past of a later sub-step.
    pub(crate) fn within_step(&self, last_step_s: f64) -> Past<'_> {
        self.past(last_step_s, &NONE_DISPLACED)
    }

    /// Moves what a group's sub-step left out of the next memory. `hints` are those of the sub-step's overlap.
    pub(crate) fn take_first(
        &mut self,
        next: &mut NextMemory,
        group: &Group,
        hints: &[HintMemory],
    ) {
        self.take_patches(next, group);
        self.hints.clear();
        self.hints.extend_from_slice(hints);
    }

    /// As [`IslandMemory::take_first`] after a later sub-step, whose hints are in the next memory too.
    pub(crate) fn take(&mut self, next: &mut NextMemory, group: &Group) {
        self.take_patches(next, group);
        self.hints.clear();
        self.hints.extend(next.hints.drain(group.first_hint..));
    }

    fn take_patches(&mut self, next: &mut NextMemory, group: &Group) {
        self.patches.clear();
        self.patches.extend(next.patches.drain(group.first_patch..));
        self.places.clear();
        self.places.extend(next.places.drain(group.first_place..));
    }

    /// Copies what the last step left of these candidates.
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
