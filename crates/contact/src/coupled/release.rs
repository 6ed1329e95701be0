//! Release: lets contacts come apart if they store more energy than balances their load.

use crate::coupled::constraint::Constraint;
use crate::maths::number::greater;
use crate::model::Model;
use crate::overlap::patch::Patch;
use crate::state::memory::PatchMemory;

/// Fraction of the speed that the unbalanced energy would give, used as the release speed. The fraction keeps the
/// release speed below v_ref in a hit, where the stored energy has an error of a few per cent because of the time step.
const SHARE: f64 = 0.8;

/// Raises the reference speed v_ref of each contact of an island to the speed that the unbalanced stored energy would
/// give the bodies. `unbalanced_j` has room for one number for each body.
///
/// v_ref alone forgets. If the relative velocity of two bodies changes sign by a small amount, their v_ref starts again
/// from almost nothing. A small change of the velocity's sign happens when a ship on several fenders yaws a little
/// while she comes back. Without release, the ship would then rest deeper than her load holds her, for ever, or stay
/// pressed on after the wind has died. A spring with deflection δ and energy U that is held by a force N < f stores
/// about U (1 − N/f)² more than N balances (exactly, if the spring is linear). All contacts between the same two bodies
/// release together, and so do all contacts of one body with fixed bodies. N ≤ f still holds after a release, and N < f
/// only while the contact opens, so release creates no energy.
#[inline]
pub(crate) fn release_island(
    model: &Model,
    patches: &[Patch],
    memories: &mut [PatchMemory],
    constraints: &mut [Constraint],
    unbalanced_j: &mut [f64],
) {
    // Most islands stop here: even the sum of all unbalanced energy raises no v_ref.
    let all_j = constraints.iter().map(|constraint| constraint.unbalanced_j).sum();
    let rises = |(memory, constraint)| rises(all_j, memory, constraint);
    if memories.iter().zip(&*constraints).any(rises) {
        release_together(model, patches, memories, constraints, unbalanced_j);
    }
}

/// Does the same as [`release_island`] for the only contact of an island.
#[inline(always)]
pub(crate) fn release_single(
    model: &Model,
    patch: &Patch,
    memory: &mut PatchMemory,
    constraint: &mut Constraint,
) {
    if rises(constraint.unbalanced_j, memory, constraint) {
        raise(constraint.unbalanced_j, model, patch, memory, constraint);
    }
}

#[inline(always)]
fn rises(unbalanced_j: f64, memory: &PatchMemory, constraint: &Constraint) -> bool {
    speed_squared(unbalanced_j, constraint) > memory.v_normal_0_mps * memory.v_normal_0_mps
}

/// Square of the speed that the unbalanced energy would give the two bodies of a contact (m²/s²). Rotation is left out,
/// because contacts at both ends of a ship do not turn her.
#[inline(always)]
fn speed_squared(unbalanced_j: f64, constraint: &Constraint) -> f64 {
    SHARE * SHARE * 2.0 * unbalanced_j * constraint.inverse_mass.linear
}

/// Raises v_ref. The memory keeps the raised v_ref until the contact closes again. Otherwise the bound −γ v_ref on the
/// normal speed would come and go with the normal force N.
#[cold]
#[inline(never)]
fn raise(
    unbalanced_j: f64,
    model: &Model,
    patch: &Patch,
    memory: &mut PatchMemory,
    constraint: &mut Constraint,
) {
    let material = &model.materials()[patch.candidate.material.0 as usize];
    let speed_mps = libm::sqrt(speed_squared(unbalanced_j, constraint));
    let rebound_mps = material.restitution * speed_mps;
    constraint.rebound_mps = greater(constraint.rebound_mps, rebound_mps);
    memory.v_normal_0_mps = greater(memory.v_normal_0_mps, speed_mps);
}

/// Sums the unbalanced energy of all contacts that release together, and raises the v_ref of these contacts by the sum.
#[cold]
#[inline(never)]
fn release_together(
    model: &Model,
    patches: &[Patch],
    memories: &mut [PatchMemory],
    constraints: &mut [Constraint],
    unbalanced_j: &mut [f64],
) {
    let fixed = |rank: u32| model.ranked[rank as usize].is_fixed();
    for constraint in constraints.iter() {
        unbalanced_j[constraint.a as usize] = 0.0;
        unbalanced_j[constraint.b as usize] = 0.0;
    }
    for constraint in constraints.iter() {
        match (fixed(constraint.a), fixed(constraint.b)) {
            (true, _) => unbalanced_j[constraint.b as usize] += constraint.unbalanced_j,
            (_, true) => unbalanced_j[constraint.a as usize] += constraint.unbalanced_j,
            _ => {}
        }
    }
    let mut from = 0;
    while from < constraints.len() {
        let (a, b) = (constraints[from].a, constraints[from].b);
        let of_pair = |constraint: &&Constraint| (constraint.a, constraint.b) == (a, b);
        let count = constraints[from..].iter().take_while(of_pair).count();
        let own = from..from + count;
        let all_j = match (fixed(a), fixed(b)) {
            (true, _) => unbalanced_j[b as usize],
            (_, true) => unbalanced_j[a as usize],
            _ => constraints[own.clone()].iter().map(|constraint| constraint.unbalanced_j).sum(),
        };
        if all_j > 0.0 {
            let both = memories[own.clone()].iter_mut().zip(&mut constraints[own.clone()]);
            for (patch, (memory, constraint)) in patches[own].iter().zip(both) {
                raise(all_j, model, patch, memory, constraint);
            }
        }
        from += count;
    }
}
