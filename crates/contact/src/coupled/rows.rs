//! One contact of a sub-step: what the solve needs of it, and what is booked afterwards.

use alloc::vec::Vec;

use crate::coupled::bodies::kick_s;
use crate::coupled::press_out::{Put, opening_mps};
use crate::coupled::tie::{Forces, Slide, Tie};
use crate::events::{note, tell_of_patch};
use crate::fender::RankedFender;
use crate::geometry::clip::ClipBuffers;
use crate::inherit::Inherited;
use crate::law::damper::{Answered, Growth, damper};
use crate::law::normal::{factor, normal_force};
use crate::mass::{InverseMatrix, Seen};
use crate::memory::PatchMemory;
use crate::model::{Material, Model};
use crate::number::{greater, lesser};
use crate::overlap::Patch;
use crate::ranked::Bodies;
use crate::report::{Event, EventKind, ForceParts, Friction};
use crate::state::BodyState;
use crate::touch::{Levers, Movers, Scene, Touch, touch};
use crate::unloading::{PLAYS, unload};
use crate::vec2::Vec2;

/// One contact of a sub-step, where contacts are reported: what is told of it besides what its [`Tie`] and its
/// [`PatchMemory`] know.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Row {
    /// As in [`Touch`].
    pub(crate) depth_m: f64,
    pub(crate) tilt_rad: f64,
    /// What f is made of.
    pub(crate) parts: ForceParts,
    /// What spring and stop of a fender store, with its factor (J); with an unloading law, what they can give back.
    pub(crate) stored_j: f64,
    /// What loads them to where they are, with its factor (J).
    pub(crate) loaded_j: f64,
    /// Heat by a fender's unloading law since the last (sub-)step, with its factor (J).
    pub(crate) hysteresis_j: f64,
}

/// What the laws say of a contact.
pub(crate) struct Laws<'m> {
    pub(crate) material: &'m Material,
    /// f (N).
    pub(crate) law_n: f64,
    /// γ v_ref (m/s).
    pub(crate) rebound_mps: f64,
    /// What N may give the bodies in this sub-step at most: see [`may_give_j`] (J).
    pub(crate) may_give_j: f64,
    /// And T: what the shear spring stores (J).
    pub(crate) may_shear_j: f64,
    /// What is stored beyond what a force holds: see [`unheld_j`] (J).
    pub(crate) unheld_j: f64,
}

/// What a sub-step's contacts come from.
#[derive(Clone, Copy)]
pub(crate) struct Begun<'w> {
    pub(crate) scene: Scene<'w>,
    /// By rank: bodies, states, whether they move and earth-fixed inverse masses.
    pub(crate) bodies: Bodies<'w>,
    pub(crate) states: &'w [BodyState],
    pub(crate) moves: &'w [bool],
    pub(crate) inverses: &'w [InverseMatrix],
    /// As in the workspace; and the length of this sub-step (s).
    pub(crate) behind_s: &'w [f64],
    pub(crate) h: f64,
}

impl Begun<'_> {
    /// How a body that floats answers at a contact along n, with these levers of n and t.
    #[inline(always)]
    fn seen(&self, rank: u32, n: Vec2, levers: Levers) -> Seen {
        let body = self.bodies.of(rank as usize);
        if body.is_alike {
            // To the bit as in `inverses`.
            Seen::alike(body.lightest_inverse_mass, body.inverse_of_turning, levers)
        } else {
            Seen::of(&self.inverses[rank as usize], n, levers)
        }
    }

    /// The same of two bodies that move, of which one may be fixed; and whether each floats.
    // By value: what it is asked with stays in registers elsewhere.
    #[inline(never)]
    fn seen_of_both(
        &self,
        [a, b]: [u32; 2],
        n: Vec2,
        levers_a: Levers,
        levers_b: Levers,
    ) -> (Seen, [bool; 2]) {
        let floats = [a, b].map(|rank| !self.bodies.of(rank as usize).is_fixed());
        let (seen_of_a, seen_of_b) = (self.seen(a, n, levers_a), self.seen(b, n, levers_b));
        let seen = match floats {
            [true, false] => seen_of_a,
            [false, true] => seen_of_b,
            _ => Seen::both(seen_of_a, seen_of_b),
        };
        (seen, floats)
    }
}

/// What is found beside the laws of the contacts.
pub(crate) struct Aside<'w> {
    pub(crate) events: &'w mut Vec<Event>,
    pub(crate) buffers: &'w mut ClipBuffers,
}

/// What a patch takes over from the last (sub-)step.
#[derive(Clone, Copy)]
pub(crate) struct Taken<'m> {
    pub(crate) inherited: Inherited,
    pub(crate) old: Option<&'m PatchMemory>,
    /// Where its bodies were put where they are rather than moved there: how many contacts they have. Else none.
    pub(crate) placed: u32,
}

/// Laws and effective masses of a patch, in its `tie`, what is told of it, in its `row`, and its memory as it is
/// before the solve.
// Always inlined: what it returns is written where it is to stay.
#[inline(always)]
pub(crate) fn collect(
    begun: &Begun<'_>,
    aside: &mut Aside<'_>,
    patch: &Patch,
    face: Option<&RankedFender>,
    taken: Taken<'_>,
    (tie, row): (&mut Tie, Option<&mut Row>),
) -> PatchMemory {
    let (model, old) = (begun.scene.model, taken.old);
    let (a, b) = (patch.candidate.a, patch.candidate.b);
    let material: &Material = &model.materials()[patch.candidate.material.0 as usize];
    let movers = Movers::of([a, b].map(|rank| begun.moves[rank as usize]));
    let bodies = (movers, begun.states);
    let mut touch = touch(&begun.scene, aside.buffers, patch, face, material, old, bodies);
    let loaded_j = touch.stored_j;
    let unloaded = match face {
        Some(face) if face.unloads => by_unloading(model, face, &mut touch, old),
        _ => None,
    };
    tie.join([a, b], movers, &touch);
    let Touch { normal, levers_a, levers_b, .. } = touch;
    // Each by itself: what any of them returns would wait in memory for the other two.
    match movers {
        Movers::A => tie.answer(&begun.seen(a, normal, levers_a), [true, false]),
        Movers::B => tie.answer(&begun.seen(b, normal, levers_b), [false, true]),
        Movers::Both => {
            let (seen, floats) = begun.seen_of_both([a, b], normal, levers_a, levers_b);
            tie.answer(&seen, floats);
        }
    }
    let factor = factor(model, face, &touch, old);
    let behind_s = begun.behind_s[tie.one_floating() as usize];
    let kick_s = kick_s(behind_s, begun.h);
    let (mut damper_n, mut damped_m2) = (0.0, 0.0);
    if material.damping_nspm2 != 0.0 {
        let chord_m = if face.is_some() { touch.chord_m } else { patch.chord_m.length() };
        let (closing_mps, area_m2) = (touch.v_normal_mps, patch.area_m2);
        let answered = answered(old, taken.placed > 0, behind_s);
        let growth = Growth { area_m2, chord_m, closing_mps, answered };
        (damper_n, damped_m2) = damper(material, &growth, (begun.h, kick_s));
    }
    let parts = normal_force(&touch, factor, damper_n);
    let law_n = parts.total_n();
    let (v_ref_mps, approaching) = reference_speed(touch.v_normal_mps, old);
    let mut laws = Laws {
        material,
        law_n,
        rebound_mps: if unloaded.is_some() {
            UNBOUNDED_MPS
        } else {
            material.restitution * v_ref_mps
        },
        may_give_j: may_give_j(&touch, factor, law_n, old, taken.placed > 0),
        may_shear_j: old.map_or(0.0, |m| m.sheared_j),
        unheld_j: if unloaded.is_some() { 0.0 } else { unheld_j(&touch, factor, law_n, old) },
    };
    let put = Put {
        placed: taken.placed,
        old,
        may_give_j: laws.may_give_j,
        law_n,
        inverse_mass: tie.linear,
        v_normal_mps: touch.v_normal_mps,
        restitution: if unloaded.is_some() { None } else { Some(material.restitution) },
    };
    let pressed_out = put.is_pressed_out();
    if pressed_out {
        laws.rebound_mps = opening_mps(touch.v_normal_mps, kick_s);
        laws.unheld_j = 0.0;
    }
    let begins_with = Forces {
        normal_n: old.map_or(law_n, |m| lesser(m.normal_force_n, law_n)),
        tangential_n: old.map_or(0.0, |m| m.tangential_force_n),
        friction: Friction::Stick,
    };
    let slide = match old {
        None => Slide::Touches,
        Some(memory) if memory.flags & PatchMemory::SLIPPING != 0 => Slide::Slides,
        Some(_) => Slide::Holds,
    };
    tie.obey(&touch, &laws, (begins_with, slide), (begun.h, kick_s));
    let flags = tell_of_patch(model, aside.events, patch, face, &touch, taken.inherited, old)
        | (u32::from(approaching) * PatchMemory::APPROACHING)
        | (u32::from(pressed_out) * PatchMemory::PRESSED_OUT);
    if pressed_out && taken.placed > 0 {
        note(model, aside.events, a, b, EventKind::PlacedInOverlap);
    }
    if let Some(row) = row {
        let Touch { depth_m, tilt_rad, stored_j, .. } = touch;
        let hysteresis_j = unloaded.map_or(0.0, |lost| lost.lost_j * factor);
        *row = Row {
            depth_m,
            tilt_rad,
            parts,
            stored_j: stored_j * factor,
            loaded_j: loaded_j * factor,
            hysteresis_j,
        };
    }
    PatchMemory {
        flags,
        shear_m: touch.shear_m,
        v_normal_0_mps: v_ref_mps,
        normal_force_n: begins_with.normal_n,
        tangential_force_n: begins_with.tangential_n,
        factor,
        taken_j: laws.may_give_j,
        sheared_j: laws.may_shear_j,
        damped_m2,
        tops_j: unloaded.map_or([0.0; PLAYS], |unloaded| unloaded.tops_j),
        ..PatchMemory::of(patch, touch.point_in_a_m, touch.normal_in_a)
    }
}

/// What the damper has answered of a contact, one of whose bodies is so far behind.
#[inline(always)]
fn answered(old: Option<&PatchMemory>, placed: bool, behind_s: f64) -> Answered {
    match old {
        _ if placed => Answered::AllThereIs,
        None => Answered::Nothing,
        // The host shows another motion than the engine's.
        Some(_) if behind_s < 0.0 => Answered::AllThereIs,
        Some(memory) => Answered::Area(memory.damped_m2),
    }
}

/// γ v_ref of a fender with an unloading law: its reaction falls by that alone, never because of a speed (m/s).
const UNBOUNDED_MPS: f64 = 1e12;

/// What the unloading law of a fender left of its loss, and of the tops of its plays.
#[derive(Clone, Copy)]
struct ByUnloading {
    tops_j: [f64; PLAYS],
    lost_j: f64,
}

/// Takes a touch's forces and stored energy from those of loading to those of the fender's unloading law.
#[inline(never)]
fn by_unloading(
    model: &Model,
    face: &RankedFender,
    touch: &mut Touch,
    old: Option<&PatchMemory>,
) -> Option<ByUnloading> {
    let fender = &model.fenders()[face.id.0 as usize];
    let unloading = fender.unloading.as_ref()?;
    let unloaded = unload(unloading, &fender.law, touch, old.map(|memory| &memory.tops_j));
    touch.spring_n *= unloaded.share;
    touch.stop_n *= unloaded.share;
    touch.stored_j = unloaded.recoverable_j;
    Some(ByUnloading { tops_j: unloaded.tops_j, lost_j: unloaded.lost_j })
}

/// What a contact stores beyond what its last force holds (J). Between outlines at least a third of
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

/// What a contact may give the bodies (J): what it has taken from them. A spring whose force is that of
/// the sub-step's start returns a little more than it took, by up to ωh/2; where it gives nearly all of it
/// back (γ near 1), or the first touch fell deep into a sub-step, somebody would leave faster than it
/// came. Bodies that were *put* where they touch (`placed`), be it deeper than they were, get what the spring holds
/// then: their hosts have pressed them in. Between outlines, whose law has no potential, f δ bounds it.
fn may_give_j(
    touch: &Touch,
    factor: f64,
    law_n: f64,
    old: Option<&PatchMemory>,
    placed: bool,
) -> f64 {
    let taken_j = old.map_or(0.0, |memory| memory.taken_j);
    if !placed {
        return taken_j;
    }
    let held_j = match touch.stored_j {
        0.0 => law_n * touch.depth_m,
        of_fender_j => of_fender_j * factor,
    };
    greater(taken_j, held_j)
}

/// v_ref: the largest speed of approach since V_n last changed sign, and whether it approaches. The
/// speed at first touch, kept for ever, would not let a ship that starts at rest settle to her
/// static depth.
fn reference_speed(v_normal_mps: f64, old: Option<&PatchMemory>) -> (f64, bool) {
    let approaching = v_normal_mps > 0.0;
    let before = old.map_or(0.0, |m| m.v_normal_0_mps);
    let went_on = old.is_some_and(|m| m.flags & PatchMemory::APPROACHING != 0);
    let v_ref_mps = match (approaching, went_on) {
        (true, true) => greater(before, v_normal_mps),
        (true, false) => v_normal_mps,
        (false, _) => before,
    };
    (v_ref_mps, approaching)
}
