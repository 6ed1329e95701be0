//! One step of the engine, stage by stage.

use crate::admit;
use crate::broad;
use crate::error::StepError;
use crate::inherit::{Inherited, continues, inherit, patches_of};
use crate::law::normal::normal_force_n;
use crate::law::shear;
use crate::limit::effective_mass::inverse_mass;
use crate::limit::paper::{self, Velocities};
use crate::memory::{Memory, PatchMemory};
use crate::model::Model;
use crate::overlap::{self, Patch};
use crate::report::{Contact, Event, EventKind, Wrench};
use crate::state::BodyState;
use crate::vec2::Vec2;
use crate::workspace::Workspace;

/// Contact forces between all bodies for the step of `step_s` seconds that begins at `states`, by
/// the paper's method. `states` are in the order in which the bodies were added.
///
/// Results are in `work`: [`Workspace::contacts`], [`Workspace::wrenches`], [`Workspace::events`].
/// `memory` goes on to the next step. The order in which bodies were added changes no bit of any
/// force: all sums go by the bodies' keys.
///
/// # Errors
/// [`StepError`] for input that is not finite or out of range; `memory` is then bit for bit as it
/// was, and `work` keeps the results of the last good step.
pub fn step(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    states: &[BodyState],
    step_s: f64,
) -> Result<(), StepError> {
    admit::admit(model, memory, states, step_s)?;
    work.events.clear();
    admit::place(model, memory, work, states);
    broad::pair(model, work);
    overlap::overlap(model, memory, work);
    forces(model, memory, work, step_s);
    gather(model, work);
    remember(memory, work, step_s);
    Ok(())
}

/// The step that begins, and the time since the last one began [s].
#[derive(Clone, Copy)]
struct Times {
    step_s: f64,
    elapsed_s: f64,
}

/// Stages 4 and 5 for every patch, each by itself as the paper has it.
fn forces(model: &Model, memory: &Memory, work: &mut Workspace, step_s: f64) {
    work.contacts.clear();
    work.next_patches.clear();
    let elapsed_s = if memory.last_step_s > 0.0 { memory.last_step_s } else { step_s };
    let times = Times { step_s, elapsed_s };
    let mut old = memory.patches.as_slice();
    let mut from = 0;
    while from < work.patches.len() {
        let (a, b) = (work.patches[from].candidate.a, work.patches[from].candidate.b);
        let to = from
            + work.patches[from..]
                .iter()
                .take_while(|p| (p.candidate.a, p.candidate.b) == (a, b))
                .count();
        let (ended, mut own) = patches_of(&mut old, a, b);
        ended.iter().for_each(|m| note(model, work, m.a, m.b, EventKind::ContactEnded));
        if work.teleported[a as usize] || work.teleported[b as usize] {
            own.iter().for_each(|_| note(model, work, a, b, EventKind::ContactEnded));
            own = &[];
        }
        tell_ends_and_splits(model, work, own, from, to);
        for index in from..to {
            let inherited = inherit(own, &work.patches[from..to], &work.patches[index]);
            let patch = work.patches[index];
            contact(model, work, &patch, inherited, times);
        }
        from = to;
    }
    old.iter().for_each(|m| note(model, work, m.a, m.b, EventKind::ContactEnded));
}

/// Events for the old patches of a pair that no new one continues, or more than one does.
fn tell_ends_and_splits(
    model: &Model,
    work: &mut Workspace,
    own: &[PatchMemory],
    from: usize,
    to: usize,
) {
    if own.len() <= 1 && to - from == 1 {
        return; // one patch that goes on
    }
    for m in own {
        let heirs = work.patches[from..to].iter().filter(|p| continues(m, p)).count();
        match heirs {
            0 => note(model, work, m.a, m.b, EventKind::ContactEnded),
            1 => {}
            _ => note(model, work, m.a, m.b, EventKind::PatchSplit),
        }
    }
}

/// Law and limit for one patch: adds its contact to the report and its memory to the next step's.
fn contact(
    model: &Model,
    work: &mut Workspace,
    patch: &Patch,
    inherited: Inherited,
    Times { step_s, elapsed_s }: Times,
) {
    let (a, b) = (patch.candidate.a, patch.candidate.b);
    let (body_a, body_b) = (&model.ranked[a as usize], &model.ranked[b as usize]);
    let material = &model.materials()[patch.candidate.material.0 as usize];
    let old = inherited.memory();

    // §1: normal and depth, then everything in earth-fixed axes with arms from each body.
    let remembered = old.map(|m| (m.normal_in_a, m.normal_in_b));
    let normal_in_a = overlap::normal_in_a(model, work, patch, remembered);
    let depth_m = overlap::depth_m(work, patch, normal_in_a);
    let pose_a = work.poses[a as usize];
    let normal = pose_a.rotation.apply(normal_in_a);
    let tangent = normal.quarter_turn();
    let arm_a_m = pose_a.rotation.apply(patch.centroid_m);
    let arm_b_m = pose_a.rotation.apply(patch.centroid_m - patch.b_in_a.position_m);
    let (state_a, state_b) = (&work.states[a as usize], &work.states[b as usize]);
    let slip_mps = (state_a.velocity_mps - state_b.velocity_mps)
        + (arm_a_m.spun_by(state_a.yaw_rate_radps) - arm_b_m.spun_by(state_b.yaw_rate_radps));
    let (v_normal_mps, v_tangential_mps) = (slip_mps.dot(normal), slip_mps.dot(tangent));

    // §2 and §4: the normal force.
    let v = Velocities {
        normal_mps: v_normal_mps,
        tangential_mps: v_tangential_mps,
        normal_0_mps: old.map_or(v_normal_mps, |m| m.v_normal_0_mps),
        tangential_0_mps: old.map_or(v_tangential_mps, |m| m.v_tangential_0_mps),
    };
    let mass = inverse_mass(body_a, arm_a_m, body_b, arm_b_m, normal);
    let area_before_m2 = old.map_or(0.0, |m| m.area_m2);
    let trial_n = normal_force_n(material, patch.area_m2, area_before_m2, elapsed_s);
    let normal_force_n =
        trial_n.min(paper::largest_normal_n(&v, &mass, material.restitution, step_s));

    // §3 and §4: the shear spring and its limits.
    let shear_m = old.map_or(0.0, |m| {
        // How far the material points that were at C have moved apart, in A's frame, where nothing
        // is lost far from the origin.
        let apart = m.point_in_a_m - patch.b_in_a.apply(m.point_in_b_m);
        m.shear_m + apart.dot(normal_in_a.quarter_turn())
    });
    let shear = shear::friction(material, shear_m, normal_force_n);
    let tangential_force_n = paper::limited_tangential_n(
        shear.force_n,
        normal_force_n,
        &v,
        &mass,
        material.restitution,
        step_s,
    );

    let limited = normal_force_n < trial_n || tangential_force_n != shear.force_n;
    let flags = tell_of_patch(model, work, patch, &inherited);
    // Reported with the body that was added first as body 1. A change of order turns n and t
    // round and nothing else.
    let swapped = body_a.id > body_b.id;
    let (first, second) = if swapped { (body_b, body_a) } else { (body_a, body_b) };
    work.contacts.push(Contact {
        body_1: first.id,
        body_2: second.id,
        patch: patch.number,
        area_m2: patch.area_m2,
        depth_m,
        point_m: pose_a.position_m + arm_a_m,
        arm_1_m: if swapped { arm_b_m } else { arm_a_m },
        arm_2_m: if swapped { arm_a_m } else { arm_b_m },
        normal: if swapped { -normal } else { normal },
        v_normal_mps,
        v_tangential_mps,
        shear_m: shear.shear_m,
        normal_force_n,
        tangential_force_n,
        friction: shear.friction,
        limited,
    });
    work.next_patches.push(PatchMemory {
        a,
        b,
        patch: patch.number,
        flags,
        area_m2: patch.area_m2,
        point_in_a_m: patch.centroid_m,
        point_in_b_m: patch.b_in_a.apply_inverse(patch.centroid_m),
        normal_in_a,
        normal_in_b: patch.b_in_a.rotation.apply_inverse(normal_in_a),
        shear_m: shear.shear_m,
        v_normal_0_mps: v.normal_0_mps,
        v_tangential_0_mps: v.tangential_0_mps,
        extent_in_a: patch.extent_in_a,
        extent_in_b: patch.extent_in_b,
    });
}

/// Events of one patch; those that last are told once. Returns the flags to remember.
fn tell_of_patch(model: &Model, work: &mut Workspace, patch: &Patch, inherited: &Inherited) -> u32 {
    let (a, b) = (patch.candidate.a, patch.candidate.b);
    match inherited {
        Inherited::Nothing => note(model, work, a, b, EventKind::ContactBegan),
        Inherited::Merged(_) => note(model, work, a, b, EventKind::PatchesMerged),
        Inherited::One(_) => {}
    }
    let smaller_m2 = model.ranked[a as usize].area_m2.min(model.ranked[b as usize].area_m2);
    // To a billionth: a body that lies in several pieces of another is summed from them.
    let contained = patch.contained || patch.area_m2 >= smaller_m2 * (1.0 - 1e-9);
    let deep = patch.area_m2 > 0.5 * smaller_m2;
    let flags = u32::from(contained) * PatchMemory::CONTAINED + u32::from(deep) * PatchMemory::DEEP;
    let told = inherited.memory().map_or(0, |m| m.flags);
    if flags & !told & PatchMemory::CONTAINED != 0 {
        note(model, work, a, b, EventKind::Contained);
    }
    if flags & !told & PatchMemory::DEEP != 0 {
        note(model, work, a, b, EventKind::DeepOverlap);
    }
    flags
}

fn note(model: &Model, work: &mut Workspace, a: u32, b: u32, kind: EventKind) {
    let (a, b) = (model.ranked[a as usize].id, model.ranked[b as usize].id);
    work.events.push(Event { bodies: [a.min(b), a.max(b)], kind });
}

/// The contacts' part of stage 6, gather: one wrench per body, in the order of the contacts. The
/// force on body 2 is exactly the opposite of that on body 1 (eq. 1).
fn gather(model: &Model, work: &mut Workspace) {
    work.wrenches.resize(model.bodies().len(), Wrench::default());
    work.wrenches.fill(Wrench::default());
    for contact in &work.contacts {
        let force_n: Vec2 = contact.force_on_body_1_n();
        let on_1 = &mut work.wrenches[contact.body_1.0 as usize];
        on_1.force_n += force_n;
        on_1.moment_nm += contact.arm_1_m.cross(force_n);
        let on_2 = &mut work.wrenches[contact.body_2.0 as usize];
        on_2.force_n -= force_n;
        on_2.moment_nm -= contact.arm_2_m.cross(force_n);
    }
}

/// The step is done: what it found becomes the memory of the next.
fn remember(memory: &mut Memory, work: &mut Workspace, step_s: f64) {
    core::mem::swap(&mut memory.patches, &mut work.next_patches);
    core::mem::swap(&mut memory.hints, &mut work.next_hints);
    memory.last_states.clone_from(&work.states);
    memory.last_step_s = step_s;
}
