//! Contacts that hold more than their load come apart.

use crate::coupled::tie::Tie;
use crate::memory::PatchMemory;
use crate::model::Model;
use crate::number::greater;
use crate::overlap::Patch;

/// Share of the speed that unheld energy would give, so that it stays below v_ref in a hit, where the
/// time step's error in the stored energy is a few per cent.
const LET_GO: f64 = 0.8;

/// Raises each v_ref of an island's contacts to the speed that the stored energy which no load holds would
/// give. `unheld_j` has room for a number a body.
///
/// v_ref alone forgets: where the relative velocity changes sign by a trifle, as it does when a ship on
/// several fenders yaws a little while she comes back, it starts again from next to nothing, and she
/// rests for ever deeper than her load holds her, or stays pressed on when the wind has died. A spring
/// at δ that is held by N < f has about U (1 − N/f)² more than it needs (exactly, where it is linear);
/// all contacts between the same two bodies, or of one body with what is fixed, let go together. As
/// N ≤ f still, and N < f only while the contact opens, nothing is made out of nothing.
#[inline]
pub(crate) fn let_go(
    model: &Model,
    patches: &[Patch],
    memories: &mut [PatchMemory],
    ties: &mut [Tie],
    unheld_j: &mut [f64],
) {
    // While bodies close most of them come faster than all of it could give them.
    let all_j = ties.iter().map(|tie| tie.unheld_j).sum();
    let rises = |(memory, tie): (&PatchMemory, &Tie)| rises(all_j, memory, tie);
    if memories.iter().zip(&*ties).any(rises) {
        let_go_together(model, patches, memories, ties, unheld_j);
    }
}

/// The same for the only contact of an island.
#[inline(always)]
pub(crate) fn alone(model: &Model, patch: &Patch, memory: &mut PatchMemory, tie: &mut Tie) {
    if rises(tie.unheld_j, memory, tie) {
        raise(tie.unheld_j, model, patch, memory, tie);
    }
}

#[inline(always)]
fn rises(unheld_j: f64, memory: &PatchMemory, tie: &Tie) -> bool {
    speed_squared(unheld_j, tie) > memory.v_normal_0_mps * memory.v_normal_0_mps
}

/// Square of the speed that unheld energy would give the two bodies of a contact, without rotation (m²/s²):
/// contacts at both ends of a ship do not turn her.
#[inline(always)]
fn speed_squared(unheld_j: f64, tie: &Tie) -> f64 {
    LET_GO * LET_GO * 2.0 * unheld_j * tie.linear
}

/// It goes on until the contact closes again: else the bound would come and go with N.
#[cold]
#[inline(never)]
fn raise(unheld_j: f64, model: &Model, patch: &Patch, memory: &mut PatchMemory, tie: &mut Tie) {
    let material = &model.materials()[patch.candidate.material.0 as usize];
    let speed_mps = libm::sqrt(speed_squared(unheld_j, tie));
    tie.rebound_mps = greater(tie.rebound_mps, material.restitution * speed_mps);
    memory.v_normal_0_mps = greater(memory.v_normal_0_mps, speed_mps);
}

/// The unheld energy of all contacts that let go together, and what it makes of their v_ref.
#[cold]
#[inline(never)]
fn let_go_together(
    model: &Model,
    patches: &[Patch],
    memories: &mut [PatchMemory],
    ties: &mut [Tie],
    unheld_j: &mut [f64],
) {
    let fixed = |rank: u32| model.ranked[rank as usize].is_fixed();
    for tie in ties.iter() {
        unheld_j[tie.a as usize] = 0.0;
        unheld_j[tie.b as usize] = 0.0;
    }
    for tie in ties.iter() {
        match (fixed(tie.a), fixed(tie.b)) {
            (true, _) => unheld_j[tie.b as usize] += tie.unheld_j,
            (_, true) => unheld_j[tie.a as usize] += tie.unheld_j,
            _ => {}
        }
    }
    let mut from = 0;
    while from < ties.len() {
        let (a, b) = (ties[from].a, ties[from].b);
        let count = ties[from..].iter().take_while(|tie| (tie.a, tie.b) == (a, b)).count();
        let own = from..from + count;
        let all_j = match (fixed(a), fixed(b)) {
            (true, _) => unheld_j[b as usize],
            (_, true) => unheld_j[a as usize],
            _ => ties[own.clone()].iter().map(|tie| tie.unheld_j).sum(),
        };
        if all_j > 0.0 {
            let both = memories[own.clone()].iter_mut().zip(&mut ties[own.clone()]);
            for (patch, (memory, tie)) in patches[own].iter().zip(both) {
                raise(all_j, model, patch, memory, tie);
            }
        }
        from += count;
    }
}
