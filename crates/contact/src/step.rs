//! One step of the engine, stage by stage.

use alloc::vec::Vec;

use crate::admit;
use crate::broad;
use crate::error::StepError;
use crate::events::tell_of_patch;
use crate::fender::RankedFender;
use crate::geometry::clip::ClipBuffers;
use crate::inherit::{Inherited, inherit_from};
use crate::law::normal::{damper_n, factor, normal_force};
use crate::law::shear;
use crate::limit::effective_mass::inverse_mass;
use crate::limit::paper::{self, Velocities};
use crate::memory::{Memory, PatchMemory, PlaceMemory};
use crate::model::Model;
use crate::overlap::{Patch, overlap};
use crate::pause::pause;
use crate::report::{Contact, ContactImpulse, EnergyParts, Event, Wrench};
use crate::state::BodyState;
use crate::touch::{Movers, Scene, arms_m, touch};
use crate::vec2::Vec2;
use crate::workspace::Workspace;

/// Contact forces between all bodies for the step of `step_s` seconds that begins at `states`, by
/// the paper's method. `states` are in the order in which the bodies were added.
///
/// Results are in `work`: [`Workspace::contacts`], [`Workspace::wrenches`], [`Workspace::events`].
/// `memory` goes on to the next step. In a step of 0 s, of a host that is paused, nothing goes on: `memory` stays as
/// it is, and what is in `work` but for events and work. The order in which bodies were added changes no bit of any
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
    if step_s == 0.0 {
        return pause(model, memory, work, states, None);
    }
    admit::admit(model, memory, states, step_s)?;
    work.advanced = None;
    work.results_of = Some(model.layout);
    admit::place(model, memory, work, states);
    let all_held = work.near.holds(model, &work.poses, &work.reach_m);
    broad::pair(model, work, all_held);
    work.own_candidates = 0..work.candidates.len();
    let mut hints = core::mem::take(&mut work.next_hints);
    hints.clear();
    let all_go_on = overlap(model, &memory.hints, work, &mut hints);
    work.next_hints = hints;
    inherit_from(model, memory.past(), work, 0);
    forces(model, memory, work, step_s);
    remember(memory, work, all_go_on, step_s);
    Ok(())
}

/// Stages 4 and 5 for every patch, each by itself as the paper has it, and the contacts' part of stage 6:
/// one wrench per body, in the order of the contacts.
fn forces(model: &Model, memory: &Memory, work: &mut Workspace, step_s: f64) {
    work.contacts.clear();
    work.peaks.clear();
    work.next_patches.clear();
    work.next_places.clear();
    PlaceMemory::add_all(&work.found.patches, &work.found.places, &mut work.next_places);
    work.wrenches.clear();
    work.wrenches.resize(model.bodies().len(), Wrench::default());
    // The backward difference of eq. 3 is over the step that has gone, not the one to come.
    let elapsed_s = if memory.last_step_s > 0.0 { memory.last_step_s } else { step_s };
    let time = Time { step_s, elapsed_s };
    let Workspace { found, shares, inherited, states, poses, clip, events, .. } = work;
    let scene = Scene { model, found, poses };
    let mut books = Books {
        told: work.contacts_told,
        contacts: &mut work.contacts,
        wrenches: &mut work.wrenches,
        next_patches: &mut work.next_patches,
        events,
        buffers: clip,
    };
    for (patch, &inherited) in found.patches.iter().zip(&*inherited) {
        let old = inherited.of(&memory.patches, shares);
        let past = (inherited, old);
        // Twice the same: without a fender most of it is nought, which the compiler then knows.
        match patch.candidate.fender(model) {
            None => contact(&scene, &mut books, patch, None, past, states, time),
            Some(face) => contact_at_face(&scene, &mut books, patch, face, past, states, time),
        }
    }
}

/// What a contact is written to.
struct Books<'w> {
    /// Contacts are reported one by one.
    told: bool,
    contacts: &'w mut Vec<Contact>,
    wrenches: &'w mut [Wrench],
    next_patches: &'w mut Vec<PatchMemory>,
    events: &'w mut Vec<Event>,
    buffers: &'w mut ClipBuffers,
}

/// What a patch takes over from the last step, and the memory that it is.
type Taken<'m> = (Inherited, Option<&'m PatchMemory>);

/// The step that is to come and the one that has gone (s).
#[derive(Clone, Copy)]
struct Time {
    step_s: f64,
    elapsed_s: f64,
}

/// As [`contact`], on a fender.
#[inline(never)]
fn contact_at_face(
    scene: &Scene<'_>,
    books: &mut Books<'_>,
    patch: &Patch,
    face: &RankedFender,
    past: Taken<'_>,
    states: &[BodyState],
    time: Time,
) {
    contact(scene, books, patch, Some(face), past, states, time);
}

/// Law and limit for one patch: adds its contact to the report and its memory to the next step's.
#[inline(always)]
fn contact(
    scene: &Scene<'_>,
    books: &mut Books<'_>,
    patch: &Patch,
    face: Option<&RankedFender>,
    (inherited, old): Taken<'_>,
    states: &[BodyState],
    Time { step_s, elapsed_s }: Time,
) {
    let model = scene.model;
    let ids = model.ids_of([patch.candidate.a, patch.candidate.b]);
    let material = &model.materials()[patch.candidate.material.0 as usize];
    let touch = touch(scene, books.buffers, patch, face, material, old, (Movers::Both, states));
    let arms_m @ [arm_a_m, arm_b_m] = arms_m(scene, patch, touch.point_in_a_m);

    // §3.2 and §3.4: the normal force.
    let v = Velocities {
        normal_mps: touch.v_normal_mps,
        tangential_mps: touch.v_tangential_mps,
        normal_0_mps: old.map_or(touch.v_normal_mps, |m| m.v_normal_0_mps),
        tangential_0_mps: old.map_or(touch.v_tangential_mps, |m| m.v_tangential_0_mps),
    };
    let body_a = &model.ranked[patch.candidate.a as usize];
    let body_b = &model.ranked[patch.candidate.b as usize];
    let mass = inverse_mass(body_a, arm_a_m, body_b, arm_b_m, touch.normal);
    let area_before_m2 = old.map_or(0.0, |m| m.area_m2);
    let factor = factor(model, face, &touch, old);
    let mut parts =
        normal_force(&touch, factor, damper_n(material, patch.area_m2, area_before_m2, elapsed_s));
    let trial_n = parts.total_n();
    let normal_force_n = paper::limited_normal_n(trial_n, &v, &mass, material.restitution, step_s);
    parts.limiter_n = trial_n - normal_force_n;

    // §3.3 and §3.4: the shear spring and its limits.
    let shear = shear::friction(material, touch.shear_m, normal_force_n);
    let tangential_force_n = paper::limited_tangential_n(
        shear.force_n,
        normal_force_n,
        &v,
        &mass,
        material.restitution,
        step_s,
    );

    let flags = tell_of_patch(model, books.events, patch, face, &touch, inherited, old);
    let report = Contact {
        shear_m: shear.shear_m,
        normal_force_n,
        tangential_force_n,
        impulse: ContactImpulse {
            normal_ns: normal_force_n * step_s,
            tangential_ns: tangential_force_n * step_s,
        },
        friction: shear.friction,
        limited: normal_force_n < trial_n || tangential_force_n != shear.force_n,
        peak_normal_force_n: normal_force_n,
        parts,
        factor,
        energy: EnergyParts {
            stored_j: touch.stored_j * factor,
            peak_absorbed_j: touch.stored_j * factor,
            shear_stored_j: 0.5 * material.shear_stiffness_npm * shear.shear_m * shear.shear_m,
            ..EnergyParts::default()
        },
        ..touch.contact(scene, (patch, ids), face, arms_m)
    };
    gather(&report, books.wrenches);
    if books.told {
        books.contacts.push(report);
    }
    let memory = PatchMemory {
        flags,
        shear_m: shear.shear_m,
        v_normal_0_mps: v.normal_0_mps,
        v_tangential_0_mps: v.tangential_0_mps,
        factor,
        ..PatchMemory::of(patch, touch.point_in_a_m, touch.normal_in_a)
    };
    books.next_patches.push(memory);
}

/// Stage 6, gather: adds a contact to the wrenches of its bodies. The force on body 2 is exactly the
/// opposite of that on body 1 (eq. 1).
#[inline(always)]
fn gather(contact: &Contact, wrenches: &mut [Wrench]) {
    let force_n: Vec2 = contact.force_on_body_1_n();
    let on_1 = &mut wrenches[contact.body_1.0 as usize];
    on_1.force_n += force_n;
    on_1.moment_nm += contact.arm_1_m.cross(force_n);
    let on_2 = &mut wrenches[contact.body_2.0 as usize];
    on_2.force_n -= force_n;
    on_2.moment_nm -= contact.arm_2_m.cross(force_n);
}

/// The step is done: what it found becomes the memory of the next. Where all hints go on the memory has them.
fn remember(memory: &mut Memory, work: &mut Workspace, all_go_on: bool, step_s: f64) {
    core::mem::swap(&mut memory.patches, &mut work.next_patches);
    core::mem::swap(&mut memory.places, &mut work.next_places);
    if !all_go_on {
        core::mem::swap(&mut memory.hints, &mut work.next_hints);
    }
    core::mem::swap(&mut memory.last_states, &mut work.states);
    memory.last_step_s = step_s;
    memory.placed.clear();
    memory.behind_s.clear();
}
