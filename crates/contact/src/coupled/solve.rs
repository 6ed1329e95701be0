//! The solve: normal and tangential forces of all contacts of an island together.
//!
//! Unknown N_i, T_i. With V⁺ the relative velocity at a contact after *all* forces of the sub-step:
//!
//! - 0 ≤ N_i ≤ f_i, V_n,i⁺ + γ v_ref,i ≥ 0, and N_i < f_i only where that bound is tight: a boxed
//!   linear complementarity problem, N_i = mid(0, N at which the bound is tight, f_i). With one
//!   contact and no load this is the paper's limiter.
//! - T_i = −k_s(Δs + ϑ h V̄), V̄ = (1 − ϑ) V_t + ϑ V_t⁺, the shear spring taken implicitly, within
//!   Coulomb's limits: see [`implicit_share`].
//!
//! Projected Gauss–Seidel on the bodies' velocities, warm-started with the last forces, in the fixed
//! order of the contacts. Bounded work: what has not settled after [`SWEEPS`] is reported.

use crate::coupled::rows::Row;
use crate::events::note;
use crate::model::Model;
use crate::report::{EventKind, Friction};
use crate::vec2::Vec2;
use crate::workspace::Workspace;

/// Most sweeps over the contacts.
const SWEEPS: u32 = 400;
/// A sweep that changes no velocity at a contact by more than this has settled [m/s].
const SETTLED_MPS: f64 = 1e-13;
/// A change larger than this in the last sweep is told to the user [m/s].
const TOLD_MPS: f64 = 1e-6;

/// New velocities of the island's bodies in `work.states`, and forces in `work.rows`.
pub(crate) fn velocities(model: &Model, work: &mut Workspace, h: f64) {
    free_velocities(work, h);
    for index in 0..work.rows.len() {
        let row = work.rows[index];
        push(
            work,
            &row,
            row.touch.normal * (-row.normal_n * h) + row.tangent * (row.tangential_n * h),
        );
    }
    for _ in 0..SWEEPS {
        let mut change_mps = 0.0_f64;
        for index in 0..work.rows.len() {
            change_mps = change_mps.max(relax(work, index, h));
        }
        if change_mps <= SETTLED_MPS {
            return;
        }
        work.last_change_mps = change_mps;
    }
    if work.last_change_mps > TOLD_MPS
        && let Some(row) = work.rows.first().copied()
    {
        note(model, work, row.a, row.b, EventKind::NotConverged);
    }
}

/// v_free = v + h M⁻¹ W.
fn free_velocities(work: &mut Workspace, h: f64) {
    for &rank in &work.island_bodies {
        let rank = rank as usize;
        work.before[rank] = work.states[rank];
        let load = work.loads[rank];
        let (dv, dr) = work.inverses[rank].response(load.force_n * h, load.moment_nm * h);
        work.states[rank].velocity_mps += dv;
        work.states[rank].yaw_rate_radps += dr;
    }
}

/// Gives the two bodies of a row an impulse and its opposite [N·s].
#[inline]
fn push(work: &mut Workspace, row: &Row, impulse: Vec2) {
    for (rank, arm_m, impulse) in
        [(row.a, row.touch.arm_a_m, impulse), (row.b, row.touch.arm_b_m, -impulse)]
    {
        let rank = rank as usize;
        let (dv, dr) = work.inverses[rank].response(impulse, arm_m.cross(impulse));
        work.states[rank].velocity_mps += dv;
        work.states[rank].yaw_rate_radps += dr;
    }
}

/// Velocity of body A at the contact relative to body B [m/s].
#[inline]
fn relative_velocity(work: &Workspace, row: &Row) -> Vec2 {
    super::point_velocity(&work.states[row.a as usize], row.touch.arm_a_m)
        - super::point_velocity(&work.states[row.b as usize], row.touch.arm_b_m)
}

/// One contact's forces, given all others'. Returns the largest change of velocity [m/s].
#[inline]
fn relax(work: &mut Workspace, index: usize, h: f64) -> f64 {
    let mut row = work.rows[index];
    let normal_n = normal(&row, relative_velocity(work, &row).dot(row.touch.normal), h);
    let more_n = normal_n - row.normal_n;
    if more_n != 0.0 {
        row.normal_n = normal_n;
        push(work, &row, row.touch.normal * (-more_n * h));
    }
    let (tangential_n, friction) =
        tangential(&row, relative_velocity(work, &row).dot(row.tangent), h);
    let more_t = tangential_n - row.tangential_n;
    if more_t != 0.0 {
        row.tangential_n = tangential_n;
        push(work, &row, row.tangent * (more_t * h));
    }
    row.friction = friction;
    work.rows[index] = row;
    (more_n * row.inverse_normal).abs().max((more_t * row.inverse_tangential).abs()) * h
}

/// N = mid(0, N at which V_n⁺ = −γ v_ref, f).
#[inline]
fn normal(row: &Row, v_normal_mps: f64, h: f64) -> f64 {
    let tight_n = row.normal_n + (v_normal_mps + row.rebound_mps) / (h * row.inverse_normal);
    passive(row, v_normal_mps, tight_n.min(row.law_n).max(0.0), h)
}

/// `normal_n`, or less where it would give the bodies more than the contact may.
///
/// The work of N on the bodies is N h (½ N h/E − s), with s the mean of V_n before the sub-step and of V_n
/// after it were N 0.
#[inline]
fn passive(row: &Row, v_normal_mps: f64, normal_n: f64, h: f64) -> f64 {
    let without_mps = v_normal_mps + row.normal_n * h * row.inverse_normal;
    let mean_mps = 0.5 * (row.touch.v_normal_mps + without_mps);
    let work_j = normal_n * h * (0.5 * normal_n * h * row.inverse_normal - mean_mps);
    if work_j <= row.may_give_j {
        return normal_n;
    }
    let root = libm::sqrt(mean_mps * mean_mps + 2.0 * row.inverse_normal * row.may_give_j);
    (mean_mps + root).max(0.0) / (row.inverse_normal * h)
}

/// The implicit shear spring and Coulomb's limits on it.
#[inline]
fn tangential(row: &Row, v_tangential_mps: f64, h: f64) -> (f64, Friction) {
    if row.shear_stiffness_npm == 0.0 {
        return (0.0, Friction::Stick);
    }
    // V_t⁺ if T were 0, then T from T(1 + ϑ² k_s h²/E) = −k_s(Δs + ϑ h V̄ without T).
    let without_mps = v_tangential_mps - row.tangential_n * h * row.inverse_tangential;
    let share = implicit_share(row, h);
    let mean_mps = (1.0 - share) * row.touch.v_tangential_mps + share * without_mps;
    let spring_n = -row.shear_stiffness_npm * (row.touch.shear_m + share * h * mean_mps)
        / (1.0 + share * share * row.shear_stiffness_npm * h * h * row.inverse_tangential);
    // Once it slips in this sub-step it holds again only below the sliding force: else, with μ_k below
    // μ_s, the sweeps would go to and fro between the two.
    let holds = match row.friction {
        Friction::Stick => row.friction_static,
        Friction::Slip => row.friction_dynamic,
    };
    if spring_n.abs() <= holds * row.normal_n {
        (spring_n, Friction::Stick)
    } else {
        ((row.friction_dynamic * row.normal_n).copysign(spring_n), Friction::Slip)
    }
}

/// ϑ of the shear spring: how implicit it is. ½, the midpoint rule, keeps its energy exactly, where
/// backward Euler (1) would damp it by ωh/2 a radian: at the sub-steps that the normal law needs, a
/// tug that rolls along a ship's side would leave with a yaw rate wrong by a seventh. Where the sub-step
/// is long beside the spring's own period ϑ rises to 1, so that it does not ring at k_s h²/m ≫ 1. Any
/// ϑ ≥ ½ is stable and makes no energy, whatever the number of contacts.
#[inline]
pub(crate) fn implicit_share(row: &Row, h: f64) -> f64 {
    let turn = libm::sqrt(row.shear_stiffness_npm * row.inverse_tangential) * h;
    if turn <= 1.0 { 0.5 } else { 1.0 - 0.5 / turn }
}
