//! Islands: groups of bodies that may touch each other in this step, directly or through other bodies. Each island is
//! solved by itself, and has its own number of sub-steps. Fixed bodies do not connect islands to each other.

use alloc::vec::Vec;
use core::ops::Range;

use crate::broad::candidates::Pairing;
use crate::coupled::motion::Role;
use crate::maths::room::room_for;
use crate::model::Model;
use crate::model::pair::JOINED;
use crate::overlap::patch::Patch;

/// The islands of a step. Computed by [`Islands::split`].
#[derive(Clone, Debug, Default)]
pub(crate) struct Islands {
    pub(crate) list: Vec<Island>,
    /// True if the candidates are in the order of their keys, although they are sorted by island.
    pub(crate) in_order: bool,
    /// True if some islands have more than one floating body.
    joined: bool,
    /// For each body, by rank, one body of its island; used while islands are joined.
    root: Vec<u32>,
}

/// Bodies that may touch each other, with their candidates as a range of `Candidates::pairings`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Island {
    candidates: Range<u32>,
    /// Patches of the island, as a range of the list of patches that its sub-step computes.
    patches: Range<u32>,
    pub(crate) sub_steps: u32,
}

/// Neighbouring islands that take the same number of sub-steps, and go through the sub-steps together ([`groups`]). Set
/// by [`Group::enter`].
#[derive(Clone, Debug, Default)]
pub(crate) struct Group {
    /// Candidates of the group, as a range of `Candidates::pairings`.
    pub(crate) candidates: Range<usize>,
    /// Patches of the group, as a range of the list of patches that the sub-step computes.
    pub(crate) patches: Range<usize>,
    /// Ranks of the group's moving bodies, in ascending order.
    pub(crate) bodies: Vec<u32>,
    /// The indices at which the group's patches, places of patches and search hints begin in their three lists in the
    /// memory of the next step.
    pub(crate) first: [usize; 3],
    /// The index at which the group's contacts begin in the results.
    pub(crate) first_contact: usize,
}

/// How islands are ordered in the list of candidates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Order {
    /// The islands are ordered by the ranks of their bodies: then the candidates are in the order of their keys.
    Ranked,
    Mixed,
    /// The islands of some candidates are not known yet.
    Unknown,
}

impl Islands {
    /// Makes an empty list of islands with room for `count` islands.
    pub(crate) fn with_room(count: usize) -> Islands {
        Islands { list: room_for(count), ..Islands::default() }
    }

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
            // Sorted by island, and within an island by key.
            candidates.sort_unstable_by_key(|p| (p.island, p.candidate.key()));
            self.part(candidates);
        }
    }

    /// Cuts the list of candidates where one island ends and the next begins.
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

    /// Finds the islands if floating bodies may touch each other, by the union–find method. The lowest rank of a body
    /// in an island identifies the island.
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

    /// Returns true if some islands have more than one floating body.
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

    /// The candidates of the island, as a range of `Candidates::pairings`.
    #[inline(always)]
    pub(crate) fn candidates(&self) -> Range<usize> {
        self.candidates.start as usize..self.candidates.end as usize
    }

    #[inline(always)]
    pub(crate) fn set_patches(&mut self, patches: Range<usize>) {
        self.patches = patches.start as u32..patches.end as u32;
    }

    /// The patches of the island in its sub-step, as a range of numbers counted from patch number `first`.
    #[inline(always)]
    pub(crate) fn patches_from(&self, first: usize) -> Range<usize> {
        self.patches.start as usize - first..self.patches.end as usize - first
    }
}

/// Finds the patches of each island in a list of patches that belong to these islands only.
pub(crate) fn set_patches(islands: &mut [Island], patches: &[Patch]) {
    let mut from = 0;
    for island in islands {
        let own = patches[from..].iter().take_while(|patch| patch.of < island.candidates.end);
        let to = from + own.count();
        island.set_patches(from..to);
        from = to;
    }
}

/// Largest number of islands that go through a sub-step together. With so few islands in a group, the data that one
/// stage writes are still in the processor's cache when the next stage reads them.
const MOST_TOGETHER: usize = 64;

/// Divides islands into groups. Islands that take several sub-steps stay in one group, because a fixed body's peak
/// wrench is computed for a group.
pub(crate) fn groups(islands: &mut [Island]) -> impl Iterator<Item = &mut [Island]> {
    islands.chunk_by_mut(|one, next| one.sub_steps == next.sub_steps).flat_map(|alike| {
        let most = if alike[0].sub_steps > 1 { alike.len() } else { MOST_TOGETHER };
        alike.chunks_mut(most)
    })
}

impl Group {
    /// Makes a group of islands with room for this number of bodies.
    pub(crate) fn with_room(bodies: usize) -> Group {
        Group { bodies: room_for(bodies), ..Group::default() }
    }

    /// Makes the group consist of these islands and their moving bodies. Marks the bodies of these islands as being in
    /// an island.
    pub(crate) fn enter(&mut self, islands: &[Island], candidates: &[Pairing], roles: &mut [Role]) {
        self.begin(islands);
        for Pairing { candidate, .. } in &candidates[self.candidates.clone()] {
            for rank in [candidate.a, candidate.b] {
                let role = &mut roles[rank as usize];
                if role.moves && !role.in_island {
                    role.in_island = true;
                    self.bodies.push(rank);
                }
            }
        }
        if !self.bodies.is_sorted() {
            self.bodies.sort_unstable();
        }
    }

    /// Does the same as [`Group::enter`] for the case that each island has one moving body. This special function saves
    /// 0.7 % of the time of a coupled step of the benchmark `ship`.
    pub(crate) fn enter_alone(
        &mut self,
        islands: &[Island],
        candidates: &[Pairing],
        roles: &mut [Role],
    ) {
        self.begin(islands);
        for island in islands {
            // The rank of its moving body identifies the island.
            let rank = candidates[island.candidates.start as usize].island;
            roles[rank as usize].in_island = true;
            self.bodies.push(rank);
        }
    }

    /// Begins with no bodies.
    fn begin(&mut self, islands: &[Island]) {
        let ([first, ..], [.., last]) = (islands, islands) else { return };
        self.candidates = first.candidates().start..last.candidates().end;
        self.patches = first.patches.start as usize..last.patches.end as usize;
        self.bodies.clear();
    }
}
