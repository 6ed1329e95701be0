//! The contacts of a sub-step, from their laws to what is booked of them.

use alloc::vec::Vec;

use crate::coupled::book::{Books, Reports};
use crate::coupled::island::Island;
use crate::coupled::let_go;
use crate::coupled::rows::{self, Aside, Begun, Row, Taken};
use crate::coupled::solve;
use crate::coupled::tie::Tie;
use crate::events::note;
use crate::inherit::{Inherited, goes_on, inherit_from};
use crate::memory::{Past, PatchMemory, PlaceMemory};
use crate::model::Model;
use crate::overlap::Patch;
use crate::report::EventKind;
use crate::touch::Scene;
use crate::workspace::{Workspace, has_either};

/// The contacts of a sub-step, of `h` seconds and this `share` of the step: their laws, the solve of each island
/// and what it leaves.
pub(crate) fn act(
    model: &Model,
    past: Past<'_>,
    work: &mut Workspace,
    islands: &[Island],
    (h, share): (f64, f64),
) {
    let first_patch = work.next_patches.len();
    // Each stage over all contacts, so that none waits for what another's solve does.
    let gone_on = laws_of_old(model, past, work, h);
    if gone_on < past.patches.len().max(work.own_patches.len()) {
        inherit_from(model, past, work, gone_on);
        laws_of_others(model, past, work, (gone_on, h));
    }
    let Workspace {
        found,
        own_patches,
        poses,
        velocities,
        inverses,
        events,
        rows,
        ties,
        trials,
        unheld_j,
        wrenches,
        contacts_told,
        contacts,
        first_contact,
        next_patches,
        next_places,
        in_order,
        ..
    } = work;
    let patches = &found.patches[own_patches.clone()];
    PlaceMemory::add_all(patches, &found.places, next_places);
    let ties = &mut ties[..patches.len()];
    let memories = &mut next_patches[first_patch..][..patches.len()];
    // As many as there are bodies: their ranks are checked once.
    let count = model.ranked.len();
    let (velocities, inverses) = (&mut velocities[..count], &inverses[..count]);
    for island in islands {
        let own = island.patches_from(own_patches.start);
        let first = own.start;
        let change_mps = match own.len() {
            0 => continue,
            1 => {
                let tie = &mut ties[first];
                let_go::alone(model, &patches[first], &mut memories[first], tie);
                solve::alone(velocities, inverses, tie, tie.kick_s)
            }
            _ => {
                let (ties, memories) = (&mut ties[own.clone()], &mut memories[own.clone()]);
                let_go::let_go(model, &patches[own], memories, ties, unheld_j);
                let kick_s = ties[0].kick_s;
                solve::velocities(velocities, inverses, ties, memories, trials, kick_s)
            }
        };
        if change_mps > solve::TOLD_MPS {
            note(model, events, ties[first].a, ties[first].b, EventKind::NotConverged);
        }
    }
    let mut books = Books { wrenches, h, share };
    if *contacts_told {
        let scene = Scene { model, found, poses: &poses[..count] };
        let mut reports = Reports { contacts, first_contact: *first_contact, in_order };
        return reports.book_all(&scene, &mut books, patches, (ties, memories, rows));
    }
    for (tie, memory) in ties.iter().zip(memories) {
        books.book(model.ids_of([tie.a, tie.b]), tie, memory);
    }
}

/// What the laws of a sub-step's contacts come from, and where they are written.
struct Laying<'w> {
    begun: Begun<'w>,
    aside: Aside<'w>,
    patches: &'w [Patch],
    /// One for each patch.
    ties: &'w mut [Tie],
    /// One for each patch where contacts are told, else none.
    rows: &'w mut [Row],
    next_patches: &'w mut Vec<PatchMemory>,
    /// What patches inherit that do not simply go on, and bodies that were put where they are.
    inherited: &'w [Inherited],
    shares: &'w [PatchMemory],
    put: &'w [u32],
}

impl<'w> Laying<'w> {
    #[inline(always)]
    fn new(model: &'w Model, work: &'w mut Workspace, h: f64) -> Laying<'w> {
        // As many as there are bodies: their ranks are checked once.
        let count = model.ranked.len();
        let patches = &work.found.patches[work.own_patches.clone()];
        // Written where they are to stay.
        if work.ties.len() < patches.len() {
            work.ties.resize(patches.len(), Tie::default());
        }
        let told = if work.contacts_told { patches.len() } else { 0 };
        if work.rows.len() < told {
            work.rows.resize(told, Row::default());
        }
        let scene = Scene { model, found: &work.found, poses: &work.poses[..count] };
        Laying {
            begun: Begun {
                scene,
                bodies: model.ranked.bodies(),
                states: &work.states[..count],
                moves: &work.moves[..count],
                inverses: &work.inverses[..count],
                behind_s: &work.behind_s[..count],
                h,
            },
            aside: Aside { events: &mut work.events, buffers: &mut work.clip },
            patches,
            ties: &mut work.ties[..patches.len()],
            rows: &mut work.rows[..told],
            next_patches: &mut work.next_patches,
            inherited: &work.inherited,
            shares: &work.shares,
            put: if work.puts { &work.put } else { &[] },
        }
    }
}

/// The laws of contacts as long as each goes on from the old one in its place, and how many those are: most often
/// all, of which nobody has to be told what they inherit. None where bodies were put.
#[inline(always)]
fn laws_of_old(model: &Model, past: Past<'_>, work: &mut Workspace, h: f64) -> usize {
    if work.puts {
        return 0;
    }
    let Laying { begun, mut aside, patches, ties, rows, next_patches, .. } =
        Laying::new(model, work, h);
    for (index, (tie, (patch, old))) in
        ties.iter_mut().zip(patches.iter().zip(past.patches)).enumerate()
    {
        if !goes_on((patch, old), patches, past.patches, index) {
            return index;
        }
        // Made where it is asked for, so that it stays in registers where it can.
        let taken = || Taken { inherited: Inherited::One(index as u32), old: Some(old), placed: 0 };
        let into = (tie, rows.get_mut(index));
        // Most of them are two outlines: much is known then.
        if patch.candidate.face == 0 {
            let memory = rows::collect(&begun, &mut aside, patch, None, taken(), into);
            next_patches.push(memory);
        } else {
            collect_other(begun, &mut aside, patch, taken(), into, next_patches);
        }
    }
    patches.len().min(past.patches.len())
}

/// The laws of contacts from number `from` on, some of which are new, or heirs of several or of a part.
#[inline(never)]
fn laws_of_others(model: &Model, past: Past<'_>, work: &mut Workspace, (from, h): (usize, f64)) {
    let Laying { begun, mut aside, patches, ties, rows, next_patches, inherited, shares, put } =
        Laying::new(model, work, h);
    let others = patches.iter().zip(ties).enumerate().skip(from);
    for ((index, (patch, tie)), &inherited) in others.zip(inherited) {
        let taken = Taken {
            inherited,
            old: inherited.of(past.patches, shares),
            placed: if past.last_step_s == 0.0
                || has_either(put, patch.candidate.a, patch.candidate.b)
            {
                beside(model, patches, patch)
            } else {
                0
            },
        };
        let into = (tie, rows.get_mut(index));
        collect_other(begun, &mut aside, patch, taken, into, next_patches);
    }
}

/// How many contacts a body that floats has beside this one, and this one.
#[cold]
#[inline(never)]
fn beside(model: &Model, patches: &[Patch], patch: &Patch) -> u32 {
    let floats = |rank: u32| !model.ranked[rank as usize].is_fixed();
    let own = [patch.candidate.a, patch.candidate.b];
    let shares = |rank: u32| own.contains(&rank) && floats(rank);
    let count =
        patches.iter().filter(|other| shares(other.candidate.a) || shares(other.candidate.b));
    (count.count() as u32).max(1)
}

/// The laws of a contact that is new, at a fender, or comes after one that is.
#[inline(never)]
fn collect_other(
    begun: Begun<'_>,
    aside: &mut Aside<'_>,
    patch: &Patch,
    taken: Taken<'_>,
    into: (&mut Tie, Option<&mut Row>),
    next_patches: &mut Vec<PatchMemory>,
) {
    let face = patch.candidate.fender(begun.scene.model);
    let memory = rows::collect(&begun, aside, patch, face, taken, into);
    next_patches.push(memory);
}
