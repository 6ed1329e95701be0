//! The solve: normal and tangential forces of all contacts of an island together.
//!
//! Unknown N_i, T_i. With V⁺ the relative velocity at a contact after *all* forces of the sub-step:
//!
//! - 0 ≤ N_i ≤ f_i, V_n,i⁺ + γ v_ref,i ≥ 0, and N_i < f_i only where that bound is tight: a boxed
//!   linear complementarity problem, N_i = mid(0, N at which the bound is tight, f_i). With one
//!   contact and no load this is the paper's limiter.
//! - T_i = −k_s(Δs + h V_t⁺), the shear spring taken implicitly, within Coulomb's limits: it neither
//!   creeps under a steady load nor rings when k_s h²/m is large.
//!
//! Projected Gauss–Seidel on the bodies' velocities, warm-started with the last forces, in the fixed
//! order of the contacts. Bounded work: what has not settled after [`SWEEPS`] is reported.

use crate::coupled::tie::Tie;
use crate::events::note;
use crate::model::Model;
use crate::report::EventKind;
use crate::state::BodyState;
use crate::workspace::Workspace;

/// Most sweeps over the contacts.
const SWEEPS: u32 = 400;
/// A sweep that changes no velocity at a contact by more than this has settled [m/s].
const SETTLED_MPS: f64 = 1e-13;
/// A change larger than this in the last sweep is told to the user [m/s].
const TOLD_MPS: f64 = 1e-6;

/// New velocities of the island's bodies in `work.states`, and forces in `work.ties`.
pub(crate) fn velocities(model: &Model, work: &mut Workspace, h: f64) {
    free_velocities(work, h);
    let Workspace { states, ties, .. } = &mut *work;
    let last_change_mps = match ties.as_mut_slice() {
        [] => return,
        [only] => alone(states, only, h),
        several => together(states, several, h),
    };
    if last_change_mps > TOLD_MPS {
        let (a, b) = (ties[0].a, ties[0].b);
        note(model, work, a, b, EventKind::NotConverged);
    }
}

/// v_free = v + h M⁻¹ W.
fn free_velocities(work: &mut Workspace, h: f64) {
    for &rank in &work.island_bodies {
        let rank = rank as usize;
        let load = work.loads[rank];
        let (dv, dr) = work.inverses[rank].response(load.force_n * h, load.moment_nm * h);
        work.states[rank].velocity_mps += dv;
        work.states[rank].yaw_rate_radps += dr;
    }
}

/// Sweeps over all contacts until they have settled. Returns the last sweep's largest change of
/// velocity [m/s].
fn together(states: &mut [BodyState], ties: &mut [Tie], h: f64) -> f64 {
    for tie in ties.iter() {
        tie.push(states, tie.forces.normal_n * h, tie.forces.tangential_n * h);
    }
    let mut change_mps = 0.0;
    for _ in 0..SWEEPS {
        change_mps = 0.0;
        for tie in ties.iter_mut() {
            let forces = tie.relaxed(tie.speeds(states), h);
            let more = forces.less(&tie.forces);
            tie.forces = forces;
            if more != (0.0, 0.0) {
                tie.push(states, more.0 * h, more.1 * h);
                change_mps = f64::max(change_mps, tie.change_mps(more, h));
            }
        }
        if change_mps <= SETTLED_MPS {
            break;
        }
    }
    change_mps
}

/// The same for an island of one contact: its own two speeds are all there is to follow.
fn alone(states: &mut [BodyState], tie: &mut Tie, h: f64) -> f64 {
    let begun = tie.forces;
    let mut speeds = tie.speeds_after(tie.speeds(states), (begun.normal_n, begun.tangential_n), h);
    let mut change_mps = 0.0;
    for _ in 0..SWEEPS {
        let forces = tie.relaxed(speeds, h);
        let more = forces.less(&tie.forces);
        tie.forces = forces;
        speeds = tie.speeds_after(speeds, more, h);
        change_mps = tie.change_mps(more, h);
        if change_mps <= SETTLED_MPS {
            break;
        }
    }
    tie.push(states, tie.forces.normal_n * h, tie.forces.tangential_n * h);
    change_mps
}
