//! Stages 4 and 5 of the coupled method: write the laws of one contact of a sub-step as a constraint for the solver.

use alloc::vec::Vec;

use crate::coupled::constraint::{Constraint, Forces, Laws};
use crate::coupled::held::Held;
use crate::coupled::motion::{Role, kick_s};
use crate::coupled::press_out::{Placement, opening_mps};
use crate::geometry::clip::ClipBuffers;
use crate::inherit::inherited::Inherited;
use crate::law::damper::{Answered, Growth, damper};
use crate::law::friction::Slide;
use crate::law::normal::{factor, normal_force};
use crate::maths::number::{greater, lesser};
use crate::maths::vec2::Vec2;
use crate::model::Model;
use crate::model::fender::RankedFender;
use crate::model::mass::{InverseMatrix, Response};
use crate::model::material::Material;
use crate::model::unloading::{Loading, PLAYS, unload};
use crate::overlap::patch::Patch;
use crate::panel::chains::{Broken, add_parted};
use crate::panel::report::PanelMotion;
use crate::state::events::{note, report_patch};
use crate::state::memory::PatchMemory;
use crate::state::report::{Event, EventKind, ForceParts, Friction};
use crate::touch::levers::Levers;
use crate::touch::{Movers, Scene, Touch, touch, touch_again};

/// The data that the report of a contact in a sub-step needs besides [`Constraint`] and [`PatchMemory`].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Diagnostics {
    /// Depth of the contact, as in [`Touch`] (m).
    pub(crate) depth_m: f64,
    pub(crate) tilt_rad: f64,
    /// The parts of the normal law's force f: spring, stop and damper.
    pub(crate) parts: ForceParts,
    /// Energy stored in a fender's spring and stop, multiplied by the factor of the fender (J); with an unloading law,
    /// only the part that the fender can return.
    pub(crate) stored_j: f64,
    /// Energy that loads the fender's spring and stop to their deflection by the loading curve, multiplied by the
    /// factor of the fender (J).
    pub(crate) absorbed_j: f64,
    /// Heat that a fender's unloading law has made since the last step or sub-step, multiplied by the factor of the
    /// fender (J).
    pub(crate) hysteresis_j: f64,
}

/// The data of the bodies at the start of a sub-step that the contacts need. Lists are by rank.
#[derive(Clone, Copy)]
pub(crate) struct Start<'w> {
    pub(crate) scene: Scene<'w>,
    pub(crate) inverses: &'w [InverseMatrix],
    pub(crate) roles: &'w [Role],
    /// Velocity lag of each body (s), as defined in [`crate::coupled::dynamics::Dynamics`].
    pub(crate) velocity_lags_s: &'w [f64],
    /// Length of the sub-step (s).
    pub(crate) h: f64,
}

impl Start<'_> {
    /// The share of a floating body in the inverse effective mass of a contact, along the contact's normal n. `levers`
    /// are the levers of the normal n and the tangent t about the body's centre of gravity.
    #[inline(always)]
    fn response(&self, rank: u32, n: Vec2, levers: Levers) -> Response {
        let body = &self.scene.model.ranked[rank as usize];
        if body.is_alike {
            // This gives the same bits as the matrix, with less work.
            Response::isotropic(body.lightest_inverse_mass, body.inverse_of_turning, levers)
        } else {
            Response::of(&self.inverses[rank as usize], n, levers)
        }
    }

    /// Does for both bodies of a contact what [`Start::response`] does for one; one of the bodies may be fixed. The
    /// function also returns, for each of the two bodies, whether the body floats.
    #[inline(never)]
    fn response_of_both(
        &self,
        [a, b]: [u32; 2],
        n: Vec2,
        levers_a: Levers,
        levers_b: Levers,
    ) -> (Response, [bool; 2]) {
        let floats = [a, b].map(|rank| !self.scene.model.ranked[rank as usize].is_fixed());
        let (response_a, response_b) =
            (self.response(a, n, levers_a), self.response(b, n, levers_b));
        let seen = match floats {
            [true, false] => response_a,
            [false, true] => response_b,
            _ => Response::both(response_a, response_b),
        };
        (seen, floats)
    }
}

/// Lists and buffers that the contact laws fill besides the data of the contact: events, motions of panels, parted
/// chains.
pub(crate) struct Aside<'w> {
    pub(crate) events: &'w mut Vec<Event>,
    pub(crate) clip: &'w mut ClipBuffers,
    pub(crate) panels: &'w mut Vec<PanelMotion>,
    /// Chains that have parted.
    pub(crate) parted: &'w mut Vec<u32>,
}

/// The memory that a patch of contact inherits from the last step or sub-step.
#[derive(Clone, Copy)]
pub(crate) struct Heritage<'m> {
    pub(crate) inherited: Inherited,
    pub(crate) old: Option<&'m PatchMemory>,
    /// Number of contacts that the two bodies have if the host displaced one of them before this sub-step; else 0.
    pub(crate) displaced: u32,
}

/// The place to which the constraint of a contact is written.
pub(crate) struct Target<'w> {
    pub(crate) constraint: &'w mut Constraint,
    /// `None` if contacts are not reported.
    pub(crate) diagnostics: Option<&'w mut Diagnostics>,
}

/// Computes the laws and the effective masses of a patch of contact, and writes them into `target`. Returns the memory
/// of the patch before the solve.
#[inline(always)]
pub(crate) fn assemble(
    start: &Start<'_>,
    aside: &mut Aside<'_>,
    patch: &Patch,
    face: Option<&RankedFender>,
    heritage: Heritage<'_>,
    Target { constraint, diagnostics }: Target<'_>,
) -> PatchMemory {
    let (model, old, displaced) = (start.scene.model, heritage.old, heritage.displaced > 0);
    let [a, b] = [patch.candidate.a, patch.candidate.b];
    let material: &Material = &model.materials()[patch.candidate.material.0 as usize];

    // Kinematics (eq. 9–10) and effective masses (eq. 13–19).
    let movers = Movers::of([a, b].map(|rank| start.roles[rank as usize].moves));
    if let Some(face) = face {
        let factor = old.map(|memory| memory.factor);
        aside.clip.panel.state = face.chain_state(patch.candidate.face, aside.parted, factor);
    }
    let mut touch = touch(&start.scene, aside.clip, patch, face, old, movers);
    let absorbed_j = touch.stored_j;
    let unload = |touch: &mut Touch, tops_j: Option<&[f64; PLAYS]>| match face {
        Some(face) if face.unloads => apply_unloading(model, face, touch, tops_j),
        _ => None,
    };
    let mut unloaded = unload(&mut touch, old.map(|memory| &memory.tops_j));
    let (mut broken, mut snapped_j) = (Broken::default(), 0.0);
    if let Some(face) = face
        && let Some(chains) = breaking(face, aside)
    {
        // The panel without the parted chains, under the same hull. The energy that these chains stored is lost.
        let intact_j = touch.stored_j;
        broken = chains;
        add_parted(aside.parted, patch.candidate.face, broken.chains);
        aside.clip.panel.state.parted |= broken.chains;
        touch = touch_again(&start.scene, aside.clip, patch, Some(face), old, movers);
        let before = unloaded;
        unloaded = unload(&mut touch, before.as_ref().map(|before| &before.tops_j));
        // The chain parts at its break load, not at the tension to which the sub-step overshot. Energy grows as the
        // square of tension.
        let overshoot = broken.overshoot * broken.overshoot;
        snapped_j = greater(intact_j - touch.stored_j, 0.0) * overshoot;
        if let (Some(now), Some(before)) = (&mut unloaded, before) {
            now.lost_j += before.lost_j;
        }
    }
    constraint.set_kinematics([a, b], movers, &touch);
    let Touch { normal, levers_a, levers_b, .. } = touch;
    match movers {
        Movers::A => constraint.set_masses(start.response(a, normal, levers_a), [true, false]),
        Movers::B => constraint.set_masses(start.response(b, normal, levers_b), [false, true]),
        Movers::Both => {
            let (seen, floats) = start.response_of_both([a, b], normal, levers_a, levers_b);
            constraint.set_masses(seen, floats);
        }
    }

    // The normal law (eq. 2–3): spring, stop and damper.
    let factor = factor(model, face, &touch, patch, old);
    if let Some(face) = face
        && face.panel.is_some()
    {
        let factor = factor * unloaded.map_or(1.0, |u| u.share);
        note_panel(model, face, aside, [a, b], (factor, &broken));
    }
    let lag_s = start.velocity_lags_s[constraint.one_floating() as usize];
    let kick_s = kick_s(lag_s, start.h);
    let (mut damper_n, mut damped_m2) = (0.0, 0.0);
    if material.damping_nspm2 != 0.0 {
        let chord_m = if face.is_some() { touch.chord_m } else { patch.chord_m.length() };
        let (closing_mps, area_m2) = (touch.v_normal_mps, patch.area_m2);
        let answered = answered(old, displaced, lag_s);
        let growth = Growth { area_m2, chord_m, closing_mps, answered };
        (damper_n, damped_m2) = damper(material, &growth, start.h, kick_s);
    }
    let parts = normal_force(&touch, factor, damper_n);
    let law_n = parts.total_n();

    // Bounds of the solve: rebound (eq. 26) and energy.
    let (v_ref_mps, approaching) = reference_speed(touch.v_normal_mps, old);
    let restitution = if unloaded.is_some() { None } else { Some(material.restitution) };
    let mut laws = Laws {
        material,
        law_n,
        rebound_mps: restitution.map_or(UNBOUNDED_MPS, |restitution| restitution * v_ref_mps),
        available_j: greater(
            available_j(&touch, factor, law_n, old, displaced) - snapped_j * factor,
            0.0,
        ),
        shear_available_j: old.map_or(0.0, |m| m.sheared_j),
        unbalanced_j: restitution.map_or(0.0, |_| unbalanced_j(&touch, factor, law_n, old)),
        slide: match old {
            None => Slide::Begins,
            Some(memory) if memory.flags & PatchMemory::SLIPPING != 0 => Slide::Slides,
            Some(_) => Slide::Holds,
        },
        was_limited: old.is_some_and(|m| m.flags & PatchMemory::LIMITED != 0),
        h: start.h,
        kick_s,
    };
    let placement = Placement {
        contacts: heritage.displaced,
        old,
        available_j: laws.available_j,
        law_n,
        inverse_mass: constraint.inverse_mass.linear,
        v_normal_mps: touch.v_normal_mps,
        restitution,
    };
    let pressed_out = placement.is_pressed_out();
    if pressed_out {
        laws.rebound_mps = opening_mps(touch.v_normal_mps, kick_s);
        laws.unbalanced_j = 0.0;
    }
    let forces = Forces {
        normal_n: old.map_or(law_n, |m| lesser(m.normal_force_n, law_n)),
        tangential_n: old.map_or(0.0, |m| m.tangential_force_n),
        friction: Friction::Stick,
    };
    constraint.set_laws(&touch, &laws, forces);

    // Events, diagnostics and memory.
    let flags = report_patch(model, aside.events, patch, face, &touch, heritage.inherited, old)
        | (u32::from(approaching) * PatchMemory::APPROACHING)
        | (u32::from(pressed_out) * PatchMemory::PRESSED_OUT);
    if pressed_out && displaced {
        note(model, aside.events, a, b, EventKind::PlacedInOverlap);
    }
    if let Some(diagnostics) = diagnostics {
        let Touch { depth_m, tilt_rad, stored_j, .. } = touch;
        let lost_j = unloaded.map_or(0.0, |unloaded| unloaded.lost_j) + snapped_j;
        let hysteresis_j = lost_j * factor;
        *diagnostics = Diagnostics {
            depth_m,
            tilt_rad,
            parts,
            stored_j: stored_j * factor,
            absorbed_j: absorbed_j * factor,
            hysteresis_j,
        };
    }
    PatchMemory {
        flags,
        shear_m: touch.shear_m,
        v_normal_0_mps: v_ref_mps,
        normal_force_n: forces.normal_n,
        tangential_force_n: forces.tangential_n,
        factor,
        taken_j: laws.available_j,
        sheared_j: laws.shear_available_j,
        damped_m2,
        tops_j: unloaded.map_or([0.0; PLAYS], |unloaded| unloaded.tops_j),
        ..PatchMemory::of(patch, touch.point_in_a_m, touch.normal_in_a)
    }
}

/// The area of overlap to which the damper of a contact has already responded; `lag_s` is the velocity lag of one of
/// the two bodies.
#[inline(always)]
fn answered(old: Option<&PatchMemory>, displaced: bool, lag_s: f64) -> Answered {
    match old {
        _ if displaced => Answered::AllThereIs,
        None => Answered::Nothing,
        // The host's motion is not the engine's motion.
        Some(_) if lag_s < 0.0 => Answered::AllThereIs,
        Some(memory) => Answered::Area(memory.damped_m2),
    }
}

/// The rebound speed γ v_ref for a fender with an unloading law (m/s). This rebound speed is so large that it never
/// limits the reaction: only the unloading law reduces the reaction.
const UNBOUNDED_MPS: f64 = 1e12;

/// The state of a fender's unloading law: the top of each play operator of the law's hysteresis (J), and the energy
/// lost (J).
#[derive(Clone, Copy)]
struct Unloaded {
    tops_j: [f64; PLAYS],
    lost_j: f64,
    /// Force by the unloading law, divided by the force of the loading curve.
    share: f64,
}

/// Replaces the forces and the stored energy in `touch`, which follow the fender's loading curve, by those of the
/// fender's unloading law.
#[inline(never)]
fn apply_unloading(
    model: &Model,
    face: &RankedFender,
    touch: &mut Touch,
    tops_j: Option<&[f64; PLAYS]>,
) -> Option<Unloaded> {
    let fender = &model.fenders()[face.id.0 as usize];
    let unloading = fender.unloading.as_ref()?;
    let loading = Loading {
        deflection_m: touch.depth_m,
        spring_n: touch.spring_n,
        stop_n: touch.stop_n,
        stored_j: touch.stored_j,
    };
    let unloaded = unload(unloading, &fender.law, &loading, tops_j);
    touch.spring_n *= unloaded.share;
    touch.stop_n *= unloaded.share;
    touch.stored_j = unloaded.recoverable_j;
    Some(Unloaded { tops_j: unloaded.tops_j, lost_j: unloaded.lost_j, share: unloaded.share })
}

/// The chains of the fender panel pressed last that part in this sub-step; `None` in most sub-steps.
#[inline(never)]
fn breaking(face: &RankedFender, aside: &Aside<'_>) -> Option<Broken> {
    let tensions_n = aside.clip.panel.pressed.tensions_n;
    let broken = face.panel.as_ref()?.breaking(&tensions_n);
    (broken.chains != 0).then_some(broken)
}

/// Reports the motion of the fender panel that was pressed last. `factor` is the factor of the fender's reaction.
#[inline(never)]
fn note_panel(
    model: &Model,
    face: &RankedFender,
    aside: &mut Aside<'_>,
    [a, b]: [u32; 2],
    (factor, broken): (f64, &Broken),
) {
    let hull = model.id_of[if face.host == a { b } else { a } as usize];
    let pressed = &aside.clip.panel.pressed;
    PanelMotion::note(aside.panels, (face.id, hull), pressed, factor, broken);
}

/// Adds the reaction of a contact's fender and the energy that the fender has stored to the sums in `held`.
pub(crate) fn add_held(
    held: &mut Held,
    model: &Model,
    patch: &Patch,
    mut touch: Touch,
    old: Option<&PatchMemory>,
) {
    let face = patch.candidate.fender(model);
    let factor = factor(model, face, &touch, patch, old);
    held.loading_j += touch.stored_j * factor;
    held.loading_n += (touch.spring_n + touch.stop_n) * factor;
    let unloaded = match face {
        Some(face) if face.unloads => {
            apply_unloading(model, face, &mut touch, old.map(|memory| &memory.tops_j))
        }
        _ => None,
    };
    held.energy_j += (touch.stored_j + unloaded.map_or(0.0, |unloaded| unloaded.lost_j)) * factor;
    held.force_n += (touch.spring_n + touch.stop_n) * factor;
}

/// The energy that a contact stores beyond the energy that balances the last force of the contact (J). Between outlines
/// a third of f δ (force times depth) counts as stored: a flat side stores half of f δ, a wedge a third.
fn unbalanced_j(touch: &Touch, factor: f64, law_n: f64, old: Option<&PatchMemory>) -> f64 {
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

/// The most energy that a contact may give to the bodies: the energy that the contact has taken from the bodies (J).
///
/// A spring acts through a whole sub-step with the force that it has at the start, so it returns up to ωh/2 more energy
/// than it took. If the spring returns nearly all energy (γ near 1), or if the first touch fell deep into a sub-step,
/// the bodies would leave each other faster than they came. If the host displaced the bodies into one another, the host
/// has compressed the spring, and the bodies get all the energy that the spring stores. Contacts between outlines have
/// no potential: force times depth, f δ, bounds their stored energy.
fn available_j(
    touch: &Touch,
    factor: f64,
    law_n: f64,
    old: Option<&PatchMemory>,
    displaced: bool,
) -> f64 {
    let taken_j = old.map_or(0.0, |memory| memory.taken_j);
    if !displaced {
        return taken_j;
    }
    let stored_j = match touch.stored_j {
        0.0 => law_n * touch.depth_m,
        of_fender_j => of_fender_j * factor,
    };
    greater(taken_j, stored_j)
}

/// Returns v_ref, the largest approach speed since the normal speed V_n last changed sign, and whether the bodies
/// approach. If v_ref stayed at the speed of the first touch, a ship that starts at rest would never settle at her
/// static depth.
fn reference_speed(v_normal_mps: f64, old: Option<&PatchMemory>) -> (f64, bool) {
    let approaching = v_normal_mps > 0.0;
    let before = old.map_or(0.0, |m| m.v_normal_0_mps);
    let approached = old.is_some_and(|m| m.flags & PatchMemory::APPROACHING != 0);
    let v_ref_mps = match (approaching, approached) {
        (true, true) => greater(before, v_normal_mps),
        (true, false) => v_normal_mps,
        (false, _) => before,
    };
    (v_ref_mps, approaching)
}
