//! The contacts of a sub-step, from their laws to what is booked of them.

use crate::coupled::book::Books;
use crate::coupled::island::Island;
use crate::coupled::let_go::let_go;
use crate::coupled::rows::{self, Begun, Row, Taken};
use crate::coupled::solve;
use crate::coupled::tie::Tie;
use crate::events::note;
use crate::inherit::Inherited;
use crate::memory::Past;
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
    let begun = Begun { scene: Scene { model, found, poses }, before, inverses, elapsed_s, h };
    let first_sub_step = contacts.len() == *first_contact;
    let first_contact = *first_contact;
    let mut books = Books {
        wrenches,
        told: *contacts_told,
        contacts,
        first_contact,
        next_patches,
        in_order,
        first_sub_step,
        h,
        share,
    };
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
        rows.resize(patches.len(), Row::default());
    }
    let (ties, rows) = (&mut ties[..patches.len()], &mut rows[..patches.len()]);
    let both = ties.iter_mut().zip(rows.iter_mut());
    for ((patch, &inherited), (tie, row)) in patches.iter().zip(&*inherited).zip(both) {
        let taken = taken(patch, inherited);
        // Twice the same: without a fender most of it is nought, which the compiler then knows.
        (*tie, *row) = match patch.candidate.fender(model) {
            None => rows::collect(&begun, (events, buffers), patch, None, taken),
            face => rows::collect(&begun, (events, buffers), patch, face, taken),
        };
    }
    let mut from = 0;
    for island in islands {
        let own = |patch: &&Patch| (patch.of as usize) < island.candidates.end;
        let to = from + patches[from..].iter().take_while(own).count();
        let (ties, rows) = (&mut ties[from..to], &mut rows[from..to]);
        from = to;
        let_go(model, rows, ties, unheld_j);
        if solve::velocities(states, inverses, ties, trials, h) > solve::TOLD_MPS {
            note(model, events, ties[0].a, ties[0].b, EventKind::NotConverged);
        }
    }
    let both = ties.iter().zip(&*rows);
    for ((patch, both), index) in patches.iter().zip(both).zip(0..) {
        books.book(&begun.scene, index, patch, both);
    }
}
