//! The contacts of one sub-step: what the solve needs of each, and what is booked afterwards.

use core::ops::Range;

use crate::coupled::tie::{Forces, Tie};
use crate::events::tell_of_patch;
use crate::inherit::Inherited;
use crate::law::normal::{factor, normal_force};
use crate::memory::{Past, PatchMemory};
use crate::model::{Material, Model};
use crate::number::{greater, lesser};
use crate::overlap::Patch;
use crate::report::{Contact, ContactWork, ForceParts, Friction};
use crate::touch::{Lasting, Touch, touch};
use crate::vec2::Vec2;
use crate::workspace::Workspace;

/// One contact of a sub-step: what is booked of it besides what its [`Tie`] knows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Row {
    /// As in [`Touch`].
    arm_a_m: Vec2,
    arm_b_m: Vec2,
    depth_m: f64,
    tilt_rad: f64,
    /// Δs at the sub-step's start [m].
    shear_m: f64,
    /// What f is made of.
    parts: ForceParts,
    /// Factor on spring and stop.
    factor: f64,
    /// What spring and stop of a fender store, with it [J].
    stored_j: f64,
    /// Stored energy that nothing holds: see [`let_go`] [J].
    unheld_j: f64,
}

/// What the laws say of a contact.
pub(crate) struct Laws<'m> {
    pub(crate) material: &'m Material,
    /// f [N].
    pub(crate) law_n: f64,
    /// γ v_ref [m/s].
    pub(crate) rebound_mps: f64,
    /// What N may give the bodies in this sub-step at most: see [`may_give_j`] [J].
    pub(crate) may_give_j: f64,
    /// And T: what the shear spring stores [J].
    pub(crate) may_shear_j: f64,
}

/// Laws and effective masses of every patch in `work`, in `work.rows` and `work.ties`.
pub(crate) fn collect(model: &Model, work: &mut Workspace, past: Past<'_>, h: f64) {
    work.rows.clear();
    work.ties.clear();
    let elapsed_s = if past.last_step_s > 0.0 { past.last_step_s } else { h };
    let patches = core::mem::take(&mut work.patches);
    let shares = core::mem::take(&mut work.shares);
    for (index, patch) in patches[work.own_patches.clone()].iter().enumerate() {
        let inherited = work.inherited[index];
        let old = inherited.of(past.patches, &shares);
        let placed = past.last_step_s == 0.0 || work.jumped(patch.candidate.a, patch.candidate.b);
        let time = Time { elapsed_s, h, placed };
        collect_one(model, work, patch, inherited, old, time);
    }
    (work.patches, work.shares) = (patches, shares);
}

/// Time since the last (sub-)step began and length of this one [s]; and whether bodies were put where they
/// are rather than moved there.
#[derive(Clone, Copy)]
struct Time {
    elapsed_s: f64,
    h: f64,
    placed: bool,
}

/// Share of the speed that unheld energy would give, so that it stays below v_ref in a hit, where the
/// time step's error in the stored energy is a few per cent.
const LET_GO: f64 = 0.8;

/// Raises each v_ref of an island's contacts to the speed that the stored energy which no load holds would
/// give.
///
/// v_ref alone forgets: where the relative velocity changes sign by a trifle, as it does when a ship on
/// several fenders yaws a little while she comes back, it starts again from next to nothing, and she
/// rests for ever deeper than her load holds her, or stays pressed on when the wind has died. A spring
/// at δ that is held by N < f has about U (1 − N/f)² more than it needs (exactly, where it is linear);
/// all contacts between the same two bodies, or of one body with what is fixed, let go together. As
/// N ≤ f still, and N < f only while the contact opens, nothing is made out of nothing.
pub(crate) fn let_go(model: &Model, work: &mut Workspace, island: Range<usize>) {
    let Workspace { rows, ties, next_patches, first_patch, .. } = &*work;
    let memories = &next_patches[first_patch + island.start..first_patch + island.end];
    let (rows, ties) = (&rows[island.clone()], &ties[island.clone()]);
    let rises = |all_j: f64, tie: &Tie, memory: &PatchMemory| {
        speed_squared(all_j, tie) > memory.v_normal_0_mps * memory.v_normal_0_mps
    };
    // While bodies close most of them come faster than all of it could give them.
    let any_rises = match (rows, ties, memories) {
        ([row], [tie], [memory]) => rises(row.unheld_j, tie, memory),
        _ => {
            let all_j = rows.iter().map(|row| row.unheld_j).sum();
            ties.iter().zip(memories).any(|(tie, memory)| rises(all_j, tie, memory))
        }
    };
    if any_rises {
        let_go_of(model, work, island);
    }
}

/// Square of the speed that unheld energy would give the two bodies of a contact, without rotation [m²/s²]:
/// contacts at both ends of a ship do not turn her.
#[inline(always)]
fn speed_squared(unheld_j: f64, tie: &Tie) -> f64 {
    LET_GO * LET_GO * 2.0 * unheld_j * tie.linear
}

/// The unheld energy of all contacts that let go together, and what it makes of their v_ref.
#[cold]
#[inline(never)]
fn let_go_of(model: &Model, work: &mut Workspace, island: Range<usize>) {
    let fixed = |rank: u32| model.ranked[rank as usize].is_fixed();
    let Workspace { rows, ties, next_patches, first_patch, unheld_j, .. } = work;
    let next_patches = &mut next_patches[*first_patch + island.start..];
    let (rows, ties) = (&rows[island.clone()], &mut ties[island]);
    for tie in ties.iter() {
        unheld_j[tie.a as usize] = 0.0;
        unheld_j[tie.b as usize] = 0.0;
    }
    for (row, tie) in rows.iter().zip(ties.iter()) {
        match (fixed(tie.a), fixed(tie.b)) {
            (true, _) => unheld_j[tie.b as usize] += row.unheld_j,
            (_, true) => unheld_j[tie.a as usize] += row.unheld_j,
            _ => {}
        }
    }
    let mut from = 0;
    while from < rows.len() {
        let (a, b) = (ties[from].a, ties[from].b);
        let count = ties[from..].iter().take_while(|tie| (tie.a, tie.b) == (a, b)).count();
        let own = from..from + count;
        let unheld_j = match (fixed(a), fixed(b)) {
            (true, _) => unheld_j[b as usize],
            (_, true) => unheld_j[a as usize],
            _ => rows[own.clone()].iter().map(|row| row.unheld_j).sum(),
        };
        if unheld_j > 0.0 {
            let memories = &mut next_patches[own.clone()];
            for (tie, memory) in ties[own].iter_mut().zip(memories) {
                let speed_mps = libm::sqrt(speed_squared(unheld_j, tie));
                tie.rebound_mps = tie.rebound_mps.max(tie.restitution * speed_mps);
                // It goes on until the contact closes again: else the bound would come and go with N.
                memory.v_normal_0_mps = memory.v_normal_0_mps.max(speed_mps);
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
    inherited: Inherited,
    old: Option<&PatchMemory>,
    time: Time,
) {
    let face = patch.candidate.fender(model);
    let material: &Material = &model.materials()[patch.candidate.material.0 as usize];
    let touch = touch(model, work, patch, face, old);
    let area_before_m2 = old.map_or(0.0, |m| m.area_m2);
    let factor = factor(model, face, &touch, old);
    let parts =
        normal_force(material, &touch, factor, patch.area_m2, area_before_m2, time.elapsed_s);
    let law_n = parts.total_n();
    let (v_ref_mps, approaching) = reference_speed(touch.v_normal_mps, old);
    let laws = Laws {
        material,
        law_n,
        rebound_mps: material.restitution * v_ref_mps,
        may_give_j: may_give_j(&touch, factor, law_n, old, time.placed),
        may_shear_j: old.map_or(0.0, |m| m.sheared_j),
    };
    let begins_with = Forces {
        normal_n: old.map_or(law_n, |m| lesser(m.normal_force_n, law_n)),
        tangential_n: old.map_or(0.0, |m| m.tangential_force_n),
        friction: Friction::Stick,
    };
    let [a, b] =
        [patch.candidate.a, patch.candidate.b].map(|rank| (rank, &work.inverses[rank as usize]));
    work.ties.push(Tie::new(a, b, &touch, &laws, begins_with, time.h));
    let flags = tell_of_patch(model, work, patch, face, &touch, inherited, old)
        | (u32::from(approaching) * PatchMemory::APPROACHING);
    // The shear is known when the solve is done.
    let lasting = Lasting { flags, factor, v_normal_0_mps: v_ref_mps, ..Lasting::default() };
    touch.remember(patch, &work.places, lasting, &mut work.next_patches);
    let unheld_j = unheld_j(&touch, factor, law_n, old);
    work.rows.push(Row {
        arm_a_m: touch.arm_a_m,
        arm_b_m: touch.arm_b_m,
        depth_m: touch.depth_m,
        tilt_rad: touch.tilt_rad,
        shear_m: touch.shear_m,
        parts,
        factor,
        stored_j: touch.stored_j * factor,
        unheld_j,
    });
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

/// Beyond this a memory would not be restored [J].
const MOST_TAKEN_J: f64 = 1e29;

/// Books forces, work and peaks of a solved sub-step, which has this `share` of the step, and completes its
/// memory.
pub(crate) fn book(model: &Model, work: &mut Workspace, h: f64, share: f64) {
    let Workspace {
        rows,
        ties,
        patches,
        own_patches,
        next_patches,
        first_patch,
        poses,
        pushes,
        contacts,
        first_contact,
        in_order,
        ..
    } = work;
    let next_patches = &mut next_patches[*first_patch..];
    let patches = &patches[own_patches.clone()];
    let first_sub_step = contacts.len() == *first_contact;
    for (index, (row, tie)) in rows.iter().zip(ties.iter()).enumerate() {
        let normal = tie.along_n;
        let Forces { normal_n, tangential_n, friction } = tie.forces;
        let force_n = (normal * -normal_n + normal.quarter_turn() * tangential_n) * share;
        let on_a = &mut pushes[tie.a as usize];
        on_a.force_n += force_n;
        on_a.moment_nm += row.arm_a_m.cross(force_n);
        let on_b = &mut pushes[tie.b as usize];
        on_b.force_n -= force_n;
        on_b.moment_nm -= row.arm_b_m.cross(force_n);

        // By the mean velocity within the sub-step.
        let (v_normal_mps, v_tangential_mps) = tie.after_mps;
        let closing_m = 0.5 * (tie.normal_before_mps + v_normal_mps) * h;
        let slip_m = 0.5 * (tie.tangential_before_mps + v_tangential_mps) * h;

        let shear_m = tie.shear_after_m(row.shear_m, v_tangential_mps, h);
        let memory = &mut next_patches[index];
        // What the bodies move in this sub-step is found again in the next one's kinematics.
        memory.shear_m = shear_m - h * v_tangential_mps;
        memory.normal_force_n = normal_n;
        memory.tangential_force_n = tangential_n;
        let shear_stored_j = tie.shear_stored_j(shear_m);
        memory.sheared_j =
            within(tie.may_shear_j - tangential_n * slip_m, lesser(shear_stored_j, MOST_TAKEN_J));
        memory.taken_j = within(tie.may_give_j + normal_n * closing_m, MOST_TAKEN_J);
        let limiter_n = tie.law_n - normal_n;
        let booked = Booked {
            normal_n,
            tangential_n,
            friction,
            depth_m: row.depth_m,
            stored_j: row.stored_j,
            work: ContactWork {
                normal_j: -normal_n * closing_m,
                tangential_j: tangential_n * slip_m,
                damper_j: -row.parts.damper_n * closing_m,
                limiter_j: -limiter_n * closing_m,
            },
            parts: ForceParts { limiter_n, ..row.parts },
            shear_m,
            shear_stored_j,
        };
        let known = if first_sub_step {
            None
        } else {
            place_of(model, &contacts[*first_contact..], &patches[index], index)
        };
        if let Some(place) = known {
            booked.add_to(&mut contacts[*first_contact + place], share);
            continue;
        }
        *in_order &= first_sub_step;
        let face = patches[index].candidate.fender(model);
        let position_m = poses[tie.a as usize].position_m;
        let mut contact = touch_of(row, tie).contact(model, position_m, &patches[index], face);
        contact.factor = row.factor;
        contact.stored_j = booked.stored_j;
        booked.add_to(&mut contact, share);
        contacts.push(contact);
    }
}

/// What the report of a contact tells of its kinematics.
#[inline(always)]
fn touch_of(row: &Row, tie: &Tie) -> Touch {
    Touch {
        normal: tie.along_n,
        arm_a_m: row.arm_a_m,
        arm_b_m: row.arm_b_m,
        depth_m: row.depth_m,
        tilt_rad: row.tilt_rad,
        v_normal_mps: tie.normal_before_mps,
        v_tangential_mps: tie.tangential_before_mps,
        shear_m: row.shear_m,
        ..Touch::default()
    }
}

/// What a contact may give back: neither less than nothing nor more than this [J].
#[inline]
fn within(taken_j: f64, most_j: f64) -> f64 {
    lesser(greater(taken_j, 0.0), most_j)
}

/// What a sub-step adds to the report of a contact.
struct Booked {
    normal_n: f64,
    tangential_n: f64,
    friction: Friction,
    depth_m: f64,
    stored_j: f64,
    work: ContactWork,
    parts: ForceParts,
    shear_m: f64,
    shear_stored_j: f64,
}

impl Booked {
    /// As a sub-step of this `share` of the step.
    #[inline(always)]
    fn add_to(&self, contact: &mut Contact, share: f64) {
        contact.normal_force_n += self.normal_n * share;
        contact.tangential_force_n += self.tangential_n * share;
        contact.peak_normal_force_n = greater(contact.peak_normal_force_n, self.normal_n);
        contact.peak_depth_m = greater(contact.peak_depth_m, self.depth_m);
        contact.peak_stored_j = greater(contact.peak_stored_j, self.stored_j);
        contact.work.normal_j += self.work.normal_j;
        contact.work.tangential_j += self.work.tangential_j;
        contact.work.damper_j += self.work.damper_j;
        contact.work.limiter_j += self.work.limiter_j;
        contact.parts.add(&self.parts, share);
        contact.shear_stored_j = self.shear_stored_j;
        contact.shear_m = self.shear_m;
        contact.limited |= self.parts.limiter_n > 0.0;
        if self.friction == Friction::Slip {
            contact.friction = Friction::Slip;
        }
    }
}

/// Where the step's report of this patch stands among the island's: at `guess` as long as the patches are
/// those of the first sub-step.
fn place_of(model: &Model, own: &[Contact], patch: &Patch, guess: usize) -> Option<usize> {
    let [one, two] = [patch.candidate.a, patch.candidate.b].map(|rank| model.id_of[rank as usize]);
    let fender = patch.candidate.fender(model).map(|face| face.id);
    let wanted = (one.min(two), one.max(two), fender, patch.number);
    let same = |c: &Contact| (c.body_1, c.body_2, c.fender, c.patch) == wanted;
    match own.get(guess) {
        Some(contact) if same(contact) => Some(guess),
        _ => own.iter().position(same),
    }
}
