//! The contacts of one sub-step: what the solve needs of each, and what is booked afterwards.

use crate::events::tell_of_patch;
use crate::inherit::Inherited;
use crate::law::normal::{factor, normal_force};
use crate::memory::{Memory, PatchMemory};
use crate::model::{Material, Model};
use crate::overlap::Patch;
use crate::report::{Contact, ForceParts, Friction};
use crate::touch::{Touch, touch};
use crate::vec2::Vec2;
use crate::workspace::Workspace;

/// One contact of the solve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Row {
    /// Ranks.
    pub(crate) a: u32,
    pub(crate) b: u32,
    pub(crate) touch: Touch,
    pub(crate) tangent: Vec2,
    /// f, the normal law's force: N lies between 0 and it [N].
    pub(crate) law_n: f64,
    /// What f is made of.
    pub(crate) parts: ForceParts,
    /// Factor on spring and stop.
    pub(crate) factor: f64,
    /// γ v_ref: V_n⁺ may not fall below its negative [m/s].
    pub(crate) rebound_mps: f64,
    /// γ.
    pub(crate) restitution: f64,
    /// Stored energy that nothing holds: see [`let_go`] [J].
    pub(crate) unheld_j: f64,
    /// What N may give the bodies in this sub-step at most: see [`may_give_j`] [J].
    pub(crate) may_give_j: f64,
    /// n·K n and t·K t [1/kg].
    pub(crate) inverse_normal: f64,
    pub(crate) inverse_tangential: f64,
    pub(crate) shear_stiffness_npm: f64,
    pub(crate) friction_static: f64,
    pub(crate) friction_dynamic: f64,
    /// N and T, from the last sub-step and then from the solve [N].
    pub(crate) normal_n: f64,
    pub(crate) tangential_n: f64,
    pub(crate) friction: Friction,
}

/// Laws and effective masses of every patch in `work`, in `work.rows`, and the inverse masses of the
/// island's bodies as they are turned now.
pub(crate) fn collect(model: &Model, work: &mut Workspace, memory: &Memory, h: f64) {
    for &rank in &work.island_bodies {
        let rank = rank as usize;
        work.inverses[rank] = model.ranked[rank].inverse.turned(work.poses[rank].rotation);
    }
    work.rows.clear();
    work.next_patches.clear();
    let elapsed_s = if memory.last_step_s > 0.0 { memory.last_step_s } else { h };
    for index in 0..work.patches.len() {
        let (patch, inherited) = (work.patches[index], work.inherited[index]);
        let placed = [patch.candidate.a, patch.candidate.b]
            .iter()
            .any(|&rank| memory.last_step_s == 0.0 || work.teleported[rank as usize]);
        collect_one(model, work, &patch, &inherited, elapsed_s, placed);
    }
    let_go(model, work);
}

/// Share of the speed that unheld energy would give, so that it stays below v_ref in a hit, where the
/// time step's error in the stored energy is a few per cent.
const LET_GO: f64 = 0.8;

/// Raises each v_ref to the speed that the stored energy which no load holds would give.
///
/// v_ref alone forgets: where the relative velocity changes sign by a trifle, as it does when a ship on
/// several fenders yaws a little while she comes back, it starts again from next to nothing, and she
/// rests for ever deeper than her load holds her, or stays pressed on when the wind has died. A spring
/// at δ that is held by N < f has about U (1 − N/f)² more than it needs (exactly, where it is linear);
/// all contacts between the same two bodies, or of one body with what is fixed, let go together. As
/// N ≤ f still, and N < f only while the contact opens, nothing is made out of nothing.
fn let_go(model: &Model, work: &mut Workspace) {
    let fixed = |rank: u32| model.ranked[rank as usize].is_fixed();
    for &rank in &work.island_bodies {
        work.unheld_j[rank as usize] = 0.0;
    }
    for row in &work.rows {
        match (fixed(row.a), fixed(row.b)) {
            (true, _) => work.unheld_j[row.b as usize] += row.unheld_j,
            (_, true) => work.unheld_j[row.a as usize] += row.unheld_j,
            _ => {}
        }
    }
    let mut from = 0;
    while from < work.rows.len() {
        let (a, b) = (work.rows[from].a, work.rows[from].b);
        let count = work.rows[from..].iter().take_while(|row| (row.a, row.b) == (a, b)).count();
        let rows = &mut work.rows[from..from + count];
        let unheld_j = match (fixed(a), fixed(b)) {
            (true, _) => work.unheld_j[b as usize],
            (_, true) => work.unheld_j[a as usize],
            _ => rows.iter().map(|row| row.unheld_j).sum(),
        };
        if unheld_j > 0.0 {
            for row in rows {
                // Without rotation: contacts at both ends of a ship do not turn her.
                let along = row.touch.normal;
                let inverse_mass: f64 = [a, b]
                    .map(|rank| work.inverses[rank as usize].response(along, 0.0).0.dot(along))
                    .iter()
                    .sum();
                let speed_mps = LET_GO * libm::sqrt(2.0 * unheld_j * inverse_mass);
                row.rebound_mps = row.rebound_mps.max(row.restitution * speed_mps);
            }
        }
        from += count;
    }
}

/// What a contact stores beyond what its last force holds [J]. Between outlines at least a third of
/// f δ: a flat side stores half of it, a wedge a third.
fn unheld_j(touch: &Touch, factor: f64, law_n: f64, old: Option<&PatchMemory>) -> f64 {
    let Some(memory) = old else { return 0.0 };
    if memory.normal_force_n >= law_n {
        return 0.0;
    }
    let stored_j = match touch.stored_j {
        0.0 => law_n * touch.depth_m * (1.0 / 3.0),
        of_fender_j => of_fender_j * factor,
    };
    let share = 1.0 - memory.normal_force_n / law_n;
    stored_j * share * share
}

/// What a contact may give the bodies [J]: what it has taken from them. A spring whose force is that of
/// the sub-step's start returns a little more than it took, by up to ωh/2; where it gives nearly all of it
/// back (γ near 1), or the first touch fell deep into a sub-step, somebody would leave faster than it
/// came. Bodies that were *put* into contact (`placed`) get what the spring holds then, or f δ, a bound on
/// it between outlines, whose law has no potential.
fn may_give_j(
    touch: &Touch,
    factor: f64,
    law_n: f64,
    old: Option<&PatchMemory>,
    placed: bool,
) -> f64 {
    match (old, placed) {
        (Some(memory), _) => memory.taken_j,
        (None, false) => 0.0,
        (None, true) => (touch.stored_j * factor).max(law_n * touch.depth_m),
    }
}

fn collect_one(
    model: &Model,
    work: &mut Workspace,
    patch: &Patch,
    inherited: &Inherited,
    elapsed_s: f64,
    placed: bool,
) {
    let material: &Material = &model.materials()[patch.candidate.material.0 as usize];
    let old = inherited.memory();
    let touch = touch(model, work, patch, old);
    let area_before_m2 = old.map_or(0.0, |m| m.area_m2);
    let factor = factor(model, patch.candidate.fender(model), &touch, old);
    let parts = normal_force(material, &touch, factor, patch.area_m2, area_before_m2, elapsed_s);
    let law_n = parts.total_n();
    let (v_ref_mps, approaching) = reference_speed(touch.v_normal_mps, old);
    let tangent = touch.normal.quarter_turn();
    let (a, b) = (patch.candidate.a as usize, patch.candidate.b as usize);
    let inverse_along = |along: Vec2| {
        [(a, touch.arm_a_m), (b, touch.arm_b_m)]
            .map(|(rank, arm)| {
                let lever = arm.cross(along);
                let (dv, dr) = work.inverses[rank].response(along, lever);
                dv.dot(along) + dr * lever
            })
            .iter()
            .sum::<f64>()
    };
    let row = Row {
        a: patch.candidate.a,
        b: patch.candidate.b,
        tangent,
        law_n,
        parts,
        factor,
        rebound_mps: material.restitution * v_ref_mps,
        restitution: material.restitution,
        unheld_j: unheld_j(&touch, factor, law_n, old),
        may_give_j: may_give_j(&touch, factor, law_n, old, placed),
        inverse_normal: inverse_along(touch.normal),
        inverse_tangential: inverse_along(tangent),
        shear_stiffness_npm: material.shear_stiffness_npm,
        friction_static: material.friction_static,
        friction_dynamic: material.friction_dynamic,
        normal_n: old.map_or(law_n, |m| m.normal_force_n).min(law_n),
        tangential_n: old.map_or(0.0, |m| m.tangential_force_n),
        friction: Friction::Stick,
        touch,
    };
    work.rows.push(row);
    let flags = tell_of_patch(model, work, patch, &touch, inherited)
        | (u32::from(approaching) * PatchMemory::APPROACHING);
    let memory = touch.memory(patch);
    work.next_patches.push(PatchMemory { flags, factor, v_normal_0_mps: v_ref_mps, ..memory });
}

/// v_ref: the largest speed of approach since V_n last changed sign, and whether it approaches. The
/// speed at first touch, kept for ever, would not let a ship that starts at rest settle to her
/// static depth.
fn reference_speed(v_normal_mps: f64, old: Option<&PatchMemory>) -> (f64, bool) {
    let approaching = v_normal_mps > 0.0;
    let before = old.map_or(0.0, |m| m.v_normal_0_mps);
    let went_on = old.is_some_and(|m| m.flags & PatchMemory::APPROACHING != 0);
    let v_ref_mps = match (approaching, went_on) {
        (true, true) => before.max(v_normal_mps),
        (true, false) => v_normal_mps,
        (false, _) => before,
    };
    (v_ref_mps, approaching)
}

/// Beyond this a memory would not be restored [J].
const MOST_TAKEN_J: f64 = 1e29;

/// Books impulses, work and peaks of a solved sub-step, and completes its memory.
pub(crate) fn book(model: &Model, work: &mut Workspace, h: f64) {
    for index in 0..work.rows.len() {
        let row = work.rows[index];
        let (a, b) = (row.a as usize, row.b as usize);
        let touch = &row.touch;
        let impulse = (touch.normal * -row.normal_n + row.tangent * row.tangential_n) * h;
        work.impulses[a].force_n += impulse;
        work.impulses[a].moment_nm += touch.arm_a_m.cross(impulse);
        work.impulses[b].force_n -= impulse;
        work.impulses[b].moment_nm -= touch.arm_b_m.cross(impulse);

        let v_after_mps = (super::point_velocity(&work.states[a], touch.arm_a_m)
            - super::point_velocity(&work.states[b], touch.arm_b_m))
        .dot(row.tangent);
        let shear_m = shear_after(&row, v_after_mps, h);
        let memory = &mut work.next_patches[index];
        // What the bodies move in this sub-step is found again in the next one's kinematics.
        memory.shear_m = shear_m - h * v_after_mps;
        memory.normal_force_n = row.normal_n;
        memory.tangential_force_n = row.tangential_n;

        let slip_mps =
            mean_velocity(work, a, touch.arm_a_m) - mean_velocity(work, b, touch.arm_b_m);
        let patch = work.patches[index];
        let entry = entry_of(model, work, &patch, &row);
        let contact = &mut work.contacts[entry];
        contact.normal_force_n += row.normal_n * h;
        contact.tangential_force_n += row.tangential_n * h;
        contact.peak_normal_force_n = contact.peak_normal_force_n.max(row.normal_n);
        contact.peak_depth_m = contact.peak_depth_m.max(touch.depth_m);
        let closing_m = touch.normal.dot(slip_mps) * h;
        let limiter_n = row.law_n - row.normal_n;
        contact.work.normal_j -= row.normal_n * closing_m;
        let taken_j = row.may_give_j + row.normal_n * closing_m;
        work.next_patches[index].taken_j = taken_j.clamp(0.0, MOST_TAKEN_J);
        contact.work.tangential_j += row.tangential_n * row.tangent.dot(slip_mps) * h;
        contact.work.damper_j -= row.parts.damper_n * closing_m;
        contact.work.limiter_j -= limiter_n * closing_m;
        contact.parts.add(&ForceParts { limiter_n, ..row.parts }, h);
        contact.peak_stored_j = contact.peak_stored_j.max(touch.stored_j * row.factor);
        contact.shear_stored_j = 0.5 * row.shear_stiffness_npm * shear_m * shear_m;
        contact.shear_m = shear_m;
        contact.limited |= row.normal_n < row.law_n;
        if row.friction == Friction::Slip {
            contact.friction = Friction::Slip;
        }
    }
}

/// Δs at the end of the sub-step [m]: grown by h V̄ while it sticks, what the sliding force shears while
/// it slips.
fn shear_after(row: &Row, v_after_mps: f64, h: f64) -> f64 {
    match row.friction {
        Friction::Stick => {
            let share = super::solve::implicit_share(row, h);
            row.touch.shear_m
                + h * ((1.0 - share) * row.touch.v_tangential_mps + share * v_after_mps)
        }
        Friction::Slip => -row.tangential_n / row.shear_stiffness_npm,
    }
}

/// Mean over the sub-step of the velocity of a body's point [m/s].
fn mean_velocity(work: &Workspace, rank: usize, arm_m: Vec2) -> Vec2 {
    let before = super::point_velocity(&work.before[rank], arm_m);
    let after = super::point_velocity(&work.states[rank], arm_m);
    (before + after) * 0.5
}

/// The step's report of this patch: that of an earlier sub-step, or a new one.
fn entry_of(model: &Model, work: &mut Workspace, patch: &Patch, row: &Row) -> usize {
    let fresh = Contact {
        factor: row.factor,
        stored_j: row.touch.stored_j * row.factor,
        ..row.touch.contact(model, work, patch)
    };
    let same = |c: &Contact| {
        (c.body_1, c.body_2, c.fender, c.patch)
            == (fresh.body_1, fresh.body_2, fresh.fender, fresh.patch)
    };
    let from = work.first_contact;
    match work.contacts[from..].iter().position(same) {
        Some(index) => from + index,
        None => {
            work.contacts.push(fresh);
            work.contacts.len() - 1
        }
    }
}
