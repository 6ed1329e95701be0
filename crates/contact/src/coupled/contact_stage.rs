//! Computes the contacts of a sub-step: the laws of each contact, and the solve of each island.

use alloc::vec;
use alloc::vec::Vec;
use core::ops::Range;

use crate::coupled::assemble::{Aside, Diagnostics, Heritage, Start, Target, assemble};
use crate::coupled::constraint::Constraint;
use crate::coupled::dynamics::Dynamics;
use crate::coupled::island::{Group, Island};
use crate::coupled::newton::NewtonBuffers;
use crate::coupled::{release, solve};
use crate::inherit::inherited::Inherited;
use crate::inherit::{Inheritance, continues_alone};
use crate::maths::room::room_for;
use crate::model::Model;
use crate::overlap::patch::Patch;
use crate::state::events::note;
use crate::state::memory::{Past, PatchMemory};
use crate::state::report::{Event, EventKind};

/// The contact constraints of a sub-step, and the solver's buffers.
#[derive(Clone, Debug, Default)]
pub(crate) struct Constraints {
    /// One constraint per patch of contact; the list may be longer than the number of patches. [`Assembly`] and
    /// [`solve_islands`] compute the constraints.
    list: Vec<Constraint>,
    /// Diagnostics of each patch of contact; used only if contacts are reported.
    diagnostics: Vec<Diagnostics>,
    pub(crate) solver: SolverBuffers,
}

#[derive(Clone, Debug, Default)]
pub(crate) struct SolverBuffers {
    newton: NewtonBuffers,
    /// Buffer for [`release`]: the unbalanced stored energy of each body's contacts with fixed bodies, by rank (J).
    unbalanced_j: Vec<f64>,
}

impl Constraints {
    /// Makes buffers with room for this number of contacts and bodies.
    pub(crate) fn with_room(contacts: usize, bodies: usize) -> Constraints {
        Constraints {
            list: vec![Constraint::default(); contacts],
            diagnostics: vec![Diagnostics::default(); contacts],
            solver: SolverBuffers { unbalanced_j: room_for(bodies), ..SolverBuffers::default() },
        }
    }

    /// Returns the constraints and the diagnostics of `patches` contacts, and the solver's buffers.
    pub(crate) fn of(
        &mut self,
        patches: usize,
        reported: bool,
    ) -> (&mut [Constraint], &mut [Diagnostics], &mut SolverBuffers) {
        if self.list.len() < patches {
            self.list.resize(patches, Constraint::default());
        }
        let reported = if reported { patches } else { 0 };
        if self.diagnostics.len() < reported {
            self.diagnostics.resize(reported, Diagnostics::default());
        }
        (&mut self.list[..patches], &mut self.diagnostics[..reported], &mut self.solver)
    }
}

impl SolverBuffers {
    pub(crate) fn resize(&mut self, bodies: usize) {
        self.unbalanced_j.resize(bodies, 0.0);
    }
}

/// Writes the laws of a sub-step's contacts as constraints.
pub(crate) struct Assembly<'w> {
    pub(crate) start: Start<'w>,
    pub(crate) aside: Aside<'w>,
    pub(crate) patches: &'w [Patch],
    /// The islands to which the patches belong, and the number of the first patch of the first island.
    pub(crate) islands: (&'w [Island], usize),
    /// One constraint per patch.
    pub(crate) constraints: &'w mut [Constraint],
    /// One entry per patch if contacts are reported, else empty.
    pub(crate) diagnostics: &'w mut [Diagnostics],
    pub(crate) next_patches: &'w mut Vec<PatchMemory>,
}

impl Assembly<'_> {
    /// Adds the laws of the contacts at the front of the list, as long as each contact continues the old contact at the
    /// same place in the list. Returns the number of contacts added.
    ///
    /// In most sub-steps `add_matched` adds all contacts, and no search for what each contact inherits is needed. If
    /// the host displaced bodies, `add_matched` adds no contact.
    #[inline(always)]
    pub(crate) fn add_matched(&mut self, past: Past<'_>) -> usize {
        if !past.displaced.all.is_empty() {
            return 0;
        }
        let count = self.patches.len().min(past.patches.len());
        for index in 0..count {
            if !continues_alone(self.patches, past.patches, index) {
                return index;
            }
            let old = Some(&past.patches[index]);
            let inherited = Inherited::One(index as u32);
            let heritage = Heritage { inherited, old, displaced: 0 };
            // Without a fender most of the law is 0: the compiler specialises this call.
            if self.patches[index].candidate.face == 0 {
                self.add_outline(index, heritage);
            } else {
                self.add(index, heritage);
            }
        }
        count
    }

    /// Adds the laws of the contacts from number `from` on: new contacts, contacts that inherit from several old
    /// contacts, and contacts that inherit from a part of an old contact.
    #[inline(never)]
    pub(crate) fn add_others(&mut self, past: Past<'_>, inheritance: &Inheritance, from: usize) {
        let (islands, first) = self.islands;
        let mut islands = islands.iter().map(|island| island.patches_from(first));
        let mut island = 0..0;
        for (index, &inherited) in (from..self.patches.len()).zip(&inheritance.inherited) {
            while island.end <= index {
                island = islands.next().expect("every patch belongs to an island");
            }
            let candidate = self.patches[index].candidate;
            let displaced =
                past.last_step_s == 0.0 || past.displaced.is_displaced(candidate.a, candidate.b);
            let heritage = Heritage {
                inherited,
                old: inherited.of(past.patches, &inheritance.shares),
                displaced: if displaced { self.contacts_beside(index, island.clone()) } else { 0 },
            };
            self.add(index, heritage);
        }
    }

    /// Counts the contacts of the floating bodies of this contact, this contact included. All the counted contacts are
    /// in the island of this contact.
    #[cold]
    fn contacts_beside(&self, index: usize, island: Range<usize>) -> u32 {
        let floats = |rank: u32| !self.start.scene.model.ranked[rank as usize].is_fixed();
        let own = self.patches[index].candidate;
        let shares = |rank: u32| [own.a, own.b].contains(&rank) && floats(rank);
        let beside = |patch: &&Patch| shares(patch.candidate.a) || shares(patch.candidate.b);
        (self.patches[island].iter().filter(beside).count() as u32).max(1)
    }

    /// Adds the laws of a contact between two outlines.
    #[inline(always)]
    fn add_outline(&mut self, index: usize, heritage: Heritage<'_>) {
        let target = Target {
            constraint: &mut self.constraints[index],
            diagnostics: self.diagnostics.get_mut(index),
        };
        let patch = &self.patches[index];
        let memory = assemble(&self.start, &mut self.aside, patch, None, heritage, target);
        self.next_patches.push(memory);
    }

    /// Adds the laws of a contact of any kind.
    #[inline(never)]
    fn add(&mut self, index: usize, heritage: Heritage<'_>) {
        let target = Target {
            constraint: &mut self.constraints[index],
            diagnostics: self.diagnostics.get_mut(index),
        };
        let patch = &self.patches[index];
        let face = patch.candidate.fender(self.start.scene.model);
        let memory = assemble(&self.start, &mut self.aside, patch, face, heritage, target);
        self.next_patches.push(memory);
    }
}

/// The contacts of a group of islands; each list has one entry per patch.
pub(crate) struct Contacts<'w> {
    pub(crate) patches: &'w [Patch],
    pub(crate) constraints: &'w mut [Constraint],
    pub(crate) memories: &'w mut [PatchMemory],
}

/// Solves the contacts of each island in a group. Writes the new velocities of the bodies, and the forces of the
/// contacts into the constraints.
pub(crate) fn solve_islands(
    model: &Model,
    group: &Group,
    islands: &[Island],
    Contacts { patches, constraints, memories }: Contacts<'_>,
    dynamics: &mut Dynamics,
    SolverBuffers { newton, unbalanced_j }: &mut SolverBuffers,
    events: &mut Vec<Event>,
) {
    let count = model.ranked.len();
    let (velocities, inverses) = (&mut dynamics.velocities[..count], &dynamics.inverses[..count]);
    for island in islands {
        let own = island.patches_from(group.patches.start);
        let first = own.start;
        let change_mps = match own.len() {
            0 => continue,
            1 => {
                let constraint = &mut constraints[first];
                release::release_single(model, &patches[first], &mut memories[first], constraint);
                solve::solve_single(velocities, inverses, constraint, constraint.kick_s)
            }
            _ => {
                let (constraints, memories) =
                    (&mut constraints[own.clone()], &mut memories[own.clone()]);
                let patches = &patches[own];
                release::release_island(model, patches, memories, constraints, unbalanced_j);
                let kick_s = constraints[0].kick_s;
                solve::solve_island(velocities, inverses, constraints, memories, newton, kick_s)
            }
        };
        if change_mps > solve::REPORTED_MPS {
            let Constraint { a, b, .. } = constraints[first];
            note(model, events, a, b, EventKind::NotConverged);
        }
    }
}
