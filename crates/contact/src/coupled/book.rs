//! What a solved sub-step leaves: wrenches, the contacts' memory and their report.

use alloc::vec::Vec;

use crate::coupled::rows::Row;
use crate::coupled::tie::{Forces, Side, Tie};
use crate::memory::PatchMemory;
use crate::model::{BodyId, Model};
use crate::number::{greater, lesser};
use crate::overlap::Patch;
use crate::report::{
    Contact, ContactImpulse, ContactWork, EnergyParts, ForceParts, Friction, Wrench,
};
use crate::touch::{Scene, Touch, arms_m};
use crate::vec2::Vec2;

/// Beyond this a memory would not be restored (J).
const MOST_TAKEN_J: f64 = 1e29;

/// What contacts are booked in.
pub(crate) struct Books<'w> {
    /// Mean wrenches of the step as far as they are known, by id.
    pub(crate) wrenches: &'w mut [Wrench],
    /// Length of the sub-step (s), and its share of the step. What is reported of a step are means over its
    /// sub-steps' time: at rest they are the force, however sub-steps change.
    pub(crate) h: f64,
    pub(crate) share: f64,
}

impl Books<'_> {
    /// Books the forces of a solved contact of these bodies, A and B, and what they leave in its memory.
    #[inline(always)]
    pub(crate) fn book(&mut self, ids: [BodyId; 2], tie: &Tie, memory: &mut PatchMemory) -> Moved {
        let Forces { normal_n, tangential_n, .. } = tie.forces;
        let (mean_n, mean_t) = (normal_n * self.share, tangential_n * self.share);
        let (force_n, on_a_nm) = tie.grip(Side::A).wrench(mean_n, mean_t);
        let (_, on_b_nm) = tie.grip(Side::B).wrench(mean_n, mean_t);
        let [id_a, id_b] = ids;
        let on_a = &mut self.wrenches[id_a.0 as usize];
        on_a.force_n += force_n;
        on_a.moment_nm += on_a_nm;
        let on_b = &mut self.wrenches[id_b.0 as usize];
        on_b.force_n -= force_n;
        on_b.moment_nm -= on_b_nm;

        let moved = Moved::of(tie, memory.shear_m, self.h);
        // What the bodies move in this sub-step is found again in the next one's kinematics.
        memory.shear_m = moved.shear_m - self.h * tie.after_mps.1;
        if tie.slides_on(moved.shear_m) {
            memory.flags |= PatchMemory::SLIPPING;
        }
        memory.normal_force_n = normal_n;
        memory.tangential_force_n = tangential_n;
        memory.taken_j = within(tie.may_give_j + normal_n * moved.closing_m, MOST_TAKEN_J);
        memory.sheared_j = within(
            tie.may_shear_j - tangential_n * moved.slip_m,
            lesser(moved.shear_stored_j, MOST_TAKEN_J),
        );
        moved
    }
}

/// Where contacts are reported one by one.
pub(crate) struct Reports<'w> {
    pub(crate) contacts: &'w mut Vec<Contact>,
    /// First of the group's contacts.
    pub(crate) first_contact: usize,
    pub(crate) in_order: &'w mut bool,
}

/// The solved contacts of a sub-step: as the solve saw them, what they leave, and what else is told of them.
type Solved<'w> = (&'w [Tie], &'w mut [PatchMemory], &'w [Row]);

impl Reports<'_> {
    /// Books contacts as [`Books::book`] does, and reports them.
    #[inline(never)]
    pub(crate) fn book_all(
        &mut self,
        scene: &Scene<'_>,
        books: &mut Books<'_>,
        patches: &[Patch],
        (ties, memories, rows): Solved<'_>,
    ) {
        let solved = patches.iter().zip(ties.iter().zip(memories).zip(rows));
        if self.contacts.len() == self.first_contact {
            // The first sub-step: as many as there are, written where they are to stay.
            self.contacts.extend(solved.map(|(patch, ((tie, memory), row))| {
                let ids = scene.model.ids_of([tie.a, tie.b]);
                let moved = books.book(ids, tie, memory);
                let booked = Booked::of((tie, memory, row), &moved);
                let arms_m = arms_m(scene, patch, memory.point_in_a_m);
                booked.contact(scene, (patch, ids), (tie, row), arms_m, books.share)
            }));
            return;
        }
        for (index, (patch, ((tie, memory), row))) in solved.enumerate() {
            let ids = scene.model.ids_of([tie.a, tie.b]);
            let moved = books.book(ids, tie, memory);
            let booked = Booked::of((tie, memory, row), &moved);
            if !self.has_added(scene.model, (index, books.share), (patch, ids), &booked) {
                let arms_m = arms_m(scene, patch, memory.point_in_a_m);
                let contact = booked.contact(scene, (patch, ids), (tie, row), arms_m, books.share);
                *self.in_order = false;
                self.contacts.push(contact);
            }
        }
    }

    /// Adds to the step's report of this patch, if there is one among the group's: at `guess` as long as the
    /// patches are those of the first sub-step. A sub-step of this `share` of the step.
    #[inline(never)]
    fn has_added(
        &mut self,
        model: &Model,
        (guess, share): (usize, f64),
        (patch, [one, two]): (&Patch, [BodyId; 2]),
        booked: &Booked,
    ) -> bool {
        let fender = patch.candidate.fender(model).map(|face| face.id);
        let wanted = (one.min(two), one.max(two), fender, patch.number);
        let same = |c: &Contact| (c.body_1, c.body_2, c.fender, c.patch) == wanted;
        let own = &mut self.contacts[self.first_contact..];
        let place = match own.get(guess) {
            Some(contact) if same(contact) => Some(guess),
            _ => own.iter().position(same),
        };
        place.inspect(|&place| booked.add_to(&mut own[place], share)).is_some()
    }
}

/// How a contact's bodies moved there while its forces acted, by the mean velocity within a sub-step, and what its shear spring is
/// after it.
pub(crate) struct Moved {
    closing_m: f64,
    slip_m: f64,
    shear_m: f64,
    shear_stored_j: f64,
}

impl Moved {
    /// `shear_m`: Δs at the sub-step's start.
    #[inline(always)]
    fn of(tie: &Tie, shear_m: f64, h: f64) -> Moved {
        let (v_normal_mps, v_tangential_mps) = tie.after_mps;
        let shear_m = tie.shear_after_m(shear_m, v_tangential_mps, h);
        Moved {
            closing_m: 0.5 * (tie.normal_before_mps + v_normal_mps) * tie.kick_s,
            slip_m: 0.5 * (tie.tangential_before_mps + v_tangential_mps) * tie.kick_s,
            shear_m,
            shear_stored_j: tie.shear_stored_j(shear_m),
        }
    }
}

/// What a contact may give back: neither less than nothing nor more than this (J).
#[inline]
fn within(taken_j: f64, most_j: f64) -> f64 {
    lesser(greater(taken_j, 0.0), most_j)
}

/// What a sub-step adds to the report of a contact.
struct Booked {
    normal_n: f64,
    tangential_n: f64,
    kick_s: f64,
    friction: Friction,
    depth_m: f64,
    stored_j: f64,
    loaded_j: f64,
    hysteresis_j: f64,
    work: ContactWork,
    parts: ForceParts,
    factor: f64,
    shear_m: f64,
    shear_stored_j: f64,
}

impl Booked {
    /// Of a contact that is booked.
    #[inline(always)]
    fn of((tie, memory, row): (&Tie, &PatchMemory, &Row), moved: &Moved) -> Booked {
        let Forces { normal_n, tangential_n, friction } = tie.forces;
        let limiter_n = tie.law_n - normal_n;
        Booked {
            normal_n,
            tangential_n,
            kick_s: tie.kick_s,
            friction,
            depth_m: row.depth_m,
            stored_j: row.stored_j,
            loaded_j: row.loaded_j,
            hysteresis_j: row.hysteresis_j,
            work: ContactWork {
                normal_j: -normal_n * moved.closing_m,
                tangential_j: tangential_n * moved.slip_m,
                damper_j: -row.parts.damper_n * moved.closing_m,
                limiter_j: -limiter_n * moved.closing_m,
            },
            parts: ForceParts { limiter_n, ..row.parts },
            factor: memory.factor,
            shear_m: moved.shear_m,
            shear_stored_j: moved.shear_stored_j,
        }
    }

    /// The report of a contact that begins with this sub-step.
    #[inline(always)]
    fn contact(
        &self,
        scene: &Scene<'_>,
        (patch, ids): (&Patch, [BodyId; 2]),
        (tie, row): (&Tie, &Row),
        arms_m: [Vec2; 2],
        share: f64,
    ) -> Contact {
        let face = patch.candidate.fender(scene.model);
        let parts = &self.parts;
        Contact {
            shear_m: self.shear_m,
            normal_force_n: self.normal_n * share,
            tangential_force_n: self.tangential_n * share,
            impulse: ContactImpulse {
                normal_ns: self.normal_n * self.kick_s,
                tangential_ns: self.tangential_n * self.kick_s,
            },
            friction: self.friction,
            limited: parts.limiter_n > 0.0,
            peak_normal_force_n: self.normal_n,
            parts: ForceParts {
                spring_n: parts.spring_n * share,
                stop_n: parts.stop_n * share,
                damper_n: parts.damper_n * share,
                limiter_n: parts.limiter_n * share,
            },
            work: self.work,
            factor: self.factor,
            energy: EnergyParts {
                stored_j: self.stored_j,
                peak_absorbed_j: self.loaded_j,
                hysteresis_j: self.hysteresis_j,
                hysteresis_at_start_j: self.hysteresis_j,
                shear_stored_j: self.shear_stored_j,
            },
            ..touch_of(tie, row).contact(scene, (patch, ids), face, arms_m)
        }
    }

    /// As a sub-step of this `share` of the step.
    fn add_to(&self, contact: &mut Contact, share: f64) {
        contact.normal_force_n += self.normal_n * share;
        contact.tangential_force_n += self.tangential_n * share;
        contact.impulse.normal_ns += self.normal_n * self.kick_s;
        contact.impulse.tangential_ns += self.tangential_n * self.kick_s;
        contact.peak_normal_force_n = greater(contact.peak_normal_force_n, self.normal_n);
        contact.peak_depth_m = greater(contact.peak_depth_m, self.depth_m);
        contact.energy.peak_absorbed_j = greater(contact.energy.peak_absorbed_j, self.loaded_j);
        contact.energy.hysteresis_j += self.hysteresis_j;
        contact.work.normal_j += self.work.normal_j;
        contact.work.tangential_j += self.work.tangential_j;
        contact.work.damper_j += self.work.damper_j;
        contact.work.limiter_j += self.work.limiter_j;
        contact.parts.add(&self.parts, share);
        contact.energy.shear_stored_j = self.shear_stored_j;
        contact.shear_m = self.shear_m;
        contact.limited |= self.parts.limiter_n > 0.0;
        if self.friction == Friction::Slip {
            contact.friction = Friction::Slip;
        }
    }
}

/// What the report of a contact tells of its kinematics.
#[inline(always)]
fn touch_of(tie: &Tie, row: &Row) -> Touch {
    Touch {
        normal: tie.along_n,
        depth_m: row.depth_m,
        tilt_rad: row.tilt_rad,
        v_normal_mps: tie.normal_before_mps,
        v_tangential_mps: tie.tangential_before_mps,
        ..Touch::default()
    }
}
