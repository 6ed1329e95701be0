//! The contacts of a sub-step, from their laws to what is booked of them.

use alloc::vec::Vec;

use crate::coupled::book::Books;
use crate::coupled::island::Island;
use crate::coupled::let_go;
use crate::coupled::rows::{self, Aside, Begun, Taken};
use crate::coupled::solve;
use crate::coupled::tie::Tie;
use crate::events::note;
use crate::inherit::Inherited;
use crate::memory::{Past, PatchMemory};
use crate::model::Model;
use crate::overlap::Patch;
use crate::report::EventKind;
use crate::touch::Scene;
use crate::workspace::{Workspace, either};

/// The contacts of a sub-step, of `h` seconds and this `share` of the step: their laws, the solve of each island
/// and what it leaves.
pub(crate) fn act(
    model: &Model,
    past: Past<'_>,
    work: &mut Workspace,
    islands: &[Island],
    (h, share): (f64, f64),
) {
    let Workspace {
        found,
        own_patches,
        inherited,
        shares,
        poses,
        states,
        before,
        inverses,
        jumps,
        teleported,
        clip: buffers,
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
        in_order,
        ..
    } = work;
    let elapsed_s = if past.last_step_s > 0.0 { past.last_step_s } else { h };
    // As many as there are bodies: their ranks are checked once.
    let count = model.ranked.len();
    let begun = Begun {
        scene: Scene { model, found, poses: &poses[..count] },
        before: &before[..count],
        inverses: &inverses[..count],
        elapsed_s,
        h,
    };
    let told = *contacts_told;
    rows.clear();
    let mut aside = Aside { events, buffers, rows, told };
    let taken = |patch: &Patch, inherited: Inherited| Taken {
        inherited,
        old: inherited.of(past.patches, shares),
        placed: past.last_step_s == 0.0
            || *jumps && either(teleported, patch.candidate.a, patch.candidate.b),
    };
    // Each stage over all contacts, so that none waits for what another's solve does; written where they are to
    // stay.
    let patches = &found.patches[own_patches.clone()];
    if ties.len() < patches.len() {
        ties.resize(patches.len(), Tie::default());
    }
    let ties = &mut ties[..patches.len()];
    let first_patch = next_patches.len();
    for ((patch, &inherited), tie) in patches.iter().zip(&*inherited).zip(&mut *ties) {
        // Most of them: two outlines that touched before, of which much is known then.
        if let (0, Inherited::One(place)) = (patch.candidate.face, inherited) {
            let old = Some(&past.patches[place as usize]);
            let taken = Taken { inherited, old, placed: false };
            let memory = rows::collect(&begun, &mut aside, patch, None, taken, tie);
            memory.add_to(patch, &found.places, next_patches);
        } else {
            let taken = taken(patch, inherited);
            collect_other(begun, &mut aside, patch, taken, tie, next_patches);
        }
    }
    let memories = &mut next_patches[first_patch..][..patches.len()];
    let (states, inverses) = (&mut states[..count], &inverses[..count]);
    let mut from = 0;
    for island in islands {
        let first = from;
        while from < patches.len() && (patches[from].of as usize) < island.candidates.end {
            from += 1;
        }
        let change_mps = match from - first {
            0 => continue,
            1 => {
                let tie = &mut ties[first];
                let_go::alone(model, &patches[first], &mut memories[first], tie);
                solve::alone(states, inverses, tie, h)
            }
            _ => {
                let own = first..from;
                let (ties, memories) = (&mut ties[own.clone()], &mut memories[own.clone()]);
                let_go::let_go(model, &patches[own], memories, ties, unheld_j);
                solve::velocities(states, inverses, ties, memories, trials, h)
            }
        };
        if change_mps > solve::TOLD_MPS {
            note(model, aside.events, ties[first].a, ties[first].b, EventKind::NotConverged);
        }
    }
    let first_sub_step = contacts.len() == *first_contact;
    let first_contact = *first_contact;
    let mut books = Books { wrenches, contacts, first_contact, in_order, first_sub_step, h, share };
    for ((tie, memory), index) in ties.iter().zip(memories).zip(0..) {
        let moved = books.book(model, tie, memory);
        if told {
            let row = &aside.rows[index];
            books.tell(&begun.scene, (index, &patches[index]), (tie, memory, row), &moved);
        }
    }
}

/// The laws of a contact that is new, at a fender, or heir of several or of a part.
#[inline(never)]
fn collect_other(
    begun: Begun<'_>,
    aside: &mut Aside<'_>,
    patch: &Patch,
    taken: Taken<'_>,
    tie: &mut Tie,
    next_patches: &mut Vec<PatchMemory>,
) {
    let face = patch.candidate.fender(begun.scene.model);
    let memory = rows::collect(&begun, aside, patch, face, taken, tie);
    memory.add_to(patch, &begun.scene.found.places, next_patches);
}
