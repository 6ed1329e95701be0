//! Computes one step of the paper's method, stage by stage.

use crate::admit;
use crate::broad;
use crate::broad::bodies::{Bodies, Displaced, PoseChange};
use crate::error::StepError;
use crate::geometry::clip::ClipBuffers;
use crate::inherit::inherited::Inherited;
use crate::law::friction;
use crate::law::normal::{damper_n, factor, normal_force};
use crate::limit::effective_mass::inverse_mass;
use crate::limit::paper::{self, Velocities};
use crate::maths::vec2::Vec2;
use crate::model::Model;
use crate::model::fender::RankedFender;
use crate::overlap;
use crate::overlap::hints::Hints;
use crate::overlap::patch::Patch;
use crate::panel::chains::{Broken, add_parted};
use crate::panel::report::PanelMotion;
use crate::pause::pause;
use crate::state::body_state::BodyState;
use crate::state::events::report_patch;
use crate::state::memory::{ContactMemory, Memory, PatchMemory, PlaceMemory};
use crate::state::report::{Contact, ContactImpulse, EnergyParts, Wrench};
use crate::state::results::Results;
use crate::state::workspace::Workspace;
use crate::touch::{Movers, Scene, arms_m, touch, touch_again};

/// Computes the contact forces between all bodies by the paper's method, for the step of `step_s` seconds that begins
/// at `states`. `states` are in the order in which the bodies were added.
///
/// The results are then in `work`: [`Workspace::contacts`], [`Workspace::wrenches`], [`Workspace::events`]. `memory`
/// becomes the memory for the next step. A step of 0 s means that the host is paused: the function changes neither
/// `memory` nor the results, except that it clears events and work. The order in which bodies were added changes no bit
/// of any force, because all sums run in the order of the bodies' keys.
///
/// # Errors
/// Returns a [`StepError`] if the input is not finite or out of range. After an error `memory` is unchanged, and `work`
/// keeps the results of the last good step.
pub fn step(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    states: &[BodyState],
    step_s: f64,
) -> Result<(), StepError> {
    admit::refuse_piles(model)?;
    if step_s == 0.0 {
        return pause(model, memory, work, states, None);
    }
    // 1. Admit: check the input and place the bodies.
    admit::admit(model, memory, states, step_s)?;
    work.dynamics.invalidate();
    let Workspace { bodies, displaced, candidates, overlap, clip, .. } = work;
    let Workspace { inheritance, next_memory, results, .. } = work;
    place(model, memory, states, bodies, displaced);
    results.layout = Some(model.layout);
    results.clear_forces(model.bodies().len());
    results.begin_events(model, &displaced.teleported);
    next_memory.clear();
    results.parted.clone_from(&memory.parted);

    // 2. Broad phase: pairs of bodies that are near each other.
    broad::pair(model, bodies, &memory.contacts.patches, candidates);

    // 3. Narrow phase: S, C and n of each patch (§3.1), and its memory.
    let past = memory.contacts.past(memory.last_step_s, displaced);
    let hints = Hints::new(past.hints, &mut next_memory.hints);
    let pairings = &candidates.pairings;
    let keeps_hints = overlap::overlap(model, bodies, pairings, 0, hints, clip, overlap);
    let (patches, places) = (overlap.patches.as_slice(), overlap.places.as_slice());
    inheritance.find(model, past, patches, places, 0, &mut results.events);
    PlaceMemory::add_all(patches, places, &mut next_memory.places);

    // 4–6. Laws (eq. 2–8), limits by momentum (eq. 26), and the sums of forces (eq. 1), patch by patch.
    let scene = Scene { model, overlap, poses: &bodies.poses, states: &bodies.input };
    let elapsed_s = if past.last_step_s > 0.0 { past.last_step_s } else { step_s };
    let mut stage = Stage { scene, clip, results, next_memory, step_s, elapsed_s };
    for (patch, &inherited) in patches.iter().zip(&inheritance.inherited) {
        stage.add(patch, inherited, inherited.of(past.patches, &inheritance.shares));
    }

    // The step is done. The new memory becomes the memory of the next step.
    next_memory.exchange(&mut memory.contacts, keeps_hints);
    memory.parted.clone_from(&results.parted);
    core::mem::swap(&mut memory.last_states, &mut bodies.input);
    memory.last_step_s = step_s;
    memory.placed.clear();
    memory.behind_s.clear();
    Ok(())
}

/// Stage 1 of a step: puts the input states and the poses in the order of the ranks, and finds the bodies that were
/// teleported.
fn place(
    model: &Model,
    memory: &Memory,
    states: &[BodyState],
    bodies: &mut Bodies,
    displaced: &mut Displaced,
) {
    bodies.resize(model.ranked.len());
    displaced.clear();
    bodies.active.extend(0..model.ranked.len() as u32);
    let Bodies { input, poses, reach_m, .. } = bodies;
    for (rank, ((input, pose), reach_m)) in input.iter_mut().zip(poses).zip(reach_m).enumerate() {
        let body = &model.ranked[rank];
        let state = states[model.id_of[rank].0 as usize];
        (*input, *pose, *reach_m) = (state, state.pose(), body.reach_m);
        let teleported = memory.last_states.get(rank).is_some_and(|last| {
            memory.pose_change(rank, last, &state, body.radius_m) == PoseChange::Teleported
        });
        if teleported {
            displaced.teleported.push(rank as u32);
        }
    }
}

/// The data that stages 4 to 6 of a step read and write, for one patch at a time.
struct Stage<'w> {
    scene: Scene<'w>,
    clip: &'w mut ClipBuffers,
    results: &'w mut Results,
    next_memory: &'w mut ContactMemory,
    /// Length of the present step, and the time since the last step began (s). The backward difference of eq. 3 is
    /// taken over the time since the last step began.
    step_s: f64,
    elapsed_s: f64,
}

impl Stage<'_> {
    /// Adds a patch of contact with the memory that it inherits.
    fn add(&mut self, patch: &Patch, inherited: Inherited, old: Option<&PatchMemory>) {
        // Without a fender most of the law is 0: the compiler specialises the first call.
        match patch.candidate.fender(self.scene.model) {
            None => self.add_contact(patch, None, inherited, old),
            Some(face) => self.add_at_fender(patch, face, inherited, old),
        }
    }

    #[inline(never)]
    fn add_at_fender(
        &mut self,
        patch: &Patch,
        face: &RankedFender,
        inherited: Inherited,
        old: Option<&PatchMemory>,
    ) {
        self.add_contact(patch, Some(face), inherited, old);
    }

    /// Applies the contact law and the limit to one patch, and adds the contact and the memory of the patch.
    #[inline(always)]
    fn add_contact(
        &mut self,
        patch: &Patch,
        face: Option<&RankedFender>,
        inherited: Inherited,
        old: Option<&PatchMemory>,
    ) {
        let Stage { scene, clip, results, next_memory, step_s, elapsed_s } = self;
        let (scene, step_s, model) = (*scene, *step_s, scene.model);
        let [rank_a, rank_b] = [patch.candidate.a, patch.candidate.b];
        let ids = model.ids_of([rank_a, rank_b]);
        let material = &model.materials()[patch.candidate.material.0 as usize];
        if let Some(face) = face {
            let factor = old.map(|memory| memory.factor);
            clip.panel.state = face.chain_state(patch.candidate.face, &results.parted, factor);
        }
        let mut touch = touch(&scene, clip, patch, face, old, Movers::Both);
        let mut broken = Broken::default();
        if let Some(law) = face.and_then(|face| face.panel.as_ref()) {
            broken = law.breaking(&clip.panel.pressed.tensions_n);
        }
        if broken.chains != 0 {
            add_parted(&mut results.parted, patch.candidate.face, broken.chains);
            clip.panel.state.parted |= broken.chains;
            touch = touch_again(&scene, clip, patch, face, old, Movers::Both);
        }
        let arms_m @ [arm_a_m, arm_b_m] = arms_m(&scene, patch, touch.point_in_a_m);

        // N by the law (eq. 2–3), limited by momentum (eq. 26, first line).
        let v = Velocities {
            normal_mps: touch.v_normal_mps,
            tangential_mps: touch.v_tangential_mps,
            normal_0_mps: old.map_or(touch.v_normal_mps, |m| m.v_normal_0_mps),
            tangential_0_mps: old.map_or(touch.v_tangential_mps, |m| m.v_tangential_0_mps),
        };
        let (body_a, body_b) = (&model.ranked[rank_a as usize], &model.ranked[rank_b as usize]);
        let mass = inverse_mass(body_a, arm_a_m, body_b, arm_b_m, touch.normal);
        let area_before_m2 = old.map_or(0.0, |m| m.area_m2);
        let factor = factor(model, face, &touch, patch, old);
        if let Some(face) = face
            && face.panel.is_some()
        {
            let hull = ids[usize::from(face.host == rank_a)];
            let pressed = &clip.panel.pressed;
            PanelMotion::note(&mut results.panels, (face.id, hull), pressed, factor, &broken);
        }
        let damper_n = damper_n(material, patch.area_m2, area_before_m2, *elapsed_s);
        let mut parts = normal_force(&touch, factor, damper_n);
        let (law_n, gamma) = (parts.total_n(), material.restitution);
        let normal_force_n = paper::limited_normal_n(law_n, &v, &mass, gamma, step_s);
        parts.limiter_n = law_n - normal_force_n;

        // T by shear spring and friction (eq. 4–8), limited by momentum (eq. 26, second line).
        let shear = friction::friction(material, touch.shear_m, normal_force_n);
        let tangential_force_n =
            paper::limited_tangential_n(shear.force_n, normal_force_n, &v, &mass, gamma, step_s);

        let flags = report_patch(model, &mut results.events, patch, face, &touch, inherited, old);
        let contact = Contact {
            shear_m: shear.shear_m,
            normal_force_n,
            tangential_force_n,
            impulse: ContactImpulse {
                normal_ns: normal_force_n * step_s,
                tangential_ns: tangential_force_n * step_s,
            },
            friction: shear.friction,
            limited: normal_force_n < law_n || tangential_force_n != shear.force_n,
            peak_normal_force_n: normal_force_n,
            parts,
            factor,
            energy: EnergyParts {
                stored_j: touch.stored_j * factor,
                peak_absorbed_j: touch.stored_j * factor,
                shear_stored_j: 0.5 * material.shear_stiffness_npm * shear.shear_m * shear.shear_m,
                ..EnergyParts::default()
            },
            ..touch.contact(&scene, patch, ids, arms_m)
        };
        add_wrenches(&contact, &mut results.wrenches);
        if results.reports_contacts {
            results.contacts.push(contact);
        }
        next_memory.patches.push(PatchMemory {
            flags,
            shear_m: shear.shear_m,
            v_normal_0_mps: v.normal_0_mps,
            v_tangential_0_mps: v.tangential_0_mps,
            factor,
            ..PatchMemory::of(patch, touch.point_in_a_m, touch.normal_in_a)
        });
    }
}

/// Adds the force of a contact to the wrenches of its two bodies. The force on body 2 is exactly the opposite of the
/// force on body 1 (eq. 1).
#[inline(always)]
fn add_wrenches(contact: &Contact, wrenches: &mut [Wrench]) {
    let force_n: Vec2 = contact.force_on_body_1_n();
    let on_1 = &mut wrenches[contact.body_1.0 as usize];
    on_1.force_n += force_n;
    on_1.moment_nm += contact.arm_1_m.cross(force_n);
    let on_2 = &mut wrenches[contact.body_2.0 as usize];
    on_2.force_n -= force_n;
    on_2.moment_nm -= contact.arm_2_m.cross(force_n);
}
